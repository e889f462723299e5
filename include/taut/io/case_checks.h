#pragma once

#include <taut/io/case_sections.h>

/// Checks of a case that involve more than one key.
namespace taut::io
{
/// Puts materials into films and checks that every name that a section refers
/// to exists. Errors: BadInput at the line of the reference, with the names
/// that exist and the nearest.
void resolve_names(const CaseText& text, CaseDraft& draft);

/// Checks what no single key shows: see the functions of the source. Errors:
/// BadInput at the line of the key that is most likely wrong.
void check_case(const CaseText& text, const CaseDraft& draft);
} // namespace taut::io
