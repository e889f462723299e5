#include <taut/io/film_model.h>
#include <taut/io/first_rank.h>
#include <taut/io/gmsh_reader.h>
#include <taut/study/adaptation.h>

namespace taut::io
{
FilmModel::FilmModel(const study::Case& film_case, const MPI_Comm communicator,
                     const StoredRun* stored)
    : triangulation_(communicator)
{
  name_case_in_errors(film_case, [&] { build(film_case, stored); });
}

void FilmModel::build(const study::Case& film_case, const StoredRun* stored)
{
  const structure::Device& device = film_case.device;
  mesh_ = read_shared_mesh(device.mesh, triangulation_.get_communicator());
  fe::create_triangulation(mesh_, stored ? 0 : device.mesh.refinements,
                           triangulation_);
  if (stored)
    restore_refinement(*stored, mesh_, triangulation_);
  structure_ =
      std::make_unique<structure::Structure>(device, mesh_, triangulation_);
}

void FilmModel::adapt(const study::Case& film_case)
{
  if (film_case.device.mesh.adaptive_refinements == 0)
    return;
  // The old structure stands on the mesh that is about to change.
  structure_.reset();
  structure_ = study::make_adapted_structure(film_case, mesh_, triangulation_);
}

fe::MeshData read_shared_mesh(const structure::MeshDescription& description,
                              const MPI_Comm communicator)
{
  return on_first_rank(
      communicator,
      [&] { return read_mesh(description.file, description.geo_parameters); });
}
} // namespace taut::io
