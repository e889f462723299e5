#pragma once

#include <taut/structure/structure.h>

namespace taut::structure
{
/// Splits in four the share of the cells in which the gradient of the
/// displacement jumps most across the edges (the indicator of Kelly, Gago,
/// Zienkiewicz and Babuska 1983). `structure` becomes useless: build a new one
/// on the refined triangulation. Collective.
void refine_worst_cells(Structure& structure, const double* u,
                        const LoadState& loads, double share,
                        fe::Triangulation& triangulation);
} // namespace taut::structure
