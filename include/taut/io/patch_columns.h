#pragma once

#include <deal.II/base/data_out_base.h>

#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace taut::io
{
/// What the rows of deal.II's patches mean.
struct PatchColumns
{
  void add_scalar(const std::string& name, const std::string& unit = "");
  /// Three rows.
  void add_vector(const std::string& name, const std::string& unit = "");

  /// One name per component.
  std::vector<std::string> names;
  /// Which components form vectors.
  std::vector<std::tuple<
      unsigned int, unsigned int, std::string,
      dealii::DataComponentInterpretation::DataComponentInterpretation>>
      vectors;
  /// By name; none for what is dimensionless.
  std::map<std::string, std::string> units;
};
} // namespace taut::io
