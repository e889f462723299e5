#pragma once

#include <memory>
#include <string>
#include <vector>

namespace taut
{
/// A muParser expression in named variables and pi, compiled once and evaluated
/// often. Not for several threads at a time.
class Formula
{
public:
  /// Errors: BadInput if the text is no expression or names something else than
  /// `variables` (with the nearest of them).
  Formula(const std::string& text, const std::vector<std::string>& variables);
  ~Formula();
  Formula(Formula&& other) noexcept;
  Formula& operator=(Formula&& other) noexcept;

  /// The value for one value per variable. Errors: BadInput if it is not
  /// finite.
  double operator()(const std::vector<double>& values) const;

private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

/// Whether a variable of an expression may be called so: letters, digits and
/// underscores, no digit first, and no function or constant of muParser.
bool is_variable_name(const std::string& name);
} // namespace taut
