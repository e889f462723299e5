#pragma once

#include <taut/lumped/demes_si.h>
#include <taut/study/case.h>

namespace taut::study
{
/// Thickness, stretch, material and temperature of the film of a lumped DEMES.
/// Errors: BadInput that names what it cannot have.
void read_demes_film(const Case& film_case, const structure::Film& film,
                     lumped::DemesSI& device);

/// The value of a signal called `name`. Errors: BadInput if it changes.
double read_constant(const Case& film_case, const std::string& kind,
                     const structure::Named& entry, const Signal& signal,
                     const std::string& name);
} // namespace taut::study
