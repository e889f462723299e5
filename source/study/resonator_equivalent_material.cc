#include "resonator_equivalent_material.h"

#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>
#include <taut/material/at_temperature.h>

#include <cmath>
#include <variant>

#include "resonator_equivalent_strip.h"

namespace taut::study
{
namespace
{
using material::Gent;
using structure::Film;

/// Takes the common limit of all springs, which are Gent springs.
const Gent& read_spring(const material::Spring& spring, const Film& film,
                        const std::string& file, double& limit)
{
  const Gent* const gent = std::get_if<Gent>(&spring);
  if (gent == nullptr)
    refuse(film, file,
           "the lumped model knows only Gent springs, and the film's material "
           "has another");
  if (limit != 0 && limit != gent->limit)
    refuse(film, file,
           "the lumped model has one limit of all Gent springs, and the "
           "film's material has " +
               number_text(limit) + " and " + number_text(gent->limit));
  limit = gent->limit;
  return *gent;
}

void read_springs(const Film& film, const std::string& file,
                  LumpedResonatorDescription& resonator)
{
  double ground = 0;
  resonator.limit = 0;
  for (const auto& spring : film.material.springs)
    ground += read_spring(spring, film, file, resonator.limit).shear_modulus;
  if (!(ground > 0))
    refuse(film, file,
           "the lumped model needs a spring that always carries beside the "
           "networks");
  resonator.shear_modulus = ground;
  for (const auto& network : film.material.networks)
  {
    const Gent& gent = read_spring(network.spring, film, file, resonator.limit);
    if (!material::is_constant(network.relaxation))
      refuse(film, file,
             "the lumped model knows only constant relaxation times, and the "
             "film's material has a Relaxation law");
    resonator.network_shares.push_back(gent.shear_modulus);
    resonator.relaxation_times.push_back(network.relaxation_time);
    resonator.shear_modulus += gent.shear_modulus;
  }
  resonator.equilibrium_share = ground / resonator.shear_modulus;
  for (double& share : resonator.network_shares)
    share /= resonator.shear_modulus;
}

void read_dielectric(const Film& film, const std::string& file,
                     LumpedResonatorDescription& resonator)
{
  const auto& dielectric = film.material.dielectric;
  const auto* const constant =
      std::get_if<material::ConstantPermittivity>(&dielectric.permittivity);
  if (constant == nullptr)
    refuse(film, file,
           "the lumped model knows only a constant permittivity, and that of "
           "the film's material depends on the stretch");
  if (!dielectric.breakdown.factors.empty())
    refuse(film, file,
           "the lumped model knows only a constant breakdown strength, and "
           "that of the film's material follows a law");
  if (!std::isfinite(dielectric.breakdown.reference))
    refuse(film, file,
           "the lumped model needs the Breakdown strength of the material");
  resonator.relative_permittivity = constant->relative;
  resonator.breakdown_strength = dielectric.breakdown.reference;
}
} // namespace

void read_film(const Film& film, const std::string& file,
               LumpedResonatorDescription& resonator)
{
  if (!film.material.fibres.empty())
    refuse(film, file,
           "the lumped model knows no fibres, and the film's material has a "
           "Fibre family");
  if (!material::is_constant(film.humidity_laws))
    refuse(film, file,
           "the lumped model knows no humidity, and the film's material has "
           "Humidity laws");
  read_springs(film, file, resonator);
  read_dielectric(film, file, resonator);
  resonator.density = film.material.density;
  resonator.thickness = film.thickness;
  resonator.pre_stretch = film.pre_stretch;
}

void check_same(const Film& active, const Film& passive,
                const std::string& file)
{
  LumpedResonatorDescription a, b;
  read_film(active, file, a);
  read_film(passive, file, b);
  const auto require = [&](const bool same, const std::string& what)
  {
    if (!same)
      refuse(passive, file,
             "the lumped model has one " + what +
                 " for both films, and it differs from that of the film '" +
                 active.name + "'");
  };
  require(a.thickness == b.thickness, "thickness");
  require(a.pre_stretch == b.pre_stretch, "pre-stretch");
  require(a.density == b.density, "density");
  require(a.shear_modulus == b.shear_modulus &&
              a.equilibrium_share == b.equilibrium_share && a.limit == b.limit,
          "set of springs");
  require(a.network_shares == b.network_shares &&
              a.relaxation_times == b.relaxation_times,
          "set of networks");
  require(a.relative_permittivity == b.relative_permittivity &&
              a.breakdown_strength == b.breakdown_strength,
          "dielectric");
}
} // namespace taut::study
