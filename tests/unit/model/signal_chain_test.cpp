// Signals together: their order, tables and limits among them.

#include "mbd_solver/model/signals/signal_chain.h"

#include <gtest/gtest.h>

#include "coupler/base/errors.h"
#include "mbd_solver/model/signals/limit_blocks.h"
#include "mbd_solver/model/signals/linear_filter.h"
#include "mbd_solver/model/signals/lookup_table.h"

namespace footfall {
namespace {

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
  const SignalChain chain(list(node("c", "signal.b * 2"), node("b", "signal.a + x"), node("a", "x ^ 2")));
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

TEST(SignalChain, NamesTheCircleOfAnAlgebraicLoop) {
  try {
    SignalChain(list(node("a", "signal.c"), node("b", "signal.a"), node("c", "signal.b")));
    FAIL() << "no refusal";
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("a <- c <- b <- a"), std::string::npos) << text;
    EXPECT_NE(text.find("lowpass"), std::string::npos) << text;
  }
}

TEST(SignalChain, MayGoRoundThroughAFilter) {
  const SignalChain chain(list(node("a", "signal.c + 1"), node("b", "signal.a"), filter("c", "signal.b")));
  EXPECT_EQ(chain.node(0).name, "c");
}

TEST(SignalChain, WorksInItsStatesOnly) {
  SignalNode some = node("a", "1");
  some.states = {"up", "down"};
  const SignalChain chain(list(std::move(some), node("b", "1"), node("c", "1")));
  ASSERT_EQ(chain.names(), (std::vector<std::string>{"state.down", "state.up"}));
  EXPECT_FALSE(chain.works(0));
  EXPECT_TRUE(chain.works(1));
  chain.set(1, 1.0);
  EXPECT_TRUE(chain.works(0));
}

TEST(SignalChain, NamesThePlaceOfAnInputWithoutAValue) {
  SignalNode placed = node("a", "1 / x");
  placed.written_at = {"scene.toml:40: signals.a.input: "};
  const SignalChain chain(list(std::move(placed), node("b", "1 / x"), node("c", "1")));
  const auto complaint = [&](std::size_t k) {
    try {
      chain.inputs(k);
    } catch (const NumericalError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  chain.set(0, 0.0);
  EXPECT_EQ(complaint(0).rfind("scene.toml:40: signals.a.input: \"1 / x\" has no value where x = 0", 0), 0u)
      << complaint(0);
  EXPECT_EQ(complaint(1).rfind("signal \"b\": ", 0), 0u) << complaint(1);
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
