#pragma once

#include <taut/time/integrate.h>

#include <vector>

namespace taut::time
{
/// Knows which watches are armed and finds when they fire. A watch that fired
/// is armed again once its value has been above what it must recover to.
class EventFinder
{
public:
  explicit EventFinder(const std::vector<Watch>& watches);

  /// The armed watches that are negative here: at the start, or after a jump.
  std::vector<Event> check(double time, const double* state, bool at_start);

  /// The events inside a step, in order of time, each located on the dense
  /// output to about 1e-14 of its time. `scratch` has room for a state.
  std::vector<Event> find(const Step& step, double* scratch);

  std::vector<bool> get_armed() const;

private:
  struct Condition
  {
    double value = 0;
    bool is_armed = true;
  };

  double locate(const Watch& watch, const Step& step, double begin_value,
                double end_value, double* scratch) const;

  const std::vector<Watch>& watches_;
  std::vector<Condition> conditions_;
};
} // namespace taut::time
