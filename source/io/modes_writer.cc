#include <taut/io/fields_writer.h>
#include <taut/io/history_writer.h>
#include <taut/io/modes_writer.h>

#include <deal.II/fe/fe_tools.h>

#include <algorithm>

namespace taut::io
{
namespace
{
using dealii::DataOutBase::Patch;

/// Rows behind all values: where the points are.
constexpr unsigned int n_place_rows = 3;

/// Opens three rows of zeros before the places, for a vector.
template <int dim>
void add_rows(Patch<dim, 3>& patch)
{
  const dealii::Table<2, float> old = patch.data;
  const unsigned int rows = old.n_rows(), columns = old.n_cols();
  const unsigned int first = rows - n_place_rows;
  patch.data.reinit(rows + 3, columns);
  for (unsigned int i = 0; i < rows; ++i)
    for (unsigned int j = 0; j < columns; ++j)
      patch.data(i < first ? i : i + 3, j) = old(i, j);
}

/// The vector of point `point` of a patch with opened rows.
template <int dim>
void set_vector(const std::vector<double>& motion, const fe::LocalNode node,
                const unsigned int point, Patch<dim, 3>& patch)
{
  const unsigned int first = patch.data.n_rows() - n_place_rows - 3;
  for (unsigned int d = 0; d < 3; ++d)
    patch.data(first + d, point) = motion.empty() ? 0. : motion[3 * node + d];
}

template <class Patches>
void open(Patches& content)
{
  content.add_vector("mode", "m");
  for (auto& patch : content.patches)
    add_rows(patch);
}

void set_motion(const structure::Structure& structure,
                const std::vector<double>& motion, FilmPatches& film)
{
  const auto& cells = structure.cells();
  const auto order = dealii::FETools::lexicographic_to_hierarchic_numbering<2>(
      cells.element().degree);
  for (std::size_t cell = 0; cell < film.patches.size(); ++cell)
    for (unsigned int i = 0; i < order.size(); ++i)
      set_vector(motion, cells.cells()[cell].nodes[order[i]], i,
                 film.patches[cell]);
}

void set_motion(const structure::Structure& structure,
                const std::vector<double>& motion, FramePatches& beams)
{
  const auto& elements = structure.frames().elements();
  for (std::size_t e = 0; e < elements.size(); ++e)
  {
    // Ends, then middle, in the order of the patch: along the element.
    std::vector<fe::LocalNode> along = elements[e].positions;
    if (along.size() == 3)
      std::swap(along[1], along[2]);
    for (unsigned int i = 0; i < along.size(); ++i)
      set_vector(motion, along[i], i, beams.patches[e]);
  }
}
} // namespace

void write_mode_table(const std::string& file, const study::ModesReport& report)
{
  HistoryWriter table(file, study::make_mode_columns(report));
  for (std::size_t mode = 0; mode < report.modes.size(); ++mode)
    table.write(study::make_mode_row(report, mode));
}

void write_mode_shapes(const std::string& folder,
                       const study::ModeShapes& shapes)
{
  structure::Structure& structure = shapes.system.structure();
  std::optional<FilmPatches> film;
  std::optional<FramePatches> beams;
  if (!structure.mesh().only_lines)
  {
    film = make_film_patches(shapes.time, shapes.system, shapes.state);
    open(*film);
  }
  if (!structure.device().frames.empty())
  {
    beams = make_frame_patches(
        compute_frame_fields(structure,
                             shapes.system.loads_at(shapes.time, shapes.state),
                             shapes.state),
        structure.device().frames);
    open(*beams);
  }
  FieldsWriter writer(folder, structure.communicator());
  for (std::size_t frame = 0; frame <= shapes.motions.size(); ++frame)
  {
    const std::vector<double> motion =
        frame == 0 ? std::vector<double>() : shapes.motions[frame - 1];
    if (film)
      set_motion(structure, motion, *film);
    if (beams)
      set_motion(structure, motion, *beams);
    writer.write(double(frame), film, beams);
  }
}
} // namespace taut::io
