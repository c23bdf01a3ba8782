#pragma once
// What a rig tells: its answers with their intervals, whether checks move them, whether claims came out, and a picture.

#include <string>
#include <vector>

#include "mbd_solver/cli/rigs/rig.h"

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

// Prints and writes into the folder: NAME.md, NAME.csv, NAME_curves.csv, and NAME.png and .svg. `title` and `command`
// head the page. Claims are told when `verdicts`. Answers are those of the first sample.
void write_rig(const Rig& rig, const std::vector<RigVariant>& variants, const std::string& folder,
               const std::string& title, const std::string& command, bool verdicts);

}  // namespace footfall
