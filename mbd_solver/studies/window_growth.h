#pragma once
// Growth per window of the coupling schemes: one body of mass m on a linear contact of stiffness K with a fixed grain,
// without damping, omega H = sqrt(K/m) H. Predicted: the spectral radius of the scheme's window map. Measured: with the coupling
// code (path, mean load, tangent) on that contact, the body integrated exactly; and with LIGGGHTS, the pad of
// inputs/accuracy/scenes/linear.toml, guided between fixed grains on linear contacts. theory 7.7.

#include <limits>
#include <string>
#include <vector>

#include "mbd_solver/studies/results.h"

namespace footfall {

struct GrowthPoint {
  std::string scheme;
  int substeps = 1;                                               // DEM steps of a window
  double omega_h = 0.0;                                           // [-]
  double theory = 0.0;                                            // spectral radius [-]
  double measured = 0.0;                                          // growth of the motion per window [-]
  double in_liggghts = std::numeric_limits<double>::quiet_NaN();  // the same in a coupled run; NaN: no result

  bool as_theory(bool ran) const;  // within 1 %, the accuracy of a motion of a few windows
};

double predicted_growth(const std::string& scheme, double omega_h, int n);
double measured_growth(const std::string& scheme, double omega_h, int n);

// Largest |lambda| of a linear motion v_k = sum c_i lambda_i^k at the ends of windows: the ratio of the last two values if
// it grows fast and steadily, otherwise the larger root of lambda^2 = a lambda + b with v_{k+1} = a v_k + b v_{k-1} by least
// squares over the second half. NaN for fewer than four values.
double growth_of_series(const std::vector<double>& v);

// A run of `scene` for every number of substeps, omega H and scheme, over as many windows as the contacts stay closed.
std::vector<RunRequest> growth_runs(const GrowthSpec& growth, const std::string& scene);

// Every scheme at every omega H and number of substeps; `runs`: those of growth_runs, may be empty.
std::vector<GrowthPoint> growth_of_schemes(const GrowthSpec& growth, const std::vector<RunResult>& runs);
// As Markdown: a table per number of substeps, a line per omega H, "in LIGGGHTS / measured / theory" per scheme.
std::string growth_page(const SweepSpec& spec, const std::vector<GrowthPoint>& points);

}  // namespace footfall
