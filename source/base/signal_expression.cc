#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>

#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

#include "signal_history.h"

namespace taut
{
namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr double infinity = std::numeric_limits<double>::infinity();

class Expression : public Signal::History
{
public:
  Expression(std::string formula, std::vector<double> kinks)
      : formula_(std::move(formula)), kinks_(std::move(kinks))
  {
    for (const double kink : kinks_)
      require_finite(kink, "a kink of an expression");
    std::sort(kinks_.begin(), kinks_.end());
    try
    {
      parser_.DefineConst("pi", pi);
      parser_.DefineVar("t", &time_);
      parser_.SetExpr(formula_);
      parser_.Eval();
    }
    catch (const mu::ParserError& error)
    {
      throw BadInput("cannot read the expression '" + formula_ +
                     "': " + error.GetMsg() +
                     " Allowed are t (s), pi, numbers, + - * / ^, comparisons,"
                     " a ? b : c and functions such as sin, exp, min");
    }
  }
  double value(const double time) const override
  {
    return evaluate(is_kink(time) ? std::nextafter(time, infinity) : time);
  }
  double value_before(const double time) const override
  {
    return evaluate(is_kink(time) ? std::nextafter(time, -infinity) : time);
  }
  double rate(const double time) const override
  {
    const auto [s, h, first, second, third, fourth] =
        compute_differences(time, 1e-5);
    return (first + s * second + (3 * s * s - 1) / 6 * third +
            s * (2 * s * s - 1) / 12 * fourth) /
           h;
  }
  double second_rate(const double time) const override
  {
    const auto [s, h, first, second, third, fourth] =
        compute_differences(time, 1e-4);
    (void)first;
    return (second + s * third + (6 * s * s - 1) / 12 * fourth) / (h * h);
  }
  std::vector<double> kinks() const override
  {
    return kinks_;
  }
  std::string to_text() const override
  {
    std::string text = "expression(" + formula_;
    for (std::size_t i = 0; i < kinks_.size(); ++i)
      text += (i == 0 ? "; kinks = " : ", ") + number_text(kinks_[i]);
    return text + ")";
  }

private:
  /// Central differences of five points at distance h; the point asked for lies
  /// s h to the right of their middle (Stirling's interpolation).
  struct Differences
  {
    double s, h, first, second, third, fourth;
  };

  bool is_kink(const double time) const
  {
    return std::binary_search(kinks_.begin(), kinks_.end(), time);
  }

  double evaluate(const double time) const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    time_ = time;
    const double result = parser_.Eval();
    if (!std::isfinite(result))
      throw BadInput("the expression '" + formula_ + "' is " +
                     number_text(result) + " at t = " + number_text(time));
    return result;
  }

  /// The five points are moved aside near a kink so that none lies beyond it.
  Differences compute_differences(const double time, double h) const
  {
    const auto next = std::upper_bound(kinks_.begin(), kinks_.end(), time);
    const double begin = next == kinks_.begin() ? -infinity : *(next - 1);
    const double end = next == kinks_.end() ? infinity : *next;
    h = std::min(std::max(h, 1e-7 * std::abs(time)), (end - begin) / 4);
    double middle = std::max(time, begin + 2 * h);
    middle = std::min(middle, end - 2 * h);
    const auto f = [&](const int i)
    {
      const double point = middle + i * h;
      return point >= end ? value_before(end) : value(std::max(point, begin));
    };
    const double a = f(-2), b = f(-1), c = f(0), d = f(1), e = f(2);
    return {(time - middle) / h,
            h,
            (d - b) / 2,
            b - 2 * c + d,
            (e - 2 * d + 2 * b - a) / 2,
            a - 4 * b + 6 * c - 4 * d + e};
  }

  std::string formula_;
  std::vector<double> kinks_;
  /// muParser reads the variable through a pointer, hence the lock.
  mutable std::mutex mutex_;
  mutable double time_ = 0;
  mu::Parser parser_;
};
} // namespace

std::shared_ptr<const Signal::History>
make_expression(std::string formula, std::vector<double> kinks)
{
  return std::make_shared<Expression>(std::move(formula), std::move(kinks));
}
} // namespace taut
