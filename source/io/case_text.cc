#include <taut/base/exceptions.h>
#include <taut/io/case_text.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <boost/algorithm/string.hpp>
#include <boost/algorithm/string/trim_all.hpp>

namespace taut::io
{
std::string join(const SectionPath& section, const std::string& key)
{
  std::string path = boost::algorithm::join(section, "/");
  if (key.empty())
    return path;
  return path.empty() ? key : path + "/" + key;
}

std::string tidy(const std::string& text)
{
  return boost::trim_all_copy(text);
}

CaseText CaseText::read(const std::string& file)
{
  std::ifstream stream(file);
  if (!stream || std::filesystem::is_directory(file))
    throw BadInput("the case file cannot be read", file, 0, "");
  std::ostringstream content;
  content << stream.rdbuf();
  return parse(content.str(), file);
}

CaseText CaseText::parse(const std::string& content, const std::string& file)
{
  CaseText text;
  text.file_ = file;
  if (std::filesystem::path(file).extension() == ".json")
    scan_json(content, text);
  else
    scan_prm(content, text);
  if (text.entries_.empty())
    throw BadInput("the case file holds no parameters", file, 0, "");
  return text;
}

void CaseText::open_section(const SectionPath& section, unsigned int line)
{
  if (section.back().empty())
    throw BadInput("a subsection needs a name", file_, line, join(section));
  if (section.back().find('/') != std::string::npos)
    throw BadInput("a name must not contain '/', which separates sections",
                   file_, line, join(section));
  if (const SectionStart* first = find(section))
    throw BadInput(fmt::format("the section is given twice, first in line {}",
                               first->line),
                   file_, line, join(section));
  sections_.push_back({section, line});
}

void CaseText::add(const Entry& entry)
{
  const std::string path = join(entry.section, entry.key);
  if (entry.key.empty())
    throw BadInput("a key is missing before '='", entry.origin, entry.line,
                   path);
  if (entry.value.find_first_of("#\n") != std::string::npos)
    throw BadInput("a value must stand in one line and not contain '#', which "
                   "starts a comment",
                   entry.origin, entry.line, path);
  if (const Entry* first = find(entry.section, entry.key))
    throw BadInput(
        fmt::format("the key is given twice, first in line {}", first->line),
        entry.origin, entry.line, path);
  entries_.push_back(entry);
}

void CaseText::override_entry(const std::string& option)
{
  const std::string origin = "--set '" + option + "'";
  const std::size_t equals = option.find('=');
  if (equals == std::string::npos)
    throw BadInput("an override has the form 'Section/Key = value'", origin, 0,
                   "");
  SectionPath path;
  const std::string left = option.substr(0, equals);
  boost::split(path, left, [](char c) { return c == '/'; });
  std::transform(path.begin(), path.end(), path.begin(), tidy);
  Entry entry;
  entry.key = path.back();
  path.pop_back();
  entry.section = path;
  entry.value = tidy(option.substr(equals + 1));
  entry.origin = origin;
  const auto same = [&entry](const Entry& other)
  { return other.section == entry.section && other.key == entry.key; };
  const auto given = std::find_if(entries_.begin(), entries_.end(), same);
  if (given != entries_.end() && given->line == 0)
    throw BadInput("the key is overridden twice", origin, 0,
                   join(entry.section, entry.key));
  if (given != entries_.end())
    entries_.erase(given);
  add(entry);
}

const Entry* CaseText::find(const SectionPath& section,
                            const std::string& key) const
{
  for (const Entry& entry : entries_)
    if (entry.section == section && entry.key == key)
      return &entry;
  return nullptr;
}

const SectionStart* CaseText::find(const SectionPath& section) const
{
  for (const SectionStart& start : sections_)
    if (start.section == section)
      return &start;
  return nullptr;
}

unsigned int CaseText::line_of(const SectionPath& section) const
{
  const SectionStart* start = find(section);
  return start ? start->line : 0;
}

std::vector<std::string> CaseText::names_of(const SectionPath& parent,
                                            const std::string& kind) const
{
  std::vector<std::string> names;
  for (const SectionStart& start : sections_)
  {
    const std::string& last = start.section.back();
    const SectionPath outer(start.section.begin(), start.section.end() - 1);
    if (outer == parent && boost::starts_with(last, kind + " "))
      names.push_back(last.substr(kind.size() + 1));
  }
  return names;
}

void CaseText::refuse(const SectionPath& section, const std::string& key,
                      const std::string& message) const
{
  const std::string path = join(section, key);
  if (const Entry* entry = find(section, key))
    throw BadInput(message, entry->origin, entry->line, path);
  throw BadInput(message, file_, line_of(section), path);
}
} // namespace taut::io
