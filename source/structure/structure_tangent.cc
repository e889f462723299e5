#include <taut/base/exceptions.h>
#include <taut/structure/structure.h>

#include <cmath>

namespace taut::structure
{
std::vector<double> Structure::get_densities() const
{
  std::vector<double> densities;
  for (const auto& film : device_.films)
    densities.push_back(film.material.density);
  return densities;
}

void Structure::assemble(const fe::TangentRequest& request)
{
  if (!tangent_)
    tangent_ = std::make_unique<fe::TangentMatrix>(
        nodes(), *cells_, get_frame_elements(),
        fe::TangentMatrix::Coupling::full);
  tangent_->begin();
  fe::add_stiffness(*cells_, tangent_laws_, pressures_, request, *tangent_);
  add_bar_tangent(request, *tangent_);
  add_frame_tangent(request);
  add_follower_tangent(*tangent_);
  tangent_->end();
}

void Structure::add_bar_tangent(const fe::TangentRequest& request,
                                fe::TangentMatrix& matrix) const
{
  using Block = std::array<double, 9>;
  const auto director_of = [&](const fe::Bar& bar)
  {
    std::array<double, 3> d;
    for (unsigned int c = 0; c < 3; ++c)
      d[c] = fe::entry(positions_, 3 * bar.director + c);
    return d;
  };
  for (const auto& bar : nodes().bars)
  {
    if (bar.director >= nodes().n_owned)
      continue;
    const auto d = director_of(bar);
    const double square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    const double length_square = bar.half_length * bar.half_length;
    const double inertia = request.inertia ? request.alpha * request.alpha : 0.;
    Block centre{}, director{};
    for (unsigned int i = 0; i < 3; ++i)
    {
      centre[4 * i] = inertia * bar.mass;
      director[4 * i] =
          inertia * bar.rotary_inertia / length_square +
          0.5 * bar.length_stiffness * (square / length_square - 1);
      for (unsigned int j = 0; j < 3; ++j)
        director[3 * i + j] +=
            bar.length_stiffness * d[i] * d[j] / length_square;
    }
    matrix.add_block(bar.centre, bar.centre, centre.data());
    matrix.add_block(bar.director, bar.director, director.data());
  }
  // The turning of the forces f on the bar's nodes:
  // s l (f n^T + n f^T + (f . n)(1 - 3 n n^T))/|d|^2.
  for (const auto& on_bar : nodes().on_bar)
  {
    const fe::Bar& bar = nodes().bars[on_bar.bar];
    const auto d = director_of(bar);
    const double length = std::hypot(d[0], d[1], d[2]);
    std::array<double, 3> f, n;
    double f_n = 0;
    for (unsigned int c = 0; c < 3; ++c)
    {
      f[c] = turned_forces_[3 * on_bar.node + c];
      n[c] = d[c] / length;
      f_n += f[c] * n[c];
    }
    const double factor = on_bar.fraction * bar.half_length / (length * length);
    Block block;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        block[3 * i + j] = factor * (f[i] * n[j] + n[i] * f[j] +
                                     f_n * ((i == j) - 3 * n[i] * n[j]));
    matrix.add_block(bar.director, bar.director, block.data());
  }
}

void Structure::set_tangent_state(const LoadState& loads, const double* u,
                                  const double* internal,
                                  const Networks networks)
{
  // The forces on nodes of bars and on arms belong to the tangent.
  if (has_turning_nodes())
  {
    std::vector<double> unused(n_free());
    compute_forces(loads, u, internal, networks, unused.data(), nullptr);
  }
  else
    compute_positions(loads, u);
  for (unsigned int i = 0; i < pressures_.size(); ++i)
    pressures_[i].pressure = loads.pressures[i];
  tangent_positions_ = positions_;
  tangent_positions_.update_ghost_values();
  fe::distribute_positions(nodes(), tangent_positions_);
  tangent_internal_.assign(internal, internal + n_internal());
  tangent_laws_ = make_laws(loads, networks);
  tangent_loads_ = loads;
}

void Structure::factorise(const LoadState& loads, const double* u,
                          const double* internal, const Networks networks,
                          const double alpha, const bool inertia,
                          const fe::LinearSolver::Kind kind)
{
  set_tangent_state(loads, u, internal, networks);
  assemble({&tangent_positions_, tangent_internal_.data(), alpha, inertia,
            device_.environment.air_drag,
            kind != fe::LinearSolver::Kind::general});
  if (!solver_ || solver_kind_ != kind)
    solver_ = std::make_unique<fe::LinearSolver>(tangent_->get(), kind);
  solver_kind_ = kind;
  solver_->factorise();
  make_border(loads, networks, alpha);
  border_.eliminate([this](double* x) { solve_with(*solver_, x, x); });
}

void Structure::solve_with(fe::LinearSolver& solver, const double* r,
                           double* d) const
{
  // Prescribed and dependent rows of the matrix are those of the identity.
  std::vector<double> all(3 * nodes().n_owned, 0.);
  for (std::size_t i = 0; i < free_.size(); ++i)
    all[free_[i]] = r[i];
  solver.solve(all.data(), all.data());
  for (std::size_t i = 0; i < free_.size(); ++i)
    d[i] = all[free_[i]];
}

void Structure::multiply_with(_p_Mat* matrix, const double* x,
                              double* result) const
{
  std::vector<double> all(3 * nodes().n_owned, 0.), product(all.size());
  for (std::size_t i = 0; i < free_.size(); ++i)
    all[free_[i]] = x[i];
  fe::multiply(matrix, all.data(), product.data());
  for (std::size_t i = 0; i < free_.size(); ++i)
    result[i] = product[free_[i]];
}

void Structure::multiply_tangent(const LoadState& loads, const double* u,
                                 const double* internal,
                                 const Networks networks, const double alpha,
                                 const bool inertia, const bool symmetric,
                                 const double* x, double* result)
{
  set_tangent_state(loads, u, internal, networks);
  assemble({&tangent_positions_, tangent_internal_.data(), alpha, inertia,
            device_.environment.air_drag, symmetric});
  multiply_with(tangent_->get(), x, result);
  make_border(loads, networks, alpha);
  border_.add_product(x, result);
}

void Structure::add_force_change(const double alpha, const double* r,
                                 double* forces)
{
  auto change = nodes().make_vector();
  fe::add_force_change(*cells_, tangent_laws_, tangent_positions_,
                       tangent_internal_.data(), alpha, r, change);
  fe::collect_forces(nodes(), &tangent_positions_, change);
  change.compress(dealii::VectorOperation::add);
  for (std::size_t i = 0; i < free_.size(); ++i)
    forces[i] -= fe::entry(change, free_[i]);
}

void Structure::compute_internal_change(const double alpha, const double* du,
                                        const double* r, double* change)
{
  auto dx = nodes().make_vector();
  prolong(du, dx);
  dx.update_ghost_values();
  fe::distribute_change(nodes(), &tangent_positions_, dx);
  fe::compute_internal_change(*cells_, tangent_laws_, tangent_positions_,
                              tangent_internal_.data(), alpha, dx, r, change);
}

void Structure::add_bar_masses(fe::TangentMatrix& matrix) const
{
  for (const auto& bar : nodes().bars)
    if (bar.director < nodes().n_owned)
    {
      const double m = bar.mass;
      const double j = bar.rotary_inertia / (bar.half_length * bar.half_length);
      matrix.add_block(bar.centre, bar.centre,
                       std::array<double, 9>{m, 0, 0, 0, m, 0, 0, 0, m}.data());
      matrix.add_block(bar.director, bar.director,
                       std::array<double, 9>{j, 0, 0, 0, j, 0, 0, 0, j}.data());
    }
}

void Structure::make_mass()
{
  if (mass_)
    return;
  const auto coupling = fe::TangentMatrix::Coupling::components;
  mass_ = std::make_unique<fe::TangentMatrix>(nodes(), *cells_,
                                              get_frame_elements(), coupling);
  mass_->begin();
  fe::add_mass(*cells_, get_densities(), *mass_);
  add_bar_masses(*mass_);
  add_frame_masses(false, *mass_);
  mass_->end();
  mass_solver_ = std::make_unique<fe::LinearSolver>(
      mass_->get(), fe::LinearSolver::Kind::symmetric_definite);
  mass_solver_->factorise();
  if (!has_drag())
    return;
  drag_ = std::make_unique<fe::TangentMatrix>(nodes(), *cells_,
                                              get_frame_elements(), coupling);
  drag_->begin();
  fe::add_mass(
      *cells_,
      std::vector<double>(device_.films.size(), device_.environment.air_drag),
      *drag_);
  add_frame_masses(true, *drag_);
  drag_->end();
}

void Structure::multiply_mass(const double* x, double* result)
{
  make_mass();
  multiply_with(mass_->get(), x, result);
}

void Structure::multiply_drag(const double* x, double* result)
{
  make_mass();
  multiply_with(drag_->get(), x, result);
}

void Structure::solve_mass(const double* b, double* x)
{
  make_mass();
  solve_with(*mass_solver_, b, x);
}

std::vector<double>
Structure::compute_support_product(const std::vector<double>& densities,
                                   const bool damping,
                                   const std::vector<double>& rates) const
{
  auto motion = nodes().make_vector(), product = nodes().make_vector();
  for (const auto& held : device_nodes_.moving)
    if (held.node < nodes().n_owned)
      fe::entry(motion, 3 * held.node + held.component) +=
          held.shape * rates[held.support];
  motion.update_ghost_values();
  fe::distribute_change(nodes(), nullptr, motion);
  fe::add_mass_product(*cells_, densities, motion, product);
  frames_->add_mass_product(damping, motion, product);
  fe::collect_forces(nodes(), nullptr, product);
  product.compress(dealii::VectorOperation::add);
  std::vector<double> result(n_free());
  restrict(product, result.data());
  return result;
}

std::vector<double>
Structure::compute_support_inertia(const std::vector<double>& rates) const
{
  return compute_support_product(get_densities(), false, rates);
}

std::vector<double>
Structure::compute_support_drag(const std::vector<double>& rates) const
{
  const std::vector<double> drag(device_.films.size(),
                                 device_.environment.air_drag);
  return compute_support_product(drag, true, rates);
}
} // namespace taut::structure
