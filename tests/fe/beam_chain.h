#pragma once

#include <taut/base/rotation.h>
#include <taut/fe/beam_element.h>

#include <functional>
#include <vector>

// A straight cantilever along x of equal beam elements, solved by Newton's
// method with dense Gaussian elimination: enough to test the element alone.
namespace taut::fe
{
class BeamChain
{
public:
  BeamChain(unsigned int n_elements, unsigned int nodes_per_element,
            double length, const BeamStiffness& stiffness);

  unsigned int n_nodes() const
  {
    return n_nodes_;
  }
  Vector3 get_position(unsigned int node) const;
  Quaternion get_rotation(unsigned int node) const;

  /// Finds the equilibrium under a dead force and a moment of constant
  /// direction at the tip, from the current state. The stiffness uses the
  /// resultants of the strains extrapolated linearly by the last step. Throws
  /// std::runtime_error unless the forces reach rounding.
  void solve(const Vector3& tip_force, const Vector3& tip_moment);

private:
  std::vector<double> gather(unsigned int element,
                             const std::vector<double>& nodal) const;
  std::size_t number(unsigned int element, unsigned int unknown) const;
  void add_loads(const Vector3& force, const Vector3& moment);
  void assemble();
  void extrapolate_resultants(const std::vector<double>& step);

  unsigned int n_nodes_, nodes_per_element_;
  BeamStiffness stiffness_;
  std::vector<BeamElement> elements_;
  std::vector<std::vector<BeamResultants>> resultants_;
  /// Of every node (x, Q), 7 numbers.
  std::vector<double> unknowns_;
  std::vector<double> residual_;
  std::vector<std::vector<double>> matrix_;
};
} // namespace taut::fe
