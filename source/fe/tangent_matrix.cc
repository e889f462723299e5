#include <taut/base/exceptions.h>
#include <taut/fe/petsc.h>
#include <taut/fe/tangent_matrix.h>

#include <deal.II/base/index_set.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <algorithm>
#include <cmath>

namespace taut::fe
{
void check_petsc(const PetscErrorCode code, const char* call)
{
  if (code == 0)
    return;
  const char* text = nullptr;
  PetscErrorMessage(code, &text, nullptr);
  throw SolverFailed(std::string("PETSc: ") + call + ": " +
                     (text ? text : "unknown error"));
}

namespace
{
using Block = std::array<double, 9>;

Block make_identity(const double factor)
{
  return {factor, 0, 0, 0, factor, 0, 0, 0, factor};
}

/// a^T b.
Block multiply_transposed(const Block& a, const double* b)
{
  Block result;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      result[3 * i + j] =
          a[i] * b[j] + a[3 + i] * b[3 + j] + a[6 + i] * b[6 + j];
  return result;
}

/// a b.
Block multiply(const Block& a, const Block& b)
{
  Block result;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      result[3 * i + j] =
          a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
  return result;
}

Block scale(Block block, const double factor)
{
  for (double& entry : block)
    entry *= factor;
  return block;
}

/// d(|d_0| n)/dd at the bar's current director.
Block make_turn(const Bar& bar, const NodalVector& positions)
{
  std::array<double, 3> d;
  double square = 0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    d[i] = entry(positions, 3 * bar.director + i);
    square += d[i] * d[i];
  }
  const double factor = bar.half_length / std::sqrt(square);
  Block result;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      result[3 * i + j] = factor * ((i == j) - d[i] * d[j] / square);
  return result;
}

/// First entry of the 3 x 3 block (row, column) of a CSR matrix whose three
/// rows of a node have the same columns; -1 if there is none.
int find_entry(const PetscInt* row_start, const PetscInt* columns,
               const int row, const int column)
{
  const auto begin = columns + row_start[row];
  const auto end = columns + row_start[row + 1];
  const auto found = std::lower_bound(begin, end, column);
  return (found == end || *found != column) ? -1 : int(found - columns);
}
} // namespace

TangentMatrix::TangentMatrix(
    const Nodes& nodes, const FilmCells& cells,
    const std::vector<std::vector<LocalNode>>& elements,
    const Coupling coupling)
    : nodes_(nodes), cells_(cells), coupling_(coupling),
      hanging_index_(nodes.n_local, -1), bar_index_(nodes.n_local, -1),
      follower_index_(nodes.n_local, -1)
{
  for (unsigned int i = 0; i < nodes.followers.size(); ++i)
    follower_index_[nodes.followers[i].node] = i;
  for (unsigned int i = 0; i < nodes.hanging.size(); ++i)
    hanging_index_[nodes.hanging[i].node] = i;
  for (unsigned int i = 0; i < nodes.on_bar.size(); ++i)
    bar_index_[nodes.on_bar[i].node] = i;
  for (const auto& cell : cells.cells())
    folded_.push_back(std::any_of(cell.nodes.begin(), cell.nodes.end(),
                                  [&](const LocalNode node)
                                  {
                                    return coupling == Coupling::components ||
                                           nodes.dependent[node] ||
                                           nodes.held[node] ||
                                           node >= nodes.n_owned;
                                  }));
  for (const auto& batch : cells.batches())
  {
    std::vector<Term> terms;
    for (unsigned int lane = 0; lane < batch.n_cells; ++lane)
      for (const auto node : cells.cells()[batch.cells[lane]].nodes)
        expand(node, nullptr, 1, terms);
    turns_.push_back(std::any_of(terms.begin(), terms.end(),
                                 [](const Term& term) { return term.turns; }));
  }
  create(elements);
  find_positions();
}

TangentMatrix::~TangentMatrix()
{
  MatDestroy(&matrix_);
}

void TangentMatrix::expand(const LocalNode node, const NodalVector* positions,
                           const double weight, std::vector<Term>& terms) const
{
  if (hanging_index_[node] >= 0)
    for (const auto& [master, factor] :
         nodes_.hanging[hanging_index_[node]].masters)
      expand(master, positions, weight * factor, terms);
  else if (bar_index_[node] >= 0)
  {
    const BarNode& on_bar = nodes_.on_bar[bar_index_[node]];
    const Bar& bar = nodes_.bars[on_bar.bar];
    const Block block =
        positions ? make_turn(bar, *positions) : make_identity(1);
    terms.push_back({bar.centre, make_identity(weight), true});
    terms.push_back(
        {bar.director, scale(block, weight * on_bar.fraction), true});
  }
  else if (follower_index_[node] >= 0)
  {
    const Follower& follower = nodes_.followers[follower_index_[node]];
    const Rotation& rotation = nodes_.rotations[follower.rotation];
    terms.push_back({follower.centre, make_identity(weight), true});
    Block by_vector{}, by_scalar{};
    if (positions)
    {
      const auto derivative = compute_arm_derivative(
          get_quaternion(rotation, *positions), follower.arm);
      by_vector = scale(derivative.by_vector, weight);
      for (unsigned int i = 0; i < 3; ++i)
        by_scalar[3 * i] = weight * derivative.by_scalar[i];
    }
    terms.push_back({rotation.vector, by_vector, true});
    terms.push_back({rotation.scalar(), by_scalar, true});
  }
  else
    terms.push_back({node, make_identity(weight), false});
}

void TangentMatrix::create(const std::vector<std::vector<LocalNode>>& elements)
{
  using dealii::types::global_dof_index;
  dealii::IndexSet owned(nodes_.n_global), relevant(nodes_.n_global);
  owned.add_range(nodes_.first_owned, nodes_.first_owned + nodes_.n_owned);
  relevant.add_range(nodes_.first_owned, nodes_.first_owned + nodes_.n_owned);
  relevant.add_indices(nodes_.ghosts.begin(), nodes_.ghosts.end());
  dealii::DynamicSparsityPattern pattern(nodes_.n_global, nodes_.n_global,
                                         relevant);
  const auto couple = [&](const std::vector<LocalNode>& members)
  {
    std::vector<Term> terms;
    for (const auto node : members)
      expand(node, nullptr, 1, terms);
    for (const auto& a : terms)
      for (const auto& b : terms)
        pattern.add(nodes_.global(a.master), nodes_.global(b.master));
  };
  for (const auto& cell : cells_.cells())
    couple(cell.nodes);
  for (const auto& element : elements)
    couple(element);
  for (const auto& rotation : nodes_.rotations)
    couple({rotation.vector, rotation.scalar()});
  for (const auto& bar : nodes_.bars)
    for (const LocalNode a : {bar.centre, bar.director})
      if (a < nodes_.n_local)
        for (const LocalNode b : {bar.centre, bar.director})
          pattern.add(nodes_.global(a), nodes_.global(b));
  for (LocalNode node = 0; node < nodes_.n_owned; ++node)
    pattern.add(nodes_.global(node), nodes_.global(node));
  const MPI_Comm comm = nodes_.partitioner->get_mpi_communicator();
  dealii::SparsityTools::distribute_sparsity_pattern(pattern, owned, comm,
                                                     relevant);

  std::vector<PetscInt> row_start{0}, columns;
  for (LocalNode node = 0; node < nodes_.n_owned; ++node)
  {
    const global_dof_index row = nodes_.global(node);
    for (unsigned int i = 0; i < 3; ++i)
    {
      for (unsigned int k = 0; k < pattern.row_length(row); ++k)
        for (unsigned int j = 0; j < 3; ++j)
          if (i == j || coupling_ == Coupling::full)
            columns.push_back(3 * pattern.column_number(row, k) + j);
      row_start.push_back(columns.size());
    }
  }
  TAUT_PETSC(MatCreate(comm, &matrix_));
  TAUT_PETSC(MatSetSizes(matrix_, 3 * nodes_.n_owned, 3 * nodes_.n_owned,
                         3 * nodes_.n_global, 3 * nodes_.n_global));
  TAUT_PETSC(MatSetBlockSize(matrix_, 3));
  TAUT_PETSC(MatSetType(matrix_, MATAIJ));
  TAUT_PETSC(MatSeqAIJSetPreallocationCSR(matrix_, row_start.data(),
                                          columns.data(), nullptr));
  TAUT_PETSC(MatMPIAIJSetPreallocationCSR(matrix_, row_start.data(),
                                          columns.data(), nullptr));
  TAUT_PETSC(MatSetOption(matrix_, MAT_NEW_NONZERO_LOCATION_ERR, PETSC_TRUE));
  TAUT_PETSC(MatSetOption(matrix_, MAT_SYMMETRIC, PETSC_FALSE));
}

void TangentMatrix::find_positions()
{
  PetscBool parallel = PETSC_FALSE;
  TAUT_PETSC(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(matrix_),
                                    MATMPIAIJ, &parallel));
  local_ = matrix_;
  if (parallel)
    TAUT_PETSC(MatMPIAIJGetSeqAIJ(matrix_, &local_, nullptr, nullptr));
  PetscInt n_rows = 0;
  const PetscInt *start = nullptr, *columns = nullptr;
  PetscBool done = PETSC_FALSE;
  TAUT_PETSC(MatGetRowIJ(local_, 0, PETSC_FALSE, PETSC_FALSE, &n_rows, &start,
                         &columns, &done));
  for (LocalNode node = 0; node < nodes_.n_owned; ++node)
    row_length_.push_back(start[3 * node + 1] - start[3 * node]);
  const unsigned int n = cells_.element().n_nodes;
  positions_.assign(cells_.cells().size() * n * n, 0);
  for (unsigned int cell = 0; cell < cells_.cells().size(); ++cell)
    if (!folded_[cell])
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int b = 0; b < n; ++b)
          positions_[(cell * n + a) * n + b] =
              find_entry(start, columns, 3 * cells_.cells()[cell].nodes[a],
                         3 * cells_.cells()[cell].nodes[b]);
  TAUT_PETSC(MatRestoreRowIJ(local_, 0, PETSC_FALSE, PETSC_FALSE, &n_rows,
                             &start, &columns, &done));
}

void TangentMatrix::begin()
{
  TAUT_PETSC(MatZeroEntries(matrix_));
  TAUT_PETSC(MatSeqAIJGetArray(local_, &values_));
}

void TangentMatrix::add_batch(const unsigned int batch, const double* stiffness,
                              const bool symmetric,
                              const NodalVector* positions)
{
  const FilmBatch& members = cells_.batches()[batch];
  for (unsigned int lane = 0; lane < members.n_cells; ++lane)
    if (folded_[members.cells[lane]])
      add_folded(members.cells[lane], lane, stiffness, symmetric, positions);
    else
      add_directly(members.cells[lane], lane, stiffness, symmetric);
}

void TangentMatrix::add_directly(const unsigned int cell,
                                 const unsigned int lane,
                                 const double* stiffness, const bool symmetric)
{
  const unsigned int n = cells_.element().n_nodes;
  const auto& cell_nodes = cells_.cells()[cell].nodes;
  const auto entry = [&](const unsigned int row, const unsigned int column)
  { return stiffness[(std::size_t(row) * 3 * n + column) * 8 + lane]; };
  for (unsigned int a = 0; a < n; ++a)
    for (unsigned int b = 0; b < (symmetric ? a + 1 : n); ++b)
    {
      double* block = values_ + positions_[(cell * n + a) * n + b];
      const int stride = row_length_[cell_nodes[a]];
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          block[i * stride + j] += entry(3 * a + i, 3 * b + j);
      if (!symmetric || a == b)
        continue;
      double* mirror = values_ + positions_[(cell * n + b) * n + a];
      const int mirror_stride = row_length_[cell_nodes[b]];
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          mirror[j * mirror_stride + i] += entry(3 * a + i, 3 * b + j);
    }
}

void TangentMatrix::add_folded(const unsigned int cell, const unsigned int lane,
                               const double* stiffness, const bool symmetric,
                               const NodalVector* positions)
{
  const unsigned int n = cells_.element().n_nodes;
  std::vector<std::vector<Term>> terms(n);
  for (unsigned int a = 0; a < n; ++a)
    expand(cells_.cells()[cell].nodes[a], positions, 1, terms[a]);
  Block block;
  for (unsigned int a = 0; a < n; ++a)
    for (unsigned int b = 0; b < n; ++b)
    {
      const bool mirrored = symmetric && b > a;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
        {
          const std::size_t row = mirrored ? 3 * b + j : 3 * a + i;
          const std::size_t column = mirrored ? 3 * a + i : 3 * b + j;
          block[3 * i + j] = stiffness[(row * 3 * n + column) * 8 + lane];
        }
      add_folded(terms, a, b, block.data());
    }
}

void TangentMatrix::add_folded(const std::vector<std::vector<Term>>& terms,
                               const unsigned int a, const unsigned int b,
                               const double* block)
{
  for (const auto& row : terms[a])
    for (const auto& column : terms[b])
      add_block(
          row.master, column.master,
          multiply(multiply_transposed(row.block, block), column.block).data());
}

void TangentMatrix::add_element(const std::vector<LocalNode>& nodes,
                                const double* matrix,
                                const NodalVector* positions)
{
  const std::size_t n = nodes.size();
  std::vector<std::vector<Term>> terms(n);
  for (std::size_t a = 0; a < n; ++a)
    expand(nodes[a], positions, 1, terms[a]);
  Block block;
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b)
    {
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          block[3 * i + j] = matrix[(3 * a + i) * 3 * n + 3 * b + j];
      add_folded(terms, a, b, block.data());
    }
}

void TangentMatrix::add_block(const LocalNode a, const LocalNode b,
                              const double* block)
{
  std::array<PetscInt, 3> rows, columns;
  for (unsigned int i = 0; i < 3; ++i)
  {
    // PETSc passes over negative indices.
    rows[i] = (nodes_.held[a] >> i & 1) ? -1 : 3 * nodes_.global(a) + i;
    columns[i] = (nodes_.held[b] >> i & 1) ? -1 : 3 * nodes_.global(b) + i;
  }
  if (coupling_ == Coupling::full)
    TAUT_PETSC(MatSetValues(matrix_, 3, rows.data(), 3, columns.data(), block,
                            ADD_VALUES));
  else
    for (unsigned int i = 0; i < 3; ++i)
      TAUT_PETSC(MatSetValues(matrix_, 1, &rows[i], 1, &columns[i],
                              &block[4 * i], ADD_VALUES));
}

void TangentMatrix::end()
{
  TAUT_PETSC(MatSeqAIJRestoreArray(local_, &values_));
  for (LocalNode node = 0; node < nodes_.n_owned; ++node)
    for (unsigned int i = 0; i < 3; ++i)
      if (nodes_.dependent[node] || (nodes_.held[node] >> i & 1))
        TAUT_PETSC(MatSetValue(matrix_, 3 * nodes_.global(node) + i,
                               3 * nodes_.global(node) + i, 1., ADD_VALUES));
  TAUT_PETSC(MatAssemblyBegin(matrix_, MAT_FINAL_ASSEMBLY));
  TAUT_PETSC(MatAssemblyEnd(matrix_, MAT_FINAL_ASSEMBLY));
}
} // namespace taut::fe
