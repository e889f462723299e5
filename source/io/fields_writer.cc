#include <taut/base/exceptions.h>
#include <taut/io/fields_writer.h>
#include <taut/io/files.h>

#include <fmt/format.h>

#include <filesystem>
#include <set>
#include <sstream>

namespace taut::io
{
namespace
{
namespace fs = std::filesystem;

/// The parts of fields.pvd.
enum Part : unsigned int
{
  film_part = 0,
  beams_part = 1
};

/// The stem of frame_N.vtu, frame_N.pvtu and frame_N.RANK.vtu.
std::string get_stem(const fs::path& file)
{
  const std::string name = file.filename();
  return name.substr(0, name.find('.'));
}

/// Files of a run that came further than its last checkpoint.
void remove_others(const fs::path& folder, const std::vector<PvdFrame>& frames)
{
  std::set<std::string> known;
  for (const PvdFrame& frame : frames)
    for (const auto& [part, file] : frame.parts)
      known.insert(get_stem(file));
  std::vector<fs::path> others;
  for (const auto& entry : fs::directory_iterator(folder))
    if (known.count(get_stem(entry.path())) == 0)
      others.push_back(entry.path());
  for (const fs::path& file : others)
    fs::remove(file);
}

bool is_quadratic(const FilmPatches& film)
{
  return !film.patches.empty() && film.patches.front().n_subdivisions > 1;
}

/// deal.II 9.4 writes wrong corners for curved lines: a beam element of three
/// nodes becomes two straight ones.
bool is_quadratic(const FramePatches&)
{
  return false;
}

template <class Patches>
dealii::DataOutBase::VtkFlags make_flags(const double time,
                                         const Patches& content)
{
  using Flags = dealii::DataOutBase::VtkFlags;
  Flags flags(time);
  flags.print_date_and_time = false;
  flags.compression_level = Flags::best_speed;
  flags.write_higher_order_cells = is_quadratic(content);
  flags.physical_units = content.units;
  return flags;
}

template <class Patches>
void write_vtu(const std::string& file, const double time,
               const Patches& content)
{
  std::ostringstream stream;
  dealii::DataOutBase::write_vtu(content.patches, content.names,
                                 content.vectors, make_flags(time, content),
                                 stream);
  replace_file(file, stream.str());
}
} // namespace

FieldsWriter::FieldsWriter(const std::string& folder,
                           const MPI_Comm communicator,
                           const std::size_t frames)
    : folder_(folder), communicator_(communicator),
      rank_(dealii::Utilities::MPI::this_mpi_process(communicator)),
      n_ranks_(dealii::Utilities::MPI::n_mpi_processes(communicator)),
      next_frame_(frames)
{
  if (rank_ == 0)
    open(frames);
  MPI_Barrier(communicator_);
}

void FieldsWriter::open(const std::size_t frames)
{
  const std::string collection = folder_ + "/fields.pvd";
  fs::create_directories(fs::path(folder_) / "fields");
  if (frames > 0)
    frames_ = read_pvd(collection);
  if (frames_.size() < frames)
    throw BadInput(fmt::format("the file names {} frames, but the checkpoint "
                               "was written after {}",
                               frames_.size(), frames),
                   collection, 0, "");
  frames_.resize(frames);
  remove_others(fs::path(folder_) / "fields", frames_);
}

std::string FieldsWriter::write_film(const double time,
                                     const FilmPatches& film) const
{
  const std::string stem = fmt::format("fields/frame_{:05}", next_frame_);
  const auto get_piece = [&](const unsigned int rank)
  {
    return n_ranks_ == 1 ? stem + ".vtu" : fmt::format("{}.{}.vtu", stem, rank);
  };
  write_vtu(folder_ + "/" + get_piece(rank_), time, film);
  if (n_ranks_ == 1)
    return stem + ".vtu";
  if (rank_ == 0)
  {
    std::vector<std::string> pieces;
    for (unsigned int rank = 0; rank < n_ranks_; ++rank)
      pieces.push_back(fs::path(get_piece(rank)).filename());
    std::ostringstream record;
    dealii::DataOutBase::write_pvtu_record(
        record, pieces, film.names, film.vectors, make_flags(time, film));
    replace_file(folder_ + "/" + stem + ".pvtu", record.str());
  }
  return stem + ".pvtu";
}

std::string FieldsWriter::write_beams(const double time,
                                      const FramePatches& beams) const
{
  const std::string file = fmt::format("fields/beams_{:05}.vtu", next_frame_);
  if (rank_ == 0)
    write_vtu(folder_ + "/" + file, time, beams);
  return file;
}

void FieldsWriter::write(const double time,
                         const std::optional<FilmPatches>& film,
                         const std::optional<FramePatches>& beams)
{
  PvdFrame frame{time, {}};
  if (film)
    frame.parts[film_part] = write_film(time, *film);
  if (beams)
    frame.parts[beams_part] = write_beams(time, *beams);
  ++next_frame_;
  // The collection names only pieces that are there.
  MPI_Barrier(communicator_);
  if (rank_ != 0)
    return;
  frames_.push_back(frame);
  replace_file(folder_ + "/fields.pvd", make_pvd(frames_));
}

void FieldsWriter::write(const double time, structure::StructureSystem& system,
                         const double* state)
{
  structure::Structure& structure = system.structure();
  const auto& frames = structure.device().frames;
  std::optional<FilmPatches> film;
  std::optional<FramePatches> beams;
  if (!structure.mesh().only_lines)
    film = make_film_patches(time, system, state);
  if (!frames.empty())
    beams = make_frame_patches(
        compute_frame_fields(structure, system.loads_at(time, state), state),
        frames);
  write(time, film, beams);
}
} // namespace taut::io
