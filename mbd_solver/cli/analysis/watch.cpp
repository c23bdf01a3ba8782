#include "mbd_solver/cli/analysis/watch.h"

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <optional>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "coupler/base/live_line.h"
#include "coupler/base/made_files.h"
#include "coupler/base/text.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/analysis/gnuplot.h"
#include "mbd_solver/cli/analysis/html_page.h"
#include "mbd_solver/cli/analysis/plots.h"
#include "mbd_solver/cli/launch/process.h"
#include "mbd_solver/cli/launch/programs.h"

namespace footfall {

namespace fs = std::filesystem;

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
