// Every coupling scheme of coupler/schemes/registry.h, both halves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "coupler/messages.h"
#include "coupler/schemes/registry.h"
#include "coupler/schemes/tangent.h"
#include "tests/support/linear_algebra.h"
#include "tests/support/refused.h"
#include "tests/unit/coupler/random_boundary.h"

namespace footfall {
namespace {

// Every coupling scheme, both halves: coupler/schemes/registry.h lists them.

using SchemeNames = std::set<std::string>;

std::string file(const std::string& path) {
  std::ifstream in(std::string(FOOTFALL_SOURCE_DIR) + "/" + path);
  EXPECT_TRUE(in) << path;
  return {std::istreambuf_iterator<char>(in), {}};
}

// The first group of every match of `pattern` in `text`.
SchemeNames found(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  SchemeNames names;
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it) names.insert((*it)[1]);
  return names;
}

TEST(Schemes, HaveNamesOfTheirOwn) {
  const SchemeNames names(scheme_names().begin(), scheme_names().end());
  EXPECT_EQ(names.size(), scheme_names().size());
  for (const std::string& name : scheme_names()) EXPECT_EQ(make_scheme(name)->name(), name);
}

TEST(Schemes, AreThoseOfTheReferenceScene) {
  const std::string scene = file("inputs/reference/scene.toml"), line = scene.substr(scene.find("\nscheme = ") + 1);
  EXPECT_EQ(found(line.substr(0, line.find('\n')), "\"([a-z-]+)\""),
            SchemeNames(scheme_names().begin(), scheme_names().end()));
  EXPECT_EQ(make_scheme(kDefaultScheme)->name(), kDefaultScheme);
}

TEST(Schemes, AnUnknownNameIsAnsweredWithAllKnownOnes) {
  const std::string said = test::error_of([] { make_scheme("css_trapezoid"); });
  for (const std::string& name : scheme_names()) EXPECT_TRUE(test::names(said, {name}));
}

class BothHalves : public testing::TestWithParam<std::string> {
 protected:
  const std::unique_ptr<Scheme> scheme = make_scheme(GetParam());
  test::RandomNumbers random{31};
};
std::string test_name(const testing::TestParamInfo<std::string>& scheme) {
  std::string name = scheme.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(Schemes, BothHalves, testing::ValuesIn(scheme_names()), test_name);

TEST_P(BothHalves, WeightsAreSharesOfAWhole) { EXPECT_EQ(scheme->weights().opening + scheme->weights().closing, 1.0); }

TEST_P(BothHalves, PathStartsAtTheState) {
  const BodyMotion start = random.motion(3);
  BodyMotion out(3);
  scheme->predict(start, 0.0, out);
  EXPECT_EQ(out.r, start.r);
  EXPECT_EQ(out.L, start.L);
  EXPECT_EQ(out.a, start.a);
}

TEST_P(BothHalves, OnlyRatesAreSentOtherwiseThanComputed) {
  const BodyMotion computed = random.motion(2);
  BodyMotion sent = computed;
  scheme->set_path_rates(Matrix6d::Identity(), BodyLoad(), 0.01, sent);
  EXPECT_EQ(sent.r, computed.r);
  EXPECT_EQ(sent.L, computed.L);
  EXPECT_EQ(sent.a, computed.a);
  // A window that is short against everything else is sent as computed.
  const double H = 1e-9, change = 1e-7;  // [s]; change: H/2 times accelerations of about 10
  sent = computed;
  scheme->set_path_rates(Matrix6d::Identity(), BodyLoad(), H, sent);
  EXPECT_LT((sent.dr - computed.dr).norm() + (sent.w - computed.w).norm() + (sent.da - computed.da).norm(), change);
}

TEST_P(BothHalves, ReactsExactlyWhenItWantsTheSlopes) {
  BodyLoad load;
  if (scheme->requires_tangent()) load.tangent.emplace_back();
  const PredictedPath path;
  EXPECT_EQ(scheme->reaction(Matrix6d::Identity(), load, path, 0.01).has_value(), scheme->requires_tangent());
}

// A spring k x resists a boundary that came at 0.1 m/s through two windows of 10 ms; it ends at x_p, and the body has
// been computed to x_c: k/2 (x_p^2 - x_c^2), which the force at the predicted end tells but for k/2 (x_p - x_c)^2.
TEST_P(BothHalves, OwesTheEnergyOfASpringBetweenPredictedAndComputed) {
  const double k = 1e5, x_p = 0.002, x_c = 0.0019;
  PredictedPath path;
  path.r_mean[2] = 0.0015;
  path.r_end[2] = x_p;
  BodyLoad load;
  MeanLoad before;
  load.mean.F_W[2] = -k * path.r_mean[2];
  before.F_W[2] = -k * 0.0005;
  if (scheme->requires_tangent()) load.tangent.emplace_back().K(2, 2) = k;
  BodyMotion computed;
  computed.r[2] = x_p;
  EXPECT_EQ(scheme->pending_work({load, before, 1.0}, path, computed), 0.0);
  computed.r[2] = x_c;
  EXPECT_NEAR(scheme->pending_work({load, before, 1.0}, path, computed), 0.5 * k * (x_p * x_p - x_c * x_c),
              0.5 * k * (x_p - x_c) * (x_p - x_c) * (1.0 + 1e-9));  // round-off
}

TEST_P(BothHalves, TheoryWithoutContactIsFreeFlight) {
  MapState z;
  z << 0.3, 0.2, 0.0, 0.3, 0.2;
  const MapState next = scheme->window_map(0.0, 4, z);
  EXPECT_NEAR(next[0], 0.5, 1e-15);
  EXPECT_NEAR(next[1], 0.2, 1e-15);
  EXPECT_EQ(next[2], 0.0);
}

TEST_P(BothHalves, TheoryIsLinear) {
  const double omega_h = 0.7, round_off = 1e-14;
  MapState y, z;
  random.fill(y);
  random.fill(z);
  const MapState together = scheme->window_map(omega_h, 3, y + 2.0 * z);
  const MapState apart = scheme->window_map(omega_h, 3, y) + 2.0 * scheme->window_map(omega_h, 3, z);
  EXPECT_LT((together - apart).norm(), round_off);
}

// Where two pairs coincide (quadratic, one substep, omega H = 1), the growth errs by 2e-6, and Eigen's eigenvalues by 2e-8.
TEST_P(BothHalves, GrowthIsTheLargestEigenvalueOfTheWindowMap) {
  for (const double omega_h : {0.0, 1e-3, 0.3, 1.0, 2.0, 5.0})
    for (const int n : {1, 7, 100}) {
      Eigen::MatrixXd map(5, 5);
      for (int k = 0; k < 5; ++k) map.col(k) = scheme->window_map(omega_h, n, MapState::Unit(k));
      const double largest = test::eigenvalues(map).cwiseAbs().maxCoeff();
      const bool twice = scheme->name() == "quadratic" && n == 1 && omega_h == 1.0;
      EXPECT_NEAR(predicted_growth(*scheme, omega_h, n), largest, (twice ? 5e-6 : 1e-10) * largest)
          << omega_h << ", " << n;
    }
}

// Fine steps: [1 - w^2/2, 1 - w^2/4; -w^2, 1 - w^2/2] has determinant 1, [1 - w^2/2, 1; -w^2, 1] has 1 + w^2/2.
TEST(WindowMap, CssTrapezoidKeepsAMotionAndFrozenPumpsIt) {
  const double w = 0.5;
  const double step_error = 1e-4;  // frozen has terms of 1/(2n)
  for (const int n : {65536, 100000}) {
    EXPECT_NEAR(predicted_growth(*make_scheme("css-trapezoid"), w, n), 1.0, step_error) << n;
    EXPECT_NEAR(predicted_growth(*make_scheme("frozen"), w, n), std::sqrt(1.0 + w * w / 2.0), step_error) << n;
  }
}

// Numbers of docs/explanation: theory 7.3, and omega H = 2.1 of coupling.md.
TEST(WindowMap, GrowthIsThatOfThePages) {
  const double digits = 0.005;  // of the pages, at most two after the point
  const auto expect = [&](const char* scheme, double omega_h, std::initializer_list<std::pair<int, double>> growths) {
    for (const auto& [n, growth] : growths)
      EXPECT_NEAR(predicted_growth(*make_scheme(scheme), omega_h, n), growth, digits) << scheme << ", " << n;
  };
  expect("css-trapezoid", 1.0, {{1, 1.138}, {3, 1.014}, {20, 1.0003}});
  expect("css", 1.0, {{1, 0.707}, {3, 0.885}, {20, 0.981}});
  expect("quadratic", 1.0, {{1, 0.707}, {3, 0.920}, {20, 0.930}});
  expect("css-trapezoid", 2.1, {{20, 1.87}});
  expect("frozen", 2.1, {{20, 1.79}});
  expect("tangent", 2.1, {{20, 0.63}});
}

// The scheme `tangent` on the body's side.

// [kg, kg m2]
Matrix6d inertia() {
  Vector6d diagonal;
  diagonal << 10.0, 10.0, 10.0, 0.1, 0.2, 0.3;
  return diagonal.asDiagonal();
}

ContactTangent along_z(double k) {
  ContactTangent slope;
  slope.K(2, 2) = k;
  return slope;
}

// A straight path from the origin at 0.1 m/s for 10 ms.
PredictedPath one_millimetre_up() {
  PredictedPath path;
  path.r_mean[2] = 0.0005;
  path.r_end[2] = 0.001;
  path.v_mean[2] = 0.1;
  return path;
}

TEST(MeanVelocity, WithoutContactIsThatOfConstantAcceleration) {
  Vector6d v_0 = Vector6d::Zero();
  v_0 << 1.0, 2.0, 3.0, 0.1, 0.0, 0.0;
  const Vector6d v = mean_velocity(inertia(), v_0, -10.0 * Vector6d::Unit(2), {}, 0.01);
  EXPECT_NEAR(v[2], 3.0 - 0.05, 1e-14);
  EXPECT_NEAR(v[0], 1.0, 1e-14);
  EXPECT_NEAR(v[3], 0.1, 1e-14);
}

TEST(MeanVelocity, MissesTheOscillatorByThirdOrder) {
  // 10 kg on 1e5 N/m, at x = 1 mm from rest: x = x0 cos(om t) + v0 / om sin(om t).
  const double om = 100.0, x0 = 1e-3, v0 = 0.2;
  const Vector6d v = v0 * Vector6d::Unit(2), a = -om * om * x0 * Vector6d::Unit(2);
  const auto error = [&](double H) {
    const double x = x0 * std::cos(om * H) + v0 / om * std::sin(om * H);
    return std::abs(H * mean_velocity(inertia(), v, a, along_z(1e5), H)[2] - (x - x0));
  };
  EXPECT_NEAR(std::log2(error(2e-3) / error(1e-3)), 3.0, 0.15);
}

TEST(MeanVelocity, OnStiffContactLeadsToWhereTheyBalance) {
  // L-stable: what is missing is of the size v0 / (omega^2 H), here 2 % of x0 at omega H = 100.
  const double om = 100.0, x0 = 1e-3, v0 = 0.2;
  const Vector6d v = v0 * Vector6d::Unit(2), a = -om * om * x0 * Vector6d::Unit(2);
  for (const double H : {1.0, 10.0})
    EXPECT_NEAR(H * mean_velocity(inertia(), v, a, along_z(1e5), H)[2], -x0, 6.0 * v0 / (om * om * H));
}

TEST(TangentLoad, DampsOnlyWhatTheWindowDoesNotResolve) {
  // Damping ratio C omega / (2 K) with omega = omega_h / H.
  const auto ratio = [&](double omega_h) {
    return tangent_load(along_z(1e5), PredictedPath(), omega_h, 0.01).C(2, 2) * omega_h / 0.01 / 2e5;
  };
  EXPECT_NEAR(ratio(0.2), std::pow(0.1, 7) / 2.0, 1e-12);
  EXPECT_NEAR(ratio(20.0), 5.0, 1e-4);
}

TEST(SurplusImpulse, IsZeroOnThePredictedPathAndTheSpringsPushBesideIt) {
  BodyMotion start;
  start.dr[2] = 0.1;
  const TangentLoad load = tangent_load(along_z(1e5), one_millimetre_up(), 0.0, 0.01);
  BodyMotion end = start;
  end.r[2] = 0.001;
  EXPECT_LT(surplus_impulse(load, start, end, 0.01).norm(), 1e-12);
  // Stopped at once: it stays 0.5 mm behind the mean, where the spring pushes by 50 N more.
  start.dr[2] = end.dr[2] = end.r[2] = 0.0;
  EXPECT_NEAR(surplus_impulse(load, start, end, 0.01)[2], 0.01 * 50.0, 1e-9);
}

}  // namespace
}  // namespace footfall
