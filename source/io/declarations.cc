#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>
#include <taut/io/declarations.h>

#include <deal.II/base/parameter_handler.h>

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <ostream>
#include <sstream>

#include <boost/algorithm/string.hpp>

namespace taut::io
{
namespace
{
/// Lets ParameterHandler accept what a format accepts; a required key starts
/// out empty.
class FormatPattern : public dealii::Patterns::PatternBase
{
public:
  FormatPattern(const std::function<void(const std::string&)>& check,
                const bool may_be_empty)
      : check_(check), may_be_empty_(may_be_empty)
  {
  }
  bool match(const std::string& text) const override
  {
    if (text.empty() && may_be_empty_)
      return true;
    try
    {
      check_(text);
      return true;
    }
    catch (const BadInput&)
    {
      return false;
    }
  }
  std::string description(const OutputStyle) const override
  {
    return "";
  }
  std::unique_ptr<PatternBase> clone() const override
  {
    return std::make_unique<FormatPattern>(*this);
  }

private:
  std::function<void(const std::string&)> check_;
  bool may_be_empty_;
};

/// Stands in a subsection of the handler while it lives.
class Inside
{
public:
  Inside(dealii::ParameterHandler& handler, const SectionPath& section)
      : handler_(handler), depth_(section.size())
  {
    for (const std::string& name : section)
      handler_.enter_subsection(name);
  }
  ~Inside()
  {
    for (std::size_t i = 0; i < depth_; ++i)
      handler_.leave_subsection();
  }
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;

private:
  dealii::ParameterHandler& handler_;
  std::size_t depth_;
};
/// "Film active" for "Flim active" and the kind Film: as many words as the kind
/// has are replaced.
std::string exchange_kind(const std::string& name, const std::string& kind)
{
  std::size_t blank = name.find(' ');
  for (auto n = std::count(kind.begin(), kind.end(), ' ');
       n > 0 && blank != std::string::npos; --n)
    blank = name.find(' ', blank + 1);
  return kind + (blank == std::string::npos ? "" : name.substr(blank));
}
} // namespace

std::string document(const std::string& meaning, const std::string& allowed,
                     const std::string& unit)
{
  std::string text = meaning + "; " + allowed;
  if (!unit.empty())
    text += " (" + unit + ")";
  return text;
}

Section Declarations::section(const SectionPath& path,
                              const std::string& meaning)
{
  sections_.push_back({path, meaning});
  return Section(*this, path);
}

void Declarations::declare(const Parameter& parameter,
                           const std::function<void(const std::string&)>& take)
{
  indices_[join(parameter.section, parameter.key)] = parameters_.size();
  parameters_.push_back(parameter);
  texts_.push_back(parameter.default_text);
  takers_.push_back(take);
}

void Declarations::allow_section(const SectionPath& parent,
                                 const std::string& kind, const bool named)
{
  kinds_.push_back({parent, kind, named});
}

void Declarations::assign(const CaseText& text)
{
  check_sections(text);
  for (const Entry& entry : text.entries())
  {
    require_known(entry);
    const Parameter* parameter = find(entry.section, entry.key);
    try
    {
      parameter->check(entry.value);
    }
    catch (const BadInput& problem)
    {
      throw BadInput(problem.message(), entry.origin, entry.line,
                     join(entry.section, entry.key));
    }
    set_text(entry.section, entry.key, entry.value);
  }
  check_required(text);
}

void Declarations::require_known(const Entry& entry) const
{
  if (!knows(entry.section))
    refuse_section(entry);
  if (!find(entry.section, entry.key))
    refuse_key(entry);
}

void Declarations::set_text(const SectionPath& section, const std::string& key,
                            const std::string& value)
{
  const std::size_t index = get_index(section, key);
  texts_[index] = value;
  if (!value.empty())
    takers_[index](value);
}

std::string Declarations::get_text(const Parameter& parameter) const
{
  return texts_[get_index(parameter.section, parameter.key)];
}

std::size_t Declarations::get_index(const SectionPath& section,
                                    const std::string& key) const
{
  return indices_.at(join(section, key));
}

void Declarations::write(std::ostream& stream) const
{
  dealii::ParameterHandler handler;
  for (std::size_t i = 0; i < parameters_.size(); ++i)
  {
    const Parameter& parameter = parameters_[i];
    const Inside inside(handler, parameter.section);
    handler.declare_entry(parameter.key, parameter.default_text,
                          FormatPattern(parameter.check, parameter.required),
                          parameter.documentation);
    handler.set(parameter.key, texts_[i]);
  }
  std::stringstream printed;
  handler.print_parameters(printed,
                           static_cast<dealii::ParameterHandler::OutputStyle>(
                               dealii::ParameterHandler::PRM |
                               dealii::ParameterHandler::KeepDeclarationOrder));
  // A required key has no default to be told.
  const std::string no_default = "# default: ";
  for (std::string line; std::getline(printed, line);)
  {
    if (boost::ends_with(line, no_default))
      line.erase(line.size() - no_default.size());
    stream << boost::trim_right_copy(line) << '\n';
  }
}

const Parameter* Declarations::find(const SectionPath& section,
                                    const std::string& key) const
{
  const auto index = indices_.find(join(section, key));
  // A key with a '/' in it is none of a section.
  return index == indices_.end() || parameters_[index->second].key != key
             ? nullptr
             : &parameters_[index->second];
}

bool Declarations::knows(const SectionPath& section) const
{
  return std::any_of(sections_.begin(), sections_.end(),
                     [&section](const SectionDocumentation& known)
                     { return known.section == section; });
}

void Declarations::check_sections(const CaseText& text) const
{
  for (const SectionStart& start : text.sections())
    if (!knows(start.section))
      refuse_section({start.section, "", "", text.file(), start.line});
}

/// What a section called `name` might have been meant to be: the declared ones,
/// and the kinds with the user's own name behind them.
std::string Declarations::suggest_section(const std::string& name,
                                          const SectionPath& parent) const
{
  std::vector<std::string> allowed, candidates;
  for (const Kind& kind : kinds_)
  {
    if (kind.parent != parent)
      continue;
    allowed.push_back(kind.name + (kind.named ? " NAME" : ""));
    const std::string candidate =
        kind.named ? exchange_kind(name, kind.name) : kind.name;
    if (candidate != name)
      candidates.push_back(candidate);
  }
  for (const SectionDocumentation& known : sections_)
    if (known.section.size() == parent.size() + 1 &&
        std::equal(parent.begin(), parent.end(), known.section.begin()))
      candidates.push_back(known.section.back());
  const std::string nearest = nearest_name(name, candidates);
  return "allowed here are: " + boost::algorithm::join(allowed, ", ") +
         (nearest.empty() ? "" : "; did you mean '" + nearest + "'?");
}

void Declarations::refuse_section(const Entry& position) const
{
  SectionPath parent;
  std::string name;
  for (const std::string& level : position.section)
  {
    name = level;
    SectionPath path = parent;
    path.push_back(level);
    if (!knows(path))
      break;
    parent = path;
  }
  throw BadInput(fmt::format("unknown section '{}'; {}", name,
                             suggest_section(name, parent)),
                 position.origin, position.line,
                 join(position.section, position.key));
}

void Declarations::check_required(const CaseText& text) const
{
  for (const Parameter& parameter : parameters_)
    if (parameter.required && !text.find(parameter.section, parameter.key))
      text.refuse(parameter.section, parameter.key,
                  "the key is missing and has no default; it is: " +
                      parameter.documentation);
}

void Declarations::refuse_key(const Entry& entry) const
{
  std::vector<std::string> known;
  for (const Parameter& parameter : parameters_)
    if (parameter.section == entry.section)
      known.push_back(parameter.key);
  throw BadInput("unknown key; " + suggest(entry.key, known), entry.origin,
                 entry.line, join(entry.section, entry.key));
}
} // namespace taut::io
