#include <taut/base/exceptions.h>
#include <taut/io/fields_writer.h>
#include <taut/io/files.h>
#include <taut/io/film_patches.h>

#include <fmt/format.h>

#include <filesystem>
#include <set>
#include <sstream>

#include <boost/property_tree/xml_parser.hpp>

namespace taut::io
{
namespace
{
namespace fs = std::filesystem;
using Frames = std::vector<std::pair<double, std::string>>;

Frames read_collection(const std::string& file)
{
  std::istringstream stream(read_file(file));
  boost::property_tree::ptree tree;
  Frames frames;
  try
  {
    boost::property_tree::read_xml(stream, tree);
    for (const auto& [name, node] : tree.get_child("VTKFile.Collection"))
      if (name == "DataSet")
        frames.emplace_back(node.get<double>("<xmlattr>.timestep"),
                            node.get<std::string>("<xmlattr>.file"));
  }
  catch (const boost::property_tree::ptree_error& error)
  {
    throw BadInput(std::string("the list of frames cannot be read: ") +
                       error.what(),
                   file, 0, "");
  }
  return frames;
}

/// The stem of frame_N.vtu, frame_N.pvtu and frame_N.RANK.vtu.
std::string get_stem(const fs::path& file)
{
  const std::string name = file.filename();
  return name.substr(0, name.find('.'));
}

/// Frames of a run that came further than its last checkpoint.
void remove_others(const fs::path& folder, const Frames& frames)
{
  std::set<std::string> known;
  for (const auto& frame : frames)
    known.insert(get_stem(frame.second));
  std::vector<fs::path> others;
  for (const auto& entry : fs::directory_iterator(folder))
    if (known.count(get_stem(entry.path())) == 0)
      others.push_back(entry.path());
  for (const fs::path& file : others)
    fs::remove(file);
}

dealii::DataOutBase::VtkFlags make_flags(const double time,
                                         const FilmPatches& film,
                                         const unsigned int degree)
{
  using Flags = dealii::DataOutBase::VtkFlags;
  Flags flags(time);
  flags.print_date_and_time = false;
  flags.compression_level = Flags::best_speed;
  flags.write_higher_order_cells = degree > 1;
  flags.physical_units = film.units;
  return flags;
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
    frames_ = read_collection(collection);
  if (frames_.size() < frames)
    throw BadInput(fmt::format("the file names {} frames, but the checkpoint "
                               "was written after {}",
                               frames_.size(), frames),
                   collection, 0, "");
  frames_.resize(frames);
  remove_others(fs::path(folder_) / "fields", frames_);
}

std::string FieldsWriter::write_frame(const double time,
                                      structure::StructureSystem& system,
                                      const double* state) const
{
  const FilmPatches film = make_film_patches(time, system, state);
  const auto flags =
      make_flags(time, film, system.structure().cells().element().degree);
  const std::string stem = fmt::format("fields/frame_{:05}", next_frame_);
  const auto get_piece = [&](const unsigned int rank)
  {
    return n_ranks_ == 1 ? stem + ".vtu" : fmt::format("{}.{}.vtu", stem, rank);
  };
  std::ostringstream piece;
  dealii::DataOutBase::write_vtu(film.patches, film.names, film.vectors, flags,
                                 piece);
  replace_file(folder_ + "/" + get_piece(rank_), piece.str());
  if (n_ranks_ == 1)
    return stem + ".vtu";
  if (rank_ == 0)
  {
    std::vector<std::string> pieces;
    for (unsigned int rank = 0; rank < n_ranks_; ++rank)
      pieces.push_back(fs::path(get_piece(rank)).filename());
    std::ostringstream record;
    dealii::DataOutBase::write_pvtu_record(record, pieces, film.names,
                                           film.vectors, flags);
    replace_file(folder_ + "/" + stem + ".pvtu", record.str());
  }
  return stem + ".pvtu";
}

void FieldsWriter::write_collection() const
{
  std::ostringstream stream;
  stream.precision(15);
  dealii::DataOutBase::write_pvd_record(stream, frames_);
  replace_file(folder_ + "/fields.pvd", stream.str());
}

void FieldsWriter::write(const double time, structure::StructureSystem& system,
                         const double* state)
{
  const std::string file = write_frame(time, system, state);
  ++next_frame_;
  // The collection names only pieces that are there.
  MPI_Barrier(communicator_);
  if (rank_ != 0)
    return;
  frames_.emplace_back(time, file);
  write_collection();
}
} // namespace taut::io
