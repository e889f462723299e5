#pragma once

#include <taut/io/film_patches.h>
#include <taut/io/frame_patches.h>
#include <taut/io/pvd_file.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace taut::io
{
/// fields.pvd and the files it names: the device over time for ParaView.
/// fields/frame_N.vtu is the film, part 0 of the collection, with quadratic
/// cells where it has them, see FilmPatches for what it carries; on several
/// ranks a .pvtu with one .vtu per rank. fields/beams_N.vtu is its frames, part
/// 1, with straight lines between the nodes, see FramePatches; the first rank
/// writes them. fields.pvd is complete after every
/// time.
class FieldsWriter
{
public:
  /// `folder` exists. Goes on after the first `frames` times of an old
  /// fields.pvd and removes the others. Collective. Errors: BadInput if the old
  /// file cannot be read or has fewer times, std::runtime_error.
  FieldsWriter(const std::string& folder, MPI_Comm communicator,
               std::size_t frames = 0);

  /// Adds a time. Collective. Errors: std::runtime_error if it cannot be
  /// written.
  void write(double time, structure::StructureSystem& system,
             const double* state);

  /// The same for parts that are made already: none of a device without a film,
  /// or without frames. The film's are those of this rank, the beams' count on
  /// the first rank.
  void write(double time, const std::optional<FilmPatches>& film,
             const std::optional<FramePatches>& beams);

private:
  void open(std::size_t frames);
  std::string write_film(double time, const FilmPatches& film) const;
  std::string write_beams(double time, const FramePatches& beams) const;

  const std::string folder_;
  const MPI_Comm communicator_;
  const unsigned int rank_, n_ranks_;
  std::size_t next_frame_;
  /// On rank 0.
  std::vector<PvdFrame> frames_;
};
} // namespace taut::io
