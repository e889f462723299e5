#pragma once

#include <taut/base/formula.h>

#include <optional>
#include <string>
#include <vector>

namespace taut::study
{
/// The variables that texts with braces may name.
struct TemplateNames
{
  /// Any texts; {name} inserts them.
  std::vector<std::string> texts;
  /// Those whose values are numbers, for expressions.
  std::vector<std::string> numbers;
};

/// Their values in one case, in the order of the names.
struct TemplateValues
{
  std::vector<std::string> texts;
  std::vector<double> numbers;
};

/// A text in which {expression} and {name} are replaced by values.
class Template
{
public:
  /// Errors: BadInput for braces without partner and unknown names.
  Template(const std::string& text, const TemplateNames& names);
  /// Errors: BadInput for an expression that is not finite.
  std::string fill(const TemplateValues& values) const;

private:
  struct Piece
  {
    std::string literal;
    std::optional<std::size_t> variable; ///< of the texts
    std::optional<Formula> formula;
  };
  void add_brace(const std::string& content, const TemplateNames& names);

  std::vector<Piece> pieces_;
};
} // namespace taut::study
