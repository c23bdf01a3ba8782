#pragma once
// The continuous signals of a model: evaluated with its equations, at every stage of a step; their inner states are
// integrated with those of the mechanism.

#include <memory>
#include <vector>

#include "mbd_solver/model/signals/sensor.h"
#include "mbd_solver/model/signals/signal_chain.h"

namespace footfall {

// Where a name's value comes from.
struct SignalSource {
  enum class Kind {
    kTime,
    kPlace,  // voltages[index]: controllers, sampled signals, states of the scene
    kSince,  // time - voltages[index]: seconds in the present state of the scene
    kSensor  // sensors[index]
  };
  Kind kind = Kind::kTime;
  std::size_t index = 0;
};

class ContinuousSignals {
 public:
  // sources: one per name of the chain.
  ContinuousSignals(SignalChain chain, std::vector<SignalSource> sources, std::vector<std::unique_ptr<Sensor>> sensors);

  int state_count() const { return chain_.state_count() + sensor_states_; }
  const SignalChain& chain() const { return chain_; }
  std::vector<int> bodies() const;  // whose motion is measured, in rising order

  // Values into their places among `voltages`, where those of others stand already, and rates of the states. kinematics:
  // has pair(body_1, body_2). Throws NumericalError. No allocation.
  template <class Kinematics>
  void evaluate(double t, const Kinematics& kinematics, const Eigen::Ref<const Eigen::VectorXd>& z,
                Eigen::Ref<Eigen::VectorXd> voltages, Eigen::Ref<Eigen::VectorXd> dz) const {
    measure(kinematics, z, dz);
    run(t, z, voltages, dz);
  }
  // The states of every signal (before null), or of those that did not work under the voltages and signals `before`.
  // Throws NumericalError; at the start, with before null, InputError.
  template <class Kinematics>
  void settle(double t, const Kinematics& kinematics, const Eigen::VectorXd* before, Eigen::Ref<Eigen::VectorXd> z,
              Eigen::Ref<Eigen::VectorXd> voltages) const {
    measure(kinematics, z, scratch_);
    start(t, before, z, voltages);
  }

 private:
  template <class Kinematics>
  void measure(const Kinematics& kinematics, const Eigen::Ref<const Eigen::VectorXd>& z,
               Eigen::Ref<Eigen::VectorXd> dz) const {
    Eigen::Index state = chain_.state_count();
    for (std::size_t i = 0; i < sensors_.size(); ++i) {
      const std::array<int, 2> bodies = sensors_[i]->bodies();
      const PairMotion pair = kinematics.pair(bodies[0], bodies[1]);
      const bool has_state = sensors_[i]->has_state();
      measured_[static_cast<Eigen::Index>(i)] = sensors_[i]->value(pair, has_state ? z[state] : 0.0);
      if (!has_state) continue;
      dz[state] = sensors_[i]->rate_of_state(pair, z[state]);
      ++state;
    }
  }
  double answer(std::size_t k, const Eigen::Ref<const Eigen::VectorXd>& states) const;  // value of node k
  void set_names(double t, const Eigen::Ref<const Eigen::VectorXd>& voltages) const;
  void run(double t, const Eigen::Ref<const Eigen::VectorXd>& z, Eigen::Ref<Eigen::VectorXd> voltages,
           Eigen::Ref<Eigen::VectorXd> dz) const;
  void start(double t, const Eigen::VectorXd* before, Eigen::Ref<Eigen::VectorXd> z,
             Eigen::Ref<Eigen::VectorXd> voltages) const;

  SignalChain chain_;
  std::vector<SignalSource> sources_;
  std::vector<std::unique_ptr<Sensor>> sensors_;
  int sensor_states_ = 0;
  mutable Eigen::VectorXd measured_, scratch_;
};

}  // namespace footfall
