#pragma once
// footfall view --follow: the progress of a run, in another terminal and as a page in 3D (live/live_page.h).

#include <string>

#include "mbd_solver/app/live/history_tail.h"
#include "mbd_solver/app/live/live_page.h"

namespace footfall {

struct FollowArguments {
  std::string run;        // folder of a run, or of a sweep: of that the newest run in progress
  bool once = false;      // print the progress once
  double interval = 1.0;  // between two updates [s]
};

// Follows the run to its end. Returns the run's exit code; with `once` 0 for a run in progress; 3 when this program is
// interrupted. Throws InputError for a folder without a run.
int follow_run(const FollowArguments& arguments);

struct RunProgress {
  enum class State { kSettingUp, kRunning, kDone, kFailed, kInterrupted, kGone };
  State state = State::kSettingUp;
  std::string reason;                 // of a failure, else empty
  bool at_start = false;              // it has failed before its first step
  std::string preparation;            // what LIGGGHTS does before the first row
  double time = 0.0, end_time = 0.0;  // of the last row, of the run [s]; end_time 0: not known
  long rows = 0;
  double contact_force = 0.0;  // on the body with the largest one, in the last row [N]
};
// Of the run in this folder, in progress or ended. Reads only what its history has got since the last call. Throws InputError for
// a folder without a run.
RunProgress progress_of_run(const std::string& run, HistoryTail& history);

// The page of the run that this program has started (run --view).
class FollowedRun {
 public:
  // Serves the page, opens a browser where there is a screen, and prints the address. Throws InputError.
  explicit FollowedRun(const std::string& run);
  // About every second, while the run proceeds.
  void tell();
  // The programs of the run have ended: the page gets the last frames and how it ended.
  void finish();

 private:
  std::string run_;
  HistoryTail history_;
  LivePage page_;
  double began_, next_;  // wall clock [s]
};

}  // namespace footfall
