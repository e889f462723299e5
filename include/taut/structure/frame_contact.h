#pragma once

#include <taut/structure/structure.h>

#include <array>
#include <optional>
#include <vector>

namespace taut::structure
{
/// How close two elements of frames are, of which the faces count: the distance
/// of their axes less half of both thicknesses.
struct FrameClearance
{
  double distance;                    ///< (m)
  double mesh_distance;               ///< the same in the mesh (m)
  std::array<unsigned int, 2> frames; ///< indices in the description
  /// Of the first element: its middle, or an end if it has no middle node (m).
  std::array<double, 3> mesh_point;
};

/// The clearances of frames: of curled ones from themselves, and of one from
/// another. Elements are taken as chains of straight pieces; frames reach as
/// far as half their thickness to all sides, whatever their width. Elements
/// that share a node or are joined by a way along the frames of up to four
/// thicknesses are neighbours, which are not looked at. Faces pass through each
/// other unhindered: once two axes have crossed, their clearance means nothing.
class FrameContact
{
public:
  /// `frame`: only its clearances; none for all.
  FrameContact(const Structure& structure, std::optional<unsigned int> frame);

  /// True if no two elements could touch.
  bool empty() const
  {
    return pairs_.empty();
  }
  /// The pair that is closest in the mesh.
  FrameClearance get_closest_in_mesh() const;
  /// The pair with the smallest (distance - gap)/(mesh distance - gap) at
  /// positions with current ghosts; the same on every rank. `gap` (m) is below
  /// every mesh distance.
  FrameClearance find_closest(const fe::NodalVector& positions,
                              double gap) const;

private:
  using Point = std::array<double, 3>;
  /// An element as points along it, within a sphere.
  struct Chain
  {
    std::vector<Point> points;
    Point centre;
    double radius;
  };
  struct Pair
  {
    std::size_t a, b;     ///< elements
    double thickness;     ///< half of both (m)
    double mesh_distance; ///< of the faces (m)
  };
  static Chain make_chain(const std::vector<Point>& nodes);
  std::vector<Chain> make_chains(const fe::NodalVector& positions) const;
  std::vector<bool> find_neighbours(std::size_t element, double reach) const;
  FrameClearance make_clearance(const Pair& pair, double distance) const;

  const Structure& structure_;
  std::vector<Pair> pairs_;
};

/// The distance (m) between the straight pieces from p to q.
double compute_segment_distance(const std::array<double, 3>& p_1,
                                const std::array<double, 3>& q_1,
                                const std::array<double, 3>& p_2,
                                const std::array<double, 3>& q_2);
} // namespace taut::structure
