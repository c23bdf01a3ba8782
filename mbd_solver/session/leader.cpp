// Lines over a socket of the operating system. Whatever goes wrong with the socket ends the run in order, as SIGINT does.

#include "mbd_solver/session/leader.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>

#include "coupler/base/errors.h"
#include "coupler/base/interrupt.h"
#include "coupler/programs.h"
#include "mbd_solver/base/exact_number.h"
#include "mbd_solver/session/codes.h"

namespace footfall {
namespace {

constexpr int kLook = 200;  // for an interruption [ms]

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
  lines_ = LineChannel(socket_, socket_);
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
  if (!leaves_ && !lines_.send(line)) leaves_ = true;
}

bool Leader::receive(std::string& line) {
  for (;;) {
    switch (lines_.receive(line, kLook)) {
      case LineChannel::Heard::kLine: return true;
      case LineChannel::Heard::kGone: return false;
      case LineChannel::Heard::kNothing: break;
    }
    if (interrupted() != 0) return false;
  }
}

void Leader::set(const std::string& words) {
  const std::size_t space = words.rfind(' ');
  const std::string name = words.substr(0, space);
  const std::vector<SignalSpec>& signals = simulation_.scene().signals;
  for (std::size_t i = 0; space != std::string::npos && i < signals.size(); ++i)
    if (signals[i].kind == SignalKind::kHost && signals[i].name == name)
      simulation_.instructions().set_input(simulation_.mechanism().signals[i].place,
                                           exact_number(words.substr(space + 1)));
}

void Leader::observe(const Sample& sample, double energy_balance) {
  if (leaves_) return;
  if (sample.state.time < target_ - simulation_.instructions().rows().tolerance() && !sample.last && saved_.empty()) {
    observation_.watch(sample);
    return;
  }
  send("balance " + shortest_text(energy_balance));
  std::string row = "row";
  for (const double value : observation_.row(sample)) row += ' ' + shortest_text(value);
  if (!saved_.empty()) send("saved " + saved_);
  saved_.clear();
  send(row);
  for (std::string line; !leaves_;) {
    if (!receive(line)) line = "end";
    if (line.rfind("step ", 0) == 0) {
      target_ = exact_number(line.substr(line.find(' ') + 1));
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
