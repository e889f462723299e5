#pragma once

#include <taut/io/study_file.h>

#include <string>

#include "worker_pool.h"

namespace taut::app
{
struct StudyOptions
{
  std::string folder;
  /// Removes an old study from the folder first.
  bool overwrite = false;
  /// Computes cases again that failed or were refused in an older call.
  bool retry_failed = false;
};

/// Computes the cases of a study that are still missing in its folder, and
/// writes what came out. The result is the exit code: done, solver_failed if
/// some case has no result, interrupted. Errors: BadInput if the folder holds
/// something else, or for a result that the first finished case shows to be
/// impossible; what was computed up to there is kept.
int run_study(const io::StudyFile& study, const StudyOptions& options,
              WorkerPool& pool);
} // namespace taut::app
