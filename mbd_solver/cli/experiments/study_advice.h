#pragma once
// What a study recommends: the cheapest value of each curve that keeps all errors within a limit, and whose error is
// the largest.

#include <string>
#include <vector>

#include "mbd_solver/cli/experiments/study_plot.h"

namespace footfall {

struct Advice {
  std::string curve;
  std::string
      value;  // the first one, in the file's order from coarse to fine, from which on all errors are within the limit:
              // one that is within while a finer one is not was lucky. Empty: none is
  std::string apart;  // where none is with all measures, but one is without this one, the worst of the best value: it
  double apart_error = 0.0;  // has this error there [-]; then `measure`, `error` and the like are of the others
  std::string
      best;  // `value`, or where none is within the limit the one with the smallest largest error; empty: none was done
  std::string measure;          // with the largest error of `best`
  double error = 0.0;           // of that measure [-]
  double standard_error = 0.0;  // likewise: what the samples leave open [-]; 0 without an ensemble
  bool resolved = true;         // the standard errors of all measures of `best` are within the limit
  // processor time of `best` over that of the curve's default, or of its reference; 0: neither is known
  double time_ratio = 0.0;
};

// One per curve.
std::vector<Advice> advice_of(const StudyTable& table, double limit);

// The largest error of each curve with a default, at that default, the largest first: `value` is the default.
std::vector<Advice> errors_of_defaults(const StudyTable& table);

}  // namespace footfall
