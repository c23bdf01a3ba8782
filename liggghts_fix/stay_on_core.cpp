#include "liggghts_fix/stay_on_core.h"

namespace footfall {

StayOnCore::StayOnCore() {
  const int core = sched_getcpu();
  if (core < 0 || core >= CPU_SETSIZE || sched_getaffinity(0, sizeof allowed_, &allowed_) != 0) return;
  cpu_set_t here;
  CPU_ZERO(&here);
  CPU_SET(core, &here);
  pinned_ = sched_setaffinity(0, sizeof here, &here) == 0;
}

StayOnCore::~StayOnCore() {
  if (pinned_) sched_setaffinity(0, sizeof allowed_, &allowed_);
}

}  // namespace footfall
