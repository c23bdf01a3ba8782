// The page of a run in progress: run --view and view --follow. A client reads its events; Chromium, where it is installed, shows it.
#include <gtest/gtest.h>
#include <httplib.h>
#undef _res  // a macro of resolv.h, and a name in Eigen
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <thread>

#include "mbd_solver/app/film/page_camera.h"
#include "tests/app/programs.h"

namespace footfall {
namespace {

using app::holds;
using nlohmann::json;

// Half a minute at most, for what the run and its page do in a moment on a quiet machine.
template <class Done>
bool comes_true(const Done& done, int tenths = 600) {
  for (int k = 0; k < tenths && !done(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  return done();
}

class Live : public ::testing::Test {
 protected:
  const app::Folder folder{"live"};
  // Of some seconds, without grains.
  const std::string landing =
      " run " + app::kInputs + "/rigid_plane --set flexible=false --set output.plots=false --until 0.4 --out run";

  // Port and token of the address that a program has printed into this file.
  void find_page(const std::string& file = "background.txt") {
    std::smatch found;
    const auto printed = [&] {
      const std::string said = folder.has(file) ? folder.read(file) : "";
      if (!std::regex_search(said, found, std::regex("http://127\\.0\\.0\\.1:([0-9]+)(/[0-9a-f]{32}/)"))) return false;
      port = std::stoi(found[1]);
      home = found[2];
      return true;
    };
    ASSERT_TRUE(comes_true(printed)) << folder.read(file);
  }
  std::string address() const { return "http://127.0.0.1:" + std::to_string(port) + home; }
  // Reads the events of the page until `enough`, or the stream ends.
  template <class Enough>
  void read_events(const Enough& enough) {
    httplib::Client client("127.0.0.1", port);
    client.set_read_timeout(60);
    std::string text;
    client.Get(home + "events", [&](const char* bytes, std::size_t count) {
      text.append(bytes, count);
      for (std::size_t end; (end = text.find("\n\n")) != std::string::npos; text.erase(0, end + 2)) {
        const std::size_t kind = text.find("event: "), data = text.find("\ndata: ");
        if (kind == std::string::npos || data == std::string::npos || data > end) continue;
        events.emplace_back(text.substr(kind + 7, text.find('\n', kind) - kind - 7),
                            json::parse(text.substr(data + 7, end - data - 7)));
      }
      return !enough();
    });
  }
  long events_of(const std::string& kind) const {
    return std::count_if(events.begin(), events.end(), [&](const auto& event) { return event.first == kind; });
  }
  bool is_over() const {
    return std::any_of(events.begin(), events.end(),
                       [](const auto& e) { return e.first == "state" && e.second.at("over") == true; });
  }

  int port = 0;
  std::string home;
  std::vector<std::pair<std::string, json>> events;
};

TEST_F(Live, ARunFeedsItsPageAndItsHistoryIsTheSame) {
  folder.done(landing.substr(1) + "_alone --quiet");
  {
    app::Background run(folder, test::RunFolder::program("footfall") + landing + " --view", "run/history.csv");
    find_page();
    read_events([&] { return is_over(); });
    run.wait();
  }
  EXPECT_TRUE(is_over()) << "the last event says that the run has ended";
  EXPECT_EQ(events_of("columns"), 1);
  EXPECT_GE(events_of("rows"), 1);
  EXPECT_GE(events_of("bodies"), 40) << "of 41 drawings";
  double last_row = 0.0, last_drawing = 0.0;
  for (const auto& [kind, data] : events) {
    if (kind == "rows") last_row = data.at("time").back();
    if (kind != "bodies") continue;
    EXPECT_GT(data.at("run").at("bodies").at("times").at(0).get<double>() + 1e-12, last_drawing);
    last_drawing = data.at("run").at("bodies").at("times").at(0);
    EXPECT_EQ(data.at("chunks").contains("bodies-triangles"), events_of("bodies") > 0 && last_drawing == 0.0);
  }
  EXPECT_DOUBLE_EQ(last_row, 0.4);
  EXPECT_NEAR(last_drawing, 0.4, 0.02);
  EXPECT_TRUE(folder.read("run/history.csv") == folder.read("run_alone/history.csv"));
}

TEST_F(Live, OnlyTheTokenOpensIt) {
  const app::Background run(folder, test::RunFolder::program("footfall") + landing + " --view", "run/history.csv");
  find_page();
  httplib::Client client("127.0.0.1", port);
  const auto page = client.Get(home);
  ASSERT_TRUE(page);
  EXPECT_EQ(page->status, 200);
  EXPECT_TRUE(holds(page->body, "\"live\":true") && holds(page->body, "connect-src 'self'")) << "of its own server";
  EXPECT_EQ(page->get_header_value("Referrer-Policy"), "no-referrer");
  const std::string other = (home[1] == '0' ? "/1" : "/0") + home.substr(2);
  for (const std::string& path : {std::string("/"), std::string("/events"), home.substr(0, home.size() - 1), other,
                                  other + "events", home + "run.json", home + "../run/history.csv",
                                  home + "%2e%2e/%2e%2e/etc/passwd", std::string("//etc/passwd")}) {
    const auto answer = client.Get(path);
    ASSERT_TRUE(answer) << path;
    EXPECT_EQ(answer->status, 404) << path;
    EXPECT_EQ(answer->body, "") << path;
  }
  EXPECT_EQ(client.Post(home, "x", "text/plain")->status, 404);
  EXPECT_EQ(client.Get(home, {{"Host", "example.org"}})->status, 404)
      << "a name that another page has bound to 127.0.0.1";
  const test::Outcome ports = folder.shell("cat /proc/net/tcp /proc/net/tcp6");
  std::ostringstream hex;
  hex << std::uppercase << std::hex << port;
  EXPECT_TRUE(holds(ports.text, "0100007F:" + std::string(hex.str().size() < 4 ? "0" : "") + hex.str() + " 00000000"));
  EXPECT_FALSE(holds(ports.text, "00000000:" + hex.str() + " 00000000:0000 0A")) << "no other network sees it";
}

TEST_F(Live, ARunThatProceedsIsFollowedAndLeavingItEndsNothing) {
  app::Background run(folder,
                      "bash -c '" + test::RunFolder::program("footfall") + landing + " --quiet; echo $? > code'",
                      "run/history.csv");
  const test::Outcome followed = folder.shell("(timeout 120 " + test::RunFolder::program("footfall") +
                                              " view . --follow > followed.txt 2>&1; echo $? > followed) & sleep 0.1");
  ASSERT_EQ(followed.exit_code, 0) << followed.text;
  find_page("followed.txt");
  read_events([&] { return events_of("bodies") >= 2; });  // and closes the page
  events.clear();
  read_events([&] { return is_over(); });  // a page that is opened again begins with what it has missed
  EXPECT_GE(events_of("bodies"), 2);
  EXPECT_EQ(events_of("columns"), 1);
  ASSERT_TRUE(comes_true([&] { return folder.has("code") && folder.has("followed"); }));
  EXPECT_EQ(folder.read("code"), "0\n");
  EXPECT_EQ(folder.read("followed"), "0\n");
  EXPECT_TRUE(holds(folder.read("followed.txt"), "run\n")) << "the run in progress in this folder";
  EXPECT_FALSE(folder.has("run/watch.html"));
}

// The run lasts until the browser has shown it: a browser may take long to start.
TEST_F(Live, ABrowserShowsIt) {
  if (chromium_program().empty()) GTEST_SKIP() << "Chromium is not installed";
  app::Background run(folder,
                      test::RunFolder::program("footfall") + " run " + app::kInputs +
                          "/rigid_plane --set flexible=false --set output.plots=false --set end_time=600"
                          " --set output.vtk_interval=0.1 --out run --view",
                      "run/history.csv");
  find_page();
  PageCamera camera(address(), "", {800, 600});
  const auto number = [&](const std::string& what) { return camera.evaluate(what).get<double>(); };
  EXPECT_TRUE(comes_true([&] { return number("footfallLive.bodies.length") > 3; }));
  EXPECT_TRUE(
      comes_true([&] { return number("footfall.stage.bodies.frames.length - footfallLive.bodies.length") == 0.0; }));
  const double before = number("footfall.player.end");
  EXPECT_TRUE(comes_true([&] { return number("footfall.player.end") > before; }));
  EXPECT_EQ(number("footfall.player.end - footfall.player.time"), 0.0) << "it stays at the end of the run";
  const std::string picture = camera.picture("png");
  EXPECT_GT(picture.size(), 20000u) << "mechanism and plots";
  camera.evaluate("void footfall.player.step(-1)");
  const double held = number("footfall.player.time");
  run.end(SIGINT, false);
  EXPECT_TRUE(comes_true([&] { return camera.evaluate("document.body.dataset.state") == "ready"; }));
  EXPECT_EQ(number("footfall.player.time"), held) << "unless the user has gone back";
  EXPECT_TRUE(
      holds(camera.evaluate("document.querySelector('.progress').textContent").get<std::string>(), "interrupted"));
}

}  // namespace
}  // namespace footfall
