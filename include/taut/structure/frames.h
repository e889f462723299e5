#pragma once

#include <taut/fe/beam_element.h>
#include <taut/fe/tangent_matrix.h>
#include <taut/structure/frame_nodes.h>
#include <taut/structure/loads.h>

#include <vector>

namespace taut::structure
{
/// A beam between nodes of this rank.
struct FrameElement
{
  unsigned int frame; ///< index in the description
  fe::BeamElement beam;
  std::vector<fe::LocalNode> positions; ///< nodes: ends, middle
  std::vector<unsigned int> rotations;  ///< of the same, in Nodes::rotations
  /// Whether this rank assembles it; each element has one such rank.
  bool assembled_here;

  /// All nodes: positions, vector parts and scalar parts of the rotations.
  std::vector<fe::LocalNode> get_nodes(const fe::Nodes& nodes) const;
};

/// The beams of a device. Every rank holds all of them and assembles some.
class Frames
{
public:
  Frames(const Device& device, const FrameNodes& frame_nodes,
         const fe::Nodes& nodes);

  const std::vector<FrameElement>& elements() const
  {
    return elements_;
  }
  bool empty() const
  {
    return elements_.empty();
  }
  /// Multiplies all stiffnesses, on the way to a rest shape; 1 at first.
  void set_stiffening(const double factor)
  {
    stiffening_ = factor;
  }
  double stiffening() const
  {
    return stiffening_;
  }
  fe::BeamStiffness get_stiffness(unsigned int frame,
                                  const LoadState& loads) const;

  /// Unknowns of an element's beam among nodal values (positions or rates).
  std::vector<double> gather(const FrameElement& element,
                             const fe::NodalVector& values) const;

  /// forces += internal forces at `positions`.
  void add_forces(const LoadState& loads, const fe::NodalVector& positions,
                  fe::NodalVector& forces) const;
  /// forces += what Kelvin-Voigt damping resists `rates` with.
  void add_damping(const LoadState& loads, const fe::NodalVector& positions,
                   const fe::NodalVector& rates, fe::NodalVector& forces) const;
  /// (1/2) strain . stiffness . strain (J), of this rank's elements.
  double compute_energy(const LoadState& loads,
                        const fe::NodalVector& positions) const;

  /// dT/dt of every frame times the change of its energy with temperature (W),
  /// of this rank's elements.
  double compute_heat_power(const LoadState& loads,
                            const fe::NodalVector& positions) const;

  /// Adds tangent, damping times `rate_factor` (1/s) and translational mass
  /// times `mass_factor` (1/s^2); mass damping joins with `rate_factor`.
  /// `predicted`: the resultants in the geometric part are those that the last
  /// linearisation predicts here (Magisano et al. 2017), which keeps Newton's
  /// steps long where thin beams turn: their true axial force is spurious
  /// before the equilibrium is found.
  void add_stiffness(const LoadState& loads, const fe::NodalVector& positions,
                     double rate_factor, double mass_factor, bool predicted,
                     fe::TangentMatrix& matrix);
  /// Adds the mass (kg), or that times each frame's mass damping (kg/s).
  void add_mass(bool damping, fe::TangentMatrix& matrix) const;
  /// result += M x of the translations, or the same with mass damping.
  void add_mass_product(bool damping, const fe::NodalVector& x,
                        fe::NodalVector& result) const;

  /// The next predicted stiffness is one of its own state.
  void forget_linearisation();

  /// forces += nodal lengths times `load` (N/m).
  void add_line_load(const std::array<double, 3>& load,
                     fe::NodalVector& forces) const;
  /// Sum of the squares of EA/length (N^2/m^2) of this rank's elements.
  double compute_axial_spring_square() const;

  /// Rotary inertia lumped at every rotation, about x, y, z of the mesh
  /// (kg m^2, row-major), and the same times mass damping. This rank's share.
  void add_rotary_inertia(std::vector<std::array<double, 9>>& inertia,
                          std::vector<std::array<double, 9>>& damping) const;
  /// A stiffness (N/m) of every stored quaternion against turning. This rank's
  /// share.
  void add_rotation_stiffness(std::vector<double>& stiffness) const;

private:
  std::vector<fe::BeamResultants>
  compute_resultants(const fe::BeamStiffness& stiffness,
                     const std::vector<fe::BeamResultants>& strains) const;
  std::vector<fe::BeamResultants>
  predict_strains(std::size_t index, const std::vector<double>& unknowns) const;
  void scatter(const FrameElement& element, const std::vector<double>& forces,
               fe::NodalVector& nodal) const;
  void add_element(const FrameElement& element, const std::vector<double>& beam,
                   const fe::NodalVector* positions,
                   fe::TangentMatrix& matrix) const;
  std::vector<double> make_mass(const FrameElement& element,
                                double factor) const;

  const Device& device_;
  const fe::Nodes& nodes_;
  std::vector<FrameElement> elements_;
  double stiffening_ = 1;
  /// By element: unknowns at the last linearisation; empty before it.
  std::vector<std::vector<double>> linearised_;
};
} // namespace taut::structure
