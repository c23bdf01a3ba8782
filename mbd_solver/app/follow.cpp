// Reads the folder of a run repeatedly: lock, run.json, the last row of history.csv, summary.json, LIGGGHTS' log.
#include "mbd_solver/app/follow.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/start.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/app/plot_script.h"
#include "mbd_solver/app/plots.h"
#include "mbd_solver/app/report.h"
#include "mbd_solver/base/child_watch.h"
#include "mbd_solver/base/csv.h"
#include "mbd_solver/base/live_line.h"
#include "mbd_solver/base/lock.h"
#include "mbd_solver/bed/liggghts_log.h"
#include "mbd_solver/bed/programs.h"
#include "mbd_solver/run/output/summary.h"

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

LastRow last_row(const std::string& history) {
  LastRow row;
  const std::optional<std::string> text = read_whole_file(history);
  if (!text) return row;
  const std::size_t units = text->find('\n');
  const std::size_t names = units == std::string::npos ? units : text->find('\n', units + 1);
  const std::size_t end = text->rfind('\n');
  if (names == std::string::npos) return row;
  row.names = split(text->substr(units + 1, names - units - 1), ',');
  row.rows = std::count(text->begin() + static_cast<long>(names) + 1, text->begin() + static_cast<long>(end) + 1, '\n');
  if (row.rows == 0) return row;
  const std::size_t start = text->rfind('\n', end - 1) + 1;
  for (const std::string& cell : split(text->substr(start, end - start), ','))
    if (!read_number(cell, row.values.emplace_back()))
      throw InputError(code::kRunDamaged, history + ": \"" + cell + "\" in the last row, expected a number");
  if (row.values.size() != row.names.size())
    throw InputError(code::kRunDamaged, history + ": its last row has " + std::to_string(row.values.size()) +
                                            " values, expected " + std::to_string(row.names.size()));
  return row;
}

RunProgress progress_of_run(const std::string& run) {
  const fs::path folder(run);
  const bool ended = fs::exists(folder / "summary.json");
  if (!ended && !fs::exists(folder / kLockFile) && !fs::exists(folder / "history.csv"))
    throw InputError(code::kNoRun, run + ": holds neither a run in progress nor the results of one");
  RunProgress progress;
  if (fs::exists(folder / kRunNote)) {
    const RunNote note = read_run_note(run);
    progress.title = note.title;
    progress.end_time = note.end_time;
  }
  const LastRow row = last_row((folder / "history.csv").string());
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
    return progress;
  });
}

namespace {

constexpr double kPageInterval = 5.0;  // least time between two pages, as gnuplot takes time from the run [s]

bool is_over(const RunProgress& progress) {
  return progress.state != RunProgress::State::kSettingUp && progress.state != RunProgress::State::kRunning;
}

int exit_code(const RunProgress& progress) {
  switch (progress.state) {
    case RunProgress::State::kFailed:
    case RunProgress::State::kGone: return kExitFailed;
    case RunProgress::State::kInterrupted: return kExitInterrupted;
    case RunProgress::State::kSettingUp:
    case RunProgress::State::kRunning:
    case RunProgress::State::kDone: break;
  }
  return kExitDone;
}

double share_of(const RunProgress& progress) {
  return progress.end_time > 0.0 ? progress.time / progress.end_time : 0.0;
}

std::string how_it_ended(const RunProgress& progress) {
  const std::string reason = progress.reason.empty() ? "" : ": " + progress.reason;
  switch (progress.state) {
    case RunProgress::State::kDone: return "done" + reason;
    case RunProgress::State::kFailed: return "failed" + reason;
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

// Plots of the rows so far. gnuplot works in a temporary folder, so that nothing of the run is touched.
class Page {
 public:
  explicit Page(std::string run)
      : run_(std::move(run)), work_(fs::temp_directory_path() / ("footfall_watch_" + std::to_string(getpid()))) {
    fs::create_directories(work_ / "plots");
  }
  ~Page() {
    std::error_code ignored;
    fs::remove_all(work_, ignored);
  }
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;

  void write(const RunProgress& progress, const Pace& pace, double interval) {
    const std::string title =
        progress.title.empty() ? fs::absolute(run_).lexically_normal().filename().string() : progress.title;
    HtmlPage page(title);
    page.paragraph(sentence(progress, pace));
    if (!is_over(progress)) page.refresh(static_cast<int>(interval + 0.5));
    if (progress.rows > 1) {
      page.section("Plots");
      for (const std::string& picture : pictures()) page.picture(picture);
    }
    if (is_over(progress)) {
      page.section("Results");
      for (const char* name : {"report.html", "view.html", "history.csv", "summary.json"})
        if (fs::exists(fs::path(run_) / name)) page.link(name, name, "of this run");
    }
    write_whole_file((fs::path(run_) / "watch.html").string(), page.text(), "is the disk full?");
  }

 private:
  std::vector<std::string> pictures() const {
    // Complete rows only: the last one may be in writing.
    const std::string text = read_whole_file((fs::path(run_) / "history.csv").string()).value_or("");
    const fs::path copy = work_ / "history.csv";
    write_whole_file(copy.string(), text.substr(0, text.rfind('\n') + 1), "is the disk full?");
    const History history = read_history(copy.string());
    std::vector<Figure> figures = standard_figures(history, "");
    const std::string plots = (work_ / "plots").string();
    thin_figures(figures, history, plots, "curves");
    std::vector<std::string> scripts = write_plot_scripts(plots, figures, "");
    if (!scripts.empty()) scripts.pop_back();  // the overview of all, which are on this page already
    return run_gnuplot(plots, scripts);
  }

  std::string run_;
  fs::path work_;
};

// False when a signal asks for the end.
bool wait_for(double seconds) {
  const SignalsHeld signals;
  for (const double end = wall_clock() + seconds; wall_clock() < end;)
    if (signals.wait()) return false;
  return true;
}

}  // namespace

int follow_run(const FollowArguments& arguments) {
  RunProgress progress = progress_of_run(arguments.run);
  const double began = wall_clock(), first = share_of(progress);
  LiveLine line(false, isatty(STDOUT_FILENO) == 1);
  std::optional<Page> page;
  if (arguments.page) page.emplace(arguments.run);
  const double interval = std::max(arguments.interval, kPageInterval);
  double next_page = 0.0;
  for (bool first_time = true;; progress = progress_of_run(arguments.run)) {
    const Pace pace{share_of(progress), share_of(progress) - first, wall_clock() - began};
    const bool last = is_over(progress) || arguments.once;
    if (line.due(pace.share) || first_time || last) line.show(sentence(progress, pace));
    if (page && (last || wall_clock() >= next_page)) {
      page->write(progress, pace, interval);
      if (first_time) {
        line.finish();
        std::printf("%s\n", short_path(arguments.run + "/watch.html").c_str());
      }
      next_page = wall_clock() + interval;
    }
    first_time = false;
    if (last || (!page && output_is_unread())) break;
    if (!wait_for(arguments.interval)) {
      line.finish();
      return kExitInterrupted;
    }
  }
  line.finish();
  return exit_code(progress);
}

}  // namespace footfall
