// Continuous signals within the equations of motion: mbd_solver/model/signals/continuous_signals.h.

#include <cmath>

#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/dynamics/workspace.h"
#include "mbd_solver/model/control/continuous_signals.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

constexpr double kDifference = 1e-6;  // [m, rad, m/s, rad/s, -]: for Newton's matrix alone

struct Answer {
  Eigen::VectorXd values, rates;
};

// The kinematics with one body changed.
struct Changed {
  const Kinematics& base;
  const BodyKinematics& was;
  BodyKinematics now;
  const BodyKinematics* of(int body) const { return &base.of(body) == &was ? &now : &base.of(body); }
  PairMotion pair(int body_1, int body_2) const { return {{of(body_1), of(body_2)}}; }
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
  const ContinuousSignals* signals = model_.signals();
  if (!signals) return inputs.values;
  Workspace& w = *work_;
  w.values = inputs.values;
  signals->evaluate(t, w.kinematics, y.segment(layout_.z0() + layout_.signal_z, w.signal_rates.size()), w.values,
                    w.signal_rates);
  return w.values;
}

void Equations::signals(const State& state, const Inputs& inputs, Eigen::VectorXd& out) {
  out = inputs.values;
  if (!model_.signals()) return;
  Workspace& w = *work_;
  load(state);
  model_.signals()->evaluate(state.time, w.kinematics, state.z.tail(w.signal_rates.size()), out, w.signal_rates);
}

void Equations::settle_signals(const Eigen::VectorXd* before, const Inputs& inputs, State& state) {
  if (!model_.signals()) return;
  Workspace& w = *work_;
  load(state);
  w.values = inputs.values;
  model_.signals()->settle(state.time, w.kinematics, before, state.z.tail(w.signal_rates.size()), w.values);
}

// By central differences of the signals, which are few: of each coordinate and velocity of the bodies that they measure,
// and of each of their states. F_z takes minus the rates, F_v minus the forces.
void Equations::add_signal_derivatives(double t, const Eigen::Ref<const Eigen::VectorXd>& y, const Inputs& inputs) {
  Workspace& w = *work_;
  const SignalPlaces& places = w.signal_places;
  const Eigen::Index states = w.signal_rates.size();
  Answer plus{inputs.values, w.signal_rates}, minus = plus;
  Eigen::VectorXd z = y.segment(layout_.z0() + layout_.signal_z, states);

  // The column of one change: `by_states` of the signals, else of measured body b; into these values.
  const auto add_column = [&](double* values, int column, bool by_states, std::size_t b, double step) {
    if (states > 0) {
      const Eigen::VectorXd rates = (minus.rates - plus.rates) / (2.0 * step);
      (by_states ? places.states_states : places.states_v[b]).add_column(values, column, rates);
    }
    if (plus.values == minus.values) return;
    for (const SignalPlaces::Driven& driven : places.driven) {
      const ForceElement& element = model_.force(driven.force);
      const PairMotion pair = w.force_pair(element);
      const int m = element.state_count();
      const auto z_of = y.segment(layout_.z0() + layout_.force_z[static_cast<std::size_t>(driven.force)], m);
      Eigen::VectorXd Q[2], dz[2];
      for (const int side : {0, 1}) {
        Q[side] = Eigen::VectorXd::Zero(pair.size());
        dz[side] = Eigen::VectorXd::Zero(m);
        element.add_force({pair, z_of, side == 0 ? plus.values : minus.values, t}, Q[side], dz[side]);
      }
      const Eigen::VectorXd dQ = (Q[1] - Q[0]) / (2.0 * step), ddz = (dz[1] - dz[0]) / (2.0 * step);
      for (int i = 0; i < 2; ++i) {
        const int n = pair.body[i]->size();
        const SparseBlock& block = by_states ? driven.v_states[i] : driven.v_v[i][b];
        if (n > 0) block.add_column(values, column, dQ.segment(pair.offset(i), n));
      }
      if (m > 0) (by_states ? driven.z_states : driven.z_v[b]).add_column(values, column, ddz);
    }
  };

  const auto evaluate = [&](const auto& kinematics, Answer& answer) {
    answer.values = inputs.values;
    model_.signals()->evaluate(t, kinematics, z, answer.values, answer.rates);
  };
  for (std::size_t b = 0; b < places.measured.size(); ++b) {
    const int body = places.measured[b], n = w.kinematics.of(body).size();
    for (const bool position : {true, false}) {
      for (int j = 0; j < n; ++j) {
        Changed changed{w.kinematics, w.kinematics.of(body), w.kinematics.of(body)};
        move(changed.now, position, j, kDifference);
        evaluate(changed, plus);
        changed.now = changed.was;
        move(changed.now, position, j, -kDifference);
        evaluate(changed, minus);
        add_column(position ? w.stiffness.data() : w.lower.valuePtr(), j, false, b, kDifference);
      }
    }
  }
  for (Eigen::Index j = 0; j < states; ++j) {
    const double before = z[j], step = kDifference * (1.0 + std::abs(before));
    z[j] = before + step;
    evaluate(w.kinematics, plus);
    z[j] = before - step;
    evaluate(w.kinematics, minus);
    z[j] = before;
    add_column(w.lower.valuePtr(), static_cast<int>(j), true, 0, step);
  }
}

}  // namespace footfall
