#pragma once
// What the programs need before they read anything.

namespace footfall {

// Sets PATH where it is missing. Throws InputError where the current folder is gone or may not be entered, and for paths
// and arguments that are not UTF-8, which the files of a run could not name.
void prepare_start(int argc, char** argv);

// Whether mpirun (of Open MPI 4 or 5, or another with PMI) has started this process.
bool under_mpirun();

}  // namespace footfall
