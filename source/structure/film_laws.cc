#include <taut/base/exceptions.h>
#include <taut/material/at_temperature.h>
#include <taut/structure/film_laws.h>
#include <taut/structure/structure.h>

#include <algorithm>
#include <cmath>

namespace taut::structure
{
namespace
{
/// Temperature and humidity of a film, gone on by the same time.
struct Climate
{
  double temperature, temperature_step; ///< (K)
  double humidity, humidity_step;
};

Climate get_climate(const LoadState& loads, const unsigned int film,
                    const double time_step)
{
  return {loads.film_temperatures[film],
          time_step * loads.film_temperature_rates[film],
          loads.film_humidities[film],
          time_step * loads.film_humidity_rates[film]};
}

bool is_constant(const Film& film)
{
  return material::is_constant(film.thermal) &&
         material::is_constant(film.humidity_laws);
}

/// Errors: StepRejected outside the range of a law, with the film.
material::Elastomer make_in_climate(const material::Elastomer& elastomer,
                                    const Film& film, const Climate& climate)
{
  try
  {
    return material::make_at_humidity(
        material::make_at_temperature(elastomer, film.thermal,
                                      climate.temperature,
                                      climate.temperature_step),
        film.humidity_laws, climate.humidity, climate.humidity_step);
  }
  catch (const StepRejected& rejection)
  {
    throw StepRejected("film '" + film.name +
                       "', everywhere: " + rejection.what());
  }
}

double compute_pre_stretch(const Film& film, const double share,
                           const unsigned int direction)
{
  return 1 + share * (film.pre_stretch[direction] - 1);
}

double find_largest(const std::vector<double>& rates)
{
  double largest = 0;
  for (const double rate : rates)
    largest = std::max(largest, std::abs(rate));
  return largest;
}
} // namespace

Device add_fibres(Device device)
{
  for (Film& film : device.films)
    if (film.fibre_modulus > 0)
      film.material.fibres.push_back(material::make_fibres_across(
          film.fibre_modulus, film.pre_stretch[1]));
  return device;
}

void Structure::set_pre_stretches(const LoadState& loads)
{
  for (unsigned int film = 0; film < loads.pre_stretch_shares.size(); ++film)
  {
    const double share = loads.pre_stretch_shares[film];
    const Film& description = device_.films[film];
    const std::array<double, 2> pre_stretch{
        {compute_pre_stretch(description, share, 0),
         compute_pre_stretch(description, share, 1)}};
    if (!(pre_stretch[0] > 0 && pre_stretch[1] > 0))
      throw StepRejected("the share " + std::to_string(share) +
                         " of the pre-stretch of film '" + description.name +
                         "' leaves no stretch");
    cells_->set_pre_stretch(film, pre_stretch);
  }
}

std::vector<fe::BatchLaw> Structure::make_laws(const LoadState& loads,
                                               const Networks networks,
                                               const double time_step) const
{
  // Of all films, so that every rank meets a law out of its range.
  std::vector<std::shared_ptr<const material::Elastomer>> elastomers;
  for (unsigned int film = 0; film < device_.films.size(); ++film)
  {
    const Film& description = device_.films[film];
    const double share = loads.pre_stretch_shares[film];
    const bool moves_fibres = description.fibre_modulus > 0 && share != 1;
    elastomers.push_back(nullptr);
    if (is_constant(description) && time_step == 0 && !moves_fibres)
      continue;
    auto elastomer =
        networks == Networks::relaxed ? relaxed_[film] : description.material;
    // Fibres that hold the width of the frame do so however far the film is
    // stretched.
    if (moves_fibres)
      elastomer.fibres.back() = material::make_fibres_across(
          description.fibre_modulus,
          compute_pre_stretch(description, share, 1));
    elastomers.back() =
        std::make_shared<const material::Elastomer>(make_in_climate(
            elastomer, description, get_climate(loads, film, time_step)));
  }
  auto laws = fe::make_laws(*cells_, loads.voltages);
  for (unsigned int slot = 0; slot < laws.size(); ++slot)
  {
    fe::BatchLaw& law = laws[slot];
    if (carries_compression_)
      law.wrinkle_stiffness = 0;
    const unsigned int film = cells_->slots()[slot].film;
    law.field.temperature = loads.film_temperatures[film];
    if (networks == Networks::relaxed)
      law.elastomer = &relaxed_[film];
    if (!elastomers[film])
      continue;
    law.owned = elastomers[film];
    law.elastomer = law.owned.get();
  }
  return laws;
}

double Structure::compute_heat_power(const LoadState& loads,
                                     const double* internal) const
{
  const double of_frames = frames_->compute_heat_power(loads, positions_);
  // Of the humidity 1e-4 counts as 1e-2 K.
  const double fastest =
      std::max(find_largest(loads.film_temperature_rates),
               100 * find_largest(loads.film_humidity_rates));
  if (fastest == 0)
    return of_frames;
  // dT/dt dPsi/dT + dh/dt dPsi/dh at fixed strain. Along the tangents of moduli
  // and permittivity the energy of a taut film is a polynomial of the second
  // degree, and the difference exact; that of a wrinkled film bends by the
  // square of the step, 1e-2 K.
  const double step = 1e-2 / fastest;
  const auto compute = [&](const double time_step)
  {
    return fe::compute_energy(*cells_,
                              make_laws(loads, Networks::as_given, time_step),
                              positions_, internal)
        .at_voltage;
  };
  return of_frames + (compute(step) - compute(-step)) / (2 * step);
}

double Structure::compute_thermal_energy(const LoadState& loads) const
{
  double energy = 0;
  for (unsigned int cell = 0; cell < cells_->cells().size(); ++cell)
  {
    const unsigned int film = cells_->cells()[cell].film;
    const Film& description = device_.films[film];
    if (description.thermal.heat_capacity == 0)
      continue;
    const double density = material::compute_thermal_energy(
        description.thermal, description.material.density,
        loads.film_temperatures[film]);
    for (unsigned int q = 0; q < cells_->element().n_nodes; ++q)
      energy += density * cells_->volume(cell, q);
  }
  return energy;
}
} // namespace taut::structure
