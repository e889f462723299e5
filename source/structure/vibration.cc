#include <taut/structure/vibration.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "vibration_matrices.h"

namespace taut::structure
{
namespace
{
/// Far slower and far faster than all that relaxes (1/s, s): what the kernel's
/// quotients of a rate and relaxation times take as 0 and infinity.
constexpr double slowest = 1e-20;
constexpr double never = 1e40;
constexpr double at_once = 1e-40;

/// Relaxation times that differ by less are equal.
constexpr double same = 1e-9;
} // namespace

Vibration::Vibration(Structure& structure, const LoadState& loads,
                     const double* u, const double* internal)
    : structure_(structure), loads_(loads), u_(u, u + structure.n_free()),
      internal_(internal, internal + structure.n_internal()),
      matrices_(std::make_unique<VibrationMatrices>(structure.nodes()))
{
  structure_.set_tangent_state(loads_, u_.data(), internal_.data(),
                               Networks::as_given);
  laws_ = structure_.tangent_laws_;
  for (unsigned int e = 0; e < loads_.voltages.size(); ++e)
    if (loads_.charge_is_given[e])
      columns_.push_back(structure_.make_column(e, loads_, Networks::as_given));
  find_relaxations();
  make_mass();
  make_unit_inertia();
  freeze();
}

Vibration::~Vibration() = default;

MPI_Comm Vibration::communicator() const
{
  return structure_.communicator();
}

std::size_t Vibration::n_unknowns() const
{
  return structure_.n_free();
}

unsigned int Vibration::find_relaxation(const double time) const
{
  unsigned int i = 0;
  while (i < n_times_ && std::abs(relaxations_[i].time - time) > same * time)
    ++i;
  return i;
}

void Vibration::find_relaxations()
{
  for (const fe::BatchLaw& law : laws_)
    for (const material::Network& network : law.elastomer->networks)
      if (find_relaxation(network.relaxation_time) == n_times_)
      {
        ++n_times_;
        relaxations_.push_back(
            {"network " + std::to_string(n_times_), network.relaxation_time});
      }
  for (const auto& column : columns_)
    if (column.conductance > 0)
      relaxations_.push_back(
          {"circuit " + structure_.device().electrodes[column.electrode].name,
           column.capacitance / column.conductance});
}

void Vibration::make_mass()
{
  fe::TangentMatrix mass(structure_.nodes(), structure_.cells(),
                         structure_.get_frame_elements(),
                         fe::TangentMatrix::Coupling::full);
  mass.begin();
  fe::add_mass(structure_.cells(), structure_.get_densities(), mass);
  structure_.add_bar_masses(mass);
  structure_.frames_->add_mass(false, mass);
  structure_.add_point_masses(1, mass);
  structure_.for_each_rotation(
      [&](const fe::Rotation& rotation, const RotaryInertia& inertia)
      {
        const auto q =
            fe::get_quaternion(rotation, structure_.tangent_positions_);
        add_rotation_block(rotation, compute_tangential(inertia.inertia, q),
                           mass);
      });
  mass.end();
  matrices_->set_mass(mass.get(), structure_.tangent_positions_);
}

void Vibration::make_unit_inertia()
{
  const fe::Nodes& nodes = structure_.nodes();
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    std::array<double, 3> direction{};
    direction[axis] = 1;
    auto inertia = nodes.make_vector();
    structure_.add_weight(direction, inertia);
    double mass = 0;
    for (std::size_t i = 0; i < 3 * nodes.n_local; ++i)
      mass += fe::entry(inertia, i);
    total_mass_ = structure_.sum(mass);
    fe::collect_forces(nodes, &structure_.tangent_positions_, inertia);
    inertia.compress(dealii::VectorOperation::add);
    unit_inertia_[axis].resize(n_unknowns());
    structure_.restrict(inertia, unit_inertia_[axis].data());
  }
}

std::vector<fe::BatchLaw>
Vibration::make_laws(const std::vector<double>& relaxation_times) const
{
  auto laws = laws_;
  for (fe::BatchLaw& law : laws)
  {
    auto elastomer = std::make_shared<material::Elastomer>(*law.elastomer);
    for (material::Network& network : elastomer->networks)
      network.relaxation_time =
          relaxation_times[find_relaxation(network.relaxation_time)];
    law.elastomer = elastomer.get();
    law.owned = std::move(elastomer);
  }
  return laws;
}

void Vibration::assemble(const double rate,
                         const std::vector<fe::BatchLaw>& laws,
                         const std::vector<bool>& held)
{
  structure_.set_tangent_state(loads_, u_.data(), internal_.data(),
                               Networks::as_given);
  structure_.tangent_laws_ = laws;
  fe::TangentRequest request{&structure_.tangent_positions_, internal_.data()};
  request.alpha = rate;
  request.symmetric = false;
  request.exact = true;
  structure_.assemble(request);
  asymmetry_ = matrices_->set_stiffness(structure_.tangent_->get());
  border_.reset(communicator(), rate);
  std::size_t circuit = n_times_;
  for (SourceBorder::Column column : columns_)
  {
    if (column.conductance > 0 && held[circuit++])
      column.conductance = 0;
    border_.add(column);
  }
}

void Vibration::freeze()
{
  assemble(std::numeric_limits<double>::infinity(), laws_,
           std::vector<bool>(relaxations_.size(), true));
}

void Vibration::relax()
{
  assemble(slowest, make_laws(std::vector<double>(n_times_, at_once)),
           std::vector<bool>(relaxations_.size(), false));
}

void Vibration::flow(const std::size_t relaxation, const double rate)
{
  std::vector<double> times(n_times_, never);
  std::vector<bool> held(relaxations_.size(), true);
  held.at(relaxation) = false;
  if (!is_circuit(relaxation))
    times[relaxation] = relaxations_[relaxation].time;
  assemble(std::max(rate, slowest), make_laws(times), held);
}

void Vibration::multiply_mass(const double* x, double* result)
{
  structure_.multiply_with(matrices_->mass(), x, result);
}

void Vibration::multiply_stiffness(const double* x, double* result) const
{
  structure_.multiply_with(matrices_->stiffness(), x, result);
  border_.add_product(x, result);
}

int Vibration::factorise(const double shift)
{
  fe::LinearSolver& solver = matrices_->factorise(shift);
  border_.eliminate([&](double* x) { structure_.solve_with(solver, x, x); });
  return solver.count_negative_eigenvalues() -
         border_.count_removed_negative_eigenvalues();
}

void Vibration::solve(const double* r, double* d)
{
  structure_.solve_with(matrices_->solver(), r, d);
  border_.correct(d);
}

bool Vibration::has_damping() const
{
  return structure_.has_drag() || structure_.has_frame_damping();
}

void Vibration::multiply_damping(const double* x, double* result)
{
  std::fill_n(result, n_unknowns(), 0.);
  if (structure_.has_drag())
    structure_.multiply_drag(x, result);
  if (structure_.has_frame_damping())
    structure_.add_frame_damping_product(x, result);
}

std::vector<double> Vibration::compute_motion(const double* x) const
{
  auto motion = structure_.nodes().make_vector();
  structure_.prolong(x, motion);
  motion.update_ghost_values();
  fe::distribute_change(structure_.nodes(), &structure_.tangent_positions_,
                        motion);
  return {motion.begin(), motion.begin() + 3 * structure_.nodes().n_local};
}

double Vibration::compute_largest(const std::vector<double>& motion) const
{
  double square = 0;
  const auto look_at = [&](const fe::LocalNode node)
  {
    double sum = 0;
    for (unsigned int c = 0; c < 3; ++c)
      sum += std::pow(motion[3 * node + c], 2);
    square = std::max(square, sum);
  };
  for (const auto& cell : structure_.cells().cells())
    for (const auto node : cell.nodes)
      look_at(node);
  for (const auto& element : structure_.frames().elements())
    for (const auto node : element.positions)
      look_at(node);
  return std::sqrt(dealii::Utilities::MPI::max(square, communicator()));
}

double Vibration::multiply(const double* x, const double* y) const
{
  return structure_.sum(std::inner_product(x, x + n_unknowns(), y, 0.));
}
} // namespace taut::structure
