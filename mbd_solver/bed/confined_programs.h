#pragma once
// LIGGGHTS with the script of someone else: the kernel lets it write below some folders only, and start no program
// (coupler/base/confinement.h).

#include <string>
#include <vector>

#include "mbd_solver/bed/process.h"

namespace footfall {

// The script of this mpirun writes below these folders only.
void confine_script(Command& mpirun, const std::vector<std::string>& folders);

// What Open MPI needs where its programs are confined; without kMayWrite in the environment of the command nothing.
std::map<std::string, std::string> settings_of_confined(const Command& mpirun);

// `footfall confined PROGRAM ARGUMENTS`, which mpirun starts for a program that cannot confine itself: replaces this
// process by the program, with the rights of its script. Returns the exit code where that fails.
int become_confined(int argc, char** argv);

}  // namespace footfall
