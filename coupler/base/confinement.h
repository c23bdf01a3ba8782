#pragma once
// Rights that a process gives up for good, enforced by the kernel: Landlock (Linux 5.13) for what it writes and executes,
// and seccomp, which every kernel has, for what it executes. The contents of a foreign script then do not matter.

#include <string>
#include <vector>

namespace footfall {

struct Confinement {
  std::vector<std::string>
      writable;  // folders below which files are written, and single files; missing ones are left out
  std::vector<std::string> executable;  // the only programs that may be started, with the dynamic loader
  bool limits_writing = true;           // otherwise it writes what it could write
};

// Does this kernel confine what a process writes? Without Landlock only execution is confined.
bool kernel_confines_files();

// From here on the calling thread, and all it starts, writes and executes nothing else; reading is not limited.
// Returns an empty text, or why the kernel refused.
std::string confine(const Confinement& confinement);

// Environment variable of LIGGGHTS: the folders, one per line, below which the script may write. Without it the script has
// the rights of the user.
inline constexpr const char* kMayWrite = "FOOTFALL_MAY_WRITE";
bool script_is_confined();
std::vector<std::string> folders_of_script();

// The folders in which Open MPI keeps the files of the running job on this machine (from the environment of its programs).
std::vector<std::string> folders_of_mpi();

}  // namespace footfall
