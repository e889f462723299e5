#include <taut/base/number_text.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace taut;

TEST(NumberText, WrittenNumbersReadBackExactly)
{
  for (const double value : {0.1, -1. / 3, 5e300, 4.9e-324, 300.})
  {
    double back = 0;
    ASSERT_TRUE(read_number(number_text(value), back));
    EXPECT_EQ(back, value);
  }
  EXPECT_EQ(number_text(0.1), "0.1");
}

TEST(NumberText, AcceptsSignsAndInfinity)
{
  double value = 0;
  EXPECT_TRUE(read_number(" +2.5e3 ", value));
  EXPECT_EQ(value, 2500);
  EXPECT_TRUE(read_number("-inf", value));
  EXPECT_TRUE(std::isinf(value) && value < 0);
}

TEST(NumberText, RefusesWhatIsNotOneNumber)
{
  double value = 7;
  for (const char* text : {"", " ", "3 kPa", "1,5", "nan", "--1", "+-1", "1e"})
    EXPECT_FALSE(read_number(text, value)) << text;
  EXPECT_EQ(value, 7);
}
