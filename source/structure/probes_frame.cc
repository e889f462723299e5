#include <taut/structure/probes.h>

#include <algorithm>

namespace taut::structure
{
std::vector<Probes::Section>
Probes::find_sections(const Probe& probe, const std::size_t frame) const
{
  const FrameMesh& mesh = system_.structure().device_nodes().frames.mesh;
  const auto place = mesh.find_place(
      probe.at.empty() ? probe.point : find_place(probe, probe.at));
  std::vector<Section> sections;
  for (std::size_t i = 0; place && i < mesh.edges.size(); ++i)
  {
    const auto& places = mesh.edges[i].places;
    const auto found = std::find(places.begin(), places.end(), *place);
    if (mesh.edges[i].frame != frame || found == places.end())
      continue;
    // The fields have the middle between the ends.
    const std::size_t number = found - places.begin();
    const std::size_t node =
        number == 0 ? 0 : (number == 1 ? places.size() - 1 : 1);
    // Two elements that both begin, or both end, here run against each other.
    const bool reversed = !sections.empty() && sections.front().node == node;
    sections.push_back({i, node, reversed});
  }
  if (sections.empty())
    refuse(probe, "no node of the frame '" + probe.of + "' lies at its point");
  return sections;
}

double
Probes::evaluate_frame(const std::size_t probe,
                       const std::vector<FrameElementFields>& fields) const
{
  const Probe& description = descriptions_[probe];
  double largest = 0, sum = 0;
  if (description.kind == Probe::Kind::frame_strain)
  {
    for (const auto& element : fields)
      for (const auto& node : element.nodes)
        if (element.frame == targets_[probe])
          largest = std::max(largest, node.strain);
    return largest;
  }
  for (const auto& section : sections_[probe])
  {
    const FramePoint& point = fields[section.element].nodes[section.node];
    const auto& resultant = description.kind == Probe::Kind::frame_force
                                ? point.force
                                : point.moment;
    // Turning axes 1 and 2 round turns the section round as well: only what is
    // along or about axis 3 changes its sign.
    const bool changes = section.reversed && description.component == 2;
    sum += (changes ? -1 : 1) * resultant[description.component];
  }
  return sum / sections_[probe].size();
}
} // namespace taut::structure
