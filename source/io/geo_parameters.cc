#include <taut/base/exceptions.h>
#include <taut/io/geo_parameters.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

namespace taut::io
{
namespace
{
std::string read_text(const std::filesystem::path& file)
{
  std::ifstream stream(file);
  if (!stream)
    throw BadInput("the file cannot be read", file.string(), 0, "");
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The end of the comment or string that begins at `begin`; `begin` itself if
/// none does.
std::size_t skip_comment_or_string(const std::string& text,
                                   const std::size_t begin)
{
  const auto end_after = [&](const char* mark, const std::size_t offset)
  {
    const std::size_t found = text.find(mark, begin + offset);
    return found == std::string::npos ? text.size()
                                      : found + std::string(mark).size();
  };
  if (text.compare(begin, 2, "//") == 0)
    return end_after("\n", 2);
  if (text.compare(begin, 2, "/*") == 0)
    return end_after("*/", 2);
  if (text[begin] == '"')
    return end_after("\"", 1);
  return begin;
}

bool is_name_character(const char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/// Cuts the text into names, numbers, strings (with their quotation marks) and
/// single other characters; comments and blanks fall away.
std::vector<std::string> split_into_tokens(const std::string& text)
{
  std::vector<std::string> tokens;
  for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end)
  {
    end = skip_comment_or_string(text, begin);
    const bool is_comment = end > begin && text[begin] == '/';
    const bool is_blank = std::isspace(static_cast<unsigned char>(text[begin]));
    while (end < text.size() && is_name_character(text[end]) &&
           is_name_character(text[begin]))
      ++end;
    if (end == begin)
      ++end;
    if (!is_comment && !is_blank)
      tokens.push_back(text.substr(begin, end - begin));
  }
  return tokens;
}

/// Appends the names defined in the brackets that open at `token`.
void collect_names(const std::vector<std::string>& tokens, std::size_t token,
                   std::vector<std::string>& names)
{
  int depth = 0;
  for (; token + 1 < tokens.size(); ++token)
  {
    const std::string& text = tokens[token];
    depth += text == "[" || text == "{" || text == "(";
    depth -= text == "]" || text == "}" || text == ")";
    if (depth == 0)
      return;
    const bool starts_entry = text == "," || text == "[";
    const std::string& next = tokens[token + 1];
    if (depth == 1 && starts_entry && is_name_character(next[0]))
      names.push_back(next);
  }
}

void collect_names_of_file(const std::filesystem::path& file,
                           std::set<std::filesystem::path>& visited,
                           std::vector<std::string>& names)
{
  if (!visited.insert(file.lexically_normal()).second)
    return;
  const std::vector<std::string> tokens = split_into_tokens(read_text(file));
  for (std::size_t token = 0; token + 1 < tokens.size(); ++token)
  {
    const std::string& next = tokens[token + 1];
    if (tokens[token] == "DefineConstant")
      collect_names(tokens, token + 1, names);
    else if (tokens[token] == "Include" && next.size() > 2)
      collect_names_of_file(
          file.parent_path() / next.substr(1, next.size() - 2), visited, names);
  }
}
} // namespace

std::vector<std::string> get_geo_parameter_names(const std::string& file)
{
  std::set<std::filesystem::path> visited;
  std::vector<std::string> names;
  collect_names_of_file(file, visited, names);
  return names;
}
} // namespace taut::io
