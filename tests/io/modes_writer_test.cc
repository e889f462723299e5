// The table and the shapes of vibration modes, read back.
#include <taut/io/files.h>
#include <taut/io/modes_writer.h>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "io/vtu_files.h"
#include "structure/devices.h"

namespace taut::io
{
namespace
{
using testing::is_first;
using testing::read_array;
using testing::read_xml;
using testing::SharedFolder;

study::ModesReport make_report()
{
  study::ModesReport report;
  report.total_mass = .5;
  report.relaxations = {{"network 1", .01}};
  study::ModesReport::Mode mode;
  mode.square = std::pow(2 * M_PI * 3, 2);
  mode.damped_angular_frequency = 2 * M_PI * 2.5;
  mode.damping_ratio = .125;
  mode.growth_rate = -1.5;
  mode.modal_mass = .25;
  mode.effective_masses = {.1, .2, 0};
  mode.products = {.75};
  report.modes = {mode, mode};
  report.modes[1].square = -4;
  return report;
}

TEST(ModesWriter, TableHasARowAMode)
{
  const SharedFolder folder("modes_table");
  if (!is_first())
    return;
  write_mode_table(folder.get("modes.csv"), make_report());
  std::ifstream stream(folder.get("modes.csv"));
  std::string header, first, second;
  std::getline(stream, header);
  std::getline(stream, first);
  std::getline(stream, second);
  EXPECT_EQ(header,
            "mode [1],frequency [Hz],angular frequency squared [1/s^2],damped "
            "frequency [Hz],damping ratio [1],growth rate [1/s],modal mass "
            "[kg],effective mass x [kg],effective mass y [kg],effective mass z "
            "[kg],share of mass x [1],share of mass y [1],share of mass z "
            "[1],omega T network 1 [1]");
  EXPECT_EQ(first.substr(0, 4), "1,3,");
  EXPECT_NE(first.find(",2.5,0.125,-1.5,0.25,0.1,0.2,0,0.2,0.4,0,0.75"),
            std::string::npos)
      << first;
  // An unstable mode has no frequency.
  EXPECT_EQ(second.substr(0, 7), "2,0,-4,");
}

TEST(ModesWriter, FramesHoldTheShapesBesideTheState)
{
  const SharedFolder folder("modes_shapes");
  structure::Device device;
  device.mesh.degree = 2;
  device.films = {
      taut::testing::make_film(material::NeoHookean{2e4}, 1e-3, {{2, 1.5}})};
  device.supports = {
      taut::testing::make_support("south", {{true, true, true}})};
  taut::testing::Model model(device,
                             taut::testing::make_rectangle(4, 2, 2, .08, .04));
  auto& structure = *model.structure;
  structure::QuasiStaticSystem system(structure, {});
  std::vector<double> state(system.layout().size());
  fe::set_unrelaxed(structure.cells(), system.internal(state.data()));
  // z moves with the place.
  const auto& nodes = structure.nodes();
  std::vector<double> motion(3 * nodes.n_local);
  for (fe::LocalNode node = 0; node < nodes.n_local; ++node)
    motion[3 * node + 2] =
        nodes.mesh_position[node][0] + 2 * nodes.mesh_position[node][1];
  write_mode_shapes(folder.path(),
                    {.7, system, state.data(), {motion, motion}});
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
    return;
  const auto sets = testing::get_all(
      read_xml(folder.get("fields.pvd")).get_child("VTKFile.Collection"),
      "DataSet", "file");
  ASSERT_EQ(sets.size(), 3u);
  for (std::size_t frame = 0; frame < sets.size(); ++frame)
  {
    const auto piece = read_xml(folder.get(sets[frame]))
                           .get_child("VTKFile.UnstructuredGrid.Piece");
    const auto places = read_array<float>(piece.get_child("Points"), "");
    const auto shape = read_array<float>(piece.get_child("PointData"), "mode");
    ASSERT_EQ(places.size(), shape.size());
    ASSERT_FALSE(shape.empty());
    for (std::size_t i = 0; i < shape.size(); i += 3)
      EXPECT_NEAR(shape[i + 2], frame == 0 ? 0. : places[i] + 2 * places[i + 1],
                  testing::round_off);
  }
}
} // namespace
} // namespace taut::io
