#include <taut/base/exceptions.h>
#include <taut/structure/probes.h>

#include <gtest/gtest.h>

#include <cmath>

#include "structure/bow.h"

// What probes show of frames, against statics in closed form.
namespace taut::testing
{
namespace
{
using structure::Probe;
using Kind = Probe::Kind;

Probe make_probe(const Kind kind, const std::string& of,
                 const unsigned int component = 0, const std::string& at = "")
{
  Probe probe;
  probe.name = "probe";
  probe.source_line = 7;
  probe.kind = kind;
  probe.of = of;
  probe.at = at;
  probe.component = component;
  return probe;
}

Probe make_probe_at(const Kind kind, const fe::Coordinates& point,
                    const unsigned int component, const std::string& of = "")
{
  Probe probe = make_probe(kind, of, component);
  probe.point = point;
  return probe;
}

/// All probes of the device at displacements u.
std::vector<double> evaluate(structure::Structure& structure,
                             const std::vector<double>& u)
{
  structure::QuasiStaticSystem system(structure, {});
  structure::Probes probes(system);
  auto state =
      system.make_initial_state(0, structure::Start::relaxed, false, {});
  std::copy(u.begin(), u.end(), state.begin());
  return probes.evaluate(0, state.data());
}

/// The equilibrium under the first point load of the device, in `n` steps.
std::vector<double> find_equilibrium(structure::Structure& structure,
                                     const unsigned int n)
{
  Statics statics(structure);
  const double force = statics.loads.point_loads[0].force.value(0);
  const double moment = statics.loads.point_loads[0].moment.value(0);
  for (unsigned int i = 1; i <= n; ++i)
  {
    for (auto& load : statics.loads.point_loads)
    {
      load.force = Signal::constant(force * i / n);
      load.moment = Signal::constant(moment * i / n);
    }
    statics.apply();
    statics.find(1e-12);
  }
  return statics.u;
}

structure::PointLoad make_moment(const std::string& group,
                                 const std::array<double, 3>& direction,
                                 const double moment)
{
  auto load = make_point_load(group, {0, 0, 0});
  load.moment_direction = direction;
  load.moment = Signal::constant(moment);
  return load;
}

/// A beam through corners, of straight lines of `n` elements each, clamped at
/// the first, `root`, and loaded at the last, `tip`.
fe::MeshData make_polygon(const std::vector<fe::Coordinates>& corners,
                          const unsigned int n)
{
  auto mesh = make_line_mesh();
  std::array<unsigned int, 2> ends{};
  for (std::size_t i = 1; i < corners.size(); ++i)
  {
    ends = add_line(mesh, "beam", n, make_straight(corners[i - 1], corners[i]));
    if (i == 1)
      name_point(mesh, ends[0], "root");
    if (i + 1 < corners.size())
      name_point(mesh, ends[1], "middle");
  }
  name_point(mesh, ends[1], "tip");
  fe::add_empty_surface(mesh);
  return mesh;
}

/// Relative error of bending or twisting by `angle` (rad) in one element, in
/// which parabolas stand for the sine and cosine of half of the angle.
double get_element_error(const double angle)
{
  return std::pow(angle, 4) / 720;
}

/// GJ = 2, EI = 1 about the width, 3 about the thickness.
structure::Device make_beam(const structure::PointLoad& load,
                            const std::string& clamped = "root")
{
  structure::Device device;
  device.frames = {make_frame("beam", make_stiffnesses(1e6, 1e6, 2, 1, 3))};
  device.frames[0].section.thickness = .02;
  device.supports = {make_clamp(clamped)};
  device.point_loads = {load};
  return device;
}

const std::string frame_name = "frame on beam";

TEST(FrameProbes, BalanceOfACantileverUnderADeadTipForce)
{
  const double force = 5;
  auto load = make_point_load("tip", {0, 0, 1});
  load.force = Signal::constant(force);
  auto device = make_beam(load);
  device.probes = {make_probe(Kind::position, "tip", 0),
                   make_probe(Kind::displacement, "tip", 2),
                   make_probe_at(Kind::displacement, {1, 0, 0}, 2),
                   make_probe(Kind::distance, "root, tip"),
                   make_probe(Kind::rotation, "tip", 1),
                   make_probe(Kind::frame_moment, frame_name, 1, "root"),
                   make_probe(Kind::frame_force, frame_name, 0, "tip"),
                   make_probe(Kind::frame_force, frame_name, 2, "tip"),
                   make_probe(Kind::frame_force, frame_name, 2, "root"),
                   make_probe(Kind::frame_force, frame_name, 0, "middle"),
                   make_probe(Kind::rotation, "middle", 1)};
  Model model(device, make_polygon({{0, 0, 0}, {.5, 0, 0}, {1, 0, 0}}, 20));
  const auto values =
      evaluate(*model.structure, find_equilibrium(*model.structure, 5));
  // The elastica; shear and stretching change it by P/GA = 5e-6.
  const double w = .7137915236, u = .3876283607, angle = 1.2153681176;
  EXPECT_NEAR(values[0], 1 - u, 2e-5);
  EXPECT_NEAR(values[1], w, 2e-5);
  EXPECT_EQ(values[2], values[1]);
  EXPECT_NEAR(values[3], std::hypot(1 - u, w), 2e-5);
  EXPECT_NEAR(values[4], -angle, 2e-5);
  // Resultants are extrapolated along straight lines within the elements: an
  // error of h^2/12 times the second derivative, that is P times the square of
  // the curvature, at most (P (1 - u)/EI)^2 = 9.4.
  const double tolerance = force * 10 / 12 / (40. * 40);
  EXPECT_NEAR(values[5], -force * (1 - u), tolerance);
  EXPECT_NEAR(values[6], force * std::sin(angle), tolerance);
  EXPECT_NEAR(values[7], force * std::cos(angle), tolerance);
  EXPECT_NEAR(values[8], force, tolerance);
  EXPECT_NEAR(values[9], force * std::sin(-values[10]), tolerance);
}

TEST(FrameProbes, PureBendingBeyondHalfATurn)
{
  const double moment = 5;
  auto device = make_beam(make_moment("tip", {0, 1, 0}, moment));
  device.probes = {make_probe(Kind::rotation, "tip", 1),
                   make_probe(Kind::half_angle, "root, tip", 1),
                   make_probe(Kind::half_angle, "tip, root", 1),
                   make_probe(Kind::frame_moment, frame_name, 1, "root"),
                   make_probe_at(Kind::frame_moment, {.5, 0, 0}, 1, frame_name),
                   make_probe(Kind::frame_force, frame_name, 0, "middle"),
                   make_probe(Kind::frame_strain, frame_name),
                   make_probe(Kind::distance, "root, tip")};
  Model model(device, make_polygon({{0, 0, 0}, {.5, 0, 0}, {1, 0, 0}}, 10));
  const auto values =
      evaluate(*model.structure, find_equilibrium(*model.structure, 10));
  // An arc of curvature M/EI = 5 of twenty elements.
  const double tolerance = get_element_error(moment / 20) * moment;
  EXPECT_NEAR(values[0], moment, tolerance);
  EXPECT_NEAR(values[1], moment / 2, tolerance);
  EXPECT_NEAR(values[2], -moment / 2, tolerance);
  EXPECT_NEAR(values[3], moment, tolerance);
  EXPECT_NEAR(values[4], moment, tolerance);
  // EA times the round-off of a strain.
  EXPECT_NEAR(values[5], 0, 1e-5);
  EXPECT_NEAR(values[6], .02 / 2 * moment, tolerance);
  EXPECT_NEAR(values[7], 2 * std::sin(moment / 2) / moment, tolerance);
}

TEST(FrameProbes, Twist)
{
  auto device = make_beam(make_moment("tip", {1, 0, 0}, 4));
  device.probes = {make_probe(Kind::rotation, "tip", 0),
                   make_probe(Kind::half_angle, "root, tip", 0),
                   make_probe(Kind::frame_moment, frame_name, 0, "middle"),
                   make_probe(Kind::frame_strain, frame_name)};
  Model model(device, make_polygon({{0, 0, 0}, {.5, 0, 0}, {1, 0, 0}}, 10));
  const auto values =
      evaluate(*model.structure, find_equilibrium(*model.structure, 4));
  // GJ = 2; twenty elements.
  const double error = get_element_error(2. / 20);
  EXPECT_NEAR(values[0], 2, error * 2);
  EXPECT_NEAR(values[1], 1, error);
  EXPECT_NEAR(values[2], 4, error * 4);
  EXPECT_NEAR(values[3], 0, 1e-9);
}

TEST(FrameProbes, HalfAngleOfAnArchIsItsEndSlope)
{
  // Held in the middle, both ends bent down by 1.5 rad.
  auto device = make_beam(make_moment("tip", {0, 1, 0}, 3), "middle");
  device.point_loads.push_back(make_moment("root", {0, -1, 0}, 3));
  device.probes = {make_probe(Kind::half_angle, "root, tip", 1),
                   make_probe(Kind::rotation, "tip", 1),
                   make_probe(Kind::rotation, "root", 1),
                   make_probe(Kind::position, "tip", 2)};
  Model model(device, make_polygon({{0, 0, 0}, {.5, 0, 0}, {1, 0, 0}}, 10));
  const auto values =
      evaluate(*model.structure, find_equilibrium(*model.structure, 4));
  const double error = 1.5 * get_element_error(3. / 20);
  EXPECT_NEAR(values[0], 1.5, error);
  EXPECT_NEAR(values[1], 1.5, error);
  EXPECT_NEAR(values[2], -1.5, error);
  EXPECT_LT(values[3], 0);
}

TEST(FrameProbes, ElementsThatRunAgainstEachOther)
{
  // Both lines run towards the corner. Axis 3 is y: the moment bends about it.
  auto device = make_beam(make_moment("tip", {0, 1, 0}, .3));
  device.frames[0].normal = {0, 1, 0};
  for (const char* at : {"root", "middle", "tip"})
    device.probes.push_back(make_probe(Kind::frame_moment, frame_name, 2, at));
  Model model(device, make_polygon({{0, 0, 0}, {1, 0, 0}, {1, 0, -1}}, 4));
  const auto values =
      evaluate(*model.structure, find_equilibrium(*model.structure, 1));
  // A constant moment; EI = 3, so the lines bend by .1 rad. Newton's tolerance.
  EXPECT_NEAR(values[0], .3, 1e-8);
  EXPECT_NEAR(values[1], .3, 1e-8);
  EXPECT_NEAR(values[2], -.3, 1e-8);
}

TEST(FrameProbes, FilmAndFrameTogether)
{
  Bow bow;
  bow.stand_off = .003;
  auto device = make_bow_device(bow);
  device.films[0].temperature = Signal::constant(310);
  device.frames[0].temperature = Signal::constant(320);
  device.probes = {make_probe(Kind::displacement, "north_east", 0),
                   make_probe(Kind::displacement, "beam_east", 0),
                   make_probe(Kind::position, "beam_east", 2),
                   make_probe(Kind::position, "north_east", 2),
                   make_probe(Kind::distance, "beam_west, north_east"),
                   make_probe(Kind::temperature, device.films[0].name),
                   make_probe(Kind::temperature, device.frames[0].name)};
  Model model(device, make_bow_mesh(bow));
  structure::Structure& structure = *model.structure;
  // The right body moves outwards with the ends of film and beam.
  const double step = .004;
  std::vector<double> u(structure.n_free(), 0.);
  const auto centre = structure.device_nodes().frames.bodies[1].centre;
  for (std::size_t i = 0; i < u.size(); ++i)
    if (structure.nodes().global(structure.free_unknowns()[i] / 3) == centre &&
        structure.free_unknowns()[i] % 3 == 0)
      u[i] = step;
  const auto values = evaluate(structure, u);
  EXPECT_NEAR(values[0], step, 1e-14);
  EXPECT_NEAR(values[1], step, 1e-14);
  EXPECT_NEAR(values[2], -bow.stand_off, 1e-14);
  EXPECT_NEAR(values[3], 0, 1e-14);
  EXPECT_NEAR(values[4],
              std::hypot(bow.length() + step, 2 * bow.width, bow.stand_off),
              1e-14);
  EXPECT_EQ(values[5], 310);
  EXPECT_EQ(values[6], 320);
}

TEST(FrameProbes, VelocityOfAFrame)
{
  auto device = make_beam(make_point_load("tip", {0, 0, 1}));
  device.frames[0].section.mass_per_length = 2;
  device.frames[0].section.rotary_inertia = {1, 1, 1};
  device.probes = {make_probe(Kind::velocity, "tip", 2),
                   make_probe_at(Kind::velocity, {.5, 0, 0}, 2)};
  Model model(device, make_polygon({{0, 0, 0}, {.5, 0, 0}, {1, 0, 0}}, 2));
  structure::InertialSystem system(*model.structure);
  structure::Probes probes(system);
  auto state =
      system.make_initial_state(0, structure::Start::relaxed, false, {});
  const auto first = system.velocities(state.data()) - state.data();
  // v_z = x in the mesh.
  const auto& nodes = model.structure->nodes();
  const auto& free = model.structure->free_unknowns();
  for (std::size_t i = 0; i < free.size(); ++i)
    if (free[i] % 3 == 2)
      state[first + i] = nodes.mesh_position[free[i] / 3][0];
  const auto values = probes.evaluate(0, state.data());
  EXPECT_DOUBLE_EQ(values[0], 1);
  EXPECT_DOUBLE_EQ(values[1], .5);
}

TEST(FrameProbes, PointOfFilmAndFrameMeansTheAxis)
{
  structure::Device device;
  device.films = {make_film(material::NeoHookean{1e5}, 1e-4, {{1, 1}})};
  device.frames = {make_frame("south", make_stiffnesses(1, 1, 1, 1, 1))};
  device.frames[0].offset = .003;
  device.supports = {make_support("film", {{true, false, true}}),
                     make_clamp("south")};
  device.probes = {make_probe(Kind::position, "south_west", 2),
                   make_probe(Kind::displacement, "south_west", 2),
                   make_probe(Kind::distance, "south_west, north_east")};
  Model model(device, make_rectangle(2, 2, 2, .04, .03));
  const auto values = evaluate(
      *model.structure, std::vector<double>(model.structure->n_free(), 0.));
  EXPECT_NEAR(values[0], -.003, 1e-15);
  EXPECT_NEAR(values[1], 0, 1e-15);
  EXPECT_NEAR(values[2], std::hypot(.04, .03, .003), 1e-15);
}

TEST(FrameProbes, RefusesWhatTheDeviceLacks)
{
  auto device = make_bow_device({});
  const auto mesh = make_bow_mesh({});
  const auto expect_refused = [&](const Probe& probe, const std::string& reason)
  {
    device.probes = {probe};
    Model model(device, mesh);
    structure::QuasiStaticSystem system(*model.structure, {});
    try
    {
      structure::Probes probes(system);
      ADD_FAILURE() << "not refused: " << reason;
    }
    catch (const BadInput& error)
    {
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos)
          << error.what();
      EXPECT_EQ(error.line(), 7u);
    }
  };
  expect_refused(make_probe(Kind::rotation, "north_east"), "no rotations");
  expect_refused(make_probe(Kind::half_angle, "beam_west, north_east"),
                 "no rotations");
  expect_refused(make_probe(Kind::half_angle, "beam_west"), "two");
  expect_refused(make_probe(Kind::rotation, "beam_wst"), "beam_west");
  expect_refused(make_probe(Kind::frame_strain, "frame on bean"), frame_name);
  expect_refused(make_probe(Kind::temperature, "fim"), "'film'");
  expect_refused(make_probe(Kind::frame_moment, frame_name, 0, "north_east"),
                 "no node of the frame");
  expect_refused(make_probe(Kind::frame_force, frame_name, 0, "beam_est"),
                 "beam_east");
  expect_refused(make_probe_at(Kind::position, {.01, .5, 0}, 0), "no node");
}
} // namespace
} // namespace taut::testing
