#pragma once

#include <taut/fe/mesh_groups.h>

#include <array>
#include <vector>

namespace taut::fe
{
/// A point in space (m).
using Coordinates = std::array<double, 3>;

/// A quadrilateral. The vertices run around the cell; counter-clockwise as seen
/// from the side to which the surface normal points.
struct MeshQuad
{
  /// Indices into MeshData::vertices.
  std::array<unsigned int, 4> vertices{};
  /// Only if MeshData::order is 2, indices into MeshData::middle_points: middle
  /// i < 4 lies on the edge from vertex i to the next, the last in the centre.
  std::array<unsigned int, 5> middles{};
  /// Id of the set of surface groups.
  unsigned int group_set = 0;

  template <typename Archive>
  void serialize(Archive& archive, const unsigned int)
  {
    archive& vertices& middles& group_set;
  }
};

/// An edge of a quadrilateral, or a line beside the surface, that lies in a
/// group of lines.
struct MeshLine
{
  std::array<unsigned int, 2> vertices{};
  /// Only if MeshData::order is 2, index into MeshData::middle_points.
  unsigned int middle = 0;
  /// Id of the set of line groups.
  unsigned int group_set = 0;

  template <typename Archive>
  void serialize(Archive& archive, const unsigned int)
  {
    archive& vertices& middle& group_set;
  }
};

/// A vertex that lies in a group of points.
struct MeshPoint
{
  unsigned int vertex = 0;
  /// Id of the set of point groups.
  unsigned int group_set = 0;

  template <typename Archive>
  void serialize(Archive& archive, const unsigned int)
  {
    archive& vertex& group_set;
  }
};

/// A mesh of quadrilaterals and lines as it was read, before any refinement. It
/// is read on one rank and broadcast.
struct MeshData
{
  /// 1: straight edges, 2: every cell carries nine points.
  unsigned int order = 1;
  /// Those of the quads come first, then those that only free lines have.
  std::vector<Coordinates> vertices;
  std::vector<Coordinates> middle_points;
  std::vector<MeshQuad> quads;
  std::vector<MeshLine> lines;
  /// Lines of groups that are no edge of a quadrilateral.
  std::vector<MeshLine> free_lines;
  std::vector<MeshPoint> points;
  MeshGroups groups;
  /// There is no surface: the one quadrilateral carries nothing and is there
  /// because a triangulation cannot be empty.
  bool only_lines = false;

  template <typename Archive>
  void serialize(Archive& archive, const unsigned int)
  {
    archive& order& vertices& middle_points& quads& lines& free_lines& points&
        groups& only_lines;
  }
};

/// Gives a mesh that has only lines one quadrilateral, in no group and as large
/// as the box around the lines, outside of it: nothing of it coincides with the
/// lines. Sets `only_lines`.
void add_empty_surface(MeshData& mesh);

/// The coordinates (m) of all points in `group`.
/// Errors: BadInput if the mesh has no such group of points.
std::vector<Coordinates> get_group_points(const MeshData& mesh,
                                          const std::string& group);
} // namespace taut::fe
