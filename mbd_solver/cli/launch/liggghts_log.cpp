#include "mbd_solver/cli/launch/liggghts_log.h"

#include <cstdio>
#include <fstream>
#include <sstream>

#include "coupler/base/clock.h"
#include "coupler/base/text.h"

namespace footfall {
namespace {

// The last line that is not empty, of the file's last few thousand bytes.
std::string last_line(const std::string& path) {
  constexpr std::streamoff kTail = 4096;
  std::ifstream file(path, std::ios::ate);
  if (!file) return "";
  const std::streamoff size = file.tellg();
  file.seekg(size > kTail ? size - kTail : 0);
  std::string line, last;
  while (std::getline(file, line))
    if (!line.empty()) last = line;
  return last;
}

}  // namespace

std::string log_progress(const std::string& log) {
  std::ifstream file(log);
  std::string line;
  long step = -1, last = -1;
  while (std::getline(file, line)) {
    long number = 0;
    char rest = 0;
    if (std::sscanf(line.c_str(), "run %ld %c", &number, &rest) == 1 && number > 0) last = number;
    double columns[2];
    if (std::sscanf(line.c_str(), "%ld %lf %lf", &number, &columns[0], &columns[1]) == 3) step = number;
  }
  if (step < 0) return "setting up";
  return "step " + std::to_string(step) + (last > 0 ? " of " + std::to_string(last) : "");
}

std::string liggghts_errors(const std::string& log) {
  std::ifstream file(log);
  std::string line, errors, before;
  while (std::getline(file, line)) {
    if (line.rfind("ERROR", 0) == 0 || line.rfind("Fix couple", 0) == 0) errors += (errors.empty() ? "" : "\n") + line;
  }
  return errors;
}

std::string ReadingWatch::operator()() {
  const double now = wall_clock();
  if (now < next_look_) return "";
  next_look_ = now + 1.0;
  const std::string line = last_line(log_);
  const bool reads = line.rfind("read_restart", 0) == 0 || line.rfind("Reading restart", 0) == 0;
  since_ = !reads ? 0.0 : since_ > 0.0 ? since_ : now;
  if (!reads || now - since_ < limit_) return "";
  return "LIGGGHTS has been at \"" + line + "\" for " + number_text(limit_) + " s: the file is damaged, make it anew";
}

}  // namespace footfall
