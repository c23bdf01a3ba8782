// Looks once a second at the programs below this one, and at the times of files.

#include "mbd_solver/launch/program_watch.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/text_reader.h"
#include "mbd_solver/launch/codes.h"

namespace footfall {
namespace {

constexpr double kBetweenLooks = 1.0;  // [s]

// Time of the last change of the file, or of the latest file in the folder [ns]; 0: there is none.
std::int64_t last_change(const std::string& path) {
  std::error_code none;
  std::int64_t latest = 0;
  if (std::filesystem::is_directory(path, none)) {
    for (const auto& entry : std::filesystem::directory_iterator(path, none))
      latest = std::max(latest, file_changed(entry.path().string()));
    return latest;
  }
  return file_changed(path);
}

}  // namespace

ProgramWatch::ProgramWatch(double limit, std::string pulse, std::string begun, std::string log)
    : limit_(limit), pulse_(std::move(pulse)), begun_(std::move(begun)), log_(std::move(log)), looked_(wall_clock()) {}

std::string ProgramWatch::operator()() {
  const double now = wall_clock(), passed = now - looked_;
  if (passed < kBetweenLooks) return "";
  looked_ = now;
  // A look that comes late ends a stop of this program, in which the others were stopped as well.
  const double counted = std::min(passed, 2.0 * kBetweenLooks);
  gone_ += counted;
  silent_ += count_descendants(true) == 0 ? counted : 0.0;
  const std::string gone = gone_programs();
  return gone.empty() ? silence() : gone;
}

// mpirun waits for ever when it cannot start its programs, or has not noticed their end.
std::string ProgramWatch::gone_programs() {
  constexpr double kEnded = 10.0, kNeverStarted = 60.0;  // [s]
  if (count_descendants(false) > 1) {
    had_programs_ = true;
    gone_ = 0.0;
  }
  const double limit = std::min(limit_, had_programs_ ? kEnded : kNeverStarted);
  if (gone_ < limit) return "";
  return with_code(code::kProgramsGone,
                   std::string("mpirun waits for programs that ") +
                       (had_programs_ ? "have ended" : "it has not started") + ", since " + number_text(limit) +
                       " s; free space in the temporary folder, and allow more open files, processes and larger files "
                       "(ulimit -a)");
}

std::string ProgramWatch::silence() {
  std::error_code none;
  if (!begun_.empty() && std::filesystem::exists(begun_, none)) {
    silent_ = 0.0;
    return "";
  }
  const std::int64_t change = last_change(pulse_);
  if (change != seen_) silent_ = 0.0;
  seen_ = change;
  if (silent_ < limit_) return "";
  const std::string line = TextReader::last_line_of(log_);
  return with_code(code::kProgramSilent,
                   "LIGGGHTS has made no step for " + number_text(limit_) + " s, the limit of coupling.timeout" +
                       (line.empty() ? "" : "; the last line of its log is \"" + line + "\"") +
                       "; correct the script, or raise coupling.timeout if that command takes so long");
}

TimeLimit::TimeLimit(std::string program, double limit)
    : program_(std::move(program)), limit_(limit), started_(wall_clock()) {}

std::string TimeLimit::operator()() const {
  if (wall_clock() - started_ < limit_) return "";
  return with_code(code::kProgramSilent, program_ + " has not ended within " + number_text(limit_) + " s");
}

}  // namespace footfall
