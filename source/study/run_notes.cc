#include "run_notes.h"

#include <taut/structure/point_fields.h>

namespace taut::study
{
namespace
{
/// How many of this rank's points are compressed by more than round-off.
long count_compressed(const structure::Structure& structure,
                      const std::vector<structure::CriticalValues>& critical)
{
  constexpr double round_off = 1e-9;
  const fe::FilmCells& cells = structure.cells();
  const unsigned int n = cells.element().n_nodes;
  long count = 0;
  for (std::size_t i = 0; i < critical.size(); ++i)
  {
    const auto& film = structure.device().films[cells.cells()[i / n].film];
    if (critical[i].smaller_stress <
        -round_off * material::shear_modulus(film.material))
      ++count;
  }
  return count;
}
} // namespace

std::vector<std::string> make_start_notes(structure::StructureSystem& system,
                                          const double time,
                                          const double* state)
{
  const auto critical = structure::compute_critical_values(
      system.structure(), system.loads_at(time, state), state,
      system.internal(state));
  const auto sum = [&](const long own)
  { return dealii::Utilities::MPI::sum(own, system.communicator()); };
  const long all = sum(static_cast<long>(critical.size()));
  const long compressed = sum(count_compressed(system.structure(), critical));
  // A few points at corners are no news.
  constexpr long share = 4;
  if (share * compressed <= all)
    return {};
  return {std::to_string(100 * compressed / all) +
          " % of the film would start in compression, where it wrinkles or is "
          "slack unless Tension field = false: is the pre-stretch large "
          "enough?"};
}
} // namespace taut::study
