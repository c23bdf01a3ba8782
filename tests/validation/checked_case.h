#pragma once
// One mechanism of docs/mechanisms_checked.md: what it is, and what a run of it errs by.

#include <functional>
#include <string>
#include <vector>

namespace footfall::test {

struct Outcome {
  double error = 0.0;   // relative [-]
  double energy = 0.0;  // largest error of the energy balance [J]
  long steps = 0;
  std::string told = {};  // what else the run shows
};

struct CheckedCase {
  std::string name;
  std::string what;      // the mechanism
  std::string compared;  // what the error is, and relative to what
  std::string source;    // of the reference
  std::vector<double> tolerances;
  // integrator, rtol. Throws what the run throws.
  std::function<Outcome(const std::string&, double)> run;
  // At rtol 1e-6. The tests hold each integrator to its `held`, the goal where none is given; `why` says what is missing.
  double goal = 100.0;         // error over tolerance [-]
  double energy = 0.1;         // error of the energy [J]
  double held_one_step = 0.0;  // error over tolerance; 0: the goal, infinity: not held
  double held_ida = 0.0;
  std::string why;
  bool in_short = true;  // runs in the tests
};

std::vector<CheckedCase> checked_cases();

}  // namespace footfall::test
