// The residual is assembled body by body, joint by joint and element by element; energies likewise.

#include "mbd_solver/dynamics/equations.h"

#include <algorithm>

#include "coupler/base/errors.h"
#include "mbd_solver/dynamics/body_force.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {

// Scratch data of Equations: sized once, then reused.
struct Equations::Workspace : Evaluation {
  Workspace(const Model& model, const Layout& layout);

  Eigen::VectorXd row;    // local row of the largest pair, or states of an element
  Eigen::VectorXd local;  // generalized force of a pair
  std::vector<double> memory;
  std::vector<int> working_joints;  // with rows that move with time or turn a rotor: the others do no work
};

Equations::Workspace::Workspace(const Model& model, const Layout& layout)
    : Evaluation(model, layout),
      row(Eigen::VectorXd::Zero(std::max(largest_pair, most_states))),
      local(Eigen::VectorXd::Zero(largest_element)) {
  for (int j = 0; j < model.joint_count(); ++j) {
    for (const ConstraintRow& r : model.joint(j).rows) {
      if (!r.motion && !(r.inertia > 0.0) && !r.law) continue;
      working_joints.push_back(j);
      break;
    }
  }
}

Equations::Equations(const Model& model, const Assembly& assembly, const Baumgarte& baumgarte)
    : model_(model),
      layout_(model),
      baumgarte_(baumgarte),
      work_(std::make_unique<Workspace>(model, layout_)),
      saddle_(std::make_unique<SaddleSystem>(*this, assembly)),
      jacobian_(*work_, *saddle_, baumgarte) {
  for (int i = 0; i < model.force_count(); ++i) {
    if (const Switching* const modes = switching(model.force(i))) switching_.emplace_back(i, modes);
    if (const auto* memory = dynamic_cast<const Remembering*>(&model.force(i))) remembering_.emplace_back(i, memory);
  }
}

Equations::~Equations() = default;

void Equations::load(const State& state) {
  work_->kinematics.load(layout_, state.q, state.v, work_->empty);
  work_->kinematics.load_turns(layout_, state.z);
}

void Equations::load(const Eigen::Ref<const Eigen::VectorXd>& y) { work_->load(y); }

const Kinematics& Equations::kinematics() const { return work_->kinematics; }

const BodyKinematics& Equations::motion(int body) const { return work_->kinematics.of(body); }

ElementScratches& Equations::scratch() { return work_->scratch; }

ElementInput Equations::element_input(int force, const State& state, const Inputs& inputs) {
  const ForceElement& element = model_.force(force);
  return footfall::element_input(element, work_->kinematics,
                                 state.z.segment(layout_.force_z[force], element.state_count()), inputs.values,
                                 state.time, work_->scratch.of(force));
}

void Equations::check_inputs(const Inputs& inputs) const {
  for (int i = 0; i < model_.force_count(); ++i) FOOTFALL_DEMAND(inputs.values.size() >= model_.force(i).input_count());
  if (inputs.loads.empty()) return;
  FOOTFALL_DEMAND(static_cast<int>(inputs.loads.size()) == model_.body_count());
  for (int i = 0; i < model_.body_count(); ++i) {
    const Eigen::Index size = inputs.loads[i].Q_a.size();
    FOOTFALL_DEMAND(size == 0 || size == model_.body(i).mode_count());
  }
}

void Equations::residual(double t, const Eigen::Ref<const Eigen::VectorXd>& y,
                         const Eigen::Ref<const Eigen::VectorXd>& ydot, const Inputs& inputs,
                         Eigen::Ref<Eigen::VectorXd> F) {
  Workspace& w = *work_;
  const auto lambda = y.segment(layout_.lambda0(), layout_.row_count);
  w.load(y, ydot);
  F = ydot;
  F.segment(layout_.v0(), layout_.v_size).setZero();

  // Bodies: dq - N v, inertia, gravity, external load.
  for (int i = 0; i < model_.body_count(); ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    const BodyKinematics& body = w.kinematics.of(i);
    const int q = layout_.body_q[at], v = layout_.v0() + layout_.body_v[at];
    F.segment<3>(q) -= body.dr;
    F.segment<4>(q + 3) -= quaternion_rate(body.L, body.w);
    if (body.modes > 0) F.segment(q + 7, body.modes) -= body.da;
    Eigen::Ref<Eigen::VectorXd> force = F.segment(v, body.size());
    add_body_force(model_.body(i), body, model_.gravity(), w.inertia[at], force);
    if (!inputs.loads.empty()) {
      Eigen::Ref<Eigen::VectorXd> local = w.local.head(body.size());
      local.setZero();
      add_load_force(inputs.loads[at], body, local);
      force -= local;
    }
  }

  // Joints: Phi_v^T lambda into the forces, phi'' into their own rows.
  const double alpha2 = 2.0 * baumgarte_.alpha, beta2 = baumgarte_.beta * baumgarte_.beta;
  for (int j = 0; j < model_.joint_count(); ++j) {
    const Joint& joint = model_.joint(j);
    MarkerVectors vectors(w.pair_of(joint), joint.m1, joint.m2);
    const PairMotion& pair = vectors.pair();
    Eigen::Ref<Eigen::VectorXd> reaction = w.local.head(pair.size());
    reaction.setZero();
    int row = layout_.joint_row[j];
    for (const ConstraintRow& written : joint.rows) {
      const RowValue value = measure_row_with_reaction(written, t, vectors, lambda[row], w.row.head(pair.size()),
                                                       reaction, w.kinematics.turns(j));
      double& condition = F[layout_.lambda0() + row];
      if (joint.row_of < 0)
        condition = -saddle_->regularisation()[row] * lambda[row];  // otherwise the row of an earlier joint
      condition += value.acc + alpha2 * value.rate + beta2 * value.phi;
      ++row;
    }
    vectors.add_pushed(reaction);
    const std::array<int, 2> v = pair_v(layout_, joint.m1.body, joint.m2.body);
    for (int i = 0; i < 2; ++i) {
      const int n = pair.body[i]->size();
      if (n > 0) F.segment(layout_.v0() + v[i], n) += reaction.segment(pair.offset(i), n);
    }
  }

  // Continuous signals, then force elements.
  const Eigen::VectorXd& values = w.input_values(t, y, inputs);
  if (model_.signals()) F.segment(layout_.z0() + layout_.signal_z, w.signal_rates.size()) -= w.signal_rates;
  for (int i = 0; i < model_.force_count(); ++i) {
    const ForceElement& element = model_.force(i);
    const int z = layout_.z0() + layout_.force_z[i], m = element.state_count();
    const ElementInput in = footfall::element_input(element, w.kinematics, y.segment(z, m), values, t, w.scratch.of(i));
    const PairMotion& pair = in.pair;
    const int pair_size = pair.size(), size = in.size();
    Eigen::Ref<Eigen::VectorXd> Q = w.local.head(size);
    Eigen::Ref<Eigen::VectorXd> dz = w.row.head(m);
    Q.setZero();
    element.add_force(in, Q, dz);
    const std::array<int, 2> v = pair_v(layout_, element.bodies()[0], element.bodies()[1]);
    for (int k = 0; k < 2; ++k) {
      const int n = pair.body[k]->size();
      if (n > 0) F.segment(layout_.v0() + v[k], n) -= Q.segment(pair.offset(k), n);
    }
    int offset = pair_size;
    for (const int body : element.further_bodies()) {
      const int n = w.kinematics.of(body).size();
      F.segment(layout_.v0() + layout_.body_v[body], n) -= Q.segment(offset, n);
      offset += n;
    }
    F.segment(z, m) -= dz;
  }
}

void Equations::apply_mass(const Eigen::Ref<const Eigen::VectorXd>& y, const Eigen::Ref<const Eigen::VectorXd>& x,
                           double t, Eigen::Ref<Eigen::VectorXd> out) {
  Workspace& w = *work_;
  w.load(y);
  out = x;
  for (int i = 0; i < model_.body_count(); ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    const int n = w.kinematics.of(i).size(), v = layout_.v0() + layout_.body_v[at];
    body_mass_product(model_.body(i), w.kinematics.of(i), x.segment(v, n), w.inertia[at], out.segment(v, n));
  }
  for_each_row(
      model_, layout_, w.kinematics, t, w.row,
      [&](const RowPlace& at, const PairMotion& pair, const Eigen::Ref<Eigen::VectorXd>& phi_v, const RowValue&) {
        const Joint& joint = model_.joint(at.joint);
        const std::array<int, 2> v = pair_v(layout_, joint.m1.body, joint.m2.body);
        double sum = at.adds ? out[layout_.lambda0() + at.row] : 0.0;
        for (int i = 0; i < 2; ++i) {
          const int n = pair.body[i]->size();
          if (n > 0) sum += phi_v.segment(pair.offset(i), n).dot(x.segment(layout_.v0() + v[i], n));
        }
        out[layout_.lambda0() + at.row] = sum;
      });
}

// --- Energies and powers.

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
  const Eigen::VectorXd& values = w.input_values(t, y, inputs);
  for (int i = 0; i < model_.force_count(); ++i) {
    const ForceElement& element = model_.force(i);
    const int z = layout_.z0() + layout_.force_z[i];
    const ElementInput in =
        footfall::element_input(element, w.kinematics, y.segment(z, element.state_count()), values, t, w.scratch.of(i));
    element.add_energy(in, out.stored, out.power);
    element.add_supply(in, out.supplied);
  }
  // The work of joint forces -Phi_v^T lambda is -lambda Phi_v v, which is zero except for prescribed motions.
  for (const int j : w.working_joints) {
    for_each_row_of(
        j, model_, layout_, w.kinematics, t, w.row,
        [&](const RowPlace& at, const PairMotion&, const Eigen::Ref<Eigen::VectorXd>&, const RowValue& value) {
          // A rotor: 1/2 J q'^2, J = 1 / eps.
          if (value.speed != 0.0)
            out.stored[Stored::kKinetic] += 0.5 * value.speed * value.speed / saddle_->regularisation()[at.row];
          if (value.phi_t != 0.0)
            out.supplied[Supply::kMotion] -= y[layout_.lambda0() + at.row] * (value.rate - value.phi_t);
        });
  }
}

Vector6d Equations::joint_wrench(int index, double t, const Eigen::Ref<const Eigen::VectorXd>& lambda) const {
  const Joint& joint = model_.joint(index);
  return footfall::joint_wrench(joint, work_->pair_of(joint), t,
                                lambda.segment(layout_.joint_row[index], static_cast<Eigen::Index>(joint.rows.size())));
}

// --- Continuous signals, modes and memory of elements.

void Equations::signals(const State& state, const Inputs& inputs, Eigen::VectorXd& out) {
  out = inputs.values;
  if (!model_.signals()) return;
  Workspace& w = *work_;
  load(state);
  w.signals->evaluate(state.time, Instant{w.kinematics, layout_, model_, state.z}, state.z.tail(w.signal_rates.size()),
                      out, w.signal_rates);
}

void Equations::settle_signals(const Eigen::VectorXd* before, const Inputs& inputs, State& state) {
  if (!model_.signals()) return;
  Workspace& w = *work_;
  load(state);
  w.values = inputs.values;
  w.signals->settle(state.time, Instant{w.kinematics, layout_, model_, state.z}, before,
                    state.z.tail(w.signal_rates.size()), w.values);
}

double Equations::mode_value(const State& state, const Inputs& inputs) {
  load(state);
  double smallest = 1.0;
  for (const auto& [force, modes] : switching_)
    smallest = std::min(smallest, modes->switch_value(element_input(force, state, inputs)));
  return smallest;
}

bool Equations::switch_modes(const Inputs& inputs, State& state) {
  if (switching_.empty()) return false;
  load(state);
  bool any = false;
  for (const auto& [force, modes] : switching_) {
    const auto z = state.z.segment(layout_.force_z[force], model_.force(force).state_count());
    any = modes->switch_states(element_input(force, state, inputs), z) || any;
  }
  return any;
}

void Equations::recall(const State& state) {
  const double* memory = state.memory.size() > 0 ? state.memory.data() : nullptr;
  for (const auto& [force, element] : remembering_) element->recall(memory, *work_->scratch.of(force));
}

void Equations::remember(const Inputs& inputs, State& state) {
  if (remembering_.empty()) return;
  load(state);
  bool changed = false;
  for (const auto& [force, element] : remembering_)
    changed = element->remember(element_input(force, state, inputs)) || changed;
  if (!changed) return;
  std::vector<double>& numbers = work_->memory;
  numbers.clear();
  for (const auto& [force, element] : remembering_) element->save_memory(*work_->scratch.of(force), numbers);
  state.memory = Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

// --- Names of entries.

std::string Equations::entry_name(int index) const {
  static constexpr const char* kPosition[] = {"r.x", "r.y", "r.z", "L.0", "L.x", "L.y", "L.z"};
  static constexpr const char* kVelocity[] = {"dr.x", "dr.y", "dr.z", "w.x", "w.y", "w.z"};
  const auto owner = [](const std::vector<int>& first, int entry) {
    std::size_t i = first.size() - 1;
    while (first[i] > entry) --i;
    return i;
  };
  if (index < layout_.z0()) {
    const bool position = index < layout_.v0();
    const int entry = position ? index : index - layout_.v0();
    const std::vector<int>& first = position ? layout_.body_q : layout_.body_v;
    const std::size_t i = owner(first, entry);
    const int k = entry - first[i], rigid = position ? 7 : 6;
    return "body \"" + model_.body(static_cast<int>(i)).name() + "\": " +
           (k < rigid ? (position ? kPosition[k] : kVelocity[k])
                      : (position ? "a." : "da.") + std::to_string(k - rigid + 1));
  }
  if (index >= layout_.z0() + layout_.signal_z && index < layout_.lambda0())
    return "signals: inner state " + std::to_string(index - layout_.z0() - layout_.signal_z + 1);
  if (index < layout_.lambda0()) {
    std::size_t i = owner(layout_.force_z, index - layout_.z0());
    return "force element \"" + model_.force(static_cast<int>(i)).name() + "\": inner state " +
           std::to_string(index - layout_.z0() - layout_.force_z[i] + 1);
  }
  const int row = index - layout_.lambda0();
  const int joint = layout_.row_joint[row];
  return "joint \"" + model_.joint(joint).name + "\": condition " + std::to_string(row - layout_.joint_row[joint] + 1);
}

}  // namespace footfall
