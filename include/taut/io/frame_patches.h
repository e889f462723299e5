#pragma once

#include <taut/io/patch_columns.h>
#include <taut/structure/frame_fields.h>

#include <vector>

namespace taut::io
{
/// Frames as deal.II's output format knows them: one patch per beam element,
/// with its two or three nodes from one end to the other. The points are those
/// of the beams' axes in the mesh (m); the deformed frame is that plus the
/// displacement.
///
/// What every point carries, SI units:
///   displacement (m)           vector
///   axis_1, axis_2, axis_3     unit vectors in space: along the beam, along
///   the
///                              width and along the thickness of the section
///   force (N)                  along axis 1, 2, 3 of the section: normal force
///                              and shear
///   moment (N m)               about axis 1, 2, 3: torsion and bending
///   strain                     largest of the section's faces
///   width, thickness (m)       of the section; that of a general one is its
///                              Depth, and its width that of the rectangle
///                              with the same ratio of bending stiffnesses
///   frame                      number from 0 in the order of the case
/// All are those of the element, so that a node of two elements is there twice.
struct FramePatches : PatchColumns
{
  std::vector<dealii::DataOutBase::Patch<1, 3>> patches;
};

/// `frames` are those of the description.
FramePatches
make_frame_patches(const std::vector<structure::FrameElementFields>& elements,
                   const std::vector<structure::Frame>& frames);
} // namespace taut::io
