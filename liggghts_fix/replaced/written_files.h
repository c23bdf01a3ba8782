#pragma once
// LIGGGHTS does not check whether the files that it writes are complete: fclose is replaced and watches them.

namespace footfall {

// From here on every fclose of this process is checked.
void watch_written_files();
// Ends the watch. True if a file since then could not be written completely.
bool written_file_lost();

}  // namespace footfall
