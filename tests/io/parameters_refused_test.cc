#include <taut/io/case_checks.h>

#include "io/refusal.h"

namespace taut::io
{
namespace
{
using testing::CaseOnDisk;
using testing::Refusal;
using testing::small_case;

std::string edit(const std::string& from, const std::string& to)
{
  return testing::edit(small_case, from, to);
}

class BadCase : public ::testing::TestWithParam<Refusal>
{
};

TEST_P(BadCase, IsRefusedWithFileLineAndKey)
{
  testing::expect_refused(small_case, GetParam());
}

const Refusal grammar[] = {
    {"unknown key", "  set Thickness = 1e-3\n  set Pre",
     "  set Thicknes = 1e-3\n  set Pre", "Thicknes =", "Film left/Thicknes",
     "did you mean 'Thickness'"},
    {"path for a key", "set Title = small", "set Film left/Thickness = 1e-3",
     "set Film left/", "Film left/Thickness", "unknown key"},
    {"unknown section", "subsection Film left", "subsection Flim left",
     "subsection Flim", "Flim left", "did you mean 'Film left'"},
    {"unknown two-word section", "subsection Edge load pull",
     "subsection Egde load pull", "subsection Egde", "Egde load pull",
     "did you mean 'Edge load pull'"},
    {"unknown inner section", "  subsection Dielectric",
     "  subsection Dielectrics", "subsection Dielectrics",
     "Material rubber/Dielectrics", "did you mean 'Dielectric'"},
    {"section without its name", "subsection Film left", "subsection Film",
     "subsection Film", "Film", "Film NAME"},
    {"key twice", "  set Thickness = 1e-3\n  set Pre",
     "  set Thickness = 1e-3\n  set  Thickness  = 2e-3\n  set Pre",
     "set  Thickness", "Film left/Thickness", "first in line 26"},
    {"section twice", "subsection Film right",
     "subsection Film left\nend\nsubsection Film right",
     "subsection Film left\nend", "Film left", "first in line 23"},
    {"missing end", "    set First step = 1e-5\n  end\n",
     "    set First step = 1e-5\n", "subsection Procedure", "Procedure",
     "'end' is missing"},
    {"too many ends", "subsection Film left", "end\nsubsection Film left",
     "end\nsubsection Film left", "", "one 'end' too many"},
    {"text after end", "end\nsubsection Film left",
     "end of material\nsubsection Film left", "end of", "Material rubber",
     "'of material' follows"},
    {"no statement", "set Title = small", "Title = small", "Title", "",
     "no statement"},
    {"misspelt statement", "set Title = small", "est Title = small", "est", "",
     "did you mean 'set'"},
    {"no equals sign", "set Title = small", "set Title small", "set Title",
     "Title small", "'=' is missing"},
    {"include", "set Title = small", "include other.prm", "include", "",
     "not supported"},
    {"missing key", "  set Mass = 0.02\n", "", "subsection Bar middle",
     "Bar middle/Mass", "missing"}};
INSTANTIATE_TEST_SUITE_P(Grammar, BadCase, ::testing::ValuesIn(grammar));

const Refusal values[] = {
    {"unit", "Shear modulus = 20e3", "Shear modulus = 20 kPa", "20 kPa",
     "Material rubber/Spring ground/Shear modulus", "here it is Pa"},
    {"unit without blank", "Thickness = 1e-3\n  set Pre",
     "Thickness = 0.5mm\n  set Pre", "0.5mm", "Film left/Thickness",
     "here it is m"},
    {"unit in a signal", "table(0: 0, 1: 5000)", "3 kV", "3 kV",
     "Electrode left/Voltage", "here it is V"},
    {"nan", "Density = 1000", "Density = nan", "nan", "Material rubber/Density",
     "not a finite number"},
    {"infinite", "Density = 1000", "Density = inf", "inf",
     "Material rubber/Density", "not a finite number"},
    {"decimal comma", "Density = 1000", "Density = 1000,5", "1000,5",
     "Material rubber/Density", "not a finite number"},
    {"negative thickness", "Thickness = 1e-3\n  set Pre",
     "Thickness = -1e-3\n  set Pre", "-1e-3", "Film left/Thickness", "above 0"},
    {"no thickness", "Thickness = 1e-3\n  set Pre", "Thickness = 0\n  set Pre",
     "Thickness = 0", "Film left/Thickness", "above 0"},
    {"negative modulus", "Shear modulus = 20e3", "Shear modulus = -20e3",
     "-20e3", "Material rubber/Spring ground/Shear modulus", "above 0"},
    {"no relaxation time", "Relaxation time = 100", "Relaxation time = 0",
     "Relaxation time", "Material rubber/Network slow/Relaxation time",
     "above 0"},
    {"negative mass", "Mass = 0.02", "Mass = -0.02", "Mass", "Bar middle/Mass",
     "0 or more"},
    {"permittivity below the vacuum's", "Relative permittivity = 4.7",
     "Relative permittivity = 0.5", "Relative permittivity",
     "Material rubber/Dielectric/Relative permittivity", "from 1"},
    {"three pre-stretches", "Pre-stretch = 2, 4", "Pre-stretch = 2, 4, 1",
     "Pre-stretch", "Film left/Pre-stretch", "2 numbers"},
    {"empty list", "Surfaces = left\n  set Material",
     "Surfaces =\n  set Material", "Surfaces =\n", "Film left/Surfaces",
     "a name is missing"},
    {"group listed twice", "Groups = edge", "Groups = edge, edge", "Groups",
     "Support frame/Groups", "'edge' is listed twice"},
    {"unknown word", "set Kind = tension loss", "set Kind = tension los",
     "tension los", "Event slack/Kind", "did you mean 'tension loss'"},
    {"unknown direction", "Held = x, y, z", "Held = x, w", "Held",
     "Support frame/Held", "'w' is no direction"},
    {"unknown law", "Law = Gent", "Law = Ghent", "Ghent",
     "Material rubber/Spring ground/Law", "did you mean 'Gent'"},
    {"key of another law", "Limit = 67", "Limit stretch = 67", "Limit stretch",
     "Material rubber/Spring ground/Limit stretch",
     "known are: Law, Shear modulus, Limit"},
    {"no whole number", "set End time = 2", "set Load steps = 2.5",
     "Load steps", "Procedure/Load steps", "whole number"},
    {"table back in time", "table(0: 0, 1: 5000)", "table(0: 0, 2: 1, 1: 5000)",
     "table(", "Electrode left/Voltage", "time"},
    {"bad expression", "0.1*sin(pi*y)", "0.1*sin(pi*w)", "Shape x",
     "Support frame/Shape x", "no expression in x, y, z"},
    {"geo parameter without number", "cells: 4", "cells", "set Parameters",
     "Mesh/Parameters", "'name: number'"},
    {"geo parameter twice", "cells: 4", "width: 4", "set Parameters",
     "Mesh/Parameters", "'width' is given twice"},
    {"mesh of another kind", "two.geo", "two.stl", "set File", "Mesh/File",
     ".geo or a .msh"}};
INSTANTIATE_TEST_SUITE_P(Values, BadCase, ::testing::ValuesIn(values));

const Refusal relations[] = {
    {"unknown material", "Material = rubber\n  set Thickness = 1e-3\n  set Pre",
     "Material = ruber\n  set Thickness = 1e-3\n  set Pre", "ruber",
     "Film left/Material", "did you mean 'rubber'"},
    {"unknown bar of a probe", "Of = middle", "Of = midle", "midle",
     "Probe swing/Of", "did you mean 'middle'"},
    {"unknown film of an event", "Of = left", "Of = lfet", "lfet",
     "Event slack/Of", "did you mean 'left'"},
    {"unknown probe of an event", "Of = swing", "Of = swnig", "swnig",
     "Event far/Of", "did you mean 'swing'"},
    {"unknown electrode in the comparison", "Electrode = left",
     "Electrode = lefd", "lefd", "Comparison/Electrode", "did you mean 'left'"},
    {"one film for both strips", "Passive film = right", "Passive film = left",
     "Passive film", "Comparison/Passive film", "must be two"},
    {"electrode without film", "Surfaces = left\n  set Voltage",
     "Surfaces = leftt\n  set Voltage", "leftt", "Electrode left/Surfaces",
     "did you mean 'left'"},
    {"group of two films", "Surfaces = right", "Surfaces = right, left",
     "right, left", "Film right/Surfaces", "'Film left' already"},
    {"limit exceeded by the pre-stretch", "Pre-stretch = 2, 4",
     "Pre-stretch = 2, 9", "Pre-stretch", "Film left/Pre-stretch",
     "is beyond the limit 70 of the Gent spring 1"},
    {"material of nothing", "subsection Material rubber\n",
     "subsection Material empty\n  set Density = 1\nend\n"
     "subsection Material rubber\n",
     "subsection Material empty", "Material empty", "neither a spring nor"},
    {"event without strength", "set Kind = tension loss\n  set Of = left",
     "set Kind = breakdown\n  set Threshold = 3", "set Threshold",
     "Event slack/Threshold", "no threshold"},
    {"support that holds nothing", "Held = x, y, z", "Held = none", "Held",
     "Support frame/Held", "holds nothing"},
    {"shape of a free component", "Held = x, y, z", "Held = y, z", "Shape x",
     "Support frame/Shape x", "does not list x"},
    {"shape without amplitude",
     "  set Amplitude = ramp(rate = 1, start = 0, limit = 1)\n", "",
     "subsection Support", "Support frame/Amplitude", "is zero"},
    {"amplitude without shape", "  set Shape x = 0.1*sin(pi*y)\n", "",
     "set Amplitude", "Support frame/Amplitude", "no Shape"},
    {"load without direction", "Direction = 0, 0, 1", "Direction = 0, 0, 0",
     "Direction", "Edge load pull/Direction", "no length"},
    {"axis without direction", "Pre-stretch = 2, 4", "Axis = 0, 0, 0", "Axis",
     "Film left/Axis", "no length"},
    {"probe without place", "  set Point = 0, 0.01, 0\n", "",
     "subsection Probe top", "Probe top/Point", "needs a place"},
    {"point of a named part", "Of = middle",
     "Of = middle\n  set Point = 1, 0, 0", "Point = 1", "Probe swing/Point",
     "no use for Point"},
    {"third axis of a film",
     "set Quantity = bar displacement\n  set Of = middle",
     "set Quantity = mean stress\n  set Of = left\n  set Component = z",
     "Component = z\nend\nsubsection Event", "Probe swing/Component",
     "first and second"},
    {"end before start", "set End time = 2", "set End time = 0", "set End time",
     "Procedure/End time", "must come after"},
    {"method without quasi-static runs", "set First step = 1e-5\n  end",
     "set Method = esdirk4\n  end\n  set Analysis = quasi-static", "set Method",
     "Procedure/Integrator/Method", "needs the method bdf"},
    {"output after the end", "History times = 0.5, 1.5",
     "History times = 0.5, 2.5", "History times", "Output/History times",
     "2.5 s is not between"},
    {"film sections of a resonator", "set Title = small",
     "set Model = resonator", "subsection Mesh", "Mesh", "Lumped resonator"},
    {"resonator in a film case", "subsection Mesh",
     "subsection Lumped resonator\nend\nsubsection Mesh", "subsection Lumped",
     "Lumped resonator", "allowed here are"}};
INSTANTIATE_TEST_SUITE_P(Relations, BadCase, ::testing::ValuesIn(relations));

/// Removes the section that starts with `first`, up to its end.
std::string without_section(const std::string& content,
                            const std::string& first)
{
  const std::size_t begin = content.find(first);
  const std::size_t end = content.find("\nend\n", begin) + 5;
  return content.substr(0, begin) + content.substr(end);
}

void expect_refused(const std::string& content, const std::string& says,
                    const std::vector<std::string>& overrides = {},
                    const std::string& name = "case.prm")
{
  const CaseOnDisk disk(content, name);
  try
  {
    read_case(disk.file(), overrides);
    FAIL() << "accepted, although: " << says;
  }
  catch (const BadInput& problem)
  {
    EXPECT_NE(std::string(problem.what()).find(says), std::string::npos)
        << problem.what();
  }
}

TEST(BadCases, FilmWithoutSupportIsRefused)
{
  expect_refused(without_section(small_case, "subsection Support"),
                 "no support");
}

TEST(BadCases, CaseWithoutFilmIsRefused)
{
  expect_refused("set Title = empty\nsubsection Mesh\nset File = a.geo\nend\n",
                 "no film");
}

TEST(BadCases, UnreadableAndEmptyFilesAreRefused)
{
  EXPECT_THROW(read_case("no/such/case.prm"), BadInput);
  expect_refused("# nothing\n", "holds no parameters");
}

TEST(BadCases, BreakdownOfAMaterialWithoutStrengthIsRefused)
{
  std::string content = edit("set Kind = tension loss", "set Kind = breakdown");
  const std::string strength = "    set Breakdown strength = 1e8\n";
  content.erase(content.find(strength), strength.size());
  expect_refused(content, "Breakdown strength");
}

TEST(BadCases, AFilmIsStretchedInItsFrameInStaticAnalysesOnly)
{
  const std::string share = "Film left/Pre-stretch share = ramp(1, 0, 1)";
  for (const char* analysis : {"transient", "quasi-static"})
    expect_refused(small_case, "only in static analyses",
                   {share, std::string("Procedure/Analysis = ") + analysis});
  const CaseOnDisk disk(small_case);
  for (const char* analysis : {"equilibrium", "continuation"})
    EXPECT_NO_THROW(read_case(
        disk.file(), {share, std::string("Procedure/Analysis = ") + analysis}));
}

TEST(BadCases, PathsNeedStepsAndASide)
{
  const std::string path = "Procedure/Continuation/";
  expect_refused(small_case, "has no length", {path + "Direction = 0, 0, 0"});
  expect_refused(small_case, "1", {path + "Steps = 0"});
  expect_refused(small_case, "2", {path + "Most points = 1"});
  expect_refused(small_case, "0.0001", {path + "Largest step = 0"});
  expect_refused(small_case, "stable", {path + "Branch = secondary"});
}

TEST(BadCases, RelaxedNetworksDoNotFeelThePreStretch)
{
  // The network's limit is passed by the pre-stretch only where it has just
  // been applied.
  const std::string network = "    set Law = neo-Hookean\n";
  std::string content =
      edit(network, "    set Law = Gent\n    set Limit = 5\n");
  const CaseOnDisk disk(content);
  EXPECT_NO_THROW(read_case(disk.file()));
  expect_refused(content, "is beyond the limit",
                 {"Procedure/Start = unrelaxed"});
}

const char* const resonator = R"(set Model = resonator
subsection Lumped resonator
  set Length active = 0.02
  set Length passive = 0.02
  set Width = 0.02
  set Thickness = 1e-3
  set Bar mass = 0.02
  set Density = 960
  set Shear modulus = 40e3
  set Breakdown strength = 1e8
  set Voltage = 0
end
)";

TEST(BadCases, LumpedResonatorSharesMustAddUp)
{
  const CaseOnDisk disk(resonator);
  EXPECT_NO_THROW(read_case(disk.file()));
  const std::string section = "Lumped resonator/";
  expect_refused(resonator, "are given", {section + "Equilibrium share = 0.5"});
  expect_refused(resonator, "2 shares are given for 1",
                 {section + "Equilibrium share = 0.5",
                  section + "Relaxation times = 1",
                  section + "Network shares = 0.2, 0.3"});
  expect_refused(resonator, "add up to 0.6",
                 {section + "Equilibrium share = 0.5",
                  section + "Relaxation times = 1, 2",
                  section + "Network shares = 0.2, 0.4"});
  expect_refused(resonator, "exceeds Limit", {section + "Pre-stretch = 2, 9"});
}

TEST(BadOverrides, NameTheOption)
{
  const auto refused = [](const std::string& option, const std::string& says)
  {
    const CaseOnDisk disk(small_case);
    try
    {
      read_case(disk.file(), {option});
      FAIL() << "accepted: " << option;
    }
    catch (const BadInput& problem)
    {
      EXPECT_EQ(problem.file(), "--set '" + option + "'");
      EXPECT_EQ(problem.line(), 0u);
      EXPECT_NE(problem.message().find(says), std::string::npos)
          << problem.what();
    }
  };
  refused("Film left/Thickness", "'Section/Key = value'");
  refused("Film left/Thickness = 1 mm", "carries a unit");
  refused("Film left/Thicknes = 1", "did you mean 'Thickness'");
  refused("Film lefd/Thickness = 1", "did you mean 'Film left'");
  refused("Film left/Pre-stretch = 9, 9", "is beyond the limit");
  refused("Title = a # b", "'#'");
}

TEST(BadOverrides, MustNotRepeatAKey)
{
  expect_refused(small_case, "overridden twice", {"Title = a", "Title = b"});
}

TEST(BadJson, IsRefusedWithItsLine)
{
  const auto refused =
      [](const std::string& content, unsigned int line, const std::string& says)
  {
    const CaseOnDisk disk(content, "case.json");
    try
    {
      read_case(disk.file());
      FAIL() << "accepted: " << content;
    }
    catch (const BadInput& problem)
    {
      EXPECT_EQ(problem.line(), line) << problem.what();
      EXPECT_NE(problem.message().find(says), std::string::npos)
          << problem.what();
    }
  };
  refused("{\n\"Titel\": \"a\"\n}", 2, "did you mean 'Title'");
  refused("{\n\"Title\": \"a\",\n\"Title\": \"b\"\n}", 3, "given twice");
  refused("{\n\"Title\": null\n}", 2, "null");
  refused("{\n\"Mesh\": {},\n\n\"Mesh\": {}\n}", 4, "given twice");
  refused("{\n\"Mesh\": [[1]]\n}", 2, "not arrays");
  refused("{\n\"Mesh\": [{}]\n}", 2, "not objects");
  refused("{\n\"Title\": \"a\"\n", 3, "not JSON");
  refused("3", 0, "JSON object");
}

TEST(BadDraft, FibresInAFilmThatWrinkles)
{
  const CaseText text = CaseText::parse(small_case, "case.prm");
  Declarations all;
  CaseDraft draft;
  declare_case(all, text, draft);
  all.assign(text);
  resolve_names(text, draft);
  structure::Film& film = draft.content.device.films.at(0);
  film.fibre_modulus = 1e6;
  try
  {
    check_case(text, draft);
    FAIL() << "accepted";
  }
  catch (const BadInput& error)
  {
    EXPECT_NE(std::string(error.what()).find("fibres carry compression"),
              std::string::npos)
        << error.what();
  }
  film.tension_field = false;
  EXPECT_NO_THROW(check_case(text, draft));
}
} // namespace
} // namespace taut::io
