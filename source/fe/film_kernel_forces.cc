#include <limits>
#include <vector>

#include "film_kernel_detail.h"

namespace taut::fe
{
namespace
{
void update_limit(const Lanes& margin, const unsigned int point,
                  const bool wrinkles_grow, LimitCheck& check)
{
  for (unsigned int lane = 0; lane < n_lanes; ++lane)
    if (!(margin.v[lane] >= check.margin))
      check = {margin.v[lane], point, lane, wrinkles_grow};
}

/// Takes C to the metric of the wrinkled film and S to its stress.
void relax_point(const BatchLaw& law, const Tensor* A, const unsigned int point,
                 Tensor& C, Tensor& S, LimitCheck& check)
{
  const auto state = find_wrinkles(law, C, A, S);
  S = material::compute_wrinkled_stress(state, C, S);
  C = state.metric;
  const Lanes margin = material::limit_margin(*law.elastomer, C, A, law.field);
  const bool wrinkles_grow = largest(-margin) < 0 && any(!state.admissible);
  update_limit(wrinkles_grow ? select(state.admissible, margin, Lanes(-1.))
                             : margin,
               point, wrinkles_grow, check);
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
  LimitCheck check{std::numeric_limits<double>::infinity(), 0, 0, false};
  for (unsigned int q = 0; q < n_nodes; ++q)
  {
    const Lanes* gradients = as_lanes(geometry.gradients) + 2 * n_nodes * q;
    const Lanes w = as_lanes(geometry.volumes)[q];
    const Tensor* A = as_tensors(internal) + n_networks * q;
    const auto F = make_deformation_gradient<n_nodes>(gradients, x);
    Tensor C = make_metric(F);
    Tensor S = material::stress(*law.elastomer, C, A, law.field);
    const double margin =
        material::limit_margin(*law.elastomer, C, A, law.field);
    if (wrinkles(law, S, margin))
      relax_point(law, A, q, C, S, check);
    else
      update_limit(margin, q, false, check);
    add_forces<n_nodes>(gradients, F, S, w, f);
    permittivity +=
        w * material::charge_density(*law.elastomer, C, law.field, 1.);
    if (n_networks > 0)
    {
      material::rates(*law.elastomer, C, A, as_tensors(rates) + n_networks * q);
      dissipation += w * material::dissipation(*law.elastomer, C, A);
    }
  }
  *as_lanes(power.dissipation) = dissipation;
  *as_lanes(power.permittivity) = permittivity;
  return check;
}

template <unsigned int n_nodes>
LimitCheck compute_permittivity(const BatchGeometry& geometry,
                                const BatchLaw& law, const double* positions,
                                const double* internal, double* permittivity)
{
  const std::size_t n_networks = law.elastomer->networks.size();
  Lanes sum(0.);
  LimitCheck check{std::numeric_limits<double>::infinity(), 0, 0, false};
  for (unsigned int q = 0; q < n_nodes; ++q)
  {
    const Lanes* gradients = as_lanes(geometry.gradients) + 2 * n_nodes * q;
    const Tensor* A = as_tensors(internal) + n_networks * q;
    Tensor C = make_metric(
        make_deformation_gradient<n_nodes>(gradients, as_lanes(positions)));
    Tensor S = material::stress(*law.elastomer, C, A, law.field);
    const double margin = material::limit_margin(*law.elastomer, C, A);
    if (wrinkles(law, S, margin))
      relax_point(law, A, q, C, S, check);
    else
      update_limit(margin, q, false, check);
    sum += as_lanes(geometry.volumes)[q] *
           material::charge_density(*law.elastomer, C, law.field, 1.);
  }
  *as_lanes(permittivity) = sum;
  return check;
}

/// A point and how its wrinkles follow the stress.
struct WrinklingPoint
{
  WrinklingPoint(const BatchLaw& law, const Tensor& metric, const Tensor* A,
                 const double alpha)
      : C(metric)
  {
    if (!(law.wrinkle_stiffness > 0))
      return;
    Tensor S = material::stress(*law.elastomer, C, A, law.field);
    if (!fe::wrinkles(law, C, A, S))
      return;
    const auto state = find_wrinkles(law, C, A, S);
    wrinkles = true;
    C = state.metric;
    material::stress_and_stiffness(*law.elastomer, C, A, law.field, alpha, S,
                                   D);
    response = material::make_wrinkle_response(state, metric, S, D);
  }

  Tensor C;              ///< of the film, wrinkled or not
  bool wrinkles = false; ///< whether the following exist
  material::Matrix3<Lanes> D, response;
};

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
    const WrinklingPoint point(law, make_metric(F), A, alpha);
    material::network_response(*law.elastomer, point.C, A, alpha, no_strain,
                               as_tensors(r) + n_networks * q, change.data());
    Tensor S =
        material::stress_change(*law.elastomer, point.C, A, change.data());
    if (point.wrinkles)
      S = material::add(
          S, material::multiply(
                 point.D, material::compute_wrinkle_change(point.response, S)));
    add_forces<n_nodes>(gradients, F, S, as_lanes(geometry.volumes)[q], f);
  }
}

/// What the wrinkles add to a change of strain while the networks change by
/// (alpha - dA'/dA)^{-1} r; `change` is room for one tensor per network.
Tensor compute_wrinkle_strain(const BatchLaw& law, const Tensor* A,
                              const double alpha, const Tensor& strain,
                              const Tensor* r, const WrinklingPoint& point,
                              std::vector<Tensor>& change)
{
  const Tensor no_strain{Lanes(0.), Lanes(0.), Lanes(0.)};
  material::network_response(*law.elastomer, point.C, A, alpha, no_strain, r,
                             change.data());
  const Tensor S = material::add(
      material::stress_change(*law.elastomer, point.C, A, change.data()),
      material::multiply(point.D, strain));
  return material::compute_wrinkle_change(point.response, S);
}

template <unsigned int n_nodes>
void compute_internal_change(const BatchGeometry& geometry, const BatchLaw& law,
                             const double* positions, const double* internal,
                             const double alpha, const double* dx,
                             const double* r, double* change)
{
  const std::size_t n_networks = law.elastomer->networks.size();
  std::vector<Tensor> response(n_networks);
  for (unsigned int q = 0; q < n_nodes; ++q)
  {
    const Lanes* gradients = as_lanes(geometry.gradients) + 2 * n_nodes * q;
    const Tensor* A = as_tensors(internal) + n_networks * q;
    const auto F =
        make_deformation_gradient<n_nodes>(gradients, as_lanes(positions));
    const auto dF = make_deformation_gradient<n_nodes>(gradients, as_lanes(dx));
    // Engineering strain: dE = sym(F^T dF), the shear doubled.
    Tensor strain{dot(F.f1, dF.f1), dot(F.f2, dF.f2),
                  dot(F.f1, dF.f2) + dot(F.f2, dF.f1)};
    const WrinklingPoint point(law, make_metric(F), A, alpha);
    if (point.wrinkles)
      strain = material::add(
          strain, compute_wrinkle_strain(law, A, alpha, strain,
                                         as_tensors(r) + n_networks * q, point,
                                         response));
    material::network_response(*law.elastomer, point.C, A, alpha, strain,
                               as_tensors(r) + n_networks * q,
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
    Tensor C = make_metric(
        make_deformation_gradient<n_nodes>(gradients, as_lanes(positions)));
    const Tensor* A = as_tensors(internal) + n_networks * q;
    Lanes of_wrinkles(0.);
    const Tensor S = material::stress(*law.elastomer, C, A, law.field);
    if (wrinkles(law, C, A, S))
    {
      const auto state = find_wrinkles(law, C, A, S);
      of_wrinkles = material::compute_wrinkle_energy(state, C);
      C = state.metric;
    }
    at_voltage +=
        w * (of_wrinkles + material::energy(*law.elastomer, C, A, law.field));
    stored += w * (of_wrinkles + material::stored_energy(*law.elastomer, C, A));
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

template <unsigned int n_nodes>
void compute_wrinkled_metric(const BatchGeometry& geometry, const BatchLaw& law,
                             const double* positions, const double* internal,
                             double* metric)
{
  const std::size_t n_networks = law.elastomer->networks.size();
  compute_metric<n_nodes>(geometry, positions, metric);
  for (unsigned int q = 0; q < n_nodes; ++q)
  {
    const Tensor* A = as_tensors(internal) + n_networks * q;
    Tensor& C = as_tensors(metric)[q];
    const Tensor S = material::stress(*law.elastomer, C, A, law.field);
    if (wrinkles(law, C, A, S))
      C = find_wrinkles(law, C, A, S).metric;
  }
}
} // namespace

LimitCheck compute_forces(const BatchGeometry& geometry, const BatchLaw& law,
                          const double* positions, const double* internal,
                          double* forces, double* rates, BatchPower& power)
{
  return with_nodes(geometry.n_nodes,
                    [&](const auto n)
                    {
                      return compute_forces<n>(geometry, law, positions,
                                               internal, forces, rates, power);
                    });
}

LimitCheck compute_permittivity(const BatchGeometry& geometry,
                                const BatchLaw& law, const double* positions,
                                const double* internal, double* permittivity)
{
  return with_nodes(geometry.n_nodes,
                    [&](const auto n)
                    {
                      return compute_permittivity<n>(geometry, law, positions,
                                                     internal, permittivity);
                    });
}

void compute_force_change(const BatchGeometry& geometry, const BatchLaw& law,
                          const double* positions, const double* internal,
                          const double alpha, const double* r, double* forces)
{
  with_nodes(geometry.n_nodes,
             [&](const auto n)
             {
               compute_force_change<n>(geometry, law, positions, internal,
                                       alpha, r, forces);
             });
}

void compute_internal_change(const BatchGeometry& geometry, const BatchLaw& law,
                             const double* positions, const double* internal,
                             const double alpha, const double* dx,
                             const double* r, double* change)
{
  with_nodes(geometry.n_nodes,
             [&](const auto n)
             {
               compute_internal_change<n>(geometry, law, positions, internal,
                                          alpha, dx, r, change);
             });
}

void compute_energy(const BatchGeometry& geometry, const BatchLaw& law,
                    const double* positions, const double* internal,
                    BatchEnergy& energy)
{
  with_nodes(geometry.n_nodes,
             [&](const auto n) {
               compute_energy<n>(geometry, law, positions, internal, energy);
             });
}

void compute_metric(const BatchGeometry& geometry, const double* positions,
                    double* metric)
{
  with_nodes(geometry.n_nodes, [&](const auto n)
             { compute_metric<n>(geometry, positions, metric); });
}

void compute_wrinkled_metric(const BatchGeometry& geometry, const BatchLaw& law,
                             const double* positions, const double* internal,
                             double* metric)
{
  with_nodes(geometry.n_nodes,
             [&](const auto n) {
               compute_wrinkled_metric<n>(geometry, law, positions, internal,
                                          metric);
             });
}
} // namespace taut::fe
