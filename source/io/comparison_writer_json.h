#pragma once

#include <taut/study/comparison.h>

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

/// What the writers of all comparisons share.
namespace taut::io
{
using ComparisonJson = nlohmann::ordered_json;

ComparisonJson make_json(const study::ComparedQuantity& quantity);
ComparisonJson make_json(const study::ComparedEvent& event);

template <class Item>
ComparisonJson make_list(const std::vector<Item>& items)
{
  ComparisonJson list = ComparisonJson::array();
  for (const Item& item : items)
    list.push_back(make_json(item));
  return list;
}

/// A history may have gaps.
std::string to_field_or_empty(double value);

/// Lines of name, largest and rms difference, time of the largest, with a head.
std::string
describe_differences(const std::vector<study::ComparedQuantity>& quantities);
} // namespace taut::io
