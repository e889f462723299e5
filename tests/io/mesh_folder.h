// Meshes in text, and a folder for their files.
#pragma once

#include <taut/io/gmsh_reader.h>

#include <gmsh.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

namespace taut::io
{
using Parameters = std::map<std::string, double>;

/// Two unit squares side by side, two cells along each edge.
inline const std::string squares = R"(
DefineConstant[ size = {1, Name "Size"}, cells = 2, order = 1 ];
Point(1) = {0, 0, 0}; Point(2) = {size, 0, 0}; Point(3) = {2 * size, 0, 0};
Point(4) = {2 * size, size, 0}; Point(5) = {size, size, 0};
Point(6) = {0, size, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 5};
Line(5) = {5, 6}; Line(6) = {6, 1}; Line(7) = {2, 5};
Curve Loop(1) = {1, 7, 5, 6}; Plane Surface(1) = {1};
Curve Loop(2) = {2, 3, 4, -7}; Plane Surface(2) = {2};
Transfinite Curve {1 : 7} = cells + 1; Transfinite Surface {1, 2};
Mesh.ElementOrder = order;
)";
inline const std::string recombined = squares + "Recombine Surface {1, 2};\n";
inline const std::string grouped = recombined + R"(
Physical Surface("left") = {1};
Physical Surface("all") = {1, 2};
Physical Curve("middle") = {7};
Physical Curve("lower") = {1, 2};
Physical Curve("lower left") = {1};
Physical Curve(77) = {3};
Physical Point("corner") = {4};
)";

/// A fixture whose folder lives as long as one test.
class MeshFolder : public testing::Test
{
protected:
  void SetUp() override
  {
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override
  {
    std::filesystem::remove_all(folder_);
  }

  std::string get_path(const std::string& name) const
  {
    return (folder_ / name).string();
  }

  std::string write(const std::string& name, const std::string& text) const
  {
    std::ofstream(get_path(name)) << text;
    return get_path(name);
  }

  fe::MeshData read_text(const std::string& text,
                         const Parameters& parameters = {}) const
  {
    return io::read_mesh(write("mesh.geo", text), parameters);
  }

  /// Lets gmsh itself write the mesh of `text`.
  std::string write_msh(const std::string& text, const double version,
                        const bool binary, const std::string& name) const
  {
    const std::string geometry = write("source.geo", text);
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::open(geometry);
    gmsh::model::mesh::generate(2);
    gmsh::option::setNumber("Mesh.MshFileVersion", version);
    gmsh::option::setNumber("Mesh.Binary", binary);
    gmsh::write(get_path(name));
    gmsh::finalize();
    return get_path(name);
  }

private:
  std::filesystem::path folder_ = std::filesystem::temp_directory_path() /
                                  ("taut_gmsh_" + std::to_string(getpid()));
};
} // namespace taut::io
