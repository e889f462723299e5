#pragma once

#include <taut/io/patch_columns.h>
#include <taut/structure/systems.h>

#include <vector>

namespace taut::io
{
/// A film as deal.II's output format knows it: one patch per cell of this rank,
/// with as many points as the cell has nodes, and values at them. The points
/// are the nodes in the mesh (m), so that curved cells keep their shape; the
/// deformed film is that plus the displacement.
///
/// What every point carries, SI units:
///   displacement (m)             vector
///   velocity (m/s)               vector; in runs with inertia
///   stretch_1, stretch_2         principal, the larger first
///   stress_1, stress_2 (Pa)      principal true stresses, the larger first
///   stress_direction_1           unit vector in space, of stress_1: wrinkles
///                                run along it
///   true_field (V/m)
///   breakdown_margin             1 - true field/strength
///   thickness (m)                of the deformed film
///   tension                      0 taut, 1 wrinkled, 2 slack
///   network_N_stretch_1, _2      internal, of the film's N-th network; nan in
///                                films that have fewer
///   film, electrode, rank        numbers from 0 in the order of the case;
///                                electrode -1 is none
/// Displacement and velocity are nodal values. Directions and tension are those
/// of the quadrature point next to the node, the others are extrapolated from
/// the points of the cell, and so jump between cells by the error of the mesh.
struct FilmPatches : PatchColumns
{
  std::vector<dealii::DataOutBase::Patch<2, 3>> patches;
};

/// Collective.
FilmPatches make_film_patches(double time, structure::StructureSystem& system,
                              const double* state);
} // namespace taut::io
