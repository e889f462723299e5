#include <taut/io/versions.h>

#include <deal.II/base/mpi.h>

#include <petscsys.h>

#include <iostream>

#include "commands.h"
#include "exit_codes.h"
#include "failure.h"

namespace taut::app
{
namespace
{
std::string describe_versions()
{
  std::string text;
  for (const auto& [name, version] : io::get_versions())
    text += name + " " + version + "\n";
  return text;
}

/// Errors in the words are told in one line like all others.
int call(const int argc, char** argv, const MPI_Comm communicator)
{
  const bool is_first =
      dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
  CLI::App program("Taut: dielectric-elastomer membranes by finite elements");
  program.name("taut");
  program.set_version_flag("--version", describe_versions,
                           "Print the versions of Taut and its libraries");
  program.require_subcommand(1);
  program.footer("Exit codes: 0 done, 1 broken, 2 bad input, 3 solver failed, "
                 "4 stopped by a fatal event, 5 interrupted.");
  Action chosen;
  add_run(program, chosen);
  add_modes(program, chosen);
  add_study(program, chosen);
  add_work(program, chosen);
  add_compare(program, chosen);
  add_render(program, chosen);
  add_report(program, chosen);
  add_check(program, chosen);
  add_describe(program, chosen);
  try
  {
    program.parse(argc, argv);
  }
  catch (const CLI::Success& success)
  {
    return is_first ? program.exit(success) : done;
  }
  catch (const CLI::ParseError& error)
  {
    if (is_first)
      std::cerr << "taut: " << error.what() << "; see taut --help\n";
    return bad_input;
  }
  return guard(communicator, [&] { return chosen(communicator); });
}
} // namespace
} // namespace taut::app

int main(int argc, char** argv)
{
  const unsigned int n_threads = 1;
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, n_threads);
  // PETSc answers SIGTERM with a stack trace and hides crashes.
  if (PetscPopSignalHandler() != 0)
    return taut::app::broken;
  return taut::app::call(argc, argv, MPI_COMM_WORLD);
}
