#pragma once

#include <taut/structure/structure.h>
#include <taut/time/equilibrium.h>
#include <taut/time/system.h>

#include <functional>
#include <vector>

namespace taut::structure
{
/// Equilibrium of a structure at the loads of a time, with the internal
/// variables given or relaxed.
class Equilibrium : public time::EquilibriumProblem
{
public:
  /// `internal` is read at every call; it may be null if networks are relaxed.
  Equilibrium(Structure& structure, LoadHistory& history, Networks networks,
              const double* internal);

  MPI_Comm communicator() const override;
  std::size_t n_unknowns() const override;
  void compute_residual(double load, const double* u,
                        double* residual) override;
  void prepare(double load, const double* u) override;
  void solve(const double* r, double* d) override;
  double reference_force() const override;
  double round_off_force() const override;
  bool takes_full_steps() const override;
  void forget_iteration() override;
  std::optional<int> count_negative_eigenvalues() override;

  /// Circuits keep these charges (C, by electrode) instead of being at rest.
  void hold_charges(const std::vector<double>& charges)
  {
    held_charges_ = charges;
  }

private:
  LoadState loads_at(double load, const double* u);

  Structure& structure_;
  LoadHistory& history_;
  Networks networks_;
  const double* internal_;
  std::vector<double> no_internal_;
  std::vector<double> held_charges_;
};

/// The scalars of the state, integrated with the motion for the balance of
/// energy: total energy + dissipated + lost - work stays constant.
enum Scalar : unsigned int
{
  dissipated = 0, ///< in the networks (J)
  lost = 1, ///< to air and resistors and in jumps of quasi-static runs (J)
  work = 2, ///< of sources, loads and moving supports (J)
  n_scalars = 3
};

/// Common to both systems in time: the state and how it begins. Its globals are
/// the charges of circuits over Structure::charge_scales.
class StructureSystem : public time::System
{
public:
  MPI_Comm communicator() const override;
  time::StateLayout layout() const override;
  std::vector<double> stop_times(double start, double end) const override;

  bool has_inertia() const
  {
    return inertia_;
  }
  Structure& structure()
  {
    return structure_;
  }
  LoadHistory& history()
  {
    return history_;
  }
  /// All loads at a state, with the voltages that follow from charges.
  /// Collective. Errors: as Structure::resolve_voltages.
  LoadState loads_at(double time, const double* state);
  /// Charges of circuits, by electrode (C); 0 for others. Collective.
  std::vector<double> get_charges(const double* state) const;
  /// Relaxes the internal variables of a state.
  void set_relaxed(double time, double* state);
  /// Charges circuits until their currents rest at the given shape.
  void set_circuits_at_rest(double time, double* state);

  /// A state at rest, circuits included: internal variables relaxed or A = 1,
  /// positions in equilibrium with them if `in_equilibrium`, else those of the
  /// mesh. Errors: as time::follow_path.
  std::vector<double> make_initial_state(double time, Start start,
                                         bool in_equilibrium,
                                         const time::PathOptions& options);

  /// Moves u from the mesh to the shape of the start, with the networks and
  /// internal variables given.
  using FindShape =
      std::function<void(Networks networks, const double* internal, double* u)>;
  /// The same with positions that `find_shape` finds.
  std::vector<double> make_initial_state(double time, Start start,
                                         const FindShape& find_shape);

  /// Parts of a state of this system.
  const double* internal(const double* state) const;
  double* internal(double* state) const;
  const double* velocities(const double* state) const;
  const double* scalars(const double* state) const;

  /// Energies at a state; the balance residual is
  /// total + dissipated + lost - work minus the same at the start.
  Energies compute_energies(double time, const double* state);

protected:
  StructureSystem(Structure& structure, bool inertia);
  double* scalars(double* state) const;
  /// Writes charges (C, by electrode) into the globals of a state.
  void set_charges(const std::vector<double>& charges, double* state) const;
  /// The rates of the circuits' charges at the last compute_forces.
  void set_circuit_rates(const LoadState& loads, double* f) const;
  /// Adds to the scalars the energy that a jump of the loads brings in at once.
  void pass_jump(double time, double* state);

  Structure& structure_;
  LoadHistory history_;
  const bool inertia_;
  const std::vector<unsigned int> circuits_; ///< electrodes
  double alpha_ = 0;
};

/// With inertia: u' = v, M v' = forces, A' = rates.
class InertialSystem : public StructureSystem
{
public:
  explicit InertialSystem(Structure& structure);
  void evaluate(double time, const double* state, double* f) override;
  void multiply_mass(const double* x, double* result) override;
  void solve_mass(const double* b, double* x) override;
  void prepare(double time, const double* state, double alpha) override;
  void solve(const double* r, double* d) override;
  void pass_stop_time(double time, double* state) override;

private:
  std::vector<double> compute_drag(const LoadState& loads, const double* v);
  void pass_kink_of_supports(const LoadState& before, const LoadState& after,
                             double* state);
};

/// Without inertia: forces = 0, A' = rates.
class QuasiStaticSystem : public StructureSystem
{
public:
  QuasiStaticSystem(Structure& structure, const time::PathOptions& options);
  void evaluate(double time, const double* state, double* f) override;
  void multiply_mass(const double* x, double* result) override;
  void solve_mass(const double* b, double* x) override;
  void prepare(double time, const double* state, double alpha) override;
  void solve(const double* r, double* d) override;
  void pass_stop_time(double time, double* state) override;

private:
  time::PathOptions options_;
};
} // namespace taut::structure
