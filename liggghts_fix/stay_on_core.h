#pragma once
// Keeps a rank of LIGGGHTS on its core while it waits for the mechanism.
//
// While the ranks wait, mbd_solver computes on one of their cores. A rank that is woken then finds its own core taken
// and is put on another, whose caches hold the grains of another rank: on two cores that made the grains 15 % slower.
// So a rank lets itself be moved only while it works, when the machine may have reasons to move it, and not while it
// sleeps.

#include <sched.h>

namespace footfall {

class StayOnCore {
 public:
  StayOnCore();
  ~StayOnCore();  // free again, as it was before
  StayOnCore(const StayOnCore&) = delete;
  StayOnCore& operator=(const StayOnCore&) = delete;

 private:
  cpu_set_t allowed_;
  bool pinned_ = false;  // false where the machine does not let itself be asked: nothing is changed
};

}  // namespace footfall
