#include <taut/structure/vibration_damping.h>
#include <taut/time/damped_modes.h>

#include <algorithm>
#include <cmath>

namespace taut::structure
{
namespace
{
using Vectors = std::vector<std::vector<double>>;

/// What is left of a vector of length 1 when others are taken out of it counts
/// as a new direction above this.
constexpr double new_direction = 1e-4;

/// Orthonormal in the product with M, the span of the modes.
Vectors make_basis(Vibration& vibration,
                   const std::vector<time::VibrationMode>& frozen,
                   const std::vector<time::VibrationMode>& relaxed)
{
  Vectors basis;
  std::vector<double> product(vibration.n_unknowns());
  for (const auto* modes : {&frozen, &relaxed})
    for (const time::VibrationMode& mode : *modes)
    {
      std::vector<double> x = mode.shape;
      double length = 1;
      // Twice is enough (Kahan and Parlett).
      for (unsigned int pass = 0; pass < 2 && length > new_direction; ++pass)
      {
        for (const auto& other : basis)
        {
          vibration.multiply_mass(x.data(), product.data());
          const double share = vibration.multiply(other.data(), product.data());
          for (std::size_t i = 0; i < x.size(); ++i)
            x[i] -= share * other[i];
        }
        vibration.multiply_mass(x.data(), product.data());
        length = std::sqrt(
            std::max(0., vibration.multiply(x.data(), product.data())));
        if (length > new_direction)
          for (double& entry : x)
            entry /= length;
      }
      if (length > new_direction)
        basis.push_back(x);
    }
  return basis;
}

/// B^T (A B), row-major; `multiply`(x, result) applies A.
template <class Multiply>
std::vector<double> reduce(const Vibration& vibration, const Vectors& basis,
                           const Multiply& multiply)
{
  const std::size_t n = basis.size();
  std::vector<double> matrix(n * n), product(vibration.n_unknowns());
  for (std::size_t j = 0; j < n; ++j)
  {
    multiply(basis[j].data(), product.data());
    for (std::size_t i = 0; i < n; ++i)
      matrix[n * i + j] = vibration.multiply(basis[i].data(), product.data());
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j)
      matrix[n * i + j] = matrix[n * j + i] =
          0.5 * (matrix[n * i + j] + matrix[n * j + i]);
  return matrix;
}

std::vector<double> reduce_stiffness(const Vibration& vibration,
                                     const Vectors& basis)
{
  return reduce(vibration, basis,
                [&](const double* x, double* result)
                { vibration.multiply_stiffness(x, result); });
}

double compute_quadratic(const std::vector<double>& matrix,
                         const std::vector<double>& x)
{
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < x.size(); ++j)
      sum += x[i] * matrix[x.size() * i + j] * x[j];
  return sum;
}

/// What a relaxation takes from the stiffness of a motion exp(rate t).
std::vector<double> compute_loss(Vibration& vibration, const Vectors& basis,
                                 const std::vector<double>& frozen,
                                 const std::size_t relaxation,
                                 const double rate)
{
  vibration.flow(relaxation, rate);
  auto loss = reduce_stiffness(vibration, basis);
  for (std::size_t i = 0; i < loss.size(); ++i)
    loss[i] = frozen[i] - loss[i];
  return loss;
}

double get_largest(const std::vector<double>& matrix)
{
  double largest = 0;
  for (const double entry : matrix)
    largest = std::max(largest, std::abs(entry));
  return largest;
}

/// What a relaxation takes from the stiffness of slow motions, and of those of
/// the rate 1/T.
struct Part
{
  std::vector<double> slow, quick;
  double time;

  /// From slow/quick = 1 + rate T at a mode.
  double compute_time(const std::vector<double>& mode) const
  {
    const double all = compute_quadratic(slow, mode);
    const double some = compute_quadratic(quick, mode);
    // A mode that does not strain these networks has no opinion.
    constexpr double least = 1e-9;
    const bool takes_part = all > least * get_largest(slow);
    return takes_part && some > 0 && some < all ? time * (all / some - 1)
                                                : time;
  }
};

std::vector<Part> make_parts(Vibration& vibration, const Vectors& basis,
                             const std::vector<double>& frozen)
{
  std::vector<Part> parts;
  const auto& relaxations = vibration.relaxations();
  for (std::size_t r = 0; r < relaxations.size(); ++r)
  {
    const double time = relaxations[r].time;
    parts.push_back({compute_loss(vibration, basis, frozen, r, 0),
                     compute_loss(vibration, basis, frozen, r, 1 / time),
                     time});
  }
  return parts;
}

/// M-product of a mode with the basis.
std::vector<double> project(Vibration& vibration, const Vectors& basis,
                            const std::vector<double>& shape)
{
  std::vector<double> product(shape.size()), result;
  vibration.multiply_mass(shape.data(), product.data());
  for (const auto& x : basis)
    result.push_back(vibration.multiply(x.data(), product.data()));
  return result;
}
} // namespace

std::vector<DampedMode> compute_damped_modes(
    Vibration& vibration, const std::vector<time::VibrationMode>& modes,
    const std::vector<time::VibrationMode>& others, const bool at_rest)
{
  const Vectors basis = make_basis(vibration, modes, others);
  time::DampedVibration reduced;
  reduced.size = basis.size();
  vibration.freeze();
  reduced.stiffness = reduce_stiffness(vibration, basis);
  reduced.damping.assign(basis.size() * basis.size(), 0.);
  if (vibration.has_damping())
    reduced.damping = reduce(vibration, basis,
                             [&](const double* x, double* result)
                             { vibration.multiply_damping(x, result); });
  for (const Relaxation& relaxation : vibration.relaxations())
    reduced.parts.push_back({{}, relaxation.time});
  std::vector<Part> parts;
  if (at_rest)
    parts = make_parts(vibration, basis, reduced.stiffness);
  std::vector<DampedMode> damped;
  for (const time::VibrationMode& mode : modes)
  {
    const auto shape = project(vibration, basis, mode.shape);
    const double frequency = std::sqrt(std::max(0., mode.square));
    DampedMode result;
    for (std::size_t r = 0; r < reduced.parts.size(); ++r)
    {
      auto& part = reduced.parts[r];
      if (at_rest)
      {
        part.time = parts[r].compute_time(shape);
        part.stiffness = parts[r].slow;
      }
      else
      {
        part.stiffness =
            compute_loss(vibration, basis, reduced.stiffness, r, frequency);
        for (double& entry : part.stiffness)
          entry *= 1 + frequency * part.time;
      }
      result.products.push_back(frequency * part.time);
    }
    result.rate = time::find_damped_rate(reduced, shape);
    damped.push_back(std::move(result));
  }
  vibration.freeze();
  return damped;
}
} // namespace taut::structure
