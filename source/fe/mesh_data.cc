#include <taut/fe/mesh_data.h>

namespace taut::fe
{
std::vector<Coordinates> get_group_points(const MeshData& mesh,
                                          const std::string& group)
{
  const std::set<unsigned int> ids = mesh.groups.get_ids(0, group);
  std::vector<Coordinates> coordinates;
  for (const MeshPoint& point : mesh.points)
    if (ids.count(point.group_set) > 0)
      coordinates.push_back(mesh.vertices[point.vertex]);
  return coordinates;
}
} // namespace taut::fe
