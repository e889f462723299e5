#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>
#include <taut/io/case_sections.h>
#include <taut/io/parameters.h>

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

namespace taut::io
{
namespace
{
/// A case with one section of every kind, and one spring of every law.
const char* const film_prototype = R"(
subsection Material NAME
  subsection Spring neo-Hookean
    set Law = neo-Hookean
  end
  subsection Spring Mooney-Rivlin
    set Law = Mooney-Rivlin
  end
  subsection Spring Gent
    set Law = Gent
  end
  subsection Spring Yeoh
    set Law = Yeoh
  end
  subsection Spring Arruda-Boyce
    set Law = Arruda-Boyce
  end
  subsection Network NAME
    set Law = neo-Hookean
  end
  subsection Dielectric
    set Permittivity = constant
  end
end
subsection Material NAME (stretch-dependent permittivity)
  subsection Dielectric
    set Permittivity = stretch-dependent
  end
end
subsection Film NAME
end
subsection Electrode NAME
end
subsection Support NAME
end
subsection Bar NAME
end
subsection Pressure NAME
end
subsection Edge load NAME
end
subsection Probe NAME
end
subsection Event NAME
end
subsection Comparison
end
)";

void describe_section(std::ostream& stream, const Declarations& all,
                      const SectionDocumentation& section)
{
  stream << (section.section.empty() ? "Top level" : join(section.section))
         << ": " << section.meaning << '\n';
  for (const Parameter& parameter : all.parameters())
    if (parameter.section == section.section)
      stream << fmt::format("  {} = {}\n      {}\n", parameter.key,
                            parameter.required ? "(must be given)"
                                               : parameter.default_text,
                            parameter.documentation);
  stream << '\n';
}

/// "Film" of "Film NAME".
std::string kind_of(const SectionDocumentation& section)
{
  const std::string& name = section.section.back();
  return name.substr(0, name.find(" NAME"));
}

/// Whether `wanted` names the section, with or without the NAME behind its
/// kind.
bool is_called(const SectionDocumentation& section, const std::string& wanted)
{
  if (section.section.empty())
    return false;
  const std::string& name = section.section.back();
  return name == wanted || name.rfind(wanted + " ", 0) == 0;
}
} // namespace

void declare_everything(Declarations& all, CaseDraft& draft)
{
  declare_case(all, CaseText::parse(film_prototype, "prototype.prm"), draft);
  declare_lumped_resonator(all, draft.content.lumped_resonator);
}

void describe(std::ostream& stream, const std::string& section)
{
  Declarations all;
  CaseDraft draft;
  declare_everything(all, draft);
  std::vector<std::string> known;
  bool found = false;
  for (const SectionDocumentation& candidate : all.sections())
  {
    if (!candidate.section.empty())
      known.push_back(kind_of(candidate));
    if (!section.empty() && !is_called(candidate, section))
      continue;
    found = true;
    describe_section(stream, all, candidate);
  }
  if (!found)
    throw BadInput(fmt::format("there is no section '{}'; {}", section,
                               suggest(section, known)));
}
} // namespace taut::io
