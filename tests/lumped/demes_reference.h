#pragma once

// Reference trajectories of the lumped DEMES: beta = 2.5, permittivity law of
// Wang et al. They come from 80-bit integration by another program (14 digits);
// the difference between its two tolerances is `error`. A few rows of each.

#include <taut/lumped/demes_run.h>

#include <string>
#include <vector>

namespace demes_reference
{
/// tau, theta, theta', xi, lambda, e^2, s, kinetic + free energy.
using Row = std::vector<double>;

/// e = size (constant + amplitude sin(frequency tau)).
struct Drive
{
  double size;
  double constant;
  double amplitude;
  double frequency;
};

struct Trajectory
{
  std::string name;
  double pre_stretch;
  double frame_stiffness;
  double relaxation;
  double modulus_factor;
  double permittivity_factor;
  double eccentricity;
  Drive drive;
  taut::lumped::DemesState start;
  double error;
  std::vector<Row> rows;
};

inline taut::Signal make_signal(const Drive& drive)
{
  using taut::Signal;
  const double offset = drive.size * drive.constant;
  if (drive.amplitude == 0)
    return Signal::constant(offset);
  constexpr double pi = 3.14159265358979323846;
  return Signal::sine(offset, drive.size * drive.amplitude,
                      drive.frequency / (2 * pi), 0);
}

inline taut::lumped::Demes make_demes(const Trajectory& trajectory)
{
  taut::lumped::Demes demes;
  demes.pre_stretch = trajectory.pre_stretch;
  demes.frame_stiffness = trajectory.frame_stiffness;
  demes.relaxation = trajectory.relaxation;
  demes.modulus_factor = trajectory.modulus_factor;
  demes.permittivity_factor = trajectory.permittivity_factor;
  demes.eccentricity = trajectory.eccentricity;
  demes.drive = make_signal(trajectory.drive);
  return demes;
}
} // namespace demes_reference
