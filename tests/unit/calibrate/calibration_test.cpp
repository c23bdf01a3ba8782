// Calibration: parameters, misfit, searches, intervals.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "mbd_solver/campaign/calibrate/determination.h"
#include "mbd_solver/campaign/calibrate/evaluations.h"
#include "mbd_solver/campaign/calibrate/search.h"
#include "mbd_solver/campaign/sampling.h"
#include "mbd_solver/studies/calibration.h"
#include "tests/support/refused.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/calibrate/search_stage.h"
#include "tests/unit/studies/text_file.h"

namespace footfall {
namespace {

// What the file of a calibration must hold: mbd_solver/studies/calibration.cpp.

using ::testing::HasSubstr;

const std::string kParameter = "[[parameters]]\nname = \"k\"\nsettings = [\"a={value}\"]\nleast = 1\nmost = 4\n";
const std::string kRest =
    "[[figures]]\nname = \"m\"\nkey = \"q\"\n[[targets]]\nfigure = \"m\"\nvalue = 3\ntolerance = 0.1\n"
    "[[stages]]\nmethod = \"sbplx\"\nevaluations = 10\n";

CalibrationSpec read_text(const std::string& text) {
  return read_calibration(test::TextFile("scene = \"scene.toml\"\n" + text).path);
}

std::string calibration_complaint(const std::string& text) {
  return test::refusal([&] { read_text(text); });
}

TEST(ReadCalibration, TakesAParameterWithItsScale) {
  CalibrationSpec s = read_text(kParameter + "scale = \"logarithmic\"\nstart = 1\n" + kRest);
  const CalibrationParameter& p = s.parameters.front();
  EXPECT_DOUBLE_EQ(p.value(0.5), 2.0);
  EXPECT_DOUBLE_EQ(p.position(2.0), 0.5);
  EXPECT_DOUBLE_EQ(p.value(1.0), 4.0);
  EXPECT_EQ(start_of(s), (UnitPoint{0.0}));
  EXPECT_EQ(s.targets.front().name, "m, run");  // the only scene
}

TEST(ReadCalibration, PutsFormulasIntoSettings) {
  const CalibrationSpec s = read_text("settings = [\"b={= 2*k + 1}\", \"c=[{= k}, {= -k}]\"]\n" + kParameter + kRest);
  EXPECT_EQ(with_formulas({"x={= 2*k}", "leg_{leg}=1"}, s, {1.0}), (std::vector<std::string>{"x=8", "leg_{leg}=1"}));
  EXPECT_THAT(calibration_complaint("settings = [\"b={= 2*kk}\"]\n" + kParameter + kRest), HasSubstr("\"kk\""));
  EXPECT_NE(calibration_complaint("settings = [\"b={= 2*k\"]\n" + kParameter + kRest), "");
}

TEST(ReadCalibration, MeasuresABrokenConstraint) {
  const CalibrationSpec s =
      read_text(kParameter + kRest + "[[constraints]]\nname = \"c\"\nformula = \"k*k\"\nmost = 8\n");
  EXPECT_DOUBLE_EQ(violation_of(s, {0.5}), 0.0);  // 2.5^2
  EXPECT_DOUBLE_EQ(violation_of(s, {1.0}), 1.0);  // 16 over 8
}

TEST(CalibrationSchema, HoldsTheKeysOfEverySection) {
  const nlohmann::json s = nlohmann::json::parse(calibration_schema())["properties"];
  EXPECT_TRUE(s["parameters"]["items"]["properties"]["scale"].contains("enum"));
  for (const char* key : {"value", "least", "against", "file", "tolerance", "weight"})
    EXPECT_TRUE(s["targets"]["items"]["properties"].contains(key)) << key;
  for (const char* section : {"scenes", "seeds", "stages", "figures", "constraints"})
    EXPECT_TRUE(s.contains(section)) << section;
}

TEST(ShippedCalibrations, CanBeRead) {
  int count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(FOOTFALL_SOURCE_DIR) + "/inputs/calibrations")) {
    if (entry.path().extension() != ".toml") continue;
    EXPECT_NO_THROW(read_calibration(entry.path())) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 4);
}

TargetSpec target(double least, double most) {
  TargetSpec t;
  t.least = least;
  t.most = most;
  t.tolerance = 0.5;
  return t;
}

TEST(Misfit, OfABandIsTheDistanceToIt) {
  const TargetSpec t = target(1.0, 2.0);
  EXPECT_DOUBLE_EQ(residual_of(t, 1.0), 0.0);
  EXPECT_DOUBLE_EQ(residual_of(t, 2.0), 0.0);
  EXPECT_DOUBLE_EQ(residual_of(t, 3.0), 2.0);
  EXPECT_DOUBLE_EQ(residual_of(t, 0.75), -0.5);
  TargetSpec value = t;
  value.value = 1.5;
  EXPECT_DOUBLE_EQ(residual_of(value, 1.0), -1.0);
}

TEST(Misfit, ReadsACurveWhereXIsReachedFirst) {
  const std::vector<double> x = {0, 1, 2, 3, 2, 1}, y = {0, 10, 20, 30, -1, -2};  // there and back
  EXPECT_EQ(first_crossings(x, y, {0.5, 2.0, 3.0}), (std::vector<double>{5, 20, 30}));
  EXPECT_EQ(first_crossings(x, y, {-1.0, 9.0}), (std::vector<double>{0, 30}));  // the nearest row
}

class MisfitOfRuns : public ::testing::Test {
 protected:
  MisfitOfRuns() {
    for (const char* name : {"a", "b"}) {
      CalibrationScene scene;
      scene.name = name;
      spec.scenes.push_back(scene);
    }
    MetricSpec figure;
    figure.name = "height";
    spec.metrics = {figure};
    TargetSpec ratio = target(1.5, 2.5);
    ratio.metric = "height";
    ratio.scene = "a";
    ratio.against = "b";
    spec.targets = {ratio};
  }
  static RunNumbers run(double height) { return {{{"height", height}}, {}}; }

  CalibrationSpec spec;
};

TEST_F(MisfitOfRuns, TakesADifferenceOfMeans) {
  spec.targets[0].difference = true;
  const TargetResult r = result_of(spec, 0, {{run(2), run(4)}, {run(1), run(1)}});
  EXPECT_DOUBLE_EQ(r.values.front(), 2.0);
  EXPECT_DOUBLE_EQ(r.residuals.front(), 0.0);
}

TEST_F(MisfitOfRuns, TakesARatioOfMeans) {
  const TargetResult r = result_of(spec, 0, {{run(2), run(4)}, {run(1), run(1)}});
  EXPECT_DOUBLE_EQ(r.values.front(), 3.0);
  EXPECT_DOUBLE_EQ(r.residuals.front(), 1.0);
  EXPECT_NEAR(r.spread.front(), std::sqrt(2.0), 1e-12);
  EXPECT_EQ(r.seeds, 2u);
  EXPECT_EQ(r.seeds_met, 1u) << "2 over 1; 4 over 1 is not within the band";
  spec.targets[0].weight = 4.0;
  EXPECT_DOUBLE_EQ(r.misfit(spec.targets[0]), 4.0);
  EXPECT_DOUBLE_EQ(r.misfit(spec.targets[0], 2.0), 4.0) << "not as far off as the cap";
  EXPECT_DOUBLE_EQ(r.misfit(spec.targets[0], 0.5), 1.0);
  EXPECT_EQ(capped(-7.0, 3.0), -3.0);
  EXPECT_EQ(capped(-7.0, 0.0), -7.0) << "no cap";
}

TEST_F(MisfitOfRuns, ABandIsMetWithinItsBoundsAndANumberWithinATolerance) {
  EXPECT_TRUE(result_of(spec, 0, {{run(2.5)}, {run(1)}}).is_met());
  EXPECT_FALSE(result_of(spec, 0, {{run(2.6)}, {run(1)}}).is_met()) << "a fifth of a tolerance beyond";
  spec.targets[0].value = 2.0;
  EXPECT_TRUE(result_of(spec, 0, {{run(2.4)}, {run(1)}}).is_met());
  EXPECT_FALSE(result_of(spec, 0, {{run(2.6)}, {run(1)}}).is_met());
}

TEST_F(MisfitOfRuns, IsThatOfFailureWhereARunOrANumberIsMissing) {
  spec.failed = 7.0;
  for (const auto& runs : {std::vector<std::vector<RunNumbers>>{{run(2)}, {}},
                           {{}, {run(1)}},
                           {{run(1)}, {run(0)}},
                           {{RunNumbers()}, {run(1)}}}) {
    const TargetResult r = result_of(spec, 0, runs);
    EXPECT_TRUE(r.failed);
    EXPECT_FALSE(r.is_met());
    EXPECT_DOUBLE_EQ(r.misfit(spec.targets[0]), 49.0);
  }
}

// The way of a search: mbd_solver/campaign/calibrate/search.h.

const UnitPoint kBottom = {0.3, 0.8, 0.45};

std::vector<double> bowl_residuals(const UnitPoint& u) {
  std::vector<double> r;
  for (std::size_t i = 0; i < u.size(); ++i) r.push_back((u[i] - kBottom[i]) * (3.0 + static_cast<double>(i)));
  r.push_back((u[0] - kBottom[0]) * (u[1] - kBottom[1]));
  return r;
}

double bowl(const UnitPoint& u) {
  double sum = 0.0;
  for (const double r : bowl_residuals(u)) sum += r * r;
  return sum;
}

struct Walked {
  SearchPath way;
  int runs = 0, rounds = 0;  // sets that were run, and how often the search began anew
};

// As a calibration does it: the sets that are wanted become known, and the search begins anew.
Walked walked(const StageSpec& stage, std::size_t side_by_side, int most_rounds = 100000) {
  static const UnitPoint kStart = {0.5, 0.5, 0.5};
  std::map<UnitPoint, bool> known;
  Walked w;
  SearchQueries questions;
  questions.misfit = [&](const UnitPoint& u) -> std::optional<double> {
    if (!known.count(u)) return {};
    return bowl(u);
  };
  questions.residuals = bowl_residuals;
  for (; w.rounds < most_rounds; ++w.rounds) {
    w.way = search_path(stage, kStart, 0.01, questions, side_by_side);
    if (w.way.requested.empty()) break;
    for (const UnitPoint& u : w.way.requested) known[u] = true;
    w.runs = static_cast<int>(known.size());
  }
  return w;
}

class Search : public ::testing::TestWithParam<SearchMethod> {};

SearchPath least_squares_path(const StageSpec& stage, const UnitPoint& start, double step,
                              const std::function<std::vector<double>(const UnitPoint&)>& residuals) {
  SearchQueries queries;
  queries.residuals = residuals;
  queries.misfit = [&](const UnitPoint& u) -> std::optional<double> {
    const std::vector<double> r = residuals(u);
    return std::inner_product(r.begin(), r.end(), r.begin(), 0.0);
  };
  return search_path(stage, start, step, queries, 1);
}

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
  for (const UnitPoint& u : one.way.sets)
    for (const double share : u) EXPECT_TRUE(share >= 0.0 && share <= 1.0);
}

TEST_P(Search, GetsNearerToTheBottom) {
  const SearchPath way = walked(stage_of(GetParam(), 150), 2).way;
  EXPECT_LT(way.misfit, 0.1 * bowl({0.5, 0.5, 0.5}));
  EXPECT_DOUBLE_EQ(way.misfit, bowl(way.best));
}

INSTANTIATE_TEST_SUITE_P(Methods, Search,
                         ::testing::Values(SearchMethod::kDirect, SearchMethod::kSbplx, SearchMethod::kGaussNewton),
                         [](const auto& of) { return std::string(name_of(of.param)); });

TEST(GaussNewton, IsAtTheBottomOfALeastSquaresProblemAfterFewSets) {
  const SearchPath way = walked(stage_of(SearchMethod::kGaussNewton, 60), 1).way;
  EXPECT_EQ(way.end, "within its precision");
  for (std::size_t i = 0; i < kBottom.size(); ++i) EXPECT_NEAR(way.best[i], kBottom[i], 1e-4);  // its precision
  EXPECT_LE(way.sets.size(), 50u);
}

// With the bottom outside, the constrained minimum is found, not the cut one: r = (a + b - 2, a - b), a <= 0.7 of its unit.
TEST(GaussNewton, SolvesAnewWhereARangeEnds) {
  const auto residuals = [](const UnitPoint& u) {
    const double a = 0.7 * u[0], b = 2.0 * u[1];
    return std::vector<double>{3.0 * (a + b - 2.0), a - b};
  };
  for (const UnitPoint& start : {UnitPoint{0.5, 0.5}, UnitPoint{0.0, 1.0}}) {
    const SearchPath way = least_squares_path(stage_of(SearchMethod::kGaussNewton, 200), start, 0.01, residuals);
    EXPECT_NEAR(way.best[0], 1.0, 1e-9);
    EXPECT_NEAR(2.0 * way.best[1], (9.0 * 1.3 + 0.7) / 10.0, 1e-3);  // least of 9 (b - 1.3)^2 + (b - 0.7)^2
  }
}

// Damper and gas over stroke, whose exponent is felt last: steps leave its range, and the search comes back from there. 80
// sets are eleven steps; a search that jumps between the ends takes up to 104.
TEST(GaussNewton, ComesBackFromTheEndOfARange) {
  const auto force = [](const UnitPoint& u, double stroke) {
    return std::pow(8.0, u[0]) * (1.0 - stroke) +
           2.0 * std::pow(4.0, u[1]) * std::pow(1.0 - 0.7 * stroke, -1.0 - 0.6 * u[2]);
  };
  for (const double tolerance : {0.05, 0.02})
    for (const UnitPoint& hidden : {UnitPoint{0.72, 0.25, 0.64}, UnitPoint{0.3, 0.8, 0.1}, UnitPoint{0.5, 0.55, 0.95},
                                    UnitPoint{0.85, 0.1, 0.5}}) {
      const SearchPath way =
          least_squares_path(stage_of(SearchMethod::kGaussNewton, 80), {0.5, 0.5, 0.5}, 0.01, [&](const UnitPoint& u) {
            std::vector<double> r;
            for (int k = 1; k <= 24; ++k) r.push_back((force(u, 0.0375 * k) - force(hidden, 0.0375 * k)) / tolerance);
            return r;
          });
      EXPECT_EQ(way.end, "within its precision") << hidden[0];
      for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(way.best[i], hidden[i], 1e-4);  // its precision
    }
}

// Searches by response surfaces: mbd_solver/campaign/calibrate/surrogate.cpp.

// Points of a lattice in the unit square, moved a little so that no three are in line.
std::vector<UnitPoint> scattered_points(int side) {
  std::vector<UnitPoint> points;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      points.push_back({(i + 0.3 * std::sin(7.0 * j + i)) / side, (j + 0.3 * std::cos(5.0 * i)) / side});
  return points;
}
std::vector<double> values_at(const std::vector<UnitPoint>& points, const std::function<double(double, double)>& f) {
  std::vector<double> values;
  for (const UnitPoint& u : points) values.push_back(f(u[0], u[1]));
  return values;
}
std::vector<UnitPoint> inner_points() {
  std::vector<UnitPoint> points;
  for (double x = 0.2; x < 0.75; x += 0.1)
    for (double y = 0.2; y < 0.75; y += 0.1) points.push_back({x, y});
  return points;
}

TEST(ResponseSurfaces, IsExactOnAPlane) {
  const auto plane = [](double x, double y) { return 3.0 + 2.0 * x - 5.0 * y; };
  const std::vector<UnitPoint> points = scattered_points(4), elsewhere = {{0.1, 0.9}, {2.0, -1.0}};
  const std::vector<double> s = response_surface(points, values_at(points, plane))(elsewhere);
  for (std::size_t i = 0; i < s.size(); ++i) EXPECT_NEAR(s[i], plane(elsewhere[i][0], elsewhere[i][1]), 1e-8);
}

// At least with the square of the distance of points.
TEST(ResponseSurfaces, ComesNearerWithMorePoints) {
  const auto f = [](double x, double y) { return std::sin(3.0 * x) * std::exp(-y); };
  double before = 0.0;
  for (const int side : {5, 10}) {
    const std::vector<UnitPoint> points = scattered_points(side);
    const std::vector<double> s = response_surface(points, values_at(points, f))(inner_points()),
                              truth = values_at(inner_points(), f);
    double error = 0.0;
    for (std::size_t i = 0; i < s.size(); ++i) error = std::max(error, std::abs(s[i] - truth[i]));
    if (side == 10) {
      EXPECT_LT(error, before / 4.0);
    }
    before = error;
  }
}

// Noise about a plane is not followed: between points the surface stays nearer to the plane than the points do.
TEST(ResponseSurfaces, SmoothsNoise) {
  const std::vector<UnitPoint> points = scattered_points(7);
  std::vector<double> values;
  double noise = 0.0;
  for (std::size_t j = 0; j < points.size(); ++j) {
    const double e = std::sin(12345.678 * static_cast<double>(j * j + 1));
    noise += e * e / static_cast<double>(points.size());
    values.push_back(4.0 * points[j][0] + e);
  }
  std::vector<UnitPoint> places;
  for (double x = 0.1; x < 0.85; x += 0.1) places.push_back({x, 0.45});
  const std::vector<double> s = response_surface(points, values)(places);
  double error = 0.0;
  for (std::size_t i = 0; i < s.size(); ++i) error += std::pow(s[i] - 4.0 * places[i][0], 2);
  EXPECT_LT(error / static_cast<double>(s.size()), 0.25 * noise);
}

TEST(ResponseSurfaces, OfFewPointsOrOfOneValueIsTheirMean) {
  const std::vector<UnitPoint> elsewhere = {{0.1, 0.2, 0.9}};
  EXPECT_DOUBLE_EQ(response_surface({{0.5, 0.5, 0.5}}, {7.0})(elsewhere)[0], 7.0);
  EXPECT_DOUBLE_EQ(response_surface({{0.5, 0.5, 0.5}, {0.1, 0.5, 0.5}}, {7.0, 8.0})(elsewhere)[0], 7.5);
  EXPECT_DOUBLE_EQ(
      response_surface(std::vector<UnitPoint>(9, {0.5, 0.5, 0.5}), std::vector<double>(9, 3.0))(elsewhere)[0], 3.0);
  EXPECT_DOUBLE_EQ(response_surface(std::vector<UnitPoint>(4), {1.0, 2.0, 3.0, 2.0})({{}})[0], 2.0)
      << "of no parameter";
}

// The quantiles of Student's distribution that tables print.
TEST(Quantiles, AreThoseOfTables) {
  EXPECT_NEAR(two_sided_quantile(0.95, 0), 1.959964, 1e-6);
  EXPECT_NEAR(two_sided_quantile(0.95, 1), 12.7062, 1e-4);
  EXPECT_NEAR(two_sided_quantile(0.99, 10), 3.1693, 1e-4);
}

// Ten parameters; each of eight numbers feels three of them, bends, and is wanted within bounds.
constexpr std::size_t kManyParameters = 10, kManyNumbers = 8;
UnitPoint bent_middle() { return UnitPoint(kManyParameters, 0.5); }
double bent_number(std::size_t k, const UnitPoint& u) {
  return std::sin(2.0 * u[k]) + u[k + 1] * u[k + 1] - u[(k + 5) % kManyParameters];
}
double bent_part(std::size_t k, double y) {  // met at a hidden set
  static const UnitPoint kHidden = {0.3, 0.7, 0.2, 0.6, 0.45, 0.8, 0.35, 0.25, 0.65, 0.55};
  const double off = (y - bent_number(k, kHidden)) / 0.1;
  return std::min(9.0, off * off);
}
double bent_misfit(const UnitPoint& u) {
  double sum = 0.0;
  for (std::size_t k = 0; k < kManyNumbers; ++k) sum += bent_part(k, bent_number(k, u));
  return sum;
}

SurrogateQueries questions_of(std::map<UnitPoint, bool>* known) {
  SurrogateQueries questions;
  for (std::size_t k = 0; k < kManyNumbers; ++k) questions.moved_by.push_back({k, k + 1, (k + 5) % kManyParameters});
  questions.part = bent_part;
  questions.numbers = [known](const UnitPoint& u) -> std::optional<std::vector<double>> {
    if (known && !known->count(u)) return {};
    std::vector<double> all;
    for (std::size_t k = 0; k < kManyNumbers; ++k) all.push_back(bent_number(k, u));
    return all;
  };
  return questions;
}

SearchPath surrogate_way(const SurrogateQueries& questions, int evaluations) {
  return surrogate_path(stage_of(SearchMethod::kSurrogate, evaluations), bent_middle(), questions);
}

TEST(ListedSets, AreSearchedInTheirOrderUpToTheFirstUnknown) {
  StageSpec stage = stage_of(SearchMethod::kListed, 3);
  stage.sets = {{0.1, 0.2}, {0.9, 0.9}, {0.5, 0.5}};
  SearchQueries queries;
  queries.misfit = [](const UnitPoint& u) -> std::optional<double> { return u[0] + u[1]; };
  const SearchPath all = search_path(stage, {0.0, 0.0}, 0.01, queries, 1);
  EXPECT_EQ(all.sets, stage.sets);
  EXPECT_EQ(all.best, stage.sets[0]);
  EXPECT_TRUE(all.requested.empty());
  queries.misfit = [&](const UnitPoint& u) -> std::optional<double> {
    if (u == stage.sets[1]) return {};
    return u[0] + u[1];
  };
  const SearchPath first = search_path(stage, {0.0, 0.0}, 0.01, queries, 1);
  EXPECT_EQ(first.sets, (std::vector<UnitPoint>{stage.sets[0]}));
  EXPECT_EQ(first.requested, (std::vector<UnitPoint>{stage.sets[1]}));
}

TEST(SurrogateSearch, IsBetterThanSimplicesInAsManySets) {
  const SearchPath way = surrogate_way(questions_of(nullptr), 40);
  SearchQueries blind;
  blind.misfit = bent_misfit;
  const SearchPath simplices = search_path(stage_of(SearchMethod::kSbplx, 40), bent_middle(), 0.01, blind, 1);
  EXPECT_EQ(way.sets.size(), 40u);
  EXPECT_DOUBLE_EQ(way.misfit, bent_misfit(way.best));
  EXPECT_LT(way.misfit, 0.2 * simplices.misfit) << simplices.misfit;
  for (const UnitPoint& u : way.sets)
    for (const double share : u) EXPECT_TRUE(share >= 0.0 && share <= 1.0);
}

TEST(SurrogateSearch, GoesTheSameWayHoweverOftenItBegins) {
  const SearchPath straight = surrogate_way(questions_of(nullptr), 30);
  std::map<UnitPoint, bool> known;
  SearchPath way;
  for (int round = 0; round < 100; ++round) {  // as a calibration that is killed after every set
    way = surrogate_way(questions_of(&known), 30);
    if (way.requested.empty()) break;
    ASSERT_EQ(way.requested.size(), 1u);
    known[way.requested.front()] = true;
  }
  EXPECT_EQ(way.sets, straight.sets);
  EXPECT_EQ(way.best, straight.best);
  EXPECT_EQ(way.end, "all evaluations done");
}

TEST(SurrogateSearch, UsesWhatIsKnownAndDoesNotAskForItAgain) {
  SurrogateQueries questions = questions_of(nullptr);
  questions.earlier = surrogate_way(questions, 30).sets;
  const SearchPath way = surrogate_way(questions, 10);
  for (std::size_t k = 1; k < way.sets.size(); ++k)
    EXPECT_EQ(std::count(questions.earlier.begin(), questions.earlier.end(), way.sets[k]), 0);
  EXPECT_LT(way.misfit, 0.5 * bent_misfit(bent_middle()));
}

TEST(SurrogateSearch, GoesAroundSetsWhoseRunsFail) {
  SurrogateQueries questions = questions_of(nullptr);
  const auto all = questions.numbers;
  questions.numbers = [all](const UnitPoint& u) { return u[0] > 0.6 ? std::vector<double>() : all(u); };
  const SearchPath way = surrogate_way(questions, 40);
  EXPECT_LE(way.best[0], 0.6);
  EXPECT_LT(way.misfit, bent_misfit(bent_middle()));
}

TEST(SurrogateSearch, KeepsConstraints) {
  SurrogateQueries questions = questions_of(nullptr);
  questions.allowed = [](const UnitPoint& u) { return u[0] + u[1] <= 1.0; };
  const SearchPath way = surrogate_way(questions, 40);
  for (std::size_t k = 1 + bent_middle().size() + 1; k < way.sets.size(); ++k)  // behind the hypercube
    EXPECT_LE(way.sets[k][0] + way.sets[k][1], 1.0);
}

// How far targets determine parameters: mbd_solver/campaign/calibrate/determination.h, on models that are formulas.

using Model = std::function<std::vector<double>(const std::vector<double>&)>;  // parameters -> y of the targets

CalibrationSpec spec_of(std::size_t parameters, const std::vector<double>& wanted, double tolerance) {
  CalibrationSpec spec;
  spec.step = 0.02;
  for (std::size_t i = 0; i < parameters; ++i) {
    CalibrationParameter p;
    p.name = "p" + std::to_string(i);
    p.least = 1.0;
    p.most = 10.0;
    p.scale = i % 2 == 0 ? RangeScale::kLogarithmic : RangeScale::kLinear;
    spec.parameters.push_back(p);
  }
  for (const double y : wanted) {
    TargetSpec t;
    t.value = y;
    t.tolerance = tolerance;
    spec.targets.push_back(t);
  }
  return spec;
}

EvaluatedPoint evaluated(const CalibrationSpec& spec, const Model& model, const UnitPoint& shares) {
  std::vector<double> p;
  for (std::size_t i = 0; i < shares.size(); ++i) p.push_back(spec.parameters[i].value(shares[i]));
  const std::vector<double> y = model(p);
  EvaluatedPoint e;
  e.point = shares;
  for (std::size_t t = 0; t < y.size(); ++t) {
    TargetResult r;
    r.values = {y[t]};
    r.spread = {0.0};
    r.residuals = {residual_of(spec.targets[t], y[t])};
    e.targets.push_back(r);
    e.misfit += r.misfit(spec.targets[t]);
  }
  return e;
}

Determination determined(const CalibrationSpec& spec, const Model& model, const UnitPoint& best) {
  std::vector<EvaluatedPoint> sets;
  for (const UnitPoint& set : difference_sets(spec, best)) sets.push_back(evaluated(spec, model, set));
  std::vector<const EvaluatedPoint*> around;
  for (const EvaluatedPoint& e : sets) around.push_back(&e);
  return determination_of(spec, evaluated(spec, model, best), around);
}

UnitPoint least_misfit(const CalibrationSpec& spec, const Model& model) {
  return least_squares_path(stage_of(SearchMethod::kGaussNewton, 500), UnitPoint(spec.parameters.size(), 0.5),
                            spec.step, [&](const UnitPoint& u) { return evaluated(spec, model, u).residuals(spec); })
      .best;
}

// Force of gas and damper over time, roughly: not linear in its parameters.
std::vector<double> decay(const std::vector<double>& p) {
  std::vector<double> y;
  for (int k = 0; k < 20; ++k) y.push_back(p[0] * std::exp(-0.02 * p[1] * k) + 0.3 * p[2] * k);
  return y;
}

// How often each interval holds what was hidden, of 400 repetitions with noise of `noise` tolerances.
std::vector<int> hits(double noise) {
  constexpr double kTolerance = 0.1;
  std::mt19937 random(20231);
  std::normal_distribution<double> normal(0.0, noise * kTolerance);
  std::uniform_real_distribution<double> anywhere(2.5, 8.0);
  std::vector<int> count(3, 0);
  for (int k = 0; k < 400; ++k) {
    const std::vector<double> hidden = {anywhere(random), anywhere(random), anywhere(random)};
    std::vector<double> measured = decay(hidden);
    for (double& y : measured) y += normal(random);
    const CalibrationSpec spec = spec_of(3, measured, kTolerance);
    const Determination d = determined(spec, decay, least_misfit(spec, decay));
    for (std::size_t i = 0; i < 3; ++i)
      count[i] += hidden[i] >= d.intervals[i].least && hidden[i] <= d.intervals[i].most;
  }
  return count;
}

// 380 of 400 expected, four standard deviations of that count are 17.
TEST(Determination, IntervalsHoldTheHiddenNumbersAsOftenAsTheySay) {
  for (const int count : hits(1.0)) {
    EXPECT_GE(count, 363);
    EXPECT_LE(count, 398);  // wider than asked, a little, where s2 is cut at 1
  }
}

TEST(Determination, IntervalsWidenWhereTheToleranceWasTooSmall) {
  for (const int count : hits(3.0)) EXPECT_GE(count, 363);
}

// y = A p: the interval is q sqrt((A' A)^-1) tolerance.
TEST(Determination, OfALinearModelIsExact) {
  const auto line = [](const std::vector<double>& p) {
    return std::vector<double>{2.0 * p[1], 0.5 * p[1] + 3.0 * std::log(p[0]), 4.0 * p[1] - std::log(p[0])};
  };
  const CalibrationSpec spec = spec_of(2, line({3.0, 4.0}), 0.05);
  const UnitPoint best = {spec.parameters[0].position(3.0), spec.parameters[1].position(4.0)};
  const Determination d = determined(spec, line, best);
  Eigen::Matrix<double, 3, 2> a;
  a << 0.0, 2.0, 3.0, 0.5, -1.0, 4.0;
  const Eigen::Matrix2d c = (a.transpose() * a).inverse() * 0.05 * 0.05;
  EXPECT_NEAR(d.intervals[0].most, 3.0 * std::exp(1.959964 * std::sqrt(c(0, 0))), 1e-5);
  EXPECT_NEAR(d.intervals[1].least, 4.0 - 1.959964 * std::sqrt(c(1, 1)), 1e-5);
  EXPECT_NEAR(d.correlation(0, 1), c(0, 1) / std::sqrt(c(0, 0) * c(1, 1)), 1e-5);
  EXPECT_NEAR(d.gain, 0.0, 1e-12);
  EXPECT_TRUE(d.loose.empty());
  EXPECT_EQ(d.intervals[0].is_determined(), "yes");
}

TEST(Determination, TellsWhatNothingHolds) {
  const auto product = [](const std::vector<double>& p) {
    return std::vector<double>{std::log(p[0]) + std::log(p[2])};
  };
  CalibrationSpec spec = spec_of(3, {2.5}, 0.01);
  const Determination d = determined(spec, product, least_misfit(spec, product));
  ASSERT_EQ(d.loose.size(), 2u);  // p1, and p0 against p2
  for (const Interval& interval : d.intervals) EXPECT_EQ(interval.is_determined(), "no");
  EXPECT_NEAR(d.correlation(0, 2), -1.0, 1e-3);
}

TEST(Determination, SaysWhenTheSearchHasNotEnded) {
  const CalibrationSpec spec = spec_of(3, decay({4.0, 4.0, 4.0}), 0.1);
  const UnitPoint best = {spec.parameters[0].position(4.0), spec.parameters[1].position(4.0) + 0.01,
                          spec.parameters[2].position(4.0)};
  const Determination d = determined(spec, decay, best);
  EXPECT_NEAR(d.gain / evaluated(spec, decay, best).misfit, 1.0, 0.05);  // nearly linear over so small a step
}

// The set next to a set that was run whole: mbd_solver/campaign/calibrate/determination.h.

// Two parameters with a range of 1; target 0 feels the first, target 1 both, target 2 the second.
struct WholeRun {
  CalibrationSpec spec;
  EvaluatedPoint whole;
  Eigen::MatrixXd sensitivity = Eigen::MatrixXd::Zero(3, 2);

  WholeRun() {
    spec.parameters.resize(2);
    spec.step = 0.3;
    for (CalibrationParameter& p : spec.parameters) p.most = 1.0;
    spec.targets.resize(3);
    for (TargetSpec& target : spec.targets) target.least = 0.0, target.most = 4.0, target.tolerance = 1.0;
    whole.point = {0.5, 0.5};
    sensitivity.row(0) << 10.0, 0.0;
    sensitivity.row(1) << 2.0, -4.0;
    sensitivity.row(2) << 0.0, 20.0;
  }
  void says(const std::vector<double>& values) {
    whole.targets.resize(values.size());
    for (std::size_t t = 0; t < values.size(); ++t) whole.targets[t].values = {values[t]};
  }
};

TEST(Adjusted, StaysWhereAllIsMetWithinTheBounds) {
  WholeRun run;
  run.says({2.0, 1.0, 3.0});
  EXPECT_EQ(adjusted(run.spec, run.whole, run.sensitivity), run.whole.point);
}

TEST(Adjusted, GoesWithinTheBoundsOfWhatWasLostAndKeepsTheRest) {
  WholeRun run;
  run.says({-1.0, 1.0, 3.0});
  const UnitPoint u = adjusted(run.spec, run.whole, run.sensitivity);
  const double a = u[0] - 0.5, b = u[1] - 0.5;
  for (const double y : {-1.0 + 10.0 * a, 1.0 + 2.0 * a - 4.0 * b, 3.0 + 20.0 * b})
    EXPECT_TRUE(y > 0.3 && y < 3.7) << y;
  EXPECT_NEAR(u[0], 0.65, 0.03);  // half a tolerance within the bound
  EXPECT_NEAR(u[1], 0.5, 0.02);
}

TEST(Adjusted, TakesNoLongWayForWhatIsOutOfReach) {
  WholeRun run;
  run.spec.cap = 3.0;
  run.says({2.0, 1.0, 300.0});
  EXPECT_EQ(adjusted(run.spec, run.whole, run.sensitivity), run.whole.point);
}

TEST(Adjusted, GoesNoFurtherThanTheDifferencesReach) {
  WholeRun run;
  run.spec.step = 0.05;
  run.says({-3.0, 1.0, 3.0});
  EXPECT_NEAR(adjusted(run.spec, run.whole, run.sensitivity)[0], 0.55, 1e-12);
}

TEST(Adjusted, KeepsConstraintsAndRanges) {
  WholeRun run;
  run.spec.parameters[0].name = "a";
  run.spec.constraints.resize(1);
  run.spec.constraints[0].formula = "a";
  run.spec.constraints[0].most = 0.55;
  run.says({-1.0, 1.0, 3.0});
  const UnitPoint u = adjusted(run.spec, run.whole, run.sensitivity);
  EXPECT_EQ(violation_of(run.spec, u), 0.0);
  EXPECT_LE(u[0], 0.55 + 1e-10);  // runs get ten digits
  EXPECT_GT(u[0], 0.5);
}

// Which targets come together: mbd_solver/campaign/calibrate/determination.h.

// Sets that meet these targets, of `targets` targets with weight 1.
struct SetsThatMeet {
  CalibrationSpec spec;
  std::vector<EvaluatedPoint> evaluations;
  std::vector<const EvaluatedPoint*> all;

  SetsThatMeet(std::size_t targets, const std::vector<std::vector<std::size_t>>& sets) {
    spec.targets.resize(targets);
    for (const std::vector<std::size_t>& met : sets) {
      EvaluatedPoint e;
      e.targets.resize(targets);
      for (TargetResult& target : e.targets) target.residuals = {5.0};
      for (const std::size_t t : met) e.targets[t].residuals = {0.0};
      e.misfit = 25.0 * static_cast<double>(targets - met.size());
      evaluations.push_back(e);
    }
    for (const EvaluatedPoint& e : evaluations) all.push_back(&e);
  }
};

TEST(Together, NamesWhatNoSetMeetsAndPairsThatNoneMeetsTogether) {
  const SetsThatMeet s(4, {{0, 1}, {1, 2}});
  const Conflicts found = conflicts_of(s.spec, s.all);
  EXPECT_EQ(found.never, std::vector<std::size_t>{3});
  ASSERT_EQ(found.pairs.size(), 1u);
  EXPECT_EQ(found.pairs[0].a, 0u);
  EXPECT_EQ(found.pairs[0].b, 2u);
}

TEST(Together, MostAreCountedByWeight) {
  SetsThatMeet s(4, {{0, 1}, {2, 3, 0}});
  s.spec.targets[2].weight = s.spec.targets[3].weight = 0.25;
  EXPECT_EQ(most_met(s.spec, s.all), s.all[0]);
  EXPECT_EQ(weight_met(s.spec, *s.all[1]), 1.5);
  s.spec.targets[3].weight = 1.0;
  EXPECT_EQ(most_met(s.spec, s.all), s.all[1]);
}

// mbd_solver/campaign/calibrate/evaluations.h: what runs said comes back to the last bit, and only as an answer to the same question; damage is named.

class LedgerOfRuns : public ::testing::Test, protected TemporaryFolder {
 protected:
  void SetUp() override {
    spec.scenes.resize(2);
    spec.scenes[0].name = "one", spec.scenes[1].name = "two";
    spec.metrics.resize(2);
    spec.metrics[0].name = "depth", spec.metrics[0].key = "max_sinkage_m";
    spec.metrics[1].name = "angle", spec.metrics[1].slope = {-0.2, -0.1};
    spec.targets.resize(2);
    spec.targets[0].metric = "depth", spec.targets[0].scene = "one", spec.targets[0].against = "two";
    spec.targets[1].metric = "angle", spec.targets[1].scene = "two";
  }

  RunRecords::Entry entry(const std::string& run, double depth, double angle) const {
    RunRecords::Entry e;
    e.run = run, e.wall = 1.5, e.cpu = 0.1 + 0.2;
    e.numbers.metrics = {{"depth", depth}};
    if (!std::isnan(angle)) e.numbers.metrics["angle"] = angle;
    return e;
  }
  void write_two() const {
    RunRecords ledger(spec, file);
    ledger.add("one", "recipe1", entry("one_1", 1.0 / 3.0, std::nan("")));
    ledger.add("two", "recipe2", entry("two_2", 2.0 / 3.0, M_PI));
    ledger.write();
  }

  CalibrationSpec spec;
  std::string file = TemporaryFolder::file("numbers.jsonl");
};

TEST_F(LedgerOfRuns, ComesBackToTheLastBit) {
  write_two();
  const RunRecords ledger(spec, file);
  const RunRecords::Entry* one = ledger.find("one", "recipe1");
  ASSERT_TRUE(one);
  EXPECT_EQ(one->run, "one_1");
  EXPECT_EQ(one->numbers.metrics.at("depth"), 1.0 / 3.0);
  EXPECT_EQ(one->numbers.metrics.count("angle"), 0u) << "not asked";
  EXPECT_EQ(one->cpu, 0.1 + 0.2);
  ASSERT_TRUE(ledger.find("two", "recipe2"));
  EXPECT_EQ(ledger.find("two", "recipe2")->numbers.metrics.at("angle"), M_PI);
  EXPECT_FALSE(ledger.find("one", "recipe2")) << "of another scene";
  EXPECT_FALSE(ledger.find("one", "")) << "a scene that cannot be read";
}

TEST_F(LedgerOfRuns, AnswersTheSameQuestionOnlyAndKeepsTheOthers) {
  write_two();
  CalibrationSpec other = spec;
  other.metrics[1].slope = {-0.3, -0.1};
  {
    RunRecords ledger(other, file);
    EXPECT_TRUE(ledger.find("one", "recipe1")) << "is not asked for the angle";
    EXPECT_FALSE(ledger.find("two", "recipe2"));
    ledger.add("two", "recipe2", entry("two_2", 0.5, 2.0));
    ledger.write();
  }
  EXPECT_EQ(RunRecords(other, file).find("two", "recipe2")->numbers.metrics.at("angle"), 2.0);
  EXPECT_EQ(RunRecords(spec, file).find("two", "recipe2")->numbers.metrics.at("angle"), M_PI);
}

TEST_F(LedgerOfRuns, CutAnywhereLosesTheLastLineAlone) {
  write_two();
  const std::string text = *read_whole_file(file);
  const std::size_t first = text.find('\n');
  for (std::size_t length = 0; length < text.size(); ++length) {
    std::ofstream(file) << text.substr(0, length);
    const RunRecords ledger(spec, file);
    EXPECT_EQ(ledger.find("one", "recipe1") != nullptr, length >= first) << length;
    EXPECT_EQ(ledger.find("two", "recipe2") != nullptr, length >= text.size() - 1) << length;
  }
}

TEST_F(LedgerOfRuns, DamageIsNamedByItsLine) {
  write_two();
  const std::string text = *read_whole_file(file);
  std::mt19937 random(7);
  int named = 0;
  for (int k = 0; k < 2000; ++k) {
    std::string damaged = text;
    for (int n = 0; n < 3; ++n) damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
    std::ofstream(file) << damaged;
    try {
      const RunRecords ledger(spec, file);
    } catch (const InputError& error) {
      ++named;
      EXPECT_NE(std::string(error.what()).find(file + ":"), std::string::npos) << error.what();
    }
  }
  EXPECT_GT(named, 500);
}

}  // namespace
}  // namespace footfall
