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

void check_keys(const StudyFile& study, const study::StudyCase& study_case,
                const std::vector<SectionPath>& owners)
{
  CaseText text = study.case_text;
  const std::size_t n_keys = study_case.keys.size();
  for (const std::string& option : get_overrides(study_case))
    text.override_entry(option);
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
  // The overridden keys stand at the end of the text.
  const std::vector<Entry>& entries = text.entries();
  for (std::size_t i = 0; i + n_keys < entries.size(); ++i)
    all.require_known(entries[i]);
  for (std::size_t i = 0; i < n_keys; ++i)
    try
    {
      all.require_known(entries[entries.size() - n_keys + i]);
    }
    catch (const BadInput& problem)
    {
      study.text.refuse(owners[i], "Key",
                        "the case has no '" + study_case.keys[i].key +
                            "': " + problem.message());
    }
}
} // namespace

std::vector<std::string> get_overrides(const study::StudyCase& study_case)
{
  std::vector<std::string> overrides;
  for (const study::KeyValue& item : study_case.keys)
    overrides.push_back(item.key + " = " + item.value);
  return overrides;
}

std::vector<study::StudyCase> make_cases(const StudyFile& study)
{
  auto cases = study::expand(study.content);
  const auto owners = get_owners(study.content);
  std::set<std::string> checked;
  for (const study::StudyCase& study_case : cases)
    if (checked.insert(get_words(study_case)).second)
      check_keys(study, study_case, owners);
  return cases;
}
} // namespace taut::io
