#include <taut/base/exceptions.h>
#include <taut/base/formula.h>

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

using namespace taut;

TEST(Formula, KnowsItsVariablesAndPi)
{
  const Formula formula("2*pi*sqrt(mass/stiffness)", {"mass", "stiffness"});
  EXPECT_DOUBLE_EQ(formula({9, 4}), 3 * std::acos(-1.));
  EXPECT_DOUBLE_EQ(formula({4, 4}), 2 * std::acos(-1.));
}

TEST(Formula, MayBeMoved)
{
  Formula first("a + b", {"a", "b"});
  const Formula second = std::move(first);
  EXPECT_DOUBLE_EQ(second({1, 2}), 3);
}

TEST(Formula, NamesWhatIsUnknownAndTheNearest)
{
  try
  {
    Formula("2*strech", {"stretch", "voltage"});
    FAIL() << "accepted";
  }
  catch (const BadInput& problem)
  {
    EXPECT_NE(problem.message().find("did you mean 'stretch'?"),
              std::string::npos)
        << problem.message();
  }
  EXPECT_THROW(Formula("2*(a", {"a"}), BadInput);
  EXPECT_THROW(Formula("", {"a"}), BadInput);
}

TEST(Formula, RefusesWhatIsNotFinite)
{
  const Formula formula("1/a", {"a"});
  EXPECT_DOUBLE_EQ(formula({2}), 0.5);
  EXPECT_THROW(formula({0}), BadInput);
}

TEST(Formula, VariablesAreIdentifiersAndNoFunctions)
{
  for (const char* name : {"a", "pre_stretch", "x2", "Voltage"})
    EXPECT_TRUE(is_variable_name(name)) << name;
  for (const char* name : {"", "2x", "pre stretch", "a-b", "sin", "pi", "_pi"})
    EXPECT_FALSE(is_variable_name(name)) << name;
}
