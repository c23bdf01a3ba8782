// Reads the environment variables that `footfall` sets for the programs it starts.

#include "coupler/programs.h"

#include <cstdio>
#include <cstdlib>

namespace footfall {

bool programs_are_refused() { return std::getenv(kNoPrograms) != nullptr; }

void note_failure() {
  const char* path = std::getenv(kFailureNote);
  if (!path) return;
  if (std::FILE* note = std::fopen(path, "w")) std::fclose(note);
}

}  // namespace footfall
