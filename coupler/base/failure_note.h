#pragma once
// A program that fails by itself leaves a note for the front door, which else knows mpirun's exit code alone: that is 1,
// too, when mpirun was asked to end.

namespace footfall {

// In the environment: the file that becomes the note.
inline constexpr const char* kFailureNote = "FOOTFALL_FAILURE_NOTE";

// Leaves the note; nothing happens where no front door asks for one.
void note_failure();

}  // namespace footfall
