#pragma once

#include <taut/io/case_text.h>
#include <taut/study/case.h>

#include <iosfwd>
#include <string>
#include <vector>

/// Case files: .prm, or .json in deal.II's short form.
namespace taut::io
{
/// A parameter whose value is not the default.
struct ChangedParameter
{
  /// "Procedure/Integrator/First step"
  std::string path;
  /// Empty if the parameter has none.
  std::string default_value;
  std::string value;
};

/// What a case file says.
struct CaseFile
{
  study::Case content;
  /// All parameters with their documentation as a .prm; reads back as the same
  /// case from any folder.
  std::string effective_parameters;
  std::vector<ChangedParameter> changed_parameters;
};

/// Reads and checks a case; `overrides` are texts `Section/Key = value`. The
/// mesh is not opened: `content.device.mesh.file` is its absolute path.
/// Errors: BadInput, with file, line and key, or the override that is wrong,
/// what is allowed and the nearest name.
CaseFile read_case_file(const std::string& file,
                        const std::vector<std::string>& overrides = {});

/// The same of a file that was taken apart before; the effective parameters are
/// left empty unless they are wanted.
CaseFile make_case_file(const CaseText& original,
                        const std::vector<std::string>& overrides,
                        bool with_effective_parameters);

/// The content alone. Errors as read_case_file.
study::Case read_case(const std::string& file,
                      const std::vector<std::string>& overrides = {});

/// Writes the sections of case and study files with every key, its default,
/// meaning, range and unit: all of them, or those called `section` ("Film",
/// "Integrator") and the sections inside them. Errors: BadInput with the
/// nearest name if there is none.
void describe(std::ostream& stream, const std::string& section = "");

/// All of them as a page in Markdown: docs/parameters.md.
void describe_as_page(std::ostream& stream);
} // namespace taut::io
