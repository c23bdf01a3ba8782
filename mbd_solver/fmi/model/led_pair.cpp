// `footfall run` with a socket through which mbd_solver requests instructions. The output of the programs goes to a
// file, from which errors and warnings are read.

#include "mbd_solver/fmi/model/led_pair.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "coupler/base/clock.h"
#include "coupler/base/files.h"
#include "coupler/base/start.h"
#include "coupler/base/text.h"
#include "coupler/programs.h"
#include "mbd_solver/base/child_process.h"
#include "mbd_solver/fmi/codes.h"
#include "mbd_solver/fmi/model/exported_model.h"
#include "mbd_solver/scene/scene_reader.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

constexpr int kLook = 200;                       // for programs that have ended [ms]
constexpr double kTimeInOrder = 15.0;            // for a checkpoint and the end of all programs [s]
constexpr double kPatience = 7 * 86400.0;        // of LIGGGHTS, unless the scene gives coupling.timeout [s]
constexpr std::size_t kLongestPath = 80;         // of a folder, so that its socket has a name the system takes
constexpr std::size_t kLastOfLog = 2000;         // [bytes]
constexpr const char* kUnfit = " \t\n\r\"'#&$";  // in paths that LIGGGHTS reads

// A program in a job of MPI cannot start one of its own while it is known as a part of the first.
void leave_mpi_job() {
  if (!under_mpirun()) return;
  std::vector<std::string> names;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string name(*entry, std::strcspn(*entry, "="));
    if (name.rfind("PMI", 0) == 0 || name.rfind("OMPI_", 0) == 0 || name.rfind("PRTE_", 0) == 0) names.push_back(name);
  }
  for (const std::string& name : names) unsetenv(name.c_str());
}

std::string without_program(const std::string& line) {
  for (const char* program : {"footfall: ", "mbd_solver: ", "liggghts_mbd: "})
    if (line.rfind(program, 0) == 0) return line.substr(std::strlen(program));
  return line;
}

}  // namespace

LedPair::LedPair(const PairToLead& pair, std::function<bool()> unwanted) : unwanted_(std::move(unwanted)) {
  make_folder();
  try {
    start(pair);
    const nlohmann::ordered_json hello = nlohmann::ordered_json::parse(line());
    names_ = hello.at("columns").get<std::vector<std::string>>();
    units_ = hello.at("units").get<std::vector<std::string>>();
    for (const auto& [name, value] : hello.at("signals").items()) signals_[name] = value.get<double>();
    end_time_ = hello.at("end_time").get<double>();
    read_row();
  } catch (...) {
    end();
    throw;
  }
}

LedPair::~LedPair() { end(); }

void LedPair::make_folder() {
  std::error_code error;
  std::string place = fs::temp_directory_path(error).string();
  if (error || place.size() > kLongestPath || place.find_first_of(kUnfit) != std::string::npos) place = "/tmp";
  folder_ = place + "/footfall-XXXXXX";
  if (mkdtemp(folder_.data()) == nullptr)
    throw InputError(code::kPairFolder, place + ": no folder for the run can be made there (" + std::strerror(errno) +
                                            "); name another one in the variable TMPDIR");
  log_ = folder_ + "/log";
}

void LedPair::start(const PairToLead& pair) {
  std::string scene = pair.scene;
  if (!pair.carried.empty()) {
    fs::copy(pair.carried, folder_ + "/scene", fs::copy_options::recursive);
    scene = folder_ + "/scene/" + fs::relative(pair.scene, pair.carried).string();
  }
  const Scene read = read_scene(scene, pair.settings);
  std::vector<std::string> settings = pair.settings;
  // The leading program may think for as long as it likes.
  if (read.coupling.timeout == CouplingSpec().timeout)
    settings.push_back("coupling.timeout=" + shortest_text(kPatience));
  if (pair.kept.empty()) settings.push_back("output.plots=false");
  std::string out = folder_ + "/run";
  if (!pair.kept.empty()) {
    footfall::make_folder(pair.kept, "name another folder in the variable FOOTFALL_FMU_RESULTS");
    out = (fs::absolute(pair.kept) / pair.name).lexically_normal().string();
    for (int k = 2; fs::exists(out); ++k)
      out = (fs::absolute(pair.kept) / (pair.name + "-" + std::to_string(k))).lexically_normal().string();
  }
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  const std::string path = folder_ + "/lead";
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  listener_ = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (listener_ < 0 || bind(listener_, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0 ||
      listen(listener_, 1) != 0)
    throw InputError(code::kPairFolder, path + ": cannot be made (" + std::strerror(errno) +
                                            "); name another folder in the variable TMPDIR");
  Command command{Rights::of_user()};  // footfall judges the scene by itself
  command.words = {pair.programs + "/footfall", "run", scene, "--out", out, "--quiet"};
  if (pair.trusted) command.words.push_back("--trust-script");
  for (const std::string& setting : settings) command.words.push_back("--set=" + setting);
  command.environment[kLeader] = path;
  command.output = log_;
  leave_mpi_job();
  process_ = start_program(command);
  for (;;) {
    pollfd wait = {listener_, POLLIN, 0};
    if (poll(&wait, 1, kLook) > 0) {
      socket_ = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
      if (socket_ >= 0) break;
    }
    if (has_ended()) fail();
    if (unwanted_()) throw Interrupted(code::kPairInterrupted, "interrupted before the coupled pair had begun");
  }
  lines_ = LineChannel(socket_, socket_);
  close(listener_);
  listener_ = -1;
}

bool LedPair::has_ended() {
  int status = 0;
  if (process_ > 0 && waitpid(process_, &status, WNOHANG) == process_) {
    exit_code_ = exit_code_of(status);
    process_ = -1;
  }
  return process_ < 0;
}

bool LedPair::has_ended_within(double time) {
  for (const double until = wall_clock() + time; !has_ended(); usleep(20'000))
    if (wall_clock() > until) return false;
  return true;
}

// The socket closes: mbd_solver ends the run as after SIGINT. footfall ends programs that do not follow.
void LedPair::end() {
  if (socket_ >= 0) {
    lines_.send("end");
  } else if (process_ > 0) {
    kill(process_, SIGTERM);
  }
  for (const int signal : {SIGTERM, SIGKILL}) {
    if (has_ended_within(kTimeInOrder)) break;
    kill(process_, signal);
  }
  has_ended_within(kTimeInOrder);
  for (int* file : {&listener_, &socket_}) {
    if (*file >= 0) close(*file);
    *file = -1;
  }
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::string LedPair::said() const { return read_whole_file(log_).value_or(""); }

void LedPair::fail() {
  if (!has_ended_within(kTimeInOrder)) {
    kill(process_, SIGTERM);
    has_ended_within(kTimeInOrder);
  }
  const std::string text = said();
  std::string message;
  std::set<std::string> known;  // several programs may report the same
  for (const std::string& line : split(text, '\n')) {
    const std::string each = without_program(line);
    if (!has_code(each) || each[each.rfind(" [") + 2] != 'E' || !known.insert(each).second) continue;
    message += (message.empty() ? "" : "\n") + each;
  }
  if (message.empty()) {
    message = trimmed(text.substr(text.size() - std::min(text.size(), kLastOfLog)));
    message = with_code(code::kPairGone, "the programs of the coupled pair have ended with exit code " +
                                             std::to_string(exit_code_) +
                                             (message.empty() ? ", without a word" : "; they wrote: " + message));
  }
  throw PartnerError(message);
}

std::string LedPair::line() {
  std::string found;
  for (;;) switch (lines_.receive(found, kLook)) {
      case LineChannel::Heard::kLine: return found;
      case LineChannel::Heard::kGone: fail();
      case LineChannel::Heard::kNothing:
        if (unwanted_()) throw Interrupted(code::kPairInterrupted, "the program that leads the coupled pair has gone");
        if (has_ended()) fail();
        break;
    }
}

void LedPair::say(const std::string& words) {
  if (!lines_.send(words)) fail();
}

void LedPair::read_row() {
  double balance = 0.0, error = 0.0;
  for (;;) {
    std::vector<std::string> words = split(line(), ' ');
    if (words[0] == "balance" && words.size() > 2) {
      balance = exact_number(words[1]);
      error = exact_number(words[2]);
    }
    if (words[0] != "row") continue;
    std::vector<double> row;
    for (std::size_t k = 1; k < words.size(); ++k) row.push_back(exact_number(words[k]));
    if (row.size() != names_.size())
      throw PartnerError(code::kPairGone, "the coupled pair sent a row that does not match its columns");
    row_ = std::move(row);
    balance_ = balance;
    error_ = error;
    return;
  }
}

std::vector<std::string> LedPair::signals() const {
  std::vector<std::string> names;
  for (const auto& [name, value] : signals_) names.push_back(name);
  return names;
}

double LedPair::signal(const std::string& name) const { return signals_.at(name); }

void LedPair::set_signal(const std::string& name, double value) {
  signals_.at(name) = value;
  say("set " + name + " " + shortest_text(value));
}

bool LedPair::step(double until, bool early) {
  if (until <= time() || finished()) return false;  // within the coupling interval that was computed last
  say((early ? "early " : "step ") + shortest_text(until));
  read_row();
  return early && time() < until * (1.0 - 1e-9) && !finished();
}

std::string LedPair::save() {
  throw InputError(code::kPairState, "the state of a scene on grains cannot be read (canGetAndSetFMUState is false)");
}

void LedPair::restore(const std::string&) {
  throw InputError(code::kPairState, "the state of a scene on grains cannot be set (canGetAndSetFMUState is false)");
}

std::vector<std::string> LedPair::warnings() const {
  std::vector<std::string> all;
  const std::string mark = "warning: ";
  for (const std::string& each : split(said(), '\n'))
    if (const std::size_t at = each.find(mark); at != std::string::npos && at < 16)
      all.push_back(each.substr(at + mark.size()));
  return all;
}

}  // namespace footfall
