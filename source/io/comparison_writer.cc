#include <taut/io/comparison_writer.h>
#include <taut/io/csv_file.h>
#include <taut/io/run_summary.h>

#include <fmt/format.h>

#include "comparison_writer_json.h"

namespace taut::io
{
namespace
{
using io::make_json;
using study::ComparedEvent;
using study::ComparedQuantity;
using study::Comparison;

ComparisonJson make_json(const study::FailureDifference& difference)
{
  return {{"time", difference.time},
          {"voltage", difference.voltage},
          {"same_kind", difference.same_kind},
          {"same_place", difference.same_place}};
}

ComparisonJson make_json(const study::LumpedResonatorDescription& resonator)
{
  return {{"length_active", resonator.length_active},
          {"length_passive", resonator.length_passive},
          {"width", resonator.width},
          {"thickness", resonator.thickness},
          {"pre_stretch", resonator.pre_stretch},
          {"bar_mass", resonator.bar_mass},
          {"density", resonator.density},
          {"shear_modulus", resonator.shear_modulus},
          {"equilibrium_share", resonator.equilibrium_share},
          {"network_shares", resonator.network_shares},
          {"relaxation_times", resonator.relaxation_times},
          {"limit", resonator.limit},
          {"relative_permittivity", resonator.relative_permittivity},
          {"breakdown_strength", resonator.breakdown_strength},
          {"voltage", resonator.voltage.to_text()}};
}

template <class Item>
ComparisonJson make_optional(const std::optional<Item>& item)
{
  return item ? make_json(*item) : ComparisonJson();
}

std::string describe_failure(const std::string& model,
                             const std::optional<ComparedEvent>& failure)
{
  if (!failure)
    return fmt::format("{:<7} does not fail\n", model);
  return fmt::format("{:<7} {} in {} at {:.9g} s, {:.9g} V\n", model,
                     failure->kind, failure->place, failure->time,
                     failure->voltage);
}

std::string describe_quantities(const Comparison& comparison)
{
  return fmt::format("Film against lumped model until {:.6g} s, relative to "
                     "the largest lumped value:\n{}",
                     comparison.compared_until,
                     describe_differences(comparison.quantities));
}
} // namespace

std::string make_comparison_json(const Comparison& comparison)
{
  ComparisonJson json;
  json["quantities"] = make_list(comparison.quantities);
  json["compared_until"] = comparison.compared_until;
  json["events"] = {
      {"film", make_list(comparison.film_events)},
      {"lumped", make_list(comparison.lumped_events)},
      {"film_failure", make_optional(comparison.film_failure)},
      {"lumped_failure", make_optional(comparison.lumped_failure)},
      {"failure_difference", make_optional(comparison.failure_difference)}};
  json["film_status"] = to_text(comparison.film_summary.status);
  json["lumped_resonator"] = make_json(comparison.equivalent.resonator);
  json["ignored"] = comparison.equivalent.ignored;
  const int indent = 2;
  return json.dump(indent) + "\n";
}

void write_comparison_table(const std::string& file,
                            const Comparison& comparison)
{
  std::vector<std::string> header = {"time [s]", "voltage [V]"};
  for (const ComparedQuantity& quantity : comparison.quantities)
    for (const char* model : {"film", "lumped"})
      header.push_back(
          fmt::format("{} {} [{}]", quantity.name, model, quantity.unit));
  CsvFile table(file, header);
  for (std::size_t i = 0; i < comparison.times.size(); ++i)
  {
    std::vector<std::string> fields = {to_field(comparison.times[i]),
                                       to_field(comparison.voltage[i])};
    for (const ComparedQuantity& quantity : comparison.quantities)
    {
      fields.push_back(to_field_or_empty(quantity.film[i]));
      fields.push_back(to_field_or_empty(quantity.lumped[i]));
    }
    table.write(fields);
  }
}

std::string describe_comparison(const Comparison& comparison)
{
  std::string text = describe_quantities(comparison);
  text += describe_failure("film", comparison.film_failure);
  text += describe_failure("lumped", comparison.lumped_failure);
  if (comparison.failure_difference)
    text += fmt::format("difference of the failures: {:.2e} in time, {:.2e} in "
                        "voltage (relative)\n",
                        comparison.failure_difference->time,
                        comparison.failure_difference->voltage);
  for (const std::string& what : comparison.equivalent.ignored)
    text += "unknown to the lumped model: " + what + "\n";
  text.pop_back();
  return text;
}
} // namespace taut::io
