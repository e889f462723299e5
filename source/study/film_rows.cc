#include <taut/base/exceptions.h>
#include <taut/study/film_rows.h>

#include <algorithm>
#include <cmath>

namespace taut::study
{
FilmRows::FilmRows(structure::StructureSystem& system,
                   structure::Probes& probes, structure::Watches& watches,
                   const bool in_time)
    : system_(system), probes_(probes), watches_(watches), in_time_(in_time)
{
}

std::vector<Column> FilmRows::make_columns() const
{
  std::vector<Column> columns{{"time", "s"}};
  for (std::size_t i = 0; i < probes_.size(); ++i)
    columns.push_back({probes_.name(i), probes_.unit(i)});
  for (const char* name :
       {"kinetic energy", "stored energy", "frame energy", "electric energy",
        "dead load energy", "dissipated energy", "lost energy", "work",
        "energy balance"})
    columns.push_back({name, "J"});
  for (const std::size_t event : watches_.with_margin_curve())
    columns.push_back(
        {"margin " + system_.structure().device().events[event].name, "1"});
  return columns;
}

void FilmRows::begin(const double time, const double* state)
{
  const auto energies = system_.compute_energies(time, state);
  initial_energy_ = energies.total();
  // Until something moves, round-off would be measured against round-off.
  balance_scale_ = 1e-6 * energies.stored;
}

void FilmRows::resume(const RunProgress& progress)
{
  initial_energy_ = progress.initial_energy;
  balance_absolute_ = progress.balance_absolute;
  balance_scale_ = progress.balance_scale;
}

void FilmRows::save(RunProgress& progress) const
{
  progress.initial_energy = initial_energy_;
  progress.balance_absolute = balance_absolute_;
  progress.balance_scale = balance_scale_;
}

std::vector<double> FilmRows::make_row(const double time, const double* state)
{
  std::vector<double> row{time};
  const auto values = probes_.evaluate(time, state);
  row.insert(row.end(), values.begin(), values.end());
  const auto energies = system_.compute_energies(time, state);
  // The scalars live on the first rank.
  std::array<double, structure::n_scalars> scalars{};
  if (system_.layout().scalars > 0)
    std::copy_n(system_.scalars(state), scalars.size(), scalars.begin());
  for (double& scalar : scalars)
    scalar = dealii::Utilities::MPI::sum(scalar, system_.communicator());
  const double dissipated = scalars[structure::Scalar::dissipated];
  const double lost = scalars[structure::Scalar::lost];
  const double work = scalars[structure::Scalar::work];
  const double change = energies.total() - initial_energy_;
  const double balance = change + dissipated + lost - work;
  balance_absolute_ = std::max(balance_absolute_, std::abs(balance));
  balance_scale_ = std::max({balance_scale_, std::abs(change), dissipated,
                             std::abs(lost), std::abs(work), energies.kinetic});
  row.insert(row.end(), {energies.kinetic, energies.stored, energies.frames,
                         energies.electric, energies.dead_loads});
  for (const double value : {dissipated, lost, work, balance})
    row.push_back(in_time_ ? value : std::nan(""));
  for (const std::size_t event : watches_.with_margin_curve())
    row.push_back(show_margin(event, time, state));
  return row;
}

/// NaN outside the range of a law: that the event cannot be watched there is
/// for the run to say, which needs its last row.
double FilmRows::show_margin(const std::size_t event, const double time,
                             const double* state)
{
  try
  {
    return watches_.compute_margin(event, time, state);
  }
  catch (const StepRejected&)
  {
    return std::nan("");
  }
}

double FilmRows::balance_relative() const
{
  return balance_scale_ > 0 ? balance_absolute_ / balance_scale_ : 0.;
}
} // namespace taut::study
