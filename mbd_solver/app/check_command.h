#pragma once
// footfall check, and the check that starts every run.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mbd_solver/app/run_command.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// Reads the scene and builds its mechanism once, so that everything a run would refuse (meshes, bases, controllers) is
// found now.
// Warnings go to standard error. Throws InputError.
Scene checked_scene(const std::string& argument, const std::vector<std::string>& settings);

// Prints what the scene holds. Returns the exit code. Throws InputError with every finding.
int check_command(const std::string& argument, const std::vector<std::string>& settings);

// How long a whole run takes, from what a trial of it (run/trial.h) told.

struct RunTime {
  double seconds = 0.0;            // of the whole run, on the wall [s]
  double least = 0.0, most = 0.0;  // [s]
  double share_of_grains = 0.0;    // of LIGGGHTS' work in it [0 ... 1]
};

// With marks 0, 1, 2 of the trial (its start, middle and end), rates of the second half, and R = t_end - t_2 to come:
//   T = t_wall,2 + R (grains + mechanism),   grains = (dem_2 - dem_1) / (t_2 - t_1)
// Grains take the same time in every substep, but for those that neighbour lists cost at an impact. A mechanism that has
// just touched hard takes short steps, and later as few as its windows ask for, a quarter of those of the trial at least:
//   most = its pace of the second half,   least = most max(windows / steps, 1/4)
// The root of least and most counts where its steps grew from the first half of the trial to the second; else most. The
// bounds hold the slower and the faster half of the grains as well.
// `trial`: "trial" of summary.json. Throws nlohmann::json::exception where it lacks something.
RunTime expected_run_time(const nlohmann::ordered_json& trial, double t_end);

// "45 s", "3.2 min", "1.5 h": two digits.
std::string duration_text(double seconds);

// footfall check --time: the first seconds of a run, and how long the whole of it takes.

// Runs the scene of `arguments` for so many seconds into a folder that is removed again, and prints the expected run time,
// the memory, and what the coupling has met so far. A bed that is not made yet is not made for this: then it says so.
// Returns the exit code. Throws InputError, PartnerError.
int trial_command(const RunArguments& arguments, double seconds);

// footfall surfaces: the fuzzy controllers of a scene as pictures.

// Of every fuzzy controller the first and the third output over (a, da) and (a, alpha), the other inputs zero, as in
// [Lin25 Figure 4]; of one with fewer outputs, the first. Returns the exit code. Throws InputError; also when the scene
// has no fuzzy controller.
int surfaces_command(const std::string& scene, const std::vector<std::string>& settings, const std::string& out);

}  // namespace footfall
