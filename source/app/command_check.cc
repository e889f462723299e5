#include <taut/io/film_model.h>
#include <taut/io/parameters.h>
#include <taut/structure/probes.h>
#include <taut/structure/watches.h>

#include <fmt/format.h>

#include <iostream>
#include <memory>

#include "commands.h"
#include "exit_codes.h"

namespace taut::app
{
namespace
{
struct CheckArguments
{
  std::string case_file;
  std::vector<std::string> overrides;
};

/// Sums over the cells of one film.
struct FilmMeasure
{
  double cells = 0;
  double volume = 0; ///< undeformed (m^3)
};

std::vector<FilmMeasure> measure_films(const structure::Structure& structure)
{
  const fe::FilmCells& cells = structure.cells();
  std::vector<FilmMeasure> films(structure.device().films.size());
  for (unsigned int cell = 0; cell < cells.cells().size(); ++cell)
  {
    FilmMeasure& film = films[cells.cells()[cell].film];
    film.cells += 1;
    for (unsigned int q = 0; q < cells.element().n_nodes; ++q)
      film.volume += cells.volume(cell, q);
  }
  for (FilmMeasure& film : films)
  {
    film.cells =
        dealii::Utilities::MPI::sum(film.cells, structure.communicator());
    film.volume =
        dealii::Utilities::MPI::sum(film.volume, structure.communicator());
  }
  return films;
}

std::string describe_film(const structure::Film& film,
                          const FilmMeasure& measure)
{
  const double area = measure.volume / film.thickness;
  return fmt::format("film {}: {:.0f} cells, {:.6g} m^2 in the mesh, {:.6g} "
                     "m^2 undeformed, {:.6g} kg\n",
                     film.name, measure.cells,
                     area * film.pre_stretch[0] * film.pre_stretch[1], area,
                     measure.volume * film.material.density);
}

std::string describe_bar(const structure::RigidBar& description,
                         const fe::Bar& bar)
{
  return fmt::format("bar {}: {:.6g} m, {:.6g} kg, {:.6g} kg m^2\n",
                     description.name, 2 * bar.half_length, bar.mass,
                     bar.rotary_inertia);
}

std::unique_ptr<structure::StructureSystem>
make_system(const study::Case& film_case, structure::Structure& structure)
{
  if (film_case.procedure.analysis == structure::Analysis::transient)
    return std::make_unique<structure::InertialSystem>(structure);
  return std::make_unique<structure::QuasiStaticSystem>(structure,
                                                        time::PathOptions());
}

/// All that a run would refuse before its first step is refused here, too.
void check_observers(const study::Case& film_case,
                     structure::Structure& structure)
{
  io::name_case_in_errors(film_case,
                          [&]
                          {
                            const auto system =
                                make_system(film_case, structure);
                            structure::Probes probes(*system);
                            structure::Watches watches(*system, probes);
                          });
}

std::string describe_model(const study::Case& film_case,
                           const MPI_Comm communicator)
{
  io::FilmModel model(film_case, communicator);
  structure::Structure& structure = model.structure();
  check_observers(film_case, structure);
  const structure::Device& device = film_case.device;
  std::string text = fmt::format(
      "mesh {}: {} cells after {} refinements, degree {}, {} free unknowns\n",
      device.mesh.file, model.triangulation().n_global_active_cells(),
      device.mesh.refinements, device.mesh.degree, structure.n_free_global());
  const auto films = measure_films(structure);
  for (std::size_t i = 0; i < films.size(); ++i)
    text += describe_film(device.films[i], films[i]);
  for (std::size_t i = 0; i < device.bars.size(); ++i)
    text += describe_bar(device.bars[i], structure.nodes().bars[i]);
  return text;
}

int check(const CheckArguments& arguments, const MPI_Comm communicator)
{
  const study::Case content =
      io::read_case(arguments.case_file, arguments.overrides);
  std::string text = content.model == "film"
                         ? describe_model(content, communicator)
                         : "lumped " + content.model + ", no mesh\n";
  if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
    std::cout << text << arguments.case_file << " is in order\n";
  return done;
}
} // namespace

void add_check(CLI::App& program, Action& chosen)
{
  auto* command = program.add_subcommand(
      "check", "Read a case with its mesh, print what it is and run nothing");
  const auto arguments = std::make_shared<CheckArguments>();
  command->add_option("CASE", arguments->case_file, "a .prm or .json")
      ->required();
  command->add_option("--set", arguments->overrides,
                      "'Section/Key = value' in place of the file's");
  command->callback(
      [&chosen, arguments]
      {
        chosen = [arguments](const MPI_Comm communicator)
        { return check(*arguments, communicator); };
      });
}
} // namespace taut::app
