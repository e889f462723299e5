// Supports that share nodes must agree on their motion.
#include <taut/base/exceptions.h>

#include <gtest/gtest.h>

#include "structure/statics.h"

namespace taut
{
namespace
{
std::unique_ptr<testing::Model> make_corner(const structure::Support& first,
                                            const structure::Support& second)
{
  structure::Device device;
  device.films = {
      testing::make_film(material::NeoHookean{1e4}, 1e-3, {{2, 2}})};
  device.supports = {first, second};
  return std::make_unique<testing::Model>(
      device, testing::make_rectangle(2, 2, 2, .1, .1));
}

structure::Support make_moving(const std::string& group,
                               const std::string& shape, const Signal& signal)
{
  return testing::make_support(group, {{true, true, true}}, {{shape, "0", "0"}},
                               signal);
}

TEST(MeetingSupports, move_their_common_node_once)
{
  const Signal signal = Signal::ramp(2, 0, 10);
  const auto model = make_corner(make_moving("west", "y - .03", signal),
                                 make_moving("south", "x - .03", signal));
  auto& structure = *model->structure;
  structure::LoadHistory history(structure.device());
  history.enter_interval(0);
  const std::vector<double> u(structure.n_free(), 0.);
  const auto& positions = structure.compute_positions(history.at(1), u.data());
  const auto& mesh_position = structure.nodes().mesh_position;
  for (unsigned int node = 0; node < mesh_position.size(); ++node)
  {
    const auto& X = mesh_position[node];
    if (X[0] == 0 && X[1] == 0)
    {
      EXPECT_NEAR(fe::entry(positions, 3 * node), -.06, 1e-16);
    }
  }
}

TEST(MeetingSupports, are_refused_if_one_moves_and_the_other_rests)
{
  EXPECT_THROW(make_corner(make_moving("west", "0", Signal()),
                           make_moving("south", "1", Signal::ramp(2, 0, 10))),
               BadInput);
}

TEST(MeetingSupports, are_refused_if_their_histories_differ)
{
  EXPECT_THROW(make_corner(make_moving("west", "1", Signal::ramp(1, 0, 10)),
                           make_moving("south", "1", Signal::ramp(2, 0, 10))),
               BadInput);
}

TEST(MeetingSupports, may_have_a_shape_that_never_moves)
{
  EXPECT_NO_THROW(make_corner(make_moving("west", "1", Signal()),
                              make_moving("south", "0", Signal())));
}

TEST(MeetingSupports, may_rest_where_an_expression_vanishes)
{
  // sin(pi) is not quite zero.
  EXPECT_NO_THROW(make_corner(
      make_moving("west", "0", Signal()),
      make_moving("north", "sin(10*pi*y)*(x + .02)", Signal::ramp(2, 0, 10))));
}
} // namespace
} // namespace taut
