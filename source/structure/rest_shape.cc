#include <taut/base/exceptions.h>
#include <taut/structure/rest_shape.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace taut::structure
{
namespace
{
/// Equilibria along the way, from 0 to 1.
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
  void check_equilibrium(double /*way*/, const double* /*u*/) override
  {
    // The last tangent was taken one iteration before the equilibrium. A long
    // step lands on the branch that stays flat, beyond the threshold.
    if (structure_.count_negative_eigenvalues() > 0)
      throw StepRejected("the shape is unstable");
  }
  bool takes_full_steps() const override
  {
    return equilibrium_.takes_full_steps();
  }

private:
  void enter(const double way)
  {
    // The load comes, the frames soften, the load goes.
    const double stiffening =
        std::pow(first_stiffness_, std::max(0., 1 - 2 * way));
    auto load = load_;
    for (double& component : load)
      component *= stiffening * std::min({6 * way, 1., 2 * (1 - way)});
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
  const double first_stiffness_;
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
  std::vector<double> bent(u, u + equilibrium.n_unknowns());
  const auto flat =
      time::find_equilibrium(equilibrium, time, u, options.newton);
  shape.flat_negative_eigenvalues = count_negative();
  shape.statistics.factorisations += flat.factorisations;
  std::copy(bent.begin(), bent.end(), u);
  {
    RestPath path(structure, equilibrium, time, options);
    time::PathOptions steps;
    steps.newton = options.newton;
    // Newton either converges soon or not at all; a shorter step is cheaper.
    steps.newton.max_iterations = 12;
    steps.newton.max_step = 0.4 * compute_extent(structure.mesh());
    steps.first_step = 1. / options.steps;
    steps.largest_step = 2. / options.steps;
    steps.smallest_step = 1e-4;
    const auto first = time::find_equilibrium(path, 0, u, steps.newton);
    const auto rest =
        time::follow_path(path, 0, 1, u, steps, [](double, const double*) {});
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
