#pragma once

#include <taut/structure/systems.h>
#include <taut/study/case.h>

#include <memory>

namespace taut::study
{
/// The structure of a case on `mesh`, refined adaptively as the case asks: the
/// starting equilibrium is solved, the worst cells are split, and again.
/// Nothing is interpolated: a run solves its start on the final mesh.
/// `triangulation` holds `mesh` with its uniform refinements.
/// Errors: as Structure and StructureSystem::make_initial_state.
std::unique_ptr<structure::Structure>
make_adapted_structure(const Case& run_case, const fe::MeshData& mesh,
                       fe::Triangulation& triangulation);
} // namespace taut::study
