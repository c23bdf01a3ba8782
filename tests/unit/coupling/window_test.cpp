// Windows: their length, the motion sent and the load felt.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "coupler/load_average.h"
#include "coupler/schemes/registry.h"
#include "coupler/schemes/window_map.h"
#include "mbd_solver/coupling/body_window.h"
#include "mbd_solver/coupling/window_choice.h"
#include "tests/support/linear_algebra.h"
#include "tests/unit/coupler/random_boundary.h"

namespace footfall {
namespace {

// The windows of one body, with every scheme: what is sent, felt, and left over.

constexpr int kSubsteps = 10;
constexpr double kDt = 1e-3;        // [s]
constexpr double kStiffness = 1e5;  // of the contacts [N/m]

class EveryScheme : public testing::TestWithParam<std::string> {
 protected:
  EveryScheme() : computed(random.motion(0)), window(*scheme, body, computed) {
    answer.mean.F_W = 100.0 * random.vector();
    answer.mean.T_B = random.vector();
    answer.contact_stiffness = kStiffness;
    if (scheme->requires_tangent()) answer.tangent.emplace_back().K.diagonal().head<3>().setConstant(kStiffness);
  }
  const std::unique_ptr<Scheme> scheme = make_scheme(GetParam());
  const Body body{"ball", 10.0, Eigen::Vector3d(0.1, 0.2, 0.3).asDiagonal()};
  test::RandomNumbers random{41};
  BodyMotion computed;
  BodyWindow window;
  BodyLoad answer;
  ExternalLoad felt;
};
std::string test_name(const testing::TestParamInfo<std::string>& scheme) {
  std::string name = scheme.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(BodyWindow, EveryScheme, testing::ValuesIn(scheme_names()), test_name);

TEST_P(EveryScheme, SendsThePlaceAsComputed) {
  window.begin(kSubsteps, kDt, computed);
  window.apply(answer, felt);
  BodyMotion sent = random.motion(0);
  const BodyMotion next = sent;
  window.begin(kSubsteps, kDt, sent);
  EXPECT_EQ(sent.r, next.r);
  EXPECT_EQ(sent.L, next.L);
  EXPECT_EQ(sent.ddr, next.ddr);
  EXPECT_EQ(sent.dw, next.dw);
}

// Two routes: the path that the grains' side walks with what was sent, and the one known here.
TEST_P(EveryScheme, KnowsWhereTheGrainsSideLeavesTheBoundary) {
  BoundaryPath grains_side(*scheme, computed);
  for (int k = 0; k < 2; ++k) {
    BodyMotion sent = computed;
    window.begin(kSubsteps, kDt, sent);
    grains_side.begin_window(sent, kSubsteps, kDt);
    for (int i = 0; i < kSubsteps; ++i) grains_side.advance();
    EXPECT_EQ(window.path().r_end, grains_side.pose().r);
    EXPECT_EQ(window.path().L_end, grains_side.pose().L);
    EXPECT_EQ(window.pending_work(grains_side.pose()), 0.0);
    window.apply(answer, felt);
    computed.r += 0.01 * random.vector();
  }
}

TEST_P(EveryScheme, FeelsTheMeanOfTheGrainsAndReactsAroundThePredictedPath) {
  window.begin(kSubsteps, kDt, computed);
  window.apply(answer, felt);
  EXPECT_EQ(felt.F_W, answer.mean.F_W);
  EXPECT_EQ(felt.T_B, answer.mean.T_B);
  ASSERT_EQ(felt.tangent.has_value(), scheme->requires_tangent());
  EXPECT_EQ(window.surplus_impulse(computed).has_value(), scheme->requires_tangent());
  if (!felt.tangent) return;
  EXPECT_EQ(felt.tangent->K, answer.tangent.front().K);
  EXPECT_EQ(felt.tangent->r_mean, window.path().r_mean);
  EXPECT_EQ(felt.tangent->v_mean, window.path().v_mean);
}

// Means stand for the windows' middles: after one of length 2 and one of length 1 the force is followed by 1/3 of its
// change to the end. A scheme with slopes follows them instead (zero here).
TEST_P(EveryScheme, FollowsTheForceToTheEndOfItsWindow) {
  BodyMotion sent = computed;
  window.begin(2 * kSubsteps, kDt, sent);
  answer.mean = MeanLoad();
  answer.mean.F_W.z() = 300.0;
  window.apply(answer, felt);
  sent = computed;
  window.begin(kSubsteps, kDt, sent);
  answer.mean.F_W.z() = 600.0;
  if (scheme->requires_tangent()) answer.tangent.front() = {};
  window.apply(answer, felt);
  BodyMotion end;
  end.r = window.path().r_end + Eigen::Vector3d(0.0, 0.0, 1e-3);
  end.L = window.path().L_end;
  const double at_end = scheme->requires_tangent() ? 600.0 : 700.0;  // [N]
  EXPECT_NEAR(window.pending_work(end), 1e-3 * at_end, 1e-10);       // round-off of r
}

// Two masses of 1 kg, 1 m apart, on a spring: one mode of Omega [rad/s].
std::shared_ptr<const ModalBody> dumbbell(double Omega) {
  auto body = std::make_shared<ModalBody>();
  body->name = "dumbbell";
  body->rho0.resize(3, 2);
  body->rho0 << 0.0, 0.0, 0.0, 0.0, -0.5, 0.5;
  body->node_mass = Eigen::Vector2d::Ones();
  body->node_inertia.assign(2, 0.1 * Eigen::Matrix3d::Identity());
  body->Phi = Eigen::MatrixXd::Zero(6, 1);
  body->Phi(2, 0) = -std::sqrt(0.5);
  body->Phi(5, 0) = std::sqrt(0.5);
  body->Psi = Eigen::MatrixXd::Zero(6, 1);
  body->stiffness = Eigen::VectorXd::Constant(1, Omega * Omega);
  body->damping = Eigen::VectorXd::Zero(1);
  return body;
}

// theta = Omega H = 10: da_path = 2 da (1 - cos theta)/theta^2, with weight theta^4/(1 + theta^4), is below 5 % of da.
TEST_P(EveryScheme, SlowsDownModesThatSwingWithinTheWindow) {
  const double H = kSubsteps * kDt;
  const Body flexible("dumbbell", dumbbell(10.0 / H));
  BodyMotion sent(1);
  BodyWindow windows(*scheme, flexible, sent);
  sent.da[0] = 1.0;
  windows.begin(kSubsteps, kDt, sent);
  EXPECT_LT(std::abs(sent.da[0]), 0.05);
}

// The path of the grains, walked on the body's side.

TEST(PredictedWindow, MeansAreThoseOfThePathOfTheGrains) {
  const std::unique_ptr<Scheme> scheme = make_scheme("tangent");
  BodyMotion start;
  start.dr = {0.0, 0.0, -1.0};
  start.w = {0.0, 0.5, 0.0};
  PredictedWindow predicted(*scheme, start);
  predicted.begin(start, 10, 1e-3);
  EXPECT_NEAR(predicted.path().r_mean[2], -0.005, 1e-15);
  EXPECT_NEAR(predicted.path().v_mean[2], -1.0, 1e-12);
  EXPECT_NEAR(rotation_vector(start.L, predicted.path().L_mean)[1], 0.0025, 1e-12);
  // The body came 1 mm less far: the next path closes that gap, and goes 1 mm less in the mean of its velocity.
  BodyMotion computed = start;
  computed.r[2] = -0.009;
  EXPECT_NEAR(predicted.path().gap(computed)[2], 0.001, 1e-15);
  predicted.begin(computed, 10, 1e-3);
  EXPECT_NEAR(predicted.path().v_mean[2], -1.0 + 0.001 / 0.01, 0.02);  // 10 substeps sample the closing roughly
}

// Elastic modes that swing within a window.

BodyMotion one_mode(double a, double da, double dda) {
  BodyMotion motion(1);
  motion.a[0] = a;
  motion.da[0] = da;
  motion.dda[0] = dda;
  return motion;
}

BodyMotion slowed(const BodyMotion& motion, double Omega, double H) {
  BodyMotion path = motion;
  slow_down_fast_modes(motion, Eigen::VectorXd::Constant(1, Omega * Omega), H, path);
  return path;
}

// a(tau) = a_s + (a - a_s) cos(Omega tau) + da / Omega sin(Omega tau), by the trapezoidal rule.
TEST(FastModes, PathHasTheMeanOfTheFreeSwing) {
  const double Omega = 2000.0, H = 0.01, a_s = 0.3, a = 0.1, da = 50.0;
  const int parts = 20000;
  double mean = 0.0;
  for (int k = 0; k <= parts; ++k) {
    const double tau = H * k / parts;
    mean += (k == 0 || k == parts ? 0.5 : 1.0) / parts *
            (a_s + (a - a_s) * std::cos(Omega * tau) + da / Omega * std::sin(Omega * tau));
  }
  const BodyMotion path = slowed(one_mode(a, da, Omega * Omega * (a_s - a)), Omega, H);
  EXPECT_NEAR(a + path.da[0] * H / 2.0, mean, 1e-5);
  EXPECT_LT(std::abs(path.dda[0]), 1e-5 * Omega * Omega);
}

TEST(FastModes, SlowModesAndRigidBodiesKeepTheirPath) {
  const BodyMotion slow = one_mode(0.1, 3.0, -2.0);
  EXPECT_EQ(slowed(slow, 1.0, 0.005).da, slow.da);
  EXPECT_NEAR(slowed(slow, 1.0, 0.1).da[0], 3.0, 1e-4);
  BodyMotion rigid;
  rigid.dr = {1.0, 2.0, 3.0};
  BodyMotion path = rigid;
  slow_down_fast_modes(rigid, {}, 1.0, path);
  EXPECT_EQ(path.dr, rigid.dr);
}

// Largest growth per window of a mode (Omega = theta, H = 1) that pushes on grains of kappa Omega^2, without damping;
// the path starts where the boundary is, s, and the mode gets the mean force. State [a, da, dda, s].
double growth(double theta, double kappa, bool slowing) {
  const double stiffness = theta * theta;
  Eigen::Matrix4d map;
  for (int j = 0; j < 4; ++j) {
    const Eigen::Vector4d z = Eigen::Vector4d::Unit(j);
    BodyMotion path = one_mode(z[0], z[1], z[2]);
    if (slowing) path = slowed(path, theta, 1.0);
    const double end = z[0] + path.da[0], Q = -kappa * stiffness * 0.5 * (z[3] + end), held = Q / stiffness;
    const double a = held + (z[0] - held) * std::cos(theta) + z[1] / theta * std::sin(theta);
    const double da = -(z[0] - held) * theta * std::sin(theta) + z[1] * std::cos(theta);
    map.col(j) << a, da, Q - stiffness * a, end;
  }
  return test::eigenvalues(map).cwiseAbs().maxCoeff();
}

TEST(FastModes, NoLongerPumpEnergy) {
  double straight = 0.0, slow = 0.0;
  for (double theta = 0.02; theta < 25.0; theta += 0.0167) {
    straight = std::max(straight, growth(theta, 0.05, false));
    slow = std::max(slow, growth(theta, 0.05, true));
  }
  std::printf("  largest growth per window: %.4f straight, %.4f slowed\n", straight, slow);
  EXPECT_GT(straight, 1.2);
  EXPECT_LT(slow, 1.02);
}

// Growth per window of a body (m = 1) on one linear contact with a fixed grain, with path, mean load and reaction as in a
// coupled run, the body integrated exactly: the slope of the logarithm of its size. theory 7.7.
double measured_growth(const Scheme& scheme, double omega_h, int n) {
  constexpr int windows = 1000;
  constexpr double least = 1e-9, most = 1e150;  // of the first size; beyond, round-off or overflow dominates
  const double K = omega_h * omega_h, dt = 1.0 / n;
  const Body body("body", 1.0, Eigen::Matrix3d::Identity());
  BodyMotion state;
  state.r.z() = 1.0;
  state.dr.z() = 0.3 * omega_h;
  state.ddr.z() = -K;
  BoundaryPath path(scheme, state);
  LoadAverage average(scheme, 0);
  GeneralizedForce contact;
  const auto touch = [&] { contact.F_W.z() = -K * path.pose().r.z(); };
  touch();
  average.set_opening_force(contact, path.pose());
  BodyLoad received;
  received.contact_stiffness = K;
  if (scheme.requires_tangent()) received.tangent.emplace_back().K(2, 2) = K;
  BodyWindow window(scheme, body, state, received);
  ExternalLoad applied;
  std::vector<double> logs;  // of the size: all on which the next window depends
  const auto size = [&] {
    return Eigen::Vector4d(omega_h * state.r.z(), state.dr.z(), state.ddr.z() / omega_h, omega_h * path.pose().r.z())
        .norm();
  };
  const double first = size();
  for (double now = 1.0; logs.size() < windows && now > least && now < most; now = size() / first) {
    logs.push_back(std::log(now));
    BodyMotion sent = state;
    window.begin(n, dt, sent);
    path.begin_window(sent, n, dt);
    average.begin_window(path.jump(), path.pose());
    for (int i = 0; i < n; ++i) {
      path.advance();
      touch();
      average.add_step(contact, path.pose(), path.last_step(), dt);
    }
    received.mean = average.finish();
    window.apply(received, applied);
    double K_applied = 0.0, C_applied = 0.0, force = applied.F_W.z();
    if (applied.tangent) {
      K_applied = applied.tangent->K(2, 2), C_applied = applied.tangent->C(2, 2);
      force += K_applied * applied.tangent->r_mean.z() + C_applied * applied.tangent->v_mean[2];
    }
    const PointMotion start{state.r.z(), state.dr.z()};
    const PointMotion end = applied.tangent ? exact_flow(K_applied, C_applied, force, start)
                                            : PointMotion{start.x + start.v + 0.5 * force, start.v + force};
    state.r.z() = end.x;
    state.dr.z() = end.v;
    state.ddr.z() = force - K_applied * end.x - C_applied * end.v;
  }
  // By least squares over the second half, where the fastest-growing mode dominates.
  const std::size_t half = logs.size() / 2;
  const double middle = 0.5 * static_cast<double>(logs.size() - half - 1);
  double above = 0.0, below = 0.0;
  for (std::size_t k = half; k < logs.size(); ++k) {
    const double x = static_cast<double>(k - half) - middle;
    above += x * logs[k], below += x * x;
  }
  return std::exp(above / below);
}

// Within 1 %; a motion that decays fast is followed over few windows, in which equal roots of the map are not told apart.
TEST_P(EveryScheme, GrowsPerWindowAsTheoryPredicts) {
  for (const int n : {1, 3, 20})
    for (const double omega_h : {0.01, 0.1, 0.5, 1.0, 1.5, 1.9, 2.1, 5.0, 20.0}) {
      const double theory = predicted_growth(*scheme, omega_h, n);
      EXPECT_NEAR(measured_growth(*scheme, omega_h, n), theory, (theory < 0.9 ? 0.05 : 0.01) * theory)
          << omega_h << ", " << n;
    }
}

// `every auto`: how many substeps a window takes.

constexpr double kSubstep = 1e-4;  // [s]

CouplingSpec spec() {
  CouplingSpec spec;
  spec.tolerance = 0.01;
  spec.max_substeps = 100;
  spec.warn_omega_h = 0.5;
  return spec;
}

OmegaHLimit limit() {
  static const std::unique_ptr<Scheme> scheme = make_scheme("css-trapezoid");
  return {*scheme, spec().warn_omega_h};
}

// 10 kg on 1e5 N/m: omega = 100 1/s, so omega H = 0.4, 0.8 of the limit, is a window of 40 substeps.
WindowChoice::Body pressed(double gap) { return {10.0, 1e5, gap, 0.0, {0.0, 0.0, 100.0}}; }

TEST(WindowChoice, FliesInTheLongestWindowsAndLandsBeforeItsTime) {
  WindowChoice choice(spec(), kSubstep, 1.0, limit());
  choice.start({{10.0, 0.0, 0.0, std::numeric_limits<double>::infinity()}});
  EXPECT_EQ(choice.substeps(), 100);
  choice.observe(100, {{10.0, 0.0, 0.0, 20.5 * kSubstep}});
  EXPECT_LE(choice.substeps(), 20);
  EXPECT_GE(choice.substeps(), 10);
}

// Grains may stand higher than was told, by `risen` of the time that the way to them takes: the window in which they are met is
// no longer than that.
TEST(WindowChoice, MeetsGrainsThatHaveRisenInAShortWindow) {
  const double risen = 3.0;  // substeps
  WindowChoice choice(spec(), kSubstep, 1.0, limit());
  choice.start({{10.0, 0.0, 0.0, 200.0 * kSubstep}});
  double left = 200.0;
  for (int k = 0; k < 100 && left - choice.substeps() > risen; ++k) {
    left -= choice.substeps();
    choice.observe(choice.substeps(), {{10.0, 0.0, 0.0, left * kSubstep}});
  }
  EXPECT_LE(choice.substeps(), risen);
}

TEST(WindowChoice, AmongGrainsWithoutAFirstContactTakesSingleSubsteps) {
  WindowChoice choice(spec(), kSubstep, 1.0, limit());
  choice.start({{10.0}});
  EXPECT_EQ(choice.substeps(), 1);
  choice.observe(1, {{10.0}});
  EXPECT_EQ(choice.substeps(), 1);
}

TEST(WindowChoice, NeverPassesTheLimitOfOmegaH) {
  WindowChoice choice(spec(), kSubstep, 1.0, limit());
  choice.start({pressed(0.0)});
  for (int k = 0; k < 20; ++k) choice.observe(choice.substeps(), {pressed(0.0)});
  EXPECT_EQ(choice.substeps(), 40);
}

TEST(WindowChoice, SettlesWhereTheEstimateMeetsTheTolerance) {
  // A gap of 1/2 a H^2 with a = F / m, and F the force scale: eta = (omega H)^2 / 2 = 0.9 tolerance at omega H = 0.134.
  WindowChoice choice(spec(), kSubstep, 1.0, limit());
  choice.start({pressed(0.0)});
  for (int k = 0; k < 20; ++k) {
    const double H = choice.substeps() * kSubstep;
    choice.observe(choice.substeps(), {pressed(0.5 * 100.0 / 10.0 * H * H)});
  }
  EXPECT_GE(choice.substeps(), 12);
  EXPECT_LE(choice.substeps(), 13);
  EXPECT_LE(choice.estimate(), 0.01);
}

TEST(WindowChoice, ShrinksAtOnceAndGrowsByTwoAtMost) {
  WindowChoice choice(spec(), kSubstep, 1.0, limit());
  choice.start({pressed(0.0)});
  choice.observe(40, {pressed(1e-4)});  // eta = 0.1
  EXPECT_EQ(choice.substeps(), 12);     // 40 sqrt(0.09)
  choice.observe(12, {pressed(0.0)});
  EXPECT_EQ(choice.substeps(), 24);
}

TEST(WindowChoice, TheStiffestBodyDecides) {
  WindowChoice choice(spec(), kSubstep, 1.0, limit());
  choice.start({pressed(0.0), {10.0, 0.0, 0.0, 1.0}});
  WindowChoice::Body stiff = pressed(0.0);
  stiff.stiffness = 1e7;
  choice.observe(40, {pressed(0.0), stiff});
  EXPECT_EQ(choice.substeps(), 4);
}

// A body that sinks by 1 cm per window while its force rises by 1 N: K_s = 3 x 100 N/m, where the contacts have 1e5
// N/m.
WindowChoice::Body sinking(int window, double gap) {
  WindowChoice::Body body = pressed(gap);
  body.force.z() += window;
  body.place.z() -= 0.01 * window;
  return body;
}

TEST(WindowChoice, GrainsThatGiveWayAreSofterThanTheirContacts) {
  WindowChoice choice(spec(), kSubstep, 1.0, limit());
  choice.start({pressed(0.0)});
  choice.observe(40, {sinking(0, 1e-4)});
  EXPECT_NEAR(choice.estimate(), 1e5 * 1e-4 / 100.0, 1e-12);
  choice.observe(40, {sinking(1, 1e-4)});
  EXPECT_NEAR(choice.estimate(), 300.0 * 1e-4 / 101.0, 1e-12);
  // A way shorter than the gap says nothing.
  WindowChoice::Body body = sinking(1, 1e-4);
  body.place.z() -= 5e-5;
  choice.observe(40, {body});
  EXPECT_NEAR(choice.estimate(), 1e5 * 1e-4 / 101.0, 1e-12);
}

// A grain of 0.1 kg on 1e5 N/m: omega_g = 1000 1/s, whose peak needs windows of 0.8 ms, whatever the mass of the body.
TEST(WindowChoice, FollowsTheContactsOfSingleGrains) {
  WindowChoice choice(spec(), kSubstep, 1.0, limit());
  WindowChoice::Body held = pressed(0.0);
  held.mass = std::numeric_limits<double>::infinity();
  choice.start({held});
  held.grain_omega2 = 1e6;
  for (int k = 0; k < 20; ++k) choice.observe(choice.substeps(), {held});
  EXPECT_EQ(choice.substeps(), 8);
}

// Fifty windows above the grains do not change how it meets them: its motion is known and says nothing of their contacts.
TEST(WindowChoice, ABodyThatIsLedMeetsGrainsAgainAsBefore) {
  WindowChoice choice(spec(), kSubstep, 1.0, limit());
  WindowChoice::Body led = pressed(0.0);
  led.mass = std::numeric_limits<double>::infinity();
  choice.start({led});
  led.grain_omega2 = 1e6;
  for (int k = 0; k < 20; ++k) choice.observe(choice.substeps(), {led});
  led.stiffness = led.grain_omega2 = 0.0;
  for (int k = 0; k < 50; ++k) choice.observe(choice.substeps(), {led});
  EXPECT_EQ(choice.substeps(), 8);
}

TEST(WindowChoice, BeforeItsFirstContactABodyTakesTheStiffnessThatOthersHaveMet) {
  WindowChoice choice(spec(), kSubstep, 1.0, limit());
  choice.start({{10.0}, {10.0}});
  WindowChoice::Body stiff = pressed(0.0);
  stiff.stiffness = 1e7;
  for (int k = 0; k < 5; ++k) choice.observe(choice.substeps(), {stiff, {10.0}});
  EXPECT_EQ(choice.substeps(), 4);  // omega H = 0.4
}

// How long a boundary may fall before it can meet a grain.

const Eigen::Vector3d kUp = Eigen::Vector3d::UnitZ();

// A square plate of edge 2 m about its origin.
ModalBoundary plate() {
  Eigen::Matrix3Xd nodes(3, 4);
  nodes << -1, 1, 1, -1, -1, -1, 1, 1, 0, 0, 0, 0;
  return ModalBoundary("plate", nodes, {{0, 1, 2}, {0, 2, 3}}, {});
}

Placement ground_at(double height) {
  Placement placement;
  placement.ground_known = true;
  placement.ground_height = height;
  return placement;
}

BodyMotion falling_from(double height, double speed) {
  BodyMotion motion(0);
  motion.r.z() = height;
  motion.dr.z() = -speed;
  return motion;
}

double time(const BodyMotion& motion, const Placement& placement, const LandingSite* site = nullptr) {
  return flight_time(motion, plate(), placement, kUp, site);
}

TEST(FlightTime, IsHeightOverSpeed) { EXPECT_DOUBLE_EQ(time(falling_from(3.0, 2.0), ground_at(1.0)), 1.0); }

TEST(FlightTime, IsZeroAmongTheGrainsAndWhereNobodyKnowsThem) {
  EXPECT_EQ(time(falling_from(1.0, 2.0), ground_at(1.0)), 0.0);
  EXPECT_EQ(time(falling_from(3.0, 2.0), Placement()), 0.0);
}

TEST(FlightTime, OfABodyThatRisesIsForEver) {
  EXPECT_EQ(time(falling_from(3.0, -2.0), ground_at(1.0)), std::numeric_limits<double>::infinity());
}

// At its highest point, 2 m above the grains, a known path bends down by 4 m/s2: t = 1 s. Of other bodies the speed counts.
TEST(FlightTime, OfAKnownPathCountsItsAcceleration) {
  BodyMotion motion = falling_from(3.0, 0.0);
  motion.ddr.z() = -4.0;
  EXPECT_DOUBLE_EQ(flight_time(motion, plate(), ground_at(1.0), kUp, nullptr, true), 1.0);
  EXPECT_EQ(time(motion, ground_at(1.0)), std::numeric_limits<double>::infinity());
  motion.dr.z() = 1.0;  // rises until 0.25 s
  EXPECT_DOUBLE_EQ(flight_time(motion, plate(), ground_at(1.0), kUp, nullptr, true), 0.25 * (1.0 + std::sqrt(17.0)));
}

// Any point may come down at |w| reach.
TEST(FlightTime, CountsTheSpinOfTheFarthestPoint) {
  BodyMotion motion = falling_from(3.0, 0.0);
  motion.w.x() = 2.0;
  EXPECT_DOUBLE_EQ(time(motion, ground_at(1.0)), 2.0 / (2.0 * std::sqrt(2.0)));
}

TEST(FlightTime, IsOfTheLowestPoint) {
  BodyMotion motion = falling_from(3.0, 1.0);
  motion.L << std::sqrt(0.5), std::sqrt(0.5), 0, 0;  // on an edge, 1 m below its origin
  EXPECT_NEAR(time(motion, ground_at(1.0)), 1.0, 1e-14);
}

TEST(FlightTime, BeamsReachTheGrainsWithTheirRadius) {
  Eigen::Matrix3Xd nodes(3, 2);
  nodes << -1, 1, 0, 0, 0, 0;
  const ModalBoundary beam("beam", nodes, {}, {{0, 1, 0.25, 0}});
  EXPECT_DOUBLE_EQ(flight_time(falling_from(3.0, 1.0), beam, ground_at(1.0), kUp, nullptr), 1.75);
}

// Above lower grains than the highest of all it may fall longer, until it strays from them.
TEST(FlightTime, IsToTheGrainsBelowAsLongAsItStaysAboveThem) {
  LandingSite site;
  site.height = 0.5;
  site.stray = 0.2;
  site.r = Eigen::Vector3d(0, 0, 5);
  BodyMotion motion = falling_from(3.0, 1.0);
  EXPECT_DOUBLE_EQ(time(motion, ground_at(1.0), &site), 2.5);
  motion.r.x() = 0.19;
  EXPECT_DOUBLE_EQ(time(motion, ground_at(1.0), &site), 2.5);
  motion.r.x() = 0.21;
  EXPECT_DOUBLE_EQ(time(motion, ground_at(1.0), &site), 2.0);
}

TEST(FlightTime, TurningStraysToo) {
  LandingSite site;
  site.height = 0.5;
  site.stray = 0.2;
  site.r = Eigen::Vector3d(0, 0, 5);
  BodyMotion motion = falling_from(3.0, 1.0);
  motion.L << std::cos(0.1), 0, 0, std::sin(0.1);  // 0.2 rad about up: its corners move by 0.28 m
  EXPECT_DOUBLE_EQ(time(motion, ground_at(1.0), &site), 2.0);
}

// No grain at all below: the highest of all counts.
TEST(FlightTime, OverAHoleIsToTheHighestGrain) {
  LandingSite site;
  site.height = -std::numeric_limits<double>::infinity();
  site.stray = 0.2;
  site.r = Eigen::Vector3d(0, 0, 5);
  EXPECT_DOUBLE_EQ(time(falling_from(3.0, 1.0), ground_at(1.0), &site), 2.0);
}

}  // namespace
}  // namespace footfall
