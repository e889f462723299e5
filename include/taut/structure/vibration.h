#pragma once

#include <taut/structure/structure.h>
#include <taut/time/vibration_modes.h>

#include <memory>
#include <string>
#include <vector>

namespace taut::structure
{
/// Something that gives way in time: the networks with one relaxation time, or
/// the charge in a circuit.
struct Relaxation
{
  std::string name; ///< "network 1", "circuit NAME"
  /// T_m of the networks (s); of a circuit its capacitance over its
  /// conductance.
  double time = 0;
};

class VibrationMatrices;

/// Small vibrations of a structure about a state.
///
/// M is the consistent mass at the positions of the state. The lengths of
/// quaternions and of the directors of bars, which have no meaning, have no
/// mass and so no modes; stiffnesses hold them. K is the symmetric part of the
/// tangent, with given charges as in Structure::factorise. Vectors are free
/// unknowns.
class Vibration : public time::VibrationProblem
{
public:
  /// Keeps the state; `structure` outlives this. The loads are resolved (see
  /// Structure::resolve_voltages). The tangent is at first frozen.
  Vibration(Structure& structure, const LoadState& loads, const double* u,
            const double* internal);
  ~Vibration() override;

  MPI_Comm communicator() const override;
  std::size_t n_unknowns() const override;
  void multiply_mass(const double* x, double* result) override;
  int factorise(double shift) override;
  void solve(const double* r, double* d) override;
  /// result = K x.
  void multiply_stiffness(const double* x, double* result) const;

  /// What relaxes: networks by film and number in it, equal times counting
  /// once, then circuits.
  const std::vector<Relaxation>& relaxations() const
  {
    return relaxations_;
  }
  bool is_circuit(const std::size_t relaxation) const
  {
    return relaxation >= n_times_;
  }
  /// K of what is fast: nothing relaxes.
  void freeze();
  /// K of what is slow: all follow at once.
  void relax();
  /// K of a motion exp(rate t), rate >= 0 (1/s), that only one relaxation
  /// answers. About a relaxed state it is K_frozen - K_r/(1 + rate T_r).
  void flow(std::size_t relaxation, double rate);
  /// Norm of the antisymmetric part of the last tangent over that of the whole.
  double asymmetry() const
  {
    return asymmetry_;
  }

  /// result = D x of air and frames (N for m/s).
  void multiply_damping(const double* x, double* result);
  bool has_damping() const;

  /// Force on the free unknowns (N) that a unit acceleration of the whole
  /// device along x, y or z takes, supports included.
  const std::vector<double>& get_unit_inertia(const unsigned int axis) const
  {
    return unit_inertia_[axis];
  }
  double total_mass() const
  {
    return total_mass_; ///< (kg)
  }
  /// Displacements of all local nodes, 3 node + component (unit of x).
  std::vector<double> compute_motion(const double* x) const;
  /// The largest of film and axes of frames, over all ranks.
  double compute_largest(const std::vector<double>& motion) const;
  /// x . y over all ranks.
  double multiply(const double* x, const double* y) const;

private:
  void make_mass();
  void make_unit_inertia();
  void find_relaxations();
  /// The laws with other relaxation times (s), by relaxation.
  std::vector<fe::BatchLaw>
  make_laws(const std::vector<double>& relaxation_times) const;
  void assemble(double rate, const std::vector<fe::BatchLaw>& laws,
                const std::vector<bool>& held);
  unsigned int find_relaxation(double time) const;

  Structure& structure_;
  const LoadState loads_;
  const std::vector<double> u_, internal_;
  std::vector<fe::BatchLaw> laws_;
  std::vector<Relaxation> relaxations_;
  std::size_t n_times_ = 0; ///< relaxations that are networks
  std::vector<SourceBorder::Column> columns_;
  std::unique_ptr<VibrationMatrices> matrices_;
  SourceBorder border_;
  std::array<std::vector<double>, 3> unit_inertia_;
  double total_mass_ = 0;
  double asymmetry_ = 0;
};
} // namespace taut::structure
