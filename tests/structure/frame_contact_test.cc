// Frames that touch themselves or each other.
#include <taut/base/exceptions.h>
#include <taut/structure/frame_contact.h>
#include <taut/structure/watches.h>

#include <gtest/gtest.h>

#include <cmath>

#include "structure/frames.h"
#include "structure/watch_refusal.h"
#include <boost/math/tools/roots.hpp>

namespace taut::testing::contact
{
namespace
{
using structure::compute_segment_distance;

TEST(SegmentDistance, InsideAtEndsAndParallel)
{
  using P = std::array<double, 3>;
  const P o{{0, 0, 0}}, x{{2, 0, 0}};
  // Crossing at a distance of 3.
  EXPECT_DOUBLE_EQ(compute_segment_distance(o, x, P{{1, -1, 3}}, P{{1, 1, 3}}),
                   3);
  // Meeting.
  EXPECT_DOUBLE_EQ(compute_segment_distance(o, x, P{{1, -1, 0}}, P{{1, 1, 0}}),
                   0);
  // An end against the inside, and two ends.
  EXPECT_DOUBLE_EQ(compute_segment_distance(o, x, P{{1, 1, 0}}, P{{1, 4, 0}}),
                   1);
  EXPECT_DOUBLE_EQ(compute_segment_distance(o, x, P{{5, 4, 0}}, P{{9, 9, 0}}),
                   5);
  // Parallel beside, and one behind the other.
  EXPECT_DOUBLE_EQ(compute_segment_distance(o, x, P{{1, 2, 0}}, P{{5, 2, 0}}),
                   2);
  EXPECT_DOUBLE_EQ(compute_segment_distance(o, x, P{{3, 0, 0}}, P{{5, 0, 0}}),
                   1);
  // A point.
  EXPECT_DOUBLE_EQ(compute_segment_distance(o, x, P{{1, 2, 0}}, P{{1, 2, 0}}),
                   2);
}

constexpr double length = 10, bending = 100, thickness = .1;

structure::EventDescription make_event(const std::string& of = "",
                                       const double gap = 0)
{
  structure::EventDescription event;
  event.name = "touch";
  event.kind = structure::EventDescription::Kind::self_contact;
  event.of = of;
  event.threshold = gap;
  return event;
}

/// A cantilever with a moment at its tip.
structure::Device make_rolled()
{
  structure::Device device;
  auto section = make_stiffnesses(1e6, 1e6, bending, bending, bending);
  section.thickness = thickness;
  device.frames = {make_frame("beam", section)};
  device.supports = {make_clamp("root")};
  device.point_loads = {make_point_load("tip", {0, 0, 0})};
  device.point_loads[0].moment_direction = {{0, -1, 0}};
  device.point_loads[0].moment = Signal::ramp(1, 0, 1e9);
  device.events = {make_event()};
  return device;
}

fe::MeshData make_beam(const unsigned int n)
{
  auto mesh = make_line_mesh();
  const auto ends =
      add_line(mesh, "beam", n, make_straight({0, 0, 0}, {length, 0, 0}));
  name_point(mesh, ends[0], "root");
  name_point(mesh, ends[1], "tip");
  fe::add_empty_surface(mesh);
  return mesh;
}

TEST(SelfContact, OfARolledUpFrameIsWhereTheCircleCloses)
{
  // The ends of the arc of curvature M/EI are 2 sin(L M/(2 EI)) EI/M apart;
  // their faces touch where that is the thickness, just before the circle
  // closes at M = 2 pi EI/L.
  const auto compute_chord = [](const double moment)
  { return 2 * bending / moment * std::sin(length * moment / (2 * bending)); };
  const double circle = 2 * M_PI * bending / length;
  std::uintmax_t iterations = 100;
  const double closure =
      boost::math::tools::toms748_solve(
          [&](const double moment)
          { return compute_chord(moment) - thickness; },
          .9 * circle, circle, boost::math::tools::eps_tolerance<double>(40),
          iterations)
          .first;
  const Model model(make_rolled(), make_beam(20));
  structure::QuasiStaticSystem system(*model.structure, {});
  structure::Probes probes(system);
  structure::Watches watches(system, probes);
  // The moment is the time.
  structure::Equilibrium problem(*model.structure, system.history(),
                                 structure::Networks::as_given, nullptr);
  auto state =
      system.make_initial_state(0, structure::Start::unrelaxed, false, {});
  EXPECT_NEAR(watches.compute_margin(0, 0, state.data()), 1, 1e-12);
  time::PathOptions options;
  options.first_step = options.largest_step = closure / 20;
  options.smallest_step = 1e-3;
  double reached = 0;
  // Pieces of 20 quadratic elements on a circle.
  constexpr double tolerance = 2e-3;
  for (const double share : {.5, .8, .99, 1 - 1e-3, 1 + 1e-3})
  {
    follow_path(problem, reached, share * closure, state.data(), options,
                [](double, const double*) {});
    reached = share * closure;
    const auto report = watches.report(0, reached, state.data());
    EXPECT_EQ(report.place, "frame on beam");
    EXPECT_EQ(report.margin<0, share> 1);
    EXPECT_EQ(report.margin, watches.compute_margin(0, reached, state.data()));
    // The ends of a half circle are not yet what is closest to touching.
    if (share < .8)
      continue;
    EXPECT_NEAR(report.value, compute_chord(reached) - thickness, tolerance);
    // In the mesh the first and the last element are all others apart.
    EXPECT_NEAR(report.margin, report.value / (18. / 20 * length - thickness),
                1e-12);
  }
}

/// Two parallel beams of three elements, a distance of .5 apart along z.
fe::MeshData make_two()
{
  auto mesh = make_line_mesh();
  const auto lower =
      add_line(mesh, "lower", 3, make_straight({0, 0, 0}, {3, 0, 0}));
  const auto upper =
      add_line(mesh, "upper", 3, make_straight({0, 0, .5}, {3, 0, .5}));
  name_point(mesh, lower[0], "a");
  name_point(mesh, upper[0], "b");
  fe::add_empty_surface(mesh);
  return mesh;
}

structure::Device make_two_frames()
{
  structure::Device device;
  auto section = make_stiffnesses(1e6, 1e6, 1, 1, 1);
  section.thickness = thickness;
  device.frames = {make_frame("lower", section), make_frame("upper", section)};
  device.frames[1].section.thickness = 2 * thickness;
  device.supports = {make_clamp("a"), make_clamp("b")};
  return device;
}

TEST(SelfContact, OfTwoFramesNamesBothAndTheMiddleOfTheElement)
{
  auto device = make_two_frames();
  device.events = {make_event("upper"), make_event("", .05)};
  device.events[0].of = device.frames[1].name;
  const Model model(device, make_two());
  structure::QuasiStaticSystem system(*model.structure, {});
  structure::Probes probes(system);
  structure::Watches watches(system, probes);
  auto state =
      system.make_initial_state(0, structure::Start::unrelaxed, false, {});
  // The lower beam bends up by z = .3 (x/3)^2 as far as its nodes say; clamped
  // at x = 0.
  const auto& structure = *model.structure;
  const auto& free = structure.free_unknowns();
  for (std::size_t i = 0; i < free.size(); ++i)
  {
    const auto& x = structure.nodes().mesh_position[free[i] / 3];
    if (free[i] % 3 == 2 && x[0] > 0 && x[2] == 0)
      state[i] = .3 * std::pow(x[0] / 3, 2);
  }
  const double gap = .5 - .3 - 1.5 * thickness;
  const auto report = watches.report(0, 0, state.data());
  EXPECT_NEAR(report.value, gap, 1e-12);
  EXPECT_NEAR(report.margin, gap / (.5 - 1.5 * thickness), 1e-12);
  EXPECT_EQ(report.place,
            device.frames[0].name + " + " + device.frames[1].name);
  EXPECT_NEAR(report.point[0], 2.5, 1e-12);
  EXPECT_NEAR(watches.compute_margin(1, 0, state.data()),
              (gap - .05) / (.5 - 1.5 * thickness - .05), 1e-12);
}

std::string get_refusal(const structure::Device& device,
                        const fe::MeshData& mesh)
{
  const Model model(device, mesh);
  structure::QuasiStaticSystem system(*model.structure, {});
  return get_watch_refusal(system);
}

TEST(SelfContact, RefusesWhatCannotBeWatched)
{
  auto device = make_two_frames();
  device.events = {make_event("middle")};
  expect_contains(get_refusal(device, make_two()),
                  "there is no frame 'middle'");
  device.events = {make_event("", -1)};
  expect_contains(get_refusal(device, make_two()), "0 or more");
  device.events = {make_event("", .4)};
  expect_contains(get_refusal(device, make_two()), "apart in the mesh");
  device = make_rolled();
  expect_contains(get_refusal(device, make_beam(2)), "could touch");
}

TEST(SelfContact, NeighboursAreThoseWithinFourThicknesses)
{
  // Elements of .5: those up to .4 of way apart, the next ones, share a node;
  // with a thickness of .2 the way of .5 over one element counts as well.
  const auto get_closest = [](const double of_thickness)
  {
    auto device = make_rolled();
    device.events.clear();
    device.frames[0].section.thickness = of_thickness;
    const Model model(device, make_beam(20));
    return structure::FrameContact(*model.structure, std::nullopt)
        .get_closest_in_mesh()
        .mesh_distance;
  };
  EXPECT_NEAR(get_closest(.1), .5 - .1, 1e-12);
  EXPECT_NEAR(get_closest(.2), 1 - .2, 1e-12);
}
} // namespace
} // namespace taut::testing::contact
