// The sections Motion and Procedure/Frequency response of a case.
#include <taut/io/case_checks.h>

#include "io/refusal.h"

namespace taut::io
{
namespace
{
using testing::Refusal;
using testing::small_case;

/// A film case with a motion, and a lumped one with a frequency response.
const std::string film_case = std::string(small_case) +
                              "subsection Motion\n"
                              "  set Of = swing\n"
                              "  set Period = 1e-3\n"
                              "  set From = 1e-3\n"
                              "  set Lyapunov exponent = false\n"
                              "end\n";

const std::string lumped_case = R"(set Model = demes
subsection Lumped DEMES
  set Film length = 0.02
  set Film width = 0.04
  set Film thickness = 5e-4
  set Shear modulus = 52246.6
  set Viscosity = 49.9
  set Frame modulus = 2e9
  set Frame width = 0.01
  set Frame thickness = 5e-4
  set Inertia = 2e-5
  set Source = 0
end
subsection Procedure
  set Analysis = frequency response
  subsection Frequency response
    set From = 1
    set To = 10
    set Amplitude = 5000
    set Direction = both
    set Spacing = logarithmic
    set From rest = false
    set Least periods = 40
    set Most periods = 400
  end
end
)";

class BadMotion : public ::testing::TestWithParam<Refusal>
{
};

TEST_P(BadMotion, IsRefusedWithFileLineAndKey)
{
  testing::expect_refused(film_case, GetParam());
}

const Refusal motions[] = {
    {"no such probe", "Of = swing\n  set Per", "Of = swign\n  set Per",
     "set Of = swign", "Motion/Of", "did you mean 'swing'"},
    {"nothing moves", "  set Of = swing\n  set Per", "  set Per",
     "subsection Motion", "Motion/Of", "missing"},
    {"no such velocity", "  set From = 1e-3\n", "  set Velocity = tpo\n",
     "set Velocity", "Motion/Velocity", "did you mean 'top'"},
    {"exponent of a film", "exponent = false", "exponent = true",
     "set Lyapunov", "Motion/Lyapunov exponent", "lumped model"},
    {"nothing left", "set From = 1e-3\n", "set From = 99\n", "set From = 99",
     "Motion/From", "nothing of the run is left"},
    {"no period left", "Period = 1e-3\n", "Period = 99\n", "set Period",
     "Motion/Period", "hold no period"},
    {"no motion", "  set End time = 2",
     "  set End time = 2\n  set Analysis = equilibrium", "subsection Motion",
     "Motion", "'transient'"},
    {"response of a film", "  set End time = 2",
     "  set End time = 2\n  set Analysis = frequency response\n"
     "  subsection Frequency response\n    set From = 1\n    set To = 2\n"
     "    set Amplitude = 1\n  end",
     "set Analysis", "Procedure/Analysis", "taut study"}};

INSTANTIATE_TEST_SUITE_P(Motions, BadMotion, ::testing::ValuesIn(motions));

class BadResponse : public ::testing::TestWithParam<Refusal>
{
};

TEST_P(BadResponse, IsRefusedWithFileLineAndKey)
{
  testing::expect_refused(lumped_case, GetParam());
}

const Refusal responses[] = {
    {"no lowest frequency", "    set From = 1\n", "",
     "subsection Frequency response", "Procedure/Frequency response/From",
     "missing"},
    {"frequencies that fall", "set To = 10", "set To = 0.5", "set To",
     "Procedure/Frequency response/To", "exceed"},
    {"too few periods", "Most periods = 400", "Most periods = 30", "set Most",
     "Procedure/Frequency response/Most periods", "40 Least periods"},
    {"no time to observe", "From rest = false", "From rest = true",
     "subsection Frequency response",
     "Procedure/Frequency response/Observation time", "1 s or more"},
    {"time that nobody observes", "    set From rest = false\n",
     "    set Observation time = 3\n", "set Observation",
     "Procedure/Frequency response/Observation time", "From rest = true"},
    {"two sources", "set Source = 0", "set Source = 100", "set Source",
     "Lumped DEMES/Source", "set this to 0"},
    {"no such column", "    set Direction = both\n", "    set Of = angel\n",
     "set Of", "Procedure/Frequency response/Of", "did you mean 'angle'"},
    {"response without its analysis", "Analysis = frequency response",
     "Analysis = transient", "subsection Frequency response",
     "Procedure/Frequency response", "only for Analysis"},
    {"motion of many frequencies", "set Model = demes\n",
     "set Model = demes\nsubsection Motion\n  set Of = angle\nend\n",
     "subsection Motion", "Motion", "'transient'"}};

INSTANTIATE_TEST_SUITE_P(Responses, BadResponse,
                         ::testing::ValuesIn(responses));

TEST(MotionCase, IsRead)
{
  const testing::CaseOnDisk disk(film_case);
  const auto motion = read_case(disk.file()).motion;
  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->of, "swing");
  EXPECT_EQ(motion->period, 1e-3);
  EXPECT_EQ(motion->from, 1e-3);
  EXPECT_EQ(motion->tolerance, 1e-3);
  EXPECT_FALSE(motion->lyapunov_exponent);
  const testing::CaseOnDisk still(small_case);
  EXPECT_FALSE(read_case(still.file()).motion);
  EXPECT_EQ(read_case(still.file(), {"Motion/Of = top"}).motion->of, "top");
}

TEST(MotionCase, ResponseIsRead)
{
  const testing::CaseOnDisk disk(lumped_case);
  const auto procedure = read_case(disk.file()).procedure;
  EXPECT_EQ(procedure.analysis, structure::Analysis::frequency_response);
  const auto& response = procedure.frequency_response;
  EXPECT_EQ(response.to, 10);
  EXPECT_EQ(response.amplitude, 5000);
  EXPECT_TRUE(response.is_logarithmic);
  EXPECT_EQ(response.direction,
            study::FrequencyResponseDescription::Direction::both);
  EXPECT_EQ(response.least_periods, 40u);
}

TEST(MotionCase, EffectiveParametersReadBack)
{
  for (const std::string& text : {film_case, lumped_case})
  {
    const testing::CaseOnDisk disk(text);
    const std::string effective =
        read_case_file(disk.file()).effective_parameters;
    const testing::CaseOnDisk again(effective);
    EXPECT_EQ(read_case_file(again.file()).effective_parameters, effective);
  }
}
} // namespace
} // namespace taut::io
