#pragma once

#include <taut/structure/structure.h>

#include <array>
#include <vector>

namespace taut::structure
{
/// What a frame shows at a node of one of its elements.
struct FramePoint
{
  std::array<double, 3> mesh_position; ///< of the axis (m)
  std::array<double, 3> displacement;  ///< of the axis (m)
  /// Unit vectors of the section's axes 1, 2, 3 in space.
  std::array<std::array<double, 3>, 3> axes;
  std::array<double, 3> force;  ///< normal, shear along 2 and 3 (N)
  std::array<double, 3> moment; ///< torsion, bending about 2 and 3 (N m)
  double strain; ///< largest of the faces, of bending about 2 and stretching
};

/// The nodes run from one end of the element to the other: two or three.
struct FrameElementFields
{
  unsigned int frame; ///< index in the description
  std::vector<FramePoint> nodes;
};

/// All elements of all frames in the order of the description, the same on
/// every rank. Collective; leaves the positions in `structure` at `u`.
std::vector<FrameElementFields> compute_frame_fields(Structure& structure,
                                                     const LoadState& loads,
                                                     const double* u);
} // namespace taut::structure
