// The two-mass oscillator through every scheme, without LIGGGHTS.
#include <gtest/gtest.h>

#include <thread>

#include "liggghts_fix/link/dem_link.h"
#include "tests/coupled/two_mass.h"
#include "tests/support/transport_loopback.h"

namespace footfall::test {
namespace two_mass {

// The whole exchange without MPI and LIGGGHTS: the grains' side is the real DemLink around one grain under
// velocity Verlet, the body's side integrates exactly under the mean load. theory 7.3.

using test::TwoMass;

struct Result {
  Eigen::Vector4d state;
  double energy_residual = 0.0;  // as the grains' side reports it [J]
  double received = 0.0;         // work received by the body [J]
  double given = 0.0;            // work on the boundary that the grains' side reports [J]
  double largest_impulse_error = 0.0;
};

// contact_damping [N s/m] between grain and body.
void grain_side(Transport& transport, double dt, int n, double contact_damping, Result& result) {
  Link link(transport, 20.0);
  DemLink dem(&link);
  dem.bodies().couple("body", "si");
  Start script;
  script.dt = dt;
  script.n = n;
  dem.start(script);
  DemBody& body = dem.window().body(0);
  const BoundaryPoint face{{0, 1, 2}, {0.25, 0.25, 0.5}};
  double x = 0.0, v = 0.0, f = 0.0, boundary_velocity = TwoMass::initial()[1];
  const auto contact = [&] {
    const double X = body.pose().r[0];
    f = TwoMass::kc * (X - x) + contact_damping * (boundary_velocity - v);  // on the grain
    body.add_contact(face, {-f, 0.0, 0.0}, Eigen::Vector3d::Zero(), 0.0, TwoMass::kc);
  };
  dem.window().opening_forces().expect_set_up();
  contact();
  std::vector<double> sums;
  for (std::int64_t step = 1; !dem.finished(); ++step) {
    dem.window().begin_substep(step);
    boundary_velocity = body.pose().dr[0];
    const double half = v + 0.5 * dt * (-TwoMass::kp * x + f) / TwoMass::m;
    x += dt * half;
    v = half;
    contact();
    v = half + 0.5 * dt * (-TwoMass::kp * x + f) / TwoMass::m;
    if (!dem.window().end_substep()) continue;
    dem.window().write_shares(1, false, sums);
    dem.window().finish_window(sums, 1);
    result.given = dem.window().work().all;
  }
  result.state[2] = x;
  result.state[3] = v;
  result.energy_residual = dem.window().work().residual();
}

void body_side(Transport& transport, const std::string& scheme, double T, double damping, Result& result) {
  Link link(transport, 20.0);
  Hello hello;
  link.receive(hello);
  Eigen::Matrix3Xd rho0(3, 3);
  rho0 << 0, 0, 0, 0, 1, 0, 0, 0, 1;
  BodyMotion state;
  state.r[0] = TwoMass::initial()[0];
  state.dr[0] = TwoMass::initial()[1];
  Geometry geometry;
  geometry.bodies.push_back({ModalBoundary("body", rho0, {{0, 1, 2}}), state});
  link.send(geometry);
  Start start;
  link.receive(start);
  Accept accept;
  accept.scheme = scheme;
  accept.t_end = T;
  accept.n_max = start.n;
  link.send(accept);
  const double H = start.n * start.dt;
  const auto windows = static_cast<std::int64_t>(std::llround(T / H));
  const double om = std::sqrt(TwoMass::K / TwoMass::M), c = std::cos(om * H), s = std::sin(om * H);
  Motion motion;
  Load load;
  state.ddr[0] = (-TwoMass::K * state.r[0] - TwoMass::kc * state.r[0] - damping * state.dr[0]) / TwoMass::M;
  for (motion.window = 0; motion.window < windows; ++motion.window) {
    motion.n = start.n;
    motion.time = static_cast<double>(motion.window) * H;
    motion.last_window = motion.window + 1 == windows;
    motion.bodies = {state};
    link.send(motion);
    link.receive(load);
    const MeanLoad& mean = load.bodies[0].mean;
    result.largest_impulse_error = std::max(result.largest_impulse_error,
                                            (mean.F_W * H - mean.impulse_W).norm() / (mean.impulse_W.norm() + 1e-300));
    const double F = mean.F_W[0], X = state.r[0], V = state.dr[0], rest = F / TwoMass::K;
    state.r[0] = rest + (X - rest) * c + V / om * s;
    state.dr[0] = -(X - rest) * om * s + V * c;
    state.ddr[0] = (F - TwoMass::K * state.r[0]) / TwoMass::M;
    result.received += F * (state.r[0] - X);
  }
  link.close();
  result.state[0] = state.r[0];
  result.state[1] = state.dr[0];
}

Result run(const std::string& scheme, double H, double dt, double T, double damping = 0.0) {
  auto [dem_end, mbd_end] = TransportLoopback::make_pair();
  Result result;
  Transport& dem_transport = *dem_end;
  std::thread grains([&] { grain_side(dem_transport, dt, static_cast<int>(std::lround(H / dt)), damping, result); });
  body_side(*mbd_end, scheme, T, damping, result);
  grains.join();
  return result;
}

constexpr double kFineDt = 3.125e-6;  // Verlet's own error is then below 1e-5: (omega dt)^2 / 24 over 7 periods
double error_at(const std::string& scheme, double H) {
  return TwoMass::error(run(scheme, H, kFineDt, 0.2).state, TwoMass::exact(0.2));
}
double observed_order(const std::string& scheme, double H) {
  const double coarse = error_at(scheme, H), fine = error_at(scheme, 0.5 * H);
  std::printf("%s: error %.3g at H = %g s, %.3g at half of it: order %.2f\n", scheme.c_str(), coarse, H, fine,
              std::log2(coarse / fine));
  return std::log2(coarse / fine);
}

TEST(TwoMassOscillator, CssTrapezoidIsOfSecondOrder) { EXPECT_GE(observed_order("css-trapezoid", 1e-3), 1.9); }

TEST(TwoMassOscillator, QuadraticIsOfSecondOrderOrMore) { EXPECT_GE(observed_order("quadratic", 1e-3), 1.9); }

TEST(TwoMassOscillator, FrozenIsOfFirstOrder) { EXPECT_NEAR(observed_order("frozen", 1e-3), 1.0, 0.1); }

TEST(TwoMassOscillator, CssKeepsAFloorOfTheSubstep) {
  // The end step counts whole: a shift of dt / 2 in time, so at a fixed dt the error stops falling with H.
  const double dt = 1e-4;
  const Eigen::Vector4d exact = TwoMass::exact(0.2);
  const double css = TwoMass::error(run("css", 2 * dt, dt, 0.2).state, exact);
  const double trapezoid = TwoMass::error(run("css-trapezoid", 2 * dt, dt, 0.2).state, exact);
  std::printf("H = 2 dt = 2e-4 s: css %.3g, css-trapezoid %.3g\n", css, trapezoid);
  EXPECT_GT(css, 3.0 * trapezoid);
}

TEST(TwoMassOscillator, ContactDampingKeepsTheOrderOnTheContinuousPath) {
  // Reference: the same damped system at a window 16 times as fine. The prediction's own velocity would give
  // first order.
  const auto at = [](double H) { return run("css-trapezoid", H, kFineDt, 0.1, 100.0).state; };
  const Eigen::Vector4d reference = at(1e-3 / 16);
  const double coarse = TwoMass::error(at(2e-3), reference), fine = TwoMass::error(at(1e-3), reference);
  std::printf("damped contact: order %.2f\n", std::log2(coarse / fine));
  EXPECT_GE(std::log2(coarse / fine), 1.9);
}

double energy_after_5_s(const std::string& scheme) {
  const double ratio = TwoMass::energy(run(scheme, 1e-3, 5e-5, 5.0).state) / TwoMass::energy(TwoMass::initial());
  std::printf("%s: energy after 5 s %.4f of the initial\n", scheme.c_str(), ratio);
  return ratio;
}

TEST(TwoMassOscillator, EnergyIsKeptWithinTwoPercentForFiveSeconds) {
  EXPECT_NEAR(energy_after_5_s("css-trapezoid"), 1.0, 0.02);
}

TEST(TwoMassOscillator, QuadraticLosesALittleEnergyAndNeverGains) {
  // abs(lambda)^2 = 1 - w^4 / 12 per window, w = 0.21 for the faster mode, and the acceleration sent lags by
  // half a window.
  const double ratio = energy_after_5_s("quadratic");
  EXPECT_LE(ratio, 1.0);
  EXPECT_GT(ratio, 0.95);
}

TEST(TwoMassOscillator, FrozenBoundaryPumpsEnergyAsPredicted) {
  // by theory 7.3 40 to 56 times after 5 s at H = 1 ms; amplification 1 + w^2 / 2 per window summed over both
  // modes.
  const double ratio = energy_after_5_s("frozen");
  EXPECT_GT(ratio, 20.0);
  EXPECT_LT(ratio, 80.0);
}

TEST(TwoMassOscillator, QuadraticInterfaceResidualFallsFasterThanItsSquare) {
  const auto residual = [](double H) {
    const Result result = run("quadratic", H, kFineDt, 0.2);
    return std::abs(result.given - result.received) / TwoMass::energy(TwoMass::initial());
  };
  const double coarse = residual(2e-3), fine = residual(1e-3);
  std::printf("quadratic: interface residual %.3g, %.3g of the energy: order %.2f\n", coarse, fine,
              std::log2(coarse / fine));
  EXPECT_GE(std::log2(coarse / fine), 2.0);
}

TEST(TwoMassOscillator, ImpulseOnTheGrainIsTheImpulseOnTheBody) {
  EXPECT_LT(run("css-trapezoid", 1e-3, 5e-5, 0.2).largest_impulse_error, 1e-12);
}

TEST(TwoMassOscillator, BothSidesAgreeOnTheEnergyResidual) {
  // The grains' side learns the body's way from the next Motion; only the last window is missing there.
  const Result result = run("css-trapezoid", 1e-3, 5e-5, 0.2);
  const double E = TwoMass::energy(TwoMass::initial());
  std::printf("css-trapezoid: interface residual %.3g of the energy\n", (result.given - result.received) / E);
  EXPECT_NEAR(result.energy_residual, result.given - result.received, 1e-3 * E);  // one window of 200
  EXPECT_LT(std::abs(result.given - result.received), 1e-2 * E);
}

}  // namespace two_mass
}  // namespace footfall::test
