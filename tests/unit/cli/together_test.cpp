// Which targets come together: mbd_solver/cli/calibrate/together.h.
#include "mbd_solver/cli/calibrate/together.h"

#include <gtest/gtest.h>

#include <numeric>

namespace footfall {
namespace {

// Sets that meet these targets, of `targets` targets with weight 1.
struct SetsThatMeet {
  CalibrationSpec spec;
  std::vector<Evaluation> evaluations;
  std::vector<const Evaluation*> all;

  SetsThatMeet(std::size_t targets, const std::vector<std::vector<std::size_t>>& sets) {
    spec.targets.resize(targets);
    for (const std::vector<std::size_t>& met : sets) {
      Evaluation e;
      e.targets.resize(targets);
      for (TargetResult& target : e.targets) target.residuals = {5.0};
      for (const std::size_t t : met) e.targets[t].residuals = {0.0};
      e.misfit = 25.0 * static_cast<double>(targets - met.size());
      evaluations.push_back(e);
    }
    for (const Evaluation& e : evaluations) all.push_back(&e);
  }
};

std::vector<std::size_t> first_targets(std::size_t count) {
  std::vector<std::size_t> targets(count);
  std::iota(targets.begin(), targets.end(), 0);
  return targets;
}

TEST(Together, NamesWhatNoSetMeetsAndPairsThatNoneMeetsTogether) {
  const SetsThatMeet s(4, {{0, 1}, {1, 2}});
  const Apart found = apart(s.spec, s.all);
  EXPECT_EQ(found.never, std::vector<std::size_t>{3});
  ASSERT_EQ(found.pairs.size(), 1u);
  EXPECT_EQ(found.pairs[0].a, 0u);
  EXPECT_EQ(found.pairs[0].b, 2u);
  EXPECT_EQ(most_without_a_pair(found, first_targets(4)), 2u);
}

TEST(Together, AtMostTheLargestChoiceWithoutAPair) {
  Apart ring;  // of five: two; the sixth goes with all, the seventh was never met
  for (std::size_t k = 0; k < 5; ++k) ring.pairs.push_back({k, (k + 1) % 5, 1, 1});
  ring.never = {6};
  EXPECT_EQ(most_without_a_pair(ring, first_targets(7)), 3u);
  Apart star;  // the middle of a star of four against its ends
  for (std::size_t k = 1; k < 5; ++k) star.pairs.push_back({0, k, 1, 1});
  EXPECT_EQ(most_without_a_pair(star, first_targets(5)), 4u);
  Apart middle;  // one against two
  for (std::size_t k = 1; k < 3; ++k) middle.pairs.push_back({0, k, 1, 1});
  EXPECT_EQ(most_without_a_pair(middle, first_targets(3)), 2u);
  EXPECT_EQ(most_without_a_pair(Apart{}, first_targets(5)), 5u);
  Apart many;  // pairs of their own: one of each, and no search through all choices
  for (std::size_t k = 0; k < 60; ++k) many.pairs.push_back({2 * k, 2 * k + 1, 1, 1});
  EXPECT_EQ(most_without_a_pair(many, first_targets(120)), 60u);
}

TEST(Together, MostAreCountedByWeight) {
  SetsThatMeet s(4, {{0, 1}, {2, 3, 0}});
  s.spec.targets[2].weight = s.spec.targets[3].weight = 0.25;
  EXPECT_EQ(most_met(s.spec, s.all), s.all[0]);
  EXPECT_EQ(weightiest(s.spec), first_targets(2));
  EXPECT_EQ(met_of(*s.all[1], weightiest(s.spec)), 1);
  s.spec.targets[3].weight = 1.0;
  EXPECT_EQ(most_met(s.spec, s.all), s.all[1]);
}

}  // namespace
}  // namespace footfall
