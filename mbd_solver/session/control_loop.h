#pragma once
// Sampled control: at its period each controller measures the mechanism and sets inputs, constant until its next sample.

#include "coupler/archive.h"
#include "mbd_solver/session/observe/sampler.h"
#include "mbd_solver/session/signal_loop.h"

namespace footfall {

class ControlLoop {
 public:
  // The controllers of the subject's mechanism, and its sampled signals, which are moved here. Mechanism and subject must
  // outlive this. Throws InputError for a signal or event that reads an unknown name.
  ControlLoop(Mechanism& mechanism, const Subject& subject);

  // Samples every controller and signal that is due at this time (within rounding) and writes its inputs. inputs: those
  // that the sample views.
  void sample_due(const Sample& sample, Inputs& inputs);
  // Time of the next sample [s]; infinity without controllers.
  double next_sample() const;
  SignalLoop* signals() { return signals_.get(); }  // null without sampled signals and events
  const SignalLoop* signals() const { return signals_.get(); }

  void visit(Archive& archive);  // samples taken, and the state of every controller

 private:
  ControllerMeasurement measure(const ControllerEntry& entry, const Sample& sample) const;

  std::vector<ControllerEntry>& controllers_;
  Subject subject_;
  Eigen::Vector3d up_;         // unit vector against gravity, in W
  std::vector<long> samples_;  // taken so far, per controller
  std::unique_ptr<SignalLoop> signals_;
};

}  // namespace footfall
