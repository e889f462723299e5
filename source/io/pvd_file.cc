#include <taut/base/exceptions.h>
#include <taut/io/files.h>
#include <taut/io/pvd_file.h>

#include <sstream>

#include <boost/property_tree/xml_parser.hpp>

namespace taut::io
{
namespace
{
using boost::property_tree::ptree;

void add_data_set(const ptree& node, std::vector<PvdFrame>& frames)
{
  const auto part = node.get<unsigned int>("<xmlattr>.part", 0);
  const bool begins =
      frames.empty() || part <= frames.back().parts.rbegin()->first;
  if (begins)
    frames.push_back({node.get<double>("<xmlattr>.timestep"), {}});
  frames.back().parts[part] = node.get<std::string>("<xmlattr>.file");
}

ptree make_data_set(const double time, const unsigned int part,
                    const std::string& file)
{
  ptree node;
  node.put("<xmlattr>.timestep", time);
  node.put("<xmlattr>.part", part);
  node.put("<xmlattr>.file", file);
  return node;
}
} // namespace

std::vector<PvdFrame> read_pvd(const std::string& file)
{
  std::istringstream stream(read_file(file));
  ptree tree;
  std::vector<PvdFrame> frames;
  try
  {
    boost::property_tree::read_xml(stream, tree);
    for (const auto& [name, node] : tree.get_child("VTKFile.Collection"))
      if (name == "DataSet")
        add_data_set(node, frames);
  }
  catch (const boost::property_tree::ptree_error& error)
  {
    throw BadInput(std::string("the list of frames cannot be read: ") +
                       error.what(),
                   file, 0, "");
  }
  return frames;
}

std::string make_pvd(const std::vector<PvdFrame>& frames)
{
  ptree collection;
  for (const PvdFrame& frame : frames)
    for (const auto& [part, file] : frame.parts)
      collection.add_child("DataSet", make_data_set(frame.time, part, file));
  ptree tree;
  tree.put("VTKFile.<xmlattr>.type", "Collection");
  tree.put("VTKFile.<xmlattr>.version", "0.1");
  tree.put_child("VTKFile.Collection", collection);
  std::ostringstream stream;
  boost::property_tree::write_xml(
      stream, tree,
      boost::property_tree::xml_writer_make_settings<std::string>(' ', 2));
  return stream.str();
}
} // namespace taut::io
