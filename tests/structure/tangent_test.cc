// The tangents against differences of the forces, in devices that use every
// term at once.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "structure/frames.h"

namespace taut
{
namespace
{
using structure::LoadState;
using structure::Networks;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Curved sheet with two materials, one of them with fibres and networks that
/// are activated, an electrode, pressure, hanging nodes and a bar that is free
/// to rotate.
std::unique_ptr<testing::Model>
make_stretched(const unsigned int degree,
               const std::array<double, 2>& pre_stretch)
{
  structure::Device device;
  device.mesh.degree = degree;
  auto film = testing::make_film(material::Gent{2e4, 60}, 1e-3, pre_stretch);
  film.material.networks = {{material::Gent{1e4, 60}, 0.01},
                            {material::NeoHookean{5e3}, 1}};
  film.material.networks[0].relaxation =
      material::StressActivatedRelaxation{2e4};
  film.material.networks[1].relaxation =
      material::StretchActivatedRelaxation{.5};
  film.material.fibres = {
      {material::ExponentialFibres{5e3, .1}, {{.8, .6}}, false, .1}};
  film.axis = {{1, 0.3, 0}};
  film.groups = {"left"};
  device.films.push_back(film);
  film.name = "second";
  film.groups = {"right"};
  film.material.networks.pop_back();
  film.material.springs = {material::MooneyRivlin{1e4, 3e3}};
  device.films.push_back(film);
  device.electrodes = {testing::make_electrode("left", Signal::constant(3000))};
  device.supports = {testing::make_support("west", {{true, true, true}}),
                     testing::make_support("east", {{false, true, true}})};
  device.pressures = {testing::make_pressure("film", Signal::constant(20))};
  device.bars = {testing::make_bar("middle", 1e-2)};
  const auto mesh = testing::make_bent_sheet(degree);
  return std::make_unique<testing::Model>(
      device, mesh, 0,
      [](fe::Triangulation& triangulation)
      {
        for (const auto& cell : triangulation.active_cell_iterators())
          if (cell->is_locally_owned() && cell->center()[0] < .015 &&
              cell->center()[1] > .02)
            cell->set_refine_flag();
        triangulation.execute_coarsening_and_refinement();
      });
}

std::unique_ptr<testing::Model> make_everything(const unsigned int degree)
{
  return make_stretched(degree, {{1.5, 2}});
}

std::unique_ptr<testing::Model> make_wrinkled(const unsigned int degree)
{
  return make_stretched(degree, {{1.5, .5}});
}

std::unique_ptr<testing::Model> make_slack(const unsigned int degree)
{
  return make_stretched(degree, {{.6, .5}});
}

/// The charge of the left half is given, at a field of .15 sqrt(G/eps) in the
/// mesh; on the right a circuit.
std::unique_ptr<testing::Model>
make_charged(const unsigned int degree,
             const std::array<double, 2>& pre_stretch)
{
  auto model = make_stretched(degree, pre_stretch);
  auto device = model->structure->device();
  using Control = structure::Electrode::Control;
  device.electrodes[0].control = Control::charge;
  device.electrodes[0].charge =
      Signal::constant(.15 * model->structure->charge_scales()[0]);
  device.electrodes.push_back(
      testing::make_electrode("right", Signal::constant(2000)));
  device.electrodes[1].control = Control::circuit;
  device.electrodes[1].series_resistance = 3e9;
  device.electrodes[1].leakage_resistance = 5e9;
  model->structure = std::make_unique<structure::Structure>(
      device, model->mesh, model->triangulation);
  return model;
}

std::unique_ptr<testing::Model> make_charged_taut(const unsigned int degree)
{
  return make_charged(degree, {{1.5, 2}});
}

std::unique_ptr<testing::Model> make_charged_wrinkled(const unsigned int degree)
{
  return make_charged(degree, {{1.5, .5}});
}

std::unique_ptr<testing::Model> make_charged_slack(const unsigned int degree)
{
  return make_charged(degree, {{.6, .5}});
}

/// The sheet in a frame: a beam along the north edge, from its end an arm into
/// space with a hinge where they meet, beams along the west edge that end in a
/// rigid body along the south edge, and loads on the arm.
std::unique_ptr<testing::Model> make_framed_sheet(const unsigned int degree)
{
  structure::Device device;
  device.mesh.degree = degree;
  auto film = testing::make_film(material::Gent{2e4, 60}, 1e-3, {{1.5, 2}});
  film.material.networks = {{material::Gent{1e4, 60}, 0.01}};
  film.tension_field = false;
  device.films = {film};
  device.electrodes = {testing::make_electrode("left", Signal::constant(3000))};
  auto section = testing::make_stiffnesses(300, 100, 1e-4, 1e-4, 3e-4);
  section.mass_per_length = 1e-3;
  section.rotary_inertia = {{3e-9, 1e-9, 2e-9}};
  device.frames = {testing::make_frame("north", section),
                   testing::make_frame("arm", section),
                   testing::make_frame("west", section)};
  // Glued on the faces of the beams, or on their axes.
  for (auto& frame : device.frames)
    frame.offset = degree == 1 ? 1e-3 : 0;
  device.frames[2].attachment = structure::Frame::Attachment::at;
  device.frames[2].attached_at = {"west"};
  device.hinges.push_back({});
  device.hinges[0].groups = {"north_east"};
  device.bodies.push_back({});
  device.bodies[0].name = "south end";
  device.bodies[0].groups = {"south"};
  device.bodies[0].mass = 1e-3;
  device.bodies[0].rotary_inertia = {{1e-7, 2e-7, 3e-7}};
  auto load = testing::make_point_load("arm_tip", {{1, 2, 3}});
  load.force = Signal::constant(0.02);
  load.moment_direction = {{1, -1, 2}};
  load.moment = Signal::constant(3e-4);
  load.follower = true;
  device.point_loads = {load};
  auto mesh = testing::make_bent_sheet(2);
  const fe::Coordinates corner = mesh.vertices[mesh.points[1].vertex];
  const auto ends = testing::add_line(
      mesh, "arm", 3,
      testing::make_straight(
          corner, {corner[0] + .01, corner[1] + .01, corner[2] - .02}));
  testing::name_point(mesh, ends[1], "arm_tip");
  return std::make_unique<testing::Model>(device, mesh);
}

std::vector<double> make_noise(const std::size_t n, const double size,
                               const unsigned int seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-size, size);
  std::vector<double> values(n);
  for (auto& value : values)
    value = uniform(generator);
  return values;
}

/// Takes from a direction what changes the length of quaternions: the tangent
/// has a stiffness of its own there, the forces have none.
void remove_lengthening(const structure::Structure& structure,
                        const std::vector<double>& u,
                        std::vector<double>& direction)
{
  const auto& nodes = structure.nodes();
  auto values = nodes.make_vector(), changes = nodes.make_vector();
  structure.prolong(u.data(), values);
  structure.prolong(direction.data(), changes);
  for (const auto& rotation : nodes.rotations)
  {
    if (rotation.vector >= nodes.n_owned)
      continue;
    fe::entry(values, 3 * rotation.scalar()) += rotation.length;
    const Quaternion q = fe::get_quaternion(rotation, values);
    const Quaternion change = fe::get_quaternion(rotation, changes);
    double along = 0;
    for (unsigned int i = 0; i < 4; ++i)
      along += q[i] * change[i] / (length(q) * length(q));
    fe::entry(changes, 3 * rotation.scalar()) -= along * q[0];
    for (unsigned int i = 0; i < 3; ++i)
      fe::entry(changes, 3 * rotation.vector + i) -= along * q[1 + i];
  }
  structure.restrict(changes, direction.data());
}

double norm(const std::vector<double>& values)
{
  double square = 0;
  for (const double value : values)
    square += value * value;
  return std::sqrt(dealii::Utilities::MPI::sum(square, MPI_COMM_WORLD));
}

struct Setting
{
  std::unique_ptr<testing::Model> (*make)(unsigned int degree);
  unsigned int degree;
};

class Tangent : public ::testing::TestWithParam<Setting>
{
protected:
  std::unique_ptr<testing::Model> make_model() const
  {
    return GetParam().make(GetParam().degree);
  }
};

/// The loads at time 0 with voltages; circuits have the charge of the first
/// electrode.
LoadState get_loads(structure::Structure& structure,
                    const structure::LoadHistory& history,
                    const std::vector<double>& u, const std::vector<double>& A)
{
  LoadState loads = history.at(0);
  const auto& electrodes = structure.device().electrodes;
  structure::give_charges(
      electrodes,
      std::vector<double>(electrodes.size(), electrodes[0].charge.value(0)),
      loads);
  return structure.resolve_voltages(loads, u.data(), A.data(),
                                    Networks::as_given);
}

TEST_P(Tangent, frozen_equals_differences_of_forces)
{
  const auto model = make_model();
  auto& structure = *model->structure;
  structure::LoadHistory history(structure.device());
  history.enter_interval(0);
  const std::size_t n = structure.n_free();
  const auto u = make_noise(n, 3e-4, 1);
  auto A = make_noise(structure.n_internal(), 0.05, 2);
  for (std::size_t i = 0; i < A.size(); i += 3)
  {
    A[i] += 0.6;
    A[i + 1] += 0.5;
  }
  auto direction = make_noise(n, 1, 3);
  remove_lengthening(structure, u, direction);
  std::vector<double> product(n), plus(n), minus(n), moved(u);
  structure.multiply_tangent(get_loads(structure, history, u, A), u.data(),
                             A.data(), Networks::as_given, infinity, false,
                             false, direction.data(), product.data());
  // Central differences: error h^2 u''' / 6 + round-off / h, about 1e-8.
  constexpr double h = 3e-8;
  for (std::size_t i = 0; i < n; ++i)
    moved[i] = u[i] + h * direction[i];
  structure.compute_forces(get_loads(structure, history, moved, A),
                           moved.data(), A.data(), Networks::as_given,
                           plus.data(), nullptr);
  for (std::size_t i = 0; i < n; ++i)
    moved[i] = u[i] - h * direction[i];
  structure.compute_forces(get_loads(structure, history, moved, A),
                           moved.data(), A.data(), Networks::as_given,
                           minus.data(), nullptr);
  std::vector<double> difference(n);
  for (std::size_t i = 0; i < n; ++i)
    difference[i] = product[i] + (plus[i] - minus[i]) / (2 * h);
  EXPECT_LT(norm(difference), 1e-6 * norm(product));
}

class CondensedTangent : public Tangent
{
};

TEST_P(CondensedTangent, solve_inverts_the_system)
{
  // Quasi-static with the general solver: the whole of alpha B - df/dy.
  const auto model = make_model();
  auto& structure = *model->structure;
  structure::QuasiStaticSystem system(structure, {});
  auto y = system.make_initial_state(0, structure::Start::unrelaxed, false, {});
  const std::size_t size = y.size();
  const auto shake = make_noise(structure.n_free(), 2e-4, 9);
  for (std::size_t i = 0; i < shake.size(); ++i)
    y[i] += shake[i];
  constexpr double alpha = 30;
  auto r = make_noise(size, 1, 7);
  const std::size_t n_scalars = system.layout().scalars;
  for (std::size_t i = size - n_scalars; i < size; ++i)
    r[i] = 0;
  std::vector<double> d(size), b(size), plus(size), minus(size), moved(y);
  system.prepare(0, y.data(), alpha);
  system.solve(r.data(), d.data());
  // Central differences over a change of 1e-4: the truncation is of its square,
  // and the round-off of rates of 1e3 /s, divided by h, stays below 1e-5. No
  // point of this noise changes between taut, wrinkled and slack within it. In
  // the slack film, next to rest, the stress-activated flow bends within 1e-4.
  const double h = 1e-4 / norm(d);
  for (std::size_t i = 0; i < size; ++i)
    moved[i] = y[i] + h * d[i];
  system.evaluate(0, moved.data(), plus.data());
  for (std::size_t i = 0; i < size; ++i)
    moved[i] = y[i] - h * d[i];
  system.evaluate(0, moved.data(), minus.data());
  system.multiply_mass(d.data(), b.data());
  std::vector<double> defect(size, 0.);
  for (std::size_t i = 0; i < size - n_scalars; ++i)
    defect[i] = alpha * b[i] - (plus[i] - minus[i]) / (2 * h) - r[i];
  EXPECT_LT(norm(defect), 2e-5 * norm(r));
}

TEST_P(Tangent, symmetric_when_networks_are_frozen)
{
  const auto model = make_model();
  auto& structure = *model->structure;
  structure::LoadHistory history(structure.device());
  const std::size_t n = structure.n_free();
  const auto u = make_noise(n, 3e-4, 1);
  std::vector<double> A(structure.n_internal());
  fe::set_unrelaxed(structure.cells(), A.data());
  LoadState loads = get_loads(structure, history, u, A);
  // Neither follows the deformation without a potential.
  for (auto* list :
       {&loads.pressures, &loads.point_forces, &loads.point_moments})
    std::fill(list->begin(), list->end(), 0.);
  const auto a = make_noise(n, 1, 3), b = make_noise(n, 1, 4);
  std::vector<double> Ka(n), Kb(n);
  structure.multiply_tangent(loads, u.data(), A.data(), Networks::as_given,
                             infinity, false, false, a.data(), Ka.data());
  structure.multiply_tangent(loads, u.data(), A.data(), Networks::as_given,
                             infinity, false, false, b.data(), Kb.data());
  double b_Ka = 0, a_Kb = 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    b_Ka += b[i] * Ka[i];
    a_Kb += a[i] * Kb[i];
  }
  b_Ka = dealii::Utilities::MPI::sum(b_Ka, MPI_COMM_WORLD);
  a_Kb = dealii::Utilities::MPI::sum(a_Kb, MPI_COMM_WORLD);
  EXPECT_NEAR(b_Ka, a_Kb, 1e-12 * norm(b) * norm(Ka));
}

INSTANTIATE_TEST_SUITE_P(films, CondensedTangent,
                         ::testing::Values(Setting{make_everything, 1},
                                           Setting{make_everything, 2},
                                           Setting{make_wrinkled, 2},
                                           Setting{make_slack, 2},
                                           Setting{make_charged_taut, 2}));
INSTANTIATE_TEST_SUITE_P(devices, Tangent,
                         ::testing::Values(Setting{make_everything, 1},
                                           Setting{make_everything, 2},
                                           Setting{make_wrinkled, 2},
                                           Setting{make_slack, 2},
                                           Setting{make_charged_taut, 1},
                                           Setting{make_charged_taut, 2},
                                           Setting{make_charged_wrinkled, 2},
                                           Setting{make_charged_slack, 2},
                                           Setting{make_framed_sheet, 1},
                                           Setting{make_framed_sheet, 2}));
} // namespace
} // namespace taut
