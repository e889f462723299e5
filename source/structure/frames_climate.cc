// Frames that soften in heat and humidity.
#include <taut/base/exceptions.h>
#include <taut/structure/frames.h>

namespace taut::structure
{
namespace
{
/// The factor of temperature and humidity on all stiffnesses of a frame, and
/// its rate (1/s). Errors: StepRejected outside the range of a law, with the
/// frame.
struct Softening
{
  double factor, rate;
};

Softening compute_softening(const Device& device, const LoadState& loads,
                            const unsigned int frame)
{
  const Frame& description = device.frames[frame];
  const double temperature = loads.frame_temperatures[frame];
  const double humidity = loads.frame_humidities[frame];
  try
  {
    const double dry =
        material::compute_factor(description.modulus_law, temperature);
    const double wet =
        material::compute_factor(description.humidity_law, humidity);
    return {dry * wet, loads.frame_temperature_rates[frame] * wet *
                               material::compute_factor_derivative(
                                   description.modulus_law, temperature) +
                           loads.frame_humidity_rates[frame] * dry *
                               material::compute_factor_derivative(
                                   description.humidity_law, humidity)};
  }
  catch (const StepRejected& rejection)
  {
    throw StepRejected("frame '" + description.name +
                       "', everywhere: " + rejection.what());
  }
}
} // namespace

fe::BeamStiffness Frames::get_stiffness(const unsigned int frame,
                                        const LoadState& loads) const
{
  const BeamSection& section = device_.frames[frame].section;
  const double factor =
      stiffening_ * compute_softening(device_, loads, frame).factor;
  fe::BeamStiffness stiffness{
      {section.axial_stiffness, section.shear_stiffness[0],
       section.shear_stiffness[1], section.torsional_stiffness,
       section.bending_stiffness[0], section.bending_stiffness[1]}};
  for (double& entry : stiffness)
    entry *= factor;
  return stiffness;
}

double Frames::compute_heat_power(const LoadState& loads,
                                  const fe::NodalVector& positions) const
{
  // Of all frames, so that every rank meets a law out of its range.
  std::vector<Softening> softenings;
  for (unsigned int frame = 0; frame < device_.frames.size(); ++frame)
    softenings.push_back(compute_softening(device_, loads, frame));
  double power = 0;
  for (const auto& element : elements_)
  {
    const auto& [factor, rate] = softenings[element.frame];
    if (!element.assembled_here || rate == 0)
      continue;
    // The energy is the factor of the laws times one that does not change.
    power +=
        rate / factor *
        element.beam.compute_energy(
            get_stiffness(element.frame, loads),
            element.beam.compute_strains(gather(element, positions).data()));
  }
  return power;
}
} // namespace taut::structure
