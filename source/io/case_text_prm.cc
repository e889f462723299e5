#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>
#include <taut/io/case_text.h>

#include <fmt/format.h>

#include <sstream>

#include <boost/algorithm/string.hpp>

namespace taut::io
{
namespace
{
/// The grammar of a .prm, line by line.
class PrmScanner
{
public:
  explicit PrmScanner(CaseText& text) : text_(text) {}

  void scan(const std::string& content);

private:
  void scan_statement(const std::string& statement);
  void scan_set(const std::string& rest);
  void close_section(const std::string& rest);
  [[noreturn]] void refuse(const std::string& message,
                           const std::string& key = "") const
  {
    throw BadInput(message, text_.file(), line_, key);
  }

  CaseText& text_;
  SectionPath open_;
  /// Of the statement's first line.
  unsigned int line_ = 0;
};

void PrmScanner::scan(const std::string& content)
{
  std::istringstream stream(content);
  std::string statement, line;
  unsigned int n_lines = 0;
  while (std::getline(stream, line))
  {
    ++n_lines;
    if (statement.empty())
      line_ = n_lines;
    statement += boost::trim_copy(line.substr(0, line.find('#')));
    if (boost::ends_with(statement, "\\"))
    {
      statement.back() = ' ';
      continue;
    }
    if (!statement.empty())
      scan_statement(tidy(statement));
    statement.clear();
  }
  if (!statement.empty())
    refuse("the last line ends in '\\' but nothing follows");
  if (!open_.empty())
  {
    line_ = text_.line_of(open_);
    refuse("the section is not closed: an 'end' is missing", join(open_));
  }
}

void PrmScanner::scan_statement(const std::string& statement)
{
  const std::string word = statement.substr(0, statement.find(' '));
  const std::string rest = tidy(statement.substr(word.size()));
  if (word == "set")
    scan_set(rest);
  else if (word == "subsection")
  {
    open_.push_back(rest);
    text_.open_section(open_, line_);
  }
  else if (word == "end")
    close_section(rest);
  else if (word == "include")
    refuse("'include' is not supported: a case is one file, so that the line "
           "of every message is its own");
  else
    refuse(fmt::format("'{}' is no statement; {}", statement,
                       suggest(word, {"set", "subsection", "end"})));
}

void PrmScanner::scan_set(const std::string& rest)
{
  const std::size_t equals = rest.find('=');
  if (equals == std::string::npos)
    refuse("'=' is missing: a parameter is given as 'set Key = value'",
           join(open_, rest));
  text_.add({open_, tidy(rest.substr(0, equals)), tidy(rest.substr(equals + 1)),
             text_.file(), line_});
}

void PrmScanner::close_section(const std::string& rest)
{
  if (!rest.empty())
    refuse(fmt::format("'end' stands alone, but '{}' follows", rest),
           join(open_));
  if (open_.empty())
    refuse("'end' closes no section: there is one 'end' too many");
  open_.pop_back();
}
} // namespace

void scan_prm(const std::string& content, CaseText& text)
{
  PrmScanner(text).scan(content);
}
} // namespace taut::io
