#include <taut/base/exceptions.h>
#include <taut/fe/mesh_groups.h>

#include <gtest/gtest.h>

namespace
{
using taut::fe::MeshGroups;
using Names = std::vector<std::string>;
using Ids = std::set<unsigned int>;

constexpr unsigned int points = 0, lines = 1, surfaces = 2;

MeshGroups make_frame()
{
  MeshGroups groups;
  groups.add(lines, {"frame", "left"});
  groups.add(lines, {"frame", "right"});
  groups.add(lines, {"bar"});
  groups.add(surfaces, {"film"});
  return groups;
}

std::string message_of(const MeshGroups& groups, const unsigned int dimension,
                       const std::string& name)
{
  try
  {
    groups.get_ids(dimension, name);
  }
  catch (const taut::BadInput& error)
  {
    return error.message();
  }
  return "";
}

TEST(MeshGroups, a_group_is_every_set_that_holds_it)
{
  const MeshGroups groups = make_frame();
  EXPECT_EQ(groups.get_ids(lines, "frame"), (Ids{1, 2}));
  EXPECT_EQ(groups.get_ids(lines, "right"), (Ids{2}));
  EXPECT_EQ(groups.get_ids(surfaces, "film"), (Ids{1}));
  EXPECT_EQ(groups.get_names(lines), (Names{"bar", "frame", "left", "right"}));
  EXPECT_TRUE(groups.get_names(points).empty());
}

TEST(MeshGroups, equal_sets_share_one_id)
{
  MeshGroups groups = make_frame();
  EXPECT_EQ(groups.add(lines, {"right", "frame"}), 2u);
  EXPECT_EQ(groups.add(lines, {"right"}), 4u);
}

TEST(MeshGroups, no_group_and_unknown_ids_are_the_empty_set)
{
  MeshGroups groups = make_frame();
  EXPECT_EQ(groups.add(lines, {}), 0u);
  EXPECT_TRUE(groups.get_set(lines, 0).empty());
  EXPECT_TRUE(groups.get_set(lines, static_cast<unsigned int>(-1)).empty());
}

TEST(MeshGroups, refuses_an_unknown_group_and_proposes_the_nearest)
{
  const std::string message = message_of(make_frame(), lines, "frme");
  EXPECT_NE(message.find("no line group 'frme'"), std::string::npos);
  EXPECT_NE(message.find("bar, frame, left, right"), std::string::npos);
  EXPECT_NE(message.find("did you mean 'frame'"), std::string::npos);
}

TEST(MeshGroups, says_when_the_group_has_another_dimension)
{
  const std::string message = message_of(make_frame(), lines, "film");
  EXPECT_NE(message.find("'film' is a surface group"), std::string::npos);
}
} // namespace
