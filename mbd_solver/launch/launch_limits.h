#pragma once
// What mpirun needs before it can start programs.

namespace footfall {

// Throws InputError, with the limit, what there is and what is needed, where mpirun would wait without end or die: a
// temporary folder that cannot be written to or is full, and limits of open files and of the size of a file.
// processes: of all programs together.
void require_room_to_launch(int processes);

}  // namespace footfall
