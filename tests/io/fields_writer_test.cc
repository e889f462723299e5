// The files as any reader of XML sees them, and the numbers in them.
#include <taut/base/exceptions.h>
#include <taut/io/fields_writer.h>
#include <taut/io/files.h>
#include <taut/io/film_patches.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "io/made_up_beams.h"
#include "io/vtu_files.h"
#include "structure/devices.h"

namespace taut::io
{
namespace
{
using boost::property_tree::ptree;
using testing::get_all;
using testing::is_first;
using testing::MadeUpBeams;
using testing::read_xml;
using testing::round_off;
using testing::SharedFolder;
namespace fs = std::filesystem;

constexpr double radius = .03; // m
/// A quarter of a cylinder, stretched by 2 around and 1.5 along it.
struct Cylinder
{
  explicit Cylinder(const unsigned int degree)
      : model(make_device(degree),
              taut::testing::make_grid(
                  4, 3, 2,
                  [](const double xi, const double eta)
                  {
                    const double angle = .5 * M_PI * xi;
                    return fe::Coordinates{radius * std::cos(angle),
                                           radius * std::sin(angle), .04 * eta};
                  })),
        system(*model.structure), state(system.layout().size())
  {
    fe::set_unrelaxed(model.structure->cells(), system.internal(state.data()));
    // A displacement along x that grows with z.
    const auto& structure = *model.structure;
    for (std::size_t i = 0; i < structure.n_free(); ++i)
    {
      const auto entry = structure.free_unknowns()[i];
      if (entry % 3 == 0)
        state[i] = .1 * structure.nodes().mesh_position[entry / 3][2];
    }
  }

  static structure::Device make_device(const unsigned int degree)
  {
    structure::Device device;
    device.mesh.degree = degree;
    auto film =
        taut::testing::make_film(material::NeoHookean{2e4}, 1e-3, {{2, 1.5}});
    film.axis = {{-1, 1, 0}};
    film.material.networks = {{material::NeoHookean{1e4}, 1.}};
    device.films = {film};
    device.supports = {
        taut::testing::make_support("south", {{true, true, true}})};
    return device;
  }

  taut::testing::Model model;
  structure::InertialSystem system;
  std::vector<double> state;
};

/// Components of the field `name` in a piece or, with a P, in a record.
int count_components(const ptree& fields, const std::string& array,
                     const std::string& name)
{
  for (const auto& [key, node] : fields)
    if (key == array && node.get<std::string>("<xmlattr>.Name") == name)
      return node.get("<xmlattr>.NumberOfComponents", 1);
  return 0;
}

/// Every array of a piece with cells has content.
void expect_content(const ptree& piece)
{
  for (const char* part : {"Points", "Cells", "PointData"})
    for (const auto& [key, node] : piece.get_child(part))
      if (key == "DataArray")
      {
        EXPECT_GT(node.get_value<std::string>().size(), 20u)
            << part << " " << node.get("<xmlattr>.Name", "");
      }
}

/// Adds up the points of a .vtu, or of the parts of a .pvtu.
unsigned int count_points(const fs::path& file)
{
  const ptree tree = read_xml(file);
  if (file.extension() == ".vtu")
  {
    const ptree& piece = tree.get_child("VTKFile.UnstructuredGrid.Piece");
    expect_content(piece);
    return piece.get<unsigned int>("<xmlattr>.NumberOfPoints");
  }
  unsigned int sum = 0;
  for (const std::string& part :
       get_all(tree.get_child("VTKFile.PUnstructuredGrid"), "Piece", "Source"))
    sum += count_points(file.parent_path() / part);
  return sum;
}

TEST(FieldsWriter, FramesHoldEveryCellAndField)
{
  const SharedFolder folder("fields");
  Cylinder cylinder(2);
  FieldsWriter writer(folder.path(), MPI_COMM_WORLD);
  writer.write(0, cylinder.system, cylinder.state.data());
  writer.write(1. / 3, cylinder.system, cylinder.state.data());
  if (!is_first())
    return;
  const ptree frames =
      read_xml(folder.get("fields.pvd")).get_child("VTKFile.Collection");
  const auto times = get_all(frames, "DataSet", "timestep");
  ASSERT_EQ(times.size(), 2u);
  EXPECT_EQ(std::stod(times[1]), 1. / 3);
  for (const std::string& file : get_all(frames, "DataSet", "file"))
  {
    const fs::path frame = folder.get(file);
    EXPECT_EQ(count_points(frame), 12 * 9u);
    const bool is_record = frame.extension() == ".pvtu";
    const std::string p = is_record ? "P" : "";
    const ptree tree = read_xml(frame);
    const ptree& fields =
        tree.get_child(is_record ? "VTKFile.PUnstructuredGrid.PPointData"
                                 : "VTKFile.UnstructuredGrid.Piece.PointData");
    for (const char* name : {"displacement", "velocity", "stress_direction_1",
                             "wrinkle_direction"})
      EXPECT_EQ(count_components(fields, p + "DataArray", name), 3) << name;
    for (const char* name :
         {"stretch_1", "stretch_2", "stress_1", "stress_2", "true_field",
          "breakdown_margin", "thickness", "wrinkle_strain", "tension",
          "network_1_stretch_1", "film", "electrode", "rank"})
      EXPECT_EQ(count_components(fields, p + "DataArray", name), 1) << name;
  }
}

TEST(FieldsWriter, ResumedRunKeepsTheFramesOfTheCheckpoint)
{
  const SharedFolder folder("fields_resumed");
  Cylinder cylinder(1);
  {
    FieldsWriter writer(folder.path(), MPI_COMM_WORLD);
    for (const double time : {0., 1., 2.})
      writer.write(time, cylinder.system, cylinder.state.data());
  }
  FieldsWriter resumed(folder.path(), MPI_COMM_WORLD, 1);
  if (is_first())
  {
    for (const auto& entry : fs::directory_iterator(folder.get("fields")))
      EXPECT_EQ(entry.path().filename().string().find("frame_00000"), 0u);
  }
  resumed.write(1.5, cylinder.system, cylinder.state.data());
  if (is_first())
  {
    const ptree frames =
        read_xml(folder.get("fields.pvd")).get_child("VTKFile.Collection");
    const auto times = get_all(frames, "DataSet", "timestep");
    ASSERT_EQ(times.size(), 2u);
    EXPECT_EQ(std::stod(times[0]), 0);
    EXPECT_EQ(std::stod(times[1]), 1.5);
  }
}

TEST(FieldsWriter, LostFramesAreRefused)
{
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
    return;
  const SharedFolder folder("fields_lost");
  EXPECT_THROW(FieldsWriter(folder.path(), MPI_COMM_WORLD, 1), BadInput);
  replace_file(folder.get("fields.pvd"), "<VTKFile><Collection/></VTKFile>");
  EXPECT_THROW(FieldsWriter(folder.path(), MPI_COMM_WORLD, 1), BadInput);
  replace_file(folder.get("fields.pvd"), "<VTKFile>");
  EXPECT_THROW(FieldsWriter(folder.path(), MPI_COMM_WORLD, 1), BadInput);
}

/// Part and file of everything that fields.pvd names.
std::vector<std::pair<std::string, std::string>>
list_parts(const SharedFolder& folder)
{
  const ptree sets =
      read_xml(folder.get("fields.pvd")).get_child("VTKFile.Collection");
  const auto parts = get_all(sets, "DataSet", "part");
  const auto files = get_all(sets, "DataSet", "file");
  std::vector<std::pair<std::string, std::string>> list;
  for (std::size_t i = 0; i < parts.size(); ++i)
    list.emplace_back(parts[i], files[i]);
  return list;
}

TEST(FieldsWriter, FilmAndBeamsArePartsOfOneTime)
{
  const SharedFolder folder("fields_parts");
  Cylinder cylinder(2);
  const MadeUpBeams beams;
  const auto film =
      make_film_patches(0, cylinder.system, cylinder.state.data());
  const auto lines = make_frame_patches(beams.elements, beams.frames);
  {
    FieldsWriter writer(folder.path(), MPI_COMM_WORLD);
    for (const double time : {0., 1., 1., 2.})
      writer.write(time, film, lines);
  }
  FieldsWriter resumed(folder.path(), MPI_COMM_WORLD, 2);
  resumed.write(1.5, film, lines);
  if (!is_first())
    return;
  const auto parts = list_parts(folder);
  ASSERT_EQ(parts.size(), 6u);
  for (unsigned int i = 0; i < 6; ++i)
  {
    const bool of_beams = i % 2 == 1;
    EXPECT_EQ(parts[i].first, of_beams ? "1" : "0");
    const std::string stem =
        of_beams ? "fields/beams_0000" : "fields/frame_0000";
    EXPECT_EQ(parts[i].second.find(stem + std::to_string(i / 2)), 0u);
    EXPECT_TRUE(fs::exists(folder.get(parts[i].second)));
  }
  for (const char* later : {"fields/beams_00003.vtu", "fields/frame_00003.vtu",
                            "fields/frame_00003.pvtu"})
    EXPECT_FALSE(fs::exists(folder.get(later)));
}

/// Row of a field in the data of a patch.
unsigned int find_row(const FilmPatches& film, const std::string& name)
{
  return std::find(film.names.begin(), film.names.end(), name) -
         film.names.begin();
}

TEST(FilmPatches, PointsLieOnTheCurveAndMoveWithTheFilm)
{
  Cylinder cylinder(2);
  const FilmPatches film =
      make_film_patches(0, cylinder.system, cylinder.state.data());
  const unsigned int displacement = find_row(film, "displacement");
  const unsigned int coordinates = film.names.size();
  for (const auto& patch : film.patches)
    for (unsigned int i = 0; i < patch.data.n_cols(); ++i)
    {
      const auto x = [&](const unsigned int d)
      { return patch.data(coordinates + d, i); };
      // Nodes of the mesh were placed on the cylinder.
      EXPECT_NEAR(std::hypot(x(0), x(1)), radius, round_off);
      EXPECT_NEAR(patch.data(displacement, i), .1 * x(2), round_off);
      EXPECT_NEAR(patch.data(displacement + 1, i), 0, round_off);
    }
}

TEST(FilmPatches, PointsOfAPatchRunRowByRow)
{
  Cylinder cylinder(2);
  for (const auto& patch :
       make_film_patches(0, cylinder.system, cylinder.state.data()).patches)
  {
    const unsigned int z = patch.data.n_rows() - 1;
    for (unsigned int j = 0; j < 3; ++j)
      for (unsigned int i = 0; i < 3; ++i)
      {
        // One of the unit directions of a cell runs along the cylinder, and
        // the middle node lies half-way.
        const bool along_second = patch.data(z, 0) != patch.data(z, 6);
        const double share = (along_second ? j : i) / 2.;
        EXPECT_NEAR(patch.data(z, 3 * j + i),
                    (1 - share) * patch.data(z, 0) + share * patch.data(z, 8),
                    round_off);
      }
  }
}

TEST(FilmPatches, UniformFieldsReachTheNodes)
{
  Cylinder cylinder(2);
  std::fill_n(cylinder.state.begin(), cylinder.model.structure->n_free(), 0.);
  const FilmPatches film =
      make_film_patches(0, cylinder.system, cylinder.state.data());
  // G (l^2 - 1/(l_1 l_2)^2) of spring and unrelaxed network.
  const std::map<std::string, double> expected{
      {"stretch_1", 2},
      {"stretch_2", 1.5},
      {"stress_1", 3e4 * (4 - 1 / 9.)},
      {"stress_2", 3e4 * (2.25 - 1 / 9.)},
      {"thickness", 1e-3 / 3},
      {"breakdown_margin", 1},
      {"network_1_stretch_1", 1},
      {"tension", 0},
      {"wrinkle_strain", 0},
      {"electrode", -1}};
  for (const auto& patch : film.patches)
    for (const auto& [name, value] : expected)
      for (unsigned int i = 0; i < patch.data.n_cols(); ++i)
        // Single precision again.
        EXPECT_NEAR(patch.data(find_row(film, name), i), value,
                    1e-6 * std::abs(value) + 1e-12)
            << name;
}
} // namespace
} // namespace taut::io
