// The file of the frames, read back.
#include <taut/io/fields_writer.h>

#include "io/made_up_beams.h"
#include "io/vtu_files.h"

namespace taut::io
{
namespace
{
using namespace testing;

TEST(FramePatches, BeamsAreLinesBetweenTheirNodes)
{
  const SharedFolder folder("fields_beams");
  const MadeUpBeams beams;
  FieldsWriter writer(folder.path(), MPI_COMM_WORLD);
  writer.write(.25, {}, make_frame_patches(beams.elements, beams.frames));
  if (!is_first())
    return;
  const ptree piece = read_xml(folder.get("fields/beams_00000.vtu"))
                          .get_child("VTKFile.UnstructuredGrid.Piece");
  EXPECT_EQ(piece.get<unsigned int>("<xmlattr>.NumberOfPoints"), 6u);
  const ptree& cells = piece.get_child("Cells");
  EXPECT_EQ(read_array<int>(cells, "connectivity"),
            (std::vector<int>{0, 1, 1, 2, 3, 4, 4, 5}));
  constexpr std::uint8_t vtk_line = 3;
  EXPECT_EQ(read_array<std::uint8_t>(cells, "types"),
            std::vector<std::uint8_t>(4, vtk_line));
  const ptree& fields = piece.get_child("PointData");
  const auto x = decode<float>(piece.get_child("Points.DataArray"));
  const auto displacement = read_array<float>(fields, "displacement");
  const auto moment = read_array<float>(fields, "moment");
  const auto across = read_array<float>(fields, "axis_3");
  const auto strain = read_array<float>(fields, "strain");
  for (unsigned int i = 0; i < 6; ++i)
  {
    const double s = i / 3 + .5 * (i % 3);
    EXPECT_NEAR(x[3 * i], .1 * s, round_off);
    EXPECT_NEAR(x[3 * i + 2], .1 * s * s, 10 * round_off);
    EXPECT_NEAR(displacement[3 * i + 1], .01 * s, round_off);
    EXPECT_NEAR(moment[3 * i + 1], 5 * s, 1e-6);
    EXPECT_EQ(across[3 * i + 1], -1);
    EXPECT_NEAR(strain[i], .001 * s, round_off);
    EXPECT_NEAR(read_array<float>(fields, "width")[i], .01, round_off);
    EXPECT_NEAR(read_array<float>(fields, "thickness")[i], .002, round_off);
    EXPECT_EQ(read_array<float>(fields, "frame")[i], 1);
    EXPECT_EQ(read_array<float>(fields, "force")[3 * i + 2], 3);
  }
}

} // namespace
} // namespace taut::io
