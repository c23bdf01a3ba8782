#include "mbd_solver/model/laws/linear_spring_damper.h"

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "tests/unit/laws/law_checks.h"

namespace footfall {
namespace {

using namespace law_checks;
const LinearSpringDamperParameters kLaw{1000.0, 20.0, 0.1, 50.0};

TEST(LinearSpringDamper, IsLinear) {
  const LinearSpringDamper law(kLaw);
  EXPECT_DOUBLE_EQ(force(law, 0.1), 50.0);
  EXPECT_DOUBLE_EQ(force(law, 0.3, -2.0), 50.0 + 200.0 - 40.0);
}

TEST(LinearSpringDamper, SineLoopIsAnEllipse) {
  const LinearSpringDamper law(kLaw);
  const double A = 0.2, omega = 5.0, area = kPi * 20.0 * omega * A * A;
  const Motion motion{[&](double t) { return A * std::sin(omega * t); },
                      [&](double t) { return A * omega * std::cos(omega * t); }};
  const Along run = drive(law, motion, 0.0, 2.0 * kPi / omega, 2000, 0.0, law_checks::kNoState);
  EXPECT_NEAR(run.work, area, 1e-8 * area);
  EXPECT_NEAR(run.dissipated, area, 1e-8 * area);
}

TEST(LinearSpringDamper, DissipatesWhatItTakes) {
  const LinearSpringDamper law(kLaw);
  const Along run = drive(law, random_motion(7, 0.0, 0.3), 0.0, 1.3, 4000, 0.0, law_checks::kNoState);
  EXPECT_NEAR(run.work, run.dissipated + run.stored - run.stored_start, 1e-8 * run.dissipated);
  expect_derivatives(law, 0.2, -1.0, 0.0, law_checks::kNoState, 0.1, 1.0);
  expect_power_identity(law, 0.2, -1.0, 0.0, law_checks::kNoState);
}

TEST(LinearSpringDamper, RefusesNonsense) {
  expect_contains(message_of<InputError>([] { LinearSpringDamper{LinearSpringDamperParameters{}}; }), "all 0");
  expect_contains(message_of<InputError>([] {
                    LinearSpringDamper{LinearSpringDamperParameters{-1.0, 0.0, 0.0, 0.0}};
                  }),
                  "stiffness is -1 N/m");
  EXPECT_THROW(LinearSpringDamper(LinearSpringDamperParameters{1.0, -2.0, 0.0, 0.0}), InputError);
}

}  // namespace
}  // namespace footfall
