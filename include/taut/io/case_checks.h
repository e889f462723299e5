#pragma once

#include <taut/io/case_sections.h>

/// Checks of a case that involve more than one key.
namespace taut::io
{
/// Puts materials into films, sections into frames and checks that every name
/// that a section refers to exists. Errors: BadInput at the line of the
/// reference, with the names that exist and the nearest.
void resolve_names(const CaseText& text, CaseDraft& draft);

/// Checks what no single key shows: see the functions of the source. Errors:
/// BadInput at the line of the key that is most likely wrong.
void check_case(const CaseText& text, const CaseDraft& draft);

/// The parts of them for frames, and what goes with them: hinges, bodies,
/// masses and loads at points, rotations of supports, the way to a rest shape.
void resolve_frames(CaseDraft& draft);
void check_frames(const CaseText& text, const CaseDraft& draft);

/// The parts of them for the motion of a run and for a frequency response.
void check_motion(const CaseText& text, const study::Case& content);
void check_frequency_response(const CaseText& text, const study::Case& content);

/// Refuses the key Temperature of `section` if it leaves, during the run, the
/// range of the law; the message says the range and calls the law `law_name`.
void check_temperature(const CaseText& text, const SectionPath& section,
                       const Signal& temperature,
                       const material::TemperatureLaw& law,
                       const std::string& law_name,
                       const study::ProcedureDescription& procedure);

/// The same for the key Humidity; constant laws allow 0 to 1.
void check_humidity(const CaseText& text, const SectionPath& section,
                    const Signal& humidity, const material::HumidityLaw& law,
                    const std::string& law_name,
                    const study::ProcedureDescription& procedure);
} // namespace taut::io
