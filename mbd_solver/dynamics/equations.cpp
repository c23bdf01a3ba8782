#include "mbd_solver/dynamics/equations.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/dynamics/workspace.h"

namespace footfall {
namespace {

// eps of the equations of motion relative to the diagonal of Phi_v M^-1 Phi_v^T.
constexpr double kRegularisation = 1e-12;
// A body lighter than this share of the heaviest that joints connect it with counts as so heavy in eps. Between two heavy
// bodies a light one makes Phi_v M^-1 Phi_v^T large on its diagonal alone; eps would be as large as what holds the two.
constexpr double kLight = 1e-6;
// Lighter than this share it is lost in the round-off of the heaviest.
constexpr double kLost = 1e-15;

// Per body: what eps takes its share of a row's length by, 1 for all but very light ones. Throws InputError.
std::vector<double> shares_in_eps(const Model& model) {
  std::vector<double> heaviest;
  for (int i = 0; i < model.body_count(); ++i) heaviest.push_back(model.body(i).mass());
  // Each pass carries the heaviest mass one joint further.
  for (bool changed = true; changed;) {
    changed = false;
    const auto connect = [&](int a, int b) {
      if (a == kGround || b == kGround) return;
      double &at_a = heaviest[static_cast<std::size_t>(a)], &at_b = heaviest[static_cast<std::size_t>(b)];
      changed = changed || at_a != at_b;
      at_a = at_b = std::max(at_a, at_b);
    };
    for (int j = 0; j < model.joint_count(); ++j) {
      const Joint& joint = model.joint(j);
      connect(joint.m1.body, joint.m2.body);
      if (joint.row_of < 0) continue;
      for (const int other : {model.joint(joint.row_of).m1.body, model.joint(joint.row_of).m2.body})
        for (const int own : {joint.m1.body, joint.m2.body}) connect(other, own);
    }
  }
  for (int i = 0; i < model.body_count(); ++i) {
    double& share = heaviest[static_cast<std::size_t>(i)];
    if (model.body(i).mass() < kLost * share)
      throw InputError(
          "body \"" + model.body(i).name() + "\" weighs " + number_text(model.body(i).mass(), 3) +
          " kg, and a body of " + number_text(share, 3) +
          " kg hangs together with it by joints: masses that differ by more than a factor of 1e15 cannot be "
          "told from each other's round-off. Make it heavier, or leave it out.");
    share = std::min(1.0, model.body(i).mass() / (kLight * share));
  }
  return heaviest;
}

}  // namespace

Equations::Equations(const Model& model, const Assembly& assembly, const Baumgarte& baumgarte)
    : model_(model),
      layout_(model),
      baumgarte_(baumgarte),
      work_(std::make_unique<Workspace>(model, layout_, assembly.redundant)) {
  set_row_sizes(assembly.state);
  rest_rows();
}

Equations::~Equations() = default;

void Equations::set_row_sizes(const State& state) {
  Workspace& w = *work_;
  load(state);
  const std::vector<double> shares = shares_in_eps(model_);
  for_each_row(
      model_, layout_, w.kinematics, state.time, w.row,
      [&](const RowPlace& at, const PairMotion& pair, const Eigen::Ref<Eigen::VectorXd>& phi_v, const RowValue&) {
        const Joint& joint = model_.joint(at.joint);
        const int bodies[2] = {joint.m1.body, joint.m2.body};
        double size = 0.0, held = 0.0;
        for (int i = 0; i < 2; ++i) {
          const int n = pair.body[i]->size();
          if (n == 0) continue;
          Eigen::Ref<Eigen::MatrixXd> M = w.M.topLeftCorner(n, n);
          body_mass_matrix(model_.body(bodies[i]), *pair.body[i], w.inertia[static_cast<std::size_t>(bodies[i])], M);
          const Eigen::VectorXd part = phi_v.segment(pair.offset(i), n);
          const double length2 = part.dot(Eigen::MatrixXd(M).ldlt().solve(part));
          size += length2;
          held += shares[static_cast<std::size_t>(bodies[i])] * length2;
        }
        w.row_size[at.row] += size;  // of a gear, without what its members share on one body: an estimate
        w.eps[at.row] += kRegularisation * held;
      });
  w.smallest_size = w.row_size;
  for (const Redundancy& redundancy : w.redundancies) {
    for (std::size_t i = 0; i < redundancy.rows().size(); ++i) {
      const double s = redundancy.s()[static_cast<Eigen::Index>(i)];
      w.smallest_size[redundancy.rows()[i]] = s * s;
    }
  }
}

void Equations::rest_rows() {
  Workspace& w = *work_;
  if (!w.redundancies.empty()) ++w.rest_choices;
  w.regularisation = w.eps;
  // A row that only gives a joint's coordinate its rotor: lambda = J q''.
  for (int row = 0; row < layout_.row_count; ++row) {
    const int joint = layout_.row_joint[static_cast<std::size_t>(row)];
    const int first = layout_.joint_row[static_cast<std::size_t>(joint)];
    const double inertia = model_.joint(joint).rows[static_cast<std::size_t>(row - first)].inertia;
    if (inertia > 0.0) w.regularisation[row] = 1.0 / inertia;
  }
  for (const Redundancy& redundancy : w.redundancies)
    for (const int i : redundancy.resting()) {
      const int row = redundancy.rows()[static_cast<std::size_t>(i)];
      w.regularisation[row] = w.smallest_size[row];
    }
}

long Equations::rest_choices() const { return work_->rest_choices; }

void Equations::load(const State& state) {
  work_->kinematics.load(layout_, state.q, state.v, work_->empty);
  work_->kinematics.load_turns(layout_, state.z);
}

const BodyKinematics& Equations::motion(int body) const { return work_->kinematics.of(body); }

ElementInput Equations::element_input(int force, const State& state, const Inputs& inputs) const {
  const ForceElement& element = model_.force(force);
  return {work_->force_pair(element),
          state.z.segment(layout_.force_z[static_cast<std::size_t>(force)], element.state_count()), inputs.values,
          state.time};
}

void Equations::demand_fitting(const Inputs& inputs) const {
  for (int i = 0; i < model_.force_count(); ++i)
    FOOTFALL_DEMAND(inputs.values.size() >= model_.force(i).input_count());
  if (inputs.loads.empty()) return;
  FOOTFALL_DEMAND(static_cast<int>(inputs.loads.size()) == model_.body_count());
  for (int i = 0; i < model_.body_count(); ++i) {
    const Eigen::Index size = inputs.loads[static_cast<std::size_t>(i)].Q_a.size();
    FOOTFALL_DEMAND(size == 0 || size == model_.body(i).mode_count());
  }
}

void Equations::residual(double t, const Eigen::Ref<const Eigen::VectorXd>& y,
                         const Eigen::Ref<const Eigen::VectorXd>& ydot, const Inputs& inputs,
                         Eigen::Ref<Eigen::VectorXd> F) {
  Workspace& w = *work_;
  const auto lambda = y.segment(layout_.lambda0(), layout_.row_count);
  w.kinematics.load(layout_, y.head(layout_.q_size), y.segment(layout_.v0(), layout_.v_size),
                    ydot.segment(layout_.v0(), layout_.v_size));
  w.kinematics.load_turns(layout_, y.segment(layout_.z0(), layout_.z_size));
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
    MarkerVectors vectors(w.joint_pair(joint), joint.m1, joint.m2);
    const PairMotion& pair = vectors.pair();
    Eigen::Ref<Eigen::VectorXd> reaction = w.local.head(pair.size());
    reaction.setZero();
    int row = layout_.joint_row[static_cast<std::size_t>(j)];
    for (const ConstraintRow& written : joint.rows) {
      const RowValue value =
          measure_row_with_reaction(written, t, vectors, lambda[row], w.row.head(pair.size()), reaction, w.kinematics.turns(j));
      double& condition = F[layout_.lambda0() + row];
      if (joint.row_of < 0) condition = -w.regularisation[row] * lambda[row];  // else the row of an earlier joint
      condition += value.acc + alpha2 * value.rate + beta2 * value.phi;
      ++row;
    }
    vectors.add_pushed(reaction);
    const std::array<int, 2> v = pair_v(layout_, joint.m1.body, joint.m2.body);
    for (int i = 0; i < 2; ++i) {
      const int n = pair.body[i]->size();
      if (n > 0) F.segment(layout_.v0() + v[static_cast<std::size_t>(i)], n) += reaction.segment(pair.offset(i), n);
    }
  }

  // Continuous signals, then force elements.
  const Eigen::VectorXd& values = input_values_at(t, y, inputs);
  if (model_.signals()) F.segment(layout_.z0() + layout_.signal_z, w.signal_rates.size()) -= w.signal_rates;
  for (int i = 0; i < model_.force_count(); ++i) {
    const ForceElement& element = model_.force(i);
    const PairMotion pair = w.force_pair(element);
    const int z = layout_.z0() + layout_.force_z[static_cast<std::size_t>(i)], m = element.state_count();
    Eigen::Ref<Eigen::VectorXd> Q = w.local.head(pair.size());
    Eigen::Ref<Eigen::VectorXd> dz = w.row.head(m);
    Q.setZero();
    element.add_force({pair, y.segment(z, m), values, t}, Q, dz);
    const std::array<int, 2> v = pair_v(layout_, element.bodies()[0], element.bodies()[1]);
    for (int k = 0; k < 2; ++k) {
      const int n = pair.body[k]->size();
      if (n > 0) F.segment(layout_.v0() + v[static_cast<std::size_t>(k)], n) -= Q.segment(pair.offset(k), n);
    }
    F.segment(z, m) -= dz;
  }
}

void Equations::pack(const State& state, const Eigen::Ref<const Eigen::VectorXd>& lambda,
                     Eigen::Ref<Eigen::VectorXd> y) const {
  y << state.q, state.v, state.z, lambda;
}

void Equations::unpack(const Eigen::Ref<const Eigen::VectorXd>& y, State& state) const {
  state.q = y.head(layout_.q_size);
  state.v = y.segment(layout_.v0(), layout_.v_size);
  state.z = y.segment(layout_.z0(), layout_.z_size);
}

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
  const int joint = layout_.row_joint[static_cast<std::size_t>(row)];
  return "joint \"" + model_.joint(joint).name + "\": condition " +
         std::to_string(row - layout_.joint_row[static_cast<std::size_t>(joint)] + 1);
}

}  // namespace footfall
