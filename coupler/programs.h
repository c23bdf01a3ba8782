#pragma once
// The two programs of a coupled run: their names in messages, and the environment variables by which `footfall` controls
// them.

#include <string>

namespace footfall {

inline constexpr const char* kDemProgram = "liggghts_mbd";
inline constexpr const char* kMbdProgram = "mbd_solver";
inline constexpr const char* kStartBoth = "mpirun -np N liggghts_mbd -in SCRIPT : -np 1 mbd_solver SCENE";

// For a liggghts_mbd whose result is of use only when complete (a bed): a signal ends it at once. It then writes no
// restart file, and this line to standard error.
inline constexpr const char* kAllOrNothing = "FOOTFALL_ALL_OR_NOTHING";
inline constexpr const char* kStoppedLine = "liggghts_mbd: interrupted\n";

// For both programs of an audited run: the folder into which they write their balances of momentum and energy.
inline constexpr const char* kAuditFolder = "FOOTFALL_AUDIT";

// For liggghts_mbd: it refuses every program that the script would run (`shell`, pipes), however the script writes it.
inline constexpr const char* kNoPrograms = "FOOTFALL_NO_PROGRAMS";
bool programs_are_refused();

// For both programs: the file by which a program marks that it failed by itself. mpirun's exit code cannot show this: it
// is 1 as well when the end of mpirun was requested.
inline constexpr const char* kFailureNote = "FOOTFALL_FAILURE_NOTE";
// Creates that file, with the reason where only this program or rank knows it; does nothing where the variable is not set.
void note_failure(const std::string& reason = "");
// The first reason in that file, with its code; empty: no program has failed, or none has given one.
std::string noted_failure();

// For mbd_solver: the socket of a program that controls the run (mbd_solver/session/leader.h).
inline constexpr const char* kLeader = "FOOTFALL_LEADER";

}  // namespace footfall
