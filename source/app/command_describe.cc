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
  auto* name = command->add_option("SECTION", *section,
                                   "a section such as Film; all if none");
  const auto as_page = std::make_shared<bool>(false);
  command
      ->add_flag("--markdown", *as_page,
                 "all sections as a page in Markdown, docs/parameters.md")
      ->excludes(name);
  command->callback(
      [&chosen, section, as_page]
      {
        chosen = [section, as_page](const MPI_Comm communicator)
        {
          std::ostringstream text;
          if (*as_page)
            io::describe_as_page(text);
          else
            io::describe(text, *section);
          if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
            std::cout << text.str();
          return done;
        };
      });
}
} // namespace taut::app
