#include <taut/base/exceptions.h>
#include <taut/io/cell_address.h>

#include <algorithm>

namespace taut::io
{
namespace
{
/// Every cell that must be refined to reach `cells`.
std::set<CellAddress> find_ancestors(const std::set<CellAddress>& cells)
{
  std::set<CellAddress> ancestors;
  for (CellAddress address : cells)
    while (!address.children.empty())
    {
      address.children.pop_back();
      if (!ancestors.insert(address).second)
        break;
    }
  return ancestors;
}

/// Whether any rank had something to refine.
bool refine_once(const std::set<CellAddress>& ancestors,
                 fe::Triangulation& triangulation)
{
  unsigned int flagged = 0;
  for (const auto& cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned() && ancestors.count(get_address(cell)) > 0)
    {
      cell->set_refine_flag();
      flagged = 1;
    }
  if (dealii::Utilities::MPI::max(flagged, triangulation.get_communicator()) ==
      0)
    return false;
  triangulation.execute_coarsening_and_refinement();
  return true;
}
} // namespace

CellAddress
get_address(const dealii::TriaIterator<dealii::CellAccessor<2, 3>>& cell)
{
  CellAddress address;
  auto ancestor = cell;
  while (ancestor->level() > 0)
  {
    const auto parent = ancestor->parent();
    for (unsigned int child = 0; child < parent->n_children(); ++child)
      if (parent->child(child) == ancestor)
        address.children += static_cast<char>('0' + child);
    ancestor = parent;
  }
  std::reverse(address.children.begin(), address.children.end());
  // The coarse cell of a CellId counts the trees of p4est instead.
  address.coarse = ancestor->index();
  return address;
}

void refine_to(const std::set<CellAddress>& cells,
               fe::Triangulation& triangulation)
{
  const std::set<CellAddress> ancestors = find_ancestors(cells);
  while (refine_once(ancestors, triangulation))
  {
  }
  unsigned int strange = triangulation.n_global_active_cells() != cells.size();
  for (const auto& cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned() && cells.count(get_address(cell)) == 0)
      strange = 1;
  if (dealii::Utilities::MPI::max(strange, triangulation.get_communicator()) >
      0)
    throw BadInput("the refined cells of the checkpoint do not tile the mesh");
}
} // namespace taut::io
