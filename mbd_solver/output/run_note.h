#pragma once
// run.json: what a run says about itself at its beginning, for those who look at it while it goes on.

#include <string>

namespace footfall {

struct RunNote {
  std::string title, scene_file;  // the file with its full path
  double end_time = 0.0;          // where this run will end [s]
};

// In the folder of the run. Both throw InputError for a file that cannot be written, or read.
void write_run_note(const std::string& folder, const RunNote& note);
RunNote read_run_note(const std::string& folder);

inline constexpr const char* kRunNote = "run.json";

}  // namespace footfall
