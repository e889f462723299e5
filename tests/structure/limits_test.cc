// What a run says when a law is taken beyond the range in which it holds: which
// film, where, and which value.
#include <taut/base/exceptions.h>

#include <gtest/gtest.h>

#include "structure/frames.h"

namespace taut
{
namespace
{
/// Two films side by side, each of 20 mm, in a prescribed motion.
structure::Device make_films()
{
  structure::Device device;
  auto film = testing::make_film(material::NeoHookean{2e4}, 1e-3, {{1.2, 1.2}});
  for (const char* name : {"left", "right"})
  {
    film.name = name;
    film.groups = {name};
    device.films.push_back(film);
  }
  device.electrodes = {testing::make_electrode("film", Signal::constant(1000))};
  // Stretches along x that grow with x, 1 + 30 x.
  device.supports = {testing::make_support("film", {{true, true, true}},
                                           {{"15*x*x", "0", "0"}})};
  return device;
}

/// What is said of forces with the motion at a share of it.
std::string get_message(const structure::Device& device, const double share)
{
  testing::Model model(device, testing::make_rectangle(8, 4, 2, .04, .02));
  testing::Statics statics(*model.structure, structure::Networks::as_given);
  if (!device.supports.empty())
    statics.set_amplitude(0, share);
  std::vector<double> forces(model.structure->n_free());
  try
  {
    model.structure->compute_forces(
        statics.get_loads(), statics.u.data(), statics.internal.data(),
        structure::Networks::as_given, forces.data(), nullptr);
  }
  catch (const StepRejected& rejection)
  {
    return rejection.what();
  }
  return "";
}

/// The film `right` at its east edge is the worst point: x of the last Gauss
/// point, of the 3 in a cell of 5 mm. `says` comes at full motion only.
void expect_said(const structure::Device& device, const std::string& says)
{
  EXPECT_EQ(get_message(device, .5), "");
  const std::string message = get_message(device, 1);
  const std::string film = "film 'right' at (";
  ASSERT_EQ(message.substr(0, film.size()), film) << message;
  EXPECT_NEAR(std::stod(message.substr(film.size())),
              .04 - .0025 * (1 - std::sqrt(.6)), 1e-6)
      << message;
  EXPECT_NE(message.find(says), std::string::npos) << message;
}

// l_1 = 1.2 (1 + 30 x) is 2.62 at x = 39.4 mm, so that I1 = 8.4.
TEST(Limits, OfASpring)
{
  auto device = make_films();
  device.films[1].material.springs = {material::Gent{2e4, 4}};
  expect_said(device, "is beyond the limit 7 of the Gent spring 1");
  const std::string message = get_message(device, 1);
  const std::string before = "m of the mesh: I1 = ";
  const std::size_t place = message.find(before);
  ASSERT_NE(place, std::string::npos) << message;
  const double l = 1.2 * (1 + 30 * (.04 - .0025 * (1 - std::sqrt(.6))));
  EXPECT_NEAR(std::stod(message.substr(place + before.size())),
              l * l + 1.44 + 1 / (l * l * 1.44), 1e-4);
}

TEST(Limits, OfARelaxationLaw)
{
  auto device = make_films();
  for (auto& film : device.films)
    film.material.networks = {{material::NeoHookean{1e4}, 1}};
  device.films[1].material.networks[0].relaxation =
      material::StretchActivatedRelaxation{12};
  expect_said(device, "is beyond the limit 50 of the relaxation law of network "
                      "1");
}

TEST(Limits, OfAFibreFamily)
{
  auto device = make_films();
  device.films[1].material.fibres = {{material::ExponentialFibres{1e3, 2}}};
  expect_said(device, "is beyond the limit 50 of fibre family 1");
}

// The factor 1 - (l_1 + l_2 - 2) vanishes where l_1 + l_2 = 3.
TEST(Limits, OfAPermittivity)
{
  auto device = make_films();
  device.films[1].material.dielectric.permittivity =
      material::StretchPermittivity{2, 900, -.6, 0, 0};
  expect_said(device, "the permittivity, multiplied by -0.");
  // Without voltage it does not matter.
  device.electrodes[0].voltage = Signal();
  EXPECT_EQ(get_message(device, 1), "");
}

TEST(Limits, OfTheClimateOfAFilm)
{
  auto device = make_films();
  device.films[1].thermal.modulus =
      material::PolynomialLaw{299, {-.005}, 250, 400};
  device.films[1].temperature = Signal::constant(401);
  EXPECT_EQ(get_message(device, 1), "film 'right', everywhere: the temperature "
                                    "is 401 K, its law holds from 250 to 400 "
                                    "K");
  device.films[1].temperature = Signal::constant(399);
  EXPECT_EQ(get_message(device, 1), "");
  device.films[1].humidity_laws.permittivity = material::ExponentialLaw{.5, 1};
  device.films[1].humidity = Signal::constant(1.2);
  EXPECT_EQ(get_message(device, 1), "film 'right', everywhere: the relative "
                                    "humidity is 1.2, its law holds from 0 to "
                                    "1");
}

TEST(Limits, OfTheClimateOfAFrame)
{
  auto device = make_films();
  device.supports = {testing::make_support("south", {{true, true, true}})};
  device.frames = {testing::make_frame(
      "north", testing::make_stiffnesses(1e3, 1e3, 1e-3, 1e-3, 1e-3))};
  device.frames[0].humidity_law = material::PolynomialLaw{.5, {-.2}, .1, .9};
  device.frames[0].humidity = Signal::constant(.95);
  EXPECT_EQ(get_message(device, 0),
            "frame 'frame on north', everywhere: the relative humidity is "
            "0.95, its law holds from 0.1 to 0.9");
}
} // namespace
} // namespace taut
