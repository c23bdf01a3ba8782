// A cantilever that bends far under its weight against the elastica: how large deflections may be for linear modes.

#include <cmath>
#include <cstdio>
#include <vector>

#include "mbd_solver/fe/modal_basis.h"
#include "mbd_solver/model/linear_range.h"
#include "mbd_solver/model/stress_recovery.h"
#include "tests/unit/dynamics/random_model.h"
#include "tests/unit/dynamics/run.h"

namespace footfall {
namespace {

const Material kStripSteel{7850.0, 207e9, 0.3};
constexpr double kStripLength = 1.0, kStripDiameter = 0.004;  // [m]

// Tip of the elastica EI theta'' = -q (L - s) cos theta, theta(0) = theta'(L) = 0, q L^3 / EI = load; in units of L,
// downwards.
double elastica_tip(double load) {
  constexpr int kSteps = 2000;
  const auto shoot = [load](double curvature, double* tip) {
    double theta = 0.0, kappa = curvature, drop = 0.0;
    const double h = 1.0 / kSteps;
    for (int i = 0; i < kSteps; ++i) {  // midpoint rule: error 1e-7
      const double s = i * h;
      const double theta_m = theta + 0.5 * h * kappa, kappa_m = kappa - 0.5 * h * load * (1.0 - s) * std::cos(theta);
      drop += h * std::sin(theta_m);
      theta += h * kappa_m;
      kappa -= h * load * (1.0 - s - 0.5 * h) * std::cos(theta_m);
    }
    *tip = drop;
    return kappa;
  };
  double low = 0.0, high = load, tip = 0.0;  // curvature at the clamp
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (shoot(middle, &tip) < 0.0 ? low : high) = middle;
  }
  return tip;
}

// The same from bars with torsion springs between them: balance of each spring by fixed-point iteration.
double bars_tip(double load) {
  constexpr int kBars = 400;
  std::vector<double> theta(kBars, 0.0);
  double tip = 0.0;
  for (int pass = 0; pass < 200; ++pass) {
    // Moment at joint i of the weight beyond it; half a spring at the clamp.
    std::vector<double> moment(kBars, 0.0);
    double weight = 0.0, first = 0.0;  // of the bars beyond, and their first moment about the joint
    for (int i = kBars - 1; i >= 0; --i) {
      const double c = std::cos(theta[static_cast<std::size_t>(i)]) / kBars, w = load / kBars;
      first += weight * c + 0.5 * w * c;
      weight += w;
      moment[static_cast<std::size_t>(i)] = first;
    }
    double angle = 0.0;
    tip = 0.0;
    for (int i = 0; i < kBars; ++i) {
      angle += moment[static_cast<std::size_t>(i)] / kBars * (i == 0 ? 0.5 : 1.0);
      theta[static_cast<std::size_t>(i)] = angle;
      tip += std::sin(angle) / kBars;
    }
  }
  return tip;
}

struct Bent {
  double tip;         // computed, over L
  double exact;       // elastica, over L
  double deflection;  // largest |Phi a| over L: what a run watches
};

Bent bend(double load) {
  const FeModel beam = straight_beam(Eigen::Vector3d::Zero(), Eigen::Vector3d(kStripLength, 0, 0), 10,
                                     rod_section(kStripDiameter), kStripSteel);
  BasisOptions options;
  options.mode_count = 6;
  options.damping_ratio = {1.0};  // so that it settles
  options.interface_nodes = {0, 10};
  const Body body("beam", std::make_shared<const ModalBody>(reduce(beam, options, "beam").body));
  const BeamSection section = rod_section(kStripDiameter);
  const double q = load * kStripSteel.young * section.bending_y / std::pow(kStripLength, 3);
  Model model({0.0, 0.0, -q / (kStripSteel.density * section.area)});
  BodyState state;
  state.r = {0.5 * kStripLength, 0.0, 0.0};
  model.add_body(body, state);
  model.add_joint(fixed_joint("clamp", ground_marker(Eigen::Vector3d::Zero()),
                              node_marker(0, model.body(0), 0, Eigen::Vector3d::Zero())));
  test::Run run(model, "one_step", test::tight(1e-7));
  run.to(5.0, 10);
  const BodyKinematics b = run.body(0);
  const ModalBody& modal = *body.modal();
  const Eigen::Vector3d tip = b.r + b.A * (modal.rho0.col(10) + modal.Phi.middleRows(30, 3) * b.a);
  return {-tip.z() / kStripLength, elastica_tip(load), largest_deflection(modal, b.a) / kStripLength};
}

TEST(LargeDeflection, ReferenceIsLinearForSmallLoadsAndAgreesWithAChainOfBars) {
  EXPECT_NEAR(elastica_tip(1e-3), 1e-3 / 8.0, 1e-9);
  // Holds the other way as well: the moment at the clamp turns the whole beam. Energy, by an independent sum of many
  // short rigid bars.
  EXPECT_NEAR(elastica_tip(2.0), bars_tip(2.0), 1e-4);
}

TEST(LargeDeflection, ErrsByOnePercentAtTheEndOfTheStatedRange) {
  double inside = 0.0, beyond = 1.0;
  for (double load : {0.1, 0.5, 0.58, 1.0, 2.0, 4.0}) {
    const Bent bent = bend(load);
    const double error = bent.tip / bent.exact - 1.0;
    std::printf("  load %.2f: tip %.5f L, elastica %.5f L, error %+.4f; largest deflection from mean axes %.4f L\n",
                load, bent.tip, bent.exact, error, bent.deflection);
    if (bent.deflection <= kDeflectionRange) inside = std::max(inside, std::abs(error));
    if (bent.deflection > 1.5 * kDeflectionRange) beyond = std::min(beyond, std::abs(error));
  }
  EXPECT_LT(inside, 0.01);
  EXPECT_GT(beyond, 0.01);
}

}  // namespace
}  // namespace footfall
