#pragma once

#include <string>
#include <vector>

namespace taut::app
{
/// Calls a script of postprocess/, or one with an absolute path, with a Python
/// that has matplotlib: the one that the environment variable TAUT_PYTHON
/// names, or else python3 on the path or /usr/bin/python3. The result says what
/// went wrong and how to mend it; empty if nothing did.
std::string run_plot_script(const std::string& script,
                            const std::vector<std::string>& arguments);

/// Calls a script of postprocess/ in the same way; the result is its exit code,
/// which is one of ours. Errors: BadInput without a Python that has matplotlib;
/// std::runtime_error if it could not be started.
int run_script(const std::string& script,
               const std::vector<std::string>& arguments);
} // namespace taut::app
