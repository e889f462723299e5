#pragma once

#include <taut/structure/watches.h>
#include <taut/study/run.h>

#include <vector>

namespace taut::study
{
/// The rows of a film run's history: time, probes, energies and the residual
/// of their balance, which it keeps count of, and the margins of its events
/// (structure::Watches::with_margin_curve).
class FilmRows
{
public:
  /// `in_time`: a motion or a slow flow, whose balance of energy holds. On
  /// static paths nobody counts the work, and its columns are NaN.
  FilmRows(structure::StructureSystem& system, structure::Probes& probes,
           structure::Watches& watches, bool in_time);

  std::vector<Column> make_columns() const;

  /// Sets the energy that the balance is measured against.
  void begin(double time, const double* state);
  /// The same for a run that goes on.
  void resume(const RunProgress& progress);
  void save(RunProgress& progress) const;

  /// Collective.
  std::vector<double> make_row(double time, const double* state);

  double balance_absolute() const
  {
    return balance_absolute_;
  }
  /// Relative to the largest energy that moved so far, at least a millionth of
  /// what was stored at the start.
  double balance_relative() const;

private:
  double show_margin(std::size_t event, double time, const double* state);

  structure::StructureSystem& system_;
  structure::Probes& probes_;
  structure::Watches& watches_;
  const bool in_time_;
  double initial_energy_ = 0;
  double balance_absolute_ = 0;
  double balance_scale_ = 0;
};
} // namespace taut::study
