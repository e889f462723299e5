#pragma once

#include <string>
#include <vector>

namespace taut::io
{
/// The names that a .geo file, or one that it includes, defines in
/// `DefineConstant [...]`, in the order of the text: these can be given other
/// values from outside. gmsh itself offers no such list.
/// Errors: BadInput if the file cannot be read.
std::vector<std::string> get_geo_parameter_names(const std::string& file);
} // namespace taut::io
