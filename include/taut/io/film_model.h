#pragma once

#include <taut/base/exceptions.h>
#include <taut/io/checkpoint.h>
#include <taut/structure/structure.h>
#include <taut/study/case.h>

#include <memory>

namespace taut::io
{
/// A case's device on its mesh.
class FilmModel
{
public:
  /// Reads and refines the mesh and sets up the structure; with `stored`, on
  /// the refined mesh of a stored run. Collective. Errors: BadInput of
  /// read_mesh, create_triangulation, Structure and restore_refinement, with
  /// the name of the case file if they name none.
  FilmModel(const study::Case& film_case, MPI_Comm communicator,
            const StoredRun* stored = nullptr);

  /// Refines the mesh adaptively if the case asks for it. Collective. Errors as
  /// study::make_adapted_structure.
  void adapt(const study::Case& film_case);

  const fe::MeshData& mesh() const
  {
    return mesh_;
  }
  const fe::Triangulation& triangulation() const
  {
    return triangulation_;
  }
  structure::Structure& structure()
  {
    return *structure_;
  }

private:
  void build(const study::Case& film_case, const StoredRun* stored);

  fe::MeshData mesh_;
  fe::Triangulation triangulation_;
  std::unique_ptr<structure::Structure> structure_;
};

/// Reads the mesh on the first rank and gives it to all. Collective. Errors as
/// read_mesh, on all ranks.
fe::MeshData read_shared_mesh(const structure::MeshDescription& description,
                              MPI_Comm communicator);

/// Calls function() and adds the name of the case file to a BadInput that names
/// no file.
template <typename Function>
auto name_case_in_errors(const study::Case& run_case, const Function& function)
{
  try
  {
    return function();
  }
  catch (const BadInput& error)
  {
    if (!error.file().empty())
      throw;
    throw BadInput(error.message(), run_case.file, error.line(), error.key());
  }
}
} // namespace taut::io
