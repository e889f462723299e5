#pragma once

#include <taut/lumped/demes.h>
#include <taut/lumped/demes_run.h>

#include <string>
#include <vector>

#include "demes_drive.h"
#include "demes_radau_rule.h"

namespace taut::lumped
{
/// A state and what has been exchanged since the beginning of the step: energy
/// dissipated, and work of the source as in DemesRow.
struct DemesMoment
{
  DemesState state;
  double dissipated = 0;
  double source_work = 0;
};

/// Integrates the motion of a DEMES by collocation. Within a step the angle's
/// acceleration is found by fixed-point iteration, while the fourth power q of
/// the inner stretch, whose equation is linear,
///   q' = (4 beta / S) (lambda^2 - q lambda^-2),
/// follows the angle by one small linear system: the dashpot may be as fast as
/// it likes without holding back the step.
class DemesStepper
{
public:
  DemesStepper(const Demes& demes, const DemesRunOptions& options,
               time::OdeStatistics& statistics);

  /// Times of a jump or kink of the drive.
  const std::vector<double>& get_kinks() const
  {
    return drive_signal_.get_kinks();
  }

  /// Starts anew; the drive is smooth between `time` and `end`.
  void start(double time, double end, const DemesState& state);
  /// One accepted step. Errors: SolverFailed if the step vanishes.
  void advance();

  /// The later end of the last step.
  double get_time() const
  {
    return time_;
  }
  const DemesState& get_state() const
  {
    return state_;
  }
  /// Time of the point i of the last step, 0 <= i <= RadauRule::n.
  double get_point_time(int i) const;
  /// Force of the film there.
  double get_point_force(int i) const
  {
    return force_[i];
  }

  /// At a time within the last step.
  DemesMoment interpolate(double time) const;

  /// As DemesDrive in the present segment.
  double get_drive(const double time) const
  {
    return drive_signal_.value(time);
  }

private:
  using Nodal = RadauRule::Nodal;
  using Sampled = RadauRule::Sampled;

  double get_relaxation_rate() const;
  void predict(double step);
  bool solve(double step);
  void place_angles(double step);
  void update_chords();
  bool is_admissible();
  bool relax_inner(double step);
  double update_accelerations(int first, int last);
  void finish(double step);
  double measure_error(double step) const;
  double get_scale() const;
  void accept(double step, double end);
  void compute_exchanges(double step);

  const Demes& demes_;
  const DemesRunOptions& options_;
  time::OdeStatistics& statistics_;
  const RadauRule& rule_;
  DemesDrive drive_signal_;
  double begin_ = 0, time_ = 0, end_ = 0;
  double step_ = 0;
  /// Length of the last step, 0 if there is none in this segment.
  double last_step_ = 0;
  DemesState state_;
  std::string reason_;
  /// At the beginning and the points of the step being tried.
  Sampled angle_{}, velocity_{}, inner_power_{}, acceleration_{}, force_{},
      drive_{};
  /// lambda and d lambda / d theta.
  Sampled stretch_{}, slope_{};
  /// Of the last accepted step.
  Sampled last_acceleration_{}, dissipated_{}, source_work_{};
};
} // namespace taut::lumped
