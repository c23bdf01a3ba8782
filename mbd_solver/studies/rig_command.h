#pragma once
// footfall rig NAME: a sweep of inputs/rigs, its answers with confidence intervals, their changes by the checks, agreement
// with published laws, and a picture.

#include <string>
#include <vector>

#include "mbd_solver/studies/rig.h"
#include "mbd_solver/studies/sweep_command.h"

namespace footfall {

// The samples of one variant: the rig itself, or one of its checks.
struct RigVariant {
  std::string name;  // empty: the rig itself
  std::vector<RigSample> samples;
};

struct RigStatistic {
  int samples = 0;        // that have the answer
  double mean = 0.0;      // NaN without
  double interval = 0.0;  // 95 % of the mean: t s / sqrt(n), Student's t; NaN with fewer than two
};
RigStatistic statistic_of(const std::vector<RigSample>& samples, std::size_t answer);

// Prints the page and writes NAME.md, NAME.csv, NAME_samples.csv, NAME_curves.csv, NAME.png and .svg into the folder. In the
// short form without published laws.
void write_rig(const Rig& rig, const std::vector<RigVariant>& variants, const OutputFolder& output,
               const std::string& title);

struct RigArguments : SweepArguments {  // file empty: inputs/rigs/NAME.toml; settings: before the settings of the rig
  RigArguments() { command = "rig", runs = "runs/rigs", resume = true; }
  std::string name, gravity;  // gravity empty: the scene's
  int samples = 0;            // of the bed; 0: as many as the file has
  bool checks = false;
};

// "earth", "moon", "mars" or a number [m/s2] as a setting. Throws InputError.
std::string gravity_setting(const std::string& name);

// Returns the exit code: 0; 1 when a run failed; 3 when interrupted. Throws InputError.
int rig_command(const RigArguments& arguments);

}  // namespace footfall
