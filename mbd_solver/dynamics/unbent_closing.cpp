#include "mbd_solver/dynamics/unbent_closing.h"

#include <memory>
#include <utility>

#include "mbd_solver/dynamics/joint_closing.h"
#include "mbd_solver/model/elements/turn_counter.h"

namespace footfall {
namespace {

void add_joints(const Model& model, Model& out) {
  for (int j = 0; j < model.joint_count(); ++j) {
    Joint joint = model.joint(j);
    if (joint.turn_counter >= 0)
      joint.turn_counter = out.add_force(std::make_unique<TurnCounter>("turns/" + joint.name, joint.m1, joint.m2));
    out.add_joint(std::move(joint));
  }
}

Model unbendable(const Model& model) {
  Model out;
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    BodyState start = model.initial(i);
    if (body.mode_count() == 0) {
      out.add_body(body, start);
      continue;
    }
    ModalBody modal = *body.modal();
    for (Eigen::MatrixXd* shapes : {&modal.Phi, &modal.Psi, &modal.stress_modes}) shapes->resize(shapes->rows(), 0);
    modal.stiffness.resize(0);
    modal.damping.resize(0);
    start.a.resize(0);
    start.da.resize(0);
    out.add_body(Body(body.name(), std::make_shared<const ModalBody>(std::move(modal))), start);
  }
  add_joints(model, out);
  return out;
}

}  // namespace

Model without_forces(const Model& model) {
  Model out;
  for (int i = 0; i < model.body_count(); ++i) out.add_body(model.body(i), model.initial(i));
  add_joints(model, out);
  return out;
}

UnbentClosing::UnbentClosing(const Model& model, const Layout& layout)
    : layout_(layout), model_(unbendable(model)), rigid_(model_), rows_(model_, rigid_) {
  for (int i = 0; i < model.body_count(); ++i) bends_ = bends_ || model.body(i).mode_count() > 0;
}

void UnbentClosing::close(State& state) {
  if (!bends_) return;
  State moved = state;
  moved.q.resize(rigid_.q_size);
  moved.v = Eigen::VectorXd::Zero(rigid_.v_size);
  for (std::size_t i = 0; i < layout_.body_q.size(); ++i)
    moved.q.segment<7>(rigid_.body_q[i]) = state.q.segment<7>(layout_.body_q[i]);
  rows_.evaluate(moved);
  close_joints(model_, rigid_, rows_, moved);
  if (rows_.phi.lpNorm<Eigen::Infinity>() > kContradiction) return;
  for (std::size_t i = 0; i < layout_.body_q.size(); ++i)
    state.q.segment<7>(layout_.body_q[i]) = moved.q.segment<7>(rigid_.body_q[i]);
  state.z = moved.z;
}

void close_unbent(const Model& model, State& state) {
  const Model joints_alone = without_forces(model);
  const Layout layout(joints_alone);
  State closed = state;
  closed.z = Eigen::VectorXd::Zero(layout.z_size);
  UnbentClosing(joints_alone, layout).close(closed);
  state.q = closed.q;
}

}  // namespace footfall
