// The way of a search: mbd_solver/cli/calibrate/search.h and gauss_newton.h.
#include "mbd_solver/cli/calibrate/search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "mbd_solver/cli/calibrate/gauss_newton.h"
#include "tests/unit/cli/search_stage.h"

namespace footfall {
namespace {

const Shares kBottom = {0.3, 0.8, 0.45};

std::vector<double> bowl_residuals(const Shares& u) {
  std::vector<double> r;
  for (std::size_t i = 0; i < u.size(); ++i) r.push_back((u[i] - kBottom[i]) * (3.0 + static_cast<double>(i)));
  r.push_back((u[0] - kBottom[0]) * (u[1] - kBottom[1]));
  return r;
}

double bowl(const Shares& u) {
  double sum = 0.0;
  for (const double r : bowl_residuals(u)) sum += r * r;
  return sum;
}

struct Walked {
  StageWay way;
  int runs = 0, rounds = 0;  // sets that were run, and how often the search began anew
};

// As a calibration does it: the sets that are wanted become known, and the search begins anew.
Walked walked(const StageSpec& stage, std::size_t side_by_side, int most_rounds = 100000) {
  static const Shares kStart = {0.5, 0.5, 0.5};
  std::map<Shares, bool> known;
  Walked w;
  SearchQuestions questions;
  questions.misfit = [&](const Shares& u) -> std::optional<double> {
    if (!known.count(u)) return {};
    return bowl(u);
  };
  LeastSquaresQuestions squares;
  squares.residuals = [&](const Shares& u) -> std::optional<std::vector<double>> {
    if (!known.count(u)) return {};
    return bowl_residuals(u);
  };
  questions.may_go_on = squares.may_go_on = [](const Shares&) { return true; };
  for (; w.rounds < most_rounds; ++w.rounds) {
    w.way = stage.method == SearchMethod::kGaussNewton ? walk_least_squares(stage, kStart, 0.01, squares)
                                                       : walk(stage, kStart, questions, side_by_side);
    if (w.way.wanted.empty()) break;
    for (const Shares& u : w.way.wanted) known[u] = true;
    w.runs = static_cast<int>(known.size());
  }
  return w;
}

class Search : public ::testing::TestWithParam<SearchMethod> {};

TEST_P(Search, GoesTheSameWayHoweverManyRunsGoSideBySide) {
  const StageSpec stage = stage_of(GetParam(), 60);
  const Walked one = walked(stage, 1), four = walked(stage, 4);
  EXPECT_GT(one.way.sets.size(), 9u);
  EXPECT_LE(one.way.sets.size(), 60u);
  EXPECT_EQ(one.way.sets, four.way.sets);
  EXPECT_EQ(one.way.best, four.way.best);
  EXPECT_EQ(one.way.end, four.way.end);
  EXPECT_EQ(one.runs, static_cast<int>(one.way.sets.size()));  // one by one nothing is run in vain
  EXPECT_LE(four.rounds, one.rounds);
  for (const Shares& u : one.way.sets)
    for (const double share : u) EXPECT_TRUE(share >= 0.0 && share <= 1.0);
}

TEST_P(Search, GetsNearerToTheBottom) {
  const StageWay way = walked(stage_of(GetParam(), 150), 2).way;
  EXPECT_LT(way.misfit, 0.1 * bowl({0.5, 0.5, 0.5}));
  EXPECT_DOUBLE_EQ(way.misfit, bowl(way.best));
}

TEST_P(Search, EndsAtALimit) {
  SearchQuestions questions;
  questions.misfit = [](const Shares& u) { return bowl(u); };
  LeastSquaresQuestions squares;
  squares.residuals = [](const Shares& u) { return bowl_residuals(u); };
  int asked = 0;
  questions.may_go_on = squares.may_go_on = [&](const Shares&) { return ++asked <= 7; };
  const StageSpec stage = stage_of(GetParam(), 100);
  const StageWay way = GetParam() == SearchMethod::kGaussNewton
                           ? walk_least_squares(stage, {0.5, 0.5, 0.5}, 0.01, squares)
                           : walk(stage, {0.5, 0.5, 0.5}, questions, 1);
  EXPECT_EQ(way.sets.size(), 7u);
  EXPECT_EQ(way.end, "limit reached");
}

INSTANTIATE_TEST_SUITE_P(Methods, Search,
                         ::testing::Values(SearchMethod::kDirect, SearchMethod::kCrs2, SearchMethod::kIsres,
                                           SearchMethod::kBobyqa, SearchMethod::kSbplx, SearchMethod::kGaussNewton),
                         [](const auto& of) { return std::string(name_of(of.param)); });

TEST(GaussNewton, IsAtTheBottomOfALeastSquaresProblemAfterFewSets) {
  const StageWay way = walked(stage_of(SearchMethod::kGaussNewton, 60), 1).way;
  EXPECT_EQ(way.end, "within its precision");
  for (std::size_t i = 0; i < kBottom.size(); ++i) EXPECT_NEAR(way.best[i], kBottom[i], 1e-4);  // its precision
  EXPECT_LE(way.sets.size(), 50u);
}

// With the bottom outside, the constrained minimum is found, not the cut one: r = (a + b - 2, a - b), a <= 0.7 of its unit.
TEST(GaussNewton, SolvesAnewWhereARangeEnds) {
  LeastSquaresQuestions squares;
  squares.may_go_on = [](const Shares&) { return true; };
  squares.residuals = [](const Shares& u) {
    const double a = 0.7 * u[0], b = 2.0 * u[1];
    return std::vector<double>{3.0 * (a + b - 2.0), a - b};
  };
  const StageWay way = walk_least_squares(stage_of(SearchMethod::kGaussNewton, 200), {0.5, 0.5}, 0.01, squares);
  EXPECT_NEAR(way.best[0], 1.0, 1e-9);
  EXPECT_NEAR(2.0 * way.best[1], (9.0 * 1.3 + 0.7) / 10.0, 1e-3);  // least of 9 (b - 1.3)^2 + (b - 0.7)^2
}

TEST(SearchSideBySide, RunsTheFirstSetsOfAGlobalSearchSideBySide) {
  const Walked one = walked(stage_of(SearchMethod::kIsres, 60), 1), six = walked(stage_of(SearchMethod::kIsres, 60), 6);
  EXPECT_LE(six.rounds, one.rounds / 3);
  EXPECT_LE(six.runs, 80);  // few in vain
}

}  // namespace
}  // namespace footfall
