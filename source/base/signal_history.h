#pragma once

#include <taut/base/signal.h>

#include <memory>
#include <string>
#include <vector>

namespace taut
{
/// What the kinds of signals have in common.
class Signal::History
{
public:
  virtual ~History() = default;
  virtual double value(double time) const = 0;
  virtual double value_before(double time) const
  {
    return value(time);
  }
  virtual double rate(double time) const = 0;
  virtual double second_rate(double time) const = 0;
  /// All kinks, increasing.
  virtual std::vector<double> kinks() const
  {
    return {};
  }
  virtual bool is_constant() const
  {
    return false;
  }
  virtual std::string to_text() const = 0;
};

/// Errors: BadInput if the formula cannot be parsed.
std::shared_ptr<const Signal::History>
make_expression(std::string formula, std::vector<double> kinks);

/// Errors: BadInput that names `what` if the number is infinite or NaN.
void require_finite(double number, const std::string& what);
} // namespace taut
