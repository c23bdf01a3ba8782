// How tests of tests/app start footfall and look at what it leaves.
#include "tests/app/programs.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <regex>
#include <thread>

namespace footfall::app {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kMoment{50};

test::Outcome Folder::footfall(const std::string& line, int limit_seconds) const {
  return command(program("footfall") + " " + line, limit_seconds);
}

test::Outcome Folder::done(const std::string& line, int limit_seconds) const {
  const test::Outcome outcome = footfall(line, limit_seconds);
  EXPECT_EQ(outcome.exit_code, 0) << "footfall " << line << "\n" << outcome.text;
  return outcome;
}

test::Outcome Folder::refused(const std::string& line, const std::string& code) const {
  const test::Outcome outcome = footfall(line);
  EXPECT_EQ(outcome.exit_code, 2) << "footfall " << line << "\n" << outcome.text;
  EXPECT_TRUE(holds(outcome.text, "[" + code + " ")) << code << ": footfall " << line << "\n" << outcome.text;
  return outcome;
}

test::Outcome Folder::shell(const std::string& line, int limit_seconds) const {
  return command("bash -c " + quoted(line), limit_seconds);
}

Background::Background(const Folder& folder, const std::string& line, const std::string& ready) {
  folder.shell("(exec setsid " + line + " > background.txt 2>&1 < /dev/null) & echo $! > background.pid");
  pid_ = std::stoi(folder.read("background.pid"));
  for (int k = 0; k < 1200 && !folder.has(ready); ++k) std::this_thread::sleep_for(kMoment);
  EXPECT_TRUE(folder.has(ready)) << folder.read("background.txt");
}

Background::~Background() { end(SIGKILL, true); }

void Background::end(int signal, bool all) {
  if (pid_ == 0) return;
  kill(all ? -pid_ : pid_, signal);
  for (int k = 0; k < 1200 && kill(pid_, 0) == 0; ++k) std::this_thread::sleep_for(kMoment);
  std::this_thread::sleep_for(4 * kMoment);  // what it started ends with it
  pid_ = 0;
}

nlohmann::json Folder::summary(const std::string& run) const {
  return nlohmann::json::parse(read(run + "/summary.json"));
}

std::string quoted(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

int lines_of(const std::string& text) { return static_cast<int>(std::count(text.begin(), text.end(), '\n')); }

int count(const std::string& text, const std::string& pattern) {
  const std::regex form(pattern);
  return static_cast<int>(std::distance(std::sregex_iterator(text.begin(), text.end(), form), std::sregex_iterator()));
}

std::string shared_run(const std::string& name) { return std::string(FOOTFALL_BINARY_DIR) + "/tests/app/runs/" + name; }

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
