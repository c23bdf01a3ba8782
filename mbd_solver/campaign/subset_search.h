#pragma once
// The probability of a rare event by subset simulation [Au and Beck, Prob. Eng. Mech. 16, 2001]: levels of a number g are raised
// such that each is exceeded by about a tenth of the runs above the one before, P(g > threshold) = product of the shares.

#include <cstdint>
#include <random>
#include <vector>

namespace footfall {

struct RareProbability {
  double value = 0.0, low = 0.0, high = 1.0;  // with a 95 % interval
  double variation = 0.0;                     // deviation over mean, as if all levels depended on each other fully
  bool reached = false;                       // the threshold, with the runs that were allowed
};

// Runs above a level are continued by Markov chains in standard normal numbers, u' = r u + sqrt(1 - r^2) n, which are
// refused where g is not above the level [Papaioannou and others, Prob. Eng. Mech. 41, 2015]. Request points and give
// their numbers and so on until there are none. The same seed and numbers give the same points.
class SubsetSearch {
 public:
  // runs: at most, of at least 50.
  SubsetSearch(std::size_t inputs, int runs, double threshold, std::uint64_t seed);

  // The next points of the unit cube. `values`: g at the points before; empty at first. NaN counts as above all levels.
  std::vector<std::vector<double>> next(const std::vector<double>& values);

  struct Level {
    double level = 0.0, share = 0.0, variation = 0.0;
  };
  const std::vector<Level>& levels() const { return levels_; }
  RareProbability result() const;

 private:
  struct Run {
    std::vector<double> u;
    double g = 0.0;
  };
  void raise();  // from a full level to the next one, or to the end
  std::vector<std::vector<double>> positions() const;

  std::size_t inputs_, size_, chains_;  // of a level: runs, and chains
  int left_;                            // runs
  double threshold_;
  std::mt19937_64 engine_;
  std::vector<Run> runs_, proposed_;  // of the level: chain after chain within each step
  std::vector<Level> levels_;         // done
  bool done_ = false, reached_ = false;
};

}  // namespace footfall
