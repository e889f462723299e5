#include "comparison_writer_json.h"

#include <taut/io/csv_file.h>

#include <fmt/format.h>

#include <cmath>

namespace taut::io
{
ComparisonJson make_json(const study::ComparedQuantity& quantity)
{
  return {{"name", quantity.name},
          {"unit", quantity.unit},
          {"max_relative_difference", quantity.max_relative_difference},
          {"rms_relative_difference", quantity.rms_relative_difference},
          {"time_of_max", quantity.time_of_max}};
}

ComparisonJson make_json(const study::ComparedEvent& event)
{
  return {{"time", event.time},
          {"voltage", event.voltage},
          {"kind", event.kind},
          {"place", event.place},
          {"at_start", event.at_start}};
}

std::string to_field_or_empty(const double value)
{
  return std::isnan(value) ? "" : to_field(value);
}

std::string
describe_differences(const std::vector<study::ComparedQuantity>& quantities)
{
  std::string text = fmt::format("{:<26} {:>10} {:>10} {:>12}\n", "quantity",
                                 "largest", "rms", "largest at");
  for (const study::ComparedQuantity& quantity : quantities)
    text += fmt::format("{:<26} {:>10.2e} {:>10.2e} {:>10.4g} s\n",
                        quantity.name, quantity.max_relative_difference,
                        quantity.rms_relative_difference, quantity.time_of_max);
  return text;
}
} // namespace taut::io
