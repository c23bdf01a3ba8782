#pragma once
// footfall view --follow: the progress of a run, from another terminal or as a page that reloads itself.

#include <string>
#include <vector>

namespace footfall {

struct FollowArguments {
  std::string run;        // folder of a run
  bool page = false;      // also write DIR/watch.html
  bool once = false;      // print the progress once
  double interval = 1.0;  // between two updates [s]
};

// Follows the run to its end. Returns the run's exit code; with `once` 0 for a run in progress; 3 when this program is
// interrupted. Throws InputError for a folder without a run.
int follow_run(const FollowArguments& arguments);

struct RunProgress {
  enum class State { kSettingUp, kRunning, kDone, kFailed, kInterrupted, kGone };
  State state = State::kSettingUp;
  std::string title;                  // of the scene; empty: not known yet
  std::string reason;                 // of a failure, else empty
  std::string preparation;            // what LIGGGHTS does before the first row
  double time = 0.0, end_time = 0.0;  // of the last row, of the run [s]; end_time 0: not known
  long rows = 0;
  double contact_force = 0.0;  // on the body with the largest one, in the last row [N]
};
// Of the run in this folder, in progress or ended. Throws InputError for a folder without a run.
RunProgress progress_of_run(const std::string& run);

// Names and last complete row of a history.csv, which may be in writing; empty without a row.
struct LastRow {
  std::vector<std::string> names;
  std::vector<double> values;
  long rows = 0;
};
LastRow last_row(const std::string& history);

}  // namespace footfall
