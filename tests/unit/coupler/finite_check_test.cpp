#include "coupler/finite_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/unit/coupler/message_content.h"

namespace footfall {
namespace {

using test::Random;

template <class Message>
class NotANumber : public testing::Test {};
using Exchanged = testing::Types<Geometry, Start, Accept, Motion, Load>;
TYPED_TEST_SUITE(NotANumber, Exchanged);

// Every number of a message in turn is made infinite or no number: the check says where it stands, and nothing before
// and after.
TYPED_TEST(NotANumber, IsFoundWhereverItStands) {
  Random random(46);
  TypeParam message;
  test::randomize(message, random, 3);
  EXPECT_EQ(first_not_finite(message), "");
  int numbers = 0;
  const auto any_size = [](const auto&...) { return true; };
  test::walk(
      "", any_size,
      [&](const std::string& path, auto& value) {
        using Value = std::decay_t<decltype(value)>;
        const auto spoil = [&](double& number, double bad) {
          const double kept = number;
          number = bad;
          EXPECT_EQ("." + first_not_finite(message), path);
          number = kept;
          ++numbers;
        };
        if constexpr (std::is_same_v<Value, double>) {
          spoil(value, std::nan(""));
          spoil(value, std::numeric_limits<double>::infinity());
        } else if constexpr (std::is_base_of_v<Eigen::PlainObjectBase<Value>, Value>) {
          if constexpr (std::is_same_v<typename Value::Scalar, double>)
            for (Eigen::Index i = 0; i < value.size(); ++i) spoil(value.data()[i], -std::nan(""));
        }
      },
      message);
  EXPECT_GE(numbers, 2);
  EXPECT_EQ(first_not_finite(message), "");
}

}  // namespace
}  // namespace footfall
