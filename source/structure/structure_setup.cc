#include <taut/base/exceptions.h>
#include <taut/base/nearest_name.h>
#include <taut/structure/film_laws.h>
#include <taut/structure/structure.h>

#include <deal.II/fe/fe_q.h>

#include <cmath>
#include <map>
#include <set>

namespace taut::structure
{
namespace
{
/// Ids of the sets of a dimension in which any of `groups` takes part.
std::set<unsigned int> find_groups(const unsigned int dimension,
                                   const std::vector<std::string>& groups,
                                   const fe::MeshData& mesh, const Named& entry,
                                   const std::string& key)
{
  std::set<unsigned int> ids;
  for (const auto& group : groups)
    try
    {
      ids.merge(mesh.groups.get_ids(dimension, group));
    }
    catch (const BadInput& error)
    {
      throw BadInput(error.message(), "", entry.source_line,
                     key + " " + entry.name);
    }
  return ids;
}

/// Surface set id -> index of the entry that uses it.
template <typename Entry>
std::map<unsigned int, unsigned int>
map_surfaces(const std::vector<Entry>& entries, const fe::MeshData& mesh,
             const std::string& key)
{
  std::map<unsigned int, unsigned int> owner;
  for (unsigned int i = 0; i < entries.size(); ++i)
    for (const auto id :
         find_groups(2, entries[i].groups, mesh, entries[i], key))
      if (!owner.insert({id, i}).second)
        throw BadInput("it shares a surface with '" + entries[owner[id]].name +
                           "'",
                       "", entries[i].source_line, key + " " + entries[i].name);
  return owner;
}

/// nodal += share * integral of N_a direction over one line.
void add_line_load(const fe::ReferenceElement& element,
                   const std::vector<unsigned int>& line,
                   const std::vector<fe::LocalNode>& cell_nodes,
                   const std::vector<std::array<double, 3>>& positions,
                   const std::array<double, 3>& direction, const double share,
                   fe::NodalVector& nodal)
{
  const std::size_t n = line.size();
  for (unsigned int q = 0; q < element.line_weights.size(); ++q)
  {
    std::array<double, 3> tangent{};
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int c = 0; c < 3; ++c)
        tangent[c] += element.line_gradients[q * n + k] *
                      positions[cell_nodes[line[k]]][c];
    const double length = std::hypot(tangent[0], tangent[1], tangent[2]) *
                          element.line_weights[q] * share;
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int c = 0; c < 3; ++c)
        fe::entry(nodal, 3 * cell_nodes[line[k]] + c) +=
            length * element.line_values[q * n + k] * direction[c];
  }
}

[[noreturn]] void refuse_bare_surface(const std::set<std::string>& groups)
{
  std::string names;
  for (const auto& group : groups)
    names += (names.empty() ? "'" : ", '") + group + "'";
  throw BadInput("no film covers the surface of the group " +
                 (names.empty() ? "without a name" : names));
}
} // namespace

Structure::Structure(const Device& device, const fe::MeshData& mesh,
                     const fe::Triangulation& triangulation)
    : device_(add_fibres(device)), mesh_(mesh), dof_handler_(triangulation)
{
  dof_handler_.distribute_dofs(dealii::FE_Q<2, 3>(device_.mesh.degree));
  device_nodes_ = make_device_nodes(device_, mesh_, dof_handler_);
  for (const auto& film : device_.films)
    relaxed_.push_back(material::relaxed(film.material));
  make_cells();
  make_source_scales();
  for (fe::LocalNode node = 0; node < nodes().n_owned; ++node)
    for (unsigned int c = 0; c < 3; ++c)
      if (!nodes().dependent[node] && !(nodes().held[node] >> c & 1))
        free_.push_back(3 * node + c);
  free_index_.assign(3 * nodes().n_owned, -1);
  for (unsigned int i = 0; i < free_.size(); ++i)
    free_index_[free_[i]] = i;
  for (auto* vector : {&positions_, &forces_, &pressure_forces_, &dead_forces_,
                       &weight_, &tangent_positions_})
    *vector = nodes().make_vector();
  make_frames();
  add_weight(device_.environment.gravity, weight_);
  least_force_ = compute_least_force();
  round_off_force_ = compute_round_off_force();
  // Growing would copy the vectors, which leaves their shares at ghosts out.
  edges_.reserve(device_.edge_loads.size());
  for (const auto& load : device_.edge_loads)
    edges_.push_back(make_edge_load(load));
  for (const auto& pressure : device_.pressures)
  {
    find_groups(2, pressure.groups, mesh_, pressure, "Pressure");
    pressures_.push_back(make_pressure(pressure.groups));
  }
}

Structure::~Structure() = default;

void Structure::make_cells()
{
  std::vector<fe::FilmSection> sections;
  for (const auto& film : device_.films)
    sections.push_back({&film.material, film.thickness, film.pre_stretch,
                        film.axis, film.temperature.value(0),
                        film.tension_field});
  const auto film_of = map_surfaces(device_.films, mesh_, "Film");
  const auto electrode_of =
      map_surfaces(device_.electrodes, mesh_, "Electrode");
  std::vector<fe::FilmCell> cells;
  std::vector<dealii::types::global_dof_index> dofs(
      dof_handler_.get_fe().n_dofs_per_cell());
  for (const auto& cell : dof_handler_.active_cell_iterators())
  {
    if (!cell->is_locally_owned() || mesh_.only_lines)
      continue;
    const unsigned int id = cell->material_id();
    if (film_of.count(id) == 0)
      refuse_bare_surface(mesh_.groups.get_set(2, id));
    fe::FilmCell film_cell;
    film_cell.film = film_of.at(id);
    if (const auto found = electrode_of.find(id); found != electrode_of.end())
      film_cell.electrode = found->second;
    cell->get_dof_indices(dofs);
    for (const auto dof : dofs)
      film_cell.nodes.push_back(nodes().local(dof));
    cells.push_back(film_cell);
  }
  cells_ = std::make_unique<fe::FilmCells>(device_.mesh.degree, sections, cells,
                                           nodes().mesh_position);
}

fe::PressureLoad
Structure::make_pressure(const std::vector<std::string>& groups) const
{
  std::set<unsigned int> ids;
  for (const auto& group : groups)
    ids.merge(mesh_.groups.get_ids(2, group));
  std::vector<bool> loaded;
  for (const auto& cell : dof_handler_.active_cell_iterators())
    if (cell->is_locally_owned())
      loaded.push_back(ids.count(cell->material_id()) > 0);
  fe::PressureLoad load;
  for (unsigned int b = 0; b < cells_->batches().size(); ++b)
  {
    const fe::FilmBatch& batch = cells_->batches()[b];
    fe::PressureLoad::Lanes lanes{b, {}};
    bool any = false;
    for (unsigned int lane = 0; lane < batch.n_cells; ++lane)
      if (loaded[batch.cells[lane]])
      {
        lanes.active[lane] = cells_->cells()[batch.cells[lane]].orientation;
        any = true;
      }
    if (any)
      load.batches.push_back(lanes);
  }
  return load;
}

void Structure::add_weight(const std::array<double, 3>& gravity,
                           fe::NodalVector& weight) const
{
  auto nodal = nodes().make_vector();
  for (fe::LocalNode node = 0; node < nodes().n_local; ++node)
    for (unsigned int c = 0; c < 3; ++c)
      fe::entry(nodal, 3 * node + c) = gravity[c];
  fe::add_mass_product(*cells_, get_densities(), nodal, weight);
  for (const auto& bar : nodes().bars)
    if (bar.centre < nodes().n_owned)
      for (unsigned int c = 0; c < 3; ++c)
        fe::entry(weight, 3 * bar.centre + c) += bar.mass * gravity[c];
  add_frame_weight(nodal, weight);
}

double Structure::compute_least_force() const
{
  // A stress G pulls at a node of a cell of size h with about G H h: the sum of
  // the squares is G^2 H^2 times the area of the mesh.
  double square = 0;
  for (unsigned int cell = 0; cell < cells_->cells().size(); ++cell)
  {
    const Film& film = device_.films[cells_->cells()[cell].film];
    const double modulus = material::shear_modulus(film.material);
    for (unsigned int q = 0; q < cells_->element().weights.size(); ++q)
      square += modulus * modulus * film.thickness * film.pre_stretch[0] *
                film.pre_stretch[1] * cells_->volume(cell, q);
  }
  return 1e-3 * std::sqrt(sum(square));
}

fe::NodalVector Structure::make_edge_load(const EdgeLoad& load) const
{
  const auto ids = find_groups(1, load.groups, mesh_, load, "Edge load");
  const fe::ReferenceElement& element = cells_->element();
  auto nodal = nodes().make_vector();
  unsigned int index = 0;
  for (const auto& cell : dof_handler_.active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    const auto& cell_nodes = cells_->cells()[index++].nodes;
    for (const unsigned int face : cell->face_indices())
      if (ids.count(cell->face(face)->manifold_id()) > 0)
        // An interior line is seen from both sides.
        add_line_load(element, element.face_nodes[face], cell_nodes,
                      nodes().mesh_position, load.direction,
                      cell->at_boundary(face) ? 1 : 0.5, nodal);
  }
  return nodal;
}
} // namespace taut::structure
