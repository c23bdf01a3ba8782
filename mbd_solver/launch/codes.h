#pragma once
// Codes of the messages of mbd_solver/launch: E0563, E0564, E0568, E0569, E0575.

#include "coupler/base/errors.h"

namespace footfall::code {

// mpirun waits for programs that are gone. Free space in the temporary folder, and raise the limits of ulimit.
inline constexpr MessageCode kProgramsGone{"E0568", "programs-gone"};
// A program does not get on within the time limit. Correct what it is at, or raise coupling.timeout.
inline constexpr MessageCode kProgramSilent{"E0569", "program-silent"};
// A limit leaves mpirun no room for its own files. Free space in the folder, or raise the limit, that the message names.
inline constexpr MessageCode kNoRoomToLaunch{"E0575", "no-room-to-launch"};
// A program of footfall is missing. Build footfall again.
inline constexpr MessageCode kProgramNotBuilt{"E0563", "program-not-built"};
// A program of another Debian package is missing. Install the package.
inline constexpr MessageCode kProgramNotInstalled{"E0564", "program-not-installed"};

}  // namespace footfall::code
