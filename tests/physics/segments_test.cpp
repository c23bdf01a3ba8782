// Segments (mbd_solver/scene/segments.cpp) bring what a floating frame with linear modes leaves out: a spinning rod
// stiffens by its own tension. Exact: Wright, Smith, Thresher and Wang, J. Appl. Mech. 49 (1982), 197, Table 1: uniform
// cantilever without hub, first flapping frequency over sqrt(EI / (m L^4)) at spin rates eta in the same unit.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <sstream>

#include "coupler/base/pi.h"
#include "mbd_solver/build/mechanism.h"
#include "tests/unit/dynamics/run.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

constexpr int kSegments = 8;
const double kUnit = std::sqrt(207e9 / 7850.0) * 0.01 / 4.0;  // sqrt(EI / (m L^4)) of the rod below [1/s]

// First mode of the cantilever at rest, up to a factor.
double first_shape(double x) {
  const double b = 1.875104069, s = (std::cosh(b) + std::cos(b)) / (std::sinh(b) + std::sin(b));
  return std::cosh(b * x) - std::cos(b * x) - s * (std::sinh(b * x) - std::sin(b * x));
}
double middle(int k) { return (k + 0.5) / kSegments; }

std::string blade(double rate) {
  std::ostringstream text;
  text.precision(15);
  text << "end_time = 1\ngravity = [0, 0, 0]\n[materials.steel]\ndensity = 7850\nyoung_GPa = 207\n[[bodies]]\nname = "
          "\"blade\"\n"
       << "material = \"steel\"\nshape = { kind = \"rod\", from = [0, 0, 0], to = [1, 0, 0], diameter = 0.01 }\n"
       << "flexible = { segments = " << kSegments
       << ", damping = 0 }\n[[joints]]\nname = \"hub\"\ntype = \"prescribed\"\n"
       << "bodies = [\"ground\", \"blade\"]\npoint = [0, 0, 0]\naxis = \"z\"\naxis2 = \"x\"\nmotion = { x = { "
          "polynomial = [0] }, "
       << "y = { polynomial = [0] }, z = { polynomial = [0] }, rotation = { polynomial = [0, " << rate
       << "] }, hold_other_rotations = true }\n[initial]\nvelocity = [0, 0, 0]\n";
  // The velocity of a small flap in the first mode.
  for (int k = 0; k < kSegments; ++k)
    text << "[[initial.bodies]]\nbody = \"blade_" << k + 1 << "\"\nvelocity = [0, " << rate * middle(k) << ", "
         << 1e-3 * first_shape(middle(k)) << "]\nangular_velocity = [0, 0, " << rate << "]\n";
  return text.str();
}

// From the zeros of sum shape z over some periods, in units of kUnit; `guess` likewise.
double flap_frequency(double eta, double guess) {
  const Mechanism mechanism = build_mechanism(SceneText().read(blade(eta * kUnit)));
  test::Run run(mechanism.model, "one_step", test::tight(1e-5));
  const auto flap = [&] {
    double sum = 0.0;
    for (int k = 0; k < kSegments; ++k) sum += first_shape(middle(k)) * run.body(k).r.z();
    return sum;
  };
  constexpr int kSamples = 24, kPeriods = 1;
  const double h = 2.0 * kPi / (guess * kUnit) / kSamples;
  double first = 0.0, last = 0.0, before = 0.0;
  int zeros = 0;
  for (int i = 1; zeros < 2 * kPeriods + 1 && i < 2 * kPeriods * kSamples; ++i) {
    const double t = run.state.time;
    run.to(t + h);
    const double now = flap();
    if (i > 1 && (now > 0.0) != (before > 0.0)) {
      last = t + h * before / (before - now);
      if (zeros++ == 0) first = last;
    }
    before = now;
  }
  return (zeros - 1) * kPi / (last - first) / kUnit;
}

TEST(Segments, StiffenASpinningRodAsItsTensionDoes) {
  // Within a segment tension does not stiffen: that share falls with the square of their number.
  constexpr double kOfEightSegments = 0.01;
  const double table[][2] = {{0, 3.5160}, {3, 4.7973}, {6, 7.3604}};
  for (const auto& [eta, exact] : table) {
    const double found = flap_frequency(eta, exact);
    std::printf("eta %g: %.4f, exact %.4f, %.2f %%\n", eta, found, exact, 100.0 * (found / exact - 1.0));
    EXPECT_NEAR(found, exact, kOfEightSegments * exact) << "spin rate " << eta;
  }
}

}  // namespace
}  // namespace footfall
