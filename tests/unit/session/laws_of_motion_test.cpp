// Whole scenes against closed forms: friction that sticks, shafts, cams, work, scales, stiff springs, damping of held bodies.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "mbd_solver/assemble/codes.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/session/observe/attached_damping.h"
#include "mbd_solver/session/session.h"
#include "tests/support/scene_texts.h"
#include "tests/unit/assemble/kind_scenes.h"
#include "tests/unit/session/recorded.h"

namespace footfall {
namespace {

using test::body;
using test::joint;

std::string text(double x) { return test::word(x); }
using Rows = test::Ran;

// --- Velocities at the start.

// A free pair that is bent at its hinge before it starts spins as one body, about its own mass centre.
TEST(InitialVelocities, AreThoseOfThePlaceInWhichAMechanismStarts) {
  const Rows rows("end_time = 1e-6\ngravity = [0, 0, 0]\noutput = { attitudes = true, interval = 1e-6 }\n" +
                  body("a", 2.0, 0.1, "[0, 0, 0]") + body("b", 1.0, 0.05, "[1, 0, 0]") +
                  joint("h", "revolute", "a", "b", "[0.5, 0, 0]", "y") +
                  "[initial]\nvelocity = [0, 0, 0.5]\nangular_velocity = [0, 0, 2]\njoints = { h = 1.5 }\n");
  for (const std::string name : {"a", "b"})
    for (const auto& [axis, right] : {std::pair{".wx", 0.0}, {".wy", 0.0}, {".wz", 2.0}})
      EXPECT_NEAR(rows.last(name + axis), right, 1e-5) << name << axis;
  for (const auto& [axis, right] : {std::pair{".vx", 0.0}, {".vy", 0.0}, {".vz", 0.5}})
    EXPECT_NEAR((2.0 * rows.last("a" + std::string(axis)) + rows.last("b" + std::string(axis))) / 3.0, right, 1e-9)
        << axis;
  // The distance of b from the mass centre along x, 2/3 of (0.5 + 0.5 cos(1.5)), times the spin.
  EXPECT_NEAR(rows.last("b.vy"), 2.0 * (1.0 + std::cos(1.5)) / 3.0, 1e-5);
}

// A sampled force acts from the start: the first row has it, and what it drives.
TEST(SampledSignals, AreInTheFirstRow) {
  const Rows rows("end_time = 0.2\ngravity = [0, 0, 0]\noutput = { interval = 0.05 }\n" +
                  body("b", 2.0, 0.1, "[0, 0, 0]") +
                  "[[signals]]\nname = \"e\"\nkind = \"expression\"\ninput = \"10 + time\"\nperiod = 0.1\n"
                  "[[forces]]\nname = \"f\"\nbody = \"b\"\ndirection = [0, 0, 1]\nforce = { signal = \"e\" }\n");
  EXPECT_EQ(rows.value(0, "signal.e"), 10.0);
  EXPECT_NEAR(rows.value(0, "b.az"), 5.0, 1e-12);
}

// --- Dry friction (theory 3.6).

// A body on rails under a force that is there at once.
std::string pushed(double force, double mass, const std::string& more = "") {
  return "end_time = 5.0\ngravity = [" + text(force / mass) + ", 0, -9.81]\n" + body("b", mass, 0.1, "[0, 0, 0]") +
         joint("p", "prismatic", "ground", "b", "[0, 0, 0]", "\"x\"") +
         "displacement = { friction = { coulomb = 4.0, breakaway = 5.2 } }\n" + more;
}

TEST(DryFriction, HoldsWhatIsBelowBreakawayHoweverFastItComes) {
  for (const char* integrator : {"solver.integrator=\"one_step\"", "solver.integrator=\"ida\""}) {
    for (const double mass : {1e-3, 1.0, 100.0}) {
      // F / k of the bristle, k = F_c / 1e-5 m.
      EXPECT_NEAR(Rows(pushed(5.1, mass), {integrator, "solver.max_step=1"}).last("p.displacement"), 5.1 / 4.0 * 1e-5,
                  1e-7)
          << mass;
      // It slides by (F - F_c) / m from the start; the bristle delays it by less than a percent of 5 s.
      const double way = 0.5 * (5.3 - 4.0) / mass * 25.0;
      EXPECT_NEAR(Rows(pushed(5.3, mass), {integrator, "solver.max_step=1"}).last("p.displacement"), way, 0.02 * way)
          << mass;
    }
  }
}

TEST(DryFriction, SettlesUnderWhatItBears) {
  const Rows run(pushed(4.9, 1.0, "[initial]\nsettle = true\n"));
  EXPECT_NEAR(run.rows.front()[1], 4.9 / 4.0 * 1e-5, 1e-8);  // b.x
  EXPECT_NEAR(run.last("p.displacement"), 4.9 / 4.0 * 1e-5, 1e-8);
}

// Between F_b and twice F_b the friction holds a load that the search for rest brings at once, but the joint slides.
TEST(DryFriction, DoesNotSettleUnderWhatItDoesNotBear) {
  for (const double force : {5.21, 7.0, 10.3}) try {
      Rows(pushed(force, 1.0, "[initial]\nsettle = true\n"));
      ADD_FAILURE() << force << " N are more than 5.2 N";
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_TRUE(test::names(message, {"E0665", "joints.p.displacement"})) << message;
    }
}

// A spring that pulls by more than F_b draws the body to where the sliding friction bears it, and there it stays.
TEST(DryFriction, SettlesWhereASpringNoLongerMovesIt) {
  const std::string spring =
      "[[struts]]\nname = \"s\"\nbodies = [\"ground\", \"b\"]\npoints = [[1.0, 0, 0], [0, 0, 0]]\nspring = { stiffness "
      "= "
      "100.0, free_length = 1.0 }\n[initial]\nsettle = true\n";
  const Rows run(pushed(7.0, 1.0, spring));
  EXPECT_NEAR(run.rows.front()[1], (7.0 - 4.0) / 100.0, 1e-6);  // b.x
  EXPECT_NEAR(run.last("p.displacement"), run.rows.front()[1], 1e-7);
}

// A mass on a belt of speed v, held by a spring k, sticks until k x = F_b and slips as an oscillator about F_c / k:
//   T = 2 A / v + (2 / w) (pi - atan(A w / v)),   A = (F_b - F_c) / k,  w^2 = k / m
class Belt : public ::testing::TestWithParam<const char*> {};
TEST_P(Belt, SticksAndSlipsWithTheClosedPeriod) {
  const double v = 0.1, k = 100.0, m = 1.0, F_c = 4.0, F_b = 5.2;
  const std::string scene = "end_time = 4.0\ngravity = [0, 0, -9.81]\n" + body("belt", 5.0, 0.1, "[0, 0, 0]") +
                            body("m", m, 0.1, "[0, 0, 0.1]") +
                            joint("drive", "prescribed", "ground", "belt", "[0, 0, 0]", "\"z\"") +
                            R"(axis2 = "x"
motion = { x = { polynomial = [0, 0.1] }, y = { polynomial = [0] }, z = { polynomial = [0] }, rotation = { polynomial = [0] }, hold_other_rotations = true }
)" + joint("p", "prismatic", "belt", "m", "[0, 0, 0.1]", "\"x\"") +
                            R"(displacement = { friction = { coulomb = 4.0, breakaway = 5.2 } }
[[struts]]
name = "s"
bodies = ["ground", "m"]
points = [[-1.0, 0, 0.1], [0, 0, 0.1]]
spring = { stiffness = 100.0, free_length = 1.0 }
[initial]
bodies = [{ body = "belt", velocity = [0.1, 0, 0] }, { body = "m", velocity = [0.1, 0, 0] }]
[output]
interval = 0.001
)";
  const Rows run(scene, {std::string("solver.integrator=\"") + GetParam() + "\""});
  const std::vector<double> t = run.column("time"), x = run.column("m.x");
  std::vector<double> crossings;
  for (std::size_t i = 1; i < t.size(); ++i)
    if (x[i - 1] < 0.04 && x[i] >= 0.04)  // on the belt, at v
      crossings.push_back(t[i - 1] + (0.04 - x[i - 1]) / (x[i] - x[i - 1]) * (t[i] - t[i - 1]));
  ASSERT_GE(crossings.size(), 5u);
  const double A = (F_b - F_c) / k, w = std::sqrt(k / m);
  const double period = 2.0 * A / v + 2.0 / w * (kPi - std::atan(A * w / v));
  EXPECT_NEAR(crossings.back() - crossings[crossings.size() - 2], period, 1e-3 * period);
  EXPECT_LT(run.metrics.energy_balance, 1e-4 * run.metrics.energy_flow);
}
INSTANTIATE_TEST_SUITE_P(Integrators, Belt, ::testing::Values("one_step", "ida"));

// --- Shafts and cams.

std::string bent_shafts(const std::string& axis2) {
  return "end_time = 2.0\ngravity = [0, 0, 0]\n" + body("a", 1.0, 0.1, "[0, 0, -0.5]") +
         body("b", 1.0, 0.1, "[0.286788218175523, 0.0, 0.409576022144496]") +
         joint("ja", "revolute", "ground", "a", "[0, 0, -0.5]", "\"z\"") +
         joint("u", "constant_velocity", "a", "b", "[0, 0, 0]", "\"z\"") + axis2 + "\n" +
         joint("jb", "revolute", "ground", "b", "[0.286788218175523, 0.0, 0.409576022144496]",
               "[0.573576436351046, 0.0, 0.819152044288992]") +
         R"([[forces]]
name = "f"
body = "a"
direction = [0, 0, 1]
torque = { polynomial = [1.0] }
[output]
interval = 0.02
)";
}

// Drawn bent by 35 degrees: with the axes of both shafts they turn alike, w = T t / (I_a + I_b).
TEST(ConstantVelocity, TurnsEvenlyWhereItIsDrawnBent) {
  for (const char* axis2 : {"axis2 = [0.573576436351046, 0.0, 0.819152044288992]",
                            "axis2 = [-0.573576436351046, 0.0, -0.819152044288992]"}) {
    const Rows run(bent_shafts(axis2));
    const std::vector<double> t = run.column("time"), a = run.column("ja.angle_rate"), b = run.column("jb.angle_rate");
    for (std::size_t i = 0; i < t.size(); ++i) {
      EXPECT_NEAR(a[i], 5.0 * t[i], 1e-4) << t[i];  // rtol 1e-6 of 10 rad/s
      EXPECT_NEAR(b[i], 5.0 * t[i], 1e-4) << t[i];
    }
  }
}

TEST(ConstantVelocity, IsRefusedWhereOneAxisCannotBeThatOfBothShafts) {
  const std::string findings = SceneText().findings(bent_shafts(""));
  EXPECT_TRUE(test::names(findings, {"E0161", "joints.u.axis2", "35", "jb", "0.573576"})) << findings;
  EXPECT_EQ(SceneText().findings(bent_shafts("axis2 = \"z\"")), "");  // whoever says so means it
}

// A shaft turns at 9 rad/s through an open curve and beyond its end, where the rod continues along the tangent.
TEST(OpenCam, GoesOnAlongItsTangentPastHalfATurn) {
  const std::string scene = "end_time = 1.0\ngravity = [0, 0, 0]\n" + body("s", 1.0, 0.1, "[0, 0, 0]") +
                            body("rod", 2.0, 0.1, "[1, 0, 0]") +
                            joint("sa", "revolute", "ground", "s", "[0, 0, 0]", "\"z\"") +
                            joint("ro", "prismatic", "ground", "rod", "[1, 0, 0]", "\"x\"") +
                            R"([[gears]]
name = "cam"
joints = ["ro", "sa"]
factors = [1, -1]
curve = [[0, 0], [1, 0.004], [2, 0.016], [3, 0.025], [4, 0.024], [5, 0.011]]
[initial]
bodies = [{ body = "s", angular_velocity = [0, 0, 9.0] }]
[output]
interval = 0.02
)";
  const CubicSpline curve("y", {0, 1, 2, 3, 4, 5}, {0, 0.004, 0.016, 0.025, 0.024, 0.011});
  for (const double direction : {1.0, -1.0}) {
    const Rows run(scene, {"initial.bodies.s.angular_velocity=[0,0," + text(9.0 * direction) + "]", "solver.rtol=1e-8",
                           "solver.max_step=1"});
    const std::vector<double> q = run.column("sa.angle"), x = run.column("ro.displacement");
    EXPECT_GT(std::abs(q.back()), 7.0);
    for (std::size_t i = 0; i < q.size(); ++i) EXPECT_NEAR(x[i], curve.at(q[i]).value, 1e-9) << q[i];
    const std::vector<double> energy = run.column("energy.total");
    EXPECT_NEAR(energy.back(), energy.front(), 1e-5 * energy.front());  // jumps of the curve's third derivative
  }
}

// --- Work.

// A body that turns at 20 rad/s is moved by 0.1 sin(2 pi t): the work of the motion is the kinetic energy of that, m x'^2 / 2.
TEST(Work, OfAPrescribedMotionStandsUnderTheErrorTest) {
  const std::string scene = "end_time = 2.0\ngravity = [0, 0, 0]\n" + body("a", 2.0, 0.3, "[0.5, 0, 0]") +
                            joint("d", "prescribed", "ground", "a", "[0, 0, 0]", "\"z\"") +
                            R"(axis2 = "x"
motion = { x = { amplitude = 0.1, frequency = 1.0 }, y = { polynomial = [0] }, z = { polynomial = [0] }, rotation = { polynomial = [0, 20.0] }, hold_other_rotations = true }
[initial]
bodies = [{ body = "a", velocity = [0.6283185307179586, 10.0, 0], angular_velocity = [0, 0, 20.0] }]
[output]
interval = 0.0173
)";
  for (const double rtol : {1e-4, 1e-6}) {
    const Rows run(scene, {"solver.rtol=" + text(rtol), "solver.max_step=1"});
    const std::vector<double> work = run.column("work.motion"), energy = run.column("energy.kinetic");
    double error = 0.0, size = 0.0;
    for (std::size_t i = 0; i < work.size(); ++i) {
      error = std::max(error, std::abs(work[i] - (energy[i] - energy[0])));
      size = std::max(size, std::abs(energy[i] - energy[0]));
    }
    EXPECT_LT(error, 100.0 * rtol * size) << rtol;  // the errors of some hundred steps
    EXPECT_GE(run.metrics.energy_balance, 0.999 * error) << rtol;
    ASSERT_EQ(run.work_estimates().size(), 1u);
    EXPECT_GE(run.work_estimates()[0].error, 0.999 * error) << rtol;
    EXPECT_GE(energy_balance_relative(run.metrics, run.work_estimates()), 0.999 * error / size) << rtol;
  }
}

// Force and damper of a shaken strut take nearly the same work with nearly the same error, which cancels in the sum.
TEST(Work, OfAShakenStrutHasNoLargerErrorThanItsBalance) {
  const std::string scene = "end_time = 2.0\ngravity = [0, 0, 0]\n" + body("a", 2.0, 0.1, "[0, 0, 0]") +
                            joint("s", "prismatic", "ground", "a", "[0, 0, 0]", "\"x\"") +
                            R"([[struts]]
name = "k"
bodies = ["ground", "a"]
points = [[-1, 0, 0], [0, 0, 0]]
mr = { yield_force = 50, viscous = 20, regularisation_speed = 0.02, voltage = 0.5 }
spring = { stiffness = 2000, damping = 0 }
[[forces]]
name = "f"
body = "a"
direction = [1, 0, 0]
frame = "inertial"
force = { amplitude = 120, frequency = 5 }
[output]
interval = 0.01
)";
  const Rows exact(scene, {"solver.rtol=1e-10", "solver.max_step=1"});
  for (const double rtol : {1e-3, 1e-4}) {
    const Rows run(scene, {"solver.rtol=" + text(rtol), "solver.max_step=1"});
    const double balance = energy_balance_relative(run.metrics, run.work_estimates());
    for (const char* column : {"work.force", "dissipated.mr_viscous", "dissipated.mr_yield"})
      EXPECT_LE(std::abs(run.last(column) - exact.last(column)), balance * run.metrics.energy_flow) << column << rtol;
  }
}

// A body on a damped spring, 7.8 Hz, half critically damped: a step of ida depends on several before it, which carry its error
// on. What the damper takes tends to the kinetic energy of the start, 1.01 J.
TEST(Work, OfADampedSpringIsWithinTheBoundOfIda) {
  const std::string scene = "end_time = 2.0\ngravity = [0, 0, 0]\n" + body("a", 2.02, 1.0, "[0, 0, 0]") +
                            joint("s", "prismatic", "ground", "a", "[0, 0, 0]", "\"z\"") +
                            R"([joints.displacement.spring]
stiffness = 4871.2
damping = 99.24
[initial]
bodies = [{ body = "a", velocity = [0, 0, 1.0] }]
[output]
interval = 0.01
)";
  const std::vector<double> exact = Rows(scene, {"solver.rtol=1e-11"}).column("dissipated.damper");
  EXPECT_NEAR(exact.back(), 1.01, 1e-6);
  for (const double rtol : {1e-3, 1e-4, 1e-6}) {
    const Rows run(scene, {"solver.integrator=ida", "solver.rtol=" + text(rtol)});
    const std::vector<double> work = run.column("dissipated.damper");
    double error = 0.0;
    for (std::size_t i = 0; i < work.size(); ++i) error = std::max(error, std::abs(work[i] - exact[i]));
    ASSERT_EQ(run.work_estimates().size(), 1u);
    EXPECT_LE(error, run.work_estimates()[0].error) << rtol;
  }
}

// Of every kind of force, damper, drive, spring and motion: the error of each integral is at most what the run reports, whether
// it comes from the rule of integration or from the motion that the rule follows.
TEST(Work, OfEveryKindIsWithinTheErrorThatIsReported) {
  std::map<std::string, std::string> scenes = {{"planar", test::planar_scene()}};
  for (const auto& [kind, keys] : test::kJointKeys) scenes["joint " + kind] = test::joint_scene(kind);
  for (const auto& [kind, keys] : test::kLawKeys) scenes["law " + kind] = test::law_scene(kind);
  for (const auto& [kind, keys] : test::kSpringKeys) scenes["spring " + kind] = test::spring_scene(kind);
  for (const auto& [kind, keys] : test::kForceKeys) scenes["force " + kind] = test::force_scene(kind);
  for (const auto& [kind, keys] : test::kDriveKeys) scenes["drive " + kind] = test::drive_scene(kind);
  std::size_t compared = 0;
  for (const auto& [name, scene] : scenes) {
    const Rows exact(scene, {"solver.rtol=1e-10", "solver.atol=1e-12", "solver.max_step=0.01"});
    for (const double rtol : {1e-4, 1e-6}) {
      const Rows run(scene, {"solver.rtol=" + text(rtol), "solver.max_step=1"});
      for (const WorkEstimate& estimate : run.work_estimates()) {
        const std::vector<double> work = run.column(estimate.column), truth = exact.column(estimate.column);
        double error = 0.0;
        for (std::size_t i = 0; i < work.size(); ++i) error = std::max(error, std::abs(work[i] - truth[i]));
        const double few_steps = rtol > 1e-5 ? 2.0 : 1.0;  // some ten in all: estimates have no order there
        EXPECT_LE(error, few_steps * estimate.error + 1e-9 * run.metrics.energy_flow)  // of `exact`
            << name << ", " << estimate.column << ", rtol " << rtol;
        ++compared;
      }
    }
  }
  EXPECT_GE(compared, 40u);
}

// --- Scales.

// A lander of length L, on three balls, thrown and spinning onto rough ground under the same gravity: times grow with sqrt(L),
// masses with L^3, so that angles are the same in any size.
TEST(Scales, OfALanderDoNotChangeItsAttitude) {
  const auto yaw = [](double L) {
    const double T = std::sqrt(L), m = 100.0 * L * L * L, V = L / T;
    std::string scene = "end_time = " + text(3.0 * T) + "\ngravity = [0, 0, -1.62]\n" +
                        body("hull", m, 20.0 * L * L * L * L * L, "[0, 0, " + text(0.6 * L) + "]");
    for (int k = 0; k < 3; ++k) {
      const double a = 2.0 * kPi * k / 3.0;
      const std::string name = "foot_" + std::to_string(k);
      const std::string place = "[" + text(L * std::cos(a)) + ", " + text(L * std::sin(a)) + ", 0]";
      scene += "[[bodies]]\nname = \"" + name + "\"\nmass = " + text(0.02 * m) +
               "\nshape = { kind = \"sphere\", centre = " + place + ", radius = " + text(0.1 * L) +
               " }\n[[joints]]\nname = \"leg_" + std::to_string(k) + "\"\nkind = \"fixed\"\nbodies = [\"hull\", \"" +
               name + "\"]\npoint = " + place + "\n[[boundaries]]\nbody = \"" + name + "\"\nsurface = {}\n";
    }
    scene += "[ground]\nkind = \"plane\"\n[ground.plane]\nstiffness = " + text(2e5 * m / 100.0 * std::pow(L, -1.5)) +
             "\ndamping = " + text(1.0 / V) + "\nfriction = 0.4\n[initial]\nclearance = " + text(0.01 * L) +
             "\nvelocity = [" + text(0.5 * V) + ", 0, " + text(-0.5 * V) + "]\nangular_velocity = [0, 0, " +
             text(0.5 / T) + "]\n[output]\ninterval = " + text(0.5 * T) +
             "\n[solver]\nrtol = 1e-7\natol = " + text(1e-9 * L) + "\nmax_step = " + text(1e-3 * T) + "\n";
    return Rows(scene).last("hull.yaw");
  };
  const double metres = yaw(1.0);
  EXPECT_GT(std::abs(metres), 0.02);
  // Errors of integration alone; velocities have their tolerance in m/s.
  EXPECT_NEAR(yaw(1e-3), metres, 1e-3 * std::abs(metres));
  EXPECT_NEAR(yaw(1e3), metres, 1e-3 * std::abs(metres));
}

// --- Damping of flexible bodies.

std::string beam(const std::string& more) {
  return R"(end_time = 1.0
gravity = [0, 0, -1.0]
[[bodies]]
name = "b"
material = "al"
shape = { kind = "rod", from = [0, 0, 0], to = [1.0, 0, 0], diameter = 0.02 }
flexible = { elements = 10, modes = 6, damping = 0.02 }
)" + more +
         R"(
[materials.al]
density = 2700.0
young = 70000000000.0
poisson = 0.3
)";
}

// Of a cantilever the lowest frequency is 1.8751^2 / (2 pi) sqrt(EI / (rho A)), and its damping ratio far below the ratio of free
// modes. The damping that the warning gives leads to the ratio that was given.
TEST(AttachedDamping, IsToldWithTheValueThatGivesTheRatio) {
  const auto found = [](const std::string& toml, const std::vector<std::string>& settings = {}) {
    const SceneText folder;
    const Scene scene = folder.read(toml, settings);
    return attached_damping(scene, build_mechanism(scene));
  };
  EXPECT_TRUE(found(beam("")).empty());
  const std::string clamp =
      "[[joints]]\nname = \"c\"\nkind = \"fixed\"\nbodies = [\"ground\", \"b\"]\npoint = [0, 0, 0]\n";
  const std::vector<AttachedDamping> held = found(beam(clamp));
  ASSERT_EQ(held.size(), 1u);
  const double frequency = 1.8751 * 1.8751 / (2.0 * kPi) * std::sqrt(70e9 / 2700.0 * 0.02 * 0.02 / 16.0);
  EXPECT_NEAR(held[0].frequency, frequency, 0.01 * frequency);  // six modes
  EXPECT_LT(held[0].ratio, 0.2 * held[0].given);
  EXPECT_NEAR(held[0].given, 0.02, 1e-12);
  const double other = held[0].given * held[0].given / held[0].ratio;
  const std::vector<AttachedDamping> mended = found(beam(clamp), {"bodies.b.flexible.damping=" + text(other)});
  ASSERT_EQ(mended.size(), 1u);
  EXPECT_NEAR(mended[0].ratio, 0.02, 1e-6);
}

// A soft cantilever sinks by rho A g L^4 / 8 E I = 0.193 m under its weight, an eighth of it from its mean axes; the free beam
// hardly bends.
TEST(AttachedDamping, TellsOfBeamsThatBendTooFarAsJointsHoldThem) {
  const std::string clamp =
      "[[joints]]\nname = \"c\"\nkind = \"fixed\"\nbodies = [\"ground\", \"b\"]\npoint = [0, 0, 0]\n";
  const auto bends = [&](const std::string& joint, const std::string& young) {
    const SceneText folder;
    const Scene read = folder.read(beam(joint), {"materials.al.young=" + young});
    for (const std::string& warning : warnings_of_held_bodies(read, build_mechanism(read)))
      if (warning.find(code::kBendsUnderWeight.number) != std::string::npos) return true;
    return false;
  };
  EXPECT_TRUE(bends(clamp, "7e7"));
  EXPECT_FALSE(bends(clamp, "7e10"));
  EXPECT_FALSE(bends("", "7e7"));
}

// Three cantilevers side by side have modes of one frequency, in which the third one must not damp the others.
TEST(AttachedDamping, IsToldOnceForBodiesOfEqualNumbers) {
  const std::string one = beam("");
  const std::size_t body = one.find("[[bodies]]"), next = one.find("\n[", body + 1);
  std::string scene = one, joints;
  for (const char* name : {"c", "d"}) {
    std::string other = one.substr(body, next - body + 1);
    other.replace(other.find("\"b\""), 3, std::string("\"") + name + "\"");
    scene.insert(next + 1, other);
  }
  for (const std::string name : {"b", "c", "d"})
    joints += "[[joints]]\nname = \"held_" + name + "\"\nkind = \"fixed\"\nbodies = [\"ground\", \"" + name +
              "\"]\npoint = [0, 0, 0]\n";
  const SceneText folder;
  const Scene read = folder.read(scene + joints, {"bodies.d.flexible.damping=0.05"});
  const std::vector<std::string> told = warnings_of_held_bodies(read, build_mechanism(read));
  ASSERT_EQ(told.size(), 2u);
  EXPECT_NE(told[0].find("bodies.{b, c}.flexible"), std::string::npos) << told[0];
  EXPECT_NE(told[1].find("bodies.d.flexible"), std::string::npos) << told[1];
}

// --- Cables that signals read, and that leave pulleys.

// A mass hangs in a cable of k = 800 N/m, and a force that a continuous signal makes of the tension pulls it up as well:
//   m z'' = (1 + s) k (z_0 - z) - m g
TEST(Cable, WhoseTensionASignalReadsSwingsAsTheStifferOne) {
  const double m = 2.0, k = 800.0, s = 1.25, g = 9.81, start = 0.005;
  const test::Ran ran(R"(end_time = 0.8
gravity = [0, 0, -9.81]
bodies = [{ name = "load", mass = 2, inertia = [1, 1, 1], position = [0, 0, -1] }]
cables = [{ name = "rope", stiffness = 800, tension = 4, path = [{ body = "ground", point = [0, 0, 0] }, { body = "load", point = [0, 0, -1] }] }]
signals = [{ name = "lift", kind = "expression", input = "1.25 * rope.force" },
           { name = "way", kind = "expression", input = "rope.length + rope.slack + rope.unstretched" }]
forces = [{ name = "winch", body = "load", direction = [0, 0, 1], force = { signal = "lift" } }]
[solver]
rtol = 1e-8
[output]
interval = 0.01
)");
  const double rest = m * g / ((1.0 + s) * k), w = std::sqrt((1.0 + s) * k / m);  // stretch of the rest; 30 rad/s
  for (std::size_t row = 0; row < ran.rows.size(); ++row) {
    const double stretch = rest + (start - rest) * std::cos(w * ran.value(row, "time"));
    EXPECT_NEAR(ran.value(row, "load.z"), -1.0 + start - stretch, 1e-7) << row;  // tolerance of the integrator
    EXPECT_NEAR(ran.value(row, "signal.lift"), s * k * stretch, 1e-3) << row;
    EXPECT_NEAR(ran.value(row, "signal.way"), 2.0 - 2.0 * start + stretch, 1e-6) << row;
  }
}

// A mass falls on a damped rope. Where the rope relaxes faster than its spring pushes, the force is zero and the motion exact for steps
// of any length, while the damper still gives heat. Values: an own integration of theory 3.8 with the classical method of fourth
// order in steps of 2e-7 s.
TEST(Cable, DampersGiveTheirHeatWithinTheTolerance) {
  struct Case {
    double rtol, heat, place;  // and the errors allowed [J], [m]
  };
  for (const auto& [rtol, heat, place] : {Case{1e-6, 1e-3, 5e-5}, {1e-8, 4e-5, 1e-6}, {1e-10, 4e-7, 2e-8}}) {
    const test::Ran ran(
        "end_time = 3\ngravity = [0, 0, -9.81]\n"
        "bodies = [{ name = \"a\", mass = 2, inertia = [1, 1, 1], position = [0, 0, -1] }]\n"
        "joints = [{ name = \"j\", kind = \"prismatic\", bodies = [\"ground\", \"a\"], point = "
        "[0, 0, -1], axis = \"z\" }]\n"
        "cables = [{ name = \"c\", stiffness = 2e4, damping = 10, slack = 0.3, path = [{ body = \"ground\", "
        "point = [0, 0, 0] }, { body = \"a\", point = [0, 0, -1] }] }]\n[solver]\natol = 1e-10\nrtol = " +
        text(rtol) + "\n[output]\ninterval = 0.1\n");
    EXPECT_NEAR(ran.last("dissipated.damper"), 4.04455666, heat) << rtol;
    EXPECT_NEAR(ran.last("a.z"), -1.300335783, place) << rtol;
  }
}

// A drum of 0.1 m takes up a cable with more than a whole turn; a continuous signal reads what the column has.
TEST(Cable, OnADrumIsReadOverWholeTurns) {
  const test::Ran ran(R"(end_time = 2.0
gravity = [0, 0, -9.81]
bodies = [{ name = "drum", mass = 1, inertia = [1, 1, 1], position = [0, 0, 0] },
          { name = "load", mass = 1, inertia = [1, 1, 1], position = [0.1, 0, -3] }]
cables = [{ name = "rope", EA = 1e5, damping = 200, tension = 9.81, path = [{ body = "drum", point = [0, 0, 0], radius = 0.1, axis = "y" }, { body = "load", point = [0.1, 0, -3] }] }]
signals = [{ name = "left", kind = "expression", input = "rope.unstretched" },
           { name = "pull", kind = "expression", input = "rope.force" }]
[[joints]]
name = "guide"
kind = "prismatic"
bodies = ["ground", "load"]
point = [0.1, 0, -3]
axis = "z"
[[joints]]
name = "axle"
kind = "prescribed"
bodies = ["ground", "drum"]
point = [0, 0, 0]
axis = "y"
axis2 = "x"
[joints.motion]
x = { polynomial = [0] }
y = { polynomial = [0] }
z = { polynomial = [0] }
rotation = { polynomial = [0, -5] }
hold_other_rotations = true
)");
  EXPECT_NEAR(ran.value(0, "signal.left"), ran.value(0, "rope.unstretched"), 1e-12);
  EXPECT_NEAR(ran.last("rope.unstretched"), ran.value(0, "rope.unstretched") - 0.1 * 5 * 2.0, 1e-6);
  for (std::size_t row = 0; row < ran.rows.size(); ++row) {
    EXPECT_NEAR(ran.value(row, "signal.left"), ran.value(row, "rope.unstretched"), 1e-12) << row;
    EXPECT_NEAR(ran.value(row, "signal.pull"), ran.value(row, "rope.force"), 1e-9) << row;
  }
}

// From (-1, 0, 0) over a pulley of R = 0.2 m at the origin, along its top, to a load at x = 1 that is driven up at 1 m/s: the cable
// would leave the pulley where the load is on the tangent through the fixed end, z = 2 R / sqrt(1 - R^2).
std::string lifted(const std::string& grip, double end) {
  return "end_time = " + std::to_string(end) + R"(
bodies = [{ name = "pulley", mass = 1, inertia = [1, 1, 1], position = [0, 0, 0] },
          { name = "load", mass = 1, inertia = [1, 1, 1], position = [1, 0, 0] }]
[[cables]]
name = "rope"
stiffness = 100
damping = 5
tension = 50
path = [{ body = "ground", point = [-1, 0, 0] }, { body = "pulley", point = [0, 0, 0], radius = 0.2, axis = "y")" +
         grip + R"( }, { body = "load", point = [1, 0, 0] }]
[[joints]]
name = "axle"
kind = "revolute"
bodies = ["ground", "pulley"]
point = [0, 0, 0]
axis = "y"
[[joints]]
name = "lift"
kind = "prescribed"
bodies = ["ground", "load"]
point = [1, 0, 0]
axis = "z"
axis2 = "x"
[joints.motion]
x = { polynomial = [0] }
y = { polynomial = [0] }
z = { polynomial = [0, 1] }
rotation = { polynomial = [0] }
hold_other_rotations = true
)";
}

TEST(Cable, LeavesAPulleyAndTellsWhereGripHoldsIt) {
  const double R = 0.2, leaves = 2.0 * R / std::sqrt(1.0 - R * R);  // [s]
  // Free, it is straight behind that, and turns nothing.
  const test::Ran free(lifted("", 0.8));
  EXPECT_NEAR(free.last("rope.length"), std::hypot(2.0, 0.8), 1e-9);
  EXPECT_NEAR(free.last("pulley.wy"), 0.0, 1e-12);
  EXPECT_TRUE(free.observation.grips().warnings().empty());
  // Held, nothing is told while it would stay, and once what happens then.
  EXPECT_TRUE(test::Ran(lifted(", grip = true", leaves - 0.01)).observation.grips().warnings().empty());
  const test::Ran held(lifted(", grip = true", leaves + 0.05), {"solver.max_step=0.01"});
  ASSERT_EQ(held.observation.grips().warnings().size(), 1u);
  const std::string& told = held.observation.grips().warnings().front();
  EXPECT_NE(told.find(code::kGripWithoutWrap.number), std::string::npos) << told;
  // At a row or the end of a step behind it.
  const double when = std::stod(told.substr(told.find("t = ") + 4));
  EXPECT_GT(when, leaves - 1e-4);
  EXPECT_LT(when, leaves + 0.011);
  // A program that controls the simulation is told the same.
  Session led(SceneText().read(lifted(", grip = true", leaves + 0.05), {"solver.max_step=0.01"}));
  led.step_to(leaves + 0.05);
  const std::vector<std::string> to_host = led.warnings();
  EXPECT_EQ(std::count_if(
                to_host.begin(), to_host.end(),
                [](const std::string& one) { return one.find(code::kGripWithoutWrap.number) != std::string::npos; }),
            1);
}

}  // namespace
}  // namespace footfall
