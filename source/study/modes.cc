#include <taut/base/exceptions.h>
#include <taut/structure/vibration_damping.h>
#include <taut/study/modes.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include <boost/math/constants/constants.hpp>

namespace taut::study
{
namespace
{
using structure::Networks;
using structure::Vibration;

/// Squares of frequencies below this part of the largest count as zero.
constexpr double round_off = 1e-9;
/// Internal variables that will still change by more than this are not at rest.
constexpr double noticeable_drift = 1e-3;

/// With two digits.
std::string show(const double value)
{
  std::ostringstream text;
  text.precision(2);
  text << value;
  return text.str();
}

/// The modes about one state of a run.
class FilmModes
{
public:
  FilmModes(const Case& run_case, structure::StructureSystem& system,
            const double time, std::vector<double>& state)
      : case_(run_case), system_(system), time_(time), state_(state)
  {
    report_.time = time;
    settle();
    vibration_ = std::make_unique<Vibration>(
        system.structure(), system.loads_at(time, state.data()), state.data(),
        system.internal(state.data()));
  }

  void find();
  std::vector<std::vector<double>> make_motions() const;
  const ModesReport& report() const
  {
    return report_;
  }
  const std::vector<std::string>& notes() const
  {
    return notes_;
  }

private:
  void settle();
  std::vector<time::VibrationMode> find_modes();
  int count_unstable(const std::vector<time::VibrationMode>& modes);
  double find_lowest(const std::vector<time::VibrationMode>& modes);
  void describe(const std::vector<structure::DampedMode>& damped);
  void set_masses(const time::VibrationMode& mode, ModesReport::Mode& row);
  double compute_drift();

  const Case& case_;
  structure::StructureSystem& system_;
  const double time_;
  std::vector<double>& state_;
  std::unique_ptr<Vibration> vibration_;
  std::vector<time::VibrationMode> modes_;
  ModesReport report_;
  std::vector<std::string> notes_;
};

/// Moves the state to the equilibrium at its internal variables.
void FilmModes::settle()
{
  auto& structure = system_.structure();
  const std::vector<double> before(state_.begin(),
                                   state_.begin() + structure.n_free());
  structure::Equilibrium problem(structure, system_.history(),
                                 Networks::as_given,
                                 system_.internal(state_.data()));
  problem.hold_charges(system_.get_charges(state_.data()));
  time::EquilibriumOptions options;
  options.tolerance = case_.procedure.newton_tolerance;
  try
  {
    time::find_equilibrium(problem, time_, state_.data(), options);
  }
  catch (const StepRejected& rejection)
  {
    std::ostringstream message;
    message << "no vibration modes: next to the state at the time " << time_
            << " s there is no equilibrium with the internal variables held ("
            << rejection.what() << ")";
    throw SolverFailed(message.str());
  }
  structure.normalise_rotations(state_.data());
  double moved = 0;
  for (std::size_t i = 0; i < before.size(); ++i)
    moved = std::max(moved, std::abs(state_[i] - before[i]));
  report_.moved = dealii::Utilities::MPI::max(moved, structure.communicator());
}

std::vector<time::VibrationMode> FilmModes::find_modes()
{
  constexpr double full_turn = 2 * boost::math::constants::pi<double>();
  time::ModeOptions options;
  options.count = case_.modes.count;
  if (case_.modes.near_frequency > 0)
    options.target = std::pow(full_turn * case_.modes.near_frequency, 2);
  auto search = time::find_modes(*vibration_, options);
  if (!search.complete)
    notes_.push_back("there are more modes between those found");
  return std::move(search.modes);
}

double FilmModes::find_lowest(const std::vector<time::VibrationMode>& modes)
{
  if (case_.modes.near_frequency == 0)
    return modes.front().square;
  time::ModeOptions options;
  options.count = 1;
  return time::find_modes(*vibration_, options).modes.front().square;
}

int FilmModes::count_unstable(const std::vector<time::VibrationMode>& modes)
{
  double largest = 0;
  for (const auto& mode : modes)
    largest = std::max(largest, std::abs(mode.square));
  return vibration_->factorise(-round_off * largest);
}

void FilmModes::find()
{
  const bool wants_relaxed =
      case_.modes.networks == ModesDescription::Networks::relaxed;
  auto frozen = find_modes();
  report_.lowest_frozen = find_lowest(frozen);
  report_.unstable_frozen = count_unstable(frozen);
  const double asymmetry = vibration_->asymmetry();
  if (asymmetry > round_off)
    notes_.push_back(
        "the tangent is not symmetric (" + show(asymmetry) +
        " of its norm), as follower forces and pressures on free edges make "
        "it: the modes are those of its symmetric part, which shows no "
        "flutter");
  std::vector<time::VibrationMode> relaxed;
  const bool relaxes = !vibration_->relaxations().empty();
  if (relaxes)
  {
    vibration_->relax();
    relaxed = find_modes();
    report_.lowest_relaxed = find_lowest(relaxed);
    report_.unstable_relaxed = count_unstable(relaxed);
  }
  else
  {
    report_.lowest_relaxed = report_.lowest_frozen;
    report_.unstable_relaxed = report_.unstable_frozen;
  }
  const double drift = compute_drift();
  const bool at_rest = drift < noticeable_drift;
  if (!at_rest)
    notes_.push_back(
        "the networks still relax (their longest time multiplies the fastest "
        "change of their internal variables to " +
        show(drift) +
        "): damping and stability are those of the moment, with "
        "the networks frozen");
  report_.stable =
      (at_rest ? report_.unstable_relaxed : report_.unstable_frozen) == 0;
  if (relaxes && wants_relaxed)
    std::swap(frozen, relaxed);
  modes_ = std::move(frozen);
  for (const auto& relaxation : vibration_->relaxations())
    report_.relaxations.push_back({relaxation.name, relaxation.time});
  report_.total_mass = vibration_->total_mass();
  describe(
      structure::compute_damped_modes(*vibration_, modes_, relaxed, at_rest));
}

void FilmModes::describe(const std::vector<structure::DampedMode>& damped)
{
  for (std::size_t i = 0; i < modes_.size(); ++i)
  {
    ModesReport::Mode row;
    row.square = modes_[i].square;
    row.growth_rate = damped[i].rate.real();
    row.damped_angular_frequency = damped[i].rate.imag();
    row.damping_ratio = damped[i].ratio();
    row.products = damped[i].products;
    set_masses(modes_[i], row);
    report_.modes.push_back(row);
  }
}

void FilmModes::set_masses(const time::VibrationMode& mode,
                           ModesReport::Mode& row)
{
  const double largest = vibration_->compute_largest(
      vibration_->compute_motion(mode.shape.data()));
  row.modal_mass = largest > 0 ? 1 / (largest * largest) : 0.;
  for (unsigned int axis = 0; axis < 3; ++axis)
    row.effective_masses.push_back(std::pow(
        vibration_->multiply(mode.shape.data(),
                             vibration_->get_unit_inertia(axis).data()),
        2));
}

/// Fastest change of an internal variable times the longest relaxation time.
double FilmModes::compute_drift()
{
  auto& structure = system_.structure();
  std::vector<double> forces(structure.n_free()), rates(structure.n_internal());
  structure.compute_forces(system_.loads_at(time_, state_.data()),
                           state_.data(), system_.internal(state_.data()),
                           Networks::as_given, forces.data(), rates.data());
  double rate = 0, longest = 0;
  for (const double entry : rates)
    rate = std::max(rate, std::abs(entry));
  for (std::size_t r = 0; r < vibration_->relaxations().size(); ++r)
    if (!vibration_->is_circuit(r))
      longest = std::max(longest, vibration_->relaxations()[r].time);
  return longest * dealii::Utilities::MPI::max(rate, structure.communicator());
}

std::vector<std::vector<double>> FilmModes::make_motions() const
{
  const double extent = case_.modes.amplitude *
                        structure::compute_extent(system_.structure().mesh());
  std::vector<std::vector<double>> motions;
  for (const auto& mode : modes_)
  {
    motions.push_back(vibration_->compute_motion(mode.shape.data()));
    const double largest = vibration_->compute_largest(motions.back());
    for (double& entry : motions.back())
      entry *= largest > 0 ? extent / largest : 0.;
  }
  return motions;
}
} // namespace

RunSummary run_film_modes(const Case& run_case, structure::Structure& structure,
                          RunOutput& output, const WriteModeShapes& write)
{
  // The frames of fields.pvd are those of the modes.
  Case quiet = run_case;
  quiet.output.write_fields = false;
  StateVisit visit;
  visit.at_start = run_case.modes.at == ModesDescription::At::start;
  visit.visit = [&](const double time, structure::StructureSystem& system,
                    std::vector<double>& state, RunSummary& summary)
  {
    FilmModes modes(run_case, system, time, state);
    modes.find();
    summary.modes = modes.report();
    summary.notes.insert(summary.notes.end(), modes.notes().begin(),
                         modes.notes().end());
    if (run_case.output.write_fields)
      write({time, system, state.data(), modes.make_motions()});
  };
  RunSummary summary = run_film(quiet, structure, output, std::nullopt, visit);
  if (!summary.modes && summary.status != Status::failed)
    summary.notes.push_back(
        "no vibration modes: the run ended before it came to the state");
  return summary;
}
} // namespace taut::study
