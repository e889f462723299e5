#include <taut/structure/frames.h>

#include <algorithm>
#include <cmath>

namespace taut::structure
{
namespace
{
using fe::BeamResultants;

/// Where an unknown of the beam, [x | Q], is among its nodes [positions |
/// vector parts | scalar parts] with three components each.
unsigned int get_component(const unsigned int unknown, const unsigned int n)
{
  if (unknown < 3 * n)
    return unknown;
  const unsigned int node = (unknown - 3 * n) / 4;
  const unsigned int part = (unknown - 3 * n) % 4;
  return part == 0 ? 3 * (2 * n + node) : 3 * (n + node) + part - 1;
}
} // namespace

std::vector<fe::LocalNode> FrameElement::get_nodes(const fe::Nodes& nodes) const
{
  std::vector<fe::LocalNode> all(positions);
  for (const auto rotation : rotations)
    all.push_back(nodes.rotations[rotation].vector);
  for (const auto rotation : rotations)
    all.push_back(nodes.rotations[rotation].scalar());
  return all;
}

Frames::Frames(const Device& device, const FrameNodes& frame_nodes,
               const fe::Nodes& nodes)
    : device_(device), nodes_(nodes)
{
  for (const auto& edge : frame_nodes.mesh.edges)
  {
    std::vector<fe::LocalNode> positions;
    std::vector<unsigned int> rotations;
    std::vector<fe::Coordinates> places;
    for (const auto place : edge.places)
    {
      const FrameNode& node = frame_nodes.nodes[place];
      positions.push_back(nodes.local(node.position));
      rotations.push_back(node.rotations.at(edge.frame));
      places.push_back(nodes.mesh_position[positions.back()]);
    }
    elements_.push_back(
        {edge.frame, fe::BeamElement(places, device.frames[edge.frame].normal),
         positions, rotations, positions[0] < nodes.n_owned});
  }
  linearised_.resize(elements_.size());
}

std::vector<double> Frames::gather(const FrameElement& element,
                                   const fe::NodalVector& values) const
{
  std::vector<double> unknowns;
  for (const auto node : element.positions)
    for (unsigned int c = 0; c < 3; ++c)
      unknowns.push_back(fe::entry(values, 3 * node + c));
  for (const auto rotation : element.rotations)
  {
    const Quaternion q = fe::get_quaternion(nodes_.rotations[rotation], values);
    unknowns.insert(unknowns.end(), q.begin(), q.end());
  }
  return unknowns;
}

void Frames::scatter(const FrameElement& element,
                     const std::vector<double>& forces,
                     fe::NodalVector& nodal) const
{
  const auto all = element.get_nodes(nodes_);
  for (unsigned int i = 0; i < forces.size(); ++i)
  {
    const unsigned int component = get_component(i, element.positions.size());
    fe::entry(nodal, 3 * all[component / 3] + component % 3) += forces[i];
  }
}

std::vector<BeamResultants>
Frames::compute_resultants(const fe::BeamStiffness& stiffness,
                           const std::vector<BeamResultants>& strains) const
{
  std::vector<BeamResultants> resultants(strains);
  for (auto& point : resultants)
    for (unsigned int i = 0; i < 6; ++i)
      point[i] *= stiffness[i];
  return resultants;
}

void Frames::add_forces(const LoadState& loads,
                        const fe::NodalVector& positions,
                        fe::NodalVector& forces) const
{
  // Of all frames, so that every rank meets a law out of its range.
  std::vector<fe::BeamStiffness> stiffnesses;
  for (unsigned int frame = 0; frame < device_.frames.size(); ++frame)
    stiffnesses.push_back(get_stiffness(frame, loads));
  for (const auto& element : elements_)
    if (element.assembled_here)
    {
      const auto unknowns = gather(element, positions);
      std::vector<double> f(unknowns.size(), 0.);
      element.beam.add_forces(
          unknowns.data(),
          compute_resultants(stiffnesses[element.frame],
                             element.beam.compute_strains(unknowns.data())),
          f.data());
      scatter(element, f, forces);
    }
}

void Frames::add_damping(const LoadState& loads,
                         const fe::NodalVector& positions,
                         const fe::NodalVector& rates,
                         fe::NodalVector& forces) const
{
  for (const auto& element : elements_)
  {
    const double time = device_.frames[element.frame].stiffness_damping;
    if (!element.assembled_here || time == 0)
      continue;
    const auto unknowns = gather(element, positions);
    const auto velocities = gather(element, rates);
    auto stiffness = get_stiffness(element.frame, loads);
    for (double& entry : stiffness)
      entry *= time;
    std::vector<double> f(unknowns.size(), 0.);
    element.beam.add_forces(
        unknowns.data(),
        compute_resultants(stiffness, element.beam.compute_strain_rates(
                                          unknowns.data(), velocities.data())),
        f.data());
    scatter(element, f, forces);
  }
}

double Frames::compute_energy(const LoadState& loads,
                              const fe::NodalVector& positions) const
{
  double energy = 0;
  for (const auto& element : elements_)
    if (element.assembled_here)
      energy += element.beam.compute_energy(
          get_stiffness(element.frame, loads),
          element.beam.compute_strains(gather(element, positions).data()));
  return energy;
}

std::vector<BeamResultants>
Frames::predict_strains(const std::size_t index,
                        const std::vector<double>& unknowns) const
{
  const fe::BeamElement& beam = elements_[index].beam;
  const std::vector<double>& last = linearised_[index];
  if (last.empty())
    return beam.compute_strains(unknowns.data());
  std::vector<double> step(unknowns);
  for (std::size_t i = 0; i < step.size(); ++i)
    step[i] -= last[i];
  auto strains = beam.compute_strains(last.data());
  const auto changes = beam.compute_strain_rates(last.data(), step.data());
  for (std::size_t q = 0; q < strains.size(); ++q)
    for (unsigned int i = 0; i < 6; ++i)
      strains[q][i] += changes[q][i];
  return strains;
}

void Frames::add_element(const FrameElement& element,
                         const std::vector<double>& beam,
                         const fe::NodalVector* positions,
                         fe::TangentMatrix& matrix) const
{
  const unsigned int n = element.positions.size();
  const unsigned int size = 7 * n, n_rows = 9 * n;
  std::vector<double> expanded(n_rows * n_rows, 0.);
  for (unsigned int i = 0; i < size; ++i)
    for (unsigned int j = 0; j < size; ++j)
      expanded[get_component(i, n) * n_rows + get_component(j, n)] =
          beam[i * size + j];
  matrix.add_element(element.get_nodes(nodes_), expanded.data(), positions);
}

std::vector<double> Frames::make_mass(const FrameElement& element,
                                      const double factor) const
{
  const unsigned int n = element.positions.size(), size = 7 * n;
  const double density = device_.frames[element.frame].section.mass_per_length;
  std::vector<double> products(n * n, 0.), mass(size * size, 0.);
  element.beam.add_shape_products(products.data());
  for (unsigned int a = 0; a < n; ++a)
    for (unsigned int b = 0; b < n; ++b)
      for (unsigned int c = 0; c < 3; ++c)
        mass[(3 * a + c) * size + 3 * b + c] =
            factor * density * products[a * n + b];
  return mass;
}

void Frames::add_stiffness(const LoadState& loads,
                           const fe::NodalVector& positions,
                           const double rate_factor, const double mass_factor,
                           const bool predicted, fe::TangentMatrix& matrix)
{
  for (std::size_t index = 0; index < elements_.size(); ++index)
  {
    const FrameElement& element = elements_[index];
    if (!element.assembled_here)
      continue;
    const Frame& frame = device_.frames[element.frame];
    const auto unknowns = gather(element, positions);
    auto stiffness = get_stiffness(element.frame, loads);
    const auto resultants = compute_resultants(
        stiffness, predicted ? predict_strains(index, unknowns)
                             : element.beam.compute_strains(unknowns.data()));
    for (double& entry : stiffness)
      entry *= 1 + rate_factor * frame.stiffness_damping;
    std::vector<double> K(unknowns.size() * unknowns.size(), 0.);
    element.beam.add_stiffness(unknowns.data(), stiffness, resultants,
                               K.data());
    add_element(element, K, &positions, matrix);
    if (predicted)
      linearised_[index] = unknowns;
    const double mass = mass_factor + rate_factor * frame.mass_damping;
    if (mass != 0)
      add_element(element, make_mass(element, mass), nullptr, matrix);
  }
}

void Frames::forget_linearisation()
{
  for (auto& unknowns : linearised_)
    unknowns.clear();
}

void Frames::add_mass(const bool damping, fe::TangentMatrix& matrix) const
{
  for (const auto& element : elements_)
    if (element.assembled_here)
      add_element(
          element,
          make_mass(element,
                    damping ? device_.frames[element.frame].mass_damping : 1.),
          nullptr, matrix);
}

void Frames::add_mass_product(const bool damping, const fe::NodalVector& x,
                              fe::NodalVector& result) const
{
  for (const auto& element : elements_)
  {
    if (!element.assembled_here)
      continue;
    const auto mass = make_mass(
        element, damping ? device_.frames[element.frame].mass_damping : 1.);
    const auto values = gather(element, x);
    std::vector<double> product(values.size(), 0.);
    for (std::size_t i = 0; i < values.size(); ++i)
      for (std::size_t j = 0; j < values.size(); ++j)
        product[i] += mass[i * values.size() + j] * values[j];
    scatter(element, product, result);
  }
}

void Frames::add_line_load(const std::array<double, 3>& load,
                           fe::NodalVector& forces) const
{
  for (const auto& element : elements_)
  {
    if (!element.assembled_here)
      continue;
    const auto lengths = element.beam.compute_nodal_lengths();
    for (unsigned int a = 0; a < lengths.size(); ++a)
      for (unsigned int c = 0; c < 3; ++c)
        fe::entry(forces, 3 * element.positions[a] + c) += lengths[a] * load[c];
  }
}

double Frames::compute_axial_spring_square() const
{
  double square = 0;
  for (const auto& element : elements_)
    if (element.assembled_here)
      square += std::pow(device_.frames[element.frame].section.axial_stiffness /
                             element.beam.length(),
                         2);
  return square;
}

void Frames::add_rotary_inertia(
    std::vector<std::array<double, 9>>& inertia,
    std::vector<std::array<double, 9>>& damping) const
{
  for (const auto& element : elements_)
  {
    if (!element.assembled_here)
      continue;
    const Frame& frame = device_.frames[element.frame];
    const auto lengths = element.beam.compute_nodal_lengths();
    for (unsigned int a = 0; a < lengths.size(); ++a)
    {
      const auto axes = element.beam.compute_axes(a);
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
          {
            const double share = lengths[a] * frame.section.rotary_inertia[k] *
                                 axes[k][i] * axes[k][j];
            inertia[element.rotations[a]][3 * i + j] += share;
            damping[element.rotations[a]][3 * i + j] +=
                frame.mass_damping * share;
          }
    }
  }
}

void Frames::add_rotation_stiffness(std::vector<double>& stiffness) const
{
  for (const auto& element : elements_)
  {
    if (!element.assembled_here)
      continue;
    const BeamSection& section = device_.frames[element.frame].section;
    const double turning = section.torsional_stiffness +
                           section.bending_stiffness[0] +
                           section.bending_stiffness[1];
    for (const auto rotation : element.rotations)
    {
      const double length = nodes_.rotations[rotation].length;
      stiffness[rotation] +=
          4 * turning / (element.beam.length() * length * length);
    }
  }
}
} // namespace taut::structure
