#pragma once
// Growth per window measured in LIGGGHTS: the pad of inputs/accuracy/scenes/linear.toml, guided between fixed grains on
// linear contacts.

#include <string>
#include <vector>

#include "mbd_solver/cli/experiments/runs.h"

namespace footfall {

// Largest |lambda| of a linear motion v_k = sum c_i lambda_i^k from its values at the ends of windows: the ratio of the
// last two where it grows fast and steadily, else the larger root of lambda^2 = a lambda + b with a, b from
// v_{k+1} = a v_k + b v_{k-1} by least squares over the second half. NaN for fewer than four values.
double growth_of_series(const std::vector<double>& v);

// A run of `scene` for every scheme and omega H, over as many windows as the contacts stay closed.
std::vector<RunRequest> growth_runs(const GrowthSpec& growth, const std::string& scene);

// From the run of that scheme among those in `folder`. NaN when it left nothing.
double growth_in_liggghts(const std::string& folder, const std::string& scheme, double omega_h, int n);

}  // namespace footfall
