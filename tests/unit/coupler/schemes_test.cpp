// Every coupling scheme, both halves: coupler/schemes/registry.h lists them.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/messages.h"
#include "coupler/schemes/registry.h"
#include "tests/unit/coupler/random_boundary.h"

namespace footfall {
namespace {

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

// From the first match of `from` to the first `to` behind it.
std::string part(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t begin = text.find(from);
  EXPECT_NE(begin, std::string::npos) << "nothing begins with \"" << from << "\"";
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find(to, begin) - begin);
}

TEST(Schemes, HaveNamesOfTheirOwn) {
  const SchemeNames names(scheme_names().begin(), scheme_names().end());
  EXPECT_EQ(names.size(), scheme_names().size());
  for (const std::string& name : scheme_names()) EXPECT_EQ(make_scheme(name)->name(), name);
}

TEST(Schemes, EveryOneIsListedEverywhere) {
  const SchemeNames names(scheme_names().begin(), scheme_names().end());

  const std::string theory = part(file("docs/theory.md"), "| scheme | path in the window |", "\n\n");
  EXPECT_EQ(found(theory, "\n\\| `([a-z-]+)`"), names) << "the table of schemes in docs/theory.md";
  EXPECT_EQ(found(theory, "\n\\| `([a-z-]+)` \\(default\\)"), SchemeNames{std::string(kDefaultScheme)})
      << "docs/theory.md";

  const std::string key = part(file("inputs/reference/scene.toml"), "\nscheme = ", "\n[");
  const std::string line = part(key, "scheme = ", "\n");
  EXPECT_EQ(found(line, "\"([a-z-]+)\""), names) << "the comment of coupling.scheme in inputs/reference/scene.toml";
  EXPECT_NE(line.find("Default " + std::string(kDefaultScheme)), std::string::npos) << line;

  const std::string growth = part(file("docs/growth.md"), "| omega H |", "\n");
  EXPECT_EQ(found(growth.substr(11), " ([a-z-]+) \\|"), names) << "the columns of docs/growth.md";
}

TEST(Schemes, EveryOneHasItsPairOfFilesAndNoFileIsForgottenInTheRegistry) {
  SchemeNames in_files;
  for (const auto& entry : std::filesystem::directory_iterator(FOOTFALL_SOURCE_DIR "/coupler/schemes")) {
    if (entry.path().extension() != ".h") continue;
    const std::string stem = entry.path().stem().string();
    for (std::string name : found(file("coupler/schemes/" + stem + ".h"), "kName = \"([a-z-]+)\"")) {
      in_files.insert(name);
      EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(entry.path()).replace_extension(".cpp"))) << name;
      std::replace(name.begin(), name.end(), '-', '_');
      EXPECT_EQ(name, stem);
    }
  }
  EXPECT_EQ(in_files, SchemeNames(scheme_names().begin(), scheme_names().end()));
}

TEST(Schemes, AnUnknownNameIsToldAllKnownOnes) {
  try {
    make_scheme("css_trapezoid");
    FAIL() << "taken";
  } catch (const InputError& error) {
    for (const std::string& name : scheme_names())
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
  }
}

class BothHalves : public testing::TestWithParam<std::string> {
 protected:
  const std::unique_ptr<Scheme> scheme = make_scheme(GetParam());
  test::Random random{31};
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
  // A window that is short beside everything else is sent as computed.
  const double H = 1e-9, change = 1e-7;  // [s]; change: H/2 times accelerations of about 10
  sent = computed;
  scheme->set_path_rates(Matrix6d::Identity(), BodyLoad(), H, sent);
  EXPECT_LT((sent.dr - computed.dr).norm() + (sent.w - computed.w).norm() + (sent.da - computed.da).norm(), change);
}

TEST_P(BothHalves, ReactsExactlyWhenItWantsTheSlopes) {
  BodyLoad load;
  if (scheme->wants_tangent()) load.tangent.emplace_back();
  const PredictedPath path;
  EXPECT_EQ(scheme->reaction(Matrix6d::Identity(), load, path, 0.01).has_value(), scheme->wants_tangent());
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
  if (scheme->wants_tangent()) load.tangent.emplace_back().K(2, 2) = k;
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
      const double largest = map.eigenvalues().cwiseAbs().maxCoeff();
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

}  // namespace
}  // namespace footfall
