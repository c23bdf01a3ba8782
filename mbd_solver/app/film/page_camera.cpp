// Starts Chromium with pipes at its descriptors 3 and 4 and speaks the DevTools protocol: navigate, evaluate, captureScreenshot.
#include "mbd_solver/app/film/page_camera.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/interrupt.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/base/child_process.h"
#include "mbd_solver/base/packed_bytes.h"

namespace footfall {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string program_in_path(std::initializer_list<const char*> names) {
  const char* const path = std::getenv("PATH");
  for (const char* name : names)
    for (const std::string& folder : split(path != nullptr ? path : "", ':')) {
      const std::string file = folder + "/" + name;
      if (!folder.empty() && access(file.c_str(), X_OK) == 0 && !fs::is_directory(file)) return file;
    }
  return "";
}

std::string chromium_program() {
  return program_in_path({"chromium", "chromium-browser", "google-chrome", "google-chrome-stable"});
}

ScratchFolder::ScratchFolder(const std::string& name)
    : path_((fs::temp_directory_path() / (name + "_XXXXXX")).string()) {
  if (!mkdtemp(path_.data()))
    throw InputError(code::kNoTemporaryFolder,
                     path_ + ": this folder cannot be created; set TMPDIR to a folder that can be written");
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

namespace {

constexpr double kReady = 300.0;       // a page of 100 MB, on a busy machine [s]
constexpr double kAnswer = 120.0;      // of the browser to one command [s]
constexpr int kFromUs = 3, kToUs = 4;  // descriptors that Chromium uses

// The address of a file, without characters that mean something in an address.
std::string address_of(const std::string& file) {
  std::string text = "file://";
  for (const char c : fs::absolute(file).lexically_normal().string()) {
    const bool plain =
        std::isalnum(static_cast<unsigned char>(c)) != 0 || std::string("/-._~").find(c) != std::string::npos;
    char coded[8];
    std::snprintf(coded, sizeof coded, "%%%02X", static_cast<unsigned char>(c));
    text += plain ? std::string(1, c) : coded;
  }
  return text;
}

}  // namespace

PageCamera::PageCamera(const std::string& page, const std::string& link, PageSize size) {
  const std::string program = chromium_program();
  if (program.empty())
    throw InputError(code::kProgramMissing,
                     "pictures of a page need Chromium, which is not installed: apt install chromium");
  start(program, size);
  try {
    open(page, link, size);
  } catch (...) {
    end();
    throw;
  }
}

PageCamera::~PageCamera() { end(); }

void PageCamera::start(const std::string& program, PageSize size) {
  int down[2], up[2];
  if (pipe2(down, O_CLOEXEC) != 0) fail("no pipe to the browser");
  if (pipe2(up, O_CLOEXEC) != 0) {
    close(down[0]);
    close(down[1]);
    fail("no pipe from the browser");
  }
  std::signal(SIGPIPE, SIG_IGN);
  std::vector<std::string> words = {program,
                                    "--headless",
                                    "--remote-debugging-pipe",
                                    "--use-gl=angle",
                                    "--use-angle=swiftshader",
                                    "--enable-unsafe-swiftshader",
                                    "--hide-scrollbars",
                                    "--mute-audio",
                                    "--no-first-run",
                                    "--disable-extensions",
                                    "--disable-dev-shm-usage",
                                    "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
                                    "--user-data-dir=" + folder_.path() + "/profile",
                                    "--window-size=" + std::to_string(size.width) + "," + std::to_string(size.height)};
  if (geteuid() == 0) words.push_back("--no-sandbox");  // Chromium refuses to start for root otherwise
  words.push_back("about:blank");
  // Chromium confines its pages by itself, which it cannot do where it is confined.
  Command command{Rights::of_user(), words};
  command.output = folder_.path() + "/log";
  pid_ = start_program(command, {{down[0], kFromUs}, {up[1], kToUs}}, Orphan::kIsKilled);
  close(down[0]);
  close(up[1]);
  to_ = down[1];
  from_ = up[0];
}

void PageCamera::open(const std::string& page, const std::string& link, PageSize size) {
  const Json target = call("Target.createTarget", {{"url", "about:blank"}});
  session_ = call("Target.attachToTarget", {{"targetId", target.at("targetId")}, {"flatten", true}})
                 .at("sessionId")
                 .get<std::string>();
  call("Page.enable");
  call("Runtime.enable");
  call("Emulation.setDeviceMetricsOverride",
       {{"width", size.width}, {"height", size.height}, {"deviceScaleFactor", 1}, {"mobile", false}});
  call("Page.navigate", {{"url", (page.rfind("http:", 0) == 0 ? page : address_of(page)) + "#" + link}});
  for (const double limit = wall_clock() + kReady;;) {
    const Json state = evaluate("document.body ? document.body.dataset.state ?? '' : ''");
    if (state == "ready" || state == "live") break;
    if (state == "failed") fail(evaluate("document.getElementById('footfall-fault').textContent").get<std::string>());
    if (wall_clock() > limit) fail("the page was not ready after " + number_text(kReady) + " s");
    usleep(20000);
  }
  if (!complaint_.empty()) fail("the page reports: " + complaint_);
}

Json PageCamera::evaluate(const std::string& expression) {
  const Json answer =
      call("Runtime.evaluate", {{"expression", expression}, {"awaitPromise", true}, {"returnByValue", true}});
  if (answer.contains("exceptionDetails"))
    fail("the page reports: " + answer.at("exceptionDetails").value("text", "") + " " +
         answer.at("exceptionDetails").value("exception", Json::object()).value("description", ""));
  return answer.at("result").value("value", Json());
}

std::string PageCamera::picture(const std::string& format) {
  Json parameters = {{"format", format}, {"captureBeyondViewport", false}, {"optimizeForSpeed", true}};
  if (format == "jpeg") parameters["quality"] = 93;
  if (format == "png") parameters.erase("optimizeForSpeed");
  // The text is not parsed as JSON: it is long, and base64.
  const std::string answer = answer_to("Page.captureScreenshot", parameters), mark = "\"data\":\"";
  const std::size_t start = answer.find(mark),
                    end = start == std::string::npos ? start : answer.find('"', start + mark.size());
  if (end == std::string::npos) fail("no picture: " + answer.substr(0, 200));
  if (!complaint_.empty()) fail("the page reports: " + complaint_);
  return bytes_of_base64(std::string_view(answer).substr(start + mark.size(), end - start - mark.size())).value_or("");
}

Json PageCamera::call(const std::string& method, const Json& parameters) {
  const Json answer = Json::parse(answer_to(method, parameters), nullptr, false);
  if (answer.is_discarded()) fail("the browser sent no JSON");
  if (answer.contains("error")) fail(method + ": " + answer.at("error").value("message", ""));
  return answer.at("result");
}

std::string PageCamera::answer_to(const std::string& method, const Json& parameters) {
  Json message = {{"id", ++last_id_}, {"method", method}, {"params", parameters}};
  if (!session_.empty()) message["sessionId"] = session_;
  std::string text = message.dump();
  text += '\0';
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t n = ::write(to_, text.data() + sent, text.size() - sent);
    if (n < 0 && errno == EINTR && interrupted() == 0) continue;
    if (n <= 0) fail("the browser has ended");
    sent += static_cast<std::size_t>(n);
  }
  const std::string beginning = "{\"id\":" + std::to_string(last_id_) + ",";
  for (;;) {
    std::string answer = next_message();
    if (answer.rfind(beginning, 0) == 0) return answer;
    if (const Json event = Json::parse(answer, nullptr, false); event.is_object()) note(event);
  }
}

std::string PageCamera::next_message() {
  const double limit = wall_clock() + kAnswer;
  for (std::array<char, 65536> buffer;;) {
    const std::size_t zero = received_.find('\0');
    if (zero != std::string::npos) {
      std::string message = received_.substr(0, zero);
      received_.erase(0, zero + 1);
      return message;
    }
    if (interrupted() != 0) throw Interrupted(code::kPageFailed, "interrupted; no picture was written");
    pollfd ready{from_, POLLIN, 0};
    if (poll(&ready, 1, 200) > 0) {
      const ssize_t n = ::read(from_, buffer.data(), buffer.size());
      if (n > 0)
        received_.append(buffer.data(), n);
      else if (n == 0 || errno != EINTR)
        fail("the browser has ended");
    }
    if (wall_clock() > limit) fail("the browser has not answered for " + number_text(kAnswer) + " s");
  }
}

// Errors that the page logs, and exceptions that it does not catch.
void PageCamera::note(const Json& event) {
  const std::string method = event.value("method", "");
  const Json parameters = event.value("params", Json::object());
  std::string text;
  if (method == "Runtime.exceptionThrown")
    text = parameters.at("exceptionDetails").value("exception", Json::object()).value("description", "an exception");
  if (method == "Runtime.consoleAPICalled" && parameters.value("type", "") == "error")
    for (const Json& argument : parameters.value("args", Json::array()))
      text += argument.value("description", argument.value("value", Json("")).dump()) + " ";
  if (complaint_.empty()) complaint_ = text;
}

void PageCamera::fail(const std::string& what) const {
  std::string log = read_whole_file(folder_.path() + "/log").value_or("");
  while (!log.empty() && log.back() == '\n') log.pop_back();
  const std::size_t line = log.rfind('\n');
  const std::string last = line == std::string::npos ? log : log.substr(line + 1);
  throw PartnerError(code::kPageFailed,
                     "Chromium drew no picture: " + what + (last.empty() ? "" : " (its last line: " + last + ")"));
}

void PageCamera::end() {
  if (to_ >= 0) close(to_);
  if (from_ >= 0) close(from_);
  to_ = from_ = -1;
  if (pid_ > 0) {
    kill(-pid_, SIGKILL);
    wait_for_end(pid_);
  }
  pid_ = -1;
}

}  // namespace footfall
