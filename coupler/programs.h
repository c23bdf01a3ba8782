#pragma once
// The two programs of a coupled run, as messages name them.

namespace footfall {

inline constexpr const char* kGrainsProgram = "liggghts_mbd";
inline constexpr const char* kMechanismProgram = "mbd_solver";
inline constexpr const char* kStartBoth = "mpirun -np N liggghts_mbd -in SCRIPT : -np 1 mbd_solver SCENE";

// In the environment of a liggghts_mbd whose work is of use only when it is whole (a bed): a signal ends it at once, and
// it leaves no restart file behind, but this word on standard error.
inline constexpr const char* kAllOrNothing = "FOOTFALL_ALL_OR_NOTHING";
inline constexpr const char* kStoppedWord = "liggghts_mbd: interrupted\n";

// In the environment of both programs of a run that is audited: the folder into which they write what they count for
// `footfall audit`.
inline constexpr const char* kAuditFolder = "FOOTFALL_AUDIT";

// In the environment: the file that becomes the note.
inline constexpr const char* kFailureNote = "FOOTFALL_FAILURE_NOTE";

// Leaves the note; nothing happens where no front door asks for one.
void note_failure();

}  // namespace footfall
