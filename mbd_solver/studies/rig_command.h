#pragma once
// footfall rig NAME: a sweep of inputs/rigs, its answers with confidence intervals, their changes by the checks, agreement
// with published laws, and a picture.

#include <string>
#include <vector>

#include "mbd_solver/studies/rig.h"

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

// Prints the page and writes NAME.md, NAME.csv, NAME_samples.csv, NAME_curves.csv, NAME.png and .svg into the folder. `title`
// and `command` head the page; `verdicts`: with published laws.
void write_rig(const Rig& rig, const std::vector<RigVariant>& variants, const std::string& folder,
               const std::string& title, const std::string& command, bool verdicts);

struct RigArguments {
  std::string name, file, out, gravity;  // file empty: inputs/rigs/NAME.toml; gravity empty: the scene's
  std::vector<std::string> settings;     // of every run, before what the rig varies
  int samples = 0;                       // of the bed; 0: as many as the file has
  int jobs = 0, only = -1;
  bool checks = false, short_form = false, list = false, beds = false;
};

// "earth", "moon", "mars" or a number [m/s2] as a setting. Throws InputError.
std::string gravity_setting(const std::string& name);

// Returns the exit code: 0; 1 when a run failed; 3 when interrupted. Throws InputError.
int rig_command(const RigArguments& arguments);

}  // namespace footfall
