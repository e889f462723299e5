#pragma once

#include <taut/structure/description.h>

#include <vector>

namespace taut::structure
{
/// The values of all signals of a device at one time, in the order of the
/// description, with their first rates (per s) and, for supports, second.
struct LoadState
{
  /// Between the faces of the electrodes (V), rates only of prescribed ones.
  /// Where charge_is_given, no number until Structure::resolve_voltages.
  std::vector<double> voltages, voltage_rates;
  /// Where they are given (C); rates only of prescribed ones.
  std::vector<double> charges, charge_rates;
  /// By electrode. The history gives the charges that are controlled and leaves
  /// circuits at rest; give_charges gives those of circuits, too.
  std::vector<bool> charge_is_given;
  std::vector<double> source_voltages;                 ///< of circuits (V)
  std::vector<double> pressures, pressure_rates;       ///< (Pa)
  std::vector<double> edge_forces, edge_rates;         ///< (N/m)
  std::vector<double> point_forces, point_force_rates; ///< (N)
  std::vector<double> point_moments;                   ///< (N m)
  std::vector<double> amplitudes, amplitude_rates, amplitude_second_rates;
  std::vector<double> film_temperatures, film_temperature_rates;   ///< (K)
  std::vector<double> frame_temperatures, frame_temperature_rates; ///< (K)
  std::vector<double> film_humidities, film_humidity_rates;        ///< (0 to 1)
  std::vector<double> frame_humidities, frame_humidity_rates;      ///< (0 to 1)
  std::vector<double> pre_stretch_shares; ///< of the way to the pre-stretch
};

/// Reads the signals between two of their kinks as the smooth functions they
/// are there: at the end of the interval a jump has not happened yet, at its
/// start it has.
class LoadHistory
{
public:
  explicit LoadHistory(const Device& device);

  /// The interval that begins at `start` and ends at the next kink.
  void enter_interval(double start);
  LoadState at(double time) const;
  /// All kinks in (start, end), increasing.
  std::vector<double> stop_times(double start, double end) const;
  /// True if any support ever moves.
  bool has_moving_supports() const;

private:
  void set_sources(LoadState& state) const;
  template <typename Function>
  void for_each_signal(const Function& function) const;
  double read(const Signal& signal, double time) const;
  double inside(double time) const;

  std::vector<Electrode> electrodes_;
  std::vector<Signal> voltages_, pressures_, edges_, amplitudes_;
  std::vector<Signal> charges_, pre_stretch_shares_;
  std::vector<Signal> film_temperatures_, frame_temperatures_;
  std::vector<Signal> film_humidities_, frame_humidities_;
  std::vector<Signal> point_forces_, point_moments_;
  double start_;
  double end_;
};
} // namespace taut::structure
