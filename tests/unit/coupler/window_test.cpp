#include "coupler/window.h"

#include <gtest/gtest.h>

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/schemes/registry.h"
#include "tests/unit/coupler/random_boundary.h"

namespace footfall {
namespace {

using test::Random;

constexpr int kSubsteps = 40;
constexpr double kDt = 1e-3;  // [s]

class EveryScheme : public testing::TestWithParam<std::string> {};
std::string of_scheme(const testing::TestParamInfo<std::string>& scheme) {
  std::string name = scheme.param;
  for (char& c : name)
    if (c == '-') c = '_';
  return name;
}
INSTANTIATE_TEST_SUITE_P(Schemes, EveryScheme, testing::ValuesIn(scheme_names()), of_scheme);

// A path that stands a little beside the state that the next window starts from.
struct Beside {
  explicit Beside(const std::string& scheme_name, int modes) : scheme(make_scheme(scheme_name)), random(21) {
    start = random.motion(modes);
    BodyMotion stands = start;
    stands.r += 1e-3 * random.vector();
    stands.L = turned(stands.L, 1e-2 * random.vector());
    stands.a += 1e-3 * Eigen::VectorXd::Ones(modes);
    path = std::make_unique<BoundaryPath>(*scheme, stands);
  }
  std::unique_ptr<Scheme> scheme;
  Random random;
  BodyMotion start;
  std::unique_ptr<BoundaryPath> path;
};

TEST_P(EveryScheme, PredictsVelocitiesThatAreTheRatesOfItsPositions) {
  const std::unique_ptr<Scheme> scheme = make_scheme(GetParam());
  Random random(22);
  const BodyMotion start = random.motion(3);
  const double tau = 0.07, h = 1e-5;  // difference error h^2 = 1e-10 times third derivatives of about 100
  BodyMotion before(3), here(3), after(3);
  scheme->predict(start, tau - h, before);
  scheme->predict(start, tau, here);
  scheme->predict(start, tau + h, after);
  EXPECT_LT(((after.r - before.r) / (2 * h) - here.dr).norm(), 1e-7);
  EXPECT_LT((rotation_vector(before.L, after.L) / (2 * h) - here.w).norm(), 1e-7);
  EXPECT_LT(((after.a - before.a) / (2 * h) - here.da).norm(), 1e-7);
}

TEST_P(EveryScheme, PathEndsAtThePrediction) {
  Beside b(GetParam(), 2);
  b.path->begin_window(b.start, kSubsteps, kDt);
  for (int i = 0; i < kSubsteps; ++i) b.path->advance();
  BodyMotion end(2);
  b.scheme->predict(b.start, kSubsteps * kDt, end);
  EXPECT_LT((b.path->pose().r - end.r).norm(), 1e-15);
  EXPECT_LT(rotation_vector(b.path->pose().L, end.L).norm(), 1e-15);
  EXPECT_LT((b.path->pose().a - end.a).norm(), 1e-15);
  EXPECT_EQ(b.path->substeps_left(), 0);
}

TEST_P(EveryScheme, StepsAndJumpAddUpToTheWholeWay) {
  Beside b(GetParam(), 2);
  const BodyMotion stood = b.path->pose();
  b.path->begin_window(b.start, kSubsteps, kDt);
  Eigen::Vector3d way = b.path->jump().r;
  Eigen::VectorXd modal = b.path->jump().a;
  Eigen::Vector4d L = turned(stood.L, b.path->jump().theta_W);
  for (int i = 0; i < kSubsteps; ++i) {
    b.path->advance();
    way += b.path->last_step().r;
    modal += b.path->last_step().a;
    L = turned(L, b.path->last_step().theta_W);
  }
  EXPECT_LT((stood.r + way - b.path->pose().r).norm(), 1e-14);
  EXPECT_LT((stood.a + modal - b.path->pose().a).norm(), 1e-14);
  EXPECT_LT(rotation_vector(L, b.path->pose().L).norm(), 1e-14);
}

TEST_P(EveryScheme, OnlyTheFrozenBoundaryJumps) {
  Beside b(GetParam(), 2);
  b.path->begin_window(b.start, kSubsteps, kDt);
  EXPECT_EQ(b.path->jump().r.norm() > 0.0, GetParam() == "frozen");
}

TEST_P(EveryScheme, PathVelocityIsTheRateOfThePathAfterItsJump) {
  Beside b(GetParam(), 2);
  // Substeps so short that the central difference is exact to h^2 times the third derivatives: 1e-10 * 1e3.
  constexpr int kFine = 4000;
  b.path->begin_window(b.start, kFine, kSubsteps * kDt / kFine);
  const double h = kSubsteps * kDt / kFine;
  for (int i = 0; i < 1500; ++i) b.path->advance();
  const BodyMotion before = b.path->pose();
  b.path->advance();
  const BodyMotion here = b.path->pose();
  b.path->advance();
  const BodyMotion after = b.path->pose();
  EXPECT_LT(((after.r - before.r) / (2 * h) - here.dr).norm(), 1e-7);
  EXPECT_LT((rotation_vector(before.L, after.L) / (2 * h) - here.w).norm(), 1e-7);
  EXPECT_LT(((after.a - before.a) / (2 * h) - here.da).norm(), 1e-7);
}

TEST(BoundaryPath, KeepsTheMeanPositionOfThePredictionWhileItClosesTheGap) {
  Beside b("css-trapezoid", 0);
  constexpr int kFine = 2000;  // trapezoid error of the mean: gap / kFine^2 = 1e-9 of the gap of 1e-3
  b.path->begin_window(b.start, kFine, kSubsteps * kDt / kFine);
  Eigen::Vector3d mean = 0.5 * b.path->pose().r;
  for (int i = 0; i < kFine; ++i) {
    b.path->advance();
    mean += (i + 1 < kFine ? 1.0 : 0.5) * b.path->pose().r;
  }
  BodyMotion middle;
  b.scheme->predict(b.start, 0.5 * kSubsteps * kDt, middle);
  EXPECT_LT((mean / kFine - middle.r).norm(), 1e-9);
}

TEST(BoundaryPath, AddsUpASteadyTranslationAsLiggghtsDoes) {
  const std::unique_ptr<Scheme> scheme = make_scheme("css-trapezoid");
  const Eigen::Vector3d v(0.1, -0.3, -1.0);
  const double dt = 5e-5;
  BodyMotion state;
  state.r = {0.1, 0.2, 0.24};
  state.dr = v;
  BoundaryPath path(*scheme, state);
  Eigen::Vector3d sum = state.r;
  for (int window = 0; window < 2000; ++window) {
    BodyMotion start = state;
    start.r = state.r + (window * 5 * dt) * v;  // adds up in another way: differs by round-off
    path.begin_window(start, 5, dt);
    ASSERT_TRUE(path.steady_translation());
    for (int i = 0; i < 5; ++i) {
      path.advance();
      for (int c = 0; c < 3; ++c) sum[c] += v[c] * dt;
    }
    ASSERT_EQ(path.pose().r, sum) << "window " << window;
  }
}

TEST(BoundaryPath, IsNotSteadyWhenItTurnsDeformsAcceleratesOrLags) {
  const std::unique_ptr<Scheme> linear = make_scheme("css-trapezoid"), quadratic = make_scheme("quadratic");
  BodyMotion state(1);
  state.r = {1, 0, 0};
  state.dr = {0, 0, 1};
  const auto steady = [&](const Scheme& scheme, const BodyMotion& start) {
    BoundaryPath path(scheme, state);
    path.begin_window(start, 10, 1e-4);
    return path.steady_translation();
  };
  EXPECT_TRUE(steady(*linear, state));
  EXPECT_TRUE(steady(*quadratic, state));
  BodyMotion changed = state;
  changed.w = {0, 1e-30, 0};
  EXPECT_FALSE(steady(*linear, changed));
  changed = state;
  changed.da[0] = 1e-30;
  EXPECT_FALSE(steady(*linear, changed));
  changed = state;
  changed.ddr = {0, 1, 0};
  EXPECT_TRUE(steady(*linear, changed));
  EXPECT_FALSE(steady(*quadratic, changed));
  changed = state;
  changed.r[0] += 1e-9;
  EXPECT_FALSE(steady(*linear, changed));
}

TEST(Scheme, UnknownNameIsRefusedAndTheKnownOnesAreNamed) {
  try {
    make_scheme("css_trapezoid");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("css-trapezoid, css, quadratic, tangent, frozen"), std::string::npos);
  }
  EXPECT_EQ(make_scheme(kDefaultScheme)->name(), kDefaultScheme);
}

TEST(Scheme, QuadraticPredictionIsThirdOrderInPositionOfASmoothMotion) {
  // Circle of radius 1 with the body turning along: error of r in tau^3 / 6, of the turn in zero (constant
  // w).
  const std::unique_ptr<Scheme> scheme = make_scheme("quadratic");
  const auto exact = [](double t, BodyMotion& m) {
    m.r = {std::cos(t), std::sin(t), 0.0};
    m.dr = {-std::sin(t), std::cos(t), 0.0};
    m.ddr = -m.r;
    m.L = turned(Eigen::Vector4d(1, 0, 0, 0), {0, 0, t});
    m.w = {0, 0, 1};
  };
  BodyMotion start, predicted, truth;
  exact(0.3, start);
  const auto error = [&](double tau) {
    scheme->predict(start, tau, predicted);
    exact(0.3 + tau, truth);
    EXPECT_LT(rotation_vector(truth.L, predicted.L).norm(), 1e-14);
    return (truth.r - predicted.r).norm();
  };
  EXPECT_NEAR(std::log2(error(0.02) / error(0.01)), 3.0, 0.01);
}

}  // namespace
}  // namespace footfall
