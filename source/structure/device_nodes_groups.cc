#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>
#include <taut/fe/reference_element.h>
#include <taut/structure/device_nodes.h>

#include <cmath>
#include <set>

namespace taut::structure
{
namespace
{
using DoFHandler = dealii::DoFHandler<2, 3>;

double distance(const dealii::Point<3>& a, const fe::Coordinates& b)
{
  return a.distance(dealii::Point<3>(b[0], b[1], b[2]));
}

std::vector<std::string> all_group_names(const fe::MeshData& mesh)
{
  std::vector<std::string> names;
  for (unsigned int dimension = 0; dimension < 3; ++dimension)
    for (const auto& name : mesh.groups.get_names(dimension))
      names.push_back(name);
  return names;
}

/// Calls function(cell, face) for the faces of known cells in the line group.
template <typename Function>
void for_each_face(const DoFHandler& dof_handler,
                   const std::set<unsigned int>& ids, const Function& function)
{
  for (const auto& cell : dof_handler.active_cell_iterators())
    if (!cell->is_artificial())
      for (const unsigned int face : cell->face_indices())
        if (ids.count(cell->face(face)->manifold_id()) > 0)
          function(cell, face);
}

void add_line_nodes(const std::set<unsigned int>& ids,
                    const DoFHandler& dof_handler,
                    std::set<fe::GlobalNode>& nodes)
{
  const fe::ReferenceElement element(dof_handler.get_fe().degree);
  std::vector<dealii::types::global_dof_index> dofs(element.n_nodes);
  for_each_face(dof_handler, ids,
                [&](const auto& cell, const unsigned int face)
                {
                  cell->get_dof_indices(dofs);
                  for (const auto node : element.face_nodes[face])
                    nodes.insert(dofs[node]);
                });
}

void add_surface_nodes(const std::set<unsigned int>& ids,
                       const DoFHandler& dof_handler,
                       std::set<fe::GlobalNode>& nodes)
{
  std::vector<dealii::types::global_dof_index> dofs(
      dof_handler.get_fe().n_dofs_per_cell());
  for (const auto& cell : dof_handler.active_cell_iterators())
    if (!cell->is_artificial() && ids.count(cell->material_id()) > 0)
    {
      cell->get_dof_indices(dofs);
      nodes.insert(dofs.begin(), dofs.end());
    }
}

void add_point_nodes(const std::string& group, const fe::MeshData& mesh,
                     const DoFHandler& dof_handler,
                     std::set<fe::GlobalNode>& nodes)
{
  const auto points = fe::get_group_points(mesh, group);
  for (const auto& cell : dof_handler.active_cell_iterators())
    if (!cell->is_artificial())
      for (const unsigned int vertex : cell->vertex_indices())
      {
        const auto x = cell->vertex(vertex);
        for (const auto& point : points)
          if (distance(x, point) < 1e-8 * cell->diameter())
            nodes.insert(cell->vertex_dof_index(vertex, 0));
      }
}

} // namespace

std::vector<fe::GlobalNode>
find_group_nodes(const std::vector<std::string>& groups,
                 const fe::MeshData& mesh, const DoFHandler& dof_handler,
                 const Named& entry, const std::string& key)
{
  std::set<fe::GlobalNode> nodes;
  for (const auto& group : groups)
  {
    if (mesh.groups.has(0, group))
      add_point_nodes(group, mesh, dof_handler, nodes);
    else if (mesh.groups.has(1, group))
      add_line_nodes(mesh.groups.get_ids(1, group), dof_handler, nodes);
    else if (mesh.groups.has(2, group))
      add_surface_nodes(mesh.groups.get_ids(2, group), dof_handler, nodes);
    else
      throw BadInput("the mesh has no group '" + group + "'; " +
                         suggest(group, all_group_names(mesh)),
                     "", entry.source_line, key + " " + entry.name);
  }
  return {nodes.begin(), nodes.end()};
}
} // namespace taut::structure
