// Lines over a socket of the operating system. Whatever goes wrong with the socket ends the run in order, as SIGINT does.

#include "mbd_solver/run/leader.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>

#include "coupler/base/errors.h"
#include "coupler/base/interrupt.h"
#include "coupler/programs.h"
#include "mbd_solver/run/codes.h"

namespace footfall {
namespace {

constexpr int kLook = 200;  // for an interruption [ms]

std::string all_digits(double value) {
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}

double number_in(const std::string& text) {
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

std::unique_ptr<Leader> Leader::of_environment(Simulation& simulation) {
  const char* const path = std::getenv(kLeader);
  return path == nullptr ? nullptr : std::unique_ptr<Leader>(new Leader(simulation, path));
}

Leader::Leader(Simulation& simulation, const std::string& path)
    : simulation_(simulation), observation_(simulation.subject()) {
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  const bool fits = path.size() < sizeof address.sun_path;
  if (fits) std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  socket_ = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (!fits || socket_ < 0 || connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0)
    throw PartnerError(code::kLeaderGone, std::string("the program that leads this run cannot be reached at ") + path +
                                              " (" + std::strerror(fits ? errno : ENAMETOOLONG) +
                                              "); unset FOOTFALL_LEADER to run without one");
  nlohmann::ordered_json hello = {{"columns", observation_.names()}, {"units", observation_.units()}};
  hello["signals"] = nlohmann::ordered_json::object();
  for (const SignalSpec& signal : simulation.scene().signals)
    if (signal.kind == SignalKind::kHost) hello["signals"][signal.name] = signal.initial.value_or(0.0);
  hello["end_time"] = simulation.scene().end_time;
  send(hello.dump());
}

Leader::~Leader() {
  if (socket_ >= 0) close(socket_);
}

void Leader::send(const std::string& line) {
  const std::string text = line + "\n";
  for (std::size_t done = 0; done < text.size() && !leaves_;) {
    const ssize_t count = ::send(socket_, text.data() + done, text.size() - done, MSG_NOSIGNAL);
    if (count > 0) done += static_cast<std::size_t>(count);
    if (count < 0 && errno != EINTR) leaves_ = true;
  }
}

bool Leader::receive(std::string& line) {
  for (;;) {
    const std::size_t end = received_.find('\n');
    if (end != std::string::npos) {
      line = received_.substr(0, end);
      received_.erase(0, end + 1);
      return true;
    }
    char bytes[4096];
    pollfd wait = {socket_, POLLIN, 0};
    if (interrupted() != 0) return false;
    if (poll(&wait, 1, kLook) <= 0) continue;
    const ssize_t count = recv(socket_, bytes, sizeof bytes, 0);
    if (count == 0 || (count < 0 && errno != EINTR)) return false;
    if (count > 0) received_.append(bytes, static_cast<std::size_t>(count));
  }
}

void Leader::set(const std::string& words) {
  const std::size_t space = words.rfind(' ');
  const std::string name = words.substr(0, space);
  const std::vector<SignalSpec>& signals = simulation_.scene().signals;
  for (std::size_t i = 0; space != std::string::npos && i < signals.size(); ++i)
    if (signals[i].kind == SignalKind::kHost && signals[i].name == name)
      simulation_.instructions().set_input(simulation_.mechanism().signals[i].place,
                                           number_in(words.substr(space + 1)));
}

double Leader::last_event(const Sample& sample) const {
  const int place = simulation_.mechanism().state_since;
  return place < 0 ? 0.0 : sample.values(place);
}

void Leader::observe(const Sample& sample, double energy_balance) {
  if (leaves_) return;
  const bool event = early_ && last_event(sample) != event_;
  if (sample.state.time < target_ - simulation_.instructions().rows().tolerance() && !sample.last && saved_.empty() &&
      !event) {
    observation_.watch(sample);
    return;
  }
  early_ = false;
  send("balance " + all_digits(energy_balance) + ' ' + all_digits(simulation_.integrator().statistics().summed_error));
  std::string row = "row";
  for (const double value : observation_.row(sample)) row += ' ' + all_digits(value);
  if (!saved_.empty()) send("saved " + saved_);
  saved_.clear();
  send(row);
  for (std::string line; !leaves_;) {
    if (!receive(line)) line = "end";
    const bool early = line.rfind("early ", 0) == 0;
    if (early || line.rfind("step ", 0) == 0) {
      early_ = early;
      event_ = last_event(sample);
      target_ = number_in(line.substr(line.find(' ') + 1));
      simulation_.instructions().stop_at(target_);
      return;
    }
    if (line == "save") {
      simulation_.instructions().request_checkpoint();
      target_ = simulation_.scene().end_time;  // until saved() is called
      return;
    }
    if (line.rfind("set ", 0) == 0) set(line.substr(4));
    if (line == "end") leaves_ = true;
  }
  if (!sample.last) std::raise(SIGINT);
}

void Leader::done() {
  send("done");
  leaves_ = true;
}

}  // namespace footfall
