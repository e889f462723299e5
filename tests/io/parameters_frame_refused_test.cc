// Cases with frames that must be refused.
#include "io/frame_case.h"
#include "io/refusal.h"

namespace taut::io
{
namespace
{
using testing::CaseOnDisk;
using testing::frame_case;
using testing::free_frame;
using testing::Refusal;

class BadFrame : public ::testing::TestWithParam<Refusal>
{
};

TEST_P(BadFrame, IsRefusedWithFileLineAndKey)
{
  testing::expect_refused(frame_case, GetParam());
}

const Refusal frame_values[] = {
    {"no thickness", "Thickness = 0.8e-3", "Thickness = 0", "Thickness = 0\n",
     "Frame legs/Thickness", "above 0"},
    {"negative thickness", "Thickness = 0.8e-3", "Thickness = -1e-3", "-1e-3",
     "Frame legs/Thickness", "above 0"},
    {"no width", "Width = 5e-3", "Width = 0", "Width = 0", "Frame legs/Width",
     "above 0"},
    {"no modulus", "Young modulus = 2e9", "Young modulus = 0", "Young",
     "Frame legs/Young modulus", "above 0"},
    {"unit", "Young modulus = 2e9", "Young modulus = 2 GPa", "Young",
     "Frame legs/Young modulus", "here it is Pa"},
    {"Poisson ratio of no solid", "Density = 1050",
     "Poisson ratio = 0.6\n  set Density = 1050", "Poisson",
     "Frame legs/Poisson ratio", "from 0 to 0.5"},
    {"no bending stiffness", "5e-3, 6e-3", "0, 6e-3", "set Bending",
     "Frame ends/Bending stiffness", "above 0"},
    {"one shear stiffness", "2e3, 3e3", "2e3", "set Shear stiffness",
     "Frame ends/Shear stiffness", "2 numbers"},
    {"key of a rectangle", "Axial stiffness = 1e4",
     "Width = 1\n  set Axial stiffness = 1e4", "Width = 1", "Frame ends/Width",
     "unknown key"},
    {"misspelt key", "Torsional stiffness", "Torsion stiffness", "Torsion ",
     "Frame ends/Torsion stiffness", "did you mean 'Torsional stiffness'"},
    {"unknown section", "Section = stiffnesses", "Section = stiffness",
     "Section = ", "Frame ends/Section", "did you mean 'stiffnesses'"},
    {"unknown attachment", "Attachment = at", "Attachment = all", "Attachment",
     "Frame legs/Attachment", "along"},
    {"offset in words", "half thickness", "half the thickness", "set Offset",
     "Frame legs/Offset", "or 'half thickness'"},
    {"negative damping", "Stiffness damping = 1e-4", "Stiffness damping = -1",
     "set Stiffness", "Frame legs/Stiffness damping", "0 or more"},
    {"negative mass", "Mass = 0.02", "Mass = -0.02", "Mass = -0.02",
     "Rigid body bar/Mass", "0 or more"},
    {"centre in words", "Centre = 0, 0, 0.01", "Centre = middle", "set Centre",
     "Rigid body bar/Centre", "'mean of its nodes'"},
    {"misspelt body", "subsection Rigid body bar", "subsection Rigid bdoy bar",
     "subsection Rigid bdoy", "Rigid bdoy bar",
     "did you mean 'Rigid body bar'"},
    {"target of a support", "Acts on = frame", "Acts on = frames", "Acts on",
     "Support middle/Acts on", "did you mean 'frame'"},
    {"unknown quantity", "half angle", "half angel", "half angel",
     "Probe opening/Quantity", "did you mean 'half angle'"},
    {"perturbation", "Perturbation = 0.02", "Perturbation = 0",
     "set Perturbation", "Procedure/Rest shape/Perturbation", "above 0"},
    {"softer at first", "First stiffness = 30", "First stiffness = 0.5",
     "set First", "Procedure/Rest shape/First stiffness", "from 1"},
    {"unknown shape", "Start shape = rest", "Start shape = curled",
     "set Start shape", "Procedure/Start shape", "equilibrium"}};
INSTANTIATE_TEST_SUITE_P(Values, BadFrame, ::testing::ValuesIn(frame_values));

const Refusal frame_relations[] = {
    {"attachment without place", "  set Attached at = corner_left, bar_right\n",
     "", "subsection Frame legs", "Frame legs/Attached at",
     "needs the points or lines"},
    {"place without attachment", "set Attachment = at",
     "set Attachment = along", "set Attached", "Frame legs/Attached at",
     "Attachment = at only"},
    {"offset beyond the width", "Offset = half thickness", "Offset = -5.1e-3",
     "set Offset", "Frame legs/Offset", "more than the width 0.005 m"},
    {"half of no thickness", "Depth = 1e-3", "Offset  = half thickness",
     "set Offset  =", "Frame ends/Offset", "give Depth"},
    {"temperature beyond the law", "steps(0: 299, 0.5: 340)", "400",
     "set Temperature", "Frame legs/Temperature", "from 273 K to 361 K"},
    {"temperature that leaves the law", "0.5: 340", "0.5: 340, 0.7: 272",
     "set Temperature", "Frame legs/Temperature",
     "reaches 272 K, but the Modulus law"},
    {"temperature that leaves the law between kinks", "steps(0: 299, 0.5: 340)",
     "sine(offset = 320, amplitude = 60, frequency = 4, phase = 0)",
     "set Temperature", "Frame legs/Temperature", "from 273 K to 361 K"},
    {"unknown law", "polynomial(299, 273, 361; -0.006)",
     "wang_2024_frame_moduls", "set Modulus law", "Frame legs/Modulus law",
     "did you mean 'wang_2024_frame_modulus'"},
    {"normal without direction", "Normal = 0, 0, 2", "Normal = 0, 0, 0",
     "set Normal", "Frame legs/Normal", "no length"},
    {"line of two frames", "Lines = end_left, end_right",
     "Lines = end_left, leg_back", "end_left, leg_back", "Frame ends/Lines",
     "'Frame legs' already"},
    {"point of two hinges", "subsection Rigid body bar",
     "subsection Hinge two\n  set Points = corner_left\nend\nsubsection Rigid "
     "body bar",
     "set Points = corner_left\nend\nsubsection Rigid", "Hinge two/Points",
     "'Hinge corner' already"},
    {"group of two bodies", "Groups = bar_right", "Groups = bar_left",
     "set Groups = bar_left\nend", "Rigid body other/Groups",
     "'Rigid body bar' already"},
    {"rotations of a film", "Acts on = frame", "Acts on = film",
     "set Held rotations", "Support middle/Held rotations",
     "films have no rotations"},
    {"support that holds nothing", "Held = x, z\n  set Held rotations = y",
     "Held = none", "set Held", "Support middle/Held", "holds nothing"},
    {"mass of nothing", "Mass = 0.5e-3\n  set Rotary inertia = 1e-5, 0, 0",
     "Mass = 0", "Mass = 0\n", "Point mass tip/Mass", "neither mass nor"},
    {"force without direction", "Force direction = 0, 0, 1",
     "Force direction = 0, 0, 0", "set Force direction",
     "Point load pull/Force direction", "no length"},
    {"direction without force", "  set Force = 2\n", "",
     "subsection Point load", "Point load pull/Force",
     "Force direction is given"},
    {"moment without direction", "  set Moment direction = 0, 1, 0\n", "",
     "subsection Point load", "Point load pull/Moment direction", "no length"},
    {"load of nothing",
     "  set Force direction = 0, 0, 1\n  set Force = 2\n  set Moment direction "
     "= 0, 1, 0\n  set Moment = 0.25\n",
     "", "subsection Point load", "Point load pull/Force",
     "neither a force nor a moment"},
    {"unknown frame of a probe", "Of = legs\n  set At", "Of = lesg\n  set At",
     "lesg", "Probe moment/Of", "did you mean 'legs'"},
    {"temperature of neither film nor frame",
     "Quantity = temperature\n  set Of = legs",
     "Quantity = temperature\n  set Of = leg", "Of = leg\n", "Probe heat/Of",
     "there is no film or frame 'leg'"},
    {"temperature of a film or a frame", "subsection Film film",
     "subsection Film legs", "Of = legs\nend\nsubsection Procedure",
     "Probe heat/Of", "both called 'legs'"},
    {"angle at one point", "Of = end_left, end_right", "Of = end_left",
     "Of = end_left\n", "Probe opening/Of", "two physical points"},
    {"distance of a point to itself",
     "Quantity = distance\n  set Of = end_left, end_right",
     "Quantity = distance\n  set Of = end_left, end_left",
     "Of = end_left, end_left", "Probe chord/Of", "two physical points"},
    {"moment without a place", "  set At = leg_middle\n", "",
     "subsection Probe moment", "Probe moment/Point", "At for a group"},
    {"moment at two places", "set At = leg_middle",
     "set At = leg_middle\n  set Point = 0, 0, 1", "set Point = 0, 0, 1",
     "Probe moment/Point", "no use for Point"},
    {"strain at a place", "Quantity = frame strain",
     "At = leg_middle\n  set Quantity = frame strain",
     "At = leg_middle\n  set Quantity", "Probe strain/At",
     "only a frame force or frame moment"},
    {"rotation without a place", "  set Of = corner_left\n", "",
     "subsection Probe turn", "Probe turn/Point", "Of for a group"},
    {"rest shape without side", "Direction = 0, 0, -1", "Direction = 0, 0, 0",
     "set Direction = 0, 0, 0", "Procedure/Rest shape/Direction", "no length"}};
INSTANTIATE_TEST_SUITE_P(Relations, BadFrame,
                         ::testing::ValuesIn(frame_relations));

class BadFreeFrame : public ::testing::TestWithParam<Refusal>
{
};

TEST_P(BadFreeFrame, IsRefusedWithFileLineAndKey)
{
  testing::expect_refused(free_frame, GetParam());
}

const Refusal without_film[] = {
    {"equilibrium without support", "set Start shape = meshed",
     "set Start shape = equilibrium", nullptr, "", "drift freely"},
    {"statics without support", "set Start shape = meshed",
     "set Start shape = meshed\n  set Analysis = equilibrium", nullptr, "",
     "drift freely"},
    {"support of films", "subsection Procedure",
     "subsection Support end\n  set Groups = end\n  set Acts on = "
     "film\nend\nsubsection Procedure",
     "set Acts on", "Support end/Acts on", "no film"},
    {"no film to attach", "  set Density = 0",
     "  set Density = 0\n  set Attachment = at\n  set Attached at = end",
     "set Attachment", "Frame beam/Attachment", "no film"}};
INSTANTIATE_TEST_SUITE_P(WithoutFilm, BadFreeFrame,
                         ::testing::ValuesIn(without_film));

/// A film alone turns nowhere.
class BadFilm : public ::testing::TestWithParam<Refusal>
{
protected:
  static std::string get_case()
  {
    std::string content = frame_case;
    const std::size_t frames = content.find("subsection Frame legs");
    return content.substr(0, frames) + R"(subsection Support edge
  set Groups = edge
end
)";
  }
};

TEST_P(BadFilm, IsRefusedWithFileLineAndKey)
{
  const CaseOnDisk disk(get_case());
  EXPECT_NO_THROW(read_case(disk.file()));
  testing::expect_refused(get_case(), GetParam());
}

const Refusal without_frame[] = {
    {"hinge", "subsection Support edge",
     "subsection Hinge a\n  set Points = p\nend\nsubsection Support edge",
     "subsection Hinge", "Hinge a", "no frame"},
    {"held rotations", "  set Groups = edge",
     "  set Groups = edge\n  set Held rotations = x", "set Held",
     "Support edge/Held rotations", "neither a frame nor a rigid body"},
    {"support of frames", "  set Groups = edge",
     "  set Groups = edge\n  set Acts on = frame", "set Acts on",
     "Support edge/Acts on", "neither a frame nor a rigid body"},
    {"rotary inertia", "subsection Support edge",
     "subsection Point mass a\n  set Points = p\n  set Mass = 1\n  set Rotary "
     "inertia = 1, 1, 1\nend\nsubsection Support edge",
     "set Rotary", "Point mass a/Rotary inertia", "takes mass only"},
    {"moment", "subsection Support edge",
     "subsection Point load a\n  set Points = p\n  set Moment = 1\n  set "
     "Moment direction = 1, 0, 0\nend\nsubsection Support edge",
     "set Moment = 1", "Point load a/Moment", "could turn"},
    {"follower", "subsection Support edge",
     "subsection Point load a\n  set Points = p\n  set Force = 1\n  set Force "
     "direction = 1, 0, 0\n  set Follower = true\nend\nsubsection Support edge",
     "set Follower", "Point load a/Follower", "could turn"},
    {"rest shape", "subsection Support edge",
     "subsection Procedure\n  set Start shape = rest\nend\nsubsection Support "
     "edge",
     "set Start shape", "Procedure/Start shape", "needs a frame that bends"}};
INSTANTIATE_TEST_SUITE_P(WithoutFrame, BadFilm,
                         ::testing::ValuesIn(without_frame));
} // namespace
} // namespace taut::io
