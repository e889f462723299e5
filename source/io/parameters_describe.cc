#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>
#include <taut/io/case_sections.h>
#include <taut/io/parameters.h>
#include <taut/io/study_file.h>

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <set>

namespace taut::io
{
namespace
{
std::string show_default(const Parameter& parameter)
{
  if (parameter.required)
    return "(must be given)";
  return parameter.default_text.empty() ? "(empty)" : parameter.default_text;
}

/// `file` is what holds the section: a case or a study.
void describe_section(std::ostream& stream, const Declarations& all,
                      const SectionDocumentation& section,
                      const std::string& file)
{
  stream << (section.section.empty() ? "Top level of a " + file + " file"
                                     : join(section.section))
         << ": " << section.meaning << '\n';
  for (const Parameter& parameter : all.parameters())
    if (parameter.section == section.section)
      stream << fmt::format("  {} = {}\n      {}\n", parameter.key,
                            show_default(parameter), parameter.documentation);
  stream << '\n';
}

/// "Film" of "Film NAME".
std::string kind_of(const std::string& section)
{
  return section.substr(0, section.find(" NAME"));
}

/// Whether `wanted` names the section or one around it, with or without the
/// NAME behind its kind.
bool is_called(const SectionPath& section, const std::string& wanted)
{
  return std::any_of(section.begin(), section.end(),
                     [&wanted](const std::string& name) {
                       return name == wanted ||
                              name.rfind(wanted + " ", 0) == 0;
                     });
}

/// Writes the sections called `wanted` and tells whether there was one; adds
/// all kinds of sections to `kinds`.
bool describe_file(std::ostream& stream, const Declarations& all,
                   const std::string& file, const std::string& wanted,
                   std::set<std::string>& kinds)
{
  bool found = false;
  for (const SectionDocumentation& candidate : all.sections())
  {
    if (!candidate.section.empty())
      kinds.insert(kind_of(candidate.section.back()));
    if (!wanted.empty() && !is_called(candidate.section, wanted))
      continue;
    found = true;
    describe_section(stream, all, candidate, file);
  }
  return found;
}
} // namespace

void describe(std::ostream& stream, const std::string& section)
{
  Declarations of_case, of_study;
  CaseDraft case_draft;
  StudyDraft study_draft;
  declare_everything(of_case, case_draft);
  declare_any_sweep(of_study, study_draft);
  std::set<std::string> kinds;
  const bool in_case = describe_file(stream, of_case, "case", section, kinds);
  const bool in_study =
      describe_file(stream, of_study, "study", section, kinds);
  if (!in_case && !in_study)
    throw BadInput(fmt::format("there is no section '{}'; {}", section,
                               suggest(section, {kinds.begin(), kinds.end()})));
}
} // namespace taut::io
