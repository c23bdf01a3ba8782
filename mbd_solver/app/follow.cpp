// Reads the folder of a run repeatedly: lock, run.json, the last row of history.csv, summary.json, LIGGGHTS' log.
#include "mbd_solver/app/follow.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "coupler/base/start.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/base/child_watch.h"
#include "mbd_solver/base/live_line.h"
#include "mbd_solver/base/lock.h"
#include "mbd_solver/bed/liggghts_log.h"
#include "mbd_solver/launch/programs.h"
#include "mbd_solver/session/output/summary.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

// The folder is locked, and its summary is not of this run.
bool is_in_progress(const fs::path& run) {
  const fs::path lock = run / kLockFile, summary = run / "summary.json";
  if (!is_alive(owner_of(lock.string()))) return false;
  std::error_code error;
  if (!fs::exists(summary, error)) return true;
  return fs::last_write_time(summary, error) < fs::last_write_time(lock, error);
}

RunProgress::State state_of(const std::string& status) {
  if (status == "done") return RunProgress::State::kDone;
  return status == "interrupted" ? RunProgress::State::kInterrupted : RunProgress::State::kFailed;
}

double largest_contact(const LastRow& row) {
  double largest = 0.0;
  for (std::size_t i = 0; i + 2 < row.names.size(); ++i) {
    if (!ends_with(row.names[i], ".contact.fx")) continue;
    const double* f = &row.values[i];
    largest = std::max(largest, std::sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]));
  }
  return largest;
}

}  // namespace

RunProgress progress_of_run(const std::string& run, HistoryTail& history) {
  const fs::path folder(run);
  const bool ended = fs::exists(folder / "summary.json");
  if (!ended && !fs::exists(folder / kLockFile) && !fs::exists(folder / "history.csv"))
    throw InputError(code::kNoRun, run + ": holds neither a run in progress nor the results of one");
  RunProgress progress;
  if (fs::exists(folder / kRunNote)) progress.end_time = read_run_note(run).end_time;
  history.read();
  const LastRow row = history.last();
  progress.rows = row.rows;
  if (row.rows > 0) {
    progress.state = RunProgress::State::kRunning;
    progress.time = row.values.front();
    progress.contact_force = largest_contact(row);
  } else if (const LogProgress log = log_progress((folder / "liggghts.log").string()); log.begun()) {
    progress.preparation = log.text();
  }
  if (is_in_progress(folder)) return progress;
  progress.state = RunProgress::State::kGone;
  if (!fs::exists(folder / "summary.json")) return progress;  // looked for again: it may have been written since
  const nlohmann::ordered_json summary = read_summary((folder / "summary.json").string());
  return with_summary_of(run, [&] {
    progress.state = state_of(summary.value("status", ""));
    progress.reason = summary.value("reason", "");
    progress.at_start = summary.value(kFailedAtStart, false);
    return progress;
  });
}

namespace {

bool is_over(const RunProgress& progress) {
  return progress.state != RunProgress::State::kSettingUp && progress.state != RunProgress::State::kRunning;
}

int exit_code(const RunProgress& progress) {
  using State = RunProgress::State;
  if (progress.state == State::kFailed || progress.state == State::kGone) return kExitFailed;
  return progress.state == State::kInterrupted ? kExitInterrupted : kExitDone;
}

double share_of(const RunProgress& progress) {
  return progress.end_time > 0.0 ? progress.time / progress.end_time : 0.0;
}

std::string how_it_ended(const RunProgress& progress) {
  const std::string reason = progress.reason.empty() ? "" : ": " + progress.reason;
  switch (progress.state) {
    case RunProgress::State::kDone: return "done" + reason;
    case RunProgress::State::kFailed: return (progress.at_start ? "failed at the start" : "failed") + reason;
    case RunProgress::State::kInterrupted: return "interrupted" + reason;
    case RunProgress::State::kGone: return "its programs have ended without a summary; they may have been killed";
    case RunProgress::State::kSettingUp:
    case RunProgress::State::kRunning: break;
  }
  return "";
}

std::string sentence(const RunProgress& progress, const Pace& pace) {
  if (progress.rows == 0) {
    const std::string what = progress.preparation.empty() ? "making the bed, or setting up" : progress.preparation;
    return is_over(progress) ? how_it_ended(progress) : "before the first row: " + what;
  }
  std::string text = progress.end_time > 0.0 ? time_text(progress.time, progress.end_time, pace)
                                             : "t = " + fixed_text(progress.time, 4) + " s";
  text +=
      " | " + std::to_string(progress.rows) + " rows | contact " + fixed_text(progress.contact_force / 1e3, 2) + " kN";
  return is_over(progress) ? text + " | " + how_it_ended(progress) : text;
}

// False when a signal asks for the end.
bool wait_for(double seconds) {
  const SignalsHeld signals;
  for (const double end = wall_clock() + seconds; wall_clock() < end;)
    if (signals.wait()) return false;
  return true;
}

// The run itself; of a sweep the newest of its runs in progress.
std::string run_to_follow(const std::string& folder) {
  const fs::path path(folder);
  std::string newest;
  fs::file_time_type when = fs::file_time_type::min();
  std::error_code error;
  if (fs::exists(path / kRunNote, error) || fs::exists(path / kLockFile, error) ||
      fs::exists(path / "history.csv", error))
    return folder;
  fs::recursive_directory_iterator it(path, fs::directory_options::skip_permission_denied, error), end;
  for (; !error && it != end; it.increment(error)) {
    if (it->path().filename() != kLockFile || !is_in_progress(it->path().parent_path())) continue;
    std::error_code gone;
    const fs::file_time_type changed = fs::last_write_time(it->path(), gone);
    if (gone || changed <= when) continue;
    when = changed;
    newest = it->path().parent_path().string();
  }
  return newest.empty() ? folder : newest;
}

}  // namespace

int follow_run(const FollowArguments& arguments) {
  const std::string run = run_to_follow(arguments.run);
  HistoryTail history((fs::path(run) / "history.csv").string());
  RunProgress progress = progress_of_run(run, history);
  const double began = wall_clock(), first = share_of(progress);
  LiveLine line(false, isatty(STDOUT_FILENO) == 1);
  std::optional<LivePage> page;
  if (run != arguments.run) std::printf("%s\n", short_path(run).c_str());
  if (!arguments.once && !is_over(progress)) {
    page.emplace(run);
    std::printf("%s\n", page->announcement().c_str());
    std::fflush(stdout);
  }
  for (bool first_time = true;; progress = progress_of_run(run, history)) {
    const Pace pace{share_of(progress), share_of(progress) - first, wall_clock() - began};
    const bool last = is_over(progress) || arguments.once;
    const std::string text = sentence(progress, pace);
    if (line.due(pace.share) || first_time || last) line.show(text);
    if (page) is_over(progress) ? page->finish(text) : page->tell(text, pace.share);
    first_time = false;
    if (last || output_is_unread()) break;
    if (!wait_for(arguments.interval)) {
      line.finish();
      return kExitInterrupted;
    }
  }
  line.finish();
  return exit_code(progress);
}

FollowedRun::FollowedRun(const std::string& run)
    : run_(run), history_((fs::path(run) / "history.csv").string()), page_(run), began_(wall_clock()), next_(began_) {
  std::printf("%s\n", page_.announcement().c_str());
  std::fflush(stdout);
}

void FollowedRun::tell() {
  if (wall_clock() < next_ || !page_.is_open()) return;
  next_ = wall_clock() + 1.0;
  const RunProgress progress = progress_of_run(run_, history_);
  const double share = share_of(progress);
  page_.tell(sentence(progress, {share, share, wall_clock() - began_}), share);
}

void FollowedRun::finish() {
  std::string text = "the run has ended";
  try {
    const RunProgress progress = progress_of_run(run_, history_);
    text = sentence(progress, {share_of(progress), 0.0, 0.0});
  } catch (const InputError&) {  // it ended before it wrote anything
  }
  page_.finish(text);
}

}  // namespace footfall
