// Films whose charge is prescribed: closed forms, stability, tangent.
#include <taut/base/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "structure/statics.h"

namespace taut
{
namespace
{
structure::Device make_square(const material::Spring& spring)
{
  structure::Device device;
  device.films = {testing::make_film(spring, 1, {{1, 1}})};
  device.films[0].tension_field = false;
  device.electrodes = {testing::make_electrode("film", Signal())};
  device.supports = {testing::make_support("film", {{false, false, true}}),
                     testing::make_support("west", {{true, false, false}}),
                     testing::make_support("south", {{false, true, false}})};
  return device;
}

fe::MeshData make_mesh()
{
  return testing::make_grid(
      2, 2, 2,
      [](const double xi, const double eta)
      {
        const double bubble = 16 * xi * (1 - xi) * eta * (1 - eta);
        return fe::Coordinates{xi + .06 * bubble * std::sin(5 * eta),
                               eta - .06 * bubble * std::cos(5 * xi), 0.};
      });
}

double square_of_field(const double l)
{
  return (std::pow(l, -2) - std::pow(l, -8)) /
         (1 - (2 * l * l + std::pow(l, -4) - 3) / 100);
}

TEST(Charge, explore)
{
  auto device = make_square(material::Gent{1, 100});
  device.electrodes[0].control = structure::Electrode::Control::charge;
  for (const unsigned int order : {2,1}) {
  testing::Model model(device, order==2 ? make_mesh() : testing::make_rectangle(1,1,1,1,1));
  testing::Statics statics(*model.structure);
  const double unit = testing::make_voltage(device.films[0], 1, 1);
  const double permittivity = 1 / (unit * unit);
  for (const double l : {1.1, 1.2, 1.26, 1.27, 1.3, 1.5, 2., 2.5, 3., 4., 5., 5.1, 6., 6.5, 6.9})
  {
    const double field = std::sqrt(square_of_field(l));
    statics.loads.electrodes[0].control = structure::Electrode::Control::charge;
    statics.loads.electrodes[0].charge =
        Signal::constant(permittivity * unit * field * std::pow(l, 4));
    statics.apply();
    const auto& free = model.structure->free_unknowns();
    for (std::size_t i = 0; i < free.size(); ++i)
      statics.u[i] = (l*.99 - 1) *
                     model.structure->nodes().mesh_position[free[i] / 3][free[i] % 3];
    try {
    statics.find(1e-6);
    } catch (const std::exception& e) { std::cerr << e.what() << "\n"; continue; }
    const double deviation =
        testing::compute_deviation(statics.compute_metric(), {{l * l, l * l, 0}});
    const int charge = statics.count_negative_eigenvalues();
    const auto loads = model.structure->resolve_voltages(statics.get_loads(), statics.u.data(), statics.internal.data(), structure::Networks::relaxed);
    const double v = loads.voltages[0];
    statics.loads.electrodes[0].control = structure::Electrode::Control::voltage;
    statics.set_voltage(v);
    const int voltage = statics.count_negative_eigenvalues();
    std::cerr << l << " " << deviation << " " << v / unit - field << " charge "
              << charge << " voltage " << voltage << std::endl;
  }
  }
}
} // namespace
} // namespace taut
