#pragma once

#include <taut/fe/mesh_data.h>

#include <map>
#include <string>

namespace taut::io
{
/// Reads a mesh of quadrilaterals and lines from a `.msh` (2.2 or 4.1), or
/// meshes a `.geo` as it asks, with `geo_parameters` in place of the values
/// that its `DefineConstant` gives. Lengths are taken as metres.
///
/// A physical group keeps its name; one without gets its number as the name.
/// Surfaces outside every physical group are refused, lines and points outside
/// are left out. A line of a group that is no edge of a quadrilateral is a free
/// line: a frame beside the film; a mesh may have lines only. Nodes at the same
/// place become one, so that surfaces which touch are joined; nodes that no
/// cell uses fall away. The normals of the cells (and so the sense of a
/// pressure) are those of gmsh: the right-hand rule over the nodes of an
/// element, which `ReverseMesh Surface` turns around. gmsh 4.8 attaches the
/// groups of msh 2.2 to whole geometric entities (the second tag of an
/// element), so these must differ where the groups do.
///
/// Runs on the calling process alone; the caller broadcasts the result.
/// Errors: BadInput with gmsh's own message, its file and line where it is one
/// of syntax; for a parameter that the `.geo` does not define; for triangles,
/// with the way to recombine them; for points that neither a cell nor a line of
/// a group has as its corner; for a mesh without both.
fe::MeshData read_mesh(const std::string& file,
                       const std::map<std::string, double>& geo_parameters);
} // namespace taut::io
