// Kinematics with accelerations, signals, energies, and the loads of the ground: of grains from the inputs, of contacts from
// their force elements.

#include "mbd_solver/session/observe/sampler.h"

namespace footfall {

Sampler::Sampler(const Subject& subject, Equations& equations, const State& state, const Eigen::VectorXd& rates,
                 const Inputs& inputs)
    : subject_(subject),
      equations_(equations),
      kinematics_(subject.mechanism.model),
      y_(Eigen::VectorXd::Zero(subject.layout.size())),
      sample_{state, inputs, values_, rates, kinematics_, energy_, contact_, equations.scratch()} {
  const Model& model = subject.mechanism.model;
  double mass = 0.0;
  for (int i = 0; i < model.body_count(); ++i) {
    contact_.emplace_back(model.body(i).mode_count());
    mass += model.body(i).mass();
  }
  ground_potential_ = mass * subject.scene.gravity.norm() * subject.mechanism.placement.ground_height;
}

void Sampler::update(long window, bool last, const CouplingSample* coupling) {
  const Layout& layout = subject_.layout;
  const State& state = sample_.state;
  const Eigen::VectorXd& rates = sample_.rates;
  kinematics_.load(layout, state.q, state.v, rates.segment(layout.v0(), layout.v_size));
  equations_.layout().pack(state, rates.tail(layout.row_count), y_);
  equations_.signals(state, sample_.inputs, values_);
  equations_.energy(state.time, y_, sample_.inputs, energy_);
  energy_.stored[Stored::kGravity] -= ground_potential_;
  update_contact();
  sample_.window = window;
  sample_.last = last;
  sample_.coupling = coupling;
}

void Sampler::update_contact() {
  const std::vector<ExternalLoad>& loads = sample_.inputs.loads;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    contact_[i].F_W = loads[i].F_W;
    contact_[i].T_W = kinematics_.of(static_cast<int>(i)).A * loads[i].T_B;
    if (loads[i].Q_a.size() == contact_[i].Q_a.size()) contact_[i].Q_a = loads[i].Q_a;
  }
  const Mechanism& mechanism = subject_.mechanism;
  const auto add = [&](int body, const Vector6d& wrench) {
    GeneralizedForce& contact = contact_[body];
    contact.F_W += wrench.head<3>();
    contact.T_W += wrench.tail<3>();
  };
  if (loads.empty())
    for (GeneralizedForce& contact : contact_) contact.set_zero();
  for (const ContactEntry& entry : mechanism.contacts) {
    const ContactElement& element = entry.force.of(mechanism.model);
    const auto& [body_1, body_2] = element.bodies();
    const Vector6d on_1 = element.wrench(element_input(subject_, sample_, entry.force.index()));
    add(body_1, on_1);
    if (body_2 == kGround) continue;
    // The reaction, about Bo of the other body.
    const Eigen::Vector3d arm = kinematics_.of(body_1).r - kinematics_.of(body_2).r;
    Vector6d on_2 = -on_1;
    on_2.tail<3>() -= arm.cross(Eigen::Vector3d(on_1.head<3>()));
    add(body_2, on_2);
  }
}

}  // namespace footfall
