#pragma once

#include <taut/structure/loads.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <mpi.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Electrodes whose charge is given, by the user or by the state of a circuit.
/// Their voltages are no unknowns: they follow from the charges at every shape
/// of the film.
namespace taut::structure
{
/// Currents in a circuit (A) while the film has the voltage V:
/// source: (V_s - V)/R_s, leakage: V/R_leak.
struct CircuitCurrents
{
  double source;
  double leakage;
};
CircuitCurrents compute_currents(const Electrode& circuit,
                                 double source_voltage, double voltage);
/// At which both currents are equal: V_s R_leak/(R_s + R_leak).
double compute_rest_voltage(const Electrode& circuit, double source_voltage);
/// What the currents lose per change of the voltage, 1/R_s + 1/R_leak (1/Ohm);
/// 0 of an electrode that is no circuit.
double get_conductance(const Electrode& electrode);
/// Indices of the electrodes in circuits.
std::vector<unsigned int>
find_circuits(const std::vector<Electrode>& electrodes);
/// Gives the charges (C, by electrode) of circuits; others stay as they are.
void give_charges(const std::vector<Electrode>& electrodes,
                  const std::vector<double>& charges, LoadState& loads);

/// What find_voltage asks: capacitance = charge/voltage (F) at a voltage (V),
/// nothing where the film cannot bear it.
using CapacitanceOf = std::function<std::optional<double>(double voltage)>;

/// The voltage that gives a charge (C), from the guess `voltage`. In a taut
/// film the capacitance does not depend on it, in a wrinkled one it grows with
/// it (the energy at prescribed voltage is concave in the square of the
/// voltage), so that Q/capacitance always lies on the other side of the
/// solution. Errors: StepRejected with charge, voltage and capacitance reached
/// if no voltage gives it.
double find_voltage(const CapacitanceOf& capacitance_of, double charge,
                    double voltage, const std::string& electrode);

/// What given charges add to the tangent K at prescribed voltages: B D B^T, a
/// column b = dQ/du = d(forces)/dV and a number d = 1/(dQ/dV + G/alpha) for
/// each electrode. Where the charge is prescribed, the conductance G is 0. In a
/// circuit dQ/dt = g(V) with dg/dV = -G, linearised at alpha,
///   dQ = dQ/dV dV + b . du,   alpha dQ + G dV = r,
/// gives dV = d (r/alpha - b . du) and from K du - b dV = f
///   (K + d b b^T) du = f + b d r/alpha.
/// Vectors are this rank's part of the free unknowns.
class SourceBorder
{
public:
  struct Column
  {
    unsigned int electrode;
    std::vector<double> b;  ///< (N/V)
    double capacitance;     ///< dQ/dV at fixed positions (F), positive
    double conductance = 0; ///< G (1/Ohm)
  };

  /// Forgets everything. `alpha` (1/s) may be infinite.
  void reset(MPI_Comm communicator, double alpha);
  void add(Column column);
  bool empty() const
  {
    return columns_.empty();
  }

  /// result += B D B^T x.
  void add_product(const double* x, double* result) const;
  /// After K has been factorised; `solve` applies K^{-1} in place.
  void eliminate(const std::function<void(double*)>& solve);
  /// Takes x = K^{-1} f to (K + B D B^T)^{-1} f (Woodbury). Errors:
  /// StepRejected if the bordered matrix is singular.
  void correct(double* x) const;
  /// f += B D r/alpha; `residuals` r by electrode (A).
  void add_residuals(const std::vector<double>& residuals, double* f) const;
  /// Replaces residuals by the changes dQ of the charges (C) for du.
  void compute_charge_changes(const double* du,
                              std::vector<double>& residuals) const;
  /// Negative eigenvalues of K that K + B D B^T no longer has: those of
  /// S = D^{-1} + B^T K^{-1} B. (By Haynsworth the matrix with the blocks K, B
  /// and -D^{-1} has as many as K and -S, and as K + B D B^T and -D^{-1}.)
  int count_removed_negative_eigenvalues() const;

private:
  double get_weight(const Column& column) const;
  std::vector<double> multiply_columns(const double* x) const;

  MPI_Comm communicator_ = MPI_COMM_SELF;
  double alpha_ = 0;
  std::vector<Column> columns_;
  std::vector<std::vector<double>> solutions_; ///< K^{-1} B
  dealii::LAPACKFullMatrix<double> schur_;     ///< D^{-1} + B^T K^{-1} B
  dealii::LAPACKFullMatrix<double> schur_factors_;
};
} // namespace taut::structure
