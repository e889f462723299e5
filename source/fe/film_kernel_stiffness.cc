#include "film_kernel_detail.h"

namespace taut::fe
{
namespace
{
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

/// From S and D of the metric to those of the film that wrinkles.
void make_wrinkled_stiffness(const BatchLaw& law, const Tensor& C,
                             const Tensor* A, const double alpha, Tensor& S,
                             material::Matrix3<Lanes>& D)
{
  const auto state = find_wrinkles(law, C, A, S);
  material::stress_and_stiffness(*law.elastomer, state.metric, A, law.field,
                                 alpha, S, D);
  D = material::condense_wrinkles(
      material::make_wrinkle_response(state, C, S, D), D);
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
    const Tensor C = make_metric(F);
    const Tensor* A = as_tensors(internal) + n_networks * q;
    Tensor S;
    material::Matrix3<Lanes> D;
    material::stress_and_stiffness(*law.elastomer, C, A, law.field, alpha, S,
                                   D);
    if (wrinkles(law, C, A, S))
      make_wrinkled_stiffness(law, C, A, alpha, S, D);
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
} // namespace

void compute_stiffness(const BatchGeometry& geometry, const BatchLaw& law,
                       const double* shape_values, const double mass_factor,
                       const double* positions, const double* internal,
                       const double alpha, const bool symmetric,
                       double* stiffness)
{
  with_nodes(geometry.n_nodes,
             [&](const auto n)
             {
               compute_stiffness<n>(geometry, law, shape_values, mass_factor,
                                    positions, internal, alpha, symmetric,
                                    stiffness);
             });
}

void compute_mass(const BatchGeometry& geometry, const double* shape_values,
                  const double density, double* mass)
{
  with_nodes(geometry.n_nodes, [&](const auto n)
             { compute_mass<n>(geometry, shape_values, density, mass); });
}
} // namespace taut::fe
