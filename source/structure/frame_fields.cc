#include <taut/structure/frame_fields.h>

#include <algorithm>
#include <cmath>

namespace taut::structure
{
namespace
{
/// The nodes of an element (ends, then middle) from one end to the other.
std::vector<unsigned int> order_along(const unsigned int n_nodes)
{
  return n_nodes == 2 ? std::vector<unsigned int>{0, 1}
                      : std::vector<unsigned int>{0, 2, 1};
}

/// Where a node of the element is and how its section has turned.
FramePoint place_point(const FrameElement& element, const fe::Nodes& nodes,
                       const std::vector<double>& unknowns,
                       const unsigned int node)
{
  FramePoint point{};
  point.mesh_position = nodes.mesh_position[element.positions[node]];
  for (unsigned int c = 0; c < 3; ++c)
    point.displacement[c] = unknowns[3 * node + c] - point.mesh_position[c];
  const double* q = &unknowns[3 * element.positions.size() + 4 * node];
  const auto reference = element.beam.compute_axes(node);
  for (unsigned int i = 0; i < 3; ++i)
    point.axes[i] = rotate({q[0], q[1], q[2], q[3]}, reference[i]);
  return point;
}

void add_resultants(const fe::BeamResultants& strain,
                    const fe::BeamStiffness& stiffness, const double thickness,
                    FramePoint& point)
{
  for (unsigned int i = 0; i < 3; ++i)
  {
    point.force[i] = stiffness[i] * strain[i];
    point.moment[i] = stiffness[3 + i] * strain[3 + i];
  }
  // Bending adds to the stretching on one face what it takes on the other.
  point.strain = std::abs(strain[0]) + thickness / 2 * std::abs(strain[4]);
}
} // namespace

std::vector<FrameElementFields> compute_frame_fields(Structure& structure,
                                                     const LoadState& loads,
                                                     const double* u)
{
  const fe::NodalVector& positions = structure.compute_positions(loads, u);
  const Frames& frames = structure.frames();
  std::vector<FrameElementFields> fields;
  // Every rank sees all elements with all their nodes.
  for (const auto& element : frames.elements())
  {
    const auto unknowns = frames.gather(element, positions);
    const auto strains =
        element.beam.extrapolate(element.beam.compute_strains(unknowns.data()));
    const auto stiffness = frames.get_stiffness(element.frame, loads);
    const double thickness =
        structure.device().frames[element.frame].section.thickness;
    FrameElementFields shown{element.frame, {}};
    for (const auto node : order_along(element.positions.size()))
    {
      shown.nodes.push_back(
          place_point(element, structure.nodes(), unknowns, node));
      add_resultants(strains[node], stiffness, thickness, shown.nodes.back());
    }
    fields.push_back(shown);
  }
  return fields;
}
} // namespace taut::structure
