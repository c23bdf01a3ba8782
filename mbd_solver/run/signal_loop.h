#pragma once
// Sampled signals, and the states of the scene with the events that lead from one to another.
// A signal with a period is computed at its multiples, in the order in which signals read each other, and held between.
// An event takes the scene to its state when its condition holds: with a period at its multiples, without at any time;
// Simulation finds that instant to kEventTime between rows and samples (with grains: at the end of the window).

#include <memory>
#include <vector>

#include "coupler/archive.h"
#include "mbd_solver/run/observe/observation.h"

namespace footfall {

inline constexpr double kEventTime = 1e-10;  // [s]

class SignalLoop {
 public:
  // The parts of the subject must outlive the loop; its mechanism's sampled signals are taken. Throws InputError.
  SignalLoop(std::vector<SignalNode> sampled, const Subject& subject);

  double next_sample() const;                // of a signal or event with a period [s]; infinity without
  bool watches() const { return watches_; }  // some events have no period

  // An event of the present state whose condition holds, and that is due; -1: none.
  struct Held {
    int event = -1;
    bool sampled = false;  // it has a period: it happens at the sample itself
  };
  Held held(const Sample& sample, const Eigen::VectorXd& values);
  // Goes to the event's state: it is among the inputs, and signals that stop are 0.
  void happen(int event, double time, Eigen::VectorXd& values);
  const std::string& event_name(int event) const;
  std::size_t state_count() const { return subject_.mechanism.states.size(); }

  // Computes the signals that are due at this time (within rounding), and writes their values.
  void sample_due(const Sample& sample, Eigen::VectorXd& values);

  void visit(Archive& archive);

 private:
  bool due(double time, double period, long samples) const {
    return time >= (static_cast<double>(samples) - 1e-6) * period;
  }

  Subject subject_;
  SignalChain chain_, conditions_;  // conditions: one node per event
  Readings readings_, of_conditions_;
  std::vector<int> events_;            // per node of conditions_: index in the scene
  std::vector<std::size_t> order_;     // of looking: first what has no period, each as the scene lists them
  std::vector<long> samples_, looks_;  // so far, per node of chain_ and of conditions_
  std::vector<bool> was_active_;           // per node of chain_, at its last sample
  Eigen::VectorXd z_;                  // inner states of chain_
  bool watches_ = false;
};

}  // namespace footfall
