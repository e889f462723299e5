// Laws of the breakdown strength, and the events of failure.
#include <taut/io/formats.h>

#include "io/refusal.h"

namespace taut::io::failure
{
namespace
{
using testing::CaseOnDisk;
using testing::Refusal;
using testing::small_case;

TEST(FailureCase, BreakdownFollowsItsLaw)
{
  const CaseOnDisk disk(small_case);
  const auto read = [&](const std::string& law)
  {
    return read_case(disk.file(),
                     {"Material rubber/Dielectric/Breakdown law = " + law})
        .device.films.at(1)
        .material.dielectric.breakdown;
  };
  EXPECT_TRUE(read("constant").factors.empty());
  const auto law = read("stretch(0.63; 1, 6)*thickness( 1e-3,.25; 0, 1e-2 ) * "
                        "temperature(arrhenius(300, 5e3)) * "
                        "rate(1e6, 0.1; 1, 1e9)");
  EXPECT_EQ(law.reference, 1e8);
  ASSERT_EQ(law.factors.size(), 4u);
  const auto& stretch = std::get<material::StretchStrength>(law.factors[0]);
  EXPECT_EQ(stretch.exponent, .63);
  EXPECT_EQ(stretch.range.highest, 6);
  const auto& thickness = std::get<material::ThicknessStrength>(law.factors[1]);
  EXPECT_EQ(thickness.reference, 1e-3);
  EXPECT_EQ(thickness.exponent, .25);
  EXPECT_EQ(thickness.range.lowest, 0);
  EXPECT_EQ(std::get<material::ArrheniusLaw>(
                std::get<material::TemperatureStrength>(law.factors[2]).law)
                .activation_energy,
            5e3);
  const auto& rate = std::get<material::RateStrength>(law.factors[3]);
  EXPECT_EQ(rate.reference, 1e6);
  EXPECT_EQ(rate.bounds.lowest, 1);
  const Format<std::vector<material::StrengthFactor>> format =
      strength_factors();
  for (const std::string text :
       {"constant", "stretch(0.63; 1, 6) * thickness(0.001, 0.25; 0, 0.01)",
        "rate(1e+06, 0.1; 1, 1e+09)", "temperature(arrhenius(300, 5000))",
        "humidity(exponential(0.2, -0.5))"})
    EXPECT_EQ(format.write(format.read(text)), text);
}

TEST(FailureCase, EventsOfDevices)
{
  const CaseOnDisk disk(small_case);
  using Kind = structure::EventDescription::Kind;
  const auto read = [&](const std::string& kind, const std::string& of)
  {
    return read_case(disk.file(),
                     {"Event slack/Kind = " + kind, "Event slack/Of = " + of})
        .device.events.at(0)
        .kind;
  };
  EXPECT_EQ(read("pull-in", ""), Kind::pull_in);
  EXPECT_EQ(read("snap-through", "swing"), Kind::snap_through);
  EXPECT_EQ(read("self-contact", ""), Kind::self_contact);
}

class BadFailure : public ::testing::TestWithParam<Refusal>
{
};

TEST_P(BadFailure, IsRefusedWithFileLineAndKey)
{
  testing::expect_refused(small_case, GetParam());
}

const char* const strength = "set Breakdown strength = 1e8";
const char* const law = "Material rubber/Dielectric/Breakdown law";

const Refusal laws[] = {
    {"unknown factor", strength,
     "set Breakdown strength = 1e8\n    set Breakdown law = strech(1; 1, 6)",
     "set Breakdown law", law, "did you mean 'stretch'"},
    {"factor without brackets", strength,
     "set Breakdown strength = 1e8\n    set Breakdown law = stretch",
     "set Breakdown law", law, "brackets"},
    {"factor without a range", strength,
     "set Breakdown strength = 1e8\n    set Breakdown law = stretch(0.6)",
     "set Breakdown law", law, "';'"},
    {"factor of one constant", strength,
     "set Breakdown strength = 1e8\n    set Breakdown law = thickness(1e-3; "
     "0, 1)",
     "set Breakdown law", law, "1 numbers in place of 2"},
    {"factor of words", strength,
     "set Breakdown strength = 1e8\n    set Breakdown law = stretch(much; 1, "
     "6)",
     "set Breakdown law", law, "'much'"},
    {"factor of an unknown law of temperature", strength,
     "set Breakdown strength = 1e8\n    set Breakdown law = temperature(0.9)",
     "set Breakdown law", law, "law of temperature"},
    {"range downwards", strength,
     "set Breakdown strength = 1e8\n    set Breakdown law = stretch(1; 6, 1)",
     "subsection Material rubber", "Material rubber", "highest stretch"},
    {"temperature outside of the law", strength,
     "set Breakdown strength = 1e8\n    set Breakdown law = "
     "temperature(table(300: 1, 350: 0.5))",
     "subsection Film left", "Film left/Temperature", "Breakdown law"},
    {"law without a strength", strength, "set Breakdown law = stretch(1; 1, 6)",
     "set Breakdown law", law, "no Breakdown strength"}};
INSTANTIATE_TEST_SUITE_P(Laws, BadFailure, ::testing::ValuesIn(laws));

const Refusal events[] = {
    {"unknown event", "Kind = tension loss", "Kind = pull in",
     "set Kind = pull", "Event slack/Kind", "did you mean 'pull-in'"},
    {"pull-in of a film", "Kind = tension loss", "Kind = pull-in",
     "set Of = left", "Event slack/Of", "whole device"},
    {"contact of a frame that is missing", "Kind = tension loss",
     "Kind = self-contact", "set Of = left", "Event slack/Of",
     "there is no frame 'left'"},
    {"snap-through of a probe that is missing", "Kind = tension loss",
     "Kind = snap-through", "set Of = left", "Event slack/Of",
     "there is no probe 'left'"}};
INSTANTIATE_TEST_SUITE_P(Events, BadFailure, ::testing::ValuesIn(events));
} // namespace
} // namespace taut::io::failure
