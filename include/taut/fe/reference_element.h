#pragma once

#include <vector>

namespace taut::fe
{
/// Shape functions of Q1 or Q2 on the unit square at the Gauss points, nodes in
/// deal.II's order of FE_Q. As many points as nodes.
struct ReferenceElement
{
  /// Errors: BadInput unless degree is 1 or 2.
  explicit ReferenceElement(unsigned int degree);

  unsigned int degree;
  unsigned int n_nodes;
  std::vector<double> values;    ///< N_a, [q][a]
  std::vector<double> gradients; ///< dN_a/d(xi, eta), [q][a][2]
  std::vector<double> weights;   ///< [q], their sum is 1
  std::vector<double> points;    ///< (xi, eta), [q][2]
  /// The same on the edge of the unit line, for loads on lines.
  std::vector<double> line_values;    ///< [q][k], k along the edge
  std::vector<double> line_gradients; ///< [q][k]
  std::vector<double> line_weights;   ///< [q]
  /// Nodes of face f in the order of line_values, [f][k].
  std::vector<std::vector<unsigned int>> face_nodes;
};
} // namespace taut::fe
