#pragma once

#include <taut/io/case_text.h>
#include <taut/study/sweep.h>

#include <map>
#include <string>
#include <vector>

/// Study files: .prm, or .json in deal.II's short form.
namespace taut::io
{
class Declarations;

/// A variable while it is read.
struct VariableDraft : structure::Named
{
  std::string list;
  std::optional<std::array<double, 3>> range;
  study::Spacing spacing = study::Spacing::linear;
  std::string key, unit;
};

struct StudyDraft
{
  study::StudyDescription content;
  std::vector<VariableDraft> variables;
};

/// Declares everything that the study `text` may hold.
void declare_sweep(Declarations& all, const CaseText& text, StudyDraft& draft);
/// Declares every section of a study, with NAME in place of names.
void declare_any_sweep(Declarations& all, StudyDraft& draft);

/// What makes two studies the same.
struct StudyIdentity
{
  /// Text by path of all that is not the default, but for titles, plots and
  /// results, which change no case, and the name of the case file.
  std::map<std::string, std::string> parameters;
  /// The content of the case file.
  std::string case_content;
};

/// How `now` differs from `then`, in words; empty if it does not.
std::string find_difference(const StudyIdentity& then,
                            const StudyIdentity& now);

struct StudyFile
{
  study::StudyDescription content;
  /// All parameters with their documentation as a .prm.
  std::string effective_parameters;
  StudyIdentity identity;
  /// The study and its case as they were written.
  CaseText text, case_text;
  std::vector<study::StudyCase> cases;
};

/// Reads and checks a study and its case file; `overrides` are texts
/// `Section/Key = value` about keys of the study. The keys of all cases are
/// checked, their values are not. A variable without a unit gets that of its
/// key. Errors: BadInput with file, line and key, what is allowed and the
/// nearest name; the study's line for a key that its case cannot have.
StudyFile read_study_file(const std::string& file,
                          const std::vector<std::string>& overrides = {});

/// The part of it that makes the cases.
void set_cases(StudyFile& study);

/// `Section/Key = value` of all keys of the case, as for read_case_file.
std::vector<std::string> get_overrides(const study::StudyCase& study_case);
} // namespace taut::io
