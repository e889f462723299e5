#pragma once

#include <taut/structure/systems.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace taut::io
{
/// fields.pvd and the frames it names, fields/frame_N.vtu: the film over time
/// for ParaView, quadratic cells where the film has them; see FilmPatches for
/// what they carry. On several ranks a frame is a .pvtu with one .vtu per rank.
/// fields.pvd is complete after every frame.
class FieldsWriter
{
public:
  /// `folder` exists. Goes on after the first `frames` frames of an old
  /// fields.pvd and removes the others. Collective. Errors: BadInput if the old
  /// file cannot be read or has fewer frames, std::runtime_error.
  FieldsWriter(const std::string& folder, MPI_Comm communicator,
               std::size_t frames = 0);

  /// Adds a frame. Collective. Errors: std::runtime_error if it cannot be
  /// written.
  void write(double time, structure::StructureSystem& system,
             const double* state);

private:
  void open(std::size_t frames);
  std::string write_frame(double time, structure::StructureSystem& system,
                          const double* state) const;
  void write_collection() const;

  const std::string folder_;
  const MPI_Comm communicator_;
  const unsigned int rank_, n_ranks_;
  std::size_t next_frame_;
  /// Time (s) and file of every frame; on rank 0.
  std::vector<std::pair<double, std::string>> frames_;
};
} // namespace taut::io
