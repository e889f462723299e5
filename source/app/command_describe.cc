#include <taut/io/parameters.h>

#include <deal.II/base/mpi.h>

#include <iostream>
#include <memory>

#include "commands.h"
#include "exit_codes.h"

namespace taut::app
{
void add_describe(CLI::App& program, Action& chosen)
{
  auto* command = program.add_subcommand(
      "describe", "Print the keys of a case file with meaning, unit, range and "
                  "default");
  const auto section = std::make_shared<std::string>();
  command->add_option("SECTION", *section,
                      "a section such as Film; all if none");
  command->callback(
      [&chosen, section]
      {
        chosen = [section](const MPI_Comm communicator)
        {
          std::ostringstream text;
          io::describe(text, *section);
          if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
            std::cout << text.str();
          return done;
        };
      });
}
} // namespace taut::app
