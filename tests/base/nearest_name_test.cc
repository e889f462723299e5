#include <taut/base/nearest_name.h>

#include <gtest/gtest.h>

using namespace taut;

TEST(NearestName, FindsEachKindOfTypingMistake)
{
  const std::vector<std::string> known = {"thickness", "permittivity",
                                          "density"};
  EXPECT_EQ(nearest_name("thicknes", known), "thickness"); // one missing
  EXPECT_EQ(nearest_name("densitty", known), "density");   // one too many
  EXPECT_EQ(nearest_name("permitivity ", known), "permittivity");
  EXPECT_EQ(nearest_name("dnesity", known), "density");     // swapped
  EXPECT_EQ(nearest_name("Thickness", known), "thickness"); // letter case
}

TEST(NearestName, SwappedNeighboursCountOnce)
{
  // Distance 1 from "ab"; as two replacements it would be 2, beyond the half.
  EXPECT_EQ(nearest_name("ba", {"ab"}), "ab");
}

TEST(NearestName, IsEmptyBeyondHalfTheLength)
{
  EXPECT_EQ(nearest_name("abcd", {"abxy"}), "abxy");
  EXPECT_EQ(nearest_name("abcd", {"axyz"}), "");
  EXPECT_EQ(nearest_name("abcd", {}), "");
}

TEST(NearestName, SuggestionListsAllAndProposesOne)
{
  EXPECT_EQ(suggest("ramb", {"sine", "ramp"}),
            "known are: sine, ramp; did you mean 'ramp'?");
  EXPECT_EQ(suggest("quadratic", {"sine", "ramp"}), "known are: sine, ramp");
}
