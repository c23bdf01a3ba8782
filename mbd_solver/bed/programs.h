#pragma once
// Where the other programs are, and how Open MPI starts them here.

#include <string>

#include "mbd_solver/bed/process.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// A program built with footfall (beside it), as a path. Throws InputError when it is not there.
std::string built_program(const std::string& name);

// A program of another Debian package, as a path: what the shell would start. Throws InputError, with the package's name,
// when there is none.
std::string installed_program(const std::string& name, const std::string& package);

// How the user calls the front door, for lines to be copied: "./footfall" of a checkout, else "footfall".
std::string called_as();

// mpirun with what this machine needs: permission for root, more processes than cores, no binding of ranks to cores.
Command mpirun();

// From here on this mpirun, asked to end or with a program that has died, gives the others some seconds to write a
// checkpoint before it kills, and they know of it at once.
void leave_time_to_end(Command& mpirun);

// What the scene's -var options say, in the order LIGGGHTS gets them: here (folder of the script), then the variables.
std::vector<std::string> script_arguments(const std::string& script,
                                          const std::map<std::string, std::string>& variables);

// `path` from here when that is shorter, for lines that people read and copy.
std::string short_path(const std::string& path);

}  // namespace footfall
