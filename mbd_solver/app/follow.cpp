// One look at the folder of a run: mbd_solver/app/follow.h
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
#include "coupler/base/text.h"
#include "mbd_solver/app/plot_script.h"
#include "mbd_solver/app/plots.h"
#include "mbd_solver/app/report.h"
#include "mbd_solver/base/live_line.h"
#include "mbd_solver/base/lock.h"
#include "mbd_solver/base/made_files.h"
#include "mbd_solver/bed/liggghts_log.h"
#include "mbd_solver/bed/process.h"
#include "mbd_solver/bed/programs.h"
#include "mbd_solver/run/output/summary.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

// Somebody runs into the folder, and has not yet said how it ended.
bool goes_on(const fs::path& run) {
  const fs::path lock = run / kLockFile, summary = run / "summary.json";
  if (!is_alive(owner_of(lock.string()))) return false;
  std::error_code error;
  if (!fs::exists(summary, error)) return true;
  return fs::last_write_time(summary, error) < fs::last_write_time(lock, error);
}

RunLook::State state_of(const std::string& status) {
  if (status == "done") return RunLook::State::kDone;
  return status == "interrupted" ? RunLook::State::kInterrupted : RunLook::State::kFailed;
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
    row.values.push_back(std::strtod(cell.c_str(), nullptr));
  if (row.values.size() != row.names.size())
    throw InputError(history + ": its last row has " + std::to_string(row.values.size()) + " values, expected " +
                     std::to_string(row.names.size()));
  return row;
}

RunLook look_at_run(const std::string& run) {
  const fs::path folder(run);
  const bool ended = fs::exists(folder / "summary.json");
  if (!ended && !fs::exists(folder / kLockFile) && !fs::exists(folder / "history.csv"))
    throw InputError(run + ": holds neither a run that is under way nor the results of one");
  RunLook look;
  if (fs::exists(folder / kRunNote)) {
    const RunNote note = read_run_note(run);
    look.title = note.title;
    look.end_time = note.end_time;
  }
  const LastRow row = last_row((folder / "history.csv").string());
  look.rows = row.rows;
  if (row.rows > 0) {
    look.state = RunLook::State::kRunning;
    look.time = row.values.front();
    look.contact_force = largest_contact(row);
  } else if (const LogProgress log = log_progress((folder / "liggghts.log").string()); log.begun()) {
    look.preparation = log.text();
  }
  if (goes_on(folder)) return look;
  look.state = RunLook::State::kGone;
  if (!ended) return look;
  const nlohmann::ordered_json summary = read_summary((folder / "summary.json").string());
  return with_summary_of(run, [&] {
    look.state = state_of(summary.value("status", ""));
    look.reason = summary.value("reason", "");
    return look;
  });
}

namespace {

constexpr double kPageInterval = 5.0;  // at least so long between two pages: gnuplot takes time that the run needs [s]

bool is_over(const RunLook& look) {
  return look.state != RunLook::State::kSettingUp && look.state != RunLook::State::kRunning;
}

int exit_code(const RunLook& look) {
  switch (look.state) {
    case RunLook::State::kFailed:
    case RunLook::State::kGone: return kExitFailed;
    case RunLook::State::kInterrupted: return kExitInterrupted;
    case RunLook::State::kSettingUp:
    case RunLook::State::kRunning:
    case RunLook::State::kDone: break;
  }
  return kExitDone;
}

double share_of(const RunLook& look) { return look.end_time > 0.0 ? look.time / look.end_time : 0.0; }

std::string how_it_ended(const RunLook& look) {
  const std::string reason = look.reason.empty() ? "" : ": " + look.reason;
  switch (look.state) {
    case RunLook::State::kDone: return "done" + reason;
    case RunLook::State::kFailed: return "failed" + reason;
    case RunLook::State::kInterrupted: return "interrupted" + reason;
    case RunLook::State::kGone: return "its programs are gone, and left no summary: were they killed?";
    case RunLook::State::kSettingUp:
    case RunLook::State::kRunning: break;
  }
  return "";
}

std::string sentence(const RunLook& look, const Pace& pace) {
  if (look.rows == 0) {
    const std::string what = look.preparation.empty() ? "it makes its bed, or sets up" : look.preparation;
    return is_over(look) ? how_it_ended(look) : "before the first row: " + what;
  }
  std::string text =
      look.end_time > 0.0 ? time_text(look.time, look.end_time, pace) : "t = " + fixed_text(look.time, 4) + " s";
  text += " | " + std::to_string(look.rows) + " rows | contact " + fixed_text(look.contact_force / 1e3, 2) + " kN";
  return is_over(look) ? text + " | " + how_it_ended(look) : text;
}

// Pictures of the rows so far. The folder of the run stays as it is: gnuplot works in one of its own.
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

  void write(const RunLook& look, const Pace& pace, double interval) {
    const std::string title =
        look.title.empty() ? fs::absolute(run_).lexically_normal().filename().string() : look.title;
    HtmlPage page(title);
    page.paragraph(sentence(look, pace));
    if (!is_over(look)) page.refresh(static_cast<int>(interval + 0.5));
    if (look.rows > 1) {
      page.section("Plots");
      for (const std::string& picture : pictures()) page.picture(picture);
    }
    if (is_over(look)) {
      page.section("Results");
      for (const char* name : {"report.html", "view.html", "history.csv", "summary.json"})
        if (fs::exists(fs::path(run_) / name)) page.link(name, name, "of this run");
    }
    const MadeFiles made(run_);
    write_whole_file((fs::path(run_) / "watch.html").string(), page.text(), "is the disk full?");
  }

 private:
  std::vector<std::string> pictures() const {
    // Whole rows alone: the last one may be in writing.
    const std::string text = read_whole_file((fs::path(run_) / "history.csv").string()).value_or("");
    const fs::path copy = work_ / "history.csv";
    write_whole_file(copy.string(), text.substr(0, text.rfind('\n') + 1), "is the disk full?");
    const History history = read_history(copy.string());
    std::vector<Figure> figures = standard_figures(history, "");
    const std::string plots = (work_ / "plots").string();
    reduce_long_figures(figures, history, plots);
    std::vector<std::string> scripts = write_plot_scripts(plots, figures, "");
    if (!scripts.empty()) scripts.pop_back();  // all on one page: they stand there alone already
    return run_gnuplot(plots, scripts);
  }

  std::string run_;
  fs::path work_;
};

// False when we are asked to end.
bool wait_for(double seconds) {
  const SignalsHeld signals;
  for (const double end = wall_clock() + seconds; wall_clock() < end;)
    if (signals.wait()) return false;
  return true;
}

}  // namespace

int watch_run(const WatchArguments& arguments) {
  RunLook look = look_at_run(arguments.run);
  const double began = wall_clock(), first = share_of(look);
  LiveLine line(false, isatty(STDOUT_FILENO) == 1);
  std::optional<Page> page;
  if (arguments.page) page.emplace(arguments.run);
  const double interval = std::max(arguments.interval, kPageInterval);
  double next_page = 0.0;
  for (bool told = false;; look = look_at_run(arguments.run)) {
    const Pace pace{share_of(look), share_of(look) - first, wall_clock() - began};
    const bool last = is_over(look) || arguments.once;
    if (line.due(pace.share) || !told || last) line.show(sentence(look, pace));
    if (page && (last || wall_clock() >= next_page)) {
      page->write(look, pace, interval);
      if (!told) {
        line.finish();
        std::printf("%s\n", short_path(arguments.run + "/watch.html").c_str());
      }
      next_page = wall_clock() + interval;
    }
    told = true;
    if (last) break;
    if (!wait_for(arguments.interval)) {
      line.finish();
      return kExitInterrupted;
    }
  }
  line.finish();
  return exit_code(look);
}

}  // namespace footfall
