#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>
#include <taut/fe/mesh_groups.h>

#include <algorithm>

namespace taut::fe
{
namespace
{
const std::array<std::string, 3> kinds{{"point", "line", "surface"}};
}

unsigned int MeshGroups::add(const unsigned int dimension,
                             const std::set<std::string>& names)
{
  auto& sets = sets_.at(dimension);
  const auto found = std::find(sets.begin(), sets.end(), names);
  const auto id = static_cast<unsigned int>(found - sets.begin());
  if (found == sets.end())
    sets.push_back(names);
  return id;
}

const std::set<std::string>& MeshGroups::get_set(const unsigned int dimension,
                                                 const unsigned int id) const
{
  const auto& sets = sets_.at(dimension);
  return id < sets.size() ? sets[id] : sets[0];
}

std::vector<std::string>
MeshGroups::get_names(const unsigned int dimension) const
{
  std::set<std::string> names;
  for (const auto& set : sets_.at(dimension))
    names.insert(set.begin(), set.end());
  return {names.begin(), names.end()};
}

bool MeshGroups::has(const unsigned int dimension,
                     const std::string& group) const
{
  const auto& sets = sets_.at(dimension);
  return std::any_of(sets.begin(), sets.end(),
                     [&](const auto& set) { return set.count(group) > 0; });
}

std::set<unsigned int> MeshGroups::get_ids(const unsigned int dimension,
                                           const std::string& group) const
{
  const auto& sets = sets_.at(dimension);
  std::set<unsigned int> ids;
  for (unsigned int id = 0; id < sets.size(); ++id)
    if (sets[id].count(group) > 0)
      ids.insert(id);
  if (ids.empty())
    refuse(dimension, group);
  return ids;
}

void MeshGroups::refuse(const unsigned int dimension,
                        const std::string& group) const
{
  std::string text = "the mesh has no " + kinds[dimension] + " group '" +
                     group + "'; " + suggest(group, get_names(dimension));
  for (unsigned int other = 0; other < kinds.size(); ++other)
    if (has(other, group))
      text += " ('" + group + "' is a " + kinds[other] + " group)";
  throw BadInput(text);
}
} // namespace taut::fe
