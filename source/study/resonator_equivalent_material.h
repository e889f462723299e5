#pragma once

#include <taut/structure/description.h>
#include <taut/study/case.h>

#include <string>

namespace taut::study
{
/// Moduli, relaxation times, limit, density, permittivity and strength of the
/// film's material; thickness and pre-stretch of the film.
/// Errors: BadInput, at the film's line in `file`, if the lumped model cannot
/// represent the material.
void read_film(const structure::Film& film, const std::string& file,
               LumpedResonatorDescription& resonator);

/// Refuses two films of which the lumped model would need two descriptions.
/// Errors: BadInput that says what differs.
void check_same(const structure::Film& active, const structure::Film& passive,
                const std::string& file);
} // namespace taut::study
