#pragma once
// Drawn parameters and campaigns of tests, without files.

#include <string>
#include <utility>
#include <vector>

#include "mbd_solver/campaign/sampling.h"

namespace footfall {

inline ParameterSpec drawn(const std::string& name, DistributionKind kind) {
  ParameterSpec p;
  p.name = name;
  p.distribution.kind = kind;
  return p;
}

inline ParameterSpec uniform(const std::string& name, double least, double most) {
  ParameterSpec p = drawn(name, DistributionKind::kUniform);
  p.distribution.least = least;
  p.distribution.most = most;
  return p;
}

inline ParameterSpec normal(const std::string& name, double mean, double deviation) {
  ParameterSpec p = drawn(name, DistributionKind::kNormal);
  p.distribution.mean = mean;
  p.distribution.deviation = deviation;
  return p;
}

inline SweepSpec drawn_sweep(std::vector<ParameterSpec> parameters, int runs, Design design = Design::kRandom,
                             int seed = 1) {
  SweepSpec spec;
  spec.parameters = std::move(parameters);
  spec.runs = runs;
  spec.design = design;
  spec.seed = seed;
  return spec;
}

inline std::vector<double> column(const Draws& draws, std::size_t k) {
  std::vector<double> values;
  for (std::size_t i = 0; i < draws.count(); ++i) values.push_back(draws.values(i)[k]);
  return values;
}

}  // namespace footfall
