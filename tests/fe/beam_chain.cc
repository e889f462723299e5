#include "beam_chain.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace taut::fe
{
namespace
{
/// Solves matrix x = b by Gaussian elimination with pivoting of rows.
std::vector<double> solve_dense(std::vector<std::vector<double>> matrix,
                                std::vector<double> b)
{
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k)
  {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::abs(matrix[i][k]) > std::abs(matrix[pivot][k]))
        pivot = i;
    std::swap(matrix[k], matrix[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < n; ++i)
    {
      const double factor = matrix[i][k] / matrix[k][k];
      if (factor == 0)
        continue;
      for (std::size_t j = k; j < n; ++j)
        matrix[i][j] -= factor * matrix[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;)
  {
    for (std::size_t j = k + 1; j < n; ++j)
      b[k] -= matrix[k][j] * b[j];
    b[k] /= matrix[k][k];
  }
  return b;
}

double norm(const std::vector<double>& v)
{
  double square = 0;
  for (const double component : v)
    square += component * component;
  return std::sqrt(square);
}
} // namespace

BeamChain::BeamChain(const unsigned int n_elements,
                     const unsigned int nodes_per_element, const double length,
                     const BeamStiffness& stiffness)
    : n_nodes_(n_elements * (nodes_per_element - 1) + 1),
      nodes_per_element_(nodes_per_element), stiffness_(stiffness),
      unknowns_(7 * n_nodes_, 0.)
{
  const double spacing = length / (n_nodes_ - 1);
  for (unsigned int node = 0; node < n_nodes_; ++node)
  {
    unknowns_[7 * node] = spacing * node;
    unknowns_[7 * node + 3] = 1;
  }
  for (unsigned int e = 0; e < n_elements; ++e)
  {
    const double start = e * spacing * (nodes_per_element - 1);
    const double end = (e + 1) * spacing * (nodes_per_element - 1);
    std::vector<Vector3> nodes = {{start, 0, 0}, {end, 0, 0}};
    if (nodes_per_element == 3)
      nodes.push_back({0.5 * (start + end), 0, 0});
    elements_.emplace_back(nodes, Vector3{0, 0, 1});
    resultants_.emplace_back(elements_.back().n_points(), BeamResultants{});
  }
}

Vector3 BeamChain::get_position(const unsigned int node) const
{
  const double* x = &unknowns_[7 * node];
  return {x[0], x[1], x[2]};
}

Quaternion BeamChain::get_rotation(const unsigned int node) const
{
  const double* q = &unknowns_[7 * node + 3];
  return {q[0], q[1], q[2], q[3]};
}

std::size_t BeamChain::number(const unsigned int element,
                              const unsigned int unknown) const
{
  const unsigned int n = nodes_per_element_;
  const bool position = unknown < 3 * n;
  const unsigned int node = position ? unknown / 3 : (unknown - 3 * n) / 4;
  const unsigned int component =
      position ? unknown % 3 : 3 + (unknown - 3 * n) % 4;
  // The ends of the element come first.
  const unsigned int along = node == 0 ? 0 : node == 1 ? n - 1 : 1;
  return 7 * (element * (n - 1) + along) + component;
}

std::vector<double> BeamChain::gather(const unsigned int element,
                                      const std::vector<double>& nodal) const
{
  std::vector<double> values(elements_[element].n_unknowns());
  for (unsigned int i = 0; i < values.size(); ++i)
    values[i] = nodal[number(element, i)];
  return values;
}

void BeamChain::assemble()
{
  residual_.assign(unknowns_.size(), 0.);
  matrix_.assign(unknowns_.size(), std::vector<double>(unknowns_.size(), 0.));
  for (unsigned int e = 0; e < elements_.size(); ++e)
  {
    const unsigned int n = elements_[e].n_unknowns();
    const auto u = gather(e, unknowns_);
    auto current = elements_[e].compute_strains(u.data());
    for (auto& strain : current)
      for (unsigned int i = 0; i < 6; ++i)
        strain[i] *= stiffness_[i];
    std::vector<double> forces(n, 0.), K(n * n, 0.);
    elements_[e].add_forces(u.data(), current, forces.data());
    elements_[e].add_stiffness(u.data(), stiffness_, resultants_[e], K.data());
    for (unsigned int i = 0; i < n; ++i)
    {
      residual_[number(e, i)] -= forces[i];
      for (unsigned int j = 0; j < n; ++j)
        matrix_[number(e, i)][number(e, j)] += K[n * i + j];
    }
  }
  // The length of Q has no forces: a stiffness alone holds it.
  const double hold = stiffness_[4];
  for (unsigned int node = 0; node < n_nodes_; ++node)
    for (unsigned int i = 3; i < 7; ++i)
      for (unsigned int j = 3; j < 7; ++j)
        matrix_[7 * node + i][7 * node + j] +=
            hold * unknowns_[7 * node + i] * unknowns_[7 * node + j];
}

void BeamChain::add_loads(const Vector3& force, const Vector3& moment)
{
  // m . 2 vec(dQ conj(Q))/|Q|^2 = dQ . 2 m Q/|Q|^2, m a pure quaternion.
  const std::size_t tip = 7 * (n_nodes_ - 1);
  for (unsigned int i = 0; i < 3; ++i)
    residual_[tip + i] += force[i];
  const Quaternion pure = {0, moment[0], moment[1], moment[2]};
  const Quaternion q = get_rotation(n_nodes_ - 1);
  const double factor = 2 / std::pow(taut::length(q), 2);
  const Quaternion m_q = multiply(pure, q);
  for (unsigned int j = 0; j < 4; ++j)
  {
    residual_[tip + 3 + j] += factor * m_q[j];
    Quaternion unit{};
    unit[j] = 1;
    const Quaternion m_unit = multiply(pure, unit);
    for (unsigned int i = 0; i < 4; ++i)
      matrix_[tip + 3 + i][tip + 3 + j] -=
          factor * (m_unit[i] - factor * m_q[i] * q[j]);
  }
}

void BeamChain::extrapolate_resultants(const std::vector<double>& step)
{
  for (unsigned int e = 0; e < elements_.size(); ++e)
  {
    const auto u = gather(e, unknowns_), du = gather(e, step);
    const auto strains = elements_[e].compute_strains(u.data());
    const auto changes = elements_[e].compute_strain_rates(u.data(), du.data());
    for (unsigned int q = 0; q < strains.size(); ++q)
      for (unsigned int i = 0; i < 6; ++i)
        resultants_[e][q][i] = stiffness_[i] * (strains[q][i] + changes[q][i]);
  }
}

void BeamChain::solve(const Vector3& tip_force, const Vector3& tip_moment)
{
  constexpr unsigned int most_steps = 50;
  for (unsigned int iteration = 0; iteration < most_steps; ++iteration)
  {
    assemble();
    add_loads(tip_force, tip_moment);
    for (unsigned int i = 0; i < 7; ++i)
    {
      residual_[i] = 0;
      std::fill(matrix_[i].begin(), matrix_[i].end(), 0.);
      matrix_[i][i] = 1;
    }
    const auto step = solve_dense(matrix_, residual_);
    extrapolate_resultants(step);
    for (std::size_t i = 0; i < step.size(); ++i)
      unknowns_[i] += step[i];
    // Positions of order one; the condition of thin beams costs digits.
    if (norm(step) < 1e-9)
      return;
  }
  throw std::runtime_error("Newton's method does not converge");
}
} // namespace taut::fe
