#pragma once

#include <taut/study/resonator_equivalent.h>
#include <taut/study/run.h>

#include <optional>
#include <string>
#include <vector>

/// One case by finite elements and by the lumped model.
namespace taut::study
{
/// A quantity that both models have.
struct ComparedQuantity
{
  std::string name;
  std::string unit;
  /// At Comparison::times; NaN in a model that has ended before.
  std::vector<double> film, lumped;
  /// |film - lumped| / max |lumped| over the compared rows: the largest, the
  /// root of the mean square, and where it is largest (s).
  double max_relative_difference = 0;
  double rms_relative_difference = 0;
  double time_of_max = 0;
};

/// An event in the words that both models share.
struct ComparedEvent
{
  double time = 0;    ///< (s)
  double voltage = 0; ///< (V)
  /// "loss of tension along 1", "... along 2" (the axes of the film), "loss of
  /// tension" if oblique, "breakdown", or the name of an event on a probe.
  std::string kind;
  /// "active", "passive", "active + passive", or the name of a probe.
  std::string place;
  bool at_start = false;
};

/// Both failures side by side; see Comparison.
struct FailureDifference
{
  /// Film less lumped, over that of the lumped model.
  double time = 0;
  double voltage = 0;
  bool same_kind = false;
  bool same_place = false;
};

struct Comparison
{
  ResonatorEquivalent equivalent;
  /// Rows of either model, except those at a jump of the voltage (s).
  std::vector<double> times;
  std::vector<double> voltage; ///< (V)
  std::vector<ComparedQuantity> quantities;
  std::vector<ComparedEvent> film_events, lumped_events;
  /// The event that ended the run of a model.
  std::optional<ComparedEvent> film_failure, lumped_failure;
  /// If both failed.
  std::optional<FailureDifference> failure_difference;
  /// Rows up to here count: until the earlier failure (s).
  double compared_until = 0;
  RunSummary film_summary;
};

/// The film case as the comparison runs it: its own probes, behind them those
/// that the lumped model has as well, and no fields and checkpoints.
/// `equivalent` is that of the case.
Case make_observed_case(const Case& film_case,
                        const ResonatorEquivalent& equivalent);

/// Runs `film_case` by finite elements and the lumped resonator it stands for
/// on the same output times. `structure` is that of the observed case. `output`
/// gets the run of the film as from run_film, except fields and checkpoints. A
/// quantity that stays zero in the lumped model is left out. Collective.
/// Errors: BadInput as run_film; SolverFailed if the lumped model fails. A
/// failure of the film's solver is in film_summary.
Comparison compare_models(const Case& film_case,
                          const ResonatorEquivalent& equivalent,
                          structure::Structure& structure, RunOutput& output);
} // namespace taut::study
