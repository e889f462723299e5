#include "motion_recorder.h"

#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>
#include <taut/study/motion_flow.h>
#include <taut/study/motion_lumped.h>

#include "motion_text.h"

namespace taut::study
{
namespace
{
std::size_t find_place(const std::vector<Column>& columns,
                       const std::string& name)
{
  std::vector<std::string> names;
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    if (columns[i].name == name)
      return i;
    names.push_back(columns[i].name);
  }
  throw BadInput("the history has no column '" + name + "' for the motion; " +
                 suggest(name, names));
}

std::string describe_end(const Motion& motion)
{
  return "The motion of '" + motion.of +
         "' is not reproducible to the eye: from " +
         show_number(motion.reproducible_until) +
         " s on, another start within 1e-10 and a tenth of the tolerance "
         "leads more than a hundredth of its range away.";
}
} // namespace

MotionRecorder::MotionRecorder(const Case& run_case, RunOutput& output)
    : PassingOutput(&output), case_(run_case), description_(*run_case.motion)
{
}

void MotionRecorder::begin(const std::vector<Column>& columns)
{
  value_ = find_place(columns, description_.of);
  unit_ = columns[value_].unit;
  velocity_name_ = description_.velocity;
  if (velocity_name_.empty() && case_.model != "film")
    velocity_name_ = get_lumped_velocity(case_, description_.of);
  if (!velocity_name_.empty())
    velocity_ = find_place(columns, velocity_name_);
  PassingOutput::begin(columns);
  for (const auto& row : get_earlier_rows())
    record(row);
}

void MotionRecorder::record(const std::vector<double>& row)
{
  if (track_.size() == 0 || row[0] > track_.times.back())
    track_.add({row[0], row[value_], row[velocity_]});
}

void MotionRecorder::write_row(const std::vector<double>& row)
{
  record(row);
  PassingOutput::write_row(row);
}

void MotionRecorder::finish(RunSummary& summary)
{
  if (velocity_ == 0)
    track_.velocities = differentiate(track_.times, track_.values);
  if (track_.size() == 0 || track_.times.back() < description_.from)
  {
    summary.notes.push_back("The run ended before the motion was looked at, "
                            "from " +
                            show_number(description_.from) + " s on.");
    return;
  }
  std::optional<lumped::LyapunovExponent> lyapunov;
  if (description_.lyapunov_exponent)
    lyapunov = measure_lyapunov(case_, track_.times.back(), summary.notes);
  Motion motion = analyse_motion(track_, description_, lyapunov);
  motion.unit = unit_;
  motion.velocity = velocity_name_;
  if (const auto end = find_reproducible_end(case_, track_))
  {
    motion.reproducible_until = *end;
    motion.reproducible = *end >= track_.times.back();
    if (!*motion.reproducible)
      summary.notes.push_back(describe_end(motion));
  }
  summary.motion = std::move(motion);
}
} // namespace taut::study
