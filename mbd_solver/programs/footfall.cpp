// footfall: the command line. It starts mbd_solver and liggghts_mbd by a command that it prints. Commands that start many
// runs are in footfall_studies and footfall_campaign, by which it replaces itself; `import` and `fmu` are separate programs,
// too.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "coupler/base/errors.h"
#include "coupler/base/start.h"
#include "mbd_solver/app/command_line.h"
#include "mbd_solver/app/needed_parts.h"
#include "mbd_solver/app/new_case.h"
#include "mbd_solver/base/child_process.h"
#include "mbd_solver/launch/confined_programs.h"
#include "mbd_solver/launch/programs.h"

using namespace footfall;

int main(int argc, char** argv) {
  std::string word = argc > 1 ? argv[1] : "";
  try {
    if (word == "confined") return become_confined(argc, argv);
    keep_streams();
    if (word == "needs") {
      for (const std::string& part : needed_parts({argv + 2, argv + argc})) std::printf("%s\n", part.c_str());
      return kExitDone;
    }
    if (word == "help" && argc > 2) word = argv[2];
    // A file of drawn runs is checked by the program that carries it out.
    if (const std::vector<std::string> words = {argv + 1, argv + argc}; word == "check")
      if (const std::vector<std::string> parts = needed_parts(words);
          std::find(parts.begin(), parts.end(), "campaign") != parts.end()) {
        std::fprintf(stderr, "footfall: %s\n",
                     become_program(built_program("footfall_campaign"), {argv, argv + argc}).c_str());
        return kExitFailed;
      }
    for (const Subcommand& subcommand : subcommands()) {
      if (word != subcommand.name || subcommand.prepare != nullptr) continue;
      if (word == "import") return start_import({argv + 1, argv + argc});
      const std::string program = built_program(subcommand.program);
      std::fprintf(stderr, "footfall: %s\n", become_program(program, {argv, argv + argc}).c_str());
      return kExitFailed;
    }
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return kExitBadInput;
  }
  return run_command_line(argc, argv, subcommands());
}
