#pragma once

#include <array>
#include <set>
#include <string>
#include <vector>

#include <boost/serialization/array.hpp>
#include <boost/serialization/library_version_type.hpp>
#include <boost/serialization/set.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

namespace taut::fe
{
/// The physical groups of a mesh. An element may lie in several groups, but
/// deal.II keeps one number per cell or line: it is the id of the element's
/// *set* of groups. Dimensions: 0 points, 1 lines, 2 surfaces. In every
/// dimension the id 0 is the empty set: an element in no group.
class MeshGroups
{
public:
  /// The id of the set `names`, which is added if it is new.
  unsigned int add(unsigned int dimension, const std::set<std::string>& names);

  /// The groups in the set `id`; the empty set for an id that is not known
  /// (such as dealii::numbers::flat_manifold_id).
  const std::set<std::string>& get_set(unsigned int dimension,
                                       unsigned int id) const;

  /// The names of all groups of `dimension`, sorted.
  std::vector<std::string> get_names(unsigned int dimension) const;

  bool has(unsigned int dimension, const std::string& group) const;

  /// The ids of all sets in which `group` takes part: an element is in the
  /// group if its id (material id of a cell, manifold id of a line, group set
  /// of a point) is among them. Errors: BadInput if the mesh has no such group;
  /// the message lists what there is and says whether the name belongs to
  /// another dimension.
  std::set<unsigned int> get_ids(unsigned int dimension,
                                 const std::string& group) const;

  template <typename Archive>
  void serialize(Archive& archive, const unsigned int)
  {
    archive& sets_;
  }

  bool operator==(const MeshGroups& other) const
  {
    return sets_ == other.sets_;
  }

private:
  [[noreturn]] void refuse(unsigned int dimension,
                           const std::string& group) const;

  using Sets = std::vector<std::set<std::string>>;
  std::array<Sets, 3> sets_{{Sets(1), Sets(1), Sets(1)}};
};
} // namespace taut::fe
