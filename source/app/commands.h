#pragma once

#include <mpi.h>

#include <functional>

#include <CLI/CLI.hpp>

/// The commands of the program, one file each.
namespace taut::app
{
/// What a chosen command does; the result is the exit code of the program.
/// Collective. Errors: BadInput, SolverFailed and whatever else goes wrong.
using Action = std::function<int(MPI_Comm)>;

/// Each adds a command that sets `chosen` when it is called.
void add_check(CLI::App& program, Action& chosen);
void add_compare(CLI::App& program, Action& chosen);
void add_describe(CLI::App& program, Action& chosen);
void add_modes(CLI::App& program, Action& chosen);
void add_render(CLI::App& program, Action& chosen);
void add_report(CLI::App& program, Action& chosen);
void add_run(CLI::App& program, Action& chosen);
void add_study(CLI::App& program, Action& chosen);
/// Hidden: what the processes of a study run.
void add_work(CLI::App& program, Action& chosen);
} // namespace taut::app
