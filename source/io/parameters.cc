#include <taut/base/exceptions.h>
#include <taut/io/case_checks.h>
#include <taut/io/parameters.h>

#include <filesystem>
#include <sstream>

namespace taut::io
{
namespace
{
std::vector<ChangedParameter> find_changed(const Declarations& all)
{
  std::vector<ChangedParameter> changed;
  for (const Parameter& parameter : all.parameters())
  {
    const std::string value = all.get_text(parameter);
    if (parameter.required)
      changed.push_back({join(parameter.section, parameter.key), "", value});
    else if (value != parameter.default_text &&
             parameter.normalise(value) != parameter.default_text)
      changed.push_back({join(parameter.section, parameter.key),
                         parameter.default_text, value});
  }
  return changed;
}

/// Paths count from the case file; the effective parameters move elsewhere.
void make_mesh_absolute(Declarations& all, const CaseText& text,
                        structure::MeshDescription& mesh)
{
  namespace fs = std::filesystem;
  const std::string extension = fs::path(mesh.file).extension();
  if (extension != ".geo" && extension != ".msh")
    text.refuse({"Mesh"}, "File", "the mesh must be a .geo or a .msh file");
  const fs::path folder = fs::absolute(text.file()).parent_path();
  mesh.file = (folder / mesh.file).lexically_normal();
  mesh.source_line = text.find({"Mesh"}, "File")->line;
  all.set_text({"Mesh"}, "File", mesh.file);
}
} // namespace

CaseFile make_case_file(const CaseText& original,
                        const std::vector<std::string>& overrides,
                        const bool with_effective_parameters)
{
  if (original.find({}, "Case"))
    original.refuse({}, "Case",
                    "this is a study of a case: `taut study` runs "
                    "it");
  CaseText text = original;
  for (const std::string& option : overrides)
    text.override_entry(option);
  Declarations all;
  CaseDraft draft;
  declare_case(all, text, draft);
  all.assign(text);
  resolve_names(text, draft);
  check_case(text, draft);
  CaseFile result;
  result.changed_parameters = find_changed(all);
  draft.content.file = text.file();
  if (draft.content.model == "film")
    make_mesh_absolute(all, text, draft.content.device.mesh);
  if (with_effective_parameters)
  {
    std::ostringstream effective;
    all.write(effective);
    result.effective_parameters = effective.str();
  }
  result.content = draft.content;
  return result;
}

CaseFile read_case_file(const std::string& file,
                        const std::vector<std::string>& overrides)
{
  return make_case_file(CaseText::read(file), overrides, true);
}

study::Case read_case(const std::string& file,
                      const std::vector<std::string>& overrides)
{
  return read_case_file(file, overrides).content;
}
} // namespace taut::io
