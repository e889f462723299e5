#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>
#include <taut/lumped/demes_elastica.h>

#include <algorithm>
#include <cmath>

#include "demes_drive.h"
#include "demes_elastica_clamped.h"

namespace taut::lumped
{
namespace
{
/// (theta, theta', xi) in time.
class Motion
{
public:
  Motion(const DemesElastica& elastica, const double start, const double end)
      : elastica_(elastica), clamped_(elastica),
        drive_(elastica.demes, start, end)
  {
  }

  const std::vector<double>& get_kinks() const
  {
    return drive_.get_kinks();
  }

  void begin_segment(const double begin, const double end, const double* y)
  {
    drive_.begin_segment(begin, end);
    clamped_.start(y[0], y[2], drive_.value(begin));
  }

  void compute_rate(const double time, const double* y, double* rate)
  {
    const auto& shape = clamped_.solve(y[0], y[2], drive_.value(time));
    rate[0] = y[1];
    rate[1] = -clamped_.compute_moment(shape);
    rate[2] = compute_inner_rate(elastica_.demes,
                                 clamped_.compute_stretch(shape), y[2]);
  }

  ElasticaRow observe(const double time, const double* y)
  {
    ElasticaRow row;
    row.time = time;
    row.velocity = y[1];
    row.inner_stretch = y[2];
    row.drive = drive_.value(time);
    row.shape = clamped_.solve(y[0], y[2], row.drive);
    row.stretch = clamped_.compute_stretch(row.shape);
    row.membrane_force =
        compute_membrane_force(elastica_.demes, row.stretch, y[2], row.drive);
    return row;
  }

private:
  const DemesElastica& elastica_;
  ClampedElastica clamped_;
  DemesDrive drive_;
};

void require_start(const DemesElastica& elastica,
                   const ElasticaRunOptions& options)
{
  validate(elastica);
  if (!(options.end_time >= options.start_time))
    throw BadInput("a run must end after it starts, not go from tau = " +
                   number_text(options.start_time) +
                   " to tau = " + number_text(options.end_time));
  if (!(options.start.inner_stretch > 0))
    throw BadInput("the inner stretch at the start must be positive, got " +
                   number_text(options.start.inner_stretch));
  const Demes& demes = elastica.demes;
  try
  {
    ClampedElastica(elastica).start(
        options.start.angle, options.start.inner_stretch,
        demes.drive.value(options.start_time * demes.time_unit) /
            demes.drive_unit);
  }
  catch (const StepRejected& rejection)
  {
    throw BadInput("an elastica whose frame has no inertia cannot start with "
                   "the end rotation " +
                   number_text(options.start.angle) + ": " + rejection.what());
  }
}
} // namespace

std::vector<ElasticaRow> run_elastica(const DemesElastica& elastica,
                                      const ElasticaRunOptions& options)
{
  require_start(elastica, options);
  Motion motion(elastica, options.start_time, options.end_time);
  time::OdeProblem problem;
  problem.size = 3;
  problem.rate = [&](const double time, const double* y, double* rate)
  { motion.compute_rate(time, y, rate); };
  problem.begin_segment = [&](const double begin, const double end, double* y)
  { motion.begin_segment(begin, end, y); };
  problem.stop_times = motion.get_kinks();
  std::vector<ElasticaRow> rows;
  time::OdeObserver observer;
  observer.output = [&](const double time, const double* y)
  { rows.push_back(motion.observe(time, y)); };
  // The oscillation decides the steps.
  time::OdeOptions ode = options.ode;
  if (ode.method == time::OdeMethod::automatic)
    ode.method = time::OdeMethod::explicit_runge_kutta;
  std::vector<double> y = {options.start.angle, options.start.velocity,
                           options.start.inner_stretch};
  time::integrate_ode(
      problem, {options.start_time, options.end_time, options.output_times},
      ode, {}, observer, y);
  return rows;
}
} // namespace taut::lumped
