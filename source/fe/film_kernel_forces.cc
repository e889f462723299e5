#include <limits>
#include <vector>

#include "film_kernel_detail.h"

namespace taut::fe
{
namespace
{
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
      material::rates(*law.elastomer, C, A, as_tensors(rates) + n_networks * q);
      dissipation += w * material::dissipation(*law.elastomer, C, A);
    }
  }
  *as_lanes(power.dissipation) = dissipation;
  *as_lanes(power.permittivity) = permittivity;
  return check;
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
} // namespace taut::fe
