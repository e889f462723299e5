#pragma once

#include <taut/io/study_file.h>
#include <taut/io/study_folder.h>
#include <taut/io/study_messages.h>

#include <string>

/// The journal of a study: one line of JSON for each case that has ended, in
/// the order of their ends. The last line about a case counts.
namespace taut::io
{
class StudyJournal
{
public:
  /// Opens the journal of the study in `folder` for this process alone, reads
  /// what it holds and makes it ready for more; a line that a killed process
  /// left unfinished is dropped. Outcomes whose results are not those that
  /// `study` asks for now come without any.
  /// Errors: BadInput if it is the journal of another study (with the
  /// difference) or another process writes it, std::runtime_error if it cannot
  /// be written.
  StudyJournal(const StudyFolder& folder, const StudyFile& study);
  ~StudyJournal();
  StudyJournal(const StudyJournal&) = delete;
  StudyJournal& operator=(const StudyJournal&) = delete;

  /// What older calls of the same study have left.
  const CaseOutcomes& outcomes() const
  {
    return outcomes_;
  }

  /// On its way to the disk when it returns. Errors: std::runtime_error.
  void add(const CaseOutcome& outcome);

private:
  void read(const StudyFile& study);
  void append(const std::string& line);

  std::string file_;
  int descriptor_ = -1;
  CaseOutcomes outcomes_;
};
} // namespace taut::io
