#pragma once
// Coordinates of joints with their rates, and reactions, at every sample.
// An angle goes on over any number of turns. Between two samples it is predicted from the rates and their derivatives,
//   q_1 ~ q_0 + h (q'_0 + q'_1) / 2 + h^2 (q''_0 - q''_1) / 12,   off by O(h^5)
// and the turn nearest to that is taken; where it is off by more than a quarter of a turn, the samples are too far
// apart to tell, and a warning says so.

#include <string>
#include <vector>

#include "coupler/archive.h"
#include "mbd_solver/observe/sample.h"

namespace footfall {

struct CoordinateFigures {
  double value = 0.0;  // [rad or m]
  double rate = 0.0;   // [rad/s or m/s]
  void visit(Archive& archive) {
    archive("value", value);
    archive("rate", rate);
  }
};

class JointFigures {
 public:
  // What the subject views must outlive this.
  explicit JointFigures(const Subject& subject);

  void take(const Sample& sample);
  const std::vector<std::string>& warnings() const { return warnings_; }  // once per joint
  void visit(Archive& archive) {
    archive("started", started_);
    archive("time", time_);
    archive("now", now_);
    archive("acc", acc_);
    archive("warned", warned_);
    archive("warnings", warnings_);
    archive("reactions", reactions_);
  }

  // Of mechanism.coordinates[k].
  const CoordinateFigures& coordinate(std::size_t k) const { return now_[k]; }
  // Force [N] and moment [N m] of a joint of the scene on its body b, about its point there, in W; only where
  // output.reactions is set.
  const Vector6d& reaction(std::size_t joint) const { return reactions_[joint]; }

 private:
  void follow(std::size_t k, double h, const JointCoordinate& at);

  Subject subject_;
  bool started_ = false;
  double time_ = 0.0;  // of the last sample [s]
  std::vector<CoordinateFigures> now_;
  std::vector<double> acc_;  // q'' [rad/s2 or m/s2]
  std::vector<bool> warned_;
  std::vector<std::string> warnings_;
  std::vector<Vector6d> reactions_;
};

}  // namespace footfall
