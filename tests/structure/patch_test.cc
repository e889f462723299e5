// Patch tests: a homogeneous state is an exact equilibrium on any flat mesh,
// however distorted its cells and however curved their edges, with hanging
// nodes as well. The isoparametric gradients are such that the Gauss rule
// integrates div(N_a S) exactly, so only round-off and Newton's residual
// remain: 1e-12.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "structure/statics.h"

namespace taut
{
namespace
{
constexpr double length = .05, width = .04;
constexpr double modulus = 3e4, thickness = 1e-3;
constexpr double tolerance = 1e-12;

struct Mesh
{
  std::string name;
  unsigned int degree;
  unsigned int order;
  bool curved;
  bool hanging;
};

void PrintTo(const Mesh& mesh, std::ostream* stream)
{
  *stream << mesh.name;
}

/// A rectangle whose inner nodes are shaken; with `curved`, also by waves that
/// bend the inner edges.
fe::MeshData make_distorted_mesh(const Mesh& mesh)
{
  return testing::make_grid(
      4, 3, mesh.order,
      [&](const double xi, const double eta)
      {
        const double shake = mesh.order == 2 ? .02 : .08;
        const double bubble = 16 * xi * (1 - xi) * eta * (1 - eta);
        double x = xi + shake * bubble * std::sin(40 * xi + 7 * eta);
        double y = eta + shake * bubble * std::cos(9 * xi - 30 * eta);
        if (mesh.curved)
        {
          x += .02 * bubble * std::cos(11 * M_PI * eta);
          y -= .02 * bubble * std::cos(13 * M_PI * xi);
        }
        return fe::Coordinates{x * length, y * width, 0.};
      });
}

std::unique_ptr<testing::Model> make_model(structure::Device device,
                                           const Mesh& mesh)
{
  device.mesh.degree = mesh.degree;
  const auto refine = [&](fe::Triangulation& triangulation)
  {
    if (mesh.hanging)
      testing::refine_corner(triangulation, length, width);
  };
  return std::make_unique<testing::Model>(device, make_distorted_mesh(mesh), 0,
                                          refine);
}

structure::Device make_device(const std::array<double, 2>& pre_stretch)
{
  structure::Device device;
  device.films = {testing::make_film(material::NeoHookean{modulus}, thickness,
                                     pre_stretch)};
  device.films[0].material.dielectric.permittivity =
      material::ConstantPermittivity{4.7};
  device.electrodes = {testing::make_electrode(
      "film",
      Signal::constant(testing::make_voltage(device.films[0], .2, modulus)))};
  return device;
}

/// A rim that moves at once would fold the cells along it.
void move_supports(testing::Statics& statics)
{
  constexpr unsigned int n_steps = 8;
  for (unsigned int step = 1; step <= n_steps; ++step)
  {
    for (auto& support : statics.loads.supports)
      support.amplitude = Signal::constant(double(step) / n_steps);
    statics.apply();
    statics.find();
  }
}

class Patch : public ::testing::TestWithParam<Mesh>
{
};

TEST_P(Patch, affine_motion_of_the_rim_is_the_motion_of_all_points)
{
  auto device = make_device({{1.4, 1.7}});
  device.films[0].axis = {{1, .5, 0}};
  for (const char* side : {"west", "east", "south", "north"})
    device.supports.push_back(testing::make_support(
        side, {{true, true, true}}, {{".2*x + .1*y", "-.05*x + .3*y", "0"}}));
  const auto model = make_model(device, GetParam());
  testing::Statics statics(*model->structure);
  move_supports(statics);

  // C = P F_s^T F_s P in the material axes, F_s = 1 + gradient of the motion.
  const double c = 1 / std::hypot(1, .5), s = .5 * c;
  const double a[2] = {1.2 * c + .1 * s, -.05 * c + 1.3 * s};
  const double b[2] = {-1.2 * s + .1 * c, .05 * s + 1.3 * c};
  const std::array<double, 3> expected{
      {1.4 * 1.4 * (a[0] * a[0] + a[1] * a[1]),
       1.7 * 1.7 * (b[0] * b[0] + b[1] * b[1]),
       1.4 * 1.7 * (a[0] * b[0] + a[1] * b[1])}};
  EXPECT_LT(testing::compute_deviation(statics.compute_metric(), expected),
            tolerance * expected[1]);
}

TEST_P(Patch, reactions_and_energies_are_those_of_the_closed_form)
{
  // Two families of fibres to either side of x, which do not shear the film.
  const double p_1 = 1.3, p_2 = 1.5, stiffness = 1e4;
  auto device = make_device({{p_1, p_2}});
  for (const double side : {-.6, .6})
    device.films[0].material.fibres.push_back(
        {material::QuadraticFibres{stiffness}, {{.8, side}}});
  device.supports = {testing::make_support("west", {{true, false, true}}),
                     testing::make_support("east", {{true, false, true}},
                                           {{".3*x", "0", "0"}}),
                     testing::make_support("south", {{false, true, true}}),
                     testing::make_support("north", {{false, true, true}},
                                           {{"0", "-.1*y", "0"}})};
  const auto model = make_model(device, GetParam());
  testing::Statics statics(*model->structure);
  move_supports(statics);

  const double l_1 = 1.3 * p_1, l_2 = .9 * p_2;
  EXPECT_LT(testing::compute_deviation(statics.compute_metric(),
                                       {{l_1 * l_1, l_2 * l_2, 0}}),
            tolerance * l_1 * l_1);
  // s_1 = mu (l_1 - l_1^-3 l_2^-2) - eps (V/H)^2 l_1 l_2^2.
  const double e = .04;
  const double across = std::pow(l_1 * l_2, -2);
  // Of each family 2 k1 (I4 - 1) times the square of a cosine and l.
  const double excess = .64 * l_1 * l_1 + .36 * l_2 * l_2 - 1;
  const double fibres = 4 * stiffness * excess;
  const double s_1 =
      modulus * (l_1 - across / l_1 - e * l_1 * l_2 * l_2) + .64 * fibres * l_1;
  const double s_2 =
      modulus * (l_2 - across / l_2 - e * l_1 * l_1 * l_2) + .36 * fibres * l_2;
  const double force_1 = s_1 * thickness * width / p_2;
  const double force_2 = s_2 * thickness * length / p_1;
  EXPECT_NEAR(statics.get_reaction(0)[0], -force_1, tolerance * force_1);
  EXPECT_NEAR(statics.get_reaction(1)[0], force_1, tolerance * force_1);
  EXPECT_NEAR(statics.get_reaction(2)[1], -force_2, tolerance * force_2);
  EXPECT_NEAR(statics.get_reaction(3)[1], force_2, tolerance * force_2);
  EXPECT_NEAR(statics.get_reaction(0)[2], 0, tolerance * force_1);

  const double volume = thickness * length * width / (p_1 * p_2);
  const double stored =
      volume * (modulus / 2 * (l_1 * l_1 + l_2 * l_2 + across - 3) +
                stiffness * excess * excess);
  const double electric = volume * modulus / 2 * e / across;
  const auto energies = statics.compute_energies();
  EXPECT_NEAR(energies.stored, stored, tolerance * stored);
  EXPECT_NEAR(energies.electric, electric, tolerance * electric);
  // Q = eps (V/H) det C per undeformed area: Q V = 2 electric.
  const double voltage = statics.get_loads().voltages[0];
  EXPECT_NEAR(model->structure->compute_charges(statics.get_loads())[0],
              2 * electric / voltage, tolerance * electric / voltage);
}

INSTANTIATE_TEST_SUITE_P(
    meshes, Patch,
    ::testing::Values(Mesh{"Q1", 1, 1, false, false},
                      Mesh{"Q1_hanging", 1, 1, false, true},
                      Mesh{"Q1_on_curved_hanging", 1, 2, true, true},
                      Mesh{"Q2", 2, 1, false, false},
                      Mesh{"Q2_hanging", 2, 1, false, true},
                      Mesh{"Q2_curved", 2, 2, true, false},
                      Mesh{"Q2_curved_hanging", 2, 2, true, true}),
    [](const auto& info) { return info.param.name; });
} // namespace
} // namespace taut
