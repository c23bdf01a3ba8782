// How tests of tests/app start footfall and look at what it leaves.
#include "tests/app/programs.h"

#include <unistd.h>

namespace footfall::app {

namespace fs = std::filesystem;

std::string quoted(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

test::Outcome footfall(const test::RunFolder& folder, const std::vector<std::string>& words, int limit_seconds) {
  std::string line = quoted(test::RunFolder::program("footfall"));
  for (const std::string& word : words) line += " " + quoted(word);
  return folder.command(line, limit_seconds);
}

std::string processes_in(const fs::path& folder) {
  const std::string below = folder.string();
  std::string found;
  std::error_code gone;
  for (const auto& entry : fs::directory_iterator("/proc", gone)) {
    const std::string id = entry.path().filename().string();
    if (id.find_first_not_of("0123456789") != std::string::npos || id == std::to_string(getpid())) continue;
    std::error_code none;
    const std::string cwd = fs::read_symlink(entry.path() / "cwd", none).string();
    if (none || cwd.compare(0, below.size(), below) != 0) continue;
    const fs::path program = fs::read_symlink(entry.path() / "exe", none);
    found += (found.empty() ? "" : ", ") + id + " " + program.filename().string();
  }
  return found;
}

}  // namespace footfall::app
