#include "mbd_solver/run/trial.h"

#include "coupler/base/clock.h"

namespace footfall {

void Trial::look(const Simulation& simulation, double time) {
  if (!runs() || over_) return;
  const IntegratorStatistics& statistics = simulation.integrator().statistics();
  const CoupledRun* coupled = simulation.coupled();
  const Mark mark = {time, wall_clock(), coupled ? coupled->dem_seconds() : 0.0, statistics.steps, statistics.windows};
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
