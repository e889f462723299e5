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
      throw StepRejected("the shape is unstable");
  }
  bool takes_full_steps() const override
  {
    return equilibrium_.takes_full_steps();
  }
  /// Starts the way with frames so stiff that the flat state, near `u`, is
  /// stable there. Errors: StepRejected if no stiffness makes it so.
  time::EquilibriumStatistics start(const time::EquilibriumOptions& options,
                                    double* u)
  {
    constexpr double factor = 4, limit = 1e4;
    while (true)
      try
      {
        return time::find_equilibrium(*this, 0, u, options);
      }
      catch (const StepRejected&)
      {
        if (first_stiffness_ > limit)
          throw;
        first_stiffness_ *= factor;
      }
  }

private:
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

/// Where the film would wrinkle, Newton's method goes round in circles from
/// afar. In the flat state its compression is small, so that the film that
/// carries it is a good start.
time::EquilibriumStatistics
find_flat(Structure& structure, Equilibrium& equilibrium, const double time,
          const time::EquilibriumOptions& options, double* u)
{
  structure.set_compression(true);
  time::EquilibriumStatistics first;
  try
  {
    first = time::find_equilibrium(equilibrium, time, u, options);
  }
  catch (...)
  {
    structure.set_compression(false);
    throw;
  }
  structure.set_compression(false);
  const auto second = time::find_equilibrium(equilibrium, time, u, options);
  return {first.iterations + second.iterations,
          first.residuals + second.residuals,
          first.factorisations + second.factorisations, second.final_residual};
}

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
  const auto flat = find_flat(structure, equilibrium, time, options.newton, u);
  shape.flat_negative_eigenvalues = count_negative();
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
