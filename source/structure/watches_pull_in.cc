#include "watches_pull_in.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace taut::structure
{
namespace
{
std::unique_ptr<Structure> make_replica(const Structure& structure)
{
  // The handler knows its triangulation only as that of the base class.
  return std::make_unique<Structure>(
      structure.device(), structure.mesh(),
      dynamic_cast<const fe::Triangulation&>(
          structure.dof_handler().get_triangulation()));
}

LoadState without_voltages(LoadState loads)
{
  std::fill(loads.voltages.begin(), loads.voltages.end(), 0.);
  return loads;
}
} // namespace

PullInWatch::PullInWatch(StructureSystem& system, const EventDescription& event,
                         const Networks networks)
    : EventWatch(system, event), networks_(networks)
{
  const Device& device = system.structure().device();
  if (device.electrodes.empty())
    refuse("a device without electrodes has no pull-in");
  if (!event.of.empty())
    refuse("a pull-in is of the whole device; Of must stay empty, not '" +
           event.of + "'");
  if (!(event.threshold >= 0 && event.threshold < 1))
    refuse("the threshold of a pull-in is the share of the stiffness that is "
           "left, from 0 to below 1");
  replica_ = make_replica(system.structure());
}

double PullInWatch::Response::get_share() const
{
  if (stiffness == 0 && electric_stiffness == 0)
    return 1;
  return stiffness / (std::abs(stiffness) + std::abs(electric_stiffness));
}

double PullInWatch::compute_product(const std::vector<double>& a,
                                    const std::vector<double>& b) const
{
  return dealii::Utilities::MPI::sum(
      std::inner_product(a.begin(), a.end(), b.begin(), 0.),
      system_.communicator());
}

PullInWatch::Response PullInWatch::compute_response(const double time,
                                                    const double* state)
{
  const LoadState loads = get_loads(time, state);
  const LoadState bare = without_voltages(loads);
  const double* A = system_.internal(state);
  Structure& structure = *replica_;
  std::vector<double> forces(structure.n_free()), driving(forces.size());
  const auto compute_forces = [&](const LoadState& at, double* result)
  { structure.compute_forces(at, state, A, networks_, result, nullptr); };
  const auto multiply_bare = [&](const std::vector<double>& x)
  {
    std::vector<double> product(x.size());
    structure.multiply_tangent(bare, state, A, networks_, material::frozen,
                               false, true, x.data(), product.data());
    return product;
  };
  compute_forces(bare, driving.data());
  compute_forces(loads, forces.data());
  for (std::size_t i = 0; i < forces.size(); ++i)
    driving[i] = forces[i] - driving[i];
  Response response;
  response.direction.assign(forces.size(), 0.);
  if (compute_product(driving, driving) == 0)
    return response;
  // Beams take part of their tangent from the last time it was taken: here.
  if (!structure.frames().empty())
    multiply_bare(driving);
  structure.factorise(loads, state, A, networks_, material::frozen, false,
                      fe::LinearSolver::Kind::symmetric);
  structure.solve(driving.data(), response.direction.data());
  response.stiffness = compute_product(driving, response.direction);
  response.electric_stiffness =
      response.stiffness -
      compute_product(multiply_bare(response.direction), response.direction);
  response.push =
      compute_product(forces, response.direction) / response.stiffness;
  return response;
}

double PullInWatch::compute_margin(const Response& response) const
{
  const double margin =
      (response.get_share() - event_.threshold) / (1 - event_.threshold);
  if (!system_.has_inertia() || response.stiffness >= 0)
    return margin;
  return std::max(margin, std::min(1., -response.push));
}

double PullInWatch::compute_margin(const double time, const double* state)
{
  return compute_margin(compute_response(time, state));
}

EventReport PullInWatch::report(const double time, const double* state)
{
  const Response response = compute_response(time, state);
  EventReport report;
  report.value = response.get_share();
  report.threshold = event_.threshold;
  report.margin = compute_margin(response);
  locate(time, state, response, report);
  return report;
}

/// The place is where the film thins fastest as the device answers.
void PullInWatch::locate(const double time, const double* state,
                         const Response& response, EventReport& report)
{
  const LoadState loads = get_loads(time, state);
  const fe::FilmCells& cells = replica_->cells();
  const auto compute_areas = [&](const double by)
  {
    std::vector<double> u(state, state + response.direction.size());
    for (std::size_t i = 0; i < u.size(); ++i)
      u[i] += by * response.direction[i];
    std::vector<double> areas;
    for (const auto& [xx, yy, xy] : fe::compute_metric(
             cells, replica_->compute_positions(loads, u.data())))
      areas.push_back(xx * yy - xy * xy);
    return areas;
  };
  // A small part of the answer, outwards.
  const double step = response.stiffness < 0 ? -1e-6 : 1e-6;
  const auto before = compute_areas(-step), after = compute_areas(step);
  std::array<double, 5> found{-std::numeric_limits<double>::infinity()};
  const unsigned int n = cells.element().n_nodes;
  for (std::size_t i = 0; i < after.size(); ++i)
    if (const double growth = after[i] / before[i]; growth > found[0])
    {
      const auto point = cells.mesh_point(i / n, i % n);
      found = {growth, double(cells.cells()[i / n].film), point[0], point[1],
               point[2]};
    }
  const auto all =
      dealii::Utilities::MPI::all_gather(system_.communicator(), found);
  const auto& worst = *std::max_element(all.begin(), all.end(),
                                        [](const auto& a, const auto& b)
                                        { return a[0] < b[0]; });
  report.place =
      replica_->device().films[static_cast<std::size_t>(worst[1])].name;
  std::copy_n(worst.begin() + 2, 3, report.point.begin());
}
} // namespace taut::structure
