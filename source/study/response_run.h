#pragma once

#include <taut/study/response.h>

namespace taut::study
{
/// The flow of a lumped case under the source of one frequency.
std::unique_ptr<MotionFlow> make_driven_flow(const Case& lumped_case,
                                             double frequency);

/// One frequency, from `state` on, or from rest if that is empty; leaves the
/// state after the last whole period in it. A point whose model fails has no
/// numbers, and what comes next starts at rest.
ResponsePoint compute_point(const Case& lumped_case, double frequency,
                            bool is_upward, std::vector<double>& state);
} // namespace taut::study
