#include "demes_equivalent_film.h"

#include <taut/base/exceptions.h>
#include <taut/material/at_temperature.h>

#include <variant>

#include "comparison_checks.h"

namespace taut::study
{
namespace
{
using material::NeoHookean;
using structure::Film;

double read_spring(const Case& film_case, const Film& film,
                   const material::Spring& spring)
{
  const NeoHookean* const neo_hookean = std::get_if<NeoHookean>(&spring);
  if (neo_hookean == nullptr)
    refuse(film_case, "Film", film,
           "the lumped DEMES knows only neo-Hookean springs, and the film's "
           "material has another");
  return neo_hookean->shear_modulus;
}

/// The material at the film's temperature and humidity.
material::Elastomer make_elastomer(const Case& film_case, const Film& film,
                                   const double temperature)
{
  try
  {
    return material::make_at_humidity(
        material::make_at_temperature(film.material, film.thermal, temperature),
        film.humidity_laws,
        read_constant(film_case, "Film", film, film.humidity, "humidity"));
  }
  catch (const StepRejected& rejection)
  {
    refuse(film_case, "Film", film, rejection.what());
  }
}

void read_springs(const Case& film_case, const Film& film,
                  const material::Elastomer& elastomer, lumped::DemesSI& device)
{
  if (!elastomer.fibres.empty())
    refuse(film_case, "Film", film,
           "the lumped DEMES knows no fibres, and the film's material has a "
           "Fibre family");
  if (elastomer.springs.empty())
    refuse(film_case, "Film", film,
           "the lumped DEMES needs a spring that always carries");
  device.shear_modulus = 0;
  for (const auto& spring : elastomer.springs)
    device.shear_modulus += read_spring(film_case, film, spring);
  if (elastomer.networks.size() > 1)
    refuse(film_case, "Film", film,
           "the lumped DEMES has one network at most, and the film's material "
           "has " +
               std::to_string(elastomer.networks.size()));
  // A dashpot behind a spring of no stiffness never moves.
  device.viscous_ratio = 0;
  device.viscosity = device.shear_modulus;
  for (const auto& network : elastomer.networks)
  {
    const double modulus = read_spring(film_case, film, network.spring);
    if (!material::is_constant(network.relaxation))
      refuse(film_case, "Film", film,
             "the lumped DEMES knows only constant relaxation times, and the "
             "film's material has a Relaxation law");
    device.viscous_ratio = modulus / device.shear_modulus;
    device.viscosity = modulus * network.relaxation_time;
  }
}

struct ReadPermittivity
{
  double temperature;
  lumped::DemesSI& device;

  void operator()(const material::ConstantPermittivity& law) const
  {
    device.relative_permittivity = law.relative;
    device.permittivity = {};
  }
  /// With lambda_2 = 1 the argument lambda_1 + lambda_2 - 2 is lambda - 1.
  void operator()(const material::StretchPermittivity& law) const
  {
    device.relative_permittivity =
        material::compute_unstretched_permittivity(law, temperature);
    device.permittivity = {law.linear, law.quadratic, law.cubic};
  }
};
} // namespace

double read_constant(const Case& film_case, const std::string& kind,
                     const structure::Named& entry, const Signal& signal,
                     const std::string& name)
{
  if (!signal.is_constant())
    refuse(film_case, kind, entry,
           "the lumped DEMES has one " + name + " at all times");
  return signal.value(film_case.procedure.start_time);
}

void read_demes_film(const Case& film_case, const Film& film,
                     lumped::DemesSI& device)
{
  if (film.pre_stretch[1] != 1)
    refuse(film_case, "Film", film,
           "the film of the lumped DEMES is stretched along its first axis "
           "only: the second pre-stretch must be 1");
  device.film_thickness = film.thickness;
  device.pre_stretch = film.pre_stretch[0];
  device.temperature =
      read_constant(film_case, "Film", film, film.temperature, "temperature");
  const auto elastomer = make_elastomer(film_case, film, device.temperature);
  read_springs(film_case, film, elastomer, device);
  std::visit(ReadPermittivity{device.temperature, device},
             elastomer.dielectric.permittivity);
}
} // namespace taut::study
