#pragma once

#include <taut/fe/triangulation.h>

#include <set>
#include <string>
#include <tuple>

namespace taut::io
{
/// A cell, named independently of the partition: the coarse cell by the place
/// of its quad in MeshData, and which child was taken at each refinement.
struct CellAddress
{
  unsigned int coarse = 0;
  std::string children; ///< one digit per level

  bool operator<(const CellAddress& other) const
  {
    return std::tie(coarse, children) < std::tie(other.coarse, other.children);
  }
  template <typename Archive>
  void serialize(Archive& archive, const unsigned int)
  {
    archive& coarse& children;
  }
};

CellAddress
get_address(const dealii::TriaIterator<dealii::CellAccessor<2, 3>>& cell);

/// Refines `triangulation`, which holds the coarse mesh, until `cells` are its
/// active cells. Collective. Errors: BadInput if they do not tile the mesh.
void refine_to(const std::set<CellAddress>& cells,
               fe::Triangulation& triangulation);
} // namespace taut::io
