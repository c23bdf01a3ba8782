#pragma once
// How far a set of parameters is from the targets.
//
//   Phi = sum over targets t, and rows k of curves, of w_t r_tk^2
//   r   = (y - value) / tolerance, or of a band the distance to it: (y - most)+ / tolerance - (least - y)+ / tolerance
//         in Phi at most CalibrationSpec::cap, and at least -cap, where there is one
//
// y is the mean over the seeds; of an ordering, the ratio of two means.

#include <string>
#include <vector>

#include "mbd_solver/cli/calibrate/calibration.h"
#include "mbd_solver/output/history.h"

namespace footfall {

// Of one finished run, as far as targets ask.
struct RunNumbers {
  std::vector<double> figures;              // as CalibrationSpec::figures; NaN: not asked, or not there
  std::vector<std::vector<double>> curves;  // one per target: of curves, y at the file's x; else empty
};

struct TargetResult {
  std::vector<double> values;                // y: one, or of a curve one per row
  std::vector<double> spread;                // over the seeds, sample standard deviation; 0 for one seed
  std::vector<double> residuals;             // r
  std::vector<std::vector<double>> of_seed;  // y of every seed alone
  bool band = false;                         // wanted within bounds
  bool failed = false;                       // a run of it did not end; r is CalibrationSpec::failed

  double misfit(const TargetSpec& target, double cap = 0.0) const;  // its part of Phi
  bool is_met() const { return !failed && met(residuals, band); }
  // A number within one tolerance, a band kept, a curve within 1.5 tolerances (root mean square).
  static bool met(const std::vector<double>& residuals, bool band);
};

// `runs`: one per seed, for every scene; empty where one of them failed.
TargetResult result_of(const CalibrationSpec& spec, std::size_t target,
                       const std::vector<std::vector<RunNumbers>>& runs);

// What targets of `scene` ask of the run in `folder`. Throws InputError when it has no such column or key.
RunNumbers numbers_of(const CalibrationSpec& spec, const std::string& scene, const std::string& folder);

// y over x at the places `at`, from rows up to the largest x: at the first crossing, linearly. Before the first row and
// beyond the largest x the nearest row counts.
std::vector<double> first_crossings(const std::vector<double>& x, const std::vector<double>& y,
                                    const std::vector<double>& at);

// r as it counts in Phi.
double capped(double residual, double cap);
// r of one number.
double residual_of(const TargetSpec& target, double y);

}  // namespace footfall
