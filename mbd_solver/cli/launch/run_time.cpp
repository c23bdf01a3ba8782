#include "mbd_solver/cli/launch/run_time.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "coupler/interrupt.h"
#include "mbd_solver/cli/launch/child.h"
#include "mbd_solver/cli/launch/programs.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

// A folder that is gone with everything in it at the end.
struct ScratchFolder {
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "footfall_check_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw InputError(name + ": cannot be made");
    path = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  fs::path path;
};

// Time of the last whole row of a history that grows; negative: none yet.
double last_time(const fs::path& history) {
  constexpr std::streamoff kLongestRow = 1 << 20;
  std::ifstream in(history, std::ios::binary | std::ios::ate);
  if (!in) return -1.0;
  const std::streamoff size = in.tellg(), from = std::max<std::streamoff>(0, size - kLongestRow);
  std::string text(static_cast<std::size_t>(size - from), '\0');
  in.seekg(from);
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  const std::size_t end = text.rfind('\n');
  if (end == std::string::npos || end == 0) return -1.0;
  const std::size_t before = text.rfind('\n', end - 1);
  if (before == std::string::npos) return -1.0;
  char* stop = nullptr;
  const double time = std::strtod(text.c_str() + before + 1, &stop);
  return stop != nullptr && *stop == ',' ? time : -1.0;
}

std::string seconds_text(double seconds) {
  return seconds < 100.0    ? number_text(seconds, 2) + " s"
         : seconds < 6000.0 ? number_text(seconds / 60.0, 2) + " min"
                            : number_text(seconds / 3600.0, 2) + " h";
}

}  // namespace

double expected_run_time(const std::vector<TimeMark>& marks, double end) {
  if (marks.empty() || !(marks.back().reached > 0.0)) return 0.0;
  const TimeMark& last = marks.back();
  if (last.reached >= end * (1.0 - 1e-9)) return last.clock;
  // The start is not like the rest: a mechanism is built, and falls freely.
  std::size_t middle = 0;
  while (middle + 2 < marks.size() && marks[middle].clock < 0.5 * last.clock) ++middle;
  const TimeMark& from = marks[middle];
  const double moved = last.reached - from.reached;
  if (!(moved > 0.0)) return last.clock * end / last.reached;
  return last.clock + (end - last.reached) * (last.clock - from.clock) / moved;
}

std::string run_time_report(const std::string& scene, const std::vector<std::string>& settings, double end,
                            double seconds) {
  const ScratchFolder scratch;
  Command command;
  const fs::path out = scratch.path / "run";
  command.words = {built_program("mbd_solver"), scene, "--out", out.string(), "--quiet", "--keep-every", "0"};
  for (const std::string& setting : settings) {
    command.words.push_back("--set");
    command.words.push_back(setting);
  }
  command.output = (scratch.path / "log").string();
  std::vector<TimeMark> marks{{0.0, 0.0}};
  const double started = wall_clock();
  const ChildEnd child = run_child(command, "mbd_solver", [&]() -> std::string {
    const TimeMark now{wall_clock() - started, last_time(out / "history.csv")};
    if (now.reached > marks.back().reached) marks.push_back(now);
    return now.clock > seconds && marks.size() > 2 ? "enough is known" : "";
  });
  if (child.interrupted) throw Interrupted("footfall check: interrupted");
  const double took = wall_clock() - started;
  if (child.given_up.empty()) {
    if (child.code == kExitDone)
      return "Run time: " + seconds_text(took) + " for " + number_text(end) + " s, the whole run. Plots come on top.\n";
    return "Run time: the run ends with an error after " + seconds_text(took) + "; `" + called_as() +
           " run` says which.\n";
  }
  return "Run time: about " + seconds_text(expected_run_time(marks, end)) + " for " + number_text(end) +
         " s, by a run up to t = " + number_text(marks.back().reached, 3) +
         " s; what comes later may be slower or faster. Plots come on top.\n";
}

}  // namespace footfall
