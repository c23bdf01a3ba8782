// The reading thread takes at most a fixed share of the time, whatever the size of the run: it rests so much longer than it works.
#include "mbd_solver/app/live/live_page.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <condition_variable>
#include <cstdlib>
#include <ctime>
#include <mutex>
#include <thread>

#include "coupler/base/clock.h"
#include "coupler/base/files.h"
#include "mbd_solver/app/film/page_camera.h"
#include "mbd_solver/app/live/page_server.h"
#include "mbd_solver/app/live/run_feed.h"
#include "mbd_solver/app/report.h"
#include "mbd_solver/base/child_process.h"
#include "mbd_solver/base/child_watch.h"

namespace footfall {

namespace {

constexpr double kLook = 0.4;                  // least time between two looks [s]
constexpr double kRested = 100.0;              // so much longer than it works, by its processor time: 1 % of one core
constexpr double kFree = 0.5;                  // work that is done at once when a page has been opened [s]
constexpr double kOpening = 8.0;               // a browser that was started may take so long to open the page [s]
constexpr double kReading = 10.0;              // an open page may take so long to read the rest [s]
constexpr int kLowest = 19;                    // priority
constexpr std::size_t kMostKept = 150u << 20;  // bytes of frames, of each kind

// A file that only this user can read, whose page goes to the address: the command line of a browser is readable by all. Beyond the
// reach of run_child, which ends all programs that this one has started.
bool open_browser(const std::string& address, const std::string& folder) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return false;
  const std::string opener = program_in_path("xdg-open");
  if (opener.empty()) return false;
  const std::string file = folder + "/open.html";
  HtmlPage page("A run of footfall");
  page.forward_to(address);
  write_whole_file(file, page.text());
  Command command{Rights::of_user(), {opener, file}};
  command.output = "/dev/null";
  prctl(PR_SET_CHILD_SUBREAPER, 0);
  const pid_t copy = start_copy(
      [&] {
        start_program(command, {}, Orphan::kEndsByItself);
        return 0;
      },
      Orphan::kEndsByItself);
  return copy > 0 && wait_for_end(copy) == 0;
}

// Of this thread [s].
double processor_time_here() {
  timespec now = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// {run, chunks}.
std::string scene_text(const PageParts& parts) {
  nlohmann::ordered_json json = {{"run", parts.run}, {"chunks", nlohmann::ordered_json::object()}};
  for (const auto& [name, text] : parts.chunks) json["chunks"][name] = text;
  return json.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace);
}

// {text, share, over}.
std::string state_text(const std::string& text, double share, bool over) {
  const nlohmann::ordered_json json = {{"text", text}, {"share", share}, {"over", over}};
  return json.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace

struct LivePage::Parts {
  explicit Parts(const std::string& run) : feed(run), server([this] { return page_of(); }) {}

  std::string page_of() {
    const std::lock_guard<std::mutex> lock(feeding);
    const PageParts parts = feed.page();
    return page_text(parts.run.at("title"), "", {{"status", "done"}}, {}, parts);
  }
  // One look; true when the page has to be opened anew, as more is known of the run.
  void look(bool last) {
    std::vector<LiveEvent> events;
    {
      const std::lock_guard<std::mutex> lock(feeding);
      const bool was_known = feed.is_known();
      events = feed.look(last);
      if (!was_known && feed.is_known()) server.send("scene", scene_text(feed.page()), "scene");
    }
    for (LiveEvent& event : events) {
      const std::string kind = event.kind;
      server.send(kind, std::move(event.data));
      while (server.kept(kind) > kMostKept) server.thin(kind);
    }
  }
  void work() {
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kLowest);
    double worked = 0.0, opened = -1.0, due = 0.0;
    std::unique_lock<std::mutex> lock(waiting);
    for (;;) {
      wake.wait_for(lock, std::chrono::duration<double>(std::max(kLook, due)), [&] { return ends; });
      if (ends) return;
      if (server.readers() == 0) continue;
      was_read = true;
      const double start = processor_time_here();
      if (opened < 0.0) opened = wall_clock();
      lock.unlock();
      look(false);
      lock.lock();
      worked += processor_time_here() - start;
      due = std::max(0.0, kRested * (worked - kFree) - (wall_clock() - opened));
    }
  }

  void stop() {
    {
      const std::lock_guard<std::mutex> lock(waiting);
      ends = true;
    }
    wake.notify_all();
    if (reader.joinable()) reader.join();
  }

  std::mutex feeding;  // of the feed
  RunFeed feed;
  PageServer server;
  ScratchFolder folder{"footfall_live"};
  bool has_browser = false;
  double began = wall_clock();
  std::mutex waiting;
  std::condition_variable wake;
  bool ends = false;
  std::atomic<bool> was_read{false};
  std::thread reader;
};

LivePage::LivePage(const std::string& run) {
  const SignalsHeld signals;  // threads that begin here leave them to the others
  parts_ = std::make_unique<Parts>(run);
  Parts* const parts = parts_.get();
  parts->reader = std::thread([parts] { parts->work(); });
  parts->has_browser = open_browser(parts->server.address(), parts->folder.path());
}

LivePage::~LivePage() { parts_->stop(); }

std::string LivePage::announcement() const { return "Live page: " + parts_->server.address(); }

bool LivePage::is_open() const { return parts_->server.readers() > 0; }

void LivePage::tell(const std::string& text, double share) {
  parts_->server.send("state", state_text(text, share, false), "state");
}

void LivePage::finish(const std::string& text) {
  parts_->stop();
  const auto wait = [&](double until, const auto& done) {
    while (!done() && wall_clock() < until) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  };
  if (parts_->has_browser)
    wait(parts_->began + kOpening, [&] { return parts_->server.readers() > 0 || parts_->was_read; });
  if (parts_->server.readers() == 0) return;
  parts_->look(true);
  parts_->server.send("state", state_text(text, 1.0, true), "state");
  wait(wall_clock() + kReading, [&] { return parts_->server.all_is_read(); });
}

}  // namespace footfall
