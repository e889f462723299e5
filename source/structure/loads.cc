#include <taut/structure/loads.h>
#include <taut/structure/sources.h>

#include <algorithm>
#include <limits>

namespace taut::structure
{
namespace
{
template <typename Entries, typename Get>
std::vector<Signal> collect(const Entries& entries, const Get& get)
{
  std::vector<Signal> signals;
  for (const auto& entry : entries)
    signals.push_back(get(entry));
  return signals;
}
} // namespace

LoadHistory::LoadHistory(const Device& device)
    : electrodes_(device.electrodes),
      voltages_(collect(device.electrodes,
                        [](const Electrode& e) { return e.voltage; })),
      pressures_(collect(device.pressures,
                         [](const Pressure& p) { return p.pressure; })),
      edges_(collect(device.edge_loads,
                     [](const EdgeLoad& e) { return e.force; })),
      amplitudes_(collect(device.supports,
                          [](const Support& s) { return s.amplitude; })),
      charges_(collect(device.electrodes,
                       [](const Electrode& e) { return e.charge; })),
      pre_stretch_shares_(collect(device.films, [](const Film& f)
                                  { return f.pre_stretch_share; })),
      film_temperatures_(
          collect(device.films, [](const Film& f) { return f.temperature; })),
      frame_temperatures_(
          collect(device.frames, [](const Frame& f) { return f.temperature; })),
      film_humidities_(
          collect(device.films, [](const Film& f) { return f.humidity; })),
      frame_humidities_(
          collect(device.frames, [](const Frame& f) { return f.humidity; })),
      point_forces_(collect(device.point_loads,
                            [](const PointLoad& l) { return l.force; })),
      point_moments_(collect(device.point_loads,
                             [](const PointLoad& l) { return l.moment; })),
      start_(-std::numeric_limits<double>::infinity()),
      end_(std::numeric_limits<double>::infinity())
{
}

template <typename Function>
void LoadHistory::for_each_signal(const Function& function) const
{
  for (const auto* list :
       {&voltages_, &charges_, &pressures_, &edges_, &amplitudes_,
        &film_temperatures_, &frame_temperatures_, &film_humidities_,
        &frame_humidities_, &pre_stretch_shares_, &point_forces_,
        &point_moments_})
    for (const auto& signal : *list)
      function(signal);
}

void LoadHistory::enter_interval(const double start)
{
  start_ = start;
  const auto kinks = stop_times(start, std::numeric_limits<double>::infinity());
  end_ =
      kinks.empty() ? std::numeric_limits<double>::infinity() : kinks.front();
}

double LoadHistory::read(const Signal& signal, const double time) const
{
  return time >= end_ ? signal.value_before(end_) : signal.value(time);
}

double LoadHistory::inside(const double time) const
{
  // Rates are those of the right at a kink: step back from the end.
  constexpr double margin = 1e-9;
  return time < end_ ? time : end_ - margin * (end_ - start_);
}

void LoadHistory::set_sources(LoadState& state) const
{
  state.source_voltages = state.voltages;
  for (std::size_t e = 0; e < electrodes_.size(); ++e)
  {
    const Electrode& electrode = electrodes_[e];
    const bool charge = electrode.control == Electrode::Control::charge;
    state.charge_is_given.push_back(charge);
    if (electrode.control == Electrode::Control::voltage)
      continue;
    state.voltages[e] =
        charge ? std::numeric_limits<double>::quiet_NaN()
               : compute_rest_voltage(electrode, state.source_voltages[e]);
    state.voltage_rates[e] = 0;
  }
}

LoadState LoadHistory::at(const double time) const
{
  LoadState state;
  const auto fill = [&](const std::vector<Signal>& signals,
                        std::vector<double>& values, std::vector<double>& rates)
  {
    for (const auto& signal : signals)
    {
      values.push_back(read(signal, time));
      rates.push_back(signal.rate(inside(time)));
    }
  };
  fill(voltages_, state.voltages, state.voltage_rates);
  fill(charges_, state.charges, state.charge_rates);
  set_sources(state);
  fill(pressures_, state.pressures, state.pressure_rates);
  fill(edges_, state.edge_forces, state.edge_rates);
  fill(amplitudes_, state.amplitudes, state.amplitude_rates);
  fill(film_temperatures_, state.film_temperatures,
       state.film_temperature_rates);
  fill(frame_temperatures_, state.frame_temperatures,
       state.frame_temperature_rates);
  fill(film_humidities_, state.film_humidities, state.film_humidity_rates);
  fill(frame_humidities_, state.frame_humidities, state.frame_humidity_rates);
  fill(point_forces_, state.point_forces, state.point_force_rates);
  for (const auto& signal : pre_stretch_shares_)
    state.pre_stretch_shares.push_back(read(signal, time));
  for (const auto& signal : point_moments_)
    state.point_moments.push_back(read(signal, time));
  for (const auto& signal : amplitudes_)
    state.amplitude_second_rates.push_back(signal.second_rate(inside(time)));
  return state;
}

std::vector<double> LoadHistory::stop_times(const double start,
                                            const double end) const
{
  std::vector<double> times;
  for_each_signal(
      [&](const Signal& signal)
      {
        const auto kinks = signal.kinks(start, end);
        times.insert(times.end(), kinks.begin(), kinks.end());
      });
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

bool LoadHistory::has_moving_supports() const
{
  return std::any_of(amplitudes_.begin(), amplitudes_.end(),
                     [](const Signal& signal)
                     { return !signal.is_constant(); });
}
} // namespace taut::structure
