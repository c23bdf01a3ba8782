#include "coupler/base/parameter_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

std::string said_by(const std::function<void()>& check) {
  try {
    check();
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(ParameterCheck, AcceptsTheEdgesOfTheRange) {
  EXPECT_NO_THROW(require_not_negative("law", "c", 0.0, "N s/m"));
  EXPECT_NO_THROW(require_within("law", "share", 0.0, 0.0, 1.0, ""));
  EXPECT_NO_THROW(require_within("law", "share", 1.0, 0.0, 1.0, ""));
  EXPECT_THROW(require_positive("law", "k", 0.0, "N/m"), InputError);
}

TEST(ParameterCheck, RefusesWhatIsNoNumber) {
  for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(require_positive("law", "k", value, "N/m"), InputError);
    EXPECT_THROW(require_not_negative("law", "k", value, "N/m"), InputError);
    EXPECT_THROW(require_finite("law", "k", value, "N/m"), InputError);
    EXPECT_THROW(require_within("law", "k", value, 0.0, 1.0, "N/m"), InputError);
  }
}

TEST(ParameterCheck, NamesLawParameterValueAndWhatWasExpected) {
  EXPECT_EQ(said_by([] { require_positive("gas spring", "volume", -2.0, "m3"); }),
            "gas spring: volume is -2 m3; expected a number above 0 m3.");
  EXPECT_EQ(said_by([] { require_within("law", "share", 1.5, 0.0, 1.0, ""); }),
            "law: share is 1.5; expected a number from 0 to 1.");
}

}  // namespace
}  // namespace footfall
