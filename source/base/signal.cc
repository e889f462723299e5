#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "signal_history.h"

namespace taut
{
void require_finite(const double number, const std::string& what)
{
  if (!std::isfinite(number))
    throw BadInput(what + " must be a finite number, not " +
                   number_text(number));
}

namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr double infinity = std::numeric_limits<double>::infinity();

class Constant : public Signal::History
{
public:
  explicit Constant(const double value) : value_(value)
  {
    require_finite(value, "the value of a constant signal");
  }
  double value(double) const override
  {
    return value_;
  }
  double rate(double) const override
  {
    return 0;
  }
  double second_rate(double) const override
  {
    return 0;
  }
  bool is_constant() const override
  {
    return true;
  }
  std::string to_text() const override
  {
    return number_text(value_);
  }

private:
  double value_;
};

class Ramp : public Signal::History
{
public:
  Ramp(const double rate, const double start, const double limit)
      : rate_(rate), start_(start), limit_(limit)
  {
    require_finite(rate, "the rate of a ramp");
    require_finite(start, "the start of a ramp");
    if (std::isfinite(limit))
    {
      if (rate * limit < 0)
        throw BadInput("the limit of a ramp (" + number_text(limit) +
                       ") must have the sign of its rate (" +
                       number_text(rate) + ")");
      if (rate != 0)
        end_ = start + limit / rate;
    }
  }
  double value(const double time) const override
  {
    if (time <= start_)
      return 0;
    return time < end_ ? rate_ * (time - start_) : limit_;
  }
  double rate(const double time) const override
  {
    return time >= start_ && time < end_ ? rate_ : 0;
  }
  double second_rate(double) const override
  {
    return 0;
  }
  std::vector<double> kinks() const override
  {
    if (is_constant())
      return {};
    return end_ < infinity ? std::vector<double>{start_, end_}
                           : std::vector<double>{start_};
  }
  bool is_constant() const override
  {
    return rate_ == 0 || limit_ == 0;
  }
  std::string to_text() const override
  {
    return "ramp(rate = " + number_text(rate_) +
           ", start = " + number_text(start_) +
           ", limit = " + number_text(limit_) + ")";
  }

private:
  double rate_;
  double start_;
  double limit_;
  /// The time at which the limit is reached.
  double end_ = infinity;
};

class Sine : public Signal::History
{
public:
  Sine(const double offset, const double amplitude, const double frequency,
       const double phase)
      : offset_(offset), amplitude_(amplitude), frequency_(frequency),
        phase_(phase), angular_(2 * pi * frequency)
  {
    require_finite(offset, "the offset of a sine");
    require_finite(amplitude, "the amplitude of a sine");
    require_finite(frequency, "the frequency of a sine");
    require_finite(phase, "the phase of a sine");
    if (frequency < 0)
      throw BadInput("the frequency of a sine must not be negative, got " +
                     number_text(frequency));
  }
  double value(const double time) const override
  {
    return offset_ + amplitude_ * std::sin(angular_ * time + phase_);
  }
  double rate(const double time) const override
  {
    return amplitude_ * angular_ * std::cos(angular_ * time + phase_);
  }
  double second_rate(const double time) const override
  {
    return -amplitude_ * angular_ * angular_ *
           std::sin(angular_ * time + phase_);
  }
  bool is_constant() const override
  {
    return amplitude_ == 0 || frequency_ == 0;
  }
  std::string to_text() const override
  {
    return "sine(offset = " + number_text(offset_) +
           ", amplitude = " + number_text(amplitude_) +
           ", frequency = " + number_text(frequency_) +
           ", phase = " + number_text(phase_) + ")";
  }

private:
  double offset_;
  double amplitude_;
  double frequency_;
  double phase_;
  double angular_;
};

/// Points (time, value) with increasing times.
class Points : public Signal::History
{
public:
  Points(std::vector<double> times, std::vector<double> values,
         std::string name)
      : times_(std::move(times)), values_(std::move(values)),
        name_(std::move(name))
  {
    if (times_.empty() || times_.size() != values_.size())
      throw BadInput("'" + name_ +
                     "' needs at least one point and one value per time, got " +
                     std::to_string(times_.size()) + " times and " +
                     std::to_string(values_.size()) + " values");
    for (std::size_t i = 0; i < times_.size(); ++i)
    {
      require_finite(times_[i], "a time of '" + name_ + "'");
      require_finite(values_[i], "a value of '" + name_ + "'");
      if (i > 0 && times_[i] <= times_[i - 1])
        throw BadInput("the times of '" + name_ + "' must increase, but " +
                       number_text(times_[i]) + " follows " +
                       number_text(times_[i - 1]));
    }
  }
  bool is_constant() const override
  {
    return std::adjacent_find(values_.begin(), values_.end(),
                              std::not_equal_to<>()) == values_.end();
  }
  std::string to_text() const override
  {
    std::string text = name_ + "(";
    for (std::size_t i = 0; i < times_.size(); ++i)
      text += (i == 0 ? "" : ", ") + number_text(times_[i]) + ": " +
              number_text(values_[i]);
    return text + ")";
  }

protected:
  /// How many points lie at or before `time`.
  std::size_t count_until(const double time) const
  {
    return std::upper_bound(times_.begin(), times_.end(), time) -
           times_.begin();
  }

  std::vector<double> times_;
  std::vector<double> values_;

private:
  std::string name_;
};

class Steps : public Points
{
public:
  Steps(std::vector<double> times, std::vector<double> values)
      : Points(std::move(times), std::move(values), "steps")
  {
  }
  double value(const double time) const override
  {
    const auto count = count_until(time);
    return values_[count == 0 ? 0 : count - 1];
  }
  double value_before(const double time) const override
  {
    const auto count =
        std::lower_bound(times_.begin(), times_.end(), time) - times_.begin();
    return values_[count == 0 ? 0 : count - 1];
  }
  double rate(double) const override
  {
    return 0;
  }
  double second_rate(double) const override
  {
    return 0;
  }
  std::vector<double> kinks() const override
  {
    std::vector<double> kinks;
    for (std::size_t i = 1; i < times_.size(); ++i)
      if (values_[i] != values_[i - 1])
        kinks.push_back(times_[i]);
    return kinks;
  }
};

class Table : public Points
{
public:
  Table(std::vector<double> times, std::vector<double> values)
      : Points(std::move(times), std::move(values), "table")
  {
  }
  double value(const double time) const override
  {
    const auto count = count_until(time);
    if (count == 0)
      return values_.front();
    return values_[count - 1] + slope(count) * (time - times_[count - 1]);
  }
  double rate(const double time) const override
  {
    return slope(count_until(time));
  }
  double second_rate(double) const override
  {
    return 0;
  }
  std::vector<double> kinks() const override
  {
    std::vector<double> kinks;
    for (std::size_t i = 0; i < times_.size(); ++i)
      if (slope(i) != slope(i + 1))
        kinks.push_back(times_[i]);
    return kinks;
  }

private:
  /// Of the line that ends at point `i`; zero outside the table.
  double slope(const std::size_t i) const
  {
    if (i == 0 || i == times_.size())
      return 0;
    return (values_[i] - values_[i - 1]) / (times_[i] - times_[i - 1]);
  }
};

} // namespace

Signal::Signal() : Signal(std::make_shared<Constant>(0)) {}

Signal::Signal(std::shared_ptr<const History> history)
    : history_(std::move(history))
{
}

Signal Signal::constant(const double value)
{
  return Signal(std::make_shared<Constant>(value));
}

Signal Signal::ramp(const double rate, const double start, const double limit)
{
  return Signal(std::make_shared<Ramp>(rate, start, limit));
}

Signal Signal::sine(const double offset, const double amplitude,
                    const double frequency, const double phase)
{
  return Signal(std::make_shared<Sine>(offset, amplitude, frequency, phase));
}

Signal Signal::steps(std::vector<double> times, std::vector<double> values)
{
  return Signal(std::make_shared<Steps>(std::move(times), std::move(values)));
}

Signal Signal::table(std::vector<double> times, std::vector<double> values)
{
  return Signal(std::make_shared<Table>(std::move(times), std::move(values)));
}

Signal Signal::expression(const std::string& formula, std::vector<double> kinks)
{
  return Signal(make_expression(formula, std::move(kinks)));
}

double Signal::value(const double time) const
{
  return history_->value(time);
}

double Signal::value_before(const double time) const
{
  return history_->value_before(time);
}

double Signal::rate(const double time) const
{
  return history_->rate(time);
}

double Signal::second_rate(const double time) const
{
  return history_->second_rate(time);
}

std::vector<double> Signal::kinks(const double start, const double end) const
{
  std::vector<double> inside;
  for (const double kink : history_->kinks())
    if (kink > start && kink < end)
      inside.push_back(kink);
  return inside;
}

bool Signal::is_constant() const
{
  return history_->is_constant();
}

std::string Signal::to_text() const
{
  return history_->to_text();
}
} // namespace taut
