// Gathered body by body, joint by joint and element by element, each at its own places of the pattern.

#include "mbd_solver/dynamics/jacobian.h"

#include <algorithm>
#include <cmath>

#include "mbd_solver/dynamics/saddle_system.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {

Jacobian::Jacobian(Evaluation& evaluation, const SaddleSystem& saddle, const Baumgarte& baumgarte)
    : at_(evaluation),
      model_(evaluation.model),
      layout_(evaluation.layout),
      saddle_(saddle),
      baumgarte_(baumgarte),
      pattern_(model_, layout_, at_.kinematics),
      own_diagonal_(Eigen::VectorXd::Zero(layout_.v_size)),
      row_scratch_(at_.largest_pair) {
  for (int i = 0; i < model_.force_count(); ++i) {
    const ForceElement& force = model_.force(i);
    int size = at_.pair_of(force).size();
    for (const int body : force.further_bodies()) size += at_.kinematics.of(body).size();
    const int m = force.state_count();
    ElementDerivatives d;
    d.dQ_dx = d.dQ_dv = Eigen::MatrixXd::Zero(size, size);
    d.dQ_dz = Eigen::MatrixXd::Zero(size, m);
    d.ddz_dx = d.ddz_dv = Eigen::MatrixXd::Zero(m, size);
    d.ddz_dz = Eigen::MatrixXd::Zero(m, force.state_block());
    elements_.push_back(d);
  }
  row_ = row2_ = row3_ = row4_ = Eigen::VectorXd::Zero(at_.largest_pair);
  K_ = D_ = M_ = Eigen::MatrixXd::Zero(at_.largest_pair, at_.largest_pair);
}

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

void Jacobian::add_body(int index, double c, const Inputs& inputs) {
  const std::size_t at = static_cast<std::size_t>(index);
  const BodyKinematics& body = at_.kinematics.of(index);
  const int n = body.size();
  Eigen::Ref<Eigen::MatrixXd> K = K_.topLeftCorner(n, n), D = D_.topLeftCorner(n, n), M = M_.topLeftCorner(n, n);
  body_derivatives(model_.body(index), body, at_.inertia[at], K, D, M);
  Eigen::Ref<Eigen::VectorXd> own = own_diagonal_.segment(layout_.body_v[at], n);
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
  add_columns(pattern_.bodies[at], pattern_.stiffness.data(), K);
  add_columns(pattern_.bodies[at], pattern_.lower.valuePtr(), D);
}

void Jacobian::add_joint(int index, double t, double c, const Eigen::Ref<const Eigen::VectorXd>& lambda) {
  const Joint& joint = model_.joint(index);
  const PairPlaces& places = pattern_.joints[index];
  const PairMotion pair = at_.pair_of(joint);
  MarkerVectors vectors(pair, joint.m1, joint.m2);
  const int n = pair.size();
  double* values = pattern_.lower.valuePtr();
  double* stiffness = pattern_.stiffness.data();
  const bool closes = joint.rows.front().inertia == 0.0;  // else a rotor
  const double alpha2 = closes ? 2.0 * baumgarte_.alpha : 0.0;

  Eigen::Ref<Eigen::MatrixXd> K = K_.topLeftCorner(n, n);
  Eigen::Ref<Eigen::VectorXd> phi_v = row_.head(n), rate_dx = row2_.head(n), acc_dx = row3_.head(n),
                              acc_dv = row4_.head(n);
  K.setZero();
  for (std::size_t k = 0; k < joint.rows.size(); ++k) {
    const int local = static_cast<int>(k), row = layout_.joint_row[index] + local;
    const double beta2 = closes && joint.rows[k].holds_positions() ? baumgarte_.beta * baumgarte_.beta : 0.0;
    const double turns = at_.kinematics.turns(index);
    evaluate_row(joint.rows[k], t, vectors, phi_v, turns);
    row_derivatives(joint.rows[k], t, vectors, lambda[row], rate_dx, acc_dx, acc_dv, K, row_scratch_, turns);
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

void Jacobian::add_force(int index, double t, const Eigen::Ref<const Eigen::VectorXd>& z,
                         const Eigen::VectorXd& input_values) {
  const ForceElement& element = model_.force(index);
  const ElementPlaces& places = pattern_.forces[index];
  const ElementInput in = footfall::element_input(element, at_.kinematics, z, input_values, t, at_.scratch.of(index));
  ElementDerivatives& d = elements_[index];
  double* values = pattern_.lower.valuePtr();
  double* stiffness = pattern_.stiffness.data();
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

void Jacobian::gather(double t, const Eigen::Ref<const Eigen::VectorXd>& y,
                      const Eigen::Ref<const Eigen::VectorXd>& ydot, double c, const Inputs& inputs) {
  at_.load(y, ydot);
  pattern_.stiffness.setZero();
  Eigen::Map<Eigen::VectorXd>(pattern_.lower.valuePtr(), pattern_.lower.nonZeros()).setZero();
  for (int i = 0; i < model_.body_count(); ++i) add_body(i, c, inputs);
  for (int i = 0; i < model_.joint_count(); ++i) add_joint(i, t, c, y.tail(layout_.row_count));
  for (int place : pattern_.z_z) pattern_.lower.valuePtr()[place] += c;
  for (std::size_t row = 0; row < pattern_.lambda_lambda.size(); ++row)
    pattern_.lower.valuePtr()[pattern_.lambda_lambda[row]] -= saddle_.regularisation()[static_cast<Eigen::Index>(row)];
  const Eigen::VectorXd& values = at_.input_values(t, y, inputs);
  for (int i = 0; i < model_.force_count(); ++i)
    add_force(i, t, y.segment(layout_.z0() + layout_.force_z[i], model_.force(i).state_count()), values);
  if (model_.signals()) add_signals(t, y);
}

double Jacobian::largest_stiffness(double c) const {
  double largest = 0.0;
  for (int i = 0; i < layout_.v_size; ++i)
    largest = std::max(largest, pattern_.stiffness[pattern_.v_v[i]] / (c * own_diagonal_[i]));
  return largest;
}

// Pairs of forces cancel in the sum of the rows of dr, so that Newton conserves linear momentum to round-off at every
// iteration: these rows are complete. With redundant rows all are complete, because the mechanism may pass singular
// positions, where the result depends on the order of pivots.
Eigen::VectorXd Jacobian::negligible_shares() const {
  if (saddle_.has_redundant_rows()) return Eigen::VectorXd::Zero(layout_.v_size);
  Eigen::VectorXd share = Eigen::VectorXd::Constant(layout_.v_size, kNegligible);
  for (const int v : layout_.body_v) share.segment<3>(v).setConstant(ThinLu::kRoundOff);
  return share;
}

std::vector<LocalUnknowns> Jacobian::local_states() const {
  constexpr int kMany = 16;  // of one element: fewer cost little in the sparse matrix
  std::vector<LocalUnknowns> out;
  for (int i = 0; i < model_.force_count(); ++i) {
    const ForceElement& element = model_.force(i);
    if (element.state_count() < kMany || element.state_block() > CondensedMatrix::kLargestBlock) continue;
    out.push_back({layout_.v_size + layout_.force_z[i], element.state_count(), element.state_block()});
  }
  return out;
}

const Eigen::SparseMatrix<double>& Jacobian::evaluate(double t, const Eigen::Ref<const Eigen::VectorXd>& y,
                                                      const Eigen::Ref<const Eigen::VectorXd>& ydot, double c,
                                                      const Inputs& inputs) {
  gather(t, y, ydot, c, inputs);
  Eigen::Map<Eigen::VectorXd> values(pattern_.reduced.valuePtr(), pattern_.reduced.nonZeros());
  values = Eigen::Map<const Eigen::VectorXd>(pattern_.lower.valuePtr(), pattern_.lower.nonZeros());
  for (int i = 0; i < model_.body_count(); ++i) {
    const BodyKinematics& body = at_.kinematics.of(i);
    const int v = layout_.body_v[i];
    const auto by = [&](int k) { return stored(pattern_.lower, pattern_.stiffness.data(), v + k); };
    const Eigen::Index count = by(0).size();
    Eigen::Matrix3d T = 0.5 * skew(body.w);
    T.diagonal().array() += c;
    T /= c * c + 0.25 * body.w.squaredNorm();
    for (int k = 0; k < 3; ++k) tail(pattern_.reduced, v + k, count) += by(k) / c;
    for (int k = 0; k < 3; ++k)
      tail(pattern_.reduced, v + 3 + k, count) += T(0, k) * by(3) + T(1, k) * by(4) + T(2, k) * by(5);
    for (int k = 6; k < body.size(); ++k) tail(pattern_.reduced, v + k, count) += by(k) / c;
  }
  return pattern_.reduced;
}

void Jacobian::subtract_stiffness(const Eigen::Ref<const Eigen::VectorXd>& dx, Eigen::Ref<Eigen::VectorXd> out) const {
  const int* outer = pattern_.lower.outerIndexPtr();
  const int* inner = pattern_.lower.innerIndexPtr();
  for (int j = 0; j < layout_.v_size; ++j) {
    for (int k = outer[j]; k < outer[j + 1]; ++k) out[inner[k]] -= pattern_.stiffness[k] * dx[j];
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

// Central differences over each coordinate and velocity of the measured bodies, and over each state of the signals;
// only values that depend on it are evaluated. values and rates of signals belong to the loaded state, before and
// after. F_z contains minus the rates, F_v minus the forces.
void Jacobian::add_signals(double t, const Eigen::Ref<const Eigen::VectorXd>& y) {
  ContinuousSignals& signals = *at_.signals;
  const Instant given_instant{at_.kinematics, layout_, model_, y.segment(layout_.z0(), layout_.z_size)};
  Eigen::VectorXd z = y.segment(layout_.z0() + layout_.signal_z, at_.signal_rates.size());
  SignalValues plus, minus;

  const auto read = [&](const ContinuousSignals::Influence& of, SignalValues& out) {
    out.values.clear();
    out.rates.clear();
    for (const int place : of.places) out.values.push_back(at_.values[place]);
    for (const auto& [first, count] : of.rates)
      for (int k = 0; k < count; ++k) out.rates.push_back(at_.signal_rates[first + k]);
  };
  const auto set_values = [&](const ContinuousSignals::Influence& of, const SignalValues& from) {
    for (std::size_t i = 0; i < of.places.size(); ++i) at_.values[of.places[i]] = from.values[i];
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
      const PairMotion pair = at_.pair_of(element);
      const int m = element.state_count();
      const auto z_of = y.segment(layout_.z0() + layout_.force_z[driven.force], m);
      Eigen::VectorXd Q[2], dz[2];
      for (const int side : {0, 1}) {
        Q[side] = Eigen::VectorXd::Zero(pair.size());
        dz[side] = Eigen::VectorXd::Zero(m);
        set_values(places.of, side == 0 ? plus : minus);
        ElementInput in{pair, z_of, at_.values, t};
        in.scratch = at_.scratch.of(driven.force);
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

  for (const SignalPlaces& places : pattern_.signals) {
    const ContinuousSignals::Influence& of = places.of;
    const auto evaluate = [&](const auto& instant) { signals.evaluate(of, instant, z, at_.values, at_.signal_rates); };
    if (of.body != kGround) {
      const BodyKinematics& body = at_.kinematics.of(of.body);
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
          add_column(places, position ? pattern_.stiffness.data() : pattern_.lower.valuePtr(), j, kDifference);
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
      add_column(places, pattern_.lower.valuePtr(), j, step);
    }
    evaluate(given_instant);
  }
}

}  // namespace footfall
