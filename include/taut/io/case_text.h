#pragma once

#include <string>
#include <vector>

namespace taut::io
{
/// Sections from the outermost inwards: {"Material vhb", "Spring ground"}.
using SectionPath = std::vector<std::string>;

/// "Material vhb/Spring ground"; with a key, "Material vhb/Spring ground/Law".
std::string join(const SectionPath& section, const std::string& key = "");

/// `key = value` as the user wrote it and where.
struct Entry
{
  SectionPath section;
  std::string key;
  std::string value;
  /// The case file, or the option that overrides it.
  std::string origin;
  /// 0 for an option.
  unsigned int line = 0;
};

struct SectionStart
{
  SectionPath section;
  unsigned int line = 0;
};

/// A case file taken apart into entries that still know their lines. What keys
/// and values mean is not known here.
class CaseText
{
public:
  /// Reads a .prm or, by its ending, a .json file. Errors: BadInput with file,
  /// line and key for text that is no entry, a missing or superfluous `end`, a
  /// key or section given twice, `include`, an unreadable file.
  static CaseText read(const std::string& file);
  /// The same from text in memory; `file` serves messages and chooses the form.
  static CaseText parse(const std::string& text, const std::string& file);

  /// Adds or replaces an entry as `Section/Key = value` says, the text of a
  /// `--set`. Errors: BadInput that names the option if it is not of this form
  /// or the key is overridden twice.
  void override_entry(const std::string& option);

  /// Errors: BadInput if the section is open already.
  void open_section(const SectionPath& section, unsigned int line);
  /// Errors: BadInput if the key was given before.
  void add(const Entry& entry);

  /// nullptr if the file does not give it.
  const Entry* find(const SectionPath& section, const std::string& key) const;
  const SectionStart* find(const SectionPath& section) const;
  /// The line of the section, 0 if the file lacks it.
  unsigned int line_of(const SectionPath& section) const;
  /// Names x of the subsections `kind x` inside `parent`, in their order.
  std::vector<std::string> names_of(const SectionPath& parent,
                                    const std::string& kind) const;

  /// Throws BadInput at the line of the key, or of its section if the key is
  /// not given.
  [[noreturn]] void refuse(const SectionPath& section, const std::string& key,
                           const std::string& message) const;

  const std::string& file() const
  {
    return file_;
  }
  const std::vector<Entry>& entries() const
  {
    return entries_;
  }
  const std::vector<SectionStart>& sections() const
  {
    return sections_;
  }

private:
  std::string file_;
  std::vector<Entry> entries_;
  std::vector<SectionStart> sections_;
};

/// Fills `text` from the lines of a .prm; see CaseText::read for the errors.
void scan_prm(const std::string& content, CaseText& text);
/// Fills `text` from deal.II's short .json form: objects are sections, all
/// other members entries; arrays become comma-separated lists.
void scan_json(const std::string& content, CaseText& text);

/// Without white space around it, and with single blanks inside.
std::string tidy(const std::string& text);
} // namespace taut::io
