#pragma once
// When a run writes checkpoints, and what it does there: at multiples of an interval, when it is
// interrupted, when a program that leads it requests one, and when the last one is too long ago on
// the wall clock.

#include <functional>
#include <limits>
#include <string>

#include "coupler/archive.h"
#include "mbd_solver/session/checkpoint.h"
#include "mbd_solver/session/loop/instructions.h"
#include "mbd_solver/session/loop/moving_mechanism.h"

namespace footfall {

// Writes the checkpoints of a run.
struct CheckpointWriter {
  // Creates the folder of the checkpoint after so many windows and returns its path; both sides
  // then write into it.
  std::function<std::string(long windows)> begin;
  std::function<void()> finish;  // writes the files of this side, when the DEM side's are complete
  std::function<void()> cancel;  // the DEM side could not write its own
  // Whether the last checkpoint is too long ago on the wall clock; empty: never. A checkpoint
  // written for this reason does not change the run; a run resumed from it agrees with the original
  // within its tolerances only.
  std::function<bool()> overdue;

  explicit operator bool() const { return begin != nullptr; }
};

class Checkpointer {
 public:
  // Both must outlive this.
  Checkpointer(MovingMechanism& moving, Instructions& instructions);

  void begin(const CheckpointWriter& writer) { writer_ = writer; }  // of the run that begins
  bool writes() const { return static_cast<bool>(writer_); }
  double next() const { return writes() ? clock_.next() : std::numeric_limits<double>::infinity(); }  // [s]
  bool is_due(double time) const { return clock_.is_due(time) || instructions_.checkpoint_requested(); }
  bool overdue() const { return writer_.overdue && writer_.overdue(); }
  // With grains: the one at the end of the window that begins, which its motion announces. due: it
  // is required there.
  CheckpointRequest announce(bool due) const;
  // undisturbed: the run continues as if there were none. Otherwise the integrator forgets what it
  // knows of earlier windows, so that this run and a resumed one continue alike. False when the DEM
  // side could not write its files.
  bool save(bool undisturbed);

  void visit(Archive& archive) { archive("next_checkpoint", clock_); }

 private:
  MovingMechanism& moving_;
  Instructions& instructions_;
  IntervalClock clock_;
  CheckpointWriter writer_;
};

}  // namespace footfall
