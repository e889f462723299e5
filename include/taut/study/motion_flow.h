#pragma once

#include <taut/study/case.h>
#include <taut/study/motion_track.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace taut::study
{
/// How a lumped model is followed.
struct FlowOptions
{
  /// The columns of its history that are watched; an empty velocity is the
  /// derivative through the rows.
  std::string of, velocity;
  /// Of the tolerances that the model runs at.
  double tolerance_factor = 1;
};

/// A lumped model from any state at any time on, in SI time. Its states are
/// dimensionless numbers.
class MotionFlow
{
public:
  virtual ~MotionFlow() = default;

  /// With which the case starts at a time. Errors: SolverFailed if the device
  /// fails there already.
  virtual std::vector<double> make_start(double time) const = 0;
  /// By which differences of the components of states are measured.
  virtual std::vector<double> get_scales() const = 0;
  /// The unit of the quantity watched.
  virtual std::string get_unit() const = 0;

  /// The state at `end` of the motion through `state` at `begin`. Appends what
  /// is watched at `times` (between both, increasing) and at both ends to
  /// `track`, if there is one.
  /// Errors: SolverFailed if the motion cannot be followed to the end, or if
  /// the device fails on the way.
  virtual std::vector<double> follow(const std::vector<double>& state,
                                     double begin, double end,
                                     const std::vector<double>& times,
                                     MotionTrack* track) const = 0;
};

/// The flow of a lumped case. Errors: BadInput for a film, an unknown column or
/// impossible parameters.
std::unique_ptr<MotionFlow> make_flow(const Case& lumped_case,
                                      const FlowOptions& options);

/// Names of the columns of a lumped model's history, and of the one that moves:
/// its angle, or the displacement of its bar.
std::vector<std::string> get_lumped_column_names(const Case& lumped_case);
std::string get_lumped_coordinate(const Case& lumped_case);
/// The column of its rate, empty if the history has none.
std::string get_lumped_velocity(const Case& lumped_case, const std::string& of);
} // namespace taut::study
