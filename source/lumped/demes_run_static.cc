#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>
#include <taut/lumped/demes_run.h>
#include <taut/lumped/demes_statics.h>

#include <cmath>
#include <optional>

#include "row_times.h"

namespace taut::lumped
{
namespace
{
/// The stable equilibrium next to an angle; of two as near the greater one.
DemesState find_next_rest(const Demes& demes, const double drive,
                          const double angle)
{
  std::optional<DemesEquilibrium> next;
  for (const DemesEquilibrium& state : find_equilibria(demes, drive))
    if (state.stable && (!next || std::abs(state.angle - angle) <=
                                      std::abs(next->angle - angle)))
      next = state;
  if (!next)
    throw SolverFailed("the DEMES has no stable shape at the drive e = " +
                       number_text(drive));
  return {next->angle, 0, next->stretch};
}

double get_drive(const Demes& demes, const double time)
{
  return demes.drive.value(time * demes.time_unit) / demes.drive_unit;
}

DemesRow make_rest_row(const Demes& demes, const double time,
                       const DemesState& rest)
{
  DemesRow row;
  row.time = time;
  row.drive = get_drive(demes, time);
  row.angle = rest.angle;
  row.inner_stretch = row.stretch = rest.inner_stretch;
  row.conjugate = compute_electric(demes, row.stretch, row.drive).conjugate;
  row.membrane_force =
      compute_membrane_force(demes, row.stretch, row.stretch, row.drive);
  row.free_energy =
      compute_free_energy(demes, row.angle, row.stretch, row.drive);
  return row;
}
} // namespace

DemesRun run_rest_states(const Demes& demes, const DemesRunOptions& options)
{
  validate(demes);
  validate(options);
  DemesRun run;
  run.smallest_force = std::numeric_limits<double>::infinity();
  DemesState rest =
      make_rest_start(demes, get_drive(demes, options.start_time));
  for (const double time : make_row_times(options.start_time, options.end_time,
                                          options.output_times))
  {
    const bool first = run.rows.empty();
    if (!first)
      rest = find_next_rest(demes, get_drive(demes, time), rest.angle);
    const DemesRow row = make_rest_row(demes, time, rest);
    if (row.membrane_force <= 0 &&
        (first || run.rows.back().membrane_force > 0))
      run.events.push_back({first, row});
    if (row.membrane_force < run.smallest_force)
    {
      run.smallest_force = row.membrane_force;
      run.smallest_force_time = time;
    }
    run.rows.push_back(row);
  }
  return run;
}
} // namespace taut::lumped
