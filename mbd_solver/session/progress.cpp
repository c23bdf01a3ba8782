// Pace is measured from the first state that is shown, so that resumed runs report their own.

#include "mbd_solver/session/progress.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "coupler/base/clock.h"
#include "coupler/base/start.h"

namespace footfall {
namespace {

// Under mpirun standard output is a pseudo-terminal of mpirun; `footfall run` reports what it really is.
bool on_terminal() {
  if (under_mpirun()) return std::getenv("FOOTFALL_TERMINAL") != nullptr;
  return isatty(STDOUT_FILENO) == 1;
}

}  // namespace

Progress::Progress(double t_end, bool quiet, bool coupled)
    : t_end_(t_end), coupled_(coupled), live_(quiet, on_terminal()), started_(wall_clock()) {}

void Progress::show(double time, long windows, double contact_force) {
  if (!begun_) {
    from_ = time;
    started_ = wall_clock();
  }
  begun_ = true;
  shown_ = false;
  time_ = time;
  windows_ = windows;
  contact_force_ = contact_force;
  if (!live_.due(time / t_end_)) return;
  live_.show(line());
  shown_ = true;
}

std::string Progress::line() const {
  const double spent = wall_clock() - started_;
  const double factor = spent > 0.0 ? (time_ - from_) / spent : 0.0;  // simulated per real second
  const std::string windows = coupled_ ? " | " + std::to_string(windows_) + " windows" : "";
  char rest[120];
  const bool large = contact_force_ >= 1e3;
  std::snprintf(rest, sizeof rest, " | %.1e x real time%s | contact %.4g %s", factor, windows.c_str(),
                large ? contact_force_ / 1e3 : contact_force_, large ? "kN" : "N");
  return time_text(time_, t_end_, {time_ / t_end_, (time_ - from_) / t_end_, spent}) + rest;
}

void Progress::finish() {
  if (begun_ && !shown_) live_.show(line());
  shown_ = true;
  live_.finish();
}

void Trial::observe(const Simulation& simulation, double time) {
  if (!active() || over_) return;
  const IntegratorStatistics& statistics = simulation.integrator().statistics();
  const CoupledRun* coupled = simulation.coupled();
  const Mark mark = {time, wall_clock(), coupled ? coupled->times().dem : 0.0, statistics.steps, statistics.windows};
  const double spent = marks_.empty() ? 0.0 : mark.wall - marks_.front().wall;
  if (marks_.size() == 3) marks_.back() = mark;
  if (marks_.empty() || (marks_.size() == 1 && spent >= 0.5 * seconds_) ||
      (marks_.size() == 2 && time > marks_.back().time))
    marks_.push_back(mark);
  over_ = marks_.size() == 3 && spent >= seconds_;
}

nlohmann::ordered_json Trial::marks() const {
  if (marks_.size() < 3) return nullptr;
  nlohmann::ordered_json json;
  json["begun"] = marks_.front().wall;
  for (const Mark& mark : marks_) {
    json["time_s"].push_back(mark.time);
    json["wall_s"].push_back(mark.wall - marks_.front().wall);
    json["dem_wall_s"].push_back(mark.dem_wall);
    json["steps"].push_back(mark.steps);
    json["windows"].push_back(mark.windows);
  }
  return json;
}

}  // namespace footfall
