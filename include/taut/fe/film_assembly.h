#pragma once

#include <taut/fe/film_cells.h>
#include <taut/fe/tangent_matrix.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

/// Sums over the film's cells on this rank. Nothing here communicates: ghosts
/// of the positions are current, and the caller compresses what was added.
namespace taut::fe
{
/// One law per slot of the cells. `voltages`: of every electrode (V).
std::vector<BatchLaw> make_laws(const FilmCells& cells,
                                const std::vector<double>& voltages);

/// The point that comes closest to the limit of a law.
struct LimitReport
{
  /// Not positive: beyond it.
  double margin = std::numeric_limits<double>::infinity();
  unsigned int film = 0;
  std::array<double, 3> place{}; ///< in the mesh (m)
  /// What is beyond its limit, with values; empty if nothing is.
  std::string excess = {};
};

struct FilmPowers
{
  double dissipation = 0; ///< in the networks (W)
  /// Integral of eps det C dV0 by slot (F m^2).
  std::vector<double> permittivity;
};

/// forces += internal forces (N); rates = rates of the internal variables.
LimitReport add_internal_forces(const FilmCells& cells,
                                const std::vector<BatchLaw>& laws,
                                const NodalVector& positions,
                                const double* internal, NodalVector& forces,
                                double* rates, FilmPowers& powers);

struct Capacitance
{
  /// Of this rank's part of an electrode, charge over voltage (F).
  double value;
  /// Of its film, as in LimitCheck.
  double margin;
};
Capacitance compute_capacitance(const FilmCells& cells,
                                const std::vector<BatchLaw>& laws,
                                int electrode, const NodalVector& positions,
                                const double* internal);

/// Two voltages of an electrode (V) and the laws at each.
struct VoltageStep
{
  double lower, higher;
  const std::vector<BatchLaw>& lower_laws;
  const std::vector<BatchLaw>& higher_laws;
};
/// How the cells of an electrode answer the step at fixed positions: forces +=
/// change of the internal forces (N); returns the change of the charge on this
/// rank's part (C).
double add_voltage_response(const FilmCells& cells, const VoltageStep& step,
                            int electrode, const NodalVector& positions,
                            const double* internal, NodalVector& forces);

/// Some cells under one follower pressure.
struct PressureLoad
{
  struct Lanes
  {
    unsigned int batch;
    /// Sign of the normal where the pressure acts, else 0.
    alignas(64) std::array<double, 8> active;
  };
  std::vector<Lanes> batches;
  double pressure = 0; ///< (Pa)
};

/// forces += forces of the pressures (N).
void add_pressure_forces(const FilmCells& cells,
                         const std::vector<PressureLoad>& pressures,
                         const NodalVector& positions, NodalVector& forces);

/// The state at which a tangent is taken, and what is taken.
struct TangentRequest
{
  const NodalVector* positions;
  const double* internal;
  double alpha = 0;      ///< (1/s), infinity: networks frozen
  bool inertia = false;  ///< add alpha^2 M + alpha * drag
  double air_drag = 0;   ///< (kg/(m^3 s))
  bool symmetric = true; ///< its symmetric part
  /// The derivative at the state itself, without what Newton's method predicts
  /// on its way (see structure::Frames::add_stiffness).
  bool exact = false;
};

/// Adds the film's tangent, pressures included, to a begun matrix.
void add_stiffness(const FilmCells& cells, const std::vector<BatchLaw>& laws,
                   const std::vector<PressureLoad>& pressures,
                   const TangentRequest& request, TangentMatrix& matrix);

/// Adds the consistent mass of films with the given densities (kg/m^3), one
/// per film.
void add_mass(const FilmCells& cells, const std::vector<double>& densities,
              TangentMatrix& matrix);

/// result += (consistent mass of films with the given densities) x, all nodes
/// taken as independent.
void add_mass_product(const FilmCells& cells,
                      const std::vector<double>& densities,
                      const NodalVector& x, NodalVector& result);

/// forces += change of the internal forces for (alpha - dA'/dA)^{-1} r.
void add_force_change(const FilmCells& cells, const std::vector<BatchLaw>& laws,
                      const NodalVector& positions, const double* internal,
                      double alpha, const double* r, NodalVector& forces);

/// change = (alpha - dA'/dA)^{-1} (r + dA'/dx dx).
void compute_internal_change(const FilmCells& cells,
                             const std::vector<BatchLaw>& laws,
                             const NodalVector& positions,
                             const double* internal, double alpha,
                             const NodalVector& dx, const double* r,
                             double* change);

struct FilmEnergy
{
  double at_voltage = 0; ///< Legendre transformed (J)
  double stored = 0;     ///< in springs and networks (J)
  /// (1/2) Q V by slot (J).
  std::vector<double> electric;
};
FilmEnergy compute_energy(const FilmCells& cells,
                          const std::vector<BatchLaw>& laws,
                          const NodalVector& positions, const double* internal);

/// The relaxed internal variables at the given positions, A = C^{-1} of the
/// film, wrinkled if so; `laws` without networks.
void set_relaxed(const FilmCells& cells, const std::vector<BatchLaw>& laws,
                 const NodalVector& positions, double* internal);

/// A = 1: the undeformed film.
void set_unrelaxed(const FilmCells& cells, double* internal);

/// C at the points of all cells, [cell][q] as (xx, yy, xy).
std::vector<std::array<double, 3>> compute_metric(const FilmCells& cells,
                                                  const NodalVector& positions);

/// C* of the wrinkled film, likewise; C where it is taut.
std::vector<std::array<double, 3>>
compute_wrinkled_metric(const FilmCells& cells,
                        const std::vector<BatchLaw>& laws,
                        const NodalVector& positions, const double* internal);
} // namespace taut::fe
