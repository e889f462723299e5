#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>
#include <taut/io/case_sections.h>
#include <taut/io/parameters.h>
#include <taut/io/study_file.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
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

/// `a | b` would end a cell of a table.
std::string make_cell(std::string text)
{
  for (std::size_t i = text.find('|'); i != std::string::npos;
       i = text.find('|', i + 2))
    text.insert(i, 1, '\\');
  return text;
}

std::string start_upper(std::string text)
{
  text.at(0) = static_cast<char>(std::toupper(text.at(0)));
  return text;
}

void describe_section_on_page(std::ostream& stream, const Declarations& all,
                              const SectionDocumentation& section)
{
  stream << fmt::format("\n## {}\n\n{}.\n\n",
                        section.section.empty() ? "Top level"
                                                : join(section.section),
                        start_upper(section.meaning));
  bool first = true;
  for (const Parameter& parameter : all.parameters())
  {
    if (parameter.section != section.section)
      continue;
    if (first)
      stream << "| key | default | meaning |\n|---|---|---|\n";
    first = false;
    stream << fmt::format("| `{}` | {} | {} |\n", parameter.key,
                          make_cell(show_default(parameter)),
                          make_cell(parameter.documentation));
  }
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

void describe_as_page(std::ostream& stream)
{
  Declarations of_case, of_study;
  CaseDraft case_draft;
  StudyDraft study_draft;
  declare_everything(of_case, case_draft);
  declare_any_sweep(of_study, study_draft);
  stream << "# Parameters of cases and studies\n\n"
            "What `taut describe --markdown` prints. Sections called `KIND "
            "NAME` may be given any number of times, under names of your own; "
            "a section inside another stands behind a slash. Values are in SI "
            "units and stand without them.\n";
  for (const SectionDocumentation& section : of_case.sections())
    describe_section_on_page(stream, of_case, section);
  stream << "\n# Studies\n";
  for (const SectionDocumentation& section : of_study.sections())
    describe_section_on_page(stream, of_study, section);
}
} // namespace taut::io
