#include "oscillators.h"

#include <algorithm>
#include <cmath>

namespace
{
bool is_mpi_running()
{
  int initialized = 0;
  MPI_Initialized(&initialized);
  return initialized != 0;
}

Matrix3 multiply(const Matrix3& a, const Matrix3& b)
{
  Matrix3 product = {};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        product[i][j] += a[i][k] * b[k][j];
  return product;
}
} // namespace

Matrix3 compute_exponential(Matrix3 matrix)
{
  double norm = 0;
  for (const auto& row : matrix)
    for (const double entry : row)
      norm = std::max(norm, std::abs(entry));
  int squarings = 0;
  for (; norm > 0.1; norm /= 2)
    ++squarings;
  Matrix3 sum = {}, term = {};
  for (int i = 0; i < 3; ++i)
    sum[i][i] = term[i][i] = 1;
  for (int n = 1; n < 16; ++n)
  {
    term = multiply(term, matrix);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        sum[i][j] += term[i][j] *= std::pow(0.5, squarings) / n;
  }
  for (int i = 0; i < squarings; ++i)
    sum = multiply(sum, sum);
  return sum;
}

Oscillators::Oscillators(const std::vector<Oscillator>& members,
                         const Kind kind, const MPI_Comm communicator)
    : kind_(kind), communicator_(communicator),
      pieces_({[](double) { return 0.; }})
{
  int n_ranks = 1;
  if (is_mpi_running())
  {
    MPI_Comm_rank(communicator, &rank_);
    MPI_Comm_size(communicator, &n_ranks);
  }
  const std::size_t n = members.size();
  members_.assign(members.begin() + n * rank_ / n_ranks,
                  members.begin() + n * (rank_ + 1) / n_ranks);
}

void Oscillators::set_load(std::vector<std::function<double(double)>> pieces,
                           std::vector<double> jumps)
{
  pieces_ = std::move(pieces);
  jumps_ = std::move(jumps);
}

std::vector<double> Oscillators::make_start() const
{
  const std::size_t n = members_.size();
  std::vector<double> state(layout().size(), 0.);
  for (std::size_t i = 0; i < n; ++i)
  {
    state[i] = members_[i].start[0];
    if (is_inertial())
      state[n + i] = members_[i].start[1];
    state[(is_inertial() ? 2 : 1) * n + i] = members_[i].start[2];
  }
  return state;
}

std::array<double, 3> Oscillators::get_exact(const std::size_t member,
                                             const double time) const
{
  const Oscillator& o = members_[member];
  const double rate = 1 / o.relaxation_time;
  Matrix3 matrix = {{{0, 1, 0},
                     {-(o.stiffness + o.viscous_stiffness) / o.mass,
                      -o.drag / o.mass, o.viscous_stiffness / o.mass},
                     {rate, 0, -rate}}};
  for (auto& row : matrix)
    for (double& entry : row)
      entry *= time;
  const Matrix3 flow = compute_exponential(matrix);
  std::array<double, 3> exact = {};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      exact[i] += flow[i][j] * o.start[j];
  return exact;
}

double Oscillators::sum(double value) const
{
  if (is_mpi_running())
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, communicator_);
  return value;
}

double Oscillators::compute_energy(const double* state) const
{
  const std::size_t n = members_.size();
  double energy = 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Oscillator& o = members_[i];
    const double u = state[i], v = state[n + i], a = state[2 * n + i];
    energy += (o.mass * v * v + o.stiffness * u * u +
               o.viscous_stiffness * (u - a) * (u - a)) /
              2;
  }
  return sum(energy);
}

taut::time::StateLayout Oscillators::layout() const
{
  const std::size_t n = members_.size();
  return {n, is_inertial() ? n : 0, n, 0, rank_ == 0 ? std::size_t(1) : 0};
}

void Oscillators::evaluate(const double time, const double* state, double* f)
{
  const std::size_t n = members_.size();
  const std::size_t force = is_inertial() ? n : 0;
  const double load = pieces_[piece](time);
  double power = 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Oscillator& o = members_[i];
    const double u = state[i];
    const double v = is_inertial() ? state[n + i] : 0;
    const double stretch = u - state[force + n + i];
    if (is_inertial())
      f[i] = v;
    f[force + i] = o.mass * load - o.stiffness * u -
                   o.viscous_stiffness * stretch - o.drag * v;
    f[force + n + i] = stretch / o.relaxation_time;
    power += o.viscous_stiffness * stretch * stretch / o.relaxation_time +
             o.drag * v * v;
  }
  power = sum(power);
  if (rank_ == 0)
    f[force + 2 * n] = power;
  if (after_evaluate)
    after_evaluate(time);
}

void Oscillators::multiply_mass(const double* x, double* result)
{
  const std::size_t n = members_.size();
  std::copy_n(x, layout().size(), result);
  for (std::size_t i = 0; i < n; ++i)
    if (is_inertial())
      result[n + i] = members_[i].mass * x[n + i];
    else
      result[i] = 0;
}

void Oscillators::solve_mass(const double* b, double* x)
{
  const std::size_t n = members_.size();
  std::copy_n(b, layout().size(), x);
  for (std::size_t i = 0; i < n; ++i)
    x[n + i] = b[n + i] / members_[i].mass;
}

void Oscillators::prepare(double /*time*/, const double* /*state*/,
                          const double alpha)
{
  alpha_ = alpha;
}

void Oscillators::solve(const double* r, double* d)
{
  const std::size_t n = members_.size();
  const std::size_t force = is_inertial() ? n : 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Oscillator& o = members_[i];
    const double decay = alpha_ + 1 / o.relaxation_time;
    const double inertia = is_inertial() ? alpha_ * o.mass + o.drag : 0;
    const double r_position = is_inertial() ? r[i] : 0;
    const double r_internal = r[force + n + i];
    const double tangent = o.stiffness + o.viscous_stiffness +
                           alpha_ * inertia -
                           o.viscous_stiffness / (o.relaxation_time * decay);
    double du = (r[force + i] + inertia * r_position +
                 o.viscous_stiffness * r_internal / decay) /
                tangent;
    if (has_wrong_tangent)
      du += 1e-3;
    d[i] = du;
    if (is_inertial())
      d[n + i] = alpha_ * du - r_position;
    d[force + n + i] = (r_internal + du / o.relaxation_time) / decay;
  }
  if (rank_ == 0)
    d[force + 2 * n] = r[force + 2 * n] / alpha_;
}

void Oscillators::pass_stop_time(const double time, double* state)
{
  ++piece;
  if (is_inertial())
    return;
  const std::size_t n = members_.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const Oscillator& o = members_[i];
    state[i] =
        (o.mass * pieces_[piece](time) + o.viscous_stiffness * state[n + i]) /
        (o.stiffness + o.viscous_stiffness);
  }
}

std::vector<double> Oscillators::stop_times(const double start,
                                            const double end) const
{
  std::vector<double> times;
  for (const double time : jumps_)
    if (time > start && time < end)
      times.push_back(time);
  return times;
}
