#pragma once
// Preparations that programs need before they read anything.

#include <filesystem>

#include "coupler/base/errors.h"

namespace footfall {

// A closed standard output or a full disk is an error of a write, and ends no program: SIGPIPE and SIGXFSZ are
// ignored, and a standard stream that is closed is /dev/null, so that no other file gets its number. First in main().
void keep_streams();
// Whether the standard output is a pipe or socket that nobody reads any more.
bool output_is_unread();

// Sets PATH where it is missing. Throws InputError for arguments that are not UTF-8, which the files of a run could not
// name.
void prepare_start(int argc, char** argv);
// Throws InputError where the current folder is gone or may not be entered, or its path is not UTF-8. For all that does
// more than print help.
void require_current_folder();

// The library's error for a file or folder, as a message for users: without permission, on a disk that is gone.
InputError as_input_error(const std::filesystem::filesystem_error& error);

// Whether mpirun (of Open MPI 4 or 5, or another with PMI) has started this process.
bool under_mpirun();

}  // namespace footfall
