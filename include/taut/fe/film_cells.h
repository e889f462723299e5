#pragma once

#include <taut/fe/film_kernel.h>
#include <taut/fe/nodes.h>
#include <taut/fe/reference_element.h>

#include <deal.II/base/aligned_vector.h>

#include <array>
#include <string>
#include <vector>

namespace taut::fe
{
/// Where a film was before it was stretched into the frame.
struct FilmSection
{
  const material::Elastomer* elastomer;
  double thickness;                  ///< undeformed, H (m)
  std::array<double, 2> pre_stretch; ///< principal values of P
  std::array<double, 3> axis;        ///< first axis of P; any length
  double temperature;                ///< (K)
  bool tension_field;                ///< wrinkles instead of compression
};

/// A cell as the mesh gives it.
struct FilmCell
{
  std::vector<LocalNode> nodes; ///< in the order of FE_Q
  unsigned int film = 0;
  int electrode = -1; ///< -1: none
  /// Of the normal d/dxi x d/deta: +1 if it is the mesh's, -1 if opposite.
  double orientation = 1;
};

/// Up to eight cells with the same film and electrode.
struct FilmBatch
{
  unsigned int n_cells;
  unsigned int slot; ///< index into FilmCells::slots
  /// Cells in the lanes; unused lanes repeat the last cell.
  std::array<unsigned int, 8> cells;
};

/// A film under an electrode, or bare.
struct LawSlot
{
  unsigned int film;
  int electrode;
};

/// The film's cells on this rank with all that does not change in time.
/// Internal variables lie in one flat array, [cell][q][m][3], cells in order.
class FilmCells
{
public:
  /// `mesh_positions`: of all local nodes (m). Errors: BadInput if a cell is
  /// turned inside out or the axis of its film is normal to it.
  FilmCells(unsigned int degree, std::vector<FilmSection> films,
            std::vector<FilmCell> cells,
            const std::vector<std::array<double, 3>>& mesh_positions);

  /// Gives a film another pre-stretch: the mesh stays the shape of its frame.
  void set_pre_stretch(unsigned int film,
                       const std::array<double, 2>& pre_stretch);

  const ReferenceElement& element() const
  {
    return element_;
  }
  const std::vector<FilmSection>& films() const
  {
    return films_;
  }
  const std::vector<FilmCell>& cells() const
  {
    return cells_;
  }
  const std::vector<FilmBatch>& batches() const
  {
    return batches_;
  }
  const std::vector<LawSlot>& slots() const
  {
    return slots_;
  }

  unsigned int n_networks(unsigned int cell) const;
  std::size_t n_internal() const
  {
    return n_internal_;
  }
  /// Where the internal variables of a cell begin.
  std::size_t first_internal(const unsigned int cell) const
  {
    return first_internal_[cell];
  }

  BatchGeometry geometry(unsigned int batch) const;
  /// Undeformed volume of point q of a cell (m^3).
  double volume(unsigned int cell, unsigned int q) const;
  /// Position in the mesh of point q of a cell (m).
  std::array<double, 3> mesh_point(unsigned int cell, unsigned int q) const;
  /// Material axes (two tangent unit vectors) at point q.
  std::array<std::array<double, 3>, 2> axes(unsigned int cell,
                                            unsigned int q) const;

  /// Gather nodal values [a][3][lane] and internal variables [q][m][3][lane]
  /// of a batch; scatter adds (nodes) or sets (internal).
  void gather(unsigned int batch, const NodalVector& nodal,
              double* values) const;
  void gather_internal(unsigned int batch, const double* internal,
                       double* values) const;
  void scatter_add(unsigned int batch, const double* values,
                   NodalVector& nodal) const;
  void scatter_internal(unsigned int batch, const double* values,
                        double* internal) const;
  /// Longest arrays a batch needs, in doubles.
  std::size_t nodal_size() const
  {
    return 8 * 3 * element_.n_nodes;
  }
  std::size_t internal_size() const
  {
    return max_batch_internal_;
  }

private:
  void make_batches();
  void
  compute_geometry(const std::vector<std::array<double, 3>>& mesh_positions);

  ReferenceElement element_;
  std::vector<FilmSection> films_;
  std::vector<FilmCell> cells_;
  std::vector<FilmBatch> batches_;
  std::vector<LawSlot> slots_;
  std::vector<std::size_t> first_internal_;
  std::vector<std::pair<unsigned int, unsigned int>> batch_and_lane_;
  std::size_t n_internal_ = 0;
  std::size_t max_batch_internal_ = 0;
  dealii::AlignedVector<double> gradients_; ///< [batch][q][a][2][lane]
  dealii::AlignedVector<double> volumes_;   ///< [batch][q][lane]
  /// Both without any pre-stretch; empty until a film gets another one.
  dealii::AlignedVector<double> plain_gradients_, plain_volumes_;
  std::vector<std::array<double, 9>> frames_; ///< [cell][q] point, two axes
};
} // namespace taut::fe
