// Signals: expressions, filters, PID, tables, and the order of their evaluation.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "coupler/base/errors.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/control/signal_blocks.h"
#include "mbd_solver/model/control/signal_chain.h"
#include "tests/support/refused.h"

namespace footfall {
namespace {

// Expressions: what they are worth, which names they read, and what is refused.

double value_of(const std::string& text) {
  NamedValues values = {{"knee.angle", 0.25}, {"signal.error", -2.0}, {"time", 3.0}};
  return Expression(text, values).value();
}

TEST(Expression, IsWorthWhatArithmeticSays) {
  EXPECT_DOUBLE_EQ(value_of("0.3 - 2 * knee.angle"), -0.2);
  EXPECT_DOUBLE_EQ(value_of("abs(signal.error) ^ 2 / time"), 4.0 / 3.0);
  EXPECT_DOUBLE_EQ(value_of("sin(pi / 6) + min(1, 2, time)"), std::sin(std::acos(-1.0) / 6.0) + 1.0);
  EXPECT_DOUBLE_EQ(value_of("atan2(1, knee.angle)"), std::atan2(1.0, 0.25));
}

TEST(Expression, OfLogicIsOneOrZero) {
  EXPECT_EQ(value_of("knee.angle < 0.3 && time >= 3"), 1.0);
  EXPECT_EQ(value_of("!(knee.angle < 0.3) || time == 2"), 0.0);
  EXPECT_EQ(value_of("time > 2 ? 7 : 8"), 7.0);
}

TEST(Expression, FollowsItsValues) {
  NamedValues values = {{"x", 1.0}};
  const Expression expression("2 * x", values);
  EXPECT_EQ(expression.value(), 2.0);
  values["x"] = -3.0;
  EXPECT_EQ(expression.value(), -6.0);
}

TEST(Expression, KnowsTheNamesThatItReads) {
  const std::vector<std::string> names = {"a.b_1.fz", "state.down", "time"};
  EXPECT_EQ(Expression::names_in("time + state.down * a.b_1.fz - pi + sin(time)"), names);
  EXPECT_TRUE(Expression::names_in("1 + 1").empty());
}

TEST(Expression, WithoutAValueNamesThoseOfItsNames) {
  EXPECT_THROW(value_of("1 / (knee.angle - 0.25)"), NumericalError);
  EXPECT_TRUE(test::names(test::error_of<NumericalError>([] { value_of("sqrt(signal.error) + knee.angle"); }),
                          {"\"sqrt(signal.error) + knee.angle\"", "knee.angle = 0.25", "signal.error = -2"}));
}

TEST(Expression, ThatCannotBeReadIsRefused) {
  for (const char* text : {"1 +", "sin(", "a b", "", "1, 2", "knee.angle = 3", "foo(1)", "\"text\"", "a{leg}"})
    EXPECT_THROW(Expression::names_in(text), InputError) << text;
}

// Filters against their transfer functions and step answers.

using Complex = std::complex<double>;

constexpr double kFrequency = 5.0, kDamping = 0.3;  // [Hz], [-]
constexpr double kOmega = 2.0 * kPi * kFrequency;

// c (s - A)^-1 b + d, with A, b, c, d found by asking for unit inputs and states.
Complex response(const LinearFilter& filter, const Complex& s) {
  const int n = filter.state_count();
  const Eigen::VectorXd no_input = Eigen::VectorXd::Zero(1), unit_input = Eigen::VectorXd::Ones(1);
  const Eigen::VectorXd no_state = Eigen::VectorXd::Zero(n);
  Eigen::VectorXd rates(n), b(n), c(n);
  Eigen::MatrixXd A(n, n);
  filter.rates(unit_input, no_state, b);
  for (int j = 0; j < n; ++j) {
    filter.rates(no_input, Eigen::VectorXd::Unit(n, j), rates);
    A.col(j) = rates;
    c[j] = filter.value(no_input, Eigen::VectorXd::Unit(n, j));
  }
  const double d = filter.value(unit_input, no_state);
  // At most two states: (s - A)^-1 in closed form.
  if (n == 1) return c[0] * b[0] / (s - A(0, 0)) + d;
  const Complex det = (s - A(0, 0)) * (s - A(1, 1)) - A(0, 1) * A(1, 0);
  return (c[0] * ((s - A(1, 1)) * b[0] + A(0, 1) * b[1]) + c[1] * (A(1, 0) * b[0] + (s - A(0, 0)) * b[1])) / det + d;
}

constexpr double kRoundOff = 1e-12;

TEST(LinearFilter, HasItsTransferFunction) {
  const LinearFilter first = LinearFilter::low_pass(kFrequency, 0.0),
                     second = LinearFilter::low_pass_2(kFrequency, kDamping, 0.0),
                     notch = LinearFilter::notch(kFrequency, kDamping, 0.0);
  const double w = kOmega;
  for (const double f : {0.1, 1.0, 4.0, 5.0, 6.0, 50.0}) {
    const Complex s(0.0, 2.0 * kPi * f), below = s * s + 2.0 * kDamping * w * s + w * w;
    EXPECT_LT(std::abs(response(first, s) - 1.0 / (1.0 + s / w)), kRoundOff) << f;
    EXPECT_LT(std::abs(response(second, s) - w * w / below), kRoundOff) << f;
    EXPECT_LT(std::abs(response(notch, s) - (s * s + w * w) / below), kRoundOff) << f;
  }
}

// The step answer of a filter of second order, from the roots of its polynomial.
double step_2(double t) {
  const double sigma = kDamping * kOmega, wd = kOmega * std::sqrt(1.0 - kDamping * kDamping);
  return 1.0 - std::exp(-sigma * t) * (std::cos(wd * t) + sigma / wd * std::sin(wd * t));
}
double bump_2(double t) {  // of w s / (s^2 + 2 D w s + w^2)
  const double sigma = kDamping * kOmega, wd = kOmega * std::sqrt(1.0 - kDamping * kDamping);
  return kOmega / wd * std::exp(-sigma * t) * std::sin(wd * t);
}

TEST(LinearFilter, SampledAnswersAStepExactly) {
  const double T = 0.013;  // [s]: coarse on purpose
  const LinearFilter first = LinearFilter::low_pass(kFrequency, T),
                     second = LinearFilter::low_pass_2(kFrequency, kDamping, T),
                     notch = LinearFilter::notch(kFrequency, kDamping, T);
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(1);
  Eigen::VectorXd z1 = Eigen::VectorXd::Zero(1), z2 = Eigen::VectorXd::Zero(2), z3 = z2;
  for (int k = 0; k < 100; ++k) {
    const double t = k * T;
    EXPECT_NEAR(first.sample(one, T, z1), -std::expm1(-kOmega * t), kRoundOff);
    EXPECT_NEAR(second.sample(one, T, z2), step_2(t), kRoundOff);
    EXPECT_NEAR(notch.sample(one, T, z3), 1.0 - 2.0 * kDamping * bump_2(t), kRoundOff);
  }
}

TEST(LinearFilter, SettledAnswersItsInput) {
  for (const LinearFilter& filter :
       {LinearFilter::low_pass(kFrequency, 0.0), LinearFilter::low_pass_2(kFrequency, kDamping, 0.0),
        LinearFilter::notch(kFrequency, kDamping, 0.0)}) {
    const Eigen::VectorXd u = Eigen::VectorXd::Constant(1, 3.5);
    Eigen::VectorXd z(filter.state_count()), dz(filter.state_count());
    filter.settle(u, z);
    filter.rates(u, z, dz);
    EXPECT_DOUBLE_EQ(filter.value(u, z), 3.5);
    EXPECT_LT(dz.norm(), kRoundOff);
  }
}

TEST(LinearFilter, RefusesWhatIsNoFilter) {
  EXPECT_THROW(LinearFilter::low_pass(0.0, 0.0), InputError);
  EXPECT_THROW(LinearFilter::notch(1.0, -1.0, 0.0), InputError);
}

// The PID of signals: its terms, its limits, and what its integral does at them.

Eigen::VectorXd error(double e) { return Eigen::VectorXd::Constant(1, e); }

TEST(PidBlock, SampledAddsItsThreeTerms) {
  PidBlockParameters p;
  p.kp = 2.0;
  p.ki = 5.0;
  p.kd = 0.1;
  p.bias = 0.5;
  p.period = 0.01;
  const PidBlock pid(p);
  Eigen::VectorXd z(2);
  pid.settle(error(1.0), z);
  double integral = 0.0, before = 1.0;
  for (int k = 0; k < 20; ++k) {
    const double e = std::cos(0.3 * k);
    const double expected = 0.5 + 2.0 * e + 5.0 * integral + 0.1 * (e - before) / 0.01;
    EXPECT_NEAR(pid.sample(error(e), 0.01, z), expected, 1e-13);  // round-off
    integral += 0.01 * e;
    before = e;
  }
}

TEST(PidBlock, TakesTheRateThatIsGiven) {
  PidBlockParameters p;
  p.kp = 2.0;
  p.kd = 3.0;
  p.rate_is_given = true;
  const PidBlock pid(p);
  EXPECT_EQ(pid.state_count(), 0);
  EXPECT_DOUBLE_EQ(pid.value(Eigen::Vector2d(0.5, -0.1), Eigen::VectorXd()), 2.0 * 0.5 - 3.0 * 0.1);
}

// A long time at the limit, then the error changes its sign: without anti-windup it would take as long to come back.
TEST(PidBlock, ComesOffItsLimitAtOnce) {
  PidBlockParameters p;
  p.kp = 1.0;
  p.ki = 10.0;
  p.max = 1.0;
  p.min = -1.0;
  p.period = 0.001;
  const PidBlock pid(p);
  Eigen::VectorXd z = Eigen::VectorXd::Zero(1);
  for (int k = 0; k < 100000; ++k) EXPECT_EQ(pid.sample(error(1.0), p.period, z), 1.0);
  // The integral rests where kp e + ki I is 1 + kp e: one more error's worth.
  EXPECT_NEAR(p.ki * z[0], 1.0, 1e-6);
  int samples = 0;
  while (pid.sample(error(-0.1), p.period, z) > 0.5) ++samples;
  EXPECT_LT(samples, 600);  // 0.4 / (ki 0.1) = 0.4 s; wound up it would take 1000 s
}

TEST(PidBlock, ContinuousIntegralIsHeldBackAtALimit) {
  PidBlockParameters p;
  p.kp = 2.0;
  p.ki = 1.0;
  p.max = 1.0;
  const PidBlock pid(p);
  Eigen::VectorXd z = Eigen::VectorXd::Constant(1, 1.0), dz(1);
  pid.rates(error(3.0), z, dz);  // v = 7, y = 1
  EXPECT_DOUBLE_EQ(dz[0], 3.0 + (1.0 - 7.0) / 2.0);
  EXPECT_DOUBLE_EQ(pid.value(error(3.0), z), 1.0);
}

TEST(PidBlock, FilteredRateSettlesToTheSlope) {
  PidBlockParameters p;
  p.kd = 1.0;
  p.derivative_frequency = 10.0;
  const PidBlock pid(p);
  // e = 2 t: z = 2 t - 2 / w once settled, D = w (e - z) = 2
  const double w = 2.0 * kPi * 10.0;
  const Eigen::VectorXd z = Eigen::VectorXd::Constant(1, 2.0 * 7.0 - 2.0 / w);
  Eigen::VectorXd dz(1);
  pid.rates(error(2.0 * 7.0), z, dz);
  EXPECT_NEAR(dz[0], 2.0, 1e-12);
  EXPECT_NEAR(pid.value(error(2.0 * 7.0), z), 2.0, 1e-12);
}

TEST(PidBlock, RefusesWhatCannotWork) {
  PidBlockParameters p;
  p.ki = 1.0;
  p.max = 1.0;
  EXPECT_THROW(PidBlock{p}, InputError);  // nothing holds the integral back
  p = {};
  p.kd = 1.0;
  EXPECT_THROW(PidBlock{p}, InputError);  // continuous, and no rate
  p = {};
  p.kp = 1.0;
  p.min = 2.0;
  p.max = 1.0;
  EXPECT_THROW(PidBlock{p}, InputError);
}

// Signals together: their order, tables and limits among them.

SignalNode node(const std::string& name, const std::string& input) {
  SignalNode out;
  out.name = name;
  out.block = std::make_unique<PassBlock>();
  out.inputs = {input};
  return out;
}
SignalNode filter(const std::string& name, const std::string& input) {
  SignalNode out = node(name, input);
  out.block = std::make_unique<LinearFilter>(LinearFilter::low_pass(1.0, 0.0));
  return out;
}
std::vector<SignalNode> list(SignalNode a, SignalNode b, SignalNode c) {
  std::vector<SignalNode> nodes;
  nodes.push_back(std::move(a));
  nodes.push_back(std::move(b));
  nodes.push_back(std::move(c));
  return nodes;
}

TEST(SignalChain, IsEvaluatedInTheOrderOfItsReads) {
  SignalChain chain(list(node("c", "signal.b * 2"), node("b", "signal.a + x"), node("a", "x ^ 2")));
  ASSERT_EQ(chain.size(), 3u);
  EXPECT_EQ(chain.node(0).name, "a");
  EXPECT_EQ(chain.node(1).name, "b");
  EXPECT_EQ(chain.node(2).name, "c");
  EXPECT_EQ(chain.names(), std::vector<std::string>{"x"});
  chain.set(0, 3.0);
  const double expected[] = {9.0, 12.0, 24.0};
  for (std::size_t k = 0; k < 3; ++k) {
    const double y = chain.node(k).block->value(chain.inputs(k), Eigen::VectorXd());
    EXPECT_DOUBLE_EQ(y, expected[k]);
    chain.put(k, y);
  }
}

TEST(SignalChain, ACopyHasValuesOfItsOwn) {
  SignalChain chain(list(node("a", "x ^ 2"), node("b", "signal.a + x"), node("c", "1")));
  chain.set(0, 3.0);
  chain.put(0, 9.0);
  SignalChain copy(chain);
  EXPECT_DOUBLE_EQ(copy.inputs(1)[0], 12.0);
  copy.set(0, 1.0);
  copy.put(0, 1.0);
  EXPECT_DOUBLE_EQ(copy.inputs(1)[0], 2.0);
  EXPECT_DOUBLE_EQ(chain.inputs(1)[0], 12.0);
}

TEST(SignalChain, NamesTheCircleOfAnAlgebraicLoop) {
  const auto make = [] { SignalChain(list(node("a", "signal.c"), node("b", "signal.a"), node("c", "signal.b"))); };
  EXPECT_TRUE(test::names(test::error_of(make), {"a <- c <- b <- a"}));
}

TEST(SignalChain, MayGoRoundThroughAFilter) {
  SignalChain chain(list(node("a", "signal.c + 1"), node("b", "signal.a"), filter("c", "signal.b")));
  EXPECT_EQ(chain.node(0).name, "c");
}

TEST(SignalChain, WorksInItsStatesOnly) {
  SignalNode some = node("a", "1");
  some.states = {"up", "down"};
  SignalChain chain(list(std::move(some), node("b", "1"), node("c", "1")));
  ASSERT_EQ(chain.names(), (std::vector<std::string>{"state.down", "state.up"}));
  EXPECT_FALSE(chain.active(0));
  EXPECT_TRUE(chain.active(1));
  chain.set(1, 1.0);
  EXPECT_TRUE(chain.active(0));
}

TEST(SignalChain, NamesThePlaceOfAnInputWithoutAValue) {
  SignalNode placed = node("a", "1 / x");
  placed.written_at = {"scene.toml:40: signals.a.input: "};
  SignalChain chain(list(std::move(placed), node("b", "1 / x"), node("c", "1")));
  chain.set(0, 0.0);
  const auto complaint = [&](std::size_t k) { return test::error_of<NumericalError>([&] { chain.inputs(k); }); };
  EXPECT_TRUE(test::names(complaint(0), {"scene.toml:40: signals.a.input: ", "x = 0"}));
  EXPECT_TRUE(test::names(complaint(1), {"signal \"b\": "}));
}

TEST(LookupTable, IsLinearBetweenItsPointsAndConstantOutside) {
  const LookupTable table({0.0, 1.0, 3.0}, {1.0, 2.0, -2.0});
  const auto at = [&](double x) { return table.value(Eigen::VectorXd::Constant(1, x), Eigen::VectorXd()); };
  EXPECT_DOUBLE_EQ(at(-5.0), 1.0);
  EXPECT_DOUBLE_EQ(at(0.5), 1.5);
  EXPECT_DOUBLE_EQ(at(1.0), 2.0);
  EXPECT_DOUBLE_EQ(at(2.0), 0.0);
  EXPECT_DOUBLE_EQ(at(9.0), -2.0);
}

// A plane a + b x + c y + d x y is met exactly.
TEST(LookupTable, OverTwoInputsIsBilinear) {
  const auto f = [](double x, double y) { return 1.0 + 2.0 * x - y + 0.5 * x * y; };
  const std::vector<double> x = {0.0, 1.0, 4.0}, y = {-1.0, 2.0};
  Eigen::MatrixXd values(3, 2);
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index j = 0; j < 2; ++j)
      values(i, j) = f(x[static_cast<std::size_t>(i)], y[static_cast<std::size_t>(j)]);
  const LookupTable table(x, y, values);
  for (const Eigen::Vector2d& u : {Eigen::Vector2d(0.3, 0.1), {1.0, 2.0}, {2.5, -0.5}, {4.0, -1.0}})
    EXPECT_NEAR(table.value(u, Eigen::VectorXd()), f(u.x(), u.y()), 1e-14);
  EXPECT_NEAR(table.value(Eigen::Vector2d(9.0, 9.0), Eigen::VectorXd()), f(4.0, 2.0), 1e-14);
  EXPECT_THROW(LookupTable({1.0, 1.0}, {0.0, 0.0}), InputError);
}

TEST(RateLimit, RisesAlongItsRampAndFollowsWhatIsSlow) {
  const RateLimit limit(2.0);
  Eigen::VectorXd z = Eigen::VectorXd::Zero(1);
  const double T = 0.1;
  for (int k = 1; k <= 10; ++k)
    EXPECT_NEAR(limit.sample(Eigen::VectorXd::Ones(1), T, z), std::min(0.2 * k, 1.0), 1e-14);
  EXPECT_NEAR(limit.sample(Eigen::VectorXd::Constant(1, 0.9), T, z), 0.9, 1e-14);
  EXPECT_NEAR(limit.sample(Eigen::VectorXd::Constant(1, -9.0), T, z), 0.7, 1e-14);
}

TEST(Saturation, CutsAtItsLimits) {
  const Saturation both(-1.0, 2.0), above(std::nullopt, 2.0);
  const auto at = [](const Saturation& s, double u) {
    return s.value(Eigen::VectorXd::Constant(1, u), Eigen::VectorXd());
  };
  EXPECT_EQ(at(both, -3.0), -1.0);
  EXPECT_EQ(at(both, 0.5), 0.5);
  EXPECT_EQ(at(above, -3.0), -3.0);
  EXPECT_EQ(at(above, 3.0), 2.0);
}

}  // namespace
}  // namespace footfall
