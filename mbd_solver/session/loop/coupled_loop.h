#pragma once
// The loop of a run with grains: every window is one exchange. The present sample is observed, and
// control computed, after the motion has been sent, while the grains move.

#include "mbd_solver/session/loop/advance.h"
#include "mbd_solver/session/loop/run_loop.h"

namespace footfall {

class CoupledLoop : private RunLoop {
 public:
  // The mechanism is coupled. observe: at the start and after every window.
  CoupledLoop(RunParts& run, const std::function<void(const Sample&)>& observe,
              const volatile std::sig_atomic_t& interrupted)
      : RunLoop(run, interrupted), observe_(observe), advance_(run.moving), coupled_(*run.moving.coupled()) {}
  void run();

 private:
  bool run_window();                             // false: the script has ended, as it may
  void sample_before_window();                   // what is due now, and ended the last window for this reason
  double exchange(double corner);                // until the first corner after now [s]; returns the window's end [s]
  CheckpointRequest checkpoint_at(double time);  // [s]
  void observe_once();                           // the present sample, unless it has been observed
  bool end_requested() const { return interrupted() || coupled_.end_requested(); }
  void advance(double end);  // [s], with rows and steps on the way

  const std::function<void(const Sample&)>& observe_;
  Advance advance_;
  CoupledRun& coupled_;
  bool observed_ = true;  // the present sample
};

}  // namespace footfall
