// Energies, powers and joint forces: what Equations can say about one instant.

#include "coupler/base/errors.h"
#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/dynamics/workspace.h"

namespace footfall {
namespace {

void add_stored(const Body& model, const BodyKinematics& body, const Eigen::Vector3d& gravity, Eigen::VectorXd& scratch,
                StoredEnergy& stored) {
  const Eigen::Vector3d w_B = body.A.transpose() * body.w;
  if (body.modes == 0) {
    stored[Stored::kKinetic] += 0.5 * model.mass() * body.dr.squaredNorm() + 0.5 * w_B.dot(model.rigid_inertia() * w_B);
  } else {
    Eigen::Ref<Eigen::VectorXd> v_B = scratch.head(body.size());
    v_B.head<3>() = body.A.transpose() * body.dr;
    v_B.segment<3>(3) = w_B;
    v_B.tail(body.modes) = body.da;
    stored[Stored::kKinetic] += model.inertia().kinetic_energy(body.a, v_B);
    stored[Stored::kStrain] += model.inertia().strain_energy(body.a);
  }
  stored[Stored::kGravity] -= model.mass() * gravity.dot(body.r);
}

}  // namespace

void Equations::energy(double t, const Eigen::Ref<const Eigen::VectorXd>& y, const Inputs& inputs, EnergySample& out) {
  sample_energy(t, y, inputs, true, out);
}

void Equations::powers(double t, const Eigen::Ref<const Eigen::VectorXd>& y, const Inputs& inputs, EnergySample& out) {
  sample_energy(t, y, inputs, false, out);
}

void Equations::sample_energy(double t, const Eigen::Ref<const Eigen::VectorXd>& y, const Inputs& inputs,
                              bool stored_by_bodies, EnergySample& out) {
  Workspace& w = *work_;
  w.kinematics.load(layout_, y.head(layout_.q_size), y.segment(layout_.v0(), layout_.v_size), w.empty);
  out.stored = {};
  out.power = {};
  out.supplied = {};
  out.load_power.setZero(model_.body_count());

  for (int i = 0; i < model_.body_count(); ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    const BodyKinematics& body = w.kinematics.of(i);
    if (stored_by_bodies) add_stored(model_.body(i), body, model_.gravity(), w.local, out.stored);
    if (body.modes > 0) out.power[Dissipation::kModal] += model_.body(i).inertia().damping_power(body.da);
    if (inputs.loads.empty()) continue;
    Eigen::Ref<Eigen::VectorXd> Q = w.local.head(body.size());
    Q.setZero();
    add_load_force(inputs.loads[at], body, Q);
    out.load_power[i] = Q.dot(y.segment(layout_.v0() + layout_.body_v[at], body.size()));
  }
  const Eigen::VectorXd& values = input_values_at(t, y, inputs);
  for (int i = 0; i < model_.force_count(); ++i) {
    const ForceElement& element = model_.force(i);
    const int z = layout_.z0() + layout_.force_z[static_cast<std::size_t>(i)];
    const ElementInput in{w.force_pair(element), y.segment(z, element.state_count()), values, t};
    element.add_energy(in, out.stored, out.power);
    element.add_supply(in, out.supplied);
  }
  // The joint forces -Phi_v^T lambda do work -lambda Phi_v v, which is zero but for prescribed motions. Other joints are
  // not looked at.
  for (const int j : w.working_joints) {
    for_each_row_of(
        j, model_, layout_, w.kinematics, t, w.row,
        [&](const RowPlace& at, const PairMotion&, const Eigen::Ref<Eigen::VectorXd>&, const RowValue& value) {
          // A rotor: 1/2 J q'^2, J = 1 / eps.
          if (value.speed != 0.0)
            out.stored[Stored::kKinetic] += 0.5 * value.speed * value.speed / w.regularisation[at.row];
          if (value.phi_t != 0.0)
            out.supplied[Supply::kMotion] -= y[layout_.lambda0() + at.row] * (value.rate - value.phi_t);
        });
  }
}

Vector6d Equations::joint_wrench(int index, double t, const Eigen::Ref<const Eigen::VectorXd>& lambda) const {
  const Joint& joint = model_.joint(index);
  return footfall::joint_wrench(
      joint, work_->joint_pair(joint), t,
      lambda.segment(layout_.joint_row[static_cast<std::size_t>(index)], static_cast<Eigen::Index>(joint.rows.size())));
}

}  // namespace footfall
