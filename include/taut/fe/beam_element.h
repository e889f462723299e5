#pragma once

#include <array>
#include <vector>

// A geometrically exact beam (Simo-Reissner) of two or three nodes. Each node
// has a position x (m) and a quaternion Q of any length > 0; the rotation
// R(Q/|Q|) takes the reference section to the current one, so that in the
// reference state Q is (1, 0, 0, 0) times a length, whatever the direction of
// the beam: corners and T-joints share a node. x and the nodes' q = Q/|Q| are
// interpolated, then
//   Gamma = R_0^T (R^T x' - x_0'),  kappa = R_0^T 2 vec(conj(q) q')/|q|^2
// with R = R(q/|q|) and R_0 the section's axes in the reference state at the
// point: both are unchanged by rigid motions and by the length of any Q, and
// the forces on each node's Q are orthogonal to it. (Were Q itself
// interpolated, longer quaternions would weigh more: the ratio of two nodes'
// lengths would have forces of its own.) Reduced integration.
namespace taut::fe
{
/// E A, G A_2, G A_3 (N), G J, E I_2, E I_3 (N m^2): section axes 1 along the
/// beam, 3 the thickness, 2 = 3 x 1.
using BeamStiffness = std::array<double, 6>;

/// Strains or stress resultants at a point: Gamma (dimensionless; N) and kappa
/// (1/m; N m) along 1, 2, 3.
using BeamResultants = std::array<double, 6>;

struct BeamPointState;

class BeamElement
{
public:
  /// `nodes`: reference positions of the 2 ends and, for 3 nodes, then the
  /// middle (m). `normal`: direction of axis 3, projected across the beam.
  /// Errors: throws std::invalid_argument if the beam has no length or runs
  /// along `normal`.
  BeamElement(const std::vector<std::array<double, 3>>& nodes,
              const std::array<double, 3>& normal);

  unsigned int n_nodes() const
  {
    return n_nodes_;
  }
  /// Unknowns: [x of every node | Q of every node], 7 n_nodes.
  unsigned int n_unknowns() const
  {
    return 7 * n_nodes_;
  }
  unsigned int n_points() const
  {
    return points_.size();
  }
  double length() const;

  /// Strains at the integration points. Stress resultants are
  /// stiffness * strain.
  std::vector<BeamResultants> compute_strains(const double* unknowns) const;
  /// Rates of the strains for the rates of the unknowns.
  std::vector<BeamResultants> compute_strain_rates(const double* unknowns,
                                                   const double* rates) const;
  /// forces += B^T resultants, integrated: conjugate to the unknowns (N, N m
  /// over the unit of Q).
  void add_forces(const double* unknowns,
                  const std::vector<BeamResultants>& resultants,
                  double* forces) const;
  /// matrix (row-major) += B^T stiffness B + derivative of B^T times
  /// `resultants`, symmetric.
  void add_stiffness(const double* unknowns, const BeamStiffness& stiffness,
                     const std::vector<BeamResultants>& resultants,
                     double* matrix) const;
  /// (1/2) strain . stiffness . strain, integrated (J).
  double compute_energy(const BeamStiffness& stiffness,
                        const std::vector<BeamResultants>& strains) const;
  /// matrix[a][b] += integral N_a N_b ds (m), n_nodes x n_nodes.
  void add_shape_products(double* matrix) const;
  /// Integral of N_a ds by the rule whose points are the nodes (m).
  std::vector<double> compute_nodal_lengths() const;
  /// Section axes 1, 2, 3 in the reference state at a node, in its columns'
  /// order: axes[i] is the unit vector of axis i + 1.
  std::array<std::array<double, 3>, 3> compute_axes(unsigned int node) const;
  /// Resultants or strains of the points, extrapolated to the nodes.
  std::vector<BeamResultants>
  extrapolate(const std::vector<BeamResultants>& at_points) const;

private:
  /// An integration point: shape functions N_a, their derivatives by arc
  /// length (1/m), the weight (m), and the section's axes, of which the first
  /// is x_0'.
  struct Point
  {
    std::array<double, 3> values, derivatives;
    double weight;
    std::array<std::array<double, 3>, 3> axes;
  };
  /// dx_0/ds at the place s, from 0 to 1 along the beam (m).
  std::array<double, 3> compute_tangent(double place) const;
  /// Of nodal values [x of every node | q of every node].
  BeamPointState interpolate(const Point& point,
                             const std::vector<double>& nodal) const;
  /// Forces and stiffness conjugate to x and the unit quaternions q.
  std::vector<double>
  compute_unit_forces(const std::vector<double>& unit,
                      const std::vector<BeamResultants>& resultants) const;
  std::vector<double>
  compute_unit_stiffness(const std::vector<double>& unit,
                         const BeamStiffness& stiffness,
                         const std::vector<BeamResultants>& resultants) const;

  unsigned int n_nodes_;
  std::vector<Point> points_;
  std::vector<std::array<double, 3>> nodes_;
  std::array<double, 3> normal_;
};
} // namespace taut::fe
