#pragma once
// Power laws through all finished runs of a sweep (sweep_fit_spec.h, power_law.h), beside exponents that others
// published.

#include <string>
#include <vector>

#include "mbd_solver/cli/experiments/power_law.h"
#include "mbd_solver/cli/experiments/sweep_table.h"
#include "mbd_solver/cli/experiments/table_reader.h"

namespace footfall {

// One entry of [[fits]]. Throws InputError.
void read_fit(TableReader& table, SweepFit& fit);
// That what the fits name is there, and that parameters in sums have numbers for values. Throws InputError.
void check_fits(const SweepSpec& sweep);

struct SweepFitData {
  std::vector<int> runs;  // those that are done
  Eigen::MatrixXd x;      // one row per run, one column per factor
  Eigen::VectorXd y;      // the figure
};
// Throws InputError when a run has a number that is not positive.
SweepFitData fit_data(const SweepSpec& sweep, const SweepFit& fit, const std::vector<SweepRun>& runs,
                      const std::vector<SweepResult>& results);

// Prints every fit and writes fits.csv, fits.md, and NAME.png and NAME.svg (measured over fitted, logarithmic) into
// `folder`; returns the files. Nothing without fits.
std::vector<std::string> write_fits(const SweepSpec& sweep, const std::vector<SweepRun>& runs,
                                    const std::vector<SweepResult>& results, const std::string& folder);

}  // namespace footfall
