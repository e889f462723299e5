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
  return reduce(vibration, basis, [&](const double* x, double* result)
                { vibration.multiply_stiffness(x, result); });
}

void subtract(const std::vector<double>& other, std::vector<double>& matrix)
{
  for (std::size_t i = 0; i < matrix.size(); ++i)
    matrix[i] -= other[i];
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

/// A relaxation on the basis: what it adds to the stiffness if it is held, and
/// if it answers a motion of the rate 1/T.
struct Part
{
  std::vector<double> held, flowing;
  double time;
  bool is_circuit;

  /// From held/flowing = 1 + 1/(rate T) at a mode.
  double compute_time(const std::vector<double>& mode) const
  {
    const double whole = compute_quadratic(held, mode);
    const double answer = is_circuit ? 0. : compute_quadratic(flowing, mode);
    // A mode that does not strain these networks has no opinion.
    if (!(std::abs(answer) > 1e-9 * std::abs(mode_stiffness(mode))))
      return time;
    const double ratio = answer / whole;
    return ratio > 0 && ratio < 1 ? time * ratio / (1 - ratio) : time;
  }
  double mode_stiffness(const std::vector<double>& mode) const
  {
    double trace = 0;
    for (std::size_t i = 0; i < mode.size(); ++i)
      trace = std::max(trace, std::abs(held[i * (mode.size() + 1)]));
    return trace;
  }
};

std::vector<Part> make_parts(Vibration& vibration, const Vectors& basis)
{
  vibration.relax();
  const auto relaxed = reduce_stiffness(vibration, basis);
  std::vector<Part> parts;
  const auto& relaxations = vibration.relaxations();
  for (std::size_t r = 0; r < relaxations.size(); ++r)
  {
    Part part;
    part.time = relaxations[r].time;
    part.is_circuit = vibration.is_circuit(r);
    vibration.hold(r);
    part.held = reduce_stiffness(vibration, basis);
    subtract(relaxed, part.held);
    if (!part.is_circuit)
    {
      vibration.flow(r, 1 / part.time);
      part.flowing = reduce_stiffness(vibration, basis);
      subtract(relaxed, part.flowing);
    }
    parts.push_back(std::move(part));
  }
  vibration.freeze();
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

std::vector<DampedMode>
compute_damped_modes(Vibration& vibration,
                     const std::vector<time::VibrationMode>& frozen,
                     const std::vector<time::VibrationMode>& relaxed)
{
  const Vectors basis = make_basis(vibration, frozen, relaxed);
  const auto parts = make_parts(vibration, basis);
  time::DampedVibration reduced;
  reduced.size = basis.size();
  reduced.stiffness = reduce_stiffness(vibration, basis);
  reduced.damping.assign(basis.size() * basis.size(), 0.);
  if (vibration.has_damping())
    reduced.damping =
        reduce(vibration, basis, [&](const double* x, double* result)
               { vibration.multiply_damping(x, result); });
  for (const Part& part : parts)
    reduced.parts.push_back({part.held, part.time});
  std::vector<DampedMode> damped;
  for (const time::VibrationMode& mode : frozen)
  {
    const auto shape = project(vibration, basis, mode.shape);
    DampedMode result;
    for (std::size_t r = 0; r < parts.size(); ++r)
    {
      reduced.parts[r].time = parts[r].compute_time(shape);
      result.products.push_back(std::sqrt(std::max(0., mode.square)) *
                                reduced.parts[r].time);
    }
    result.rate = time::find_damped_rate(reduced, shape);
    damped.push_back(result);
  }
  return damped;
}
} // namespace taut::structure
