#pragma once

#include <cstddef>
#include <vector>

// From the quaternions Q of a beam's nodes to the unit quaternions q = Q/|Q|
// that are interpolated. Unknowns are [x of every node | Q of every node].
namespace taut::fe
{
/// The unknowns with q in the place of every Q.
std::vector<double> normalise(unsigned int n_nodes, const double* unknowns);

/// The derivative of every q by its Q, (1 - q (x) q)/|Q|, times the four
/// numbers of every node that lie `stride` apart.
void project(unsigned int n_nodes, const std::vector<double>& unit,
             const double* unknowns, double* numbers, std::size_t stride = 1);

/// matrix += second derivative of every q by its Q, contracted with the forces
/// g on q: -(q (x) g + g (x) q + (g.q)(1 - 3 q (x) q))/|Q|^2.
void add_curvature(unsigned int n_nodes, const std::vector<double>& unit,
                   const double* unknowns, const std::vector<double>& forces,
                   double* matrix);
} // namespace taut::fe
