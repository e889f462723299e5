#include <taut/base/exceptions.h>
#include <taut/base/number_text.h>
#include <taut/lumped/lyapunov.h>

#include <cmath>
#include <numeric>

namespace taut::lumped
{
namespace
{
constexpr std::size_t n_parts = 10;

void validate(const LyapunovOptions& options)
{
  if (!(options.end > options.begin))
    throw BadInput("the growth of a disturbance is measured from " +
                   number_text(options.begin) + " to " +
                   number_text(options.end) + ", which is no time");
  if (options.intervals < 20)
    throw BadInput("the growth of a disturbance is measured over at least 20 "
                   "intervals, got " +
                   std::to_string(options.intervals));
}

std::vector<double> get_scales(const LyapunovOptions& options,
                               const std::size_t size)
{
  return options.scales.empty() ? std::vector<double>(size, 1.)
                                : options.scales;
}

double measure_distance(const std::vector<double>& one,
                        const std::vector<double>& other,
                        const std::vector<double>& scales)
{
  double sum = 0;
  for (std::size_t i = 0; i < one.size(); ++i)
    sum += std::pow((other[i] - one[i]) / scales[i], 2);
  return std::sqrt(sum);
}

/// Moves `neighbour` towards `state` or away from it.
void rescale(const std::vector<double>& state, std::vector<double>& neighbour,
             const double factor)
{
  for (std::size_t i = 0; i < state.size(); ++i)
    neighbour[i] = state[i] + factor * (neighbour[i] - state[i]);
}

std::vector<double> make_neighbour(std::vector<double> state,
                                   const std::vector<double>& scales,
                                   const double distance)
{
  for (std::size_t i = 0; i < state.size(); ++i)
    state[i] += distance * scales[i] / std::sqrt(double(state.size()));
  return state;
}

/// ln(d_k / d_0) / h of every interval.
std::vector<double> measure_growth(const Flow& flow, std::vector<double> state,
                                   const LyapunovOptions& options)
{
  const auto scales = get_scales(options, state.size());
  auto neighbour = make_neighbour(state, scales, options.distance);
  const double interval = (options.end - options.begin) / options.intervals;
  std::vector<double> rates;
  for (unsigned int k = 0; k < options.intervals; ++k)
  {
    const double begin = options.begin + k * interval;
    const double end = options.begin + (k + 1) * interval;
    const double before = measure_distance(state, neighbour, scales);
    state = flow(state, begin, end);
    neighbour = flow(neighbour, begin, end);
    const double after = measure_distance(state, neighbour, scales);
    if (!(after > 0))
      throw SolverFailed("a disturbance dies out within one interval, so that "
                         "its decay cannot be measured");
    rates.push_back(std::log(after / before) / interval);
    rescale(state, neighbour, options.distance / after);
  }
  return rates;
}

double compute_mean(const double* begin, const double* end)
{
  return std::accumulate(begin, end, 0.) / double(end - begin);
}
} // namespace

LyapunovExponent compute_lyapunov(const Flow& flow,
                                  const std::vector<double>& state,
                                  const LyapunovOptions& options)
{
  validate(options);
  const auto rates = measure_growth(flow, state, options);
  const std::size_t n_per_part = (rates.size() - rates.size() / 5) / n_parts;
  const double* const end = rates.data() + rates.size();
  const double* const begin = end - n_per_part * n_parts;
  LyapunovExponent exponent;
  exponent.value = compute_mean(begin, end);
  double variance = 0;
  for (std::size_t part = 0; part < n_parts; ++part)
  {
    const double* const first = begin + part * n_per_part;
    variance +=
        std::pow(compute_mean(first, first + n_per_part) - exponent.value, 2);
  }
  exponent.uncertainty = std::sqrt(variance / (n_parts * (n_parts - 1)));
  return exponent;
}
} // namespace taut::lumped
