#pragma once

#include <string>
#include <vector>

namespace taut::study
{
/// A column of history.csv and other tables.
struct Column
{
  std::string name;
  std::string unit; ///< "1" if dimensionless
};

/// Something that relaxes while a device vibrates.
struct ModesRelaxation
{
  std::string name;
  double time = 0; ///< (s)
};

/// Small vibrations about a state, for modes.csv and run.json.
struct ModesReport
{
  struct Mode
  {
    /// Of the undamped mode (1/s^2); negative: it leaves the state.
    double square = 0;
    /// Real and imaginary part of s in exp(s t) (1/s).
    double growth_rate = 0;
    double damped_angular_frequency = 0;
    double damping_ratio = 0;
    /// Kinetic energy is half of it times the square of the largest velocity
    /// (kg, or kg m^2 where the coordinate is an angle).
    double modal_mass = 0;
    /// Along x, y, z (kg): of all modes they sum up to the mass that is not
    /// held.
    std::vector<double> effective_masses;
    /// Angular frequency times relaxation time, by relaxation.
    std::vector<double> products;

    double frequency() const; ///< (Hz), 0 if unstable
  };

  double time = 0; ///< of the state (s)
  std::vector<Mode> modes;
  std::vector<ModesRelaxation> relaxations;
  /// Whether no small motion leaves the state for good: no square of the
  /// relaxed stiffness is negative. Where networks still relax, of the frozen
  /// one.
  bool stable = true;
  /// Lowest squares with all networks following and with none (1/s^2), and how
  /// many are negative.
  double lowest_relaxed = 0, lowest_frozen = 0;
  int unstable_relaxed = 0, unstable_frozen = 0;
  double total_mass = 0; ///< (kg); 0 of lumped models
  /// From the state of the run to the equilibrium next to it, largest
  /// displacement (m).
  double moved = 0;
  /// Unit of modal masses.
  std::string mass_unit = "kg";
};

/// Those of modes.csv.
std::vector<Column> make_mode_columns(const ModesReport& report);
/// One number per column, of the mode with the given index.
std::vector<double> make_mode_row(const ModesReport& report, std::size_t mode);
} // namespace taut::study
