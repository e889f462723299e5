#pragma once

#include <taut/study/modes.h>

#include <string>

namespace taut::io
{
/// modes.csv: one row a mode, columns as in history.csv. On one rank. Errors:
/// as CsvFile.
void write_mode_table(const std::string& file,
                      const study::ModesReport& report);

/// fields.pvd in `folder`: the equilibrium at "time" 0 and a frame for each
/// mode, its number the time. Everything is that of the equilibrium but for the
/// vector `mode` (m), which is 0 in the first frame; warped by displacement +
/// a mode, -1 < a < 1, the device vibrates. Collective. Errors: as
/// FieldsWriter.
void write_mode_shapes(const std::string& folder,
                       const study::ModeShapes& shapes);
} // namespace taut::io
