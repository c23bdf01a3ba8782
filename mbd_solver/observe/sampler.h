#pragma once
// From a state to a Sample: kinematics, energies and ground contact, each computed once.

#include "mbd_solver/observe/sample.h"

namespace footfall {

class Sampler {
 public:
  // The run's own, all of which must outlive the sampler; rates: [dq; dv; dz; lambda].
  Sampler(const Subject& subject, Equations& equations, const State& state, const Eigen::VectorXd& rates,
          const Inputs& inputs);
  Sampler(const Sampler&) = delete;
  Sampler& operator=(const Sampler&) = delete;

  // Computes the sample of the present state. coupling: null without grains.
  void take(long window, bool last, const CouplingSample* coupling);
  const Sample& sample() const { return sample_; }  // after take()

 private:
  void update_contact();

  Subject subject_;
  Equations& equations_;
  Kinematics kinematics_;
  Eigen::VectorXd voltages_;
  EnergySample energy_;
  std::vector<GeneralizedForce> contact_;
  Eigen::VectorXd y_;  // [q; v; z; lambda]
  Sample sample_;      // views what stands above
};

}  // namespace footfall
