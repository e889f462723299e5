#include "run_notes.h"

#include <taut/structure/point_fields.h>

#include <algorithm>

namespace taut::study
{
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
  const long compressed = sum(std::count_if(
      critical.begin(), critical.end(),
      [](const auto& point) { return point.smaller_stress < 0; }));
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
