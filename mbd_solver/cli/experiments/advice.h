#pragma once
// What the errors of an experiment recommend: the cheapest value of each curve that keeps all errors within a limit,
// and whose error is the largest.

#include <vector>

#include "mbd_solver/cli/experiments/results.h"

namespace footfall {

constexpr std::size_t kNoFigure = static_cast<std::size_t>(-1);

struct Advice {
  // The first case, in the file's order from coarse to fine, from which on all errors are within the limit: one that
  // is within while a finer one is not was lucky. Where none is, the one with the smallest largest error; null: none
  // was done. Points into the results.
  const CaseResult* point = nullptr;
  bool within = false;
  // Where none is with all figures, but one is without this one, the worst of the best value.
  std::size_t apart = kNoFigure;
  std::size_t worst = kNoFigure;  // the figure with the largest error, but for that one
  bool resolved = true;           // the standard errors of all figures but that one are within the limit
  // Processor time over that of the curve's default, or of its reference; 0: neither is known.
  double time_ratio = 0.0;

  const SampledFigure& largest() const { return point->figures[worst]; }
};

// One per curve.
std::vector<Advice> advice_of(const ExperimentSpec& spec, const Results& results, double limit);

// The largest error of each curve with a default, at that default, the largest first.
std::vector<Advice> errors_of_defaults(const ExperimentSpec& spec, const Results& results);

}  // namespace footfall
