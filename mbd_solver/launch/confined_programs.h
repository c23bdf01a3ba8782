#pragma once
// LIGGGHTS with the script of someone else: the kernel lets it write below some folders only, and start no program
// (coupler/base/confinement.h).

#include <string>
#include <vector>

#include "mbd_solver/base/child_process.h"

namespace footfall {

// trusted: this mpirun and its programs have the rights of the user. Otherwise its script writes below these folders only.
void limit_script(Command& mpirun, bool trusted, const std::vector<std::string>& folders);

// `footfall confined PROGRAM ARGUMENTS`, which mpirun starts for a program that cannot confine itself: replaces this
// process by the program, with the rights of its script. Returns the exit code where that fails.
int become_confined(int argc, char** argv);

}  // namespace footfall
