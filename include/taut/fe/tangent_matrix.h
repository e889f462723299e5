#pragma once

#include <taut/fe/film_cells.h>

#include <memory>
#include <vector>

struct _p_Mat;

namespace taut::fe
{
/// The sparse matrix of the free nodal unknowns (3 node + component, global
/// numbering). Rows of prescribed components and of nodes that follow others
/// hold only a one on the diagonal. Cells without such nodes and without nodes
/// of other ranks go straight into the value array; the others are folded
/// first.
class TangentMatrix
{
public:
  enum class Coupling
  {
    full,      ///< 3 x 3 blocks
    components ///< each component by itself, as in a mass matrix
  };

  /// `elements`: nodes of elements other than the cells, for add_element.
  TangentMatrix(const Nodes& nodes, const FilmCells& cells,
                const std::vector<std::vector<LocalNode>>& elements,
                Coupling coupling);
  ~TangentMatrix();
  TangentMatrix(const TangentMatrix&) = delete;
  TangentMatrix& operator=(const TangentMatrix&) = delete;

  _p_Mat* get() const
  {
    return matrix_;
  }

  /// Sets all values to zero and opens the matrix for adding. Collective.
  void begin();
  /// Adds the cells of a batch, [a][3][b][3][lane]; if `symmetric`, only the
  /// blocks b <= a are read. `positions`: where bars turn their nodes, nullptr
  /// for inertia.
  void add_batch(unsigned int batch, const double* stiffness, bool symmetric,
                 const NodalVector* positions);
  /// Adds a 3 x 3 block (row-major) to rows of node a and columns of node b.
  void add_block(LocalNode a, LocalNode b, const double* block);
  /// Adds the matrix of an element with the given nodes, row-major with
  /// 3 nodes.size() rows. `positions` as in add_batch.
  void add_element(const std::vector<LocalNode>& nodes, const double* matrix,
                   const NodalVector* positions);
  /// Ends adding. Collective.
  void end();

  /// True if the batch has a cell whose nodes turn with a bar or a rotation:
  /// forces and inertia follow different maps there.
  bool turns(const unsigned int batch) const
  {
    return turns_[batch];
  }

private:
  /// A node as a combination of free ones: x_node = sum block x_master.
  struct Term
  {
    LocalNode master;
    std::array<double, 9> block;
    bool turns; ///< the block changes with a rotation
  };
  void expand(LocalNode node, const NodalVector* positions, double weight,
              std::vector<Term>& terms) const;
  void add_folded(const std::vector<std::vector<Term>>& terms, unsigned int a,
                  unsigned int b, const double* block);
  void create(const std::vector<std::vector<LocalNode>>& elements);
  void find_positions();
  void add_directly(unsigned int cell, unsigned int lane,
                    const double* stiffness, bool symmetric);
  void add_folded(unsigned int cell, unsigned int lane, const double* stiffness,
                  bool symmetric, const NodalVector* positions);

  const Nodes& nodes_;
  const FilmCells& cells_;
  const Coupling coupling_;
  _p_Mat* matrix_ = nullptr;
  _p_Mat* local_ = nullptr; ///< rows and columns of this rank, not owned
  double* values_ = nullptr;
  /// Per local node, index into hanging / on_bar / followers or -1.
  std::vector<int> hanging_index_;
  std::vector<int> bar_index_;
  std::vector<int> follower_index_;
  std::vector<bool> folded_; ///< [cell]
  std::vector<bool> turns_;  ///< [batch]
  /// [cell][a][b]: where the block begins in the values of `local_`.
  std::vector<int> positions_;
  std::vector<int> row_length_; ///< [node], entries per row of `local_`
};
} // namespace taut::fe
