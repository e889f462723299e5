#include <taut/base/exceptions.h>
#include <taut/base/signal.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace taut;

namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The message with which the text is refused.
std::string refusal(const std::string& text)
{
  try
  {
    Signal::parse(text);
  }
  catch (const BadInput& error)
  {
    return error.what();
  }
  return "accepted";
}

void expect_refused(const std::string& text, const std::string& reason)
{
  EXPECT_NE(refusal(text).find(reason), std::string::npos)
      << text << " gave: " << refusal(text);
}

/// Both derivatives against central differences of the value, within the error
/// of the differences (h^2 and rounding / h^2).
void expect_consistent_rates(const Signal& signal, const double time)
{
  const double h = 1e-4;
  const double right = signal.value(time + h), left = signal.value(time - h);
  const double scale = 1 + std::abs(signal.value(time));
  EXPECT_NEAR(signal.rate(time), (right - left) / (2 * h), 1e-4 * scale);
  EXPECT_NEAR(signal.second_rate(time),
              (right - 2 * signal.value(time) + left) / (h * h), 1e-3 * scale);
}
} // namespace

TEST(Signal, DefaultIsZero)
{
  EXPECT_EQ(Signal().value(3), 0);
  EXPECT_TRUE(Signal().is_constant());
  EXPECT_TRUE(Signal().kinks(-infinity, infinity).empty());
}

TEST(Signal, Constant)
{
  const Signal signal = Signal::parse(" 5e3 ");
  EXPECT_EQ(signal.value(-1), 5000);
  EXPECT_EQ(signal.value_before(2), 5000);
  EXPECT_EQ(signal.rate(2), 0);
  EXPECT_EQ(signal.second_rate(2), 0);
  EXPECT_TRUE(signal.is_constant());
}

TEST(Signal, RampStartsAndIsHeldAtItsLimit)
{
  const Signal signal =
      Signal::parse("ramp(rate = 300, start = 1, limit = 600)");
  EXPECT_EQ(signal.value(0.5), 0);
  EXPECT_EQ(signal.value(2), 300);
  EXPECT_EQ(signal.value(3), 600);
  EXPECT_EQ(signal.value(30), 600);
  EXPECT_EQ(signal.rate(0.5), 0);
  EXPECT_EQ(signal.rate(1), 300); // from the right
  EXPECT_EQ(signal.rate(3), 0);
  EXPECT_EQ(signal.second_rate(2), 0);
  EXPECT_EQ(signal.kinks(0, 10), (std::vector<double>{1, 3}));
  EXPECT_EQ(signal.kinks(1, 3), std::vector<double>()); // the ends are outside
  EXPECT_FALSE(signal.is_constant());
}

TEST(Signal, FallingRamp)
{
  const Signal signal = Signal::ramp(-2, 0, -3);
  EXPECT_EQ(signal.value(1), -2);
  EXPECT_EQ(signal.value(5), -3);
  EXPECT_EQ(signal.kinks(-1, 9), (std::vector<double>{0, 1.5}));
  EXPECT_EQ(Signal::ramp(-2, 0, infinity).value(1e6), -2e6);
  EXPECT_THROW(Signal::ramp(-2, 0, 3), BadInput);
}

TEST(Signal, ArgumentsMayBeGivenInOrder)
{
  const Signal signal = Signal::parse("ramp(300, start = 1)");
  EXPECT_EQ(signal.value(11), 3000);
  EXPECT_EQ(Signal::parse("sine(1, 2, 0.25, 0)").value(1), 3);
}

TEST(Signal, Sine)
{
  const Signal signal = Signal::sine(1e3, 5e3, 10, 0.3);
  EXPECT_NEAR(signal.value(0.02), 1e3 + 5e3 * std::sin(0.4 * pi + 0.3), 1e-9);
  const double w = 20 * pi, angle = 0.4 * pi + 0.3;
  EXPECT_NEAR(signal.rate(0.02), 5e3 * w * std::cos(angle), 1e-7);
  EXPECT_NEAR(signal.second_rate(0.02), -5e3 * w * w * std::sin(angle), 1e-5);
  EXPECT_TRUE(signal.kinks(0, 10).empty());
}

TEST(Signal, StepsJumpAndAreRightContinuous)
{
  const Signal signal = Signal::parse("steps(0: 0, 1: 2000, 3: 0)");
  EXPECT_EQ(signal.value(-1), 0);
  EXPECT_EQ(signal.value_before(1), 0);
  EXPECT_EQ(signal.value(1), 2000);
  EXPECT_EQ(signal.value_before(2), 2000);
  EXPECT_EQ(signal.value_before(3), 2000);
  EXPECT_EQ(signal.value(3), 0);
  EXPECT_EQ(signal.rate(1), 0);
  EXPECT_EQ(signal.kinks(-1, 10), (std::vector<double>{1, 3}));
  EXPECT_EQ(Signal::parse("steps(2: 7, 3: 8)").value(0), 7);
}

TEST(Signal, TableIsLinearBetweenItsPoints)
{
  const Signal signal = Signal::parse("table(0: 1, 1: 5, 2: 5, 4: 3)");
  EXPECT_EQ(signal.value(-1), 1);
  EXPECT_DOUBLE_EQ(signal.value(0.25), 2);
  EXPECT_EQ(signal.value(1.5), 5);
  EXPECT_DOUBLE_EQ(signal.value(3), 4);
  EXPECT_EQ(signal.value(9), 3);
  EXPECT_EQ(signal.rate(-1), 0);
  EXPECT_EQ(signal.rate(0), 4);
  EXPECT_EQ(signal.rate(1), 0);
  EXPECT_EQ(signal.rate(2), -1);
  EXPECT_EQ(signal.rate(4), 0);
  EXPECT_EQ(signal.kinks(-1, 10), (std::vector<double>{0, 1, 2, 4}));
}

TEST(Signal, PointsOnOneLineAreNoKink)
{
  EXPECT_EQ(Signal::parse("table(0: 0, 1: 1, 2: 2)").kinks(0, 2),
            std::vector<double>());
  EXPECT_EQ(Signal::parse("steps(0: 1, 1: 1)").kinks(-1, 2),
            std::vector<double>());
  EXPECT_TRUE(Signal::parse("steps(0: 1, 1: 1)").is_constant());
}

TEST(Signal, ExpressionAndItsDerivatives)
{
  const Signal signal = Signal::parse("expression(3 + 2*sin(4*pi*t)^2)");
  const double w = 8 * pi;
  for (const double t : {0., 0.3, 1.7})
  {
    EXPECT_NEAR(signal.value(t), 4 - std::cos(w * t), 1e-13);
    // Differences over h = 1e-5 s and 1e-4 s: (w h)^4 and rounding / h^n.
    EXPECT_NEAR(signal.rate(t), w * std::sin(w * t), 1e-8 * w);
    EXPECT_NEAR(signal.second_rate(t), w * w * std::cos(w * t), 1e-8 * w * w);
  }
}

TEST(Signal, ExpressionIsNotDifferentiatedAcrossItsKinks)
{
  const Signal signal =
      Signal::parse("expression(t < 1 ? t^2 : 5 - 3*t; kinks = 1)");
  const double h = 1e-9;
  EXPECT_NEAR(signal.rate(1), -3, 1e-7);
  EXPECT_NEAR(signal.rate(1 - h), 2, 1e-7);
  EXPECT_NEAR(signal.second_rate(1), 0, 1e-5);
  EXPECT_NEAR(signal.second_rate(1 - h), 2, 1e-5);
  EXPECT_NEAR(signal.value_before(1), 1, 1e-12);
  EXPECT_NEAR(signal.value(1), 2, 1e-12);
  EXPECT_EQ(signal.kinks(0, 2), std::vector<double>{1});
}

TEST(Signal, ExpressionIsRightContinuousHoweverItIsWritten)
{
  const Signal signal = Signal::expression("t <= 1 ? 0 : 8", {1});
  EXPECT_EQ(signal.value_before(1), 0);
  EXPECT_EQ(signal.value(1), 8);
}

TEST(Signal, ExpressionWithoutAFiniteValueIsReported)
{
  const Signal signal = Signal::expression("1/(t - 2)", {});
  EXPECT_EQ(signal.value(3), 1);
  EXPECT_THROW(signal.value(2), BadInput);
}

TEST(Signal, RatesAgreeWithDifferencesOfTheValue)
{
  for (const char* text :
       {"7", "ramp(3, 0.1)", "sine(1, 0.5, 0.8, 0.2)", "steps(0: 1, 1: 2)",
        "table(0: 0, 1: 5, 2: 1)", "expression(exp(-t)*cos(3*t))"})
    for (const double time : {0.4, 1.3})
      expect_consistent_rates(Signal::parse(text), time);
}

TEST(Signal, TextFormReadsBackAsTheSameSignal)
{
  for (const char* text :
       {"0.1", "ramp(0.3, 0.1, 2)", "ramp(-3)", "sine(1, 0.5, 0.8, 0.2)",
        "steps(0: 1, 1: 2)", "table(0: 0, 0.1: 5, 2: 1)",
        "expression(t < 1 ? t : min(t, 2); kinks = 1, 2)"})
  {
    const Signal signal = Signal::parse(text);
    const Signal back = Signal::parse(signal.to_text());
    EXPECT_EQ(back.to_text(), signal.to_text());
    for (double time = -0.5; time < 3; time += 0.25)
      EXPECT_EQ(back.value(time), signal.value(time)) << text;
    EXPECT_EQ(back.kinks(-1, 9), signal.kinks(-1, 9));
  }
}

TEST(Signal, RefusesUnknownFormsAndProposesTheNearest)
{
  expect_refused("ramb(rate = 300)", "did you mean 'ramp'?");
  expect_refused("ramb(rate = 300)", "allowed are a number, ramp(");
  expect_refused("5 kV", "'5 kV' is not a signal");
  expect_refused("", "is not a signal");
  expect_refused("ramp", "needs its arguments in brackets");
  expect_refused("ramp(300", "needs its arguments in brackets");
}

TEST(Signal, RefusesBadArguments)
{
  expect_refused("ramp(rat = 300)", "did you mean 'rate'?");
  expect_refused("ramp(start = 1)", "needs the argument 'rate'");
  expect_refused("ramp()", "rate must be a number");
  expect_refused("ramp(300 V/s)", "rate must be a number in SI units");
  expect_refused("ramp(300, rate = 200)", "'rate' twice");
  expect_refused("ramp(rate = 300, 2)", "follows a named one");
  expect_refused("ramp(1, 2, 3, 4)", "one argument too many");
  expect_refused("ramp(inf)", "must be a finite number");
  expect_refused("ramp(1, 0, -2)", "must have the sign of its rate");
  expect_refused("sine(0, 1, -10)", "must not be negative");
  expect_refused("inf", "must be a finite number");
}

TEST(Signal, RefusesBadPoints)
{
  expect_refused("steps()", "is not a point 'time: value'");
  expect_refused("table(0: 1, 2)", "is not a point 'time: value'");
  expect_refused("table(0: 1, 2: 5 V)", "a value must be a number");
  expect_refused("table(0: 1, 2: 5, 1: 0)", "must increase, but 1 follows 2");
  expect_refused("steps(0: 1, 0: 2)", "must increase");
  EXPECT_THROW(Signal::steps({}, {}), BadInput);
  EXPECT_THROW(Signal::table({0, 1}, {0}), BadInput);
}

TEST(Signal, RefusesBadExpressions)
{
  expect_refused("expression(2*x)", "cannot read the expression '2*x'");
  expect_refused("expression()", "cannot read the expression");
  expect_refused("expression(t; knks = 1)", "must read 'kinks = 0.5, 1'");
  expect_refused("expression(t; kinks = a)", "a kink must be a number");
  expect_refused("expression(t; kinks = 1; 2)", "one list of kinks");
}
