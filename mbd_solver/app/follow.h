#pragma once
// footfall watch: a run that is under way, seen from another terminal, or as a page that refreshes itself.

#include <string>
#include <utility>
#include <vector>

namespace footfall {

struct WatchArguments {
  std::string run;        // folder of a run
  bool page = false;      // RUN/watch.html as well
  bool once = false;      // one look
  double interval = 1.0;  // between two looks [s]
};

// Follows the run to its end, or says once where it is. Returns the run's exit code; 0 for a look at a run that goes on;
// 3 when it is asked to end itself. Throws InputError for a folder that no run has.
int watch_run(const WatchArguments& arguments);

// One look at the folder of a run, whatever it is at.
struct RunLook {
  enum class State { kSettingUp, kRunning, kDone, kFailed, kInterrupted, kGone };
  State state = State::kSettingUp;
  std::string title;                  // of the scene; empty: not known yet
  std::string reason;                 // of a failure, else empty
  std::string preparation;            // what LIGGGHTS is at before the first row
  double time = 0.0, end_time = 0.0;  // of the last row, of the run [s]; end_time 0: not known
  long rows = 0;
  double contact_force = 0.0;  // on the body with most of it, in the last row [N]
};
RunLook look_at_run(const std::string& run);

// The names of history.csv and the numbers of its last whole row: it may be in writing. Empty without one.
struct LastRow {
  std::vector<std::string> names;
  std::vector<double> values;
  long rows = 0;
};
LastRow last_row(const std::string& history);

}  // namespace footfall
