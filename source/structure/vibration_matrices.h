#pragma once

#include <taut/fe/linear_solver.h>

#include <memory>

struct _p_Mat;

namespace taut::structure
{
/// K and M of vibrations on all owned entries, 3 node + component. Rows of
/// prescribed and dependent entries are those of the identity in K and zero in
/// M.
class VibrationMatrices
{
public:
  explicit VibrationMatrices(const fe::Nodes& nodes) : nodes_(nodes) {}
  ~VibrationMatrices();
  VibrationMatrices(const VibrationMatrices&) = delete;
  VibrationMatrices& operator=(const VibrationMatrices&) = delete;

  /// Copies a mass matrix and takes the inertia from the lengths of the
  /// directors of bars at `positions`.
  void set_mass(_p_Mat* mass, const fe::NodalVector& positions);
  /// Copies the symmetric part; returns the Frobenius norm of the other over
  /// that of the whole.
  double set_stiffness(_p_Mat* stiffness);
  _p_Mat* mass() const
  {
    return mass_;
  }
  _p_Mat* stiffness() const
  {
    return stiffness_;
  }
  /// K - shift M. Errors: StepRejected if it is singular.
  fe::LinearSolver& factorise(double shift);
  fe::LinearSolver& solver() const
  {
    return *solver_;
  }

private:
  void clear_held(_p_Mat* mass) const;
  _p_Mat* make_projection(const fe::NodalVector& positions) const;

  const fe::Nodes& nodes_;
  _p_Mat* mass_ = nullptr;
  _p_Mat* stiffness_ = nullptr;
  _p_Mat* shifted_ = nullptr;
  std::unique_ptr<fe::LinearSolver> solver_;
};
} // namespace taut::structure
