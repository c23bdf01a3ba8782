#pragma once
// What the errors of an experiment recommend: the cheapest value of each curve that keeps all errors within a limit,
// and whose error is the largest.

#include <string>
#include <vector>

#include "mbd_solver/cli/experiments/error_table.h"

namespace footfall {

struct Advice {
  std::string curve;
  // The first value, in the file's order from coarse to fine, from which on all errors are within the limit: one that
  // is within while a finer one is not was lucky. Empty: none is.
  std::string value;
  // Where none is with all figures, but one is without this one, the worst of the best value: it has this error there
  // [-]; then `figure`, `error` and the like are of the others.
  std::string apart;
  double apart_error = 0.0;
  // `value`, or where none is within the limit the one with the smallest largest error; empty: none was done.
  std::string best;
  std::string figure;           // with the largest error of `best`
  double error = 0.0;           // of that figure [-]
  double standard_error = 0.0;  // likewise: what the samples leave open [-]; 0 without an ensemble
  bool resolved = true;         // the standard errors of all figures of `best` are within the limit
  // Processor time of `best` over that of the curve's default, or of its reference; 0: neither is known.
  double time_ratio = 0.0;
};

// One per curve.
std::vector<Advice> advice_of(const ErrorTable& table, double limit);

// The largest error of each curve with a default, at that default, the largest first: `value` is the default.
std::vector<Advice> errors_of_defaults(const ErrorTable& table);

}  // namespace footfall
