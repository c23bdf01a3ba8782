#include "mbd_solver/dynamics/layout.h"

#include "mbd_solver/model/signals/continuous_signals.h"

namespace footfall {

Layout::Layout(const Model& model) {
  for (int i = 0; i < model.body_count(); ++i) {
    const int s = model.body(i).mode_count();
    body_q.push_back(q_size);
    body_v.push_back(v_size);
    q_size += 7 + s;
    v_size += 6 + s;
  }
  for (int i = 0; i < model.force_count(); ++i) {
    force_z.push_back(z_size);
    z_size += model.force(i).state_count();
  }
  signal_z = z_size;
  if (model.signals()) z_size += model.signals()->state_count();
  for (int i = 0; i < model.joint_count(); ++i) {
    const Joint& joint = model.joint(i);
    joint_turns.push_back(joint.turn_counter < 0 ? -1 : force_z[static_cast<std::size_t>(joint.turn_counter)]);
    if (joint.row_of >= 0) {
      joint_row.push_back(joint_row[static_cast<std::size_t>(joint.row_of)]);
      shared[static_cast<std::size_t>(joint_row.back())] = 1;
      continue;
    }
    joint_row.push_back(row_count);
    for (std::size_t k = 0; k < joint.rows.size(); ++k) row_joint.push_back(i);
    row_count = static_cast<int>(row_joint.size());
    shared.resize(row_joint.size(), 0);
  }
}

}  // namespace footfall
