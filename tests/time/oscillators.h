#pragma once

#include <taut/time/system.h>

#include <array>
#include <functional>
#include <vector>

/// Independent oscillators, each with one viscous network, as a time::System
/// whose exact solution is known:
///   u' = v,  m v' = m p(t) - k u - kv (u - a) - c v,  a' = (u - a)/tau.
/// Without inertia, 0 = m p(t) - k u - kv (u - a). One scalar integrates the
/// dissipated power, sum kv (u - a)^2/tau + c v^2. The members are dealt out to
/// the ranks in blocks.
struct Oscillator
{
  double mass = 1;
  double stiffness = 1;
  double viscous_stiffness = 0;
  double relaxation_time = 1;
  double drag = 0;
  /// u, v and a at the start.
  std::array<double, 3> start = {{1, 0, 1}};
};

class Oscillators : public taut::time::System
{
public:
  enum class Kind
  {
    inertial,
    quasi_static
  };

  Oscillators(const std::vector<Oscillator>& members, Kind kind,
              MPI_Comm communicator = MPI_COMM_SELF);

  /// The specific load p(t) from one jump to the next: one more piece than
  /// there are jumps.
  void set_load(std::vector<std::function<double(double)>> pieces,
                std::vector<double> jumps);
  /// The piece of the load that applies now.
  std::size_t piece = 0;
  /// Called at the end of every evaluation, to fail where a test wants it.
  std::function<void(double time)> after_evaluate;
  /// Whether `solve` leads astray, so that Newton cannot converge.
  bool has_wrong_tangent = false;

  std::vector<double> make_start() const;
  /// Exact u, v, a of a member of this rank without load.
  std::array<double, 3> get_exact(std::size_t member, double time) const;
  /// Kinetic and stored energy of all members.
  double compute_energy(const double* state) const;
  double sum(double value) const;
  std::size_t n_members() const
  {
    return members_.size();
  }

  MPI_Comm communicator() const override
  {
    return communicator_;
  }
  taut::time::StateLayout layout() const override;
  void evaluate(double time, const double* state, double* f) override;
  void multiply_mass(const double* x, double* result) override;
  void solve_mass(const double* b, double* x) override;
  void prepare(double time, const double* state, double alpha) override;
  void solve(const double* r, double* d) override;
  void pass_stop_time(double time, double* state) override;
  std::vector<double> stop_times(double start, double end) const override;

private:
  bool is_inertial() const
  {
    return kind_ == Kind::inertial;
  }

  std::vector<Oscillator> members_;
  Kind kind_;
  MPI_Comm communicator_;
  int rank_ = 0;
  std::vector<std::function<double(double)>> pieces_;
  std::vector<double> jumps_;
  double alpha_ = 0;
};

/// exp(matrix) by scaling and squaring, exact to round-off.
using Matrix3 = std::array<std::array<double, 3>, 3>;
Matrix3 compute_exponential(Matrix3 matrix);
