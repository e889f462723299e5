#include <taut/fe/film_kernel.h>
#include <taut/fe/lanes.h>

#include <array>
#include <limits>
#include <vector>

// Compiled for the processor at hand; must include nothing of deal.II.

namespace taut::fe
{
namespace
{
using Tensor = material::SymmetricTensor2<Lanes>;
using Vector = std::array<Lanes, 3>;

const Lanes* as_lanes(const double* x)
{
  return reinterpret_cast<const Lanes*>(x);
}

Lanes* as_lanes(double* x)
{
  return reinterpret_cast<Lanes*>(x);
}

Tensor* as_tensors(double* x)
{
  return reinterpret_cast<Tensor*>(x);
}

const Tensor* as_tensors(const double* x)
{
  return reinterpret_cast<const Tensor*>(x);
}

/// The two columns of F = sum_a x_a (x) G_a.
struct DeformationGradient
{
  Vector f1, f2;
};

template <unsigned int n_nodes>
inline DeformationGradient make_deformation_gradient(const Lanes* gradients,
                                                     const Lanes* x)
{
  DeformationGradient F;
  for (unsigned int d = 0; d < 3; ++d)
    F.f1[d] = F.f2[d] = Lanes(0.);
  for (unsigned int a = 0; a < n_nodes; ++a)
    for (unsigned int d = 0; d < 3; ++d)
    {
      F.f1[d] += x[3 * a + d] * gradients[2 * a];
      F.f2[d] += x[3 * a + d] * gradients[2 * a + 1];
    }
  return F;
}

inline Lanes dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Tensor make_metric(const DeformationGradient& F)
{
  return {dot(F.f1, F.f1), dot(F.f2, F.f2), dot(F.f1, F.f2)};
}

/// forces_a += w F S G_a.
template <unsigned int n_nodes>
inline void add_forces(const Lanes* gradients, const DeformationGradient& F,
                       const Tensor& S, const Lanes& w, Lanes* forces)
{
  Vector p1, p2;
  for (unsigned int d = 0; d < 3; ++d)
  {
    p1[d] = w * (F.f1[d] * S.xx + F.f2[d] * S.xy);
    p2[d] = w * (F.f1[d] * S.xy + F.f2[d] * S.yy);
  }
  for (unsigned int a = 0; a < n_nodes; ++a)
    for (unsigned int d = 0; d < 3; ++d)
      forces[3 * a + d] +=
          p1[d] * gradients[2 * a] + p2[d] * gradients[2 * a + 1];
}

void update_limit(const Lanes& margin, const unsigned int point,
                  LimitCheck& check)
{
  for (unsigned int lane = 0; lane < n_lanes; ++lane)
    if (!(margin.v[lane] >= check.margin))
      check = {margin.v[lane], point, lane};
}

template <unsigned int n_nodes>
LimitCheck compute_forces(const BatchGeometry& geometry, const BatchLaw& law,
                          const double* positions, const double* internal,
                          double* forces, double* rates, BatchPower& power)
{
  const std::size_t n_networks = law.elastomer->networks.size();
  const Lanes* x = as_lanes(positions);
  Lanes* f = as_lanes(forces);
  for (unsigned int i = 0; i < 3 * n_nodes; ++i)
    f[i] = Lanes(0.);
  Lanes dissipation(0.), permittivity(0.);
  LimitCheck check{std::numeric_limits<double>::infinity(), 0, 0};
  for (unsigned int q = 0; q < n_nodes; ++q)
  {
    const Lanes* gradients = as_lanes(geometry.gradients) + 2 * n_nodes * q;
    const Lanes w = as_lanes(geometry.volumes)[q];
    const Tensor* A = as_tensors(internal) + n_networks * q;
    const auto F = make_deformation_gradient<n_nodes>(gradients, x);
    const Tensor C = make_metric(F);
    update_limit(material::limit_margin(*law.elastomer, C, A), q, check);
    const Tensor S = material::stress(*law.elastomer, C, A, law.field);
    add_forces<n_nodes>(gradients, F, S, w, f);
    permittivity +=
        w * material::charge_density(*law.elastomer, C, law.field, 1.);
    if (n_networks > 0)
    {
      material::rates(*law.elastomer, C, A,
                      as_tensors(rates) + n_networks * q);
      dissipation += w * material::dissipation(*law.elastomer, C, A);
    }
  }
  *as_lanes(power.dissipation) = dissipation;
  *as_lanes(power.permittivity) = permittivity;
  return check;
}

/// dP/dF of P = F S with dS = D dE: [i alpha][j beta], i, j in 0..2.
using Moduli = std::array<std::array<Lanes, 6>, 6>;

/// F_i gamma D_(gamma alpha)(delta beta) F_j delta + delta_ij S_alpha beta; row
/// and column 2 i + alpha.
inline void make_moduli(const DeformationGradient& F, const Tensor& S,
                        const material::Matrix3<Lanes>& D, const Lanes& w,
                        Moduli& moduli)
{
  // Voigt numbers of (gamma, alpha).
  constexpr unsigned int voigt[2][2] = {{0, 2}, {2, 1}};
  // Left products L[i alpha][n] = sum_gamma F_i gamma D[voigt(gamma alpha)][n].
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int alpha = 0; alpha < 2; ++alpha)
    {
      std::array<Lanes, 3> left;
      for (unsigned int n = 0; n < 3; ++n)
        left[n] = w * (F.f1[i] * D[voigt[0][alpha]][n] +
                       F.f2[i] * D[voigt[1][alpha]][n]);
      for (unsigned int j = 0; j < 3; ++j)
        for (unsigned int beta = 0; beta < 2; ++beta)
          moduli[2 * i + alpha][2 * j + beta] =
              left[voigt[0][beta]] * F.f1[j] + left[voigt[1][beta]] * F.f2[j];
      const Lanes w_S[2] = {w * (alpha == 0 ? S.xx : S.xy),
                            w * (alpha == 0 ? S.xy : S.yy)};
      for (unsigned int beta = 0; beta < 2; ++beta)
        moduli[2 * i + alpha][2 * i + beta] += w_S[beta];
    }
}

/// K_ai,bj += sum G_a alpha moduli[i alpha][j beta] G_b beta.
template <unsigned int n_nodes>
inline void add_stiffness(const Lanes* gradients, const Moduli& moduli,
                          const bool symmetric, Lanes* stiffness)
{
  constexpr unsigned int n = 3 * n_nodes;
  for (unsigned int a = 0; a < n_nodes; ++a)
  {
    Lanes left[3][6];
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int k = 0; k < 6; ++k)
        left[i][k] = gradients[2 * a] * moduli[2 * i][k] +
                     gradients[2 * a + 1] * moduli[2 * i + 1][k];
    const unsigned int b_end = symmetric ? a + 1 : n_nodes;
    for (unsigned int b = 0; b < b_end; ++b)
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          stiffness[(3 * a + i) * n + 3 * b + j] +=
              left[i][2 * j] * gradients[2 * b] +
              left[i][2 * j + 1] * gradients[2 * b + 1];
  }
}

template <unsigned int n_nodes>
void add_mass(const BatchGeometry& geometry, const double* shape_values,
              const double factor, const bool symmetric, Lanes* stiffness)
{
  constexpr unsigned int n = 3 * n_nodes;
  for (unsigned int a = 0; a < n_nodes; ++a)
    for (unsigned int b = 0; b < (symmetric ? a + 1 : n_nodes); ++b)
    {
      Lanes mass(0.);
      for (unsigned int q = 0; q < n_nodes; ++q)
        mass += as_lanes(geometry.volumes)[q] *
                (factor * shape_values[q * n_nodes + a] *
                 shape_values[q * n_nodes + b]);
      for (unsigned int i = 0; i < 3; ++i)
        stiffness[(3 * a + i) * n + 3 * b + i] += mass;
    }
}

inline void symmetrise(material::Matrix3<Lanes>& D)
{
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < i; ++j)
      D[i][j] = D[j][i] = (D[i][j] + D[j][i]) * Lanes(0.5);
}

template <unsigned int n_nodes>
void compute_stiffness(const BatchGeometry& geometry, const BatchLaw& law,
                       const double* shape_values, const double mass_factor,
                       const double* positions, const double* internal,
                       const double alpha, const bool symmetric,
                       double* stiffness)
{
  const std::size_t n_networks = law.elastomer->networks.size();
  Lanes* K = as_lanes(stiffness);
  for (unsigned int i = 0; i < 9 * n_nodes * n_nodes; ++i)
    K[i] = Lanes(0.);
  for (unsigned int q = 0; q < n_nodes; ++q)
  {
    const Lanes* gradients = as_lanes(geometry.gradients) + 2 * n_nodes * q;
    const auto F =
        make_deformation_gradient<n_nodes>(gradients, as_lanes(positions));
    Tensor S;
    material::Matrix3<Lanes> D;
    material::stress_and_stiffness(*law.elastomer, make_metric(F),
                                   as_tensors(internal) + n_networks * q,
                                   law.field, alpha, S, D);
    if (symmetric)
      symmetrise(D);
    Moduli moduli;
    make_moduli(F, S, D, as_lanes(geometry.volumes)[q], moduli);
    add_stiffness<n_nodes>(gradients, moduli, symmetric, K);
  }
  if (mass_factor != 0)
    add_mass<n_nodes>(geometry, shape_values,
                      mass_factor * law.elastomer->density, symmetric, K);
}

template <unsigned int n_nodes>
void compute_mass(const BatchGeometry& geometry, const double* shape_values,
                  const double density, double* mass)
{
  Lanes* M = as_lanes(mass);
  for (unsigned int i = 0; i < 9 * n_nodes * n_nodes; ++i)
    M[i] = Lanes(0.);
  add_mass<n_nodes>(geometry, shape_values, density, true, M);
}

template <unsigned int n_nodes>
void compute_force_change(const BatchGeometry& geometry, const BatchLaw& law,
                          const double* positions, const double* internal,
                          const double alpha, const double* r, double* forces)
{
  const std::size_t n_networks = law.elastomer->networks.size();
  Lanes* f = as_lanes(forces);
  for (unsigned int i = 0; i < 3 * n_nodes; ++i)
    f[i] = Lanes(0.);
  const Tensor no_strain{Lanes(0.), Lanes(0.), Lanes(0.)};
  std::vector<Tensor> change(n_networks);
  for (unsigned int q = 0; q < n_nodes; ++q)
  {
    const Lanes* gradients = as_lanes(geometry.gradients) + 2 * n_nodes * q;
    const Tensor* A = as_tensors(internal) + n_networks * q;
    const auto F =
        make_deformation_gradient<n_nodes>(gradients, as_lanes(positions));
    const Tensor C = make_metric(F);
    material::network_response(*law.elastomer, C, A, alpha, no_strain,
                               as_tensors(r) + n_networks * q, change.data());
    const Tensor S =
        material::stress_change(*law.elastomer, C, A, change.data());
    add_forces<n_nodes>(gradients, F, S, as_lanes(geometry.volumes)[q], f);
  }
}

template <unsigned int n_nodes>
void compute_internal_change(const BatchGeometry& geometry, const BatchLaw& law,
                             const double* positions, const double* internal,
                             const double alpha, const double* dx,
                             const double* r, double* change)
{
  const std::size_t n_networks = law.elastomer->networks.size();
  for (unsigned int q = 0; q < n_nodes; ++q)
  {
    const Lanes* gradients = as_lanes(geometry.gradients) + 2 * n_nodes * q;
    const auto F =
        make_deformation_gradient<n_nodes>(gradients, as_lanes(positions));
    const auto dF = make_deformation_gradient<n_nodes>(gradients, as_lanes(dx));
    // Engineering strain: dE = sym(F^T dF), the shear doubled.
    const Tensor strain{dot(F.f1, dF.f1), dot(F.f2, dF.f2),
                        dot(F.f1, dF.f2) + dot(F.f2, dF.f1)};
    material::network_response(*law.elastomer, make_metric(F),
                               as_tensors(internal) + n_networks * q, alpha,
                               strain, as_tensors(r) + n_networks * q,
                               as_tensors(change) + n_networks * q);
  }
}

template <unsigned int n_nodes>
void compute_energy(const BatchGeometry& geometry, const BatchLaw& law,
                    const double* positions, const double* internal,
                    BatchEnergy& energy)
{
  const std::size_t n_networks = law.elastomer->networks.size();
  Lanes at_voltage(0.), stored(0.);
  for (unsigned int q = 0; q < n_nodes; ++q)
  {
    const Lanes* gradients = as_lanes(geometry.gradients) + 2 * n_nodes * q;
    const Lanes w = as_lanes(geometry.volumes)[q];
    const Tensor C = make_metric(
        make_deformation_gradient<n_nodes>(gradients, as_lanes(positions)));
    const Tensor* A = as_tensors(internal) + n_networks * q;
    at_voltage += w * material::energy(*law.elastomer, C, A, law.field);
    stored += w * material::stored_energy(*law.elastomer, C, A);
  }
  *as_lanes(energy.at_voltage) = at_voltage;
  *as_lanes(energy.stored) = stored;
}

template <unsigned int n_nodes>
void compute_metric(const BatchGeometry& geometry, const double* positions,
                    double* metric)
{
  for (unsigned int q = 0; q < n_nodes; ++q)
    as_tensors(metric)[q] = make_metric(make_deformation_gradient<n_nodes>(
        as_lanes(geometry.gradients) + 2 * n_nodes * q, as_lanes(positions)));
}

inline Vector cross(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
          a[0] * b[1] - a[1] * b[0]};
}

/// The two tangents dx/dxi, dx/deta at a point.
template <unsigned int n_nodes>
inline DeformationGradient make_tangents(const double* shape_gradients,
                                         const Lanes* x)
{
  DeformationGradient tangents;
  for (unsigned int d = 0; d < 3; ++d)
    tangents.f1[d] = tangents.f2[d] = Lanes(0.);
  for (unsigned int a = 0; a < n_nodes; ++a)
    for (unsigned int d = 0; d < 3; ++d)
    {
      tangents.f1[d] += x[3 * a + d] * Lanes(shape_gradients[2 * a]);
      tangents.f2[d] += x[3 * a + d] * Lanes(shape_gradients[2 * a + 1]);
    }
  return tangents;
}

template <unsigned int n_nodes>
void compute_pressure_forces(const double* shape_values,
                             const double* shape_gradients,
                             const double* weights, const Lanes& active,
                             const Lanes* x, const double pressure, Lanes* f)
{
  for (unsigned int i = 0; i < 3 * n_nodes; ++i)
    f[i] = Lanes(0.);
  for (unsigned int q = 0; q < n_nodes; ++q)
  {
    const auto tangents =
        make_tangents<n_nodes>(shape_gradients + 2 * n_nodes * q, x);
    const Vector normal = cross(tangents.f1, tangents.f2);
    const Lanes w = active * Lanes(pressure * weights[q]);
    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int d = 0; d < 3; ++d)
        f[3 * a + d] += w * Lanes(shape_values[q * n_nodes + a]) * normal[d];
  }
}

/// The matrix of v -> t x v.
inline Lanes cross_matrix(const Vector& t, const unsigned int i,
                          const unsigned int j)
{
  if (i == j)
    return Lanes(0.);
  const unsigned int k = 3 - i - j;
  return (j + 1) % 3 == i ? t[k] : -t[k];
}

template <unsigned int n_nodes>
void add_pressure_stiffness(const double* shape_values,
                            const double* shape_gradients,
                            const double* weights, const Lanes& active,
                            const Lanes* x, const double pressure,
                            const bool symmetric, Lanes* K)
{
  constexpr unsigned int n = 3 * n_nodes;
  for (unsigned int q = 0; q < n_nodes; ++q)
  {
    const double* gradients = shape_gradients + 2 * n_nodes * q;
    const double* values = shape_values + q * n_nodes;
    const auto tangents = make_tangents<n_nodes>(gradients, x);
    const Lanes w = active * Lanes(pressure * weights[q]);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
      {
        if (i == j)
          continue;
        // d(t1 x t2)/dx_b = [t1 x] dN_b/deta - [t2 x] dN_b/dxi.
        const Lanes c1 = w * cross_matrix(tangents.f1, i, j);
        const Lanes c2 = w * cross_matrix(tangents.f2, i, j);
        for (unsigned int a = 0; a < n_nodes; ++a)
          for (unsigned int b = 0; b < (symmetric ? a + 1 : n_nodes); ++b)
          {
            Lanes change = values[a] * (c1 * Lanes(gradients[2 * b + 1]) -
                                        c2 * Lanes(gradients[2 * b]));
            if (symmetric)
              // The transposed block (b j, a i); the cross matrix is skew.
              change = Lanes(0.5) *
                       (change - values[b] * (c1 * Lanes(gradients[2 * a + 1]) -
                                              c2 * Lanes(gradients[2 * a])));
            K[(3 * a + i) * n + 3 * b + j] -= change;
          }
      }
  }
}
} // namespace

LimitCheck compute_forces(const BatchGeometry& geometry, const BatchLaw& law,
                          const double* positions, const double* internal,
                          double* forces, double* rates, BatchPower& power)
{
  return geometry.n_nodes == 9
             ? compute_forces<9>(geometry, law, positions, internal, forces,
                                 rates, power)
             : compute_forces<4>(geometry, law, positions, internal, forces,
                                 rates, power);
}

void compute_stiffness(const BatchGeometry& geometry, const BatchLaw& law,
                       const double* shape_values, const double mass_factor,
                       const double* positions, const double* internal,
                       const double alpha, const bool symmetric,
                       double* stiffness)
{
  if (geometry.n_nodes == 9)
    compute_stiffness<9>(geometry, law, shape_values, mass_factor, positions,
                         internal, alpha, symmetric, stiffness);
  else
    compute_stiffness<4>(geometry, law, shape_values, mass_factor, positions,
                         internal, alpha, symmetric, stiffness);
}

void compute_mass(const BatchGeometry& geometry, const double* shape_values,
                  const double density, double* mass)
{
  if (geometry.n_nodes == 9)
    compute_mass<9>(geometry, shape_values, density, mass);
  else
    compute_mass<4>(geometry, shape_values, density, mass);
}

void compute_force_change(const BatchGeometry& geometry, const BatchLaw& law,
                          const double* positions, const double* internal,
                          const double alpha, const double* r, double* forces)
{
  if (geometry.n_nodes == 9)
    compute_force_change<9>(geometry, law, positions, internal, alpha, r,
                            forces);
  else
    compute_force_change<4>(geometry, law, positions, internal, alpha, r,
                            forces);
}

void compute_internal_change(const BatchGeometry& geometry, const BatchLaw& law,
                             const double* positions, const double* internal,
                             const double alpha, const double* dx,
                             const double* r, double* change)
{
  if (geometry.n_nodes == 9)
    compute_internal_change<9>(geometry, law, positions, internal, alpha, dx, r,
                               change);
  else
    compute_internal_change<4>(geometry, law, positions, internal, alpha, dx, r,
                               change);
}

void compute_energy(const BatchGeometry& geometry, const BatchLaw& law,
                    const double* positions, const double* internal,
                    BatchEnergy& energy)
{
  if (geometry.n_nodes == 9)
    compute_energy<9>(geometry, law, positions, internal, energy);
  else
    compute_energy<4>(geometry, law, positions, internal, energy);
}

void compute_metric(const BatchGeometry& geometry, const double* positions,
                    double* metric)
{
  if (geometry.n_nodes == 9)
    compute_metric<9>(geometry, positions, metric);
  else
    compute_metric<4>(geometry, positions, metric);
}

void compute_pressure_forces(const unsigned int n_nodes,
                             const double* shape_values,
                             const double* shape_gradients,
                             const double* weights, const double* active,
                             const double* positions, const double pressure,
                             double* forces)
{
  if (n_nodes == 9)
    compute_pressure_forces<9>(shape_values, shape_gradients, weights,
                               *as_lanes(active), as_lanes(positions), pressure,
                               as_lanes(forces));
  else
    compute_pressure_forces<4>(shape_values, shape_gradients, weights,
                               *as_lanes(active), as_lanes(positions), pressure,
                               as_lanes(forces));
}

void add_pressure_stiffness(const unsigned int n_nodes,
                            const double* shape_values,
                            const double* shape_gradients,
                            const double* weights, const double* active,
                            const double* positions, const double pressure,
                            const bool symmetric, double* stiffness)
{
  if (n_nodes == 9)
    add_pressure_stiffness<9>(shape_values, shape_gradients, weights,
                              *as_lanes(active), as_lanes(positions), pressure,
                              symmetric, as_lanes(stiffness));
  else
    add_pressure_stiffness<4>(shape_values, shape_gradients, weights,
                              *as_lanes(active), as_lanes(positions), pressure,
                              symmetric, as_lanes(stiffness));
}
} // namespace taut::fe
