#pragma once
// Targets and what runs say of them, as pages have it.

#include <string>

#include "mbd_solver/cli/calibrate/evaluations.h"

namespace footfall {

// "0.9 to 1.1", "at least 2", "0.5".
std::string wanted(const TargetSpec& target);
// In tolerances; of a curve the root mean square.
double distance(const TargetResult& result);
// The value with its spread over the seeds; "failed".
std::string value_text(const TargetSpec& target, const TargetResult& result);
int seeds_that_meet(const TargetSpec& target, const TargetResult& result);

}  // namespace footfall
