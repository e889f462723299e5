#pragma once

#include <taut/study/comparison.h>
#include <taut/study/demes_equivalent.h>
#include <taut/study/oscillation.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

/// A DEMES by finite elements, as an elastica and as an arc.
namespace taut::study
{
struct DemesShape
{
  double angle = std::numeric_limits<double>::quiet_NaN();   ///< half (rad)
  double chord = std::numeric_limits<double>::quiet_NaN();   ///< (m)
  double stretch = std::numeric_limits<double>::quiet_NaN(); ///< of the film
};

/// A relaxed equilibrium of a lumped model. The frequencies (Hz) of small
/// motion about it are those with a film that stays relaxed and with networks
/// that do not flow meanwhile; NaN where it is unstable.
struct DemesRest
{
  double voltage = 0; ///< (V)
  DemesShape shape;
  double relaxed_frequency = std::numeric_limits<double>::quiet_NaN();
  double instantaneous_frequency = std::numeric_limits<double>::quiet_NaN();
};

struct DemesModel
{
  std::string name; ///< "finite elements", "elastica" or "arc"
  /// At the start; of finite elements without frequencies.
  DemesRest rest;
  /// Under the voltage at the end, if that has been steady over the second half
  /// of the run; not of finite elements.
  std::optional<DemesRest> driven;
  /// At DemesComparison::times; NaN in a model that has ended before.
  std::vector<double> angle, chord, stretch;
  /// Of the angle over the run, and the mean shape meanwhile.
  Oscillation oscillation;
  DemesShape mean;
};

struct DemesComparison
{
  DemesEquivalent equivalent;
  /// The output times, except those at a jump of the voltage (s).
  std::vector<double> times;
  std::vector<double> voltage; ///< (V)
  DemesModel film, elastica, arc;
  /// Angle, chord and stretch, against the arc and, with " (elastica)" behind
  /// the name, against the elastica.
  std::vector<ComparedQuantity> quantities;
  std::vector<EventRecord> film_events;
  /// The film of the arc begins to push.
  std::vector<ComparedEvent> arc_events;
  /// Rows up to here count (s).
  double compared_until = 0;
  RunSummary film_summary;
  /// What a reader of the numbers must know, as sentences.
  std::vector<std::string> notes;
};

/// The film case as the comparison runs it: without fields and checkpoints.
Case make_observed_demes_case(const Case& film_case);

/// Runs `film_case` by finite elements and both lumped models on the same
/// output times, all from their rest at the first voltage. `structure` is that
/// of the case; `output` gets the run of the film as from run_film, except
/// fields and checkpoints. The sign of the film's angle is taken such that it
/// is positive at rest, as those of the models. An elastica that cannot follow
/// its own motion ends in a note. Collective.
/// Errors: BadInput as run_film, or if a lumped model has no rest;
/// SolverFailed if the arc fails. A failure of the film's solver is in
/// film_summary.
DemesComparison compare_demes_models(const Case& film_case,
                                     const DemesEquivalent& equivalent,
                                     structure::Structure& structure,
                                     RunOutput& output);
} // namespace taut::study
