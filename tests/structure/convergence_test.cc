// Order of convergence with a manufactured solution: a film whose points are
// told to move to x(X), in the plane and out of it, carries the force density
// b = -Div N of that motion, N the nominal stress per length of the mesh.
#include <gtest/gtest.h>

#include <cmath>

#include "structure/statics.h"

namespace taut
{
namespace
{
using Vector3 = std::array<double, 3>;

constexpr double modulus = 1, thickness = .5;
constexpr std::array<double, 2> pre_stretch{{1.5, 1.3}};

/// The motion of the point (X, Y) of the unit square.
Vector3 compute_position(const double X, const double Y)
{
  return {X + .1 * std::sin(2 * X + Y), Y + .08 * std::cos(X - 2 * Y),
          .2 * std::sin(2 * X) * std::cos(1.5 * Y)};
}

/// Columns of the gradient of the motion.
std::array<Vector3, 2> compute_gradient(const double X, const double Y)
{
  const double a = std::cos(2 * X + Y), b = std::sin(X - 2 * Y);
  return {{{{1 + .2 * a, -.08 * b, .4 * std::cos(2 * X) * std::cos(1.5 * Y)}},
           {{.1 * a, 1 + .16 * b, -.3 * std::sin(2 * X) * std::sin(1.5 * Y)}}}};
}

/// N = F S P/det P H of the neo-Hookean film, its two columns.
std::array<Vector3, 2> compute_nominal_stress(const double X, const double Y)
{
  auto F = compute_gradient(X, Y);
  for (unsigned int i = 0; i < 2; ++i)
    for (auto& component : F[i])
      component *= pre_stretch[i];
  const auto dot = [](const Vector3& a, const Vector3& b)
  { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const double xx = dot(F[0], F[0]), yy = dot(F[1], F[1]), xy = dot(F[0], F[1]);
  const double det = xx * yy - xy * xy;
  // S = mu (1 - C^-1/det C).
  const double S_xx = modulus * (1 - yy / (det * det));
  const double S_yy = modulus * (1 - xx / (det * det));
  const double S_xy = modulus * xy / (det * det);
  std::array<Vector3, 2> N;
  for (unsigned int c = 0; c < 3; ++c)
  {
    N[0][c] = thickness / pre_stretch[1] * (F[0][c] * S_xx + F[1][c] * S_xy);
    N[1][c] = thickness / pre_stretch[0] * (F[0][c] * S_xy + F[1][c] * S_yy);
  }
  return N;
}

/// -Div N by differences of sixth order: 1e-11.
Vector3 compute_force_density(const double X, const double Y)
{
  constexpr double h = 5e-3;
  constexpr double weights[3] = {45. / 60, -9. / 60, 1. / 60};
  Vector3 force{};
  for (int k = 1; k <= 3; ++k)
    for (const int side : {-1, 1})
    {
      const double weight = side * weights[k - 1] / h;
      const auto along = compute_nominal_stress(X + side * k * h, Y);
      const auto across = compute_nominal_stress(X, Y + side * k * h);
      for (unsigned int c = 0; c < 3; ++c)
        force[c] -= weight * (along[0][c] + across[1][c]);
    }
  return force;
}

/// A unit square of trapezia that stay as crooked however fine the grid.
fe::MeshData make_crooked_square(const unsigned int n)
{
  return testing::make_grid(
      n, n, 1,
      [n](const double xi, const double eta)
      {
        const int i = std::lround(xi * n), j = std::lround(eta * n);
        const bool inside_x = i > 0 && i<int(n), inside_y = j> 0 && j < int(n);
        const double X = xi + inside_x * (j % 2 ? .2 : -.2) / n;
        const double Y = eta + inside_y * (i % 2 ? -.15 : .15) / n;
        return fe::Coordinates{X, Y, 0.};
      });
}

/// Area of the mesh that a point of a cell stands for.
double get_area(const fe::FilmCells& cells, const unsigned int cell,
                const unsigned int q)
{
  return cells.volume(cell, q) * pre_stretch[0] * pre_stretch[1] / thickness;
}

std::vector<double> assemble_forces(const structure::Structure& structure)
{
  const auto& cells = structure.cells();
  const auto& element = cells.element();
  auto nodal = structure.nodes().make_vector();
  for (unsigned int cell = 0; cell < cells.cells().size(); ++cell)
    for (unsigned int q = 0; q < element.weights.size(); ++q)
    {
      const auto X = cells.mesh_point(cell, q);
      const Vector3 density = compute_force_density(X[0], X[1]);
      for (unsigned int a = 0; a < element.n_nodes; ++a)
        for (unsigned int c = 0; c < 3; ++c)
          fe::entry(nodal, 3 * cells.cells()[cell].nodes[a] + c) +=
              get_area(cells, cell, q) *
              element.values[q * element.n_nodes + a] * density[c];
    }
  nodal.compress(dealii::VectorOperation::add);
  std::vector<double> forces(structure.n_free());
  structure.restrict(nodal, forces.data());
  return forces;
}

/// L2 norm of the error of the positions.
double compute_error(const structure::Structure& structure,
                     const fe::NodalVector& positions)
{
  const auto& cells = structure.cells();
  const auto& element = cells.element();
  double square = 0;
  for (unsigned int cell = 0; cell < cells.cells().size(); ++cell)
    for (unsigned int q = 0; q < element.weights.size(); ++q)
    {
      const auto X = cells.mesh_point(cell, q);
      Vector3 error = compute_position(X[0], X[1]);
      for (unsigned int a = 0; a < element.n_nodes; ++a)
        for (unsigned int c = 0; c < 3; ++c)
          error[c] -=
              element.values[q * element.n_nodes + a] *
              fe::entry(positions, 3 * cells.cells()[cell].nodes[a] + c);
      for (const double component : error)
        square += component * component * get_area(cells, cell, q);
    }
  return std::sqrt(dealii::Utilities::MPI::sum(square, MPI_COMM_WORLD));
}

double solve_for_error(const unsigned int degree, const unsigned int n)
{
  structure::Device device;
  device.mesh.degree = degree;
  device.films = {testing::make_film(material::NeoHookean{modulus}, thickness,
                                     pre_stretch)};
  for (const char* side : {"west", "east", "south", "north"})
    device.supports.push_back(testing::make_support(
        side, {{true, true, true}},
        {{".1*sin(2*x + y)", ".08*cos(x - 2*y)", ".2*sin(2*x)*cos(1.5*y)"}},
        Signal::constant(1)));
  testing::Model model(device, make_crooked_square(n));
  auto& structure = *model.structure;
  testing::Statics statics(structure);
  statics.nodal_forces = assemble_forces(structure);
  // Newton starts at the nodes of the solution.
  const auto& free = structure.free_unknowns();
  for (std::size_t i = 0; i < free.size(); ++i)
  {
    const auto& X = structure.nodes().mesh_position[free[i] / 3];
    const unsigned int c = free[i] % 3;
    statics.u[i] = compute_position(X[0], X[1])[c] - X[c];
  }
  statics.find(1e-11);
  return compute_error(structure, structure.compute_positions(
                                      statics.get_loads(), statics.u.data()));
}

class Convergence : public ::testing::TestWithParam<unsigned int>
{
};

TEST_P(Convergence, is_of_one_order_more_than_the_degree)
{
  const unsigned int degree = GetParam();
  double last = solve_for_error(degree, 8);
  for (const unsigned int n : {16, 32})
  {
    const double error = solve_for_error(degree, n);
    EXPECT_NEAR(std::log2(last / error), degree + 1., .15) << "n = " << n;
    last = error;
  }
}

INSTANTIATE_TEST_SUITE_P(degrees, Convergence, ::testing::Values(1u, 2u));
} // namespace
} // namespace taut
