// A rigid motion of the deformed film, its bar included, leaves energies and
// the rates of the internal variables as they were and turns all forces.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "structure/statics.h"

namespace taut
{
namespace
{
using Vector3 = std::array<double, 3>;
using Rotation = std::array<Vector3, 3>;

/// Rodrigues' formula.
Rotation make_rotation(const Vector3& axis, const double angle)
{
  const double size = std::hypot(axis[0], axis[1], axis[2]);
  const Vector3 n{{axis[0] / size, axis[1] / size, axis[2] / size}};
  const double c = std::cos(angle), s = std::sin(angle);
  const Rotation cross{
      {{{0, -n[2], n[1]}}, {{n[2], 0, -n[0]}}, {{-n[1], n[0], 0}}}};
  Rotation R;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      R[i][j] = c * (i == j) + s * cross[i][j] + (1 - c) * n[i] * n[j];
  return R;
}

Vector3 turn(const Rotation& R, const double* x)
{
  Vector3 result;
  for (unsigned int i = 0; i < 3; ++i)
    result[i] = R[i][0] * x[0] + R[i][1] * x[1] + R[i][2] * x[2];
  return result;
}

/// A free bowl under voltage and pressure, with two networks, a rigid bar and
/// hanging nodes: all nodes of a group of three unknowns are free.
std::unique_ptr<testing::Model> make_free_bowl(const unsigned int degree)
{
  structure::Device device;
  device.mesh.degree = degree;
  device.films = {
      testing::make_film(material::Gent{2e4, 60}, 1e-3, {{1.5, 2}})};
  device.films[0].material.networks = {{material::Gent{1e4, 60}, .01},
                                       {material::NeoHookean{5e3}, 1}};
  device.electrodes = {testing::make_electrode("left", Signal::constant(3000))};
  device.pressures = {testing::make_pressure("film", Signal::constant(20))};
  device.bars = {testing::make_bar("middle", 1e-2)};
  const auto mesh = testing::make_bent_sheet(degree);
  return std::make_unique<testing::Model>(
      device, mesh, 0,
      [](fe::Triangulation& triangulation)
      { testing::refine_corner(triangulation, .04, .03); });
}

/// Positions, forces, rates and energies of a state.
struct Answer
{
  std::vector<double> forces, rates;
  double stored, electric;
};

Answer compute_answer(testing::Statics& statics,
                      structure::Structure& structure,
                      const std::vector<double>& u)
{
  Answer answer;
  answer.forces.resize(structure.n_free());
  answer.rates.resize(structure.n_internal());
  const auto loads = statics.get_loads();
  structure.compute_forces(loads, u.data(), statics.internal.data(),
                           structure::Networks::as_given, answer.forces.data(),
                           answer.rates.data());
  const auto energies = structure.compute_energies(loads, u.data(), nullptr,
                                                   statics.internal.data());
  answer.stored = energies.stored;
  answer.electric = energies.electric;
  return answer;
}

double find_largest(const std::vector<double>& values)
{
  double largest = 0;
  for (const double value : values)
    largest = std::max(largest, std::abs(value));
  return dealii::Utilities::MPI::max(largest, MPI_COMM_WORLD);
}

class Frame : public ::testing::TestWithParam<unsigned int>
{
};

TEST_P(Frame, rigid_motion_turns_forces_and_leaves_energies)
{
  const auto model = make_free_bowl(GetParam());
  auto& structure = *model->structure;
  const auto& nodes = structure.nodes();
  testing::Statics statics(structure);
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> noise(-4e-4, 4e-4);
  for (auto& value : statics.u)
    value = noise(generator);
  const Answer before = compute_answer(statics, structure, statics.u);

  const Rotation R = make_rotation({{.3, -1, .8}}, 2.1);
  const Vector3 shift{{.02, -.01, .03}};
  const auto& free = structure.free_unknowns();
  std::vector<double> moved(statics.u);
  for (std::size_t i = 0; i < free.size(); i += 3)
  {
    ASSERT_EQ(free[i] % 3, 0u);
    const auto node = free[i] / 3;
    const auto& X = nodes.mesh_position[node];
    // The director of a bar is a difference of points.
    bool is_director = false;
    for (const auto& bar : nodes.bars)
      is_director = is_director || bar.director == node;
    const double x[3] = {X[0] + statics.u[i], X[1] + statics.u[i + 1],
                         X[2] + statics.u[i + 2]};
    const Vector3 turned = turn(R, x);
    for (unsigned int c = 0; c < 3; ++c)
      moved[i + c] = turned[c] + (is_director ? 0. : shift[c]) - X[c];
  }
  const Answer after = compute_answer(statics, structure, moved);

  // Round-off of positions of .05 m in cells of .005 m.
  constexpr double tolerance = 1e-12;
  EXPECT_NEAR(after.stored, before.stored, tolerance * before.stored);
  EXPECT_NEAR(after.electric, before.electric, tolerance * before.electric);
  std::vector<double> difference(before.forces.size());
  for (std::size_t i = 0; i < free.size(); i += 3)
  {
    const Vector3 turned = turn(R, &before.forces[i]);
    for (unsigned int c = 0; c < 3; ++c)
      difference[i + c] = after.forces[i + c] - turned[c];
  }
  EXPECT_GT(find_largest(before.forces), 1e-3);
  EXPECT_LT(find_largest(difference), tolerance * find_largest(before.forces));
  difference = after.rates;
  for (std::size_t i = 0; i < difference.size(); ++i)
    difference[i] -= before.rates[i];
  EXPECT_LT(find_largest(difference), tolerance * find_largest(before.rates));
}

INSTANTIATE_TEST_SUITE_P(degrees, Frame, ::testing::Values(1u, 2u));
} // namespace
} // namespace taut
