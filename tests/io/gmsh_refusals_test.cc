// What the reader of meshes does not accept, and what it says.
#include <taut/base/exceptions.h>
#include <taut/io/gmsh_reader.h>

#include <gtest/gtest.h>
#include <io/mesh_folder.h>
#include <io/mesh_measures.h>

#include <cstdlib>

namespace
{
using namespace taut;
using namespace taut::io;

class GmshRefusals : public MeshFolder
{
protected:
  /// The refusal of a geometry.
  BadInput refuse(const std::string& text,
                  const Parameters& parameters = {}) const
  {
    return refuse_file(write("mesh.geo", text), parameters);
  }

  BadInput refuse_file(const std::string& file,
                       const Parameters& parameters = {}) const
  {
    try
    {
      io::read_mesh(file, parameters);
    }
    catch (const BadInput& error)
    {
      EXPECT_NE(std::string(error.what()).find(file), std::string::npos);
      return error;
    }
    ADD_FAILURE() << "the mesh was accepted";
    return BadInput("");
  }
};

bool contains(const BadInput& error, const std::string& text)
{
  return error.message().find(text) != std::string::npos;
}

TEST_F(GmshRefusals, refuses_parameters_that_the_geometry_lacks)
{
  const BadInput error = refuse(grouped, {{"sise", 1.}});
  EXPECT_EQ(error.key(), "sise");
  EXPECT_TRUE(contains(error, "did you mean 'size'"));
  EXPECT_EQ(
      refuse_file(write_msh(grouped, 4.1, false, "mesh.msh"), {{"size", 1.}})
          .key(),
      "size");
}

TEST_F(GmshRefusals, refuses_files_that_cannot_be_read)
{
  EXPECT_TRUE(contains(refuse_file(get_path("none.geo")), "missing"));
  EXPECT_TRUE(contains(refuse_file(write("a.geo", "")), "empty"));
  EXPECT_TRUE(contains(refuse_file(write("a.msh", " \n")), "empty"));
  EXPECT_TRUE(contains(refuse_file(write("a.vtk", "x")), ".geo or .msh"));
  std::filesystem::create_directories(get_path("folder.geo"));
  EXPECT_TRUE(contains(refuse_file(get_path("folder.geo")), "cannot be read"));
  refuse_file(write("a.msh", "$MeshFormat\n9.9 0 8\n$EndMeshFormat\n"));
  refuse_file(write("a.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                             "$Nodes\n4\n1 0 0 0\n"));
}

TEST_F(GmshRefusals, tells_the_line_of_a_syntax_error)
{
  const BadInput error = refuse("Point(1) = {0, 0, 0};\nPoint(2) = {1, 0;\n");
  EXPECT_EQ(error.line(), 2u);
  EXPECT_TRUE(contains(error, "syntax error"));
  EXPECT_TRUE(contains(refuse("Line(1) = {1, 2};"), "Unknown control point"));
}

TEST_F(GmshRefusals, refuses_triangles_and_tells_how_to_recombine_them)
{
  const std::string group = "Physical Surface(\"film\") = {1, 2};\n";
  const BadInput error = refuse(squares + group);
  EXPECT_TRUE(contains(error, "16 of the 16 surface elements are triangles"));
  EXPECT_TRUE(contains(error, "Recombine Surface {:};"));
  EXPECT_TRUE(contains(error, "Mesh.Algorithm = 6;"));
  EXPECT_TRUE(contains(refuse(squares + "Recombine Surface {1};" + group),
                       "8 of the 12"));
}

TEST_F(GmshRefusals, the_advised_recombination_gives_quadrilaterals)
{
  const std::string triangle = R"(
DefineConstant[ size = .25 ];
Point(1) = {0, 0, 0, size}; Point(2) = {1, 0, 0, size};
Point(3) = {0, 1, 0, size};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 1};
Curve Loop(1) = {1 : 3}; Plane Surface(1) = {1};
Physical Surface("film") = {1};
Recombine Surface {:};
Mesh.RecombinationAlgorithm = 1;
Mesh.Algorithm = 6;
)";
  const BadInput error = refuse(triangle);
  EXPECT_TRUE(contains(error, "2 of the"));
  EXPECT_TRUE(contains(error, "'Mesh.SubdivisionAlgorithm = 1;'"));
  const std::string all_quads = triangle + "Mesh.SubdivisionAlgorithm = 1;\n";
  for (const double size : {.2, .25})
    EXPECT_NEAR(compute_area(read_text(all_quads, {{"size", size}}), "film"),
                .5, 1e-14);
}

TEST_F(GmshRefusals, refuses_a_last_line_that_gmsh_reads_in_part)
{
  EXPECT_TRUE(contains(refuse(grouped + "Mesh.ElementOrder = 2; x = 1;"),
                       "line break"));
}

TEST_F(GmshRefusals, refuses_the_algorithm_that_crashes_gmsh)
{
  EXPECT_TRUE(
      contains(refuse(grouped + "Mesh.Algorithm = 8;"), "Mesh.Algorithm = 6"));
}

TEST_F(GmshRefusals, refuses_meshes_without_surfaces_or_groups)
{
  EXPECT_TRUE(contains(refuse("Point(1) = {0, 0, 0};"), "no surface elements"));
  EXPECT_TRUE(contains(refuse("Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0};"
                              "Line(1) = {1, 2};\n"),
                       "no lines in a physical group"));
  EXPECT_TRUE(contains(refuse(recombined), "8 of the 8"));
  EXPECT_TRUE(contains(refuse(recombined + "Physical Surface(\"left\") = {1};"),
                       "4 of the 8 surface elements lie in no physical group"));
}

TEST_F(GmshRefusals, refuses_points_beside_film_and_frame)
{
  const BadInput point = refuse(grouped + "Point(9) = {0, 0, 1};"
                                          "Physical Point(\"star\") = {9};\n");
  EXPECT_TRUE(contains(point, "'star'"));
  EXPECT_TRUE(contains(point, "neither a corner"));
}

TEST_F(GmshRefusals, refuses_lines_without_length)
{
  EXPECT_TRUE(contains(
      refuse_file(write("mesh.msh",
                        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                        "$PhysicalNames\n1\n1 7 \"leg\"\n$EndPhysicalNames\n"
                        "$Nodes\n2\n1 0 0 0\n2 1 0 0\n$EndNodes\n"
                        "$Elements\n2\n1 1 2 7 1 1 2\n2 1 2 7 1 2 2\n"
                        "$EndElements\n")),
      "'leg' has no length"));
}

TEST_F(GmshRefusals, refuses_elements_of_other_orders)
{
  EXPECT_TRUE(contains(refuse(grouped + "Mesh.ElementOrder = 3;"), "order"));
  EXPECT_TRUE(contains(refuse(grouped + "Mesh.ElementOrder = 2;"
                                        "Mesh.SecondOrderIncomplete = 1;\n"),
                       "Mesh.SecondOrderIncomplete = 0"));
}

/// A mesh of msh 2.2 with two cells, the second given by its nodes, of which
/// there are nine in rows of three.
std::string make_two_cells(const std::string& second)
{
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                     "$PhysicalNames\n1\n2 7 \"film\"\n$EndPhysicalNames\n"
                     "$Nodes\n9\n";
  for (int node = 0; node < 9; ++node)
    text += std::to_string(node + 1) + " " + std::to_string(node % 3) + " " +
            std::to_string(node / 3) + " 0\n";
  return text + "$EndNodes\n$Elements\n2\n1 3 2 7 1 1 2 5 4\n2 " + second +
         "\n$EndElements\n";
}

TEST_F(GmshRefusals, refuses_cells_without_extent_and_mixed_orders)
{
  const auto file = [&](const std::string& second)
  { return write("mesh.msh", make_two_cells(second)); };
  EXPECT_EQ(io::read_mesh(file("3 2 7 1 4 5 8 7"), {}).quads.size(), 2u);
  EXPECT_TRUE(contains(refuse_file(file("3 2 7 1 4 5 5 7")), "no length"));
  EXPECT_TRUE(contains(refuse_file(file("10 2 7 2 1 3 9 7 2 6 8 4 5")),
                       "order 1 and 2"));
}

TEST_F(GmshRefusals, refuses_parameters_where_no_file_can_be_written)
{
  const std::string file = write("mesh.geo", grouped);
  setenv("TMPDIR", "/proc", 1);
  EXPECT_THROW(io::read_mesh(file, {{"size", 2.}}), BadInput);
  unsetenv("TMPDIR");
  EXPECT_NEAR(compute_area(io::read_mesh(file, {{"size", 2.}}), "all"), 8,
              1e-13);
}
} // namespace
