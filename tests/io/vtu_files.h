// Output files for ParaView, read back.
#pragma once

#include <deal.II/base/utilities.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "io/output_files.h"
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/filter/zlib.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <boost/property_tree/xml_parser.hpp>

namespace taut::io::testing
{
using boost::property_tree::ptree;

/// deal.II keeps the numbers of a patch in single precision; lengths here are
/// below .1 m.
constexpr double round_off = 1e-8;

inline ptree read_xml(const std::string& file)
{
  ptree tree;
  boost::property_tree::read_xml(file, tree);
  return tree;
}

/// The attribute `what` of all nodes `name` below `parent`.
inline std::vector<std::string>
get_all(const ptree& parent, const std::string& name, const std::string& what)
{
  std::vector<std::string> values;
  for (const auto& [key, node] : parent)
    if (key == name)
      values.push_back(node.get<std::string>("<xmlattr>." + what));
  return values;
}

/// The numbers of a DataArray: base64 of four lengths, then of the numbers as
/// zlib packs them.
template <typename Number>
std::vector<Number> decode(const ptree& array)
{
  std::string text = array.get_value<std::string>();
  text.erase(std::remove_if(text.begin(), text.end(), isspace), text.end());
  const std::size_t header_length = 24; // base64 of 16 bytes
  const auto packed =
      dealii::Utilities::decode_base64(text.substr(header_length));
  boost::iostreams::filtering_istream stream;
  stream.push(boost::iostreams::zlib_decompressor());
  stream.push(boost::iostreams::array_source(
      reinterpret_cast<const char*>(packed.data()), packed.size()));
  std::vector<Number> numbers;
  Number number;
  while (stream.read(reinterpret_cast<char*>(&number), sizeof(Number)))
    numbers.push_back(number);
  return numbers;
}

template <typename Number>
std::vector<Number> read_array(const ptree& part, const std::string& name)
{
  for (const auto& [key, node] : part)
    if (key == "DataArray" && node.get("<xmlattr>.Name", "") == name)
      return decode<Number>(node);
  ADD_FAILURE() << "no array " << name;
  return {};
}

} // namespace taut::io::testing
