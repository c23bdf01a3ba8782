#pragma once
// Sampled signals, and the states of the scene with the events between them.
// A signal with a period is computed at its multiples, in the order in which signals read each other, and held between.
// An event puts the scene into its state when its condition holds: with a period at its multiples, without at any time.
// Simulation locates that instant to kEventTime between rows and samples (with grains: at the end of the window).

#include <array>
#include <vector>

#include "coupler/archive.h"
#include "mbd_solver/model/control/expression_parts.h"
#include "mbd_solver/session/observe/observation.h"

namespace footfall {

inline constexpr double kEventTime = 1e-10;  // [s]

class SignalLoop {
 public:
  // The parts of the subject must outlive the loop. sampled: the mechanism's sampled signals, moved here. Throws
  // InputError.
  SignalLoop(std::vector<SignalNode> sampled, const Subject& subject);

  double next_sample() const;  // of a signal or event with a period [s]; infinity without
  bool has_unsampled_events() const { return unsampled_events_; }  // events without a period

  // An event of the present state that is due and whose condition holds.
  struct Trigger {
    int event = -1;        // -1: none
    bool sampled = false;  // it has a period: its instant is the sample itself
  };
  Trigger triggered(const Sample& sample, const Eigen::VectorXd& values);
  // Between two samples at which no condition holds, an event without a period may hold if several of its comparisons
  // change. remember(): the first sample; changed(): comparisons that differ at another, of which may_have_held() asks.
  void remember(const Sample& sample, const Eigen::VectorXd& values);
  std::vector<std::size_t> changed(const Sample& sample, const Eigen::VectorXd& values);
  bool may_have_held(const Sample& sample, const Eigen::VectorXd& values);
  // Puts the scene into the event's state: sets the inputs of states; signals that become inactive are 0.
  void apply(int event, double time, Eigen::VectorXd& values);
  const std::string& event_name(int event) const;
  std::size_t state_count() const { return subject_.mechanism.states.size(); }

  // Computes the signals that are due at this time (within rounding) and writes their values.
  void sample_due(const Sample& sample, Eigen::VectorXd& values);

  void visit(Archive& archive);

 private:
  bool is_due(double time, double period, long samples) const {
    return time >= (static_cast<double>(samples) - 1e-6) * period;
  }

  // A condition as its comparisons make it; other parts may be true or false.
  struct Test {
    enum class Kind { kAnd, kOr, kNot, kCompare, kOther };
    Kind kind = Kind::kOther;
    std::size_t margin = 0;  // of a comparison: positive where it is true
    std::vector<Test> parts;
  };
  struct Condition {
    int event = 0;
    std::size_t first = 0, count = 0;  // of its margins
    Test test;
  };
  static Test test_of(const ExpressionPart& part, std::vector<std::string>& margins);
  static std::array<bool, 2> can_be(const Test& test, const std::vector<bool>& truth);  // false, true
  SignalChain margins_of_conditions();
  void compute_margins(const Sample& sample, const Eigen::VectorXd& values);
  bool in_state(const std::string& name, const Eigen::VectorXd& values) const;
  bool applies(const EventSpec& event, const Eigen::VectorXd& values) const;

  Subject subject_;
  SignalChain chain_, conditions_;  // conditions: one node per event
  Readings readings_, condition_readings_;
  std::vector<int> events_;         // per node of conditions_: index in the scene
  std::vector<std::size_t> order_;  // of evaluation: events without period first, each group in the order of the scene
  std::vector<long> samples_, condition_samples_;  // so far, per node of chain_ and of conditions_
  std::vector<bool> was_active_;                   // per node of chain_, at its last sample
  Eigen::VectorXd z_;                              // inner states of chain_
  bool unsampled_events_ = false;
  std::vector<Condition> compared_;        // of two comparisons or more
  SignalChain margins_;                    // one node per comparison
  std::vector<std::size_t> margin_names_;  // of its names among the names of conditions_
  std::vector<double> margin_, remembered_;
};

}  // namespace footfall
