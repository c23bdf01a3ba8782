#include "mbd_solver/cli/launch/grain_rows.h"

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/whole_file.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStart = "gravity from ";  // in the first line, then the number

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

GrainsKept read_grains_kept(const std::string& checkpoint) {
  const std::string file = checkpoint + "/grains.txt", mark = "\nstep ";
  const std::string text = read_whole_file(file).value_or("");
  const std::size_t at = text.find(mark);
  if (at == std::string::npos) throw InputError(file + ": does not tell at which step LIGGGHTS was");
  return {std::strtol(text.c_str() + at + mark.size(), nullptr, 10)};
}

std::string set_rows_aside(const std::string& run, long step) {
  join_rows(run);
  const std::optional<std::string> text = read_whole_file(rows_of(run).string());
  if (!text) return "";
  write_whole_file(rows_aside(run).string(), rows_between(*text, -1, step, true));
  const std::size_t at = text->find(kStart), line = text->find('\n');
  if (at == std::string::npos || at > line) return "";
  std::istringstream number(text->substr(at + std::string(kStart).size()));
  std::string start;
  number >> start;
  return start;
}

void join_rows(const std::string& run) {
  const std::optional<std::string> before = read_whole_file(rows_aside(run).string());
  if (!before) return;
  const std::string after = read_whole_file(rows_of(run).string()).value_or("");
  write_whole_file(rows_of(run).string(), *before + rows_between(after, last_step(*before), 1L << 62, false));
  fs::remove(rows_aside(run));
}

}  // namespace footfall
