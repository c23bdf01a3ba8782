// Drawn runs: distributions, intervals and corrections with known answers.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <csignal>
#include <numeric>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/campaign/campaign.h"
#include "mbd_solver/campaign/campaign_page.h"
#include "mbd_solver/campaign/sampling.h"
#include "mbd_solver/campaign/statistics.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/session/output/history.h"
#include "mbd_solver/session/run_scene.h"
#include "mbd_solver/studies/metrics.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/campaign/drawn_parameters.h"

namespace footfall {
namespace {

double mean(const std::vector<double>& x) {
  return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

double deviation(const std::vector<double>& x) {
  double sum = 0.0;
  for (const double value : x) sum += std::pow(value - mean(x), 2);
  return std::sqrt(sum / static_cast<double>(x.size()));
}

// Of an even number of values the mean of the middle two, as of any share that ends between two.
TEST(Quantile, LiesBetweenValuesWhereTheShareEndsThere) {
  EXPECT_EQ(quantile({4, 1, 3, 2}, 0.5), 2.5);
  EXPECT_EQ(quantile({4, 1, 3}, 0.5), 3);
  EXPECT_EQ(quantile({7}, 0.5), 7);
  std::vector<double> hundred(100);
  std::iota(hundred.begin(), hundred.end(), 1.0);
  EXPECT_EQ(quantile(hundred, 0.05), 5.5);
  EXPECT_EQ(quantile(hundred, 0.99), 99.5);
  EXPECT_EQ(quantile(hundred, 0.994), 100);
  EXPECT_EQ(quantile({}, 0.5), 0);
}

// A Latin hypercube of 2000 has the moments of a distribution to about 1 / 2000 of its width; 2 % leave room for tails.
TEST(DrawnRuns, OfEveryDistributionHaveItsMoments) {
  std::vector<ParameterSpec> p = {drawn("n", DistributionKind::kNormal),
                                  drawn("t", DistributionKind::kNormal),
                                  uniform("u", 1.0, 3.0),
                                  drawn("r", DistributionKind::kTriangular),
                                  drawn("w", DistributionKind::kWeibull),
                                  drawn("d", DistributionKind::kDiscrete),
                                  drawn("m", DistributionKind::kMeasured)};
  p[0].distribution.mean = 2.0, p[0].distribution.deviation = 0.5;
  p[1].distribution.mean = 0.0, p[1].distribution.deviation = 1.0, p[1].distribution.least = 0.0;
  p[3].distribution.least = 0.0, p[3].distribution.likely = 1.0, p[3].distribution.most = 5.0;
  p[4].distribution.scale = 2.0, p[4].distribution.shape = 2.0;
  p[5].choices = {{"1", "", {}}, {"2", "", {}}};
  p[5].distribution.weights = {3.0, 1.0};
  p[6].distribution.measured = {1.0, 2.0, 6.0};
  const Draws draws(drawn_sweep(p, 2000, Design::kLatinHypercube));
  const double means[] = {2.0, std::sqrt(2.0 / kPi), 2.0, 2.0, 2.0 * std::sqrt(kPi) / 2.0, 0.25, 3.0};
  const double deviations[] = {0.5,
                               std::sqrt(1.0 - 2.0 / kPi),
                               1.0 / std::sqrt(3.0),
                               std::sqrt((25.0 + 1.0 - 5.0) / 18.0),
                               2.0 * std::sqrt(1.0 - kPi / 4.0),
                               std::sqrt(3.0) / 4.0,
                               std::sqrt(14.0 / 3.0)};
  for (std::size_t k = 0; k < p.size(); ++k) {
    EXPECT_NEAR(mean(column(draws, k)), means[k], 0.02 * means[k]) << p[k].name;
    EXPECT_NEAR(deviation(column(draws, k)), deviations[k], 0.02 * deviations[k]) << p[k].name;
  }
  EXPECT_GE(*std::min_element(draws.values(0).begin(), draws.values(0).end()), 0.0);
}

// Of the values themselves, also above a threshold.
TEST(DrawnRuns, OfALognormalDistributionHaveTheMomentsOfTheFile) {
  ParameterSpec p = drawn("l", DistributionKind::kLognormal), above = p;
  p.distribution.mean = 3.0, p.distribution.deviation = 1.5;
  above.distribution.mean = 3.0, above.distribution.deviation = 1.0, above.distribution.least = 1.0;
  const Draws draws(drawn_sweep({p, above}, 4000, Design::kLatinHypercube));
  for (const std::size_t k : {0, 1}) EXPECT_NEAR(mean(column(draws, k)), 3.0, 0.01);
  EXPECT_NEAR(deviation(column(draws, 0)), 1.5, 0.05);
  EXPECT_NEAR(deviation(column(draws, 1)), 1.0, 0.04);
  std::vector<double> logs;
  for (const double value : column(draws, 1)) logs.push_back(std::log(value - 1.0));
  EXPECT_NEAR(deviation(logs), std::sqrt(std::log(1.25)), 0.01);  // sigma^2 = log(1 + (s / m)^2)
}

// Pairs that a table has, and no others; the correlation equals the table's.
TEST(DrawnRuns, OfWholeRowsKeepWhatBelongsTogether) {
  ParameterSpec x = drawn("x", DistributionKind::kMeasured), y = drawn("y", DistributionKind::kMeasured), alone = x;
  x.distribution.file = y.distribution.file = "touchdowns.csv";
  x.distribution.whole_rows = y.distribution.whole_rows = true;
  x.distribution.measured = {3.0, 1.0, 2.0, 5.0};
  y.distribution.measured = {-3.0, -1.0, -2.0, -5.0};
  alone.name = "z";
  alone.distribution.measured = y.distribution.measured;
  const Draws draws(drawn_sweep({x, y, alone}, 400));
  std::set<double> seen;
  int unlike = 0;
  for (std::size_t i = 0; i < draws.count(); ++i) {
    EXPECT_EQ(draws.values(i)[0], -draws.values(i)[1]);
    EXPECT_NEAR(draws.positions(i)[0], 1.0 - draws.positions(i)[1], 1e-12);
    seen.insert(draws.values(i)[0]);
    unlike += draws.values(i)[0] != -draws.values(i)[2] ? 1 : 0;
  }
  EXPECT_EQ(seen.size(), 4U);
  EXPECT_NEAR(unlike, 300, 40);  // three of four; deviation 9
  EXPECT_FALSE(draws.independent());
}

TEST(DrawnRuns, OfALatinHypercubeFillEverySliceOnce) {
  const Draws draws(drawn_sweep({uniform("a", 0.0, 100.0), uniform("b", 0.0, 100.0)}, 100, Design::kLatinHypercube));
  for (const std::size_t k : {0, 1}) {
    std::set<int> slices;
    for (const double value : column(draws, k)) slices.insert(static_cast<int>(value));
    EXPECT_EQ(slices.size(), 100U);
  }
}

TEST(DrawnRuns, OfSobolHaveTheMeanOfASmoothFunctionToAThousandth) {
  const Draws draws(drawn_sweep({uniform("a", 0.0, 1.0), uniform("b", 0.0, 1.0)}, 1024, Design::kSobol));
  double sum = 0.0;
  for (std::size_t i = 0; i < draws.count(); ++i) sum += draws.values(i)[0] * draws.values(i)[1];
  EXPECT_NEAR(sum / 1024.0, 0.25, 1e-3);  // random draws: 0.007
}

TEST(DrawnRuns, OfARandomDesignDoNotDependOnTheNumberOfRuns) {
  const std::vector<ParameterSpec> p = {uniform("a", 0.0, 1.0)};
  const Draws few(drawn_sweep(p, 10)), many(drawn_sweep(p, 1000));
  std::set<std::uint32_t> seeds;
  for (std::size_t i = 0; i < few.count(); ++i) EXPECT_EQ(few.values(i), many.values(i));
  for (std::size_t i = 0; i < many.count(); ++i) seeds.insert(many.seed(i));
  EXPECT_EQ(seeds.size(), many.count());
  EXPECT_NE(Draws(drawn_sweep(p, 10, Design::kRandom, 2)).values(0), few.values(0));
}

TEST(DrawnRuns, OfCorrelatedParametersHaveTheRankAskedFor) {
  SweepSpec spec = drawn_sweep({uniform("a", 0.0, 1.0), uniform("b", -4.0, 9.0)}, 4000);
  spec.correlations = {{{"b", "a"}, 0.7, {}}};
  const Draws draws(spec);
  std::vector<std::vector<double>> x;
  for (std::size_t i = 0; i < draws.count(); ++i) x.push_back({draws.positions(i)[0]});
  EXPECT_NEAR(rank_correlations(x, column(draws, 1))[0], 0.7, 0.025);  // 3 (1 - r^2) / sqrt(4000)
  spec.parameters.push_back(uniform("c", 0.0, 1.0));
  spec.correlations = {{{"a", "b"}, 0.9, {}}, {{"b", "c"}, 0.9, {}}, {{"a", "c"}, -0.9, {}}};
  EXPECT_THROW(Draws{spec}, InputError);
}

TEST(IntervalsOfAQuantile, CoverTheMedianInNinetyFiveOfAHundredCampaigns) {
  int covered = 0;
  for (int seed = 1; seed <= 200; ++seed) {
    std::vector<double> a = column(Draws(drawn_sweep({uniform("a", 0.0, 1.0)}, 101, Design::kRandom, seed)), 0);
    std::sort(a.begin(), a.end());
    const auto [low, high] = quantile_bounds(a.size(), 0.5);
    covered += a[low] <= 0.5 && 0.5 <= a[high] ? 1 : 0;
  }
  EXPECT_NEAR(covered / 200.0, 0.95, 0.045);        // three deviations; the places are whole, so that it is a bit above
  EXPECT_EQ(quantile_bounds(10, 0.99).second, 10);  // no bound above
}

// The boundary of a certain event, which separates the runs: within its band in 95 of 100 campaigns or more.
TEST(BoundariesOf, AnEventThatIsCertainAreWithinTheirBand) {
  int within = 0;
  double width = 0.0;
  for (int seed = 1; seed <= 100; ++seed) {
    const std::vector<double> v = column(Draws(drawn_sweep({uniform("v", -1.0, 1.0)}, 100, Design::kRandom, seed)), 0);
    Eigen::MatrixXd x(100, 3);
    Eigen::VectorXd y(100);
    for (Eigen::Index i = 0; i < 100; ++i) {
      const double u = v[i];
      x.row(i) << 1.0, u, u * u;
      y[i] = u > -0.04 ? 1.0 : 0.0;
    }
    const Logistic fit = fit_logistic(x, y);
    const Eigen::Vector3d at(1.0, -0.04, 0.0016);
    within += std::abs(fit.score(at)) < 1.96 * fit.deviation(at) ? 1 : 0;
    // Where the band ends, about.
    const Eigen::Vector3d slope(0.0, 1.0, -0.08);
    width += 2.0 * 1.96 * fit.deviation(at) / slope.dot(fit.b) / 100.0;
  }
  EXPECT_GE(within, 90);
  EXPECT_LT(width, 0.3);  // of a range of 2: it says something
}

// Bisection of the scene: sqrt(2 g (r - h) (k^2 + r^2)) / h.
TEST(TipOver, OfAPlaneBodyBeginsAtTheSpeedOfTheClosedForm) {
  const double h = 1.5, r = std::sqrt(2.0) * 1.5, k = 1.0, g = 1.62;
  const double exact = std::sqrt(2.0 * g * (r - h) * (k * k + r * r)) / h;
  EXPECT_NEAR(exact, 2.218, 5e-4);
  const TemporaryFolder folder;
  const std::string out = folder.file("run");
  double low = 1.5, high = 3.0;
  const volatile std::sig_atomic_t never = 0;
  while (high - low > 1e-3) {
    const double v = 0.5 * (low + high);
    const Scene scene = read_scene(FOOTFALL_SOURCE_DIR "/inputs/tip_over/scene.toml",
                                   {"initial.velocity=[" + std::to_string(v) + ",0,0]"});
    RunOptions options;
    options.out = out;
    options.quiet = true;
    options.keep_every = 0.0;
    ASSERT_EQ(run_scene(scene, options, nullptr, never), kExitDone);
    const History history = read_history(out + "/history.csv");
    const std::vector<double>& turn = history.column("foot.angle");
    (*std::max_element(turn.begin(), turn.end()) > kPi / 4.0 ? high : low) = v;
  }
  EXPECT_NEAR(0.5 * (low + high), exact, 0.002 * exact);
}

class CampaignOfTheTipOver : public ::testing::Test {
 protected:
  SweepSpec spec_ = read_sweep_file(FOOTFALL_SOURCE_DIR "/inputs/sweeps/tip_over_plane.toml");
};

TEST_F(CampaignOfTheTipOver, EndsAtTheSameDrawInWhateverOrderRunsEnd) {
  spec_.until_width = 0.2;
  Campaign forward(spec_, false), backward(spec_, false);
  const auto done = [&](const Campaign& c, std::size_t k) {
    return CampaignRow{0, "", {c.draws().values(k)[0] > 2.2 ? 2.0 : 0.5}, {}};
  };
  for (std::size_t k = 0; k < forward.size(); ++k) forward.set(k, done(forward, k));
  for (std::size_t k = backward.size(); k-- > 0;) backward.set(k, done(backward, k));
  EXPECT_TRUE(forward.stopped_early());
  EXPECT_LT(forward.used(), forward.draws().count());
  EXPECT_EQ(forward.used(), backward.used());
  EXPECT_LE(forward.tally(0, 0).probability().width(), 0.2);
}

TEST_F(CampaignOfTheTipOver, IsNotEndedByAFirstDrawThatTheSceneRefuses) {
  spec_.settings.push_back("bodies.body.mass={= row < 1 ? -1 : 1000}");
  const Campaign campaign(spec_, true);
  EXPECT_EQ(campaign.first_valid(0).first.name, campaign.name(campaign.cases()));
  EXPECT_FALSE(campaign.recipe().empty());
  spec_.settings.push_back("bodies.body.mass=-1");
  EXPECT_THROW(Campaign(spec_, true).recipe(), InputError) << "all draws are refused";
}

// From the draw to the scene, the outcome and the table.
TEST_F(CampaignOfTheTipOver, HasTheSameBitsInTheDrawTheRunTheOutcomeAndTheTable) {
  spec_.settings.push_back("end_time={= exp(v) / 3}");
  spec_.outcomes.resize(1);
  spec_.outcomes[0].name = "differs";
  spec_.outcomes[0].when = "turn != exp(v) / 3";
  const Campaign campaign(spec_, false), resumed(spec_, false);
  int of_more_than_ten_digits = 0;
  for (std::size_t row = 0; row < campaign.size(); ++row) {
    const double v = campaign.draws().values(row)[0];
    const RunRequest request = campaign.request(row);
    const Scene scene = read_scene(request.scene, request.settings);
    EXPECT_EQ(scene.initial.velocity.x(), v);
    EXPECT_EQ(scene.end_time, std::exp(v) / 3.0);
    EXPECT_EQ(campaign.outcomes_of(row, {scene.end_time}), std::vector<int>{0});
    EXPECT_EQ(read_number(campaign.drawn_values(row)[0].c_str(), nullptr), v);
    EXPECT_EQ(resumed.draws().values(row)[0], v);
    of_more_than_ten_digits += number_text(v, 10) != exact_text(v) ? 1 : 0;
  }
  EXPECT_GT(of_more_than_ten_digits, 190) << "of 200 draws";
}

TEST(CampaignRow, OfAProgramThatWasEndedFromOutsideIsNoResult) {
  for (const int code : {3, 128, 128 + SIGKILL, 128 + SIGTERM, 128 + SIGSEGV})
    EXPECT_TRUE((CampaignRow{code, "", {}, {}}.is_lost())) << code;
  for (const int code : {-1, 0, 1, 2, 124}) EXPECT_FALSE((CampaignRow{code, "", {}, {}}.is_lost())) << code;
}

TEST_F(CampaignOfTheTipOver, HasItsBoundaryWithinTheBand) {
  Campaign campaign(spec_, false);
  const double exact = 2.218;
  for (std::size_t k = 0; k < campaign.size(); ++k)
    campaign.set(k, {0, "", {campaign.draws().values(k)[0] > exact ? 2.0 : 0.5}, {}});
  const std::vector<Boundary::Crossing> at = boundary_of(campaign, spec_.envelopes[0], 0).middle();
  ASSERT_EQ(at.size(), 1U);
  EXPECT_LT(at[0].low, exact);
  EXPECT_GT(at[0].high, exact);
  EXPECT_NEAR(at[0].x, exact, 0.02 * exact);
}

// The value of a requirement is a metric, and missing it an outcome with a probability.
TEST_F(CampaignOfTheTipOver, ReportsRequirementsOfTheSceneWithTheirProbability) {
  const TemporaryFolder folder;
  spec_.scene = folder.write("scene.toml", "base = \"" FOOTFALL_SOURCE_DIR
                                           "/inputs/tip_over/scene.toml\"\n[[requirements]]\nname = \"turns little\"\n"
                                           "value = \"foot.angle.max\"\nunit = \"rad\"\nmost = 0.7\n");
  spec_.runs = 10;
  const SweepSpec spec = with_requirements(spec_, false);
  ASSERT_EQ(spec.metrics.size(), spec_.metrics.size() + 1);
  EXPECT_EQ(spec.metrics.back().requirement, "turns little");
  Campaign campaign(spec, false);
  for (std::size_t k = 0; k < campaign.size(); ++k) {
    const double turn = k < 4 ? 0.8 : k < 9 ? 0.6 : NAN;
    campaign.set(k, {0, "", {turn, turn}, {}});
  }
  const Tally& tally = campaign.tally(0, spec.outcomes.size() - 1);
  EXPECT_EQ(tally.hits, 4);
  EXPECT_EQ(tally.misses, 5);
  EXPECT_EQ(tally.unknown, 1);
  const std::string summary =
      folder.write("run/summary.json", "{\"requirements\": [{\"name\": \"turns little\", \"value\": 0.75}]}");
  EXPECT_EQ(metrics_of_run({spec.metrics.back()}, folder.file("run"), "f").front(), 0.75);
}

TEST_F(CampaignOfTheTipOver, HasAPageThatCanBeSignedAndMadeAgain) {
  spec_.outcomes[0].at_most = 0.3;
  Campaign campaign(spec_, false);
  for (std::size_t k = 0; k < campaign.size(); ++k) campaign.set(k, {0, "", {k < 40 ? 2.0 : 0.5}, {}});
  const StudyPage page = campaign_page(campaign, {}, {}, "./footfall sweep tip_over_plane.toml", {});
  const std::string text = page.markdown(), html = page.html();
  for (const char* part :
       {"\"tipped\" happened in 40 of 200 runs. With 95 % confidence its probability is at most 25.2 %.",
        "The statement that it is below 30 % is shown.", "uniform, least 1.5, most 3", "turn > pi / 4",
        "inputs/tip_over/scene.toml", "./footfall sweep tip_over_plane.toml", "OpenTURNS", "random, 1",
        "95 % of runs are below (95 % confidence)"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in\n" << text;
  EXPECT_NE(text.find(campaign.recipe()), std::string::npos);
  EXPECT_EQ(html.find('`'), std::string::npos);
  EXPECT_TRUE(statements_shown(campaign));
  spec_.outcomes[0].at_most = 0.25;
  Campaign other(spec_, false);
  for (std::size_t k = 0; k < other.size(); ++k) other.set(k, {0, "", {k < 40 ? 2.0 : 0.5}, {}});
  EXPECT_FALSE(statements_shown(other));
}

TEST_F(CampaignOfTheTipOver, CountsARunWithoutANumberNeitherAsOneNorAsTheOther) {
  Campaign campaign(spec_, false);
  campaign.set(0, {0, "", {NAN}, {}});
  campaign.set(1, {1, "t = 1 s: stopped", {}, {}});
  EXPECT_EQ(campaign.row(0).outcomes, (std::vector<int>{-1}));
  EXPECT_EQ(campaign.row(1).outcomes, (std::vector<int>{-1}));
  EXPECT_EQ(rows_to_keep(campaign, 2)[0].row, 1U);
  EXPECT_EQ(rows_to_keep(campaign, 2)[1].row, 0U);
}

// 28 of 60 runs have the outcome, the others have no number (a ratio 0/0) or no result: 28/60 to 1.
TEST_F(CampaignOfTheTipOver, BoundsAProbabilityByTheRunsThatDoNotTell) {
  spec_.runs = 60;
  Campaign campaign(spec_, false);
  for (std::size_t k = 0; k < 60; ++k)
    campaign.set(k, k < 28   ? CampaignRow{0, "", {2.0}, {}}
                    : k < 58 ? CampaignRow{0, "", {NAN}, {}}
                             : CampaignRow{1, "t = 1 s: stopped [E0666 passes-through]", {}, {}});
  const Tally& tally = campaign.tally(0, 0);
  EXPECT_EQ(tally.unknown, 32);
  EXPECT_NEAR(tally.least(), 28.0 / 60.0, 1e-12);
  EXPECT_EQ(tally.most(), 1.0);
  EXPECT_NEAR(tally.probability().low, clopper_pearson(28.0, 60.0).low, 1e-12);
  EXPECT_EQ(tally.probability().high, 1.0);
  EXPECT_EQ(rows_without_number(campaign), 32U);
  const std::string page = campaign_page(campaign, {}, {}, "footfall sweep", {}).markdown();
  EXPECT_NE(page.find("| tipped | all | 28 | 0 | 32 | 46.7 to 100 ("), std::string::npos) << page;
  EXPECT_NE(page.find("figure turn [rad] has no number | 30 | 28 |"), std::string::npos) << page;
  EXPECT_NE(page.find("exit code 1, E0666 | 2 | 58 |"), std::string::npos) << page;
}

}  // namespace
}  // namespace footfall
