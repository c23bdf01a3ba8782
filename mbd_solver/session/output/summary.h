#pragma once
// JSON files of a run: summary.json, run.json, and start.json of each checkpoint.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace footfall {

// Exit code of `footfall run` for a run that is done, but misses a requirement of its scene, or could not compute one.
inline constexpr int kExitRequirements = 4;

// "GCC 12.2.0", of the compiler of this program.
std::string compiler_version();
// Processor, cores, system, as far as known. No names of the machine or its user.
nlohmann::ordered_json machine();

// run.json: written when a run begins, for commands that read the run while it is running.
struct RunNote {
  std::string title, scene_file;  // the file with its full path
  double end_time = 0.0;          // of this run [s]
};

// In the folder of the run. Both throw InputError for a file that cannot be written or read.
void write_run_note(const std::string& folder, const RunNote& note);
RunNote read_run_note(const std::string& folder);

inline constexpr const char* kRunNote = "run.json";

// start.json of a checkpoint: arguments of the run, to start it again.
struct RunStart {
  std::string scene_file;             // absolute path
  std::vector<std::string> settings;  // --set key=value
  double until = 0.0;                 // [s]; 0: the scene's end
  int ranks = 0;                      // of LIGGGHTS; 0 without grains
  std::string scene;                  // with all defaults, as JSON: must be equal when the run is resumed
};

// Layout of checkpoints: raised whenever what a run stores changes.
inline constexpr int kCheckpointFormat = 6;

// folder: of the checkpoint. Both throw InputError for a file that cannot be written or read, or that another version of
// footfall or of the layout wrote.
void write_run_start(const std::string& folder, const RunStart& start);
RunStart read_run_start(const std::string& folder);

// summary.json: metrics of a run, complete or absent (files.h).
// Throws NumericalError, naming the key, when a number is not finite; InputError when the file cannot be written.
void write_summary(const std::string& path, const nlohmann::ordered_json& summary);

// Key of a run that has failed before its first step.
inline constexpr const char* kFailedAtStart = "failed_at_start";
// The end of a run that could not summarize itself: status and reason, in its summary so far or in a new one, which is that of a
// failed start. Leaves a summary with this status and a reason. Throws InputError when it cannot be read or written.
void note_end_of_run(const std::string& folder, const std::string& status, const std::string& reason);
// "failed at the start: REASON", "interrupted: REASON", "done". May throw nlohmann::json::exception.
std::string end_text(const nlohmann::ordered_json& summary);

[[noreturn]] void throw_incomplete_summary(const std::string& folder, const std::string& what);

// Throws InputError when the file does not exist or contains no object.
nlohmann::ordered_json read_summary(const std::string& path);

// Calls `action`, which reads the summary; a missing or wrong value becomes an InputError that names it.
template <class Action>
auto with_summary_of(const std::string& folder, const Action& action) {
  try {
    return action();
  } catch (const nlohmann::json::exception& error) {
    throw_incomplete_summary(folder, error.what());
  }
}

// What mbd_solver adds to run.json once it has begun, for pages of a run in progress.
struct LiveNote {
  double dt_dem = 0.0;           // DEM time step [s]; 0: not known yet, or no grains
  nlohmann::ordered_json scene;  // with all defaults, as in summary.json; null: not known yet
};

// In the folder of the run, next to what write_run_note (summary.h) has written. Throw InputError as it does.
void add_live_note(const std::string& folder, const LiveNote& note);
LiveNote read_live_note(const std::string& folder);

}  // namespace footfall
