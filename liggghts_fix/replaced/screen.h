#pragma once
// What LIGGGHTS prints with `-screen none`: its errors must not get lost (MPI_Abort), and a line that it prints past its
// screen must not appear (__printf_chk).

#include <cstdio>
#include <string>

namespace footfall {

// An error that a single rank meets is printed on that rank's screen, not in the log, and MPI_Abort drops the buffers of
// both. With `-screen none` every rank therefore gets this screen: a file without a name that ends with the program,
// null if there can be none. MPI_Abort then writes all buffers, copies lines with ERROR to the log and to stderr, and notes them
// for the partner (note_failure), which that rank cannot reach.
// log: LIGGGHTS' log file.
std::FILE* open_hidden_screen(const std::string& log);
// The errors on that screen so far, in one line; empty without any.
std::string errors_on_screen();
// The message to the partner about these errors, with its code.
std::string own_error(const std::string& errors);

// From now on LIGGGHTS' line about the version of a restart file is not printed.
void hide_restart_version();

}  // namespace footfall
