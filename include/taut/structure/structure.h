#pragma once

#include <taut/fe/film_assembly.h>
#include <taut/fe/linear_solver.h>
#include <taut/structure/device_nodes.h>
#include <taut/structure/frames.h>
#include <taut/structure/loads.h>
#include <taut/structure/point_forces.h>
#include <taut/structure/rotary_inertia.h>
#include <taut/structure/sources.h>

#include <memory>
#include <vector>

namespace taut::structure
{
/// How the internal variables enter a static question.
enum class Networks
{
  as_given, ///< the given values count
  relaxed   ///< every network is stress-free: A = C^{-1}
};

/// Sums over all ranks that a change of state in time produces.
struct Powers
{
  double dissipation = 0; ///< in the networks (W)
  double drag = 0;        ///< lost to the air (W)
  double resistance = 0;  ///< lost in resistors of circuits (W)
  /// Of sources (- Q dV/dt, V dQ/dt or V_s i_s), dead loads (- dF/dt . u),
  /// pressures, moving supports and temperatures (dT/dt dPsi/dT) (W); see
  /// Energies::total.
  double work = 0;
};

struct Energies
{
  double kinetic = 0;  ///< (J)
  double stored = 0;   ///< springs and networks (J)
  double frames = 0;   ///< bending, stretching, twisting of frames (J)
  double electric = 0; ///< (1/2) Q V (J)
  /// - Q V of the electrodes whose voltage is prescribed (J)
  double sources = 0;
  /// - F . u, in quasi-static problems also - p (volume) (J)
  double dead_loads = 0;
  /// rho c_0 ((T - T_0) - T ln(T/T_0)) of the films: a function of the
  /// temperature alone, which the mechanical balance leaves out (J).
  double thermal = 0;
  /// What the balance follows.
  double total() const
  {
    return kinetic + stored + frames + electric + sources + dead_loads;
  }
};

/// A device on its mesh: all forces, masses and tangents of its free unknowns.
///
/// The free unknowns u are displacements (m) of the free components of this
/// rank's nodes, bars included; `internal` are the internal variables of its
/// cells. All methods are collective unless they say otherwise.
class Structure
{
public:
  /// `triangulation` holds `mesh`, refined as wanted, and outlives this.
  /// Errors: BadInput as in make_device_nodes, and for cells without a film,
  /// groups used by two films, electrodes or loads on nothing.
  Structure(const Device& device, const fe::MeshData& mesh,
            const fe::Triangulation& triangulation);
  ~Structure();

  const Device& device() const
  {
    return device_;
  }
  const fe::MeshData& mesh() const
  {
    return mesh_;
  }
  const dealii::DoFHandler<2, 3>& dof_handler() const
  {
    return dof_handler_;
  }
  const fe::Nodes& nodes() const
  {
    return device_nodes_.nodes;
  }
  const DeviceNodes& device_nodes() const
  {
    return device_nodes_;
  }
  const fe::FilmCells& cells() const
  {
    return *cells_;
  }
  const Frames& frames() const
  {
    return *frames_;
  }
  MPI_Comm communicator() const;

  std::size_t n_free() const
  {
    return free_.size();
  }
  std::size_t n_internal() const
  {
    return cells_->n_internal();
  }
  /// Index of each free unknown among the owned entries, 3 node + component.
  const std::vector<unsigned int>& free_unknowns() const
  {
    return free_;
  }
  /// Over all ranks.
  std::size_t n_free_global() const;
  /// Positions (m) of all local nodes for displacements u under `loads`.
  const fe::NodalVector& compute_positions(const LoadState& loads,
                                           const double* u);
  /// Velocities (m/s) of all local nodes at the last compute_positions.
  fe::NodalVector compute_velocities(const LoadState& loads, const double* v);
  /// One law per slot of the cells, at the temperatures and humidities of the
  /// loads. With `time_step` (s) moduli and permittivities have gone on by it
  /// along their tangents. Errors: StepRejected outside the range of a law of
  /// temperature or humidity, with the film.
  std::vector<fe::BatchLaw> make_laws(const LoadState& loads, Networks networks,
                                      double time_step = 0) const;

  /// The loads with the voltages of all electrodes whose charges are given, as
  /// all that follows needs them. The networks are given, as the charge of a
  /// wrinkled film depends on them. Errors: StepRejected if no voltage gives a
  /// charge.
  LoadState resolve_voltages(LoadState loads, const double* u,
                             const double* internal, Networks networks);
  /// By electrode, of the film in the mesh at the dimensionless field
  /// (V/H) sqrt(eps/G) = 1 (C).
  const std::vector<double>& charge_scales() const
  {
    return charge_scales_;
  }

  /// forces = external minus internal forces on the free unknowns (N) and, if
  /// `rates` is given, the rates of the internal variables.
  /// Errors: StepRejected, with film, place, value and limit, if a law is
  /// beyond its limit.
  void compute_forces(const LoadState& loads, const double* u,
                      const double* internal, Networks networks, double* forces,
                      double* rates);
  /// Powers at the last compute_forces, without drag. `velocities` are null in
  /// quasi-static problems.
  Powers compute_powers(const LoadState& loads,
                        const fe::NodalVector* velocities) const;
  /// Norm of the nodal internal forces before they cancelled (N), but not less
  /// than those of a stress of 1e-3 shear moduli: where springs and voltage
  /// cancel within the film, their round-off stays.
  double internal_force_norm() const
  {
    return internal_force_norm_;
  }
  /// Round-off of axial forces in frames, whose strain is a small difference of
  /// positions (N).
  double round_off_force() const
  {
    return round_off_force_ * frames_->stiffening();
  }
  /// Capacitance (F) and charge (C) of every electrode at the last
  /// compute_forces.
  std::vector<double> compute_capacitances() const;
  std::vector<double> compute_charges(const LoadState& loads) const;
  /// Residual force that a support carries, external minus internal, at the
  /// last compute_forces: its reaction without inertia (N).
  std::array<double, 3> compute_reaction(unsigned int support) const;

  /// (1/3) int x . n dA over surface groups at the last positions (m^3): the
  /// enclosed volume if they close, or would with surfaces whose planes pass
  /// through the origin.
  double compute_volume(const std::vector<std::string>& groups) const;

  Energies compute_energies(const LoadState& loads, const double* u,
                            const double* v, const double* internal);

  /// Assembles and factorises the tangent (see fe::TangentRequest), of which
  /// given charges are a part (see SourceBorder).
  void factorise(const LoadState& loads, const double* u,
                 const double* internal, Networks networks, double alpha,
                 bool inertia, fe::LinearSolver::Kind kind);
  /// d = tangent^{-1} r on the free unknowns. Not a copy: may be one array.
  void solve(const double* r, double* d);
  /// The same for a motion with circuits: takes the residuals of the rates of
  /// their charges (A), by electrode, to changes of the charges (C).
  void solve(const double* r, double* d, std::vector<double>& circuits);
  /// Negative eigenvalues of the last factorised tangent, of its symmetric part
  /// where it has none itself.
  int count_negative_eigenvalues();
  /// result = tangent x, without a factorisation.
  void multiply_tangent(const LoadState& loads, const double* u,
                        const double* internal, Networks networks, double alpha,
                        bool inertia, bool symmetric, const double* x,
                        double* result);

  /// Films carry compression while `carries`, whatever the description says.
  void set_compression(const bool carries)
  {
    carries_compression_ = carries;
  }
  /// The next tangent of the frames takes the resultants of its own state; see
  /// Frames::add_stiffness.
  void forget_linearisation();
  /// Sets a point on the way to a rest shape: all stiffnesses of frames times
  /// `stiffening`, and a dead load (N/m) along all frames. 1 and 0 at first.
  void set_rest_path(double stiffening, const std::array<double, 3>& load);
  /// The quaternions in u brought to their length in the mesh, which changes
  /// no state.
  void normalise_rotations(double* u) const;

  /// What dampers of frames resist the velocities v with (N), at the last
  /// compute_forces, and the power lost (W, this rank's share).
  struct Damping
  {
    std::vector<double> forces;
    double power;
  };
  Damping compute_frame_damping(const LoadState& loads, const double* v);
  /// The same, linear in `rates`, at the state of the last factorise.
  void add_frame_damping_product(const double* rates, double* result);
  /// Replaces the forces on quaternions by what their accelerations would need
  /// if the mass matrix held (see RotaryInertia), at the last compute_forces.
  void turn_forces_into_accelerations(const double* v, double* forces) const;
  /// Undoes this for a residual.
  void turn_accelerations_into_forces(double* residual) const;
  /// Turns vectors at the nodes of frames from their orientation at the last
  /// factorise to that of the last compute_forces, or back. The factors of a
  /// tangent serve longer for vectors turned like this: beams are stiff along
  /// their axes, wherever these point.
  void turn_with_frames(bool forward, double* vector) const;
  bool has_frame_damping() const;
  bool has_follower_forces() const
  {
    return point_forces_->follow();
  }

  /// forces += change of the forces for (alpha - dA'/dA)^{-1} r at the state of
  /// the last factorise; internal change likewise.
  void add_force_change(double alpha, const double* r, double* forces);
  void compute_internal_change(double alpha, const double* du, const double* r,
                               double* change);

  /// result = M x, D x, M^{-1} b on the free unknowns. The matrices are made at
  /// the first call.
  void multiply_mass(const double* x, double* result);
  void multiply_drag(const double* x, double* result);
  void solve_mass(const double* b, double* x);
  /// True if air or the mass damping of frames resists velocities.
  bool has_drag() const;
  /// M a on the free unknowns for the accelerations of moving supports, given
  /// by the second rates of their amplitudes (or M v by their rates).
  std::vector<double>
  compute_support_inertia(const std::vector<double>& rates) const;
  /// D v on the free unknowns for the velocities of moving supports (N), given
  /// by the rates of their amplitudes.
  std::vector<double>
  compute_support_drag(const std::vector<double>& rates) const;

  /// Free unknowns of a nodal vector and back (local, no ghosts).
  void restrict(const fe::NodalVector& nodal, double* free) const;
  void prolong(const double* free, fe::NodalVector& nodal) const;

private:
  /// Assembles the same parts into matrices of its own.
  friend class Vibration;
  void set_pre_stretches(const LoadState& loads);
  void make_cells();
  void make_source_scales();
  void add_source_powers(const LoadState& loads, Powers& powers) const;
  void make_border(const LoadState& loads, Networks networks, double alpha);
  SourceBorder::Column make_column(unsigned int electrode,
                                   const LoadState& loads, Networks networks);
  std::optional<double> compute_capacitance(unsigned int electrode,
                                            const LoadState& loads,
                                            const double* internal,
                                            Networks networks) const;
  fe::PressureLoad make_pressure(const std::vector<std::string>& groups) const;
  void add_weight(const std::array<double, 3>& gravity,
                  fe::NodalVector& weight) const;
  double compute_least_force() const;
  void set_dead_forces(const LoadState& loads);
  bool has_turning_nodes() const
  {
    return !nodes().bars.empty() || !nodes().followers.empty();
  }
  fe::NodalVector make_edge_load(const EdgeLoad& load) const;
  std::vector<double> get_densities() const;
  std::vector<double>
  compute_support_product(const std::vector<double>& densities, bool damping,
                          const std::vector<double>& rates) const;
  double get_displacement(std::size_t entry) const;
  double compute_heat_power(const LoadState& loads,
                            const double* internal) const;
  double compute_thermal_energy(const LoadState& loads) const;
  void make_frames();
  void add_lumped_film_inertia();
  void add_frame_weight(const fe::NodalVector& gravity,
                        fe::NodalVector& weight) const;
  double compute_round_off_force() const;
  void add_frame_masses(bool damping, fe::TangentMatrix& matrix) const;
  void add_point_masses(double factor, fe::TangentMatrix& matrix) const;
  void add_bar_masses(fe::TangentMatrix& matrix) const;
  void add_frame_tangent(const fe::TangentRequest& request);
  void add_follower_tangent(fe::TangentMatrix& matrix) const;
  double compute_rotary_energy(const double* v) const;
  std::vector<std::vector<fe::LocalNode>> get_frame_elements() const;
  std::array<bool, 4> get_free_parts(const fe::Rotation& rotation) const;
  Quaternion get_free_quaternion(const fe::Rotation& rotation,
                                 const double* free) const;
  void set_free_quaternion(const fe::Rotation& rotation, const Quaternion& q,
                           double* free) const;
  /// Calls function(rotation, its inertia) for the rotations this rank owns.
  template <typename Function>
  void for_each_rotation(const Function& function) const
  {
    for (std::size_t i = 0; i < nodes().rotations.size(); ++i)
      if (nodes().rotations[i].vector < nodes().n_owned)
        function(nodes().rotations[i], rotary_[i]);
  }
  void add_bar_forces(fe::NodalVector& forces) const;
  void add_bar_tangent(const fe::TangentRequest& request,
                       fe::TangentMatrix& matrix) const;
  void set_tangent_state(const LoadState& loads, const double* u,
                         const double* internal, Networks networks);
  void solve_with(fe::LinearSolver& solver, const double* r, double* d) const;
  void multiply_with(_p_Mat* matrix, const double* x, double* result) const;
  void assemble(const fe::TangentRequest& request);
  void make_mass();
  double sum(double local) const;

  const Device device_;
  const fe::MeshData& mesh_;
  dealii::DoFHandler<2, 3> dof_handler_;
  DeviceNodes device_nodes_;
  std::vector<material::Elastomer> relaxed_;
  std::unique_ptr<fe::FilmCells> cells_;
  std::vector<unsigned int> free_;
  /// Index among the free unknowns by owned entry, or -1.
  std::vector<int> free_index_;
  std::unique_ptr<Frames> frames_;
  std::unique_ptr<PointForces> point_forces_;
  std::vector<LoadedNode> masses_;
  std::vector<RotaryInertia> rotary_;
  /// Stiffness (N/m) that fixes the length of a quaternion in statics.
  std::vector<double> gauge_;
  std::array<double, 3> rest_load_{}; ///< (N/m)
  bool carries_compression_ = false;
  /// By electrode: the voltage (V) and charge (C) at the dimensionless field 1
  /// and the last voltage that was found for a given charge (V).
  std::vector<double> voltage_scales_, charge_scales_, last_voltages_;
  SourceBorder border_;
  std::vector<fe::PressureLoad> pressures_;
  fe::NodalVector weight_;             ///< (N)
  std::vector<fe::NodalVector> edges_; ///< per N/m of each edge load (m)

  /// The state of the last compute_positions / compute_forces.
  fe::NodalVector positions_, forces_, pressure_forces_, dead_forces_;
  fe::FilmPowers powers_;
  double heat_power_ = 0; ///< of the films on this rank (W)
  double internal_force_norm_ = 1;
  double least_force_ = 0; ///< (N)
  double round_off_force_ = 0;
  /// This rank's share of the forces on all local nodes, before collection;
  /// kept if there are bars or followers.
  std::vector<double> turned_forces_;

  /// The state at which the tangent was taken.
  fe::NodalVector tangent_positions_;
  std::vector<double> tangent_internal_;
  std::vector<fe::BatchLaw> tangent_laws_;
  LoadState tangent_loads_;
  std::unique_ptr<fe::TangentMatrix> tangent_;
  std::unique_ptr<fe::LinearSolver> solver_;
  fe::LinearSolver::Kind solver_kind_ = fe::LinearSolver::Kind::symmetric;
  std::unique_ptr<fe::TangentMatrix> mass_, drag_;
  std::unique_ptr<fe::LinearSolver> mass_solver_;
};
} // namespace taut::structure
