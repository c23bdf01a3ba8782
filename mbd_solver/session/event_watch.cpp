// The rate of events over the last kWatched ones.
#include "mbd_solver/session/event_watch.h"

#include <set>
#include <vector>

#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "mbd_solver/session/codes.h"

namespace footfall {

void EventWatch::count(const std::string& event, double time, double t_end) {
  if (count_ == 0) since_ = time;
  names_[count_] = event;
  if (++count_ < kWatched) return;
  count_ = 0;
  const double interval = (time - since_) / (kWatched - 1);  // [s]
  if (interval > kShortest || t_end - time < kMostEvents * interval) return;
  std::vector<std::string> names;
  for (const std::string& name : std::set<std::string>(names_.begin(), names_.end()))
    names.push_back("\"" + name + "\"");
  throw NumericalError(code::kEventChatter,
                       "t = " + plain_text(time) + " s: the events " + joined(names) + " alternate without end, " +
                           std::to_string(kWatched) + " times within " + number_text(time - since_, 2) +
                           " s. Give their conditions a hysteresis, such as \"b.vx < -0.01\" and \"b.vx > 0.01\", or "
                           "one of them a period, such as period_ms = 1");
}

}  // namespace footfall
