// footfall_studies: all commands of footfall and the help of all; footfall starts it for those that it does not have itself.
#include <vector>

#include "mbd_solver/app/command_line.h"
#include "mbd_solver/studies/studies.h"

using namespace footfall;

int main(int argc, char** argv) {
  std::vector<Subcommand> commands = subcommands();
  commands.insert(commands.end(), studies().begin(), studies().end());
  return front_door(argc, argv, commands, print_help);
}
