#pragma once
// Angles of joints over any number of turns, State::angles, followed from one state of a motion to the next. The turn
// is chosen nearest to the angle expected from rates at both ends (Hermite's rule):
//   q_1 ~ q_0 + h (q'_0 + q'_1) / 2 + h^2 (q''_0 - q''_1) / 12,   error O(h^5)
// Within an integration step the error is far below half a turn, unless steps are taken without error control.

#include <Eigen/Dense>
#include <limits>
#include <vector>

#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/model/model.h"
#include "mbd_solver/model/state.h"

namespace footfall {

class TurnFollower {
 public:
  // Both must outlive this object.
  TurnFollower(const Model& model, const Layout& layout);

  // How the angles move at one instant.
  struct Motion {
    double time = -std::numeric_limits<double>::infinity();  // [s]
    Eigen::VectorXd rate, acc;                               // q' [rad/s], q'' [rad/s2]
  };
  // rates: [dq; dv; dz; lambda] at the state.
  void measure(const State& state, const Eigen::VectorXd& rates, Motion& out);
  // state.angles: before the call at `from`, after it at the end of the step. to: the motion there, or null.
  void follow(const Motion& from, const Eigen::VectorXd& rates, State& state, Motion* to = nullptr);

 private:
  void load(const State& state, const Eigen::VectorXd& rates);

  const Model& model_;
  const Layout& layout_;
  Kinematics kinematics_;
  std::vector<int> joints_;  // that count turns
};

// Angles of a start, each nearest to zero.
void start_angles(const Model& model, const Layout& layout, const Kinematics& kinematics, State& state);

}  // namespace footfall
