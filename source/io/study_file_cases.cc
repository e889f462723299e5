#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>
#include <taut/io/case_sections.h>
#include <taut/io/study_file.h>

#include <set>

namespace taut::io
{
namespace
{
/// Which keys a case has depends on words in it, such as the name of a law, but
/// on no number.
std::string get_words(const study::StudyCase& study_case)
{
  std::string words;
  for (const study::KeyValue& item : study_case.keys)
  {
    double number;
    if (!read_number(item.value, number))
      words += item.value;
    words += '\n';
  }
  return words;
}

/// The sections of the study, in the order of a case's keys.
std::vector<SectionPath> get_owners(const study::StudyDescription& study)
{
  std::vector<SectionPath> owners;
  for (const study::SweepVariable& variable : study.variables)
    if (!variable.key.empty())
      owners.push_back({"Vary " + variable.name});
  for (const study::SweepSetting& setting : study.settings)
    owners.push_back({"Set " + setting.name});
  return owners;
}

/// The text of a case with its keys at the end.
CaseText make_text(const StudyFile& study, const study::StudyCase& study_case)
{
  CaseText text = study.case_text;
  for (const std::string& option : get_overrides(study_case))
    text.override_entry(option);
  return text;
}

std::string find_unit(const Declarations& all, const Entry& entry)
{
  for (const Parameter& parameter : all.parameters())
    if (parameter.section == entry.section && parameter.key == entry.key)
      return parameter.unit == "dimensionless" ? "1" : parameter.unit;
  return "";
}

/// Gives variables the units of their keys.
void complete_units(study::StudyDescription& study, const Declarations& all,
                    const std::vector<Entry>& keys)
{
  std::size_t i = 0;
  for (study::SweepVariable& variable : study.variables)
    if (!variable.key.empty())
    {
      const std::string unit = find_unit(all, keys[i++]);
      if (variable.unit.empty())
        variable.unit = unit;
    }
}

void check_keys(StudyFile& study, const study::StudyCase& study_case,
                const std::vector<SectionPath>& owners)
{
  const CaseText text = make_text(study, study_case);
  Declarations all;
  CaseDraft draft;
  try
  {
    declare_case(all, text, draft);
  }
  catch (const BadInput&)
  {
    // A value is wrong: the case will be refused when its turn comes.
    return;
  }
  const auto first_key = text.entries().end() - study_case.keys.size();
  const std::vector<Entry> own(text.entries().begin(), first_key);
  const std::vector<Entry> keys(first_key, text.entries().end());
  for (const Entry& entry : own)
    all.require_known(entry);
  for (std::size_t i = 0; i < keys.size(); ++i)
    try
    {
      all.require_known(keys[i]);
    }
    catch (const BadInput& problem)
    {
      study.text.refuse(owners[i], "Key",
                        "the case has no '" + study_case.keys[i].key +
                            "': " + problem.message());
    }
  complete_units(study.content, all, keys);
}
} // namespace

std::vector<std::string> get_overrides(const study::StudyCase& study_case)
{
  std::vector<std::string> overrides;
  for (const study::KeyValue& item : study_case.keys)
    overrides.push_back(item.key + " = " + item.value);
  return overrides;
}

void set_cases(StudyFile& study)
{
  study.cases = study::expand(study.content);
  const auto owners = get_owners(study.content);
  std::set<std::string> checked;
  for (const study::StudyCase& study_case : study.cases)
    if (checked.insert(get_words(study_case)).second)
      check_keys(study, study_case, owners);
}
} // namespace taut::io
