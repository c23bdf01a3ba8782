// The residual is assembled body by body, joint by joint and element by element; the Jacobian is gathered over [v; z; lambda]
// by increments dx = [dr; dtheta; da] and by velocities, and q is eliminated by dq = N v at the rate c:
//   dx = T dv,  T = diag(1/c, (c I + w~/2) / (c^2 + |w|^2 / 4), 1/c).

#include "mbd_solver/dynamics/equations.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "coupler/base/errors.h"
#include "mbd_solver/dynamics/body_force.h"
#include "mbd_solver/dynamics/jacobian_pattern.h"
#include "mbd_solver/model/control/continuous_signals.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {

// Scratch data of Equations: sized once, then reused.
struct Equations::Workspace {
  Workspace(const Model& model, const Layout& layout);

  PairMotion joint_pair(const Joint& joint) const { return kinematics.pair(joint.m1.body, joint.m2.body); }
  PairMotion force_pair(const ForceElement& force) const {
    return kinematics.pair(force.bodies()[0], force.bodies()[1]);
  }

  Kinematics kinematics;
  ElementScratches scratch;
  std::optional<ContinuousSignals> signals;  // a copy of the model's signals
  JacobianPattern pattern;
  Eigen::VectorXd own_diagonal;              // per velocity
  std::vector<InertiaScratch> inertia;       // per body
  std::vector<ElementDerivatives> elements;  // per force element
  Eigen::VectorXd row, row2, row3, row4;     // local rows of the largest pair
  RowScratch row_scratch{0};                 // of the largest pair
  Eigen::VectorXd local;                     // generalized force of a pair
  Eigen::MatrixXd K, D, M;                   // local matrices of the largest pair or body
  Eigen::VectorXd empty;
  Eigen::VectorXd values, signal_rates;  // inputs with the continuous signals; rates of their states
  std::vector<double> memory;
  std::vector<int> working_joints;  // with rows that move with time or turn a rotor: the others do no work
};

Equations::Workspace::Workspace(const Model& model, const Layout& layout)
    : kinematics(model), scratch(model), pattern(model, layout, kinematics) {
  if (model.signals()) signals.emplace(*model.signals());
  int largest = 0;
  for (int i = 0; i < model.body_count(); ++i) {
    inertia.emplace_back(model.body(i).mode_count());
    largest = std::max(largest, 6 + model.body(i).mode_count());
  }
  const int n = 2 * largest;
  int most = n;  // of the largest element
  K = D = M = Eigen::MatrixXd::Zero(n, n);
  int most_states = 0;
  for (int i = 0; i < model.force_count(); ++i) {
    const ForceElement& force = model.force(i);
    int size = force_pair(force).size();
    const int m = force.state_count();
    for (const int body : force.further_bodies()) size += kinematics.of(body).size();
    most = std::max(most, size);
    ElementDerivatives d;
    d.dQ_dx = d.dQ_dv = Eigen::MatrixXd::Zero(size, size);
    d.dQ_dz = Eigen::MatrixXd::Zero(size, m);
    d.ddz_dx = d.ddz_dv = Eigen::MatrixXd::Zero(m, size);
    d.ddz_dz = Eigen::MatrixXd::Zero(m, force.state_block());
    elements.push_back(d);
    most_states = std::max(most_states, m);
  }
  local = Eigen::VectorXd::Zero(most);
  row_scratch = RowScratch(n);
  row = row2 = row3 = row4 = Eigen::VectorXd::Zero(std::max(n, most_states));
  for (int j = 0; j < model.joint_count(); ++j) {
    for (const ConstraintRow& r : model.joint(j).rows) {
      if (!r.motion && !(r.inertia > 0.0) && !r.law) continue;
      working_joints.push_back(j);
      break;
    }
  }
  own_diagonal = Eigen::VectorXd::Zero(layout.v_size);
  signal_rates = Eigen::VectorXd::Zero(layout.z_size - layout.signal_z);
}

Equations::Equations(const Model& model, const Assembly& assembly, const Baumgarte& baumgarte)
    : model_(model),
      layout_(model),
      baumgarte_(baumgarte),
      work_(std::make_unique<Workspace>(model, layout_)),
      saddle_(std::make_unique<SaddleSystem>(*this, assembly)) {
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

void Equations::load(const Eigen::Ref<const Eigen::VectorXd>& y) {
  work_->kinematics.load(layout_, y.head(layout_.q_size), y.segment(layout_.v0(), layout_.v_size), work_->empty);
  work_->kinematics.load_turns(layout_, y.segment(layout_.z0(), layout_.z_size));
}

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
  const Eigen::VectorXd& values = input_values_at(t, y, inputs);
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
  w.kinematics.load(layout_, y.head(layout_.q_size), y.segment(layout_.v0(), layout_.v_size), w.empty);
  w.kinematics.load_turns(layout_, y.segment(layout_.z0(), layout_.z_size));
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
  const Eigen::VectorXd& values = input_values_at(t, y, inputs);
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
  return footfall::joint_wrench(joint, work_->joint_pair(joint), t,
                                lambda.segment(layout_.joint_row[index], static_cast<Eigen::Index>(joint.rows.size())));
}

// --- Jacobians.

namespace {

// Relative to a body's contribution to the diagonal: Newton takes one iteration in a hundred more.
constexpr double kNegligible = 3e-3;

void add_columns(const SparseBlock& block, double* values, const Eigen::Ref<const Eigen::MatrixXd>& X) {
  for (Eigen::Index k = 0; k < X.cols(); ++k) block.add_column(values, static_cast<int>(k), X.col(k));
}

// One column of a matrix as a vector of its stored values.
Eigen::Map<const Eigen::VectorXd> stored(const Eigen::SparseMatrix<double>& pattern, const double* values, int column) {
  const int begin = pattern.outerIndexPtr()[column], end = pattern.outerIndexPtr()[column + 1];
  return {values + begin, end - begin};
}

// The last `count` stored values of a column.
Eigen::Map<Eigen::VectorXd> tail(Eigen::SparseMatrix<double>& matrix, int column, Eigen::Index count) {
  return {matrix.valuePtr() + matrix.outerIndexPtr()[column + 1] - count, count};
}

}  // namespace

void Equations::add_body_derivatives(int index, double c, const Inputs& inputs) {
  Workspace& w = *work_;
  const std::size_t at = static_cast<std::size_t>(index);
  const BodyKinematics& body = w.kinematics.of(index);
  const int n = body.size();
  Eigen::Ref<Eigen::MatrixXd> K = w.K.topLeftCorner(n, n), D = w.D.topLeftCorner(n, n), M = w.M.topLeftCorner(n, n);
  body_derivatives(model_.body(index), body, w.inertia[at], K, D, M);
  Eigen::Ref<Eigen::VectorXd> own = w.own_diagonal.segment(layout_.body_v[at], n);
  own = c * M.diagonal();
  if (body.modes > 0) {
    own.tail(body.modes) += D.diagonal().tail(body.modes).cwiseMax(0.0);
    own.tail(body.modes) += (1.0 / c) * K.diagonal().tail(body.modes).cwiseMax(0.0);
  }
  if (!inputs.loads.empty()) {  // F_v takes -Q
    K = -K;
    D = -D;
    add_load_derivatives(inputs.loads[at], body, K, D);
    K = -K;
    D = -D;
  }
  D += c * M;
  add_columns(w.pattern.bodies[at], w.pattern.stiffness.data(), K);
  add_columns(w.pattern.bodies[at], w.pattern.lower.valuePtr(), D);
}

void Equations::add_joint_derivatives(int index, double t, double c, const Eigen::Ref<const Eigen::VectorXd>& lambda) {
  Workspace& w = *work_;
  const Joint& joint = model_.joint(index);
  const PairPlaces& places = w.pattern.joints[index];
  const PairMotion pair = w.joint_pair(joint);
  MarkerVectors vectors(pair, joint.m1, joint.m2);
  const int n = pair.size();
  double* values = w.pattern.lower.valuePtr();
  double* stiffness = w.pattern.stiffness.data();
  const bool closes = joint.rows.front().inertia == 0.0;  // else a rotor
  const double alpha2 = closes ? 2.0 * baumgarte_.alpha : 0.0;

  Eigen::Ref<Eigen::MatrixXd> K = w.K.topLeftCorner(n, n);
  Eigen::Ref<Eigen::VectorXd> phi_v = w.row.head(n), rate_dx = w.row2.head(n), acc_dx = w.row3.head(n),
                              acc_dv = w.row4.head(n);
  K.setZero();
  for (std::size_t k = 0; k < joint.rows.size(); ++k) {
    const int local = static_cast<int>(k), row = layout_.joint_row[index] + local;
    const double beta2 = closes && joint.rows[k].holds_positions() ? baumgarte_.beta * baumgarte_.beta : 0.0;
    const double turns = w.kinematics.turns(index);
    evaluate_row(joint.rows[k], t, vectors, phi_v, turns);
    row_derivatives(joint.rows[k], t, vectors, lambda[row], rate_dx, acc_dx, acc_dv, K, w.row_scratch, turns);
    // F_lambda = phi'' + 2 alpha phi' + beta^2 phi - eps lambda
    if (alpha2 != 0.0 || beta2 != 0.0) acc_dx += alpha2 * rate_dx + beta2 * phi_v;
    acc_dv += (c + alpha2) * phi_v;
    for (int i = 0; i < 2; ++i) {
      const int m = pair.body[i]->size(), offset = pair.offset(i);
      if (m == 0) continue;
      for (int j = 0; j < m; ++j) {
        places.extra_v[i].add(stiffness, local, j, acc_dx[offset + j]);
        places.extra_v[i].add(values, local, j, acc_dv[offset + j]);
      }
      places.v_extra[i].add_column(values, local, phi_v.segment(offset, m));
    }
  }
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      const int ni = pair.body[i]->size(), nj = pair.body[j]->size();
      if (ni > 0 && nj > 0) add_columns(places.v_v[i][j], stiffness, K.block(pair.offset(i), pair.offset(j), ni, nj));
    }
  }
}

void Equations::add_force_derivatives(int index, double t, const Eigen::Ref<const Eigen::VectorXd>& z,
                                      const Eigen::VectorXd& input_values) {
  Workspace& w = *work_;
  const ForceElement& element = model_.force(index);
  const ElementPlaces& places = w.pattern.forces[index];
  const ElementInput in = footfall::element_input(element, w.kinematics, z, input_values, t, w.scratch.of(index));
  ElementDerivatives& d = w.elements[index];
  double* values = w.pattern.lower.valuePtr();
  double* stiffness = w.pattern.stiffness.data();
  for (Eigen::MatrixXd* part : {&d.dQ_dx, &d.dQ_dv, &d.dQ_dz, &d.ddz_dx, &d.ddz_dv, &d.ddz_dz}) part->setZero();
  if (!element.add_derivatives(in, d)) return;

  // F_v takes -Q, F_z takes -g.
  for (Eigen::MatrixXd* part : {&d.dQ_dx, &d.dQ_dv, &d.dQ_dz, &d.ddz_dx, &d.ddz_dv, &d.ddz_dz}) *part = -*part;
  const auto body = [&](std::size_t i) { return i < 2 ? in.pair.body[i] : in.further[i - 2]; };
  const std::size_t count = 2 + element.further_bodies().size();
  for (std::size_t j = 0, cj = 0; j < count; cj += static_cast<std::size_t>(body(j++)->size())) {
    const int nj = body(j)->size(), column = static_cast<int>(cj);
    if (nj == 0) continue;
    for (std::size_t i = 0, ci = 0; i < count; ci += static_cast<std::size_t>(body(i++)->size())) {
      const int ni = body(i)->size(), row = static_cast<int>(ci);
      if (ni == 0) continue;
      add_columns(places.v_v[i][j], stiffness, d.dQ_dx.block(row, column, ni, nj));
      add_columns(places.v_v[i][j], values, d.dQ_dv.block(row, column, ni, nj));
    }
    if (element.state_count() == 0) continue;
    add_columns(places.extra_v[j], stiffness, d.ddz_dx.middleCols(column, nj));
    add_columns(places.extra_v[j], values, d.ddz_dv.middleCols(column, nj));
    add_columns(places.v_extra[j], values, d.dQ_dz.middleRows(column, nj));
  }
  const int block = element.state_block();
  for (std::size_t k = 0; k < places.extra_extra.size(); ++k)
    add_columns(places.extra_extra[k], values, d.ddz_dz.middleRows(static_cast<int>(k) * block, block));
}

void Equations::gather_derivatives(double t, const Eigen::Ref<const Eigen::VectorXd>& y,
                                   const Eigen::Ref<const Eigen::VectorXd>& ydot, double c, const Inputs& inputs) {
  Workspace& w = *work_;
  w.kinematics.load(layout_, y.head(layout_.q_size), y.segment(layout_.v0(), layout_.v_size),
                    ydot.segment(layout_.v0(), layout_.v_size));
  w.kinematics.load_turns(layout_, y.segment(layout_.z0(), layout_.z_size));
  w.pattern.stiffness.setZero();
  Eigen::Map<Eigen::VectorXd>(w.pattern.lower.valuePtr(), w.pattern.lower.nonZeros()).setZero();
  for (int i = 0; i < model_.body_count(); ++i) add_body_derivatives(i, c, inputs);
  for (int i = 0; i < model_.joint_count(); ++i) add_joint_derivatives(i, t, c, y.tail(layout_.row_count));
  for (int place : w.pattern.z_z) w.pattern.lower.valuePtr()[place] += c;
  for (std::size_t row = 0; row < w.pattern.lambda_lambda.size(); ++row)
    w.pattern.lower.valuePtr()[w.pattern.lambda_lambda[row]] -=
        saddle_->regularisation()[static_cast<Eigen::Index>(row)];
  const Eigen::VectorXd& values = input_values_at(t, y, inputs);
  for (int i = 0; i < model_.force_count(); ++i)
    add_force_derivatives(i, t, y.segment(layout_.z0() + layout_.force_z[i], model_.force(i).state_count()), values);
  if (model_.signals()) add_signal_derivatives(t, y);
}

const Eigen::SparseMatrix<double>& Equations::reduced_pattern() const { return work_->pattern.reduced; }

const Eigen::VectorXd& Equations::own_diagonal() const { return work_->own_diagonal; }

double Equations::largest_stiffness(double c) const {
  double largest = 0.0;
  for (int i = 0; i < layout_.v_size; ++i)
    largest = std::max(largest, work_->pattern.stiffness[work_->pattern.v_v[i]] / (c * work_->own_diagonal[i]));
  return largest;
}

// Pairs of forces cancel in the sum of the rows of dr, so that Newton conserves linear momentum to round-off at every
// iteration: these rows are complete. With redundant rows all are complete, because the mechanism may pass singular
// positions, where the result depends on the order of pivots.
Eigen::VectorXd Equations::negligible_shares() const {
  if (saddle_->has_redundant_rows()) return Eigen::VectorXd::Zero(layout_.v_size);
  Eigen::VectorXd share = Eigen::VectorXd::Constant(layout_.v_size, kNegligible);
  for (const int v : layout_.body_v) share.segment<3>(v).setConstant(ThinLu::kRoundOff);
  return share;
}

std::vector<LocalUnknowns> Equations::local_states() const {
  constexpr int kMany = 16;  // of one element: fewer cost little in the sparse matrix
  std::vector<LocalUnknowns> out;
  for (int i = 0; i < model_.force_count(); ++i) {
    const ForceElement& element = model_.force(i);
    if (element.state_count() < kMany || element.state_block() > CondensedMatrix::kLargestBlock) continue;
    out.push_back({layout_.v_size + layout_.force_z[i], element.state_count(), element.state_block()});
  }
  return out;
}

const Eigen::SparseMatrix<double>& Equations::reduced_jacobian(double t, const Eigen::Ref<const Eigen::VectorXd>& y,
                                                               const Eigen::Ref<const Eigen::VectorXd>& ydot, double c,
                                                               const Inputs& inputs) {
  Workspace& w = *work_;
  gather_derivatives(t, y, ydot, c, inputs);
  Eigen::Map<Eigen::VectorXd> values(w.pattern.reduced.valuePtr(), w.pattern.reduced.nonZeros());
  values = Eigen::Map<const Eigen::VectorXd>(w.pattern.lower.valuePtr(), w.pattern.lower.nonZeros());
  for (int i = 0; i < model_.body_count(); ++i) {
    const BodyKinematics& body = w.kinematics.of(i);
    const int v = layout_.body_v[i];
    const auto by = [&](int k) { return stored(w.pattern.lower, w.pattern.stiffness.data(), v + k); };
    const Eigen::Index count = by(0).size();
    Eigen::Matrix3d T = 0.5 * skew(body.w);
    T.diagonal().array() += c;
    T /= c * c + 0.25 * body.w.squaredNorm();
    for (int k = 0; k < 3; ++k) tail(w.pattern.reduced, v + k, count) += by(k) / c;
    for (int k = 0; k < 3; ++k)
      tail(w.pattern.reduced, v + 3 + k, count) += T(0, k) * by(3) + T(1, k) * by(4) + T(2, k) * by(5);
    for (int k = 6; k < body.size(); ++k) tail(w.pattern.reduced, v + k, count) += by(k) / c;
  }
  return w.pattern.reduced;
}

void Equations::subtract_stiffness(const Eigen::Ref<const Eigen::VectorXd>& dx, Eigen::Ref<Eigen::VectorXd> out) const {
  const Workspace& w = *work_;
  const int* outer = w.pattern.lower.outerIndexPtr();
  const int* inner = w.pattern.lower.innerIndexPtr();
  for (int j = 0; j < layout_.v_size; ++j) {
    for (int k = outer[j]; k < outer[j + 1]; ++k) out[inner[k]] -= w.pattern.stiffness[k] * dx[j];
  }
}

// --- Continuous signals: derivatives by central differences.

namespace {

constexpr double kDifference = 1e-6;  // step of differences, which only Newton's matrix uses [m, rad, m/s, rad/s, -]

struct SignalValues {
  std::vector<double> values, rates;  // of values that an influence changes
};

// The instant of a state, with one body changed.
struct Changed {
  const Instant& base;
  const BodyKinematics& was;
  BodyKinematics now;
  const BodyKinematics& of(int body) const { return &base.of(body) == &was ? now : base.of(body); }
  PairMotion pair(int body_1, int body_2) const { return {{&of(body_1), &of(body_2)}}; }
  Eigen::Ref<const Eigen::VectorXd> states(int force) const { return base.states(force); }
};

// Moves coordinate j of dx = [dr; dtheta; da], or of v = [dr; w; da].
void move(BodyKinematics& body, bool position, int j, double step) {
  const Eigen::Vector3d e = Eigen::Vector3d::Unit(j % 3) * step;
  if (j >= 6) {
    (position ? body.a : body.da)[j - 6] += step;
  } else if (!position) {
    (j < 3 ? body.dr : body.w) += e;
  } else if (j < 3) {
    body.r += e;
  } else {
    body.L += quaternion_rate(body.L, e);
    body.A = rotation_matrix(body.L);
  }
}

}  // namespace

const Eigen::VectorXd& Equations::input_values_at(double t, const Eigen::Ref<const Eigen::VectorXd>& y,
                                                  const Inputs& inputs) {
  Workspace& w = *work_;
  if (!w.signals) return inputs.values;
  w.values = inputs.values;
  const Instant instant{w.kinematics, layout_, model_, y.segment(layout_.z0(), layout_.z_size)};
  w.signals->evaluate(t, instant, instant.z.tail(w.signal_rates.size()), w.values, w.signal_rates);
  return w.values;
}

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

// Central differences over each coordinate and velocity of the measured bodies, and over each state of the signals;
// only values that depend on it are evaluated. w.values and w.signal_rates belong to the loaded state, before and
// after. F_z contains minus the rates, F_v minus the forces.
void Equations::add_signal_derivatives(double t, const Eigen::Ref<const Eigen::VectorXd>& y) {
  Workspace& w = *work_;
  ContinuousSignals& signals = *w.signals;
  const Instant given_instant{w.kinematics, layout_, model_, y.segment(layout_.z0(), layout_.z_size)};
  Eigen::VectorXd z = y.segment(layout_.z0() + layout_.signal_z, w.signal_rates.size());
  SignalValues plus, minus;

  const auto read = [&](const ContinuousSignals::Influence& of, SignalValues& out) {
    out.values.clear();
    out.rates.clear();
    for (const int place : of.places) out.values.push_back(w.values[place]);
    for (const auto& [first, count] : of.rates)
      for (int k = 0; k < count; ++k) out.rates.push_back(w.signal_rates[first + k]);
  };
  const auto set_values = [&](const ContinuousSignals::Influence& of, const SignalValues& from) {
    for (std::size_t i = 0; i < of.places.size(); ++i) w.values[of.places[i]] = from.values[i];
  };
  // Adds the column of one change to these values.
  const auto add_column = [&](const SignalPlaces& places, double* values, int column, double step) {
    std::size_t k = 0;
    Eigen::VectorXd rates;
    for (std::size_t i = 0; i < places.rates.size(); ++i) {
      rates.resize(places.of.rates[i].second);
      for (Eigen::Index l = 0; l < rates.size(); ++l, ++k) rates[l] = (minus.rates[k] - plus.rates[k]) / (2.0 * step);
      places.rates[i].add_column(values, column, rates);
    }
    if (plus.values == minus.values) return;
    for (const SignalPlaces::Driven& driven : places.driven) {
      const ForceElement& element = model_.force(driven.force);
      const PairMotion pair = w.force_pair(element);
      const int m = element.state_count();
      const auto z_of = y.segment(layout_.z0() + layout_.force_z[driven.force], m);
      Eigen::VectorXd Q[2], dz[2];
      for (const int side : {0, 1}) {
        Q[side] = Eigen::VectorXd::Zero(pair.size());
        dz[side] = Eigen::VectorXd::Zero(m);
        set_values(places.of, side == 0 ? plus : minus);
        ElementInput in{pair, z_of, w.values, t};
        in.scratch = w.scratch.of(driven.force);
        element.add_force(in, Q[side], dz[side]);
      }
      const Eigen::VectorXd dQ = (Q[1] - Q[0]) / (2.0 * step), ddz = (dz[1] - dz[0]) / (2.0 * step);
      for (int i = 0; i < 2; ++i) {
        const int n = pair.body[i]->size();
        if (n > 0) driven.v[i].add_column(values, column, dQ.segment(pair.offset(i), n));
      }
      if (m > 0) driven.z.add_column(values, column, ddz);
    }
  };

  for (const SignalPlaces& places : w.pattern.signals) {
    const ContinuousSignals::Influence& of = places.of;
    const auto evaluate = [&](const auto& instant) { signals.evaluate(of, instant, z, w.values, w.signal_rates); };
    if (of.body != kGround) {
      const BodyKinematics& body = w.kinematics.of(of.body);
      for (const bool position : {true, false}) {
        for (int j = 0; j < body.size(); ++j) {
          Changed changed{given_instant, body, body};
          move(changed.now, position, j, kDifference);
          evaluate(changed);
          read(of, plus);
          changed.now = changed.was;
          move(changed.now, position, j, -kDifference);
          evaluate(changed);
          read(of, minus);
          add_column(places, position ? w.pattern.stiffness.data() : w.pattern.lower.valuePtr(), j, kDifference);
        }
      }
    }
    for (int j = 0; j < of.state_count; ++j) {
      double& state = z[of.first_state + j];
      const double given = state, step = kDifference * (1.0 + std::abs(given));
      state = given + step;
      evaluate(given_instant);
      read(of, plus);
      state = given - step;
      evaluate(given_instant);
      read(of, minus);
      state = given;
      add_column(places, w.pattern.lower.valuePtr(), j, step);
    }
    evaluate(given_instant);
  }
}

// --- States as vectors, names of entries.

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
  const int joint = layout_.row_joint[row];
  return "joint \"" + model_.joint(joint).name + "\": condition " + std::to_string(row - layout_.joint_row[joint] + 1);
}

}  // namespace footfall
