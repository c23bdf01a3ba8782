// Reads the environment variables that `footfall` sets for the programs it starts.

#include "coupler/programs.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>

#include "coupler/base/files.h"

namespace footfall {

bool programs_are_refused() { return std::getenv(kNoPrograms) != nullptr; }

void note_failure(const std::string& reason) {
  const char* path = std::getenv(kFailureNote);
  if (!path) return;
  const int note = open(path, O_WRONLY | O_CREAT | O_APPEND | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0644);
  if (note < 0) return;
  std::string line = reason;
  for (char& c : line)
    if (c == '\n') c = ' ';
  // In one piece, after the message of another rank.
  line += line.empty() ? "" : "\n";
  if (!line.empty()) (void)!::write(note, line.data(), line.size());
  close(note);
}

std::string noted_failure() {
  const char* path = std::getenv(kFailureNote);
  const std::string text = path == nullptr ? "" : read_whole_file(path).value_or("");
  return text.substr(0, text.find('\n'));
}

}  // namespace footfall
