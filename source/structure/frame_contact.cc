#include <taut/fe/vector3.h>
#include <taut/structure/frame_contact.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace taut::structure
{
namespace
{
using fe::compute_distance;
using Place = std::array<double, 3>;

Place subtract(const Place& a, const Place& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// a + s b.
Place add_scaled(const Place& a, const double s, const Place& b)
{
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}

/// From x to the straight line between p and q.
double compute_distance_to_line(const Place& x, const Place& p, const Place& q)
{
  const Place line = subtract(q, p);
  const double square = fe::dot(line, line);
  const double share =
      square > 0 ? std::clamp(fe::dot(subtract(x, p), line) / square, 0., 1.)
                 : 0.;
  return compute_distance(x, add_scaled(p, share, line));
}
} // namespace

double compute_segment_distance(const std::array<double, 3>& p_1,
                                const std::array<double, 3>& q_1,
                                const std::array<double, 3>& p_2,
                                const std::array<double, 3>& q_2)
{
  // The closest points are inside both pieces or one of them is an end.
  const double of_ends = std::min({compute_distance_to_line(p_1, p_2, q_2),
                                   compute_distance_to_line(q_1, p_2, q_2),
                                   compute_distance_to_line(p_2, p_1, q_1),
                                   compute_distance_to_line(q_2, p_1, q_1)});
  const Place a = subtract(q_1, p_1), b = subtract(q_2, p_2),
              r = subtract(p_2, p_1);
  const double aa = fe::dot(a, a), bb = fe::dot(b, b), ab = fe::dot(a, b);
  const double determinant = aa * bb - ab * ab;
  // Parallel lines are closest at ends as well.
  if (determinant <= 1e-14 * aa * bb)
    return of_ends;
  const double s = (fe::dot(r, a) * bb - fe::dot(r, b) * ab) / determinant;
  const double t = (fe::dot(r, a) * ab - fe::dot(r, b) * aa) / determinant;
  if (s < 0 || s > 1 || t < 0 || t > 1)
    return of_ends;
  return std::min(
      of_ends, compute_distance(add_scaled(p_1, s, a), add_scaled(p_2, t, b)));
}

namespace
{
double compute_chain_distance(const std::vector<Place>& a,
                              const std::vector<Place>& b)
{
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < a.size(); ++i)
    for (std::size_t j = 1; j < b.size(); ++j)
      distance = std::min(
          distance, compute_segment_distance(a[i - 1], a[i], b[j - 1], b[j]));
  return distance;
}
} // namespace

FrameContact::FrameContact(const Structure& structure,
                           const std::optional<unsigned int> frame)
    : structure_(structure)
{
  const auto& elements = structure.frames().elements();
  std::vector<double> thicknesses;
  std::vector<Chain> chains;
  for (const FrameElement& element : elements)
  {
    thicknesses.push_back(
        structure.device().frames[element.frame].section.thickness);
    std::vector<Point> nodes;
    for (const auto node : element.positions)
      nodes.push_back(structure.nodes().mesh_position[node]);
    chains.push_back(make_chain(nodes));
  }
  for (std::size_t a = 0; a < elements.size(); ++a)
  {
    const auto neighbours = find_neighbours(
        a, 4 * *std::max_element(thicknesses.begin(), thicknesses.end()));
    for (std::size_t b = a + 1; b < elements.size(); ++b)
    {
      if (neighbours[b] ||
          (frame && elements[a].frame != *frame && elements[b].frame != *frame))
        continue;
      const double thickness = (thicknesses[a] + thicknesses[b]) / 2;
      pairs_.push_back(
          {a, b, thickness,
           compute_chain_distance(chains[a].points, chains[b].points) -
               thickness});
    }
  }
}

/// Four pieces along a curved element: a circle of 20 elements is followed to
/// 1e-4 of its length.
FrameContact::Chain FrameContact::make_chain(const std::vector<Point>& nodes)
{
  Chain chain{{nodes[0]}, {}, 0};
  const unsigned int n = nodes.size() == 2 ? 1 : 4;
  for (unsigned int i = 1; i <= n; ++i)
    chain.points.push_back(interpolate_edge(nodes, double(i) / n));
  chain.centre = chain.points[n / 2];
  for (const Point& point : chain.points)
    chain.radius =
        std::max(chain.radius, compute_distance(point, chain.centre));
  return chain;
}

std::vector<FrameContact::Chain>
FrameContact::make_chains(const fe::NodalVector& positions) const
{
  std::vector<Chain> chains;
  for (const FrameElement& element : structure_.frames().elements())
  {
    std::vector<Point> nodes;
    for (const auto node : element.positions)
      nodes.push_back({fe::entry(positions, 3 * node),
                       fe::entry(positions, 3 * node + 1),
                       fe::entry(positions, 3 * node + 2)});
    chains.push_back(make_chain(nodes));
  }
  return chains;
}

/// Elements to which a way of up to `reach` (m) leads along others.
std::vector<bool> FrameContact::find_neighbours(const std::size_t element,
                                                const double reach) const
{
  const auto& elements = structure_.frames().elements();
  std::map<fe::LocalNode, double> ways;
  for (const auto node : elements[element].positions)
    ways[node] = 0;
  const auto find_way = [&](const FrameElement& to)
  {
    double way = std::numeric_limits<double>::infinity();
    for (const auto node : to.positions)
      if (const auto found = ways.find(node); found != ways.end())
        way = std::min(way, found->second);
    return way;
  };
  // Goes on until no way becomes shorter.
  for (bool changed = true; changed;)
  {
    changed = false;
    for (const FrameElement& next : elements)
    {
      const double way = find_way(next) + next.beam.length();
      for (const auto node : next.positions)
        if (const auto [entry, is_new] =
                ways.try_emplace(node, std::numeric_limits<double>::infinity());
            way <= reach && way < entry->second)
        {
          entry->second = way;
          changed = true;
        }
    }
  }
  std::vector<bool> neighbours;
  for (const FrameElement& other : elements)
    neighbours.push_back(find_way(other) <= reach);
  return neighbours;
}

FrameClearance FrameContact::make_clearance(const Pair& pair,
                                            const double distance) const
{
  const auto& elements = structure_.frames().elements();
  const FrameElement& first = elements[pair.a];
  return {distance,
          pair.mesh_distance,
          {first.frame, elements[pair.b].frame},
          structure_.nodes().mesh_position[first.positions.back()]};
}

FrameClearance FrameContact::get_closest_in_mesh() const
{
  const auto closest =
      std::min_element(pairs_.begin(), pairs_.end(),
                       [](const Pair& a, const Pair& b)
                       { return a.mesh_distance < b.mesh_distance; });
  return make_clearance(*closest, closest->mesh_distance);
}

FrameClearance FrameContact::find_closest(const fe::NodalVector& positions,
                                          const double gap) const
{
  const auto chains = make_chains(positions);
  double smallest = std::numeric_limits<double>::infinity();
  double smallest_distance = std::numeric_limits<double>::infinity();
  const Pair* closest = nullptr;
  for (const Pair& pair : pairs_)
  {
    const Chain& a = chains[pair.a];
    const Chain& b = chains[pair.b];
    const double scale = pair.mesh_distance - gap;
    const double at_least = compute_distance(a.centre, b.centre) - a.radius -
                            b.radius - pair.thickness;
    if ((at_least - gap) / scale >= smallest)
      continue;
    const double distance =
        compute_chain_distance(a.points, b.points) - pair.thickness;
    if ((distance - gap) / scale < smallest)
    {
      smallest = (distance - gap) / scale;
      smallest_distance = distance;
      closest = &pair;
    }
  }
  return make_clearance(*closest, smallest_distance);
}
} // namespace taut::structure
