// footfall: the front door. It only arranges mbd_solver and liggghts_mbd; whatever it does, the line it prints does
// too. Words that are not its own it hands to footfall_studies, which knows them all.
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <string>

#include "coupler/base/errors.h"
#include "mbd_solver/app/command_line.h"
#include "mbd_solver/bed/programs.h"

using namespace footfall;

int main(int argc, char** argv) {
  const std::string word = argc > 1 ? argv[1] : "";
  for (const Subcommand& subcommand : subcommands())
    if (word == subcommand.name) return front_door(argc, argv, subcommands());
  try {
    const std::string studies = built_program("footfall_studies");
    execv(studies.c_str(), argv);
    std::perror(studies.c_str());
    return kExitFailed;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return kExitBadInput;
  }
}
