// Corners of signals that are known beforehand: every jump to the last digit, every bump however narrow.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mbd_solver/model/control/given_signals.h"
#include "mbd_solver/model/control/signal_blocks.h"
#include "mbd_solver/model/laws/time_function.h"

namespace footfall {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kEnd = 1.0;  // [s]

// Inputs of a run: place 0 is state "on", place 1 its beginning; "b.x" depends on the motion.
GivenSource source_of(const std::string& name) {
  if (name == "time") return {GivenSource::Kind::kTime, -1};
  if (name == "state.on") return {GivenSource::Kind::kHeld, 0};
  if (name == "state.since") return {GivenSource::Kind::kSince, 1};
  return {name.rfind("signal.", 0) == 0 ? GivenSource::Kind::kSignal : GivenSource::Kind::kUnknown, -1};
}

class Given {
 public:
  void add(const std::string& name, const std::string& input) { add(name, input, std::make_unique<PassBlock>()); }
  void add(const std::string& name, const std::string& input, std::unique_ptr<SignalBlock> block) {
    entries_.push_back({name, name, block.get(), {input}, {}});
    blocks_.push_back(std::move(block));
  }
  std::vector<Corner> corners(double on = 1.0, double since = 0.0) {
    GivenSignals signals(entries_, source_of, kEnd);
    const Eigen::VectorXd values = Eigen::Vector2d(on, since);
    std::vector<Corner> all;
    for (Corner corner = signals.next(0.0, values); corner.after <= kEnd; corner = signals.next(corner.after, values))
      all.push_back(corner);
    too_fast = signals.too_fast();
    return all;
  }
  int splits() {
    GivenSignals signals(entries_, source_of, kEnd);
    const Eigen::VectorXd values = Eigen::Vector2d(1.0, 0.0);
    int count = 0;
    for (double t = 0.0; t < kEnd;) {
      const double split = signals.next_split(t, values);
      count += split < kInfinity ? 1 : 0;
      t = split < kInfinity ? split : signals.next(t, values).after;
    }
    return count;
  }
  std::vector<std::string> too_fast;

 private:
  std::vector<GivenEntry> entries_;
  std::vector<std::unique_ptr<SignalBlock>> blocks_;
};

std::vector<Corner> corners_of(const std::string& text) {
  Given given;
  given.add("s", text);
  return given.corners();
}

std::vector<double> times_of(const std::string& text) {
  std::vector<double> times;
  for (const Corner& corner : corners_of(text)) times.push_back(corner.after);
  return times;
}

bool has_near(const std::vector<double>& times, double t, double distance) {
  for (const double time : times)
    if (std::abs(time - t) <= distance) return true;
  return false;
}

TEST(GivenSignals, JumpWhereComparisonsChangeToTheLastDigit) {
  const std::vector<Corner> corners = corners_of("time > 0.25 && time < 0.25000001 ? 7 : 0");
  ASSERT_EQ(corners.size(), 2u);
  EXPECT_EQ(corners[0].before, 0.25);
  EXPECT_EQ(corners[0].after, std::nextafter(0.25, kInfinity));
  EXPECT_EQ(corners[1].before, std::nextafter(0.25000001, 0.0));
  EXPECT_EQ(corners[1].after, 0.25000001);
}

// However a pulse of 1e-9 s is written.
// -0.1 t is zero until 2e-323 s: no step may end there.
TEST(GivenSignals, CornersAtZeroAreAtZero) {
  for (const char* text : {"exp(-0.1 * time)", "sin(-0.1 * time)", "atan(0 - 0.3 * time)", "max(0, 0.01 * time)"})
    for (const Corner& corner : corners_of(text)) EXPECT_TRUE(corner.before == 0.0 || corner.before > 1e-3) << text;
}

TEST(GivenSignals, FindEveryNotationOfANarrowPulse) {
  for (const char* text :
       {"(time >= 0.3) * (time < 0.300000001) * 5", "abs(time - 0.3) < 1e-9 ? 5 : 0",
        "(time - 0.3) ^ 2 < 1e-18 ? 5 : b.x", "b.x + (time > 0.3 && time < 0.300000001) * b.x",
        "max(0, 1 - abs(time - 0.3) / 1e-9)", "sign(time - 0.3) - sign(time - 0.300000001)",
        "rint(time + 0.2) - rint(time + 0.199999999)", "b.x > 2 ? 1 : (time < 0.3 ? 0 : time < 0.300000001 ? 5 : 0)",
        "!(abs(time - 0.3) >= 1e-9)", "exp(-((time - 0.3) / 1e-9) ^ 2)", "1 / (1 + ((time - 0.3) / 1e-9) ^ 2)",
        "cos(1e9 * (time - 0.3)) * (abs(time - 0.3) < 1e-9)", "1 - tanh((time - 0.3) / 1e-9) ^ 2",
        "sin(2 * pi * time) > sin(0.6 * pi) && time < 0.300000001 && time > 0.2",
        "state.since > 0.3 && state.since < 0.300000001", "state.on * (state.since - 0.3 < 1e-9 && time > 0.3)"}) {
    const std::vector<double> times = times_of(text);
    EXPECT_TRUE(has_near(times, 0.3, 5e-9)) << text;
    EXPECT_LT(times.size(), 100u) << text;
  }
}

// Bumps of 1e-6 s where an argument has an extreme, but no zero.
TEST(GivenSignals, FindNarrowBumpsAtTheExtremesOfArguments) {
  for (const char* text :
       {"exp(-1e12 * (time ^ 2 - 0.6 * time + 0.09))", "sin(pi * (time + 0.2)) ^ 1e12",
        "exp(1e12 * (cos(time - 0.3) - 1))", "1 / (1 + 1e12 * (time ^ 2 - 0.6 * time + 0.09))",
        "exp(-1e12 * (1 + (time - 0.3) ^ 2) + 1e12)", "exp(-1e6 * sqrt(1e-12 + time ^ 2 - 0.6 * time + 0.09))"}) {
    const std::vector<double> times = times_of(text);
    EXPECT_TRUE(has_near(times, 0.3, 1e-5)) << text;
    EXPECT_LT(times.size(), 400u) << text;  // 64 of them are the ends of blocks
  }
}

TEST(GivenSignals, OfTheMotionAloneHaveNone) {
  for (const char* text : {"b.x > 0.3 ? 1 : 0", "3", "2 * time + 1", "b.x * time", "time * state.on", "time > b.x"})
    EXPECT_TRUE(corners_of(text).empty()) << text;
}

TEST(GivenSignals, BendAtThePointsOfTables) {
  Given given;
  given.add("later", "time - 0.1");
  given.add("s", "1000 * signal.later",
            std::make_unique<LookupTable>(std::vector<double>{0, 200, 300, 301}, std::vector<double>{0, 0, 1, 7}));
  given.add("limited", "10 * time", std::make_unique<Saturation>(1.5, 6.25));
  std::vector<double> times;
  for (const Corner& corner : given.corners()) {
    EXPECT_EQ(corner.after, std::nextafter(corner.before, kInfinity));  // the slope jumps
    times.push_back(corner.after);
  }
  ASSERT_EQ(times.size(), 5u);  // 0 and 200 belong to one line
  const double expected[] = {0.15, 0.3, 0.4, 0.401, 0.625};
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(times[i], expected[i], 1e-15);
}

TEST(GivenSignals, FollowTheStateOfTheScene) {
  Given given;
  given.add("s", "state.on && state.since < 1e-4 ? 3 : 0");
  const std::vector<Corner> corners = given.corners(1.0, 0.5);
  ASSERT_EQ(corners.size(), 1u);
  EXPECT_NEAR(corners[0].after, 0.5001, 1e-15);
  EXPECT_LT(corners[0].before, corners[0].after);
}

// Random expressions of bumps: between neighbouring corners each is nearly a line, but for what is small against the bumps.
TEST(GivenSignals, LeaveNearlyLinesBetweenCorners) {
  std::mt19937 random(7);
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  for (int trial = 0; trial < 10; ++trial) {
    std::string text = "0";
    for (int i = 0; i < 3; ++i) {
      const double centre = uniform(0.05, 0.95), width = std::pow(10.0, uniform(-6.0, -2.0));
      text += " + exp(-((time - " + std::to_string(centre) + ") / " + std::to_string(width) + ") ^ 2)";
    }
    text += " + 0.1 * sin(" + std::to_string(uniform(1.0, 100.0)) + " * time)";
    const std::vector<Corner> corners = corners_of(text);
    NamedValues names = {{"time", 0.0}};
    const Expression f(text, names);
    double from = 0.0;
    for (const Corner& corner : corners) {
      constexpr int kSamples = 20;
      double values[kSamples + 1], farthest = 0.0;
      for (int i = 0; i <= kSamples; ++i) {
        names["time"] = from + (corner.before - from) * i / kSamples;
        values[i] = f.value();
      }
      const auto [low, high] = std::minmax_element(values, values + kSamples + 1);
      for (int i = 0; i <= kSamples; ++i)
        farthest = std::max(farthest, std::abs(values[i] - values[0] - (values[kSamples] - values[0]) * i / kSamples));
      EXPECT_LE(farthest, 0.4 * (*high - *low) + 0.01) << text << " in [" << from << ", " << corner.before << "]";
      from = corner.after;
    }
    EXPECT_LT(corners.size(), 400u) << text;
  }
}

// 44 = 14 pi + 0.018: the argument's round-off is 3e-13 of the sine, which no shorter step makes smaller.
TEST(GivenSignals, AreNotSplitForTheirRoundOff) {
  Given slow;
  slow.add("s", "sin(0.05 * time + 44)");
  EXPECT_LE(slow.splits(), 2 * GivenSignals::kBlocks);
  Given fast;  // 32 periods: half of one in a block
  fast.add("s", "sin(201 * time)");
  EXPECT_GE(fast.splits(), 2 * GivenSignals::kBlocks);
}

TEST(GivenSignals, TooFastForTheGridAreNamed) {
  Given given;
  given.add("noise", "sin(1e6 * time)");
  given.add("slow", "sin(10 * time)");
  given.corners();
  EXPECT_EQ(given.too_fast, std::vector<std::string>{"noise"});
}

// As a fuzzy system: it bends many times, and no class shows where.
class ManyBends final : public SignalBlock {
 public:
  double value(const BlockValues& u, const BlockValues&) const override {
    const double x = 40.0 * u[0];
    return std::abs(x - std::floor(x) - 0.5);
  }
};

// Steps that halve towards each bend would be ten times as many as its corners, and each evaluates the block again.
TEST(GivenSignals, OfABlockThatBendsUnseenEndNoStepsForTheirIntegral) {
  Given bends;
  bends.add("s", "time", std::make_unique<ManyBends>());
  EXPECT_EQ(bends.splits(), 0);
  bends.add("t", "2 * signal.s + 1");
  EXPECT_EQ(bends.splits(), 0);
  bends.add("u", "sin(20 * time)");
  EXPECT_GT(bends.splits(), 0);
}

// A fuzzy system takes a tenth of a millisecond; four of them over time kept a run of 0.2 s busy for minutes before its first steps.
class CountedBends final : public SignalBlock {
 public:
  explicit CountedBends(long& count) : count_(count) {}
  double value(const BlockValues& u, const BlockValues&) const override {
    ++count_;
    return bends_.value(u, u);
  }

 private:
  long& count_;
  ManyBends bends_;
};

TEST(GivenSignals, EvaluateABlockThatBendsUnseenOnlyForWhatIsFoundByIt) {
  long count = 0;
  Given bends;
  bends.add("s", "time", std::make_unique<CountedBends>(count));
  bends.add("t", "signal.s");
  bends.add("other", "sin(20 * time)");
  EXPECT_GT(bends.corners().size(), 0u);
  EXPECT_EQ(count, 0);
  bends.add("above", "signal.t > 0.25 ? 1 : 0");
  EXPECT_GT(bends.corners().size(), 70u) << "two jumps of each of 40 bends";
  EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace footfall
