#pragma once
// With grains: the time of an event without a period in the window that comes, as far as it can be
// foreseen. The grains move before their load is known, so an event cannot cut the window in which
// it happens. A second integrator continues under the mean loads of the last window instead, to see
// where the window that comes must end; conditions read loads and accelerations as they follow from
// the last two windows. Another event takes effect at the end of its window.

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "coupler/archive.h"
#include "mbd_solver/session/loop/moving_mechanism.h"
#include "mbd_solver/session/signal_loop.h"

namespace footfall {

class EventForesight {
 public:
  // signals: null without events. Both must outlive this.
  EventForesight(MovingMechanism& moving, SignalLoop* signals) : moving_(moving), signals_(signals) {}

  // Time of the event [s]; infinity: none until `before` [s]. Before a window begins.
  double find(double before);
  void begin_window();
  void end_window();  // its sample is up to date
  // An event without a period changes the rates by this at the end of a window [as rates].
  void tell_of_late_event(const std::string& event, const Eigen::VectorXd& change);

  void visit(Archive& archive);

 private:
  bool is_needed() const;
  void extrapolate_loads(double time);  // inputs().loads, from the means over the last two windows [s]
  double find_under_present_loads(double end, double precision);  // both [s]

  static constexpr double kNever = std::numeric_limits<double>::infinity();
  MovingMechanism& moving_;
  SignalLoop* signals_;
  std::unique_ptr<Equations> equations_;    // null until an event must be foreseen
  std::unique_ptr<Integrator> integrator_;  // likewise
  double foreseen_ = kNever;                // in this window [s]
  // Loads of the window before the last, and the lengths of both windows [s].
  std::vector<ExternalLoad> loads_before_;
  double last_length_ = 0.0, length_before_ = 0.0;
  double largest_kinetic_ = 0.0;  // since the start [J]
};

}  // namespace footfall
