#pragma once
// Which targets come together, from sets that were run: no linearity is taken for granted.

#include <string>
#include <vector>

#include "mbd_solver/cli/calibrate/evaluations.h"
#include "mbd_solver/cli/calibrate/page_part.h"

namespace footfall {

// The set of those given that meets most targets, counted by their weights; the least misfit decides between equals.
const Evaluation* most_met(const CalibrationSpec& spec, const std::vector<const Evaluation*>& sets);
// The targets of the largest weight: all, unless some count less.
std::vector<std::size_t> weightiest(const CalibrationSpec& spec);
int met_of(const Evaluation& set, const std::vector<std::size_t>& targets);
// Pairs of targets that some set meets alone, and no set together; and targets that none meets.
struct Apart {
  std::vector<std::size_t> never;
  struct Pair {
    std::size_t a, b;
    int met_a, met_b;  // sets
  };
  std::vector<Pair> pairs;
};
Apart apart(const CalibrationSpec& spec, const std::vector<const Evaluation*>& sets);
// So many of the targets can come together at most, as far as these pairs and the targets that none meets tell: the
// largest choice of the others without a pair.
std::size_t most_without_a_pair(const Apart& apart, const std::vector<std::size_t>& targets);
// The same as sentences, and a table of the pairs.
PagePart apart_part(const CalibrationSpec& spec, const std::vector<const Evaluation*>& sets);

}  // namespace footfall
