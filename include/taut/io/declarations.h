#pragma once

#include <taut/io/case_text.h>
#include <taut/io/formats.h>

#include <functional>
#include <iosfwd>
#include <string>
#include <unordered_map>
#include <vector>

namespace taut::io
{
/// What is known about one key of a case file.
struct Parameter
{
  SectionPath section;
  std::string key;
  /// Empty if the case must give the key.
  std::string default_text;
  bool required = false;
  /// Meaning, what is allowed and, in parentheses at the end, the unit.
  std::string documentation;
  /// "m", "dimensionless"; empty if the value is no number.
  std::string unit;
  /// Throws BadInput if the text is not allowed.
  std::function<void(const std::string&)> check;
  /// The same value in its standard spelling.
  std::function<std::string(const std::string&)> normalise;
};

struct SectionDocumentation
{
  SectionPath section;
  std::string meaning;
};

class Section;

/// All sections and keys of a case, bound to the variables that receive the
/// values. dealii::ParameterHandler prints them; this class adds what it lacks:
/// lines, units and names in every refusal, and speed, for studies of many
/// cases.
class Declarations
{
public:
  /// Opens a section for declaration; the empty path is the top level.
  Section section(const SectionPath& path, const std::string& meaning);

  /// Says that `parent` may hold subsections `kind`, or `kind NAME`.
  void allow_section(const SectionPath& parent, const std::string& kind,
                     bool named);

  /// Hands the values of `text` to the bound variables. Errors: BadInput with
  /// file, line and key for unknown sections and keys (with what is known and
  /// the nearest name), values that are not allowed, and missing ones.
  void assign(const CaseText& text);

  /// Errors: BadInput with the position of `entry` and the nearest name if its
  /// section or key is not declared.
  void require_known(const Entry& entry) const;

  /// The parameters as a .prm with their documentation; reads back as the same
  /// case.
  void write(std::ostream& stream) const;
  /// Replaces the text of one value in what `write` gives.
  void set_text(const SectionPath& section, const std::string& key,
                const std::string& value);
  std::string get_text(const Parameter& parameter) const;

  const std::vector<Parameter>& parameters() const
  {
    return parameters_;
  }
  const std::vector<SectionDocumentation>& sections() const
  {
    return sections_;
  }

private:
  friend class Section;
  struct Kind
  {
    SectionPath parent;
    std::string name;
    bool named;
  };
  const Parameter* find(const SectionPath& section,
                        const std::string& key) const;
  bool knows(const SectionPath& section) const;
  std::string suggest_section(const std::string& name,
                              const SectionPath& parent) const;
  void check_sections(const CaseText& text) const;
  void check_required(const CaseText& text) const;
  [[noreturn]] void refuse_section(const Entry& position) const;
  [[noreturn]] void refuse_key(const Entry& entry) const;
  void declare(const Parameter& parameter,
               const std::function<void(const std::string&)>& take);
  std::size_t get_index(const SectionPath& section,
                        const std::string& key) const;

  std::vector<Parameter> parameters_;
  /// Of each parameter: its present text, and what hands it to its variable.
  std::vector<std::string> texts_;
  std::vector<std::function<void(const std::string&)>> takers_;
  std::unordered_map<std::string, std::size_t> indices_;
  std::vector<SectionDocumentation> sections_;
  std::vector<Kind> kinds_;
};

/// Declares the keys of one section, one statement each.
class Section
{
public:
  /// A key with the present value of `target` as default.
  template <class T>
  Section& optional(const std::string& key, T& target, const Format<T>& format,
                    const std::string& meaning)
  {
    return add(key, target, format, meaning, format.write(target), false);
  }

  /// A key that the case must give.
  template <class T>
  Section& required(const std::string& key, T& target, const Format<T>& format,
                    const std::string& meaning)
  {
    return add(key, target, format, meaning, "", true);
  }

  const SectionPath& path() const
  {
    return path_;
  }

private:
  friend class Declarations;
  Section(Declarations& all, const SectionPath& path) : all_(all), path_(path)
  {
  }

  template <class T>
  Section& add(const std::string& key, T& target, const Format<T>& format,
               const std::string& meaning, const std::string& default_text,
               bool required);

  Declarations& all_;
  SectionPath path_;
};

/// Declares one section `kind NAME` for every such section of the text:
/// resizes `list`, fills in names and lines, and calls
/// declare_one(Section&, item). The list must not be resized afterwards.
template <class Item, class DeclareOne>
void declare_list(Declarations& all, const CaseText& text,
                  const SectionPath& parent, const std::string& kind,
                  const std::string& meaning, std::vector<Item>& list,
                  const DeclareOne& declare_one)
{
  all.allow_section(parent, kind, true);
  const std::vector<std::string> names = text.names_of(parent, kind);
  list.resize(names.size());
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    SectionPath path = parent;
    path.push_back(kind + " " + names[i]);
    list[i].name = names[i];
    list[i].source_line = text.line_of(path);
    Section section = all.section(path, meaning);
    declare_one(section, list[i]);
  }
}

/// "meaning; allowed (unit)".
std::string document(const std::string& meaning, const std::string& allowed,
                     const std::string& unit);

template <class T>
Section& Section::add(const std::string& key, T& target,
                      const Format<T>& format, const std::string& meaning,
                      const std::string& default_text, const bool required)
{
  Parameter parameter;
  parameter.section = path_;
  parameter.key = key;
  parameter.default_text = default_text;
  parameter.required = required;
  parameter.unit = format.unit;
  parameter.documentation = document(meaning, format.allowed, format.unit);
  parameter.check = [format](const std::string& text) { format.read(text); };
  parameter.normalise = [format](const std::string& text)
  { return format.write(format.read(text)); };
  all_.declare(parameter, [format, &target](const std::string& text)
               { target = format.read(text); });
  return *this;
}
} // namespace taut::io
