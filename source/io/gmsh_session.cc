#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>
#include <taut/io/geo_parameters.h>
#include <taut/io/gmsh_session.h>

#include <fmt/format.h>
#include <gmsh.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <vector>

namespace taut::io
{
namespace
{
using Parameters = std::map<std::string, double>;

bool is_geometry(const std::string& file)
{
  return std::filesystem::path(file).extension() == ".geo";
}

std::string read_text(const std::string& file)
{
  std::ifstream stream(file);
  if (!std::filesystem::is_regular_file(file) || !stream)
    throw BadInput("the mesh file is missing or cannot be read", file, 0, "");
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// gmsh itself opens a missing file, an empty one or a folder in silence.
void check_file(const std::string& file)
{
  const std::string extension = std::filesystem::path(file).extension();
  if (extension != ".geo" && extension != ".msh")
    throw BadInput("a mesh is read from a .geo or .msh file", file, 0, "");
  const std::string text = read_text(file);
  if (std::all_of(text.begin(), text.end(),
                  [](const unsigned char c) { return std::isspace(c); }))
    throw BadInput("the mesh file is empty", file, 0, "");
  // Without a line break at its end gmsh carries out only the first statement
  // of the last line, in silence.
  const std::string last_line = text.substr(text.rfind('\n') + 1);
  if (is_geometry(file) &&
      std::count(last_line.begin(), last_line.end(), ';') > 1)
    throw BadInput("the last line holds several statements and must end with "
                   "a line break, or gmsh passes over all but the first",
                   file, 0, "");
}

void check_parameters(const std::string& file, const Parameters& parameters)
{
  if (parameters.empty())
    return;
  if (!is_geometry(file))
    throw BadInput("only a .geo has parameters, a .msh has none", file, 0,
                   parameters.begin()->first);
  const std::vector<std::string> known = get_geo_parameter_names(file);
  for (const auto& [name, value] : parameters)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw BadInput("no DefineConstant of the .geo has a parameter '" + name +
                         "'; " + suggest(name, known),
                     file, 0, name);
}

/// Takes file and line out of gmsh's "'file', line 3: text".
BadInput make_error(const std::string& file, const std::string& gmsh_message)
{
  static const std::regex with_line("'([^']*)', line ([0-9]+) ?: ?(.*)");
  std::smatch match;
  if (!std::regex_match(gmsh_message, match, with_line))
    return BadInput("gmsh says: " + gmsh_message, file, 0, "");
  return BadInput("gmsh says: " + match[3].str(), match[1],
                  std::stoul(match[2]), "");
}

/// Algorithm 8 ends the process with a segmentation fault as soon as it has to
/// recombine (gmsh 4.8.4).
void check_algorithm(const std::string& file)
{
  double algorithm = 0;
  gmsh::option::getNumber("Mesh.Algorithm", algorithm);
  if (algorithm == 8)
    throw BadInput("Mesh.Algorithm = 8 crashes gmsh when it recombines; use "
                   "Mesh.Algorithm = 6",
                   file, 0, "");
}

/// A variable that exists wins over its DefineConstant. The interface of gmsh
/// 4.8 cannot set one, so a file in gmsh's language does.
void set_variables(const Parameters& parameters)
{
  if (parameters.empty())
    return;
  const auto file = std::filesystem::temp_directory_path() /
                    fmt::format("taut_variables_{}.geo", getpid());
  std::ofstream stream(file);
  for (const auto& [name, value] : parameters)
    stream << fmt::format("{} = {:.17g};\n", name, value);
  stream.close();
  if (!stream)
    throw BadInput("the mesh parameters cannot be handed to gmsh: no file can "
                   "be written to " +
                   file.parent_path().string());
  gmsh::merge(file.string());
  std::filesystem::remove(file);
}

/// Merges the file where `open` would forget the variables.
void open_and_mesh(const std::string& file)
{
  gmsh::merge(file);
  if (is_geometry(file))
  {
    check_algorithm(file);
    gmsh::model::mesh::generate(2);
  }
  gmsh::model::mesh::removeDuplicateNodes();
}
} // namespace

GmshSession::Library::Library()
{
  const bool read_configuration = false;
  gmsh::initialize(0, nullptr, read_configuration);
  gmsh::option::setNumber("General.Terminal", 0);
  // The named parameters of DefineConstant outlive an earlier finalize.
  gmsh::onelab::clear();
}

GmshSession::Library::~Library()
{
  gmsh::finalize();
}

GmshSession::GmshSession(const std::string& file, const Parameters& parameters)
{
  check_file(file);
  check_parameters(file, parameters);
  try
  {
    set_variables(parameters);
    open_and_mesh(file);
  }
  catch (const std::string& gmsh_message)
  {
    throw make_error(file, gmsh_message);
  }
}
} // namespace taut::io
