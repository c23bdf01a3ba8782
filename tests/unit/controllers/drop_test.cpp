// mbd_solver/model/controllers/controller.h:
// what a controller does to a landing, in the smallest model that shows it: a rigid mass on four equal MR
// struts (gas spring, damper with coil lag, end stop) above ground that yields like regolith. One degree of
// freedom, sampled control, closed loop.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

#include "mbd_solver/model/controllers/constant_controller.h"
#include "mbd_solver/model/controllers/fuzzy_controller.h"
#include "mbd_solver/model/laws/end_stop.h"
#include "mbd_solver/model/laws/gas_spring.h"
#include "mbd_solver/model/laws/mr_damper.h"
#include "tests/unit/controllers/fuzzy_files.h"

namespace footfall {
namespace {

constexpr double kMass = 1250.0;   // [kg] [Lin25 Table 3]
constexpr double kGravity = 1.63;  // [m/s2]
constexpr double kSpeed = 3.8;     // at touchdown [m/s]
// ground force of one pad at depth z: kSoil z^2 [N/m2], about the 17 to 20 kN at 0.1 m of the bed
constexpr double kSoil = 2.0e6;
constexpr double kStroke = 0.32;  // end stop [m]
constexpr double kStep = 1.0e-4;  // [s]

struct Landing {
  double peak = 0.0;     // largest upward acceleration [g]
  double stroke = 0.0;   // largest stroke [m]
  double rebound = 0.0;  // largest upward speed [m/s]
};

struct Strut {
  GasSpring gas{{}};
  MrDamper damper;
  EndStop stop{{0.0, kStroke}};
  StrutOutput none{0}, coil{1};
  Strut()
      : damper([] {
          MrDamperParameters p;
          p.coil_lag = 0.002;
          return p;
        }()) {}
  double force(double x, double rate, double command, const Eigen::VectorXd& z) {
    const Eigen::VectorXd empty;
    gas.evaluate({x, rate, command, empty}, none);
    double sum = none.force;
    stop.evaluate({x, rate, command, empty}, none);
    sum += none.force;
    damper.evaluate({x, rate, command, z}, coil);
    return sum + coil.force;
  }
};

// Each step: the massless pad either stands (strut force below what the ground bears), sinks (they are
// equal), or hangs free (0).
Landing land(Controller& controller, double until = 0.4) {
  Strut strut;
  Landing result;
  Eigen::VectorXd u = Eigen::VectorXd::Zero(4), z = Eigen::VectorXd::Zero(1);
  ControllerMeasurement m;
  m.strut_rate = Eigen::VectorXd::Zero(4);
  double v = -kSpeed, x = 0.0, depth = 0.0, a = -kGravity;
  const int every = static_cast<int>(std::lround(controller.period() / kStep));
  for (int n = 0; n * kStep < until; ++n) {
    if (n % every == 0) {
      m.time = n * kStep;
      m.acceleration = a;
      m.velocity = v;
      controller.sample(m, u);
    }
    const double bearing = kSoil * depth * depth;
    double rate = -v, f = strut.force(x, rate, u[0], z);
    const double target = std::clamp(f, 0.0, bearing);
    const bool sinks = f > bearing;
    if (target != f) {  // find the rate at which the strut gives the target; the force rises with the rate
      double low = rate - 20.0, high = rate + 20.0;
      for (int i = 0; i < 45; ++i) {
        const double middle = 0.5 * (low + high);
        (strut.force(x, middle, u[0], z) < target ? low : high) = middle;
      }
      rate = 0.5 * (low + high), f = target;
    }
    a = 4.0 * f / kMass - kGravity;
    z[0] += (u[0] - z[0]) * -std::expm1(-kStep / 0.002);
    x += kStep * rate;
    if (sinks) depth += kStep * (-v - rate);
    v += kStep * a;
    result.peak = std::max(result.peak, a / kStandardGravity);
    result.stroke = std::max(result.stroke, x);
    result.rebound = std::max(result.rebound, v);
  }
  return result;
}

Landing constant(double voltage) {
  ConstantControllerParameters p;
  p.voltages = Eigen::VectorXd::Constant(4, voltage);
  ConstantController controller(p);
  return land(controller);
}

Landing fuzzy(double period, bool tabulated = false) {
  FuzzyControllerParameters p;
  p.file = lander_file();
  p.period = period;
  p.tabulated = tabulated;
  p.grid = {25, 9, 17, 17};
  FuzzyController controller(p);
  return land(controller);
}

// The stated cost: peak acceleration, among landings that keep clear of the end stop and do not jump (rebound
// at most 0.1 m/s). Without the second condition U = 0 wins by itself: a semi-active damper can add to the
// viscous force of a passive one, never take from it.
TEST(Drop, FuzzyHasASmallerPeakThanEveryConstantVoltageThatDoesNotJump) {
  constexpr double kJump = 0.1;  // [m/s]
  const Landing controlled = fuzzy(1e-3);
  std::cout << "fuzzy: peak " << controlled.peak << " g, stroke " << controlled.stroke << " m, rebound "
            << controlled.rebound << " m/s\n";
  EXPECT_LT(controlled.stroke, kStroke);
  EXPECT_LT(controlled.rebound, kJump);
  int admissible = 0;
  for (int i = 0; i <= 10; ++i) {
    const Landing passive = constant(0.1 * i);
    std::cout << "U = " << 0.1 * i << ": peak " << passive.peak << " g, stroke " << passive.stroke << " m, rebound "
              << passive.rebound << " m/s\n";
    if (passive.stroke >= kStroke || passive.rebound > kJump) continue;
    ++admissible;
    EXPECT_LT(controlled.peak, passive.peak) << "U = " << 0.1 * i;
  }
  EXPECT_GT(admissible, 5);
}

TEST(Drop, HalvingTheControlPeriodChangesThePeakByLessThanTwoPercent) {
  const double whole = fuzzy(1e-3).peak, half = fuzzy(0.5e-3).peak;
  std::cout << "peak at 1 ms " << whole << " g, at 0.5 ms " << half << " g\n";
  EXPECT_LT(std::abs(half - whole), 0.02 * whole);
}

TEST(Drop, TableAndControllerLandAlike) {
  const Landing exact = fuzzy(1e-3), table = fuzzy(1e-3, true);
  // A voltage within 0.02 (coarse grid) is 0.02 * 4 * 8279 N / 1250 kg = 0.05 g.
  EXPECT_NEAR(exact.peak, table.peak, 0.05);
  EXPECT_NEAR(exact.stroke, table.stroke, 0.005);
}

}  // namespace
}  // namespace footfall
