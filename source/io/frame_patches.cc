#include <taut/io/frame_patches.h>

#include <cmath>

namespace taut::io
{
namespace
{
using structure::FrameElementFields;
using structure::FramePoint;

void name_columns(PatchColumns& columns)
{
  columns.add_vector("displacement", "m");
  for (const char* axis : {"axis_1", "axis_2", "axis_3"})
    columns.add_vector(axis);
  columns.add_vector("force", "N");
  columns.add_vector("moment", "N m");
  columns.add_scalar("strain");
  columns.add_scalar("width", "m");
  columns.add_scalar("thickness", "m");
  columns.add_scalar("frame");
}

/// E I_3/(E I_2) = width^2/thickness^2 of a rectangle.
double compute_width(const structure::BeamSection& section)
{
  const auto& bending = section.bending_stiffness;
  return section.thickness * std::sqrt(bending[1] / bending[0]);
}

/// All values of a node in the order of the columns, then its place.
std::vector<double> make_column(const FramePoint& point,
                                const structure::BeamSection& section,
                                const unsigned int frame)
{
  std::vector<double> values;
  const auto append = [&values](const std::array<double, 3>& vector)
  { values.insert(values.end(), vector.begin(), vector.end()); };
  append(point.displacement);
  for (const auto& axis : point.axes)
    append(axis);
  append(point.force);
  append(point.moment);
  append({point.strain, compute_width(section), section.thickness});
  values.push_back(frame);
  append(point.mesh_position);
  return values;
}

dealii::DataOutBase::Patch<1, 3>
make_patch(const FrameElementFields& element,
           const structure::BeamSection& section, const unsigned int n_columns)
{
  dealii::DataOutBase::Patch<1, 3> patch;
  patch.reference_cell = dealii::ReferenceCells::Line;
  patch.n_subdivisions = element.nodes.size() - 1;
  patch.points_are_available = true;
  patch.data.reinit(n_columns + 3, element.nodes.size());
  for (unsigned int i = 0; i < element.nodes.size(); ++i)
  {
    const auto values = make_column(element.nodes[i], section, element.frame);
    for (unsigned int row = 0; row < values.size(); ++row)
      patch.data(row, i) = values[row];
  }
  for (unsigned int d = 0; d < 3; ++d)
  {
    patch.vertices[0][d] = element.nodes.front().mesh_position[d];
    patch.vertices[1][d] = element.nodes.back().mesh_position[d];
  }
  return patch;
}
} // namespace

FramePatches make_frame_patches(const std::vector<FrameElementFields>& elements,
                                const std::vector<structure::Frame>& frames)
{
  FramePatches result;
  name_columns(result);
  for (const FrameElementFields& element : elements)
  {
    result.patches.push_back(make_patch(
        element, frames.at(element.frame).section, result.names.size()));
    result.patches.back().patch_index = result.patches.size() - 1;
  }
  return result;
}
} // namespace taut::io
