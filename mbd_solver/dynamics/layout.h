#pragma once
// Where everything stands in y = [q; v; z; lambda]; lambda are the multipliers of all rows of all joints.

#include <vector>

#include "mbd_solver/model/model.h"

namespace footfall {

struct Layout {
  explicit Layout(const Model& model);

  int q_size = 0, v_size = 0, z_size = 0, row_count = 0;  // row_count: constraint rows of all joints
  int v0() const { return q_size; }                       // first entry of v, z, lambda in y
  int z0() const { return q_size + v_size; }
  int lambda0() const { return q_size + v_size + z_size; }
  int size() const { return lambda0() + row_count; }

  std::vector<int> body_q, body_v;  // first entry of each body in q and in v
  std::vector<int> force_z;         // first inner state of each force element in z
  int signal_z = 0;                 // first state of the continuous signals in z; they end it
  std::vector<int> joint_row;       // first row of each joint among all rows; members of a gear share one
  std::vector<int> row_joint;       // for each of all rows: its joint, the first member of a gear
  std::vector<int> joint_turns;     // for each joint: the inner state that counts its turns for a gear in z, or -1
  std::vector<char> shared;         // for each of all rows: whether several joints add to it
};

}  // namespace footfall
