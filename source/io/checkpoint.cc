#include <taut/base/exceptions.h>
#include <taut/io/checkpoint.h>

#include <algorithm>
#include <array>

#include <boost/crc.hpp>

namespace taut::io
{
namespace
{
using structure::Structure;

/// Sections and keys whose change leaves the physics of a run as it was.
constexpr std::array<const char*, 10> uncritical{
    {"Title", "Mesh/File", "Output/", "Checkpoint/", "Event ", "Comparison/",
     "Procedure/End time", "Procedure/Newton tolerance", "Procedure/Load steps",
     "Procedure/Integrator/"}};

bool is_critical(const std::string& path)
{
  return std::none_of(uncritical.begin(), uncritical.end(),
                      [&](const std::string& start)
                      { return path.compare(0, start.size(), start) == 0; });
}

std::uint32_t compute_checksum(const fe::MeshData& mesh)
{
  const auto bytes = dealii::Utilities::pack(mesh, false);
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

/// Values of free unknowns on all local nodes, zero elsewhere.
fe::NodalVector spread(const Structure& structure, const double* free)
{
  auto nodal = structure.nodes().make_vector();
  structure.prolong(free, nodal);
  nodal.update_ghost_values();
  return nodal;
}

void append(const fe::NodalVector& nodal, const fe::LocalNode node,
            std::vector<double>& values)
{
  for (unsigned int c = 0; c < 3; ++c)
    values.push_back(fe::entry(nodal, 3 * node + c));
}

/// The nodes of bars, frames and rigid bodies, which every rank sees.
std::vector<fe::LocalNode> get_extra_nodes(const fe::Nodes& nodes)
{
  std::vector<fe::LocalNode> extra;
  for (auto node = nodes.first_extra; node < nodes.n_global; ++node)
    extra.push_back(nodes.local(node));
  return extra;
}

std::vector<double> get_extra_values(const fe::Nodes& nodes,
                                     const fe::NodalVector& nodal)
{
  std::vector<double> values;
  for (const fe::LocalNode node : get_extra_nodes(nodes))
    append(nodal, node, values);
  return values;
}

std::size_t count_internal(const Structure& structure, const unsigned int cell)
{
  return 3ul * structure.cells().element().n_nodes *
         structure.cells().n_networks(cell);
}

/// Calls function(index among this rank's cells, address).
template <typename Function>
void for_each_cell(const Structure& structure, const Function& function)
{
  unsigned int index = 0;
  for (const auto& cell : structure.dof_handler().active_cell_iterators())
    if (cell->is_locally_owned())
      function(index++, get_address(cell));
}

/// The cells of all ranks, on the first.
std::vector<CellState> gather_cells(const Structure& structure,
                                    const fe::NodalVector& displacements,
                                    const fe::NodalVector* velocities,
                                    const double* internal)
{
  std::vector<CellState> own;
  for_each_cell(structure,
                [&](const unsigned int index, const CellAddress& address)
                {
                  CellState cell;
                  cell.address = address;
                  for (const auto node : structure.cells().cells()[index].nodes)
                  {
                    append(displacements, node, cell.displacements);
                    if (velocities)
                      append(*velocities, node, cell.velocities);
                  }
                  const double* A =
                      internal + structure.cells().first_internal(index);
                  cell.internal.assign(A, A + count_internal(structure, index));
                  own.push_back(std::move(cell));
                });
  std::vector<CellState> all;
  for (auto& part :
       dealii::Utilities::MPI::gather(structure.communicator(), own, 0))
    std::move(part.begin(), part.end(), std::back_inserter(all));
  std::sort(all.begin(), all.end(),
            [](const CellState& a, const CellState& b)
            { return a.address < b.address; });
  return all;
}

[[noreturn]] void refuse_state()
{
  throw BadInput("the state of the checkpoint does not fit the case");
}

/// Sets the owned nodes among `nodes` to `values`.
void set_owned(const fe::Nodes& all, const std::vector<fe::LocalNode>& nodes,
               const std::vector<double>& values, fe::NodalVector& nodal)
{
  if (values.size() != 3 * nodes.size())
    refuse_state();
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (unsigned int c = 0; c < 3 && nodes[i] < all.n_owned; ++c)
      fe::entry(nodal, 3 * nodes[i] + c) = values[3 * i + c];
}

std::map<CellAddress, const CellState*> index_cells(const StoredRun& run)
{
  std::map<CellAddress, const CellState*> index;
  for (const CellState& cell : run.cells)
    index[cell.address] = &cell;
  return index;
}

/// The stored states of this rank's cells, in their order.
std::vector<const CellState*> find_cells(const StoredRun& run,
                                         const Structure& structure)
{
  const auto index = index_cells(run);
  std::vector<const CellState*> own;
  for_each_cell(structure,
                [&](unsigned int, const CellAddress& address)
                {
                  const auto found = index.find(address);
                  if (found == index.end())
                    refuse_state();
                  own.push_back(found->second);
                });
  return own;
}

/// The free unknowns of this rank from nodal values of cells and extra nodes.
std::vector<double> restore_unknowns(const std::vector<const CellState*>& own,
                                     std::vector<double> CellState::*values,
                                     const std::vector<double>& extra_values,
                                     const Structure& structure)
{
  const fe::Nodes& nodes = structure.nodes();
  auto nodal = nodes.make_vector();
  for (std::size_t i = 0; i < own.size(); ++i)
    set_owned(nodes, structure.cells().cells()[i].nodes, own[i]->*values,
              nodal);
  set_owned(nodes, get_extra_nodes(nodes), extra_values, nodal);
  std::vector<double> free(structure.n_free());
  structure.restrict(nodal, free.data());
  return free;
}
} // namespace

CriticalParameters get_critical_parameters(const CaseFile& case_file)
{
  CriticalParameters critical;
  for (const ChangedParameter& parameter : case_file.changed_parameters)
    if (is_critical(parameter.path))
      critical[parameter.path] = parameter.value;
  return critical;
}

StoredRun collect_run(const CriticalParameters& parameters,
                      const study::RunProgress& progress,
                      structure::StructureSystem& system, const double* state)
{
  const Structure& structure = system.structure();
  StoredRun run;
  run.progress = progress;
  run.parameters = parameters;
  run.mesh_checksum = compute_checksum(structure.mesh());
  const auto displacements = spread(structure, state);
  run.extra_displacements = get_extra_values(structure.nodes(), displacements);
  fe::NodalVector velocities;
  const bool has_velocities = system.velocities(state) != nullptr;
  if (has_velocities)
  {
    velocities = spread(structure, system.velocities(state));
    run.extra_velocities = get_extra_values(structure.nodes(), velocities);
  }
  run.cells = gather_cells(structure, displacements,
                           has_velocities ? &velocities : nullptr,
                           system.internal(state));
  // Both lie side by side at the end of the state.
  const double* end = system.scalars(state) + system.layout().scalars;
  run.scalars.assign(end - system.layout().scalars - system.layout().globals,
                     end);
  return run;
}

void check_parameters(const StoredRun& run, const CaseFile& case_file)
{
  const CriticalParameters now = get_critical_parameters(case_file);
  std::map<std::string, std::array<std::string, 2>> both;
  for (const auto& [path, value] : run.parameters)
    both[path][0] = value;
  for (const auto& [path, value] : now)
    both[path][1] = value;
  const auto quote = [](const std::string& value)
  { return value.empty() ? "the default" : "'" + value + "'"; };
  for (const auto& [path, values] : both)
    if (values[0] != values[1])
      throw BadInput("the run to be resumed had " + quote(values[0]) +
                         ", the case now has " + quote(values[1]) +
                         ": change it back, or start a new run",
                     case_file.content.file, 0, path);
}

void restore_refinement(const StoredRun& run, const fe::MeshData& mesh,
                        fe::Triangulation& triangulation)
{
  if (compute_checksum(mesh) != run.mesh_checksum)
    throw BadInput("the mesh is not the one of the run to be resumed: change "
                   "it back, or start a new run");
  std::set<CellAddress> cells;
  for (const CellState& cell : run.cells)
    cells.insert(cell.address);
  refine_to(cells, triangulation);
}

study::Checkpoint restore_state(const StoredRun& run,
                                const Structure& structure)
{
  study::Checkpoint checkpoint;
  checkpoint.progress = run.progress;
  auto& state = checkpoint.state;
  const auto add = [&](const std::vector<double>& part)
  { state.insert(state.end(), part.begin(), part.end()); };
  const auto own = find_cells(run, structure);
  add(restore_unknowns(own, &CellState::displacements, run.extra_displacements,
                       structure));
  if (!run.cells.front().velocities.empty())
    add(restore_unknowns(own, &CellState::velocities, run.extra_velocities,
                         structure));
  for (unsigned int i = 0; i < own.size(); ++i)
  {
    if (own[i]->internal.size() != count_internal(structure, i))
      refuse_state();
    add(own[i]->internal);
  }
  if (dealii::Utilities::MPI::this_mpi_process(structure.communicator()) == 0)
    add(run.scalars);
  return checkpoint;
}
} // namespace taut::io
