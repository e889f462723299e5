#pragma once

#include <cstddef>
#include <functional>

namespace taut::lumped
{
/// Calls task(0), ..., task(n - 1) once each, on `threads` threads or, if that
/// is 0, on one per core. The tasks must not touch each other's data.
/// Errors: the first that a task throws; tasks not yet begun are then left out.
void run_all(std::size_t n, const std::function<void(std::size_t)>& task,
             unsigned int threads = 0);
} // namespace taut::lumped
