#pragma once

#include <taut/structure/frame_fields.h>
#include <taut/structure/systems.h>

#include <optional>
#include <string>
#include <vector>

namespace taut::structure
{
/// The numbers that a case wants to see, evaluated at a state of a system.
///
/// A point where frames have a node means the frame: its axis and the rotation
/// of its section (of the first of the frames where they are hinged). Else it
/// means the film's node. What probes of frames show:
/// - rotation: the angle about x, y or z of the mesh between -2 pi and 2 pi,
///   if the axis of the rotation lies along it;
/// - half_angle: half of the angle by which the section at the second point is
///   turned against the one at the first, about x, y or z as it turned with the
///   first, between -pi and pi; positive if it turns from the first to the
///   second positively about that axis (about y: of a bow along x that is
///   higher in z than its ends);
/// - frame_force, frame_moment: normal force (tension), shear along 2 and 3;
///   torsion, bending about 2 and 3: what the part of the beam ahead along axis
///   1 does to the part behind. The mean of the elements that meet there, of
///   which the first says where axis 1 points;
/// - frame_strain: the largest FramePoint::strain of all nodes of a frame.
class Probes
{
public:
  /// Errors: BadInput if a probe names what the device or the mesh lacks.
  explicit Probes(StructureSystem& system);

  std::size_t size() const
  {
    return descriptions_.size();
  }
  const std::string& name(const std::size_t probe) const
  {
    return descriptions_[probe].name;
  }
  /// "m", "rad", "m/s", "V", "C", "A", "F", "N", "N m", "K", "Pa", "V/m", "m^3"
  /// or "1".
  static std::string get_unit(Probe::Kind kind);
  std::string unit(const std::size_t probe) const
  {
    return get_unit(descriptions_[probe].kind);
  }

  /// All values in the order of the description. Collective.
  std::vector<double> evaluate(double time, const double* state);

private:
  struct Point
  {
    /// Only on the rank that owns it.
    std::optional<fe::LocalNode> node;
    fe::Coordinates mesh_position; ///< (m)
    /// Index into Nodes::rotations if it is of a frame.
    std::optional<unsigned int> rotation;
  };
  /// A node of an element of a frame, both as in compute_frame_fields.
  struct Section
  {
    std::size_t element, node;
    /// Axis 1 points against that of the first section of the same place.
    bool reversed;
  };

  [[noreturn]] static void refuse(const Probe& probe,
                                  const std::string& message);
  std::size_t find_target(const Probe& probe) const;
  std::vector<Point> find_points(const Probe& probe) const;
  Point find_point(const Probe& probe, const std::string& group) const;
  fe::Coordinates find_place(const Probe& probe,
                             const std::string& group) const;
  Point find_node(const Probe& probe, const fe::Coordinates& place) const;
  std::vector<Section> find_sections(const Probe& probe,
                                     std::size_t frame) const;
  fe::Coordinates get_vector(const Point& point,
                             const fe::NodalVector& values) const;
  double evaluate_point(std::size_t probe, const fe::NodalVector& positions,
                        const fe::NodalVector* velocities) const;
  double evaluate_rotation(std::size_t probe,
                           const fe::NodalVector& positions) const;
  double evaluate_bar(std::size_t probe, const fe::NodalVector& positions,
                      const fe::NodalVector* velocities) const;
  double evaluate_film(std::size_t probe, const LoadState& loads,
                       const double* u, const double* internal) const;
  double evaluate_frame(std::size_t probe,
                        const std::vector<FrameElementFields>& fields) const;
  double evaluate_temperature(std::size_t probe, const LoadState& loads) const;
  double evaluate_current(std::size_t electrode, const LoadState& loads) const;
  double evaluate_device(std::size_t probe, const LoadState& loads) const;

  StructureSystem& system_;
  std::vector<Probe> descriptions_;
  /// By probe; empty for other kinds.
  std::vector<std::vector<Point>> points_;
  std::vector<std::vector<Section>> sections_;
  /// By probe: bar, electrode, support, frame or film; for temperatures frames
  /// are numbered behind the films.
  std::vector<std::size_t> targets_;
  std::vector<std::vector<std::string>> groups_; ///< by probe, of volumes
};
} // namespace taut::structure
