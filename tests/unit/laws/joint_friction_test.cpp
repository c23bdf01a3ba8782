#include "mbd_solver/model/laws/joint_friction.h"

#include "coupler/base/errors.h"
#include "tests/unit/laws/law_checks.h"

namespace footfall {
namespace {

using namespace law_checks;

JointFrictionParameters parameters() {
  JointFrictionParameters p;
  p.coulomb = 2.0;
  p.breakaway = 3.0;
  p.stribeck_speed = 0.1;
  p.viscous = 0.5;
  p.stick_displacement = 1e-3;
  return p;
}

Eigen::VectorXd state(double z) { return Eigen::VectorXd::Constant(1, z); }

TEST(JointFriction, SlidesAtItsStribeckCurve) {
  const JointFriction law(parameters());
  for (const double v : {0.02, 0.1, 0.5, -0.3}) {
    const Along end = drive(law, {[v](double t) { return v * t; }, [v](double) { return v; }}, 0.0, 0.5 / std::abs(v),
                            20000, 0.0, state(0.0));
    const double g = 2.0 + std::exp(-v * v / 0.01);
    // The rest of the way into sliding has gone: exp(-0.5 / 0.001).
    EXPECT_NEAR(force(law, 0.0, v, 0.0, end.z), (v > 0.0 ? g : -g) + 0.5 * v, 1e-9);
  }
}

TEST(JointFriction, IsASpringWhileItSticks) {
  const JointFriction law(parameters());
  EXPECT_DOUBLE_EQ(force(law, 0.0, 0.0, 0.0, state(5e-4)), 1.0);
  StrutOutput out(1);
  law.evaluate({0.0, 0.01, 0.0, state(5e-4)}, out);
  EXPECT_DOUBLE_EQ(out.dz[0], 0.01);  // nothing slides
}

TEST(JointFriction, HasTheDerivativesOfItsForceAndRates) {
  const JointFriction law(parameters());
  for (const double z : {-1.2e-3, -8e-4, -3e-4, 2e-4, 9e-4, 1.1e-3, 2e-3})
    for (const double v : {-0.5, -0.08, -0.01, 0.02, 0.15, 0.7})
      expect_derivatives(law, 0.0, v, 0.0, state(z), 1e-3, 0.1);
}

TEST(JointFriction, StoresOrDissipatesWhatItTakes) {
  const JointFriction law(parameters());
  for (const double z : {-1.2e-3, -3e-4, 2e-4, 9e-4, 1.4e-3, 2e-3})
    for (const double v : {-0.5, -0.01, 0.02, 0.7}) expect_power_identity(law, 0.0, v, 0.0, state(z));
}

TEST(JointFriction, RefusesABreakawayBelowCoulomb) {
  JointFrictionParameters p = parameters();
  p.breakaway = 1.0;
  expect_contains(message_of<InputError>([&] { JointFriction law(p); }), "breakaway");
}

}  // namespace
}  // namespace footfall
