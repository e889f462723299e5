#pragma once

#include <taut/structure/systems.h>

#include <string>
#include <vector>

namespace taut::study
{
/// What the user should know of the state a run starts from: whether much of
/// the film would be in compression. Collective.
std::vector<std::string> make_start_notes(structure::StructureSystem& system,
                                          double time, const double* state);
} // namespace taut::study
