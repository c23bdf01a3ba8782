// Expressions: what they are worth, which names they read, and what is refused.

#include "mbd_solver/model/signals/expression.h"

#include <gtest/gtest.h>

#include <cmath>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

double value_of(const std::string& text) {
  NamedValues values = {{"knee.angle", 0.25}, {"signal.error", -2.0}, {"time", 3.0}};
  return Expression(text, values).value();
}

std::string refusal(const std::string& text) {
  try {
    Expression::names_in(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
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

TEST(Expression, WithoutAValueSaysSo) {
  EXPECT_THROW(value_of("1 / (knee.angle - 0.25)"), NumericalError);
  EXPECT_THROW(value_of("sqrt(signal.error)"), NumericalError);
}

TEST(Expression, WithoutAValueTellsTheValuesOfItsNames) {
  try {
    value_of("sqrt(signal.error) + knee.angle");
    FAIL() << "it has a value";
  } catch (const NumericalError& error) {
    EXPECT_EQ(std::string(error.what()),
              "\"sqrt(signal.error) + knee.angle\" has no value where knee.angle = 0.25, signal.error = -2; guard what "
              "divides, a root or a logarithm, for example \"x > 0 ? sqrt(x) : 0\"");
  }
}

TEST(Expression, ThatCannotBeReadIsRefused) {
  for (const char* text : {"1 +", "sin(", "a b", "", "1, 2", "knee.angle = 3", "foo(1)", "\"text\"", "a{leg}"})
    EXPECT_NE(refusal(text), "") << text;
  EXPECT_NE(refusal("a = 3").find("=="), std::string::npos);
}

}  // namespace
}  // namespace footfall
