#include <taut/lumped/demes_run.h>
#include <taut/lumped/demes_statics.h>

#include "row_times.h"

namespace taut::lumped
{
namespace
{
DemesRow make_rest_row(const Demes& demes, const double time)
{
  DemesRow row;
  row.time = time;
  row.drive = demes.drive.value(time * demes.time_unit) / demes.drive_unit;
  const DemesState rest = make_rest_start(demes, row.drive);
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
  for (const double time : make_row_times(options.start_time, options.end_time,
                                          options.output_times))
  {
    DemesRow row = make_rest_row(demes, time);
    const bool first = run.rows.empty();
    if (!first)
      row.source_work = run.rows[0].free_energy - row.free_energy;
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
