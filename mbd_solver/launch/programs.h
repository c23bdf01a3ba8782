#pragma once
// Where the other programs are, and how Open MPI starts them on this machine.

#include <string>

#include "mbd_solver/base/child_process.h"

namespace footfall {

// Path of a program of footfall: next to this one. Throws InputError when it does not exist.
std::string built_program(const std::string& name);

// Path of a program of another Debian package, as the shell would find it. Throws InputError with the package's name.
std::string installed_program(const std::string& name, const std::string& package);

// A batch system or a list of hosts names the machines on which mpirun starts programs.
bool in_batch_job();

// How the user calls this program, for lines to be copied: "./footfall" in a checkout, otherwise "footfall".
std::string called_as();

// mpirun with permission for root, more processes than cores, and without binding ranks to cores. It and what it starts may
// start the programs of MPI and of add_program only: the scripts and variables of a scene are not the user's.
Command mpirun();
// Adds "-np RANKS PROGRAM ARGUMENTS" to the line of mpirun, behind ":" where there is a program before.
void add_program(Command& mpirun, int ranks, const std::string& program, const std::vector<std::string>& arguments);

// When this mpirun is asked to end, or one of its programs dies, it warns the other programs at once and gives them some
// seconds to write a checkpoint before it kills them.
void leave_time_to_end(Command& mpirun);

// Options of LIGGGHTS for a script: -in, then -var here (the folder of the script) and the other variables. Files are named from
// the current folder: what is above it may have blanks, at which LIGGGHTS would split them. Throws InputError for a value that
// could be anything else than a value on that line (fault_of_value).
std::vector<std::string> script_arguments(const std::string& script,
                                          const std::map<std::string, std::string>& variables);

// `path` relative to the current folder when that is shorter, for lines to be read and copied.
std::string short_path(const std::string& path);

}  // namespace footfall
