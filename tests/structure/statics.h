#pragma once

#include <algorithm>
#include <cmath>

#include "structure/devices.h"

namespace taut::testing
{
/// Equilibria of a structure under constant loads that a test sets one by one.
class Statics
{
public:
  /// Internal variables start unrelaxed.
  explicit Statics(
      structure::Structure& structure,
      const structure::Networks networks = structure::Networks::relaxed)
      : loads(structure.device()), u(structure.n_free(), 0.),
        internal(structure.n_internal()), structure_(structure),
        networks_(networks), history_(structure.device()),
        problem_(*this, networks)
  {
    fe::set_unrelaxed(structure.cells(), internal.data());
    history_.enter_interval(0);
  }

  /// The signals of this description count, at time 0, after `apply`.
  structure::Device loads;
  std::vector<double> u, internal;
  /// Further forces on the free unknowns (N); none if empty.
  std::vector<double> nodal_forces;

  void apply()
  {
    history_ = structure::LoadHistory(loads);
    history_.enter_interval(0);
  }
  void set_voltage(const double voltage)
  {
    for (auto& electrode : loads.electrodes)
      electrode.voltage = Signal::constant(voltage);
    apply();
  }
  void set_pressure(const double pressure)
  {
    loads.pressures[0].pressure = Signal::constant(pressure);
    apply();
  }
  void set_amplitude(const unsigned int support, const double amplitude)
  {
    loads.supports[support].amplitude = Signal::constant(amplitude);
    apply();
  }
  /// At the present u, with the voltages that given charges need.
  structure::LoadState get_loads() const
  {
    return structure_.resolve_voltages(history_.at(0), u.data(),
                                       internal.data(), networks_);
  }

  /// Newton from `u`; residual below `tolerance` of the internal forces.
  void find(const double tolerance = 1e-13)
  {
    time::EquilibriumOptions options;
    options.tolerance = tolerance;
    time::find_equilibrium(problem_, 0, u.data(), options);
  }
  /// At the last equilibrium.
  std::array<double, 3> get_reaction(const unsigned int support) const
  {
    return structure_.compute_reaction(support);
  }
  structure::Energies compute_energies()
  {
    return structure_.compute_energies(get_loads(), u.data(), nullptr,
                                       internal.data());
  }
  /// Of the tangent; collective.
  int count_negative_eigenvalues()
  {
    problem_.prepare(0, u.data());
    return structure_.count_negative_eigenvalues();
  }
  /// C of all points of this rank as (xx, yy, xy) in the material axes.
  std::vector<std::array<double, 3>> compute_metric()
  {
    return fe::compute_metric(structure_.cells(), structure_.compute_positions(
                                                      get_loads(), u.data()));
  }

private:
  class Problem : public structure::Equilibrium
  {
  public:
    Problem(Statics& statics, const structure::Networks networks)
        : Equilibrium(statics.structure_, statics.history_, networks,
                      statics.internal.data()),
          nodal_forces_(statics.nodal_forces)
    {
    }
    void compute_residual(const double load, const double* unknowns,
                          double* residual) override
    {
      Equilibrium::compute_residual(load, unknowns, residual);
      for (std::size_t i = 0; i < nodal_forces_.size(); ++i)
        residual[i] -= nodal_forces_[i];
    }

  private:
    const std::vector<double>& nodal_forces_;
  };

  structure::Structure& structure_;
  const structure::Networks networks_;
  structure::LoadHistory history_;
  Problem problem_;
};

/// The largest deviation of C from a homogeneous one over all points.
inline double
compute_deviation(const std::vector<std::array<double, 3>>& metric,
                  const std::array<double, 3>& expected)
{
  double deviation = 0;
  for (const auto& C : metric)
    for (unsigned int i = 0; i < 3; ++i)
      deviation = std::max(deviation, std::abs(C[i] - expected[i]));
  return dealii::Utilities::MPI::max(deviation, MPI_COMM_WORLD);
}

/// Refines the cells whose centre is in the lower left quarter of a box.
inline void refine_corner(fe::Triangulation& triangulation, const double length,
                          const double width)
{
  for (const auto& cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned() && cell->center()[0] < .5 * length &&
        cell->center()[1] < .5 * width)
      cell->set_refine_flag();
  triangulation.execute_coarsening_and_refinement();
}
} // namespace taut::testing
