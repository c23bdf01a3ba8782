#pragma once
// Numbers of grains, kept by every rank for its own grains and added over all ranks at the end of a
// window: how many there are, those that were lost, changed otherwise than by forces, and the first
// that no body can stop.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "coupler/archive.h"
#include "coupler/messages.h"

namespace footfall {

// A grain that a body cannot stop, so that the run must end.
struct GrainFault {
  enum Kind { kNone, kTooFast, kPassed };
  Kind kind = kNone;
  double time = 0.0;    // [s]
  int tag = 0;          // of the grain
  int body = 0;         // index in the link
  double speed = 0.0;   // relative to the body [m/s]
  double radius = 0.0;  // of the grain [m]
};

class GrainBooks {
 public:
  void set_max_lost(double share) { max_lost_ = share; }  // of all grains [-]; the run stops when more are lost
  void expect_outflow() { outflow_ = true; }              // grains may leave the box, however many

  // Grains have changed ranks: numbers of this rank before and after. Their difference, summed over
  // the ranks, is lost.
  void exchanged(std::int64_t before, std::int64_t now) { lost_here_ += static_cast<double>(before - now); }
  // Grains of this rank have changed otherwise than by forces. Energies count once the first run is
  // set up.
  void changed(const GrainChanges& more);
  void count_changes() { counts_changes_ = true; }
  bool counts_changes() const { return counts_changes_ && !closed_; }
  // Until the end of the last window, of all ranks; since then, of this rank.
  const GrainChanges& changes() const { return changes_; }
  const GrainChanges& changes_here() const { return here_; }
  // A fault of a grain of this rank; the first fault since the last row counts.
  void fault(const GrainFault& fault) {
    if (fault_.kind == GrainFault::kNone) fault_ = fault;
  }

  void begin();                     // the coupling begins: nothing counts that was before
  void close() { closed_ = true; }  // the last window is done
  // Appends the numbers of this rank since the last row, of `grains` present ones.
  static std::size_t row_size();
  void append_share(std::int64_t grains, std::vector<double>& row);
  // Adds the numbers of a rank, in a window whose bodies have these names, until now [s], with time
  // steps of dt [s]. Throws NumericalError for its fault.
  void add_share(const double* row, const std::vector<std::string>& bodies, double dt);
  // After the books of all ranks: writes the totals into the load, with a warning at the first grain
  // that is lost. Throws NumericalError when more are lost than allowed.
  void finish_window(double time, Load& load);

  void visit(Archive& archive);

 private:
  double max_lost_ = 1.0;  // of all grains [-]
  bool outflow_ = false;
  // On this rank since the last row.
  double lost_here_ = 0.0;  // grains sent to other ranks minus received
  GrainChanges here_;
  GrainFault fault_;
  bool counts_changes_ = false;
  bool closed_ = false;
  // Sums over all ranks: in this window, and since the start.
  double grains_now_ = 0.0, lost_now_ = 0.0;
  std::int64_t lost_ = 0;
  GrainChanges changes_;
};

}  // namespace footfall
