#pragma once

#include <taut/study/run.h>

#include <string>

namespace taut::io
{
/// section.csv (time and the quantity with its rate at each crossing) and
/// spectrum.csv (its amplitude over frequency), by the names of the files
/// without their ending.
std::map<std::string, study::Table>
make_motion_tables(const study::Motion& motion);

/// The text of a CSV with the header `name [unit]`.
std::string make_table_text(const study::Table& table);
} // namespace taut::io
