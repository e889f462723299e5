#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>
#include <taut/base/number_text.h>
#include <taut/study/lumped_case.h>
#include <taut/study/lumped_case_demes.h>
#include <taut/study/motion_flow.h>

#include <algorithm>

namespace taut::study
{
namespace
{
template <typename ModelColumn>
std::vector<std::string> list_names(const std::vector<ModelColumn>& columns)
{
  std::vector<std::string> names;
  for (const auto& entry : columns)
    names.push_back(entry.column.name);
  return names;
}

template <typename ModelColumn>
const ModelColumn& find_watched(const std::vector<ModelColumn>& columns,
                                const std::string& name)
{
  for (const auto& entry : columns)
    if (entry.column.name == name)
      return entry;
  throw BadInput("the history has no column '" + name + "'; " +
                 suggest(name, list_names(columns)));
}

/// What of the rows of a model is watched.
template <typename ModelColumn>
class Watched
{
public:
  Watched(const std::vector<ModelColumn>& columns, const FlowOptions& options)
      : value_(find_watched(columns, options.of)),
        velocity_(options.velocity.empty()
                      ? nullptr
                      : &find_watched(columns, options.velocity))
  {
  }

  const std::string& get_unit() const
  {
    return value_.column.unit;
  }

  /// The rows of a run; make(row) gives them in SI units.
  template <typename Run, typename MakeRow>
  void add(const Run& run, const MakeRow& make, MotionTrack& track) const
  {
    const std::size_t first = track.size();
    for (const auto& lumped_row : run.rows)
    {
      const auto row = make(lumped_row);
      track.add(
          {row.time, row.*value_.value, velocity_ ? row.*velocity_->value : 0});
    }
    complete(first, track);
  }

private:
  /// Rows from `first` on that came without their velocities.
  void complete(const std::size_t first, MotionTrack& track) const
  {
    if (velocity_)
      return;
    const auto begin = std::ptrdiff_t(first);
    const auto rates =
        differentiate({track.times.begin() + begin, track.times.end()},
                      {track.values.begin() + begin, track.values.end()});
    std::copy(rates.begin(), rates.end(), track.velocities.begin() + begin);
  }

  const ModelColumn& value_;
  const ModelColumn* velocity_;
};

/// Its state is angle, velocity and inner stretch.
class DemesFlow : public MotionFlow
{
public:
  DemesFlow(const LumpedDemesDescription& device, const FlowOptions& options)
      : device_(device), watched_(get_lumped_demes_columns(), options),
        demes_(lumped::make_demes(make_demes_si(device))),
        scales_(lumped::make_scales(make_demes_si(device))),
        tolerance_(std::max(options.tolerance_factor * device.tolerance, 1e-13))
  {
  }

  std::vector<double> make_start(double) const override
  {
    const auto start = study::make_start(device_);
    return {start.angle, start.velocity, start.inner_stretch};
  }

  std::vector<double> get_scales() const override
  {
    return {1, 1, 1};
  }

  std::string get_unit() const override
  {
    return watched_.get_unit();
  }

  std::vector<double> follow(const std::vector<double>& state,
                             const double begin, const double end,
                             const std::vector<double>& times,
                             MotionTrack* const track) const override
  {
    lumped::DemesRunOptions options;
    options.start_time = begin / demes_.time_unit;
    options.end_time = end / demes_.time_unit;
    for (const double time : times)
      options.output_times.push_back(time / demes_.time_unit);
    options.start = {state[0], state[1], state[2]};
    options.tolerance = tolerance_;
    const auto run = lumped::run_demes(demes_, options);
    if (track)
      watched_.add(
          run,
          [this](const auto& row)
          { return make_lumped_row(device_, scales_, row); },
          *track);
    const auto& last = run.rows.back();
    return {last.angle, last.velocity, last.inner_stretch};
  }

private:
  const LumpedDemesDescription device_;
  const Watched<LumpedDemesColumn> watched_;
  const lumped::Demes demes_;
  const lumped::DemesScales scales_;
  const double tolerance_;
};

/// Its state is the stretch of the active strip, its rate over the natural unit
/// of frequency, and the internal stretches.
class ResonatorFlow : public MotionFlow
{
public:
  ResonatorFlow(const LumpedResonatorDescription& device,
                const ProcedureDescription& procedure,
                const FlowOptions& options)
      : device_(device), watched_(get_lumped_columns(), options),
        resonator_(lumped::make_resonator(make_resonator_si(device))),
        scales_(lumped::make_scales(make_resonator_si(device))),
        relaxed_(procedure.start == structure::Start::relaxed),
        tolerance_factor_(options.tolerance_factor)
  {
  }

  std::vector<double> make_start(const double time) const override
  {
    auto options = make_options(time, time);
    options.start = relaxed_ ? lumped::ResonatorStart::relaxed
                             : lumped::ResonatorStart::unrelaxed;
    const auto run = lumped::run_inertial(resonator_, options);
    // Such a failure would stop no run.
    if (!run.events.empty())
      refuse(run.events.front());
    return get_state(run.rows.back());
  }

  std::vector<double> get_scales() const override
  {
    return std::vector<double>(2 + resonator_.n_internal(), 1.);
  }

  std::string get_unit() const override
  {
    return watched_.get_unit();
  }

  std::vector<double> follow(const std::vector<double>& state,
                             const double begin, const double end,
                             const std::vector<double>& times,
                             MotionTrack* const track) const override
  {
    auto options = make_options(begin, end);
    options.output_times = times;
    options.start = lumped::ResonatorStart::given;
    options.internal.assign(state.begin() + 2, state.end());
    options.displacement = state[0] - find_balance(options);
    options.velocity = state[1] * scales_.angular_frequency;
    const auto run = lumped::run_inertial(resonator_, options);
    if (run.failure)
      refuse(*run.failure);
    if (track)
      watched_.add(
          run,
          [this](const auto& row)
          { return make_lumped_row(device_, scales_, row); },
          *track);
    return get_state(run.rows.back());
  }

private:
  [[noreturn]] static void refuse(const lumped::ResonatorEvent& failure)
  {
    throw SolverFailed(lumped::to_text(failure.failure) + " in " +
                       lumped::to_text(failure.place) + " at " +
                       number_text(failure.row.time) + " s");
  }

  lumped::ResonatorRunOptions make_options(const double begin,
                                           const double end) const
  {
    lumped::ResonatorRunOptions options;
    options.start_time = begin;
    options.end_time = end;
    // No tolerance below round-off.
    options.ode.relative_tolerance =
        std::max(tolerance_factor_ * options.ode.relative_tolerance, 1e-14);
    options.ode.absolute_tolerance =
        std::max(tolerance_factor_ * options.ode.absolute_tolerance, 1e-15);
    return options;
  }

  /// From which the displacement of a start is counted.
  double find_balance(const lumped::ResonatorRunOptions& options) const
  {
    lumped::FrozenResonator frozen(resonator_);
    frozen.freeze(options.internal.data());
    return frozen.find_balance(resonator_.voltage.value(options.start_time) /
                               resonator_.voltage_unit);
  }

  std::vector<double> get_state(const lumped::ResonatorRow& row) const
  {
    std::vector<double> state{row.stretch_1a,
                              row.velocity / scales_.angular_frequency};
    state.insert(state.end(), row.internal.begin(), row.internal.end());
    return state;
  }

  const LumpedResonatorDescription device_;
  const Watched<LumpedColumn> watched_;
  const lumped::Resonator resonator_;
  const lumped::ResonatorScales scales_;
  const bool relaxed_;
  const double tolerance_factor_;
};

bool is_demes(const Case& lumped_case)
{
  return lumped_case.model == "demes";
}
} // namespace

std::unique_ptr<MotionFlow> make_flow(const Case& lumped_case,
                                      const FlowOptions& options)
{
  if (is_demes(lumped_case))
    return std::make_unique<DemesFlow>(lumped_case.lumped_demes, options);
  if (lumped_case.model == "resonator")
    return std::make_unique<ResonatorFlow>(lumped_case.lumped_resonator,
                                           lumped_case.procedure, options);
  throw BadInput("only a lumped model can be followed from any state");
}

std::vector<std::string> get_lumped_column_names(const Case& lumped_case)
{
  return is_demes(lumped_case) ? list_names(get_lumped_demes_columns())
                               : list_names(get_lumped_columns());
}

std::string get_lumped_coordinate(const Case& lumped_case)
{
  return is_demes(lumped_case) ? "angle" : "bar displacement";
}

std::string get_lumped_velocity(const Case& lumped_case, const std::string& of)
{
  if (of != get_lumped_coordinate(lumped_case))
    return "";
  return is_demes(lumped_case) ? "angular velocity" : "bar velocity";
}
} // namespace taut::study
