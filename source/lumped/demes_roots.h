#pragma once

#include <functional>
#include <vector>

namespace taut::lumped
{
/// The zeros of a smooth function in [begin, end], increasing, to round-off. It
/// is sampled at the ends of `pieces` equal pieces; a pair of zeros within one
/// piece is found from the extremum between them.
std::vector<double> scan_roots(const std::function<double(double)>& function,
                               double begin, double end, int pieces);
} // namespace taut::lumped
