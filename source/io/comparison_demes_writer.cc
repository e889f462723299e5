#include <taut/io/comparison_demes_writer.h>
#include <taut/io/csv_file.h>
#include <taut/io/run_summary.h>

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "comparison_writer_json.h"

namespace taut::io
{
namespace
{
using study::DemesComparison;
using study::DemesModel;
using study::DemesRest;
using study::DemesShape;

ComparisonJson make_json(const DemesShape& shape)
{
  return {{"angle", shape.angle},
          {"chord", shape.chord},
          {"stretch", shape.stretch}};
}

ComparisonJson make_json(const DemesRest& rest)
{
  ComparisonJson json = make_json(rest.shape);
  json["voltage"] = rest.voltage;
  json["relaxed_frequency"] = rest.relaxed_frequency;
  json["instantaneous_frequency"] = rest.instantaneous_frequency;
  return json;
}

ComparisonJson make_json(const DemesModel& model)
{
  ComparisonJson oscillation = make_json(model.mean);
  oscillation["frequency"] = model.oscillation.frequency;
  return {
      {"name", model.name},
      {"rest", make_json(model.rest)},
      {"driven", model.driven ? make_json(*model.driven) : ComparisonJson()},
      {"oscillation", oscillation}};
}

double compare(const double film, const double lumped)
{
  return (film - lumped) / std::abs(lumped);
}

ComparisonJson make_film_difference(const DemesModel& film,
                                    const DemesModel& lumped)
{
  const DemesShape &a = film.rest.shape, &b = lumped.rest.shape;
  ComparisonJson json =
      make_json(DemesShape{compare(a.angle, b.angle), compare(a.chord, b.chord),
                           compare(a.stretch, b.stretch)});
  json["frequency"] =
      compare(film.oscillation.frequency, lumped.oscillation.frequency);
  return json;
}

ComparisonJson make_models_json(const DemesComparison& comparison)
{
  ComparisonJson models = ComparisonJson::array({make_json(comparison.film)});
  for (const DemesModel* lumped : {&comparison.elastica, &comparison.arc})
  {
    ComparisonJson json = make_json(*lumped);
    json["film_difference"] = make_film_difference(comparison.film, *lumped);
    models.push_back(json);
  }
  return models;
}

ComparisonJson make_json(const study::DemesEquivalent& equivalent)
{
  const lumped::DemesSI& device = equivalent.device;
  return {
      {"film_length", device.film_length},
      {"film_width", device.film_width},
      {"film_thickness", device.film_thickness},
      {"film_offset", device.film_offset},
      {"pre_stretch", device.pre_stretch},
      {"shear_modulus", device.shear_modulus},
      {"viscous_ratio", device.viscous_ratio},
      {"viscosity", device.viscosity},
      {"relative_permittivity", device.relative_permittivity},
      {"permittivity_coefficients",
       {device.permittivity.a, device.permittivity.b, device.permittivity.c}},
      {"bending_stiffness", equivalent.bending_stiffness},
      {"leg_length", equivalent.leg_length},
      {"inertia", device.inertia},
      {"temperature", device.temperature},
      {"voltage", device.source.to_text()}};
}

ComparisonJson make_film_events(const DemesComparison& comparison)
{
  ComparisonJson list = ComparisonJson::array();
  for (const study::EventRecord& event : comparison.film_events)
    list.push_back({{"time", event.time},
                    {"name", event.name},
                    {"kind", event.kind},
                    {"place", event.place},
                    {"at_start", event.at_start}});
  return list;
}

/// Finite elements, elastica, arc.
std::array<const DemesModel*, 3> get_models(const DemesComparison& comparison)
{
  return {&comparison.film, &comparison.elastica, &comparison.arc};
}

std::string describe_number(const double value)
{
  return std::isnan(value) ? "-" : fmt::format("{:.5g}", value);
}

std::string describe_row(const std::string& name, const DemesShape& shape,
                         const std::array<double, 3>& frequencies)
{
  std::string line = fmt::format(
      "{:<26} {:>10} {:>10} {:>8}", name, describe_number(shape.angle),
      describe_number(shape.chord), describe_number(shape.stretch));
  for (const double frequency : frequencies)
    line += fmt::format(" {:>9}", describe_number(frequency));
  return line + "\n";
}

std::string describe_rest(const DemesRest& rest, const std::string& model)
{
  return describe_row(
      fmt::format("{}, {:.5g} V", model, rest.voltage), rest.shape,
      {rest.relaxed_frequency, rest.instantaneous_frequency, std::nan("")});
}

std::string describe_models(const DemesComparison& comparison)
{
  std::string text =
      fmt::format("{:<26} {:>10} {:>10} {:>8} {:>9} {:>9} {:>9}\n{:<26} {:>10} "
                  "{:>10} {:>8} "
                  "{:>9} {:>9} {:>9}\n",
                  "", "half angle", "chord", "stretch", "relaxed", "instant",
                  "measured", "at rest", "rad", "m", "1", "Hz", "Hz", "Hz");
  for (const DemesModel* model : get_models(comparison))
    text += describe_rest(model->rest, model->name);
  for (const DemesModel* model : get_models(comparison))
    if (model->driven)
      text += describe_rest(*model->driven, model->name);
  return text;
}

std::string describe_oscillations(const DemesComparison& comparison)
{
  std::string text = "mean over the periods of the run\n";
  for (const DemesModel* model : get_models(comparison))
    text += describe_row(
        model->name, model->mean,
        {std::nan(""), std::nan(""), model->oscillation.frequency});
  return text;
}
} // namespace

std::string make_comparison_json(const DemesComparison& comparison)
{
  ComparisonJson json;
  json["quantities"] = make_list(comparison.quantities);
  json["models"] = make_models_json(comparison);
  json["compared_until"] = comparison.compared_until;
  json["events"] = {{"film", make_film_events(comparison)},
                    {"arc", make_list(comparison.arc_events)}};
  json["film_status"] = to_text(comparison.film_summary.status);
  json["lumped_demes"] = make_json(comparison.equivalent);
  json["ignored"] = comparison.equivalent.ignored;
  json["notes"] = comparison.notes;
  const int indent = 2;
  return json.dump(indent) + "\n";
}

void write_comparison_table(const std::string& file,
                            const DemesComparison& comparison)
{
  struct Quantity
  {
    const char* name;
    const char* unit;
    std::vector<double> DemesModel::*history;
  };
  const std::array<Quantity, 3> quantities = {
      {{"angle", "rad", &DemesModel::angle},
       {"chord", "m", &DemesModel::chord},
       {"stretch", "1", &DemesModel::stretch}}};
  std::vector<std::string> header = {"time [s]", "voltage [V]"};
  for (const Quantity& quantity : quantities)
    for (const DemesModel* model : get_models(comparison))
      header.push_back(
          fmt::format("{} {} [{}]", quantity.name, model->name, quantity.unit));
  CsvFile table(file, header);
  for (std::size_t i = 0; i < comparison.times.size(); ++i)
  {
    std::vector<std::string> fields = {to_field(comparison.times[i]),
                                       to_field(comparison.voltage[i])};
    for (const Quantity& quantity : quantities)
      for (const DemesModel* model : get_models(comparison))
        fields.push_back(to_field_or_empty((model->*quantity.history)[i]));
    table.write(fields);
  }
}

std::string describe_comparison(const DemesComparison& comparison)
{
  std::string text = describe_models(comparison);
  if (!std::isnan(comparison.film.oscillation.frequency))
    text += describe_oscillations(comparison);
  text += fmt::format("Film against arc and elastica until {:.6g} s, relative "
                      "to the largest lumped value:\n{}",
                      comparison.compared_until,
                      describe_differences(comparison.quantities));
  for (const std::string& note : comparison.notes)
    text += "note: " + note + "\n";
  for (const std::string& what : comparison.equivalent.ignored)
    text += "unknown to the lumped models: " + what + "\n";
  text.pop_back();
  return text;
}
} // namespace taut::io
