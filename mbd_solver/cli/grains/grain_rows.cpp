#include "mbd_solver/cli/grains/grain_rows.h"

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/whole_file.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

fs::path rows_of(const std::string& run) { return fs::path(run) / "grains_energy.txt"; }
fs::path rows_aside(const std::string& run) { return fs::path(run) / "grains_energy.before.txt"; }

// Lines of the text whose step is in (after, until]; comments on request.
std::string rows_between(const std::string& text, long after, long until, bool comments) {
  std::istringstream lines(text);
  std::string line, kept;
  while (std::getline(lines, line)) {
    const bool comment = !line.empty() && line[0] == '#';
    const long step = std::strtol(line.c_str(), nullptr, 10);
    if (comment ? comments : step > after && step <= until) kept += line + "\n";
  }
  return kept;
}

long last_step(const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  long step = -1;
  while (std::getline(lines, line))
    if (!line.empty() && line[0] != '#') step = std::strtol(line.c_str(), nullptr, 10);
  return step;
}

}  // namespace

long step_of_checkpoint(const std::string& checkpoint) {
  const std::string file = checkpoint + "/grains.txt", mark = "\nstep ";
  const std::string text = read_whole_file(file).value_or("");
  const std::size_t at = text.find(mark);
  if (at == std::string::npos) throw InputError(file + ": does not tell at which step LIGGGHTS was");
  return std::strtol(text.c_str() + at + mark.size(), nullptr, 10);
}

void set_rows_aside(const std::string& run, long step) {
  join_rows(run);
  if (const std::optional<std::string> text = read_whole_file(rows_of(run).string()))
    write_whole_file(rows_aside(run).string(), rows_between(*text, -1, step, true));
}

std::string energy_at_start(const std::string& run) {
  std::istringstream text(read_whole_file(run + "/grains_energy_start.txt").value_or(""));
  std::string number;
  text >> number;
  return number;
}

void join_rows(const std::string& run) {
  const std::optional<std::string> before = read_whole_file(rows_aside(run).string());
  if (!before) return;
  const std::string after = read_whole_file(rows_of(run).string()).value_or("");
  write_whole_file(rows_of(run).string(), *before + rows_between(after, last_step(*before), 1L << 62, false));
  fs::remove(rows_aside(run));
}

}  // namespace footfall
