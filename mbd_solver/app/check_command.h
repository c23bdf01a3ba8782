#pragma once
// footfall check, which every run begins with; with --time a short trial of the run, with --surfaces pictures of its fuzzy
// controllers.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mbd_solver/app/run_command.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// Reads the scene and builds its mechanism once, to find everything that a run would refuse: meshes, modal bases,
// controllers. Warnings go to standard error. Throws InputError.
Scene checked_scene(const std::string& argument, const std::vector<std::string>& settings);

// Prints the contents of the scene. Returns the exit code. Throws InputError with every finding.
int check_command(const std::string& argument, const std::vector<std::string>& settings);

// Estimated wall time of a whole run, from a trial of it.
struct RunTime {
  double seconds = 0.0;            // estimate [s]
  double least = 0.0, most = 0.0;  // range [s]
  double share_of_grains = 0.0;    // share of LIGGGHTS' work in it [0 ... 1]
};

// With marks 0, 1, 2 of the trial (its start, middle and end), rates of the second half, and R = t_end - t_2 to come:
//   T = t_wall,2 + R (grains + mechanism),   grains = (dem_2 - dem_1) / (t_2 - t_1)
// Every DEM step is taken to cost as much as in the second half of the trial. A mechanism takes short steps after an
// impact; later as few as its windows require, but at least a quarter of the trial's steps:
//   most = its pace in the second half,   least = most max(windows / steps, 1/4)
// The estimate takes sqrt(least most) when its steps grew from the first half of the trial to the second, otherwise most.
// The range also covers the slower and the faster half of the grains.
// `trial`: "trial" of summary.json. Throws nlohmann::json::exception when it is incomplete.
RunTime expected_run_time(const nlohmann::ordered_json& trial, double t_end);

// "45 s", "3.2 min", "1.5 h": two digits.
std::string duration_text(double seconds);

// check --time: runs the scene for so many seconds in a temporary folder and prints the estimated run time, the memory,
// and the largest omega H and overlap so far. Does not make a bed: without one it prints how to make it. Returns the exit
// code. Throws InputError, PartnerError.
int trial_command(const RunArguments& arguments, double seconds);

// check --surfaces: draws, for every fuzzy controller of the scene, its first and third output over (a, da) and (a, alpha)
// with the other inputs zero, as in [Lin25 Figure 4]; with fewer than three outputs only the first. Returns the exit code.
// Throws InputError, also when the scene has no fuzzy controller.
int draw_control_surfaces(const std::string& scene, const std::vector<std::string>& settings, const std::string& out);

}  // namespace footfall
