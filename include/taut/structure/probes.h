#pragma once

#include <taut/structure/systems.h>

#include <string>
#include <utility>
#include <vector>

namespace taut::structure
{
/// The numbers that a case wants to see, evaluated at a state of a system.
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
  /// "m", "rad", "m/s", "V", "C", "F", "N", "N m", "K", "Pa", "V/m", "m^3" or
  /// "1".
  static std::string get_unit(Probe::Kind kind);
  std::string unit(const std::size_t probe) const
  {
    return get_unit(descriptions_[probe].kind);
  }

  /// All values in the order of the description. Collective.
  std::vector<double> evaluate(double time, const double* state);

private:
  /// A point as a combination of nodes of this rank; empty on other ranks.
  using Point = std::vector<std::pair<fe::LocalNode, double>>;

  Point find_point(const Probe& probe) const;
  std::size_t find_target(const Probe& probe) const;
  double evaluate_point(std::size_t probe, const fe::NodalVector& positions,
                        const fe::NodalVector* velocities) const;
  double evaluate_bar(std::size_t probe, const fe::NodalVector& positions,
                      const fe::NodalVector* velocities) const;
  double evaluate_film(std::size_t probe, const LoadState& loads,
                       const double* u, const double* internal) const;
  double evaluate_device(std::size_t probe, const LoadState& loads) const;

  StructureSystem& system_;
  std::vector<Probe> descriptions_;
  std::vector<Point> points_; ///< by probe; empty for other kinds
  std::vector<std::size_t>
      targets_; ///< by probe: bar, electrode, support, film
  std::vector<std::vector<std::string>> groups_; ///< by probe, of volumes
};
} // namespace taut::structure
