#pragma once
// The inputs that controllers, sampled signals and states of the scene set, and whether their last
// sample changed one.

#include <memory>
#include <string>
#include <vector>

#include "coupler/archive.h"
#include "mbd_solver/session/loop/moving_mechanism.h"
#include "mbd_solver/session/observe/sampler.h"
#include "mbd_solver/session/signal_loop.h"
#include "mbd_solver/session/stiff_signals.h"

namespace footfall {

// Sampled control: at its period each controller measures the mechanism and sets inputs, constant until its next sample.
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

  void visit(Archive& archive);  // samples taken, and the state of every controller

 private:
  ControllerMeasurement measure(const ControllerEntry& entry, const Sample& sample) const;

  std::vector<ControllerEntry>& controllers_;
  Subject subject_;
  Eigen::Vector3d up_;         // unit vector against gravity, in W
  std::vector<long> samples_;  // taken so far, per controller
  std::unique_ptr<SignalLoop> signals_;
};

class SampledInputs {
 public:
  // Takes over the sampled signals of the mechanism, which must outlive this. Throws InputError.
  explicit SampledInputs(MovingMechanism& moving);
  // The inputs of the start; throws InputError.
  void begin();

  double next_sample() const { return control_.next_sample(); }  // [s]; infinity: nothing is sampled
  void sample_due();                                             // reads the present sample
  // The first sample of a run: its first row has what acts from the start on. A program that leads
  // the run sets its signals after that row, and a signal that jumps at the start is read behind
  // its jump.
  void sample_at_start();
  bool change() const { return change_; }               // the last sample changed an input
  SignalLoop* signals() { return control_.signals(); }  // null without sampled signals and events
  ControlLoop& control() { return control_; }
  std::vector<std::string> warnings() const;  // about signals of other programs, as far as the run has come

  void visit(Archive& archive) { archive("inputs_change", change_); }  // control() has a visit of its own

 private:
  MovingMechanism& moving_;
  ControlLoop control_;
  std::unique_ptr<StiffSignals> stiff_signals_;  // null where no other program computes a signal from inputs
  bool change_ = true;
};

}  // namespace footfall
