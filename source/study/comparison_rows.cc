#include "comparison_rows.h"

#include <algorithm>
#include <cmath>

namespace taut::study
{
Case without_files(Case film_case)
{
  film_case.output.write_fields = false;
  film_case.output.field_intervals = 0;
  film_case.checkpoint = {0, 0, 0};
  return film_case;
}

bool is_at_jump(const Signal& voltage, const double time)
{
  return voltage.value(time) != voltage.value_before(time);
}

void compute_differences(const std::vector<double>& times,
                         const std::vector<bool>& counts,
                         ComparedQuantity& quantity)
{
  double scale = 0, squares = 0;
  std::size_t n = 0;
  for (std::size_t i = 0; i < times.size(); ++i)
    if (counts[i])
      scale = std::max(scale, std::abs(quantity.lumped[i]));
  for (std::size_t i = 0; i < times.size() && scale > 0; ++i)
  {
    if (!counts[i])
      continue;
    const double difference =
        std::abs(quantity.film[i] - quantity.lumped[i]) / scale;
    squares += difference * difference;
    ++n;
    if (difference > quantity.max_relative_difference)
    {
      quantity.max_relative_difference = difference;
      quantity.time_of_max = times[i];
    }
  }
  if (n > 0)
    quantity.rms_relative_difference = std::sqrt(squares / double(n));
}
} // namespace taut::study
