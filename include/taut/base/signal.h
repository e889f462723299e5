#pragma once

#include <memory>
#include <string>
#include <vector>

namespace taut
{
/// A scalar history of time, such as the voltage of an electrode.
///
/// A signal is smooth except at its kinks, where the value or its slope jumps.
/// Time integration stops and starts anew at every kink. At a jump, `value` is
/// the value just after it (right-continuous), `value_before` the one before.
///
/// Text form (see `parse`), numbers in SI units, arguments named or in order:
///   5000                                       constant
///   ramp(rate = 300, start = 0, limit = inf)   rate (t - start), held at limit
///   sine(offset = 1e3, amplitude = 5e3, frequency = 10, phase = 0)
///                       offset + amplitude sin(2 pi frequency t + phase)
///   steps(0: 0, 1: 2000, 3: 0)                 constant from each time on
///   table(0: 0, 1: 5000, 2: 5000)              straight lines between points
///   expression(1e3*sin(20*t)^2; kinks = 0.5, 1)   muParser, t in s, pi known
class Signal
{
public:
  /// Zero at all times.
  Signal();
  static Signal constant(double value);
  /// `limit` bounds the magnitude reached (same sign as `rate`).
  static Signal ramp(double rate, double start, double limit);
  static Signal sine(double offset, double amplitude, double frequency,
                     double phase);
  /// Times must increase; before the first time the first value holds.
  /// Errors: BadInput if times do not increase strictly or lists are empty.
  static Signal steps(std::vector<double> times, std::vector<double> values);
  /// Linear between the points, constant outside. Errors as for `steps`.
  static Signal table(std::vector<double> times, std::vector<double> values);
  /// Errors: BadInput if the expression cannot be parsed.
  static Signal expression(const std::string& formula,
                           std::vector<double> kinks);

  /// Reads the text form above. Errors: BadInput that says what is wrong and
  /// what is allowed; file, line and key are left to the caller to add.
  static Signal parse(const std::string& text);

  double value(double time) const;
  double value_before(double time) const;
  /// First and second time derivative, from the right at a kink. Exact except
  /// for expressions, which are differentiated by central differences that do
  /// not reach across a kink.
  double rate(double time) const;
  double second_rate(double time) const;
  /// The kinks in (start, end), increasing.
  std::vector<double> kinks(double start, double end) const;
  bool is_constant() const;
  /// The text form, such that parse(to_text()) is the same signal.
  std::string to_text() const;

  class History;

private:
  explicit Signal(std::shared_ptr<const History> history);
  std::shared_ptr<const History> history_;
};
} // namespace taut
