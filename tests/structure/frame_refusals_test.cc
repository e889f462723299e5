// What a frame cannot be on its mesh.
#include <taut/base/exceptions.h>

#include <gtest/gtest.h>

#include "structure/demes.h"

namespace taut::testing
{
namespace
{
std::string refuse(const std::function<void(structure::Device&)>& spoil)
{
  auto device = make_demes_device({});
  spoil(device);
  try
  {
    Model model(device, make_demes_mesh({}));
  }
  catch (const BadInput& error)
  {
    return error.what();
  }
  return "accepted";
}

void expect_contains(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(FrameRefusals, NameTheEntryAndWhatIsWrong)
{
  expect_contains(
      refuse([](auto& device) { device.frames[0].groups = {"lags"}; }), "lags");
  expect_contains(refuse(
                      [](auto& device)
                      {
                        device.frames[0].attachment =
                            structure::Frame::Attachment::at;
                        device.frames[0].attached_at = {"middles"};
                      }),
                  "no node of both the frame and a film");
  expect_contains(refuse(
                      [](auto& device)
                      {
                        device.frames[0].attachment =
                            structure::Frame::Attachment::at;
                        device.frames[0].attached_at = {"middels"};
                      }),
                  "did you mean 'middles'");
  expect_contains(refuse(
                      [](auto& device)
                      {
                        structure::Hinge hinge;
                        hinge.name = "elbow";
                        hinge.groups = {"middles"};
                        device.hinges = {hinge};
                      }),
                  "fewer than two frames");
  expect_contains(refuse(
                      [](auto& device) {
                        device.bodies[1].groups = {"west", "east_legs"};
                      }),
                  "shares nodes with the body 'west'");
  expect_contains(refuse(
                      [](auto& device)
                      {
                        auto support = make_support("east_legs", {});
                        support.held = {{true, true, true}};
                        device.supports.push_back(support);
                      }),
                  "may turn about it");
  expect_contains(refuse(
                      [](auto& device)
                      {
                        auto load = make_point_load("south_west", {{0, 0, 1}});
                        load.groups = {"nowhere"};
                        device.point_loads = {load};
                      }),
                  "no group 'nowhere'");
}

TEST(FrameRefusals, AFilmRefinedOnOneSideOfAFrame)
{
  structure::Device device;
  device.films = {make_film(material::NeoHookean{2e4}, 1e-3, {{1.2, 1.2}})};
  device.frames = {
      make_frame("middle", make_stiffnesses(1e3, 1e3, 1e-3, 1e-3, 1e-3))};
  const auto mesh = make_rectangle(4, 4, 2, .04, .04);
  const auto refine_left = [](fe::Triangulation& triangulation)
  {
    for (const auto& cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && cell->center()[0] < .02)
        cell->set_refine_flag();
    triangulation.execute_coarsening_and_refinement();
  };
  EXPECT_NO_THROW(Model(device, mesh));
  EXPECT_THROW(Model(device, mesh, 0, refine_left), BadInput);
}

TEST(FrameRefusals, AFrameOfTwoNamesOnOneLine)
{
  const auto message = refuse(
      [](auto& device)
      {
        device.frames.push_back(device.frames[0]);
        device.frames[1].name = "second";
      });
  expect_contains(message, "shares the line 'legs'");
}
} // namespace
} // namespace taut::testing
