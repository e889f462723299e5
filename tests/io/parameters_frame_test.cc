// Sections of frames and of what goes with them, as they arrive.
#include <gtest/gtest.h>

#include "io/frame_case.h"
#include "io/small_case.h"

namespace taut::io
{
namespace
{
using structure::Frame;
using structure::Probe;
using structure::Support;
using testing::CaseOnDisk;
using testing::frame_case;
using testing::free_frame;
using Names = std::vector<std::string>;
using Vector = std::array<double, 3>;

study::Case read(const std::string& content,
                 const std::vector<std::string>& overrides = {})
{
  const CaseOnDisk disk(content);
  return read_case(disk.file(), overrides);
}

TEST(FrameParameters, RectanglesArriveAsTheirSection)
{
  const Frame frame = read(frame_case).device.frames.at(0);
  EXPECT_EQ(frame.name, "legs");
  EXPECT_EQ(frame.source_line, 16u);
  EXPECT_EQ(frame.groups, (Names{"leg_front", "leg_back"}));
  structure::RectangularSection rectangle;
  rectangle.width = 5e-3;
  rectangle.thickness = .8e-3;
  rectangle.young_modulus = 2e9;
  rectangle.density = 1050;
  const structure::BeamSection expected = structure::make_section(rectangle);
  EXPECT_EQ(frame.section.axial_stiffness, expected.axial_stiffness);
  EXPECT_EQ(frame.section.torsional_stiffness, expected.torsional_stiffness);
  EXPECT_EQ(frame.section.bending_stiffness, expected.bending_stiffness);
  EXPECT_EQ(frame.section.mass_per_length, expected.mass_per_length);
  EXPECT_EQ(frame.section.thickness, .8e-3);
  EXPECT_EQ(frame.offset, .4e-3);
  EXPECT_EQ(frame.normal, (Vector{{0, 0, 2}}));
  EXPECT_EQ(frame.attachment, Frame::Attachment::at);
  EXPECT_EQ(frame.attached_at, (Names{"corner_left", "bar_right"}));
  EXPECT_EQ(frame.temperature.value(20), 340);
  const auto& law = std::get<material::PolynomialLaw>(frame.modulus_law);
  EXPECT_EQ(law.coefficients, std::vector<double>{-.006});
  EXPECT_EQ(law.highest, 361);
  EXPECT_EQ(frame.mass_damping, 3);
  EXPECT_EQ(frame.stiffness_damping, 1e-4);
}

TEST(FrameParameters, GeneralSectionsKeepTheirNumbers)
{
  const Frame frame = read(frame_case).device.frames.at(1);
  const structure::BeamSection& section = frame.section;
  EXPECT_EQ(section.axial_stiffness, 1e4);
  EXPECT_EQ(section.shear_stiffness, (std::array<double, 2>{{2e3, 3e3}}));
  EXPECT_EQ(section.torsional_stiffness, 4e-3);
  EXPECT_EQ(section.bending_stiffness, (std::array<double, 2>{{5e-3, 6e-3}}));
  EXPECT_EQ(section.mass_per_length, .007);
  EXPECT_EQ(section.rotary_inertia, (Vector{{1e-8, 2e-8, 3e-8}}));
  EXPECT_EQ(section.thickness, 1e-3);
  EXPECT_EQ(frame.offset, 0);
  EXPECT_TRUE(std::holds_alternative<material::ConstantLaw>(frame.modulus_law));
  EXPECT_EQ(frame.attachment, Frame::Attachment::along);
  EXPECT_TRUE(frame.attached_at.empty());
  EXPECT_EQ(read(frame_case, {"Frame ends/Offset = half thickness"})
                .device.frames[1]
                .offset,
            .5e-3);
}

TEST(FrameParameters, JointsBodiesAndLoadsArrive)
{
  const structure::Device device = read(frame_case).device;
  EXPECT_EQ(device.hinges.at(0).groups, Names{"corner_left"});
  const structure::RigidBody& body = device.bodies.at(0);
  EXPECT_EQ(body.groups, Names{"bar_left"});
  ASSERT_TRUE(body.centre);
  EXPECT_EQ(*body.centre, (Vector{{0, 0, .01}}));
  EXPECT_EQ(body.mass, .02);
  EXPECT_EQ(body.rotary_inertia, (Vector{{1e-6, 2e-6, 3e-6}}));
  EXPECT_FALSE(device.bodies.at(1).centre);
  EXPECT_EQ(device.bodies.at(1).mass, 0);
  EXPECT_EQ(device.masses.at(0).mass, .5e-3);
  EXPECT_EQ(device.masses.at(0).rotary_inertia, (Vector{{1e-5, 0, 0}}));
  const structure::PointLoad& load = device.point_loads.at(0);
  EXPECT_EQ(load.force_direction, (Vector{{0, 0, 1}}));
  EXPECT_EQ(load.force.value(0), 2);
  EXPECT_EQ(load.moment_direction, (Vector{{0, 1, 0}}));
  EXPECT_EQ(load.moment.value(0), .25);
  EXPECT_TRUE(load.follower);
  const Support& support = device.supports.at(0);
  EXPECT_EQ(support.target, Support::Target::frame);
  EXPECT_EQ(support.held, (std::array<bool, 3>{{true, false, true}}));
  EXPECT_EQ(support.held_rotations,
            (std::array<bool, 3>{{false, true, false}}));
}

TEST(FrameParameters, ProbesOfFramesArrive)
{
  const auto probes = read(frame_case).device.probes;
  const std::vector<Probe::Kind> kinds{
      Probe::Kind::rotation,    Probe::Kind::half_angle,
      Probe::Kind::distance,    Probe::Kind::frame_moment,
      Probe::Kind::frame_force, Probe::Kind::frame_strain,
      Probe::Kind::temperature};
  ASSERT_EQ(probes.size(), kinds.size());
  for (std::size_t i = 0; i < kinds.size(); ++i)
    EXPECT_EQ(probes[i].kind, kinds[i]);
  EXPECT_EQ(probes[1].of, "end_left, end_right");
  EXPECT_EQ(probes[1].component, 1u);
  EXPECT_EQ(probes[3].at, "leg_middle");
  EXPECT_EQ(probes[4].point, (Vector{{0, .02, 0}}));
}

TEST(FrameParameters, WayToTheRestShapeArrives)
{
  const study::ProcedureDescription procedure = read(frame_case).procedure;
  EXPECT_EQ(procedure.shape, study::Shape::rest);
  EXPECT_EQ(procedure.rest_shape.direction, (Vector{{0, 0, -1}}));
  EXPECT_EQ(procedure.rest_shape.perturbation, .02);
  EXPECT_EQ(procedure.rest_shape.first_stiffness, 30);
  EXPECT_EQ(procedure.rest_shape.steps, 12u);
  EXPECT_TRUE(procedure.rest_shape.both_branches);
}

TEST(FrameParameters, EffectiveParametersReadBackAsTheSameCase)
{
  const CaseOnDisk original(frame_case);
  const std::string first =
      read_case_file(original.file()).effective_parameters;
  const CaseOnDisk copy(first);
  EXPECT_EQ(read_case_file(copy.file()).effective_parameters, first);
}

TEST(FrameParameters, FramesNeedNoFilmAndMayFly)
{
  const study::Case flying = read(free_frame);
  EXPECT_TRUE(flying.device.films.empty());
  EXPECT_EQ(flying.procedure.shape, study::Shape::meshed);
  EXPECT_EQ(flying.device.frames.at(0).section.mass_per_length, 0);
}
} // namespace
} // namespace taut::io
