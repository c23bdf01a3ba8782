#pragma once
// The sample: everything that history, pictures, summary, progress and controllers read at one instant of a run.

#include <vector>

#include "coupler/body_motion.h"
#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/coupling/coupling_sample.h"
#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/dynamics/kinematics.h"

namespace footfall {

// What is observed: constant during a run. A view; the run owns everything.
struct Subject {
  const Scene& scene;
  const Mechanism& mechanism;
  const Layout& layout;                  // of the state
  const Agreement* agreement = nullptr;  // null without grains
};

// At the start, and at the end of every window. Views of data of the run: valid until it continues.
struct Sample {
  const State& state;
  const Inputs& inputs;           // of the window that ends here
  const Eigen::VectorXd& values;  // of the inputs, with the continuous signals now
  const Eigen::VectorXd& rates;   // [dq; dv; dz; lambda]
  const Kinematics& kinematics;   // of all bodies, with accelerations
  const EnergySample& energy;
  // load of the ground on each body, F_W and T_W about Bo: mean of the grains over the window, or of the plane now
  const std::vector<GeneralizedForce>& contact;
  ElementScratches& scratch;                 // of the equations, which have evaluated the elements at this state
  long window = 0;                           // windows completed
  bool last = false;                         // the end time has been reached
  const CouplingSample* coupling = nullptr;  // null without grains
};

// The input of force element `force` of the model at this instant.
inline ElementInput element_input(const Subject& subject, const Sample& sample, int force) {
  const ForceElement& element = subject.mechanism.model.force(force);
  const int z = subject.layout.force_z[force];
  return element_input(element, sample.kinematics, sample.state.z.segment(z, element.state_count()), sample.values,
                       sample.state.time, sample.scratch.of(force));
}

// What a strut, cable or drive reports at this instant.
template <class T>
auto sample_of(Handle<T> element, const Subject& subject, const Sample& sample) {
  return element.of(subject.mechanism.model).sample(element_input(subject, sample, element.index()));
}

// Computes a Sample from the state: kinematics, energies and ground contact, each once.
class Sampler {
 public:
  // Data of the run, all of which must outlive the sampler; rates: [dq; dv; dz; lambda].
  Sampler(const Subject& subject, Equations& equations, const State& state, const Eigen::VectorXd& rates,
          const Inputs& inputs);
  Sampler(const Sampler&) = delete;
  Sampler& operator=(const Sampler&) = delete;

  // Computes the sample of the present state. coupling: null without grains.
  void update(long window, bool last, const CouplingSample* coupling);
  const Sample& sample() const { return sample_; }  // of the last update()

 private:
  void update_contact();

  Subject subject_;
  Equations& equations_;
  Kinematics kinematics_;
  Eigen::VectorXd values_;
  EnergySample energy_;            // with gravity's from the height of the ground (Placement::ground_height)
  double ground_potential_ = 0.0;  // energy of the whole mass at that height [J]
  std::vector<GeneralizedForce> contact_;
  Eigen::VectorXd y_;  // [q; v; z; lambda]
  Sample sample_;      // views the members above
};

}  // namespace footfall
