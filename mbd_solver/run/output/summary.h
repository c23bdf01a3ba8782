#pragma once
// What a run was computed with and on, for its summary.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace footfall {

// "GCC 12.2.0", of the compiler of this program.
std::string compiler_version();
// processor, cores, system; what the machine does not tell is left out. No name of the machine or of its user.
nlohmann::ordered_json machine();

// run.json: what a run says about itself at its beginning, for those who look at it while it goes on.

struct RunNote {
  std::string title, scene_file;  // the file with its full path
  double end_time = 0.0;          // where this run will end [s]
};

// In the folder of the run. Both throw InputError for a file that cannot be written, or read.
void write_run_note(const std::string& folder, const RunNote& note);
RunNote read_run_note(const std::string& folder);

inline constexpr const char* kRunNote = "run.json";

// What a run was started with, as it stands in each of its checkpoints (start.json): enough to start it again.

struct RunStart {
  std::string scene_file;             // absolute path
  std::vector<std::string> settings;  // --set key=value
  double until = 0.0;                 // [s]; 0: the scene's end
  int ranks = 0;                      // of LIGGGHTS; 0 without grains
  std::string scene;                  // with all defaults, as JSON: that of a resumed run must be the same
};

// `folder`: of the checkpoint. Both throw InputError for a file that cannot be written or read, or that another version
// wrote.
void write_run_start(const std::string& folder, const RunStart& start);
RunStart read_run_start(const std::string& folder);

// summary.json: the figures of a run, whole or not there (whole_file.h).

// Throws NumericalError, naming the key, when a number is not finite; InputError when the file cannot be written.
void write_summary(const std::string& path, const nlohmann::ordered_json& summary);

[[noreturn]] void throw_incomplete_summary(const std::string& folder, const std::string& what);

// Throws InputError when there is no such file, or it holds something else than an object.
nlohmann::ordered_json read_summary(const std::string& path);

// Does what needs the summary; one that lacks something, or holds something else there, is an InputError that names it.
template <class Action>
auto with_summary_of(const std::string& folder, const Action& action) {
  try {
    return action();
  } catch (const nlohmann::json::exception& error) {
    throw_incomplete_summary(folder, error.what());
  }
}

}  // namespace footfall
