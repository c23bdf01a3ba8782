#pragma once
// Growth per window of the coupling schemes on the simplest problem there is: one body of mass m on one linear contact
// of stiffness K with a grain that stands, no damping, omega H = sqrt(K/m) H. By theory the spectral radius of the scheme's
// window map; measured: the coupling code itself (path, mean load, tangent) on that contact, the body integrated
// exactly; and the whole program with LIGGGHTS (window_growth_run.h).
// theory 7.7.

#include <limits>
#include <string>
#include <vector>

namespace footfall {

struct GrowthPoint {
  std::string scheme;
  double omega_h = 0.0;                                           // [-]
  double theory = 0.0;                                            // spectral radius [-]
  double measured = 0.0;                                          // growth of the motion per window [-]
  double in_liggghts = std::numeric_limits<double>::quiet_NaN();  // the same in a coupled run; NaN: not run
};

double predicted_growth(const std::string& scheme, double omega_h, int n);
double measured_growth(const std::string& scheme, double omega_h, int n);

// Every scheme at every omega H with windows of n substeps; in LIGGGHTS too unless `runs` is empty, the folder of the
// runs (window_growth_run.h).
std::vector<GrowthPoint> growth_of_schemes(const std::vector<double>& omega_h, int n, const std::string& runs);
// As Markdown: one line per omega H, "measured / theory" per scheme.
void write_growth(const std::string& path, const std::string& title, const std::vector<GrowthPoint>& points, int n);

}  // namespace footfall
