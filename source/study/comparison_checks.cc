#include "comparison_checks.h"

#include <taut/base/exceptions.h>

namespace taut::study
{
void refuse(const Case& film_case, const std::string& kind,
            const structure::Named& entry, const std::string& message)
{
  throw BadInput(message, film_case.file, entry.source_line,
                 kind + " " + entry.name);
}

void refuse(const Case& film_case, const std::string& message)
{
  throw BadInput(message, film_case.file, 0, "Comparison");
}

void check_loads(const Case& film_case)
{
  const structure::Device& device = film_case.device;
  check_no_others(film_case, "Pressure", device.pressures, {});
  check_no_others(film_case, "Edge load", device.edge_loads, {});
  for (const double component : device.environment.gravity)
    if (component != 0)
      throw BadInput("the lumped model of the comparison knows no gravity",
                     film_case.file, 0, "Environment");
  for (const structure::Support& support : device.supports)
    for (const std::string& shape : support.shape)
      if (shape != "0")
        refuse(film_case, "Support", support,
               "the frame of the lumped model does not move");
}
} // namespace taut::study
