#include <taut/base/exceptions.h>
#include <taut/structure/rest_shape.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace taut::structure
{
namespace
{
/// The way, from 0 to 1: until `loaded` the load comes, until `soft` the frames
/// soften, then the load goes.
constexpr double loaded = 1. / 6;
constexpr double soft = 2. / 3;

/// The equilibrium at `load` next to the mesh. Where the film would wrinkle,
/// Newton's method goes round in circles from afar. In the flat state its
/// compression is small, so that the film that carries it is a good start.
/// Errors: as time::find_equilibrium.
time::EquilibriumStatistics
find_flat(Structure& structure, time::EquilibriumProblem& equilibrium,
          const double load, const time::EquilibriumOptions& options, double* u)
{
  structure.set_compression(true);
  time::EquilibriumStatistics first;
  try
  {
    first = time::find_equilibrium(equilibrium, load, u, options);
  }
  catch (...)
  {
    structure.set_compression(false);
    throw;
  }
  structure.set_compression(false);
  const auto second = time::find_equilibrium(equilibrium, load, u, options);
  return {first.iterations + second.iterations,
          first.residuals + second.residuals,
          first.factorisations + second.factorisations, second.final_residual};
}

/// Whether no node is further than a fifth of the device from its place in the
/// mesh: free edges draw in by less, a frame that has curled goes further.
bool is_near(const Structure& structure, const double* u)
{
  double largest = 0;
  for (std::size_t i = 0; i < structure.n_free(); ++i)
    largest = std::max(largest, std::abs(u[i]));
  return dealii::Utilities::MPI::max(largest, structure.communicator()) <
         compute_extent(structure.mesh()) / 5;
}

/// The device with dead forces at all its unknowns that balance it in the mesh
/// (load 0) and are taken away (load 1): a way on which Newton's method is
/// never far from an equilibrium.
class ReleasePath : public time::EquilibriumProblem
{
public:
  /// `way`: the load at which `device` is released from `u`.
  ReleasePath(time::EquilibriumProblem& device, const double way,
              const double* u)
      : device_(device), way_(way), held_(device.n_unknowns())
  {
    device_.compute_residual(way_, u, held_.data());
  }
  MPI_Comm communicator() const override
  {
    return device_.communicator();
  }
  std::size_t n_unknowns() const override
  {
    return device_.n_unknowns();
  }
  void compute_residual(const double load, const double* u,
                        double* residual) override
  {
    device_.compute_residual(way_, u, residual);
    for (std::size_t i = 0; i < held_.size(); ++i)
      residual[i] -= (1 - load) * held_[i];
  }
  void prepare(const double, const double* u) override
  {
    device_.prepare(way_, u);
  }
  void solve(const double* r, double* d) override
  {
    device_.solve(r, d);
  }
  double reference_force() const override
  {
    return device_.reference_force();
  }
  double round_off_force() const override
  {
    return device_.round_off_force();
  }
  void check_equilibrium(const double load, const double* u) override
  {
    if (load == 1)
      device_.check_equilibrium(way_, u);
  }
  bool takes_full_steps() const override
  {
    return device_.takes_full_steps();
  }
  void forget_iteration() override
  {
    device_.forget_iteration();
  }

private:
  time::EquilibriumProblem& device_;
  const double way_;
  std::vector<double> held_;
};

/// Releases `device` from `u` in steps. Errors: as time::follow_path.
time::EquilibriumStatistics release(time::EquilibriumProblem& device,
                                    const double way,
                                    const time::EquilibriumOptions& options,
                                    double* u)
{
  ReleasePath path(device, way, u);
  time::PathOptions steps;
  steps.newton = options;
  steps.first_step = 0.1;
  steps.smallest_step = 1e-3;
  return time::follow_path(path, 0, 1, u, steps, [](double, const double*) {});
}

/// Equilibria along the way.
class RestPath : public time::EquilibriumProblem
{
public:
  RestPath(Structure& structure, Equilibrium& equilibrium, const double time,
           const RestPathOptions& options)
      : structure_(structure), equilibrium_(equilibrium), time_(time),
        first_stiffness_(options.first_stiffness), load_(options.direction)
  {
    const double size = std::hypot(load_[0], load_[1], load_[2]);
    for (double& component : load_)
      component *= options.perturbation * compute_load() / size;
  }
  ~RestPath() override
  {
    structure_.set_rest_path(1, {});
  }
  RestPath(const RestPath&) = delete;
  RestPath& operator=(const RestPath&) = delete;

  MPI_Comm communicator() const override
  {
    return equilibrium_.communicator();
  }
  std::size_t n_unknowns() const override
  {
    return equilibrium_.n_unknowns();
  }
  void compute_residual(const double way, const double* u,
                        double* residual) override
  {
    enter(way);
    equilibrium_.compute_residual(time_, u, residual);
  }
  void prepare(const double way, const double* u) override
  {
    enter(way);
    ++factorisations_;
    equilibrium_.prepare(time_, u);
  }
  /// Those of rejected steps, too.
  unsigned int n_factorisations() const
  {
    return factorisations_;
  }
  void solve(const double* r, double* d) override
  {
    equilibrium_.solve(r, d);
  }
  double reference_force() const override
  {
    return equilibrium_.reference_force();
  }
  double round_off_force() const override
  {
    return equilibrium_.round_off_force();
  }
  void check_equilibrium(const double way, const double* u) override
  {
    // A long step may land on the branch that stays flat, beyond the threshold.
    // The last tangent was taken one iteration before the equilibrium; only if
    // it raises a doubt another one is worth its price.
    if (structure_.count_negative_eigenvalues() == 0)
      return;
    prepare(way, u);
    if (structure_.count_negative_eigenvalues() > 0)
      throw StepRejected("the shape is unstable: the frames bend or twist to "
                         "another side, too; give Direction in Rest shape a "
                         "component to that side");
  }
  bool takes_full_steps() const override
  {
    return equilibrium_.takes_full_steps();
  }
  void forget_iteration() override
  {
    equilibrium_.forget_iteration();
  }
  /// Starts the way with frames so stiff that the flat state, near `u`, is
  /// stable there. Errors: StepRejected if no stiffness makes it so.
  time::EquilibriumStatistics start(const time::EquilibriumOptions& options,
                                    double* u)
  {
    constexpr double factor = 4, limit = 1e4;
    const std::vector<double> meshed(u, u + n_unknowns());
    while (true)
      try
      {
        return start_once(options, u);
      }
      catch (const StepRejected&)
      {
        std::copy(meshed.begin(), meshed.end(), u);
        if (first_stiffness_ > limit)
          throw;
        first_stiffness_ *= factor;
      }
  }

private:
  time::EquilibriumStatistics
  start_once(const time::EquilibriumOptions& options, double* u)
  {
    const std::vector<double> meshed(u, u + n_unknowns());
    try
    {
      return find_flat(structure_, *this, 0, options, u);
    }
    catch (const StepRejected&)
    {
      std::copy(meshed.begin(), meshed.end(), u);
    }
    try
    {
      return release(*this, 0, options, u);
    }
    catch (const SolverFailed& failure)
    {
      throw StepRejected(failure.what());
    }
  }

  void enter(const double way)
  {
    const double stiffening =
        std::pow(first_stiffness_,
                 std::clamp(1 - (way - loaded) / (soft - loaded), 0., 1.));
    const double share = std::min(way / loaded, (1 - way) / (1 - soft));
    auto load = load_;
    for (double& component : load)
      component *= stiffening * std::clamp(share, 0., 1.);
    structure_.set_rest_path(stiffening, load);
  }

  /// 8 EI/L^3 (N/m) of the most flexible frame.
  double compute_load() const
  {
    double stiffness = std::numeric_limits<double>::infinity();
    for (const auto& frame : structure_.device().frames)
      stiffness = std::min({stiffness, frame.section.bending_stiffness[0],
                            frame.section.bending_stiffness[1]});
    return 8 * stiffness / std::pow(compute_extent(structure_.mesh()), 3);
  }

  Structure& structure_;
  Equilibrium& equilibrium_;
  const double time_;
  double first_stiffness_;
  std::array<double, 3> load_;
  unsigned int factorisations_ = 0;
};
} // namespace

RestShape find_rest_shape(Structure& structure, LoadHistory& history,
                          const Networks networks, const double* internal,
                          const double time, const RestPathOptions& options,
                          double* u)
{
  if (structure.frames().empty())
    throw BadInput("a rest shape is looked for, but the device has no frame");
  Equilibrium equilibrium(structure, history, networks, internal);
  RestShape shape;
  const auto count_negative = [&]
  {
    equilibrium.prepare(time, u);
    ++shape.statistics.factorisations;
    return structure.count_negative_eigenvalues();
  };
  const auto flat = [&]
  {
    const std::vector<double> meshed(u, u + structure.n_free());
    try
    {
      const auto statistics =
          find_flat(structure, equilibrium, time, options.newton, u);
      if (is_near(structure, u))
      {
        shape.flat_negative_eigenvalues = count_negative();
        return statistics;
      }
    }
    catch (const StepRejected&)
    {
    }
    // A film on the face of its frame may leave no equilibrium near the flat
    // state; the way begins with frames that are stiff enough for one.
    std::copy(meshed.begin(), meshed.end(), u);
    equilibrium.forget_iteration();
    return time::EquilibriumStatistics();
  }();
  shape.statistics.factorisations += flat.factorisations;
  {
    RestPath path(structure, equilibrium, time, options);
    time::PathOptions steps;
    steps.newton = options.newton;
    // Newton either converges soon or not at all; a shorter step is cheaper.
    steps.newton.max_iterations = 12;
    steps.newton.max_step = 0.4 * compute_extent(structure.mesh());
    steps.first_step = 1. / options.steps;
    steps.largest_step = 1. / options.steps;
    steps.smallest_step = 1e-4;
    const auto first = path.start(steps.newton, u);
    time::EquilibriumStatistics rest;
    double begin = 0;
    for (const double end : {loaded, soft, 1.})
    {
      const auto part = time::follow_path(path, begin, end, u, steps,
                                          [](double, const double*) {});
      rest.iterations += part.iterations;
      rest.residuals += part.residuals;
      rest.final_residual = part.final_residual;
      begin = end;
    }
    shape.statistics.iterations =
        flat.iterations + first.iterations + rest.iterations;
    shape.statistics.residuals =
        flat.residuals + first.residuals + rest.residuals;
    shape.statistics.factorisations += path.n_factorisations();
    shape.statistics.final_residual = rest.final_residual;
  }
  shape.negative_eigenvalues = count_negative();
  return shape;
}
} // namespace taut::structure
