#pragma once
// Power laws through all finished runs of an experiment (fit_spec.h, power_law.h), beside exponents that others
// published.

#include <string>
#include <vector>

#include "mbd_solver/cli/experiments/power_law.h"
#include "mbd_solver/cli/experiments/results.h"

namespace footfall {

struct FitData {
  std::vector<std::size_t> runs;  // those that are done
  Eigen::MatrixXd x;              // one row per run, one column per factor
  Eigen::VectorXd y;              // the figure
};
// Throws InputError when a run has a number that is not positive.
FitData fit_data(const ExperimentSpec& spec, const FitSpec& fit, const Plan& plan,
                 const std::vector<RunResult>& results);

// Prints every fit and writes fits.csv, fits.md, and NAME.png and NAME.svg (measured over fitted, logarithmic) into
// `folder`; returns the files. Nothing without fits.
std::vector<std::string> write_fits(const ExperimentSpec& spec, const Plan& plan, const std::vector<RunResult>& results,
                                    const std::string& folder);

}  // namespace footfall
