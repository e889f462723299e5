#pragma once

#include <map>
#include <string>

namespace taut::io
{
/// Holds gmsh, which is one global object, open with one mesh while it lives.
/// gmsh prints nothing and does not read the user's configuration.
class GmshSession
{
public:
  /// Opens `file`; a .geo is meshed with `geo_parameters` in place of its own.
  /// Errors: BadInput with gmsh's message; see read_mesh.
  GmshSession(const std::string& file,
              const std::map<std::string, double>& geo_parameters);

private:
  /// Between gmsh's initialize and finalize, also if opening the file fails.
  struct Library
  {
    Library();
    ~Library();
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
  };

  Library library_;
};
} // namespace taut::io
