#include <taut/study/modes_report.h>

#include <cmath>

#include <boost/math/constants/constants.hpp>

namespace taut::study
{
namespace
{
constexpr double full_turn = 2 * boost::math::constants::pi<double>();
} // namespace

double ModesReport::Mode::frequency() const
{
  return std::sqrt(std::max(0., square)) / full_turn;
}

std::vector<Column> make_mode_columns(const ModesReport& report)
{
  std::vector<Column> columns{{"mode", "1"},
                              {"frequency", "Hz"},
                              {"angular frequency squared", "1/s^2"},
                              {"damped frequency", "Hz"},
                              {"damping ratio", "1"},
                              {"growth rate", "1/s"},
                              {"modal mass", report.mass_unit}};
  if (report.total_mass > 0)
    for (const char* kind : {"effective mass ", "share of mass "})
      for (const char* axis : {"x", "y", "z"})
        columns.push_back({std::string(kind) + axis,
                           std::string(kind)[0] == 'e' ? "kg" : "1"});
  for (const ModesRelaxation& relaxation : report.relaxations)
    columns.push_back({"omega T " + relaxation.name, "1"});
  return columns;
}

std::vector<double> make_mode_row(const ModesReport& report,
                                  const std::size_t mode)
{
  const ModesReport::Mode& entry = report.modes.at(mode);
  std::vector<double> row{
      double(mode + 1),    entry.frequency(),
      entry.square,        entry.damped_angular_frequency / full_turn,
      entry.damping_ratio, entry.growth_rate,
      entry.modal_mass};
  if (report.total_mass > 0)
  {
    for (const double mass : entry.effective_masses)
      row.push_back(mass);
    for (const double mass : entry.effective_masses)
      row.push_back(mass / report.total_mass);
  }
  row.insert(row.end(), entry.products.begin(), entry.products.end());
  return row;
}
} // namespace taut::study
