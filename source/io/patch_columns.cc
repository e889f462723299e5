#include <taut/io/patch_columns.h>

namespace taut::io
{
void PatchColumns::add_scalar(const std::string& name, const std::string& unit)
{
  names.push_back(name);
  if (!unit.empty())
    units[name] = unit;
}

void PatchColumns::add_vector(const std::string& name, const std::string& unit)
{
  const unsigned int first = names.size();
  vectors.emplace_back(
      first, first + 2, name,
      dealii::DataComponentInterpretation::component_is_part_of_vector);
  for (unsigned int d = 0; d < 3; ++d)
    add_scalar(name, unit);
}
} // namespace taut::io
