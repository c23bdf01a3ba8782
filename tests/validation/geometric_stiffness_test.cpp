// Where linear modes of a flexible body err.

#include <cmath>
#include <cstdio>
#include <vector>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/fe/modal_basis.h"
#include "mbd_solver/model/mass_properties.h"
#include "mbd_solver/model/modal_body.h"
#include "tests/support/fe_reference.h"
#include "tests/support/linear_algebra.h"
#include "tests/unit/dynamics/random_model.h"
#include "tests/unit/dynamics/run.h"

namespace footfall {
namespace geometric_stiffness {

// Spinning beams: what a floating frame with linear modes gets right, and how far. The exact frequencies of a rotating
// beam come from a Galerkin solution with its centrifugal tension (Wright, Smith, Thresher and Wang, J. Appl. Mech.
// 49 (1982), 197).

const Material kBeamSteel{7850.0, 207e9, 0.3};
constexpr double kBeamLength = 1.0;     // [m]
constexpr double kBeamDiameter = 0.01;  // [m]

// sqrt(EI / (m L^4)): the unit of spin rates and frequencies [1/s].
double unit() {
  return std::sqrt(kBeamSteel.young / kBeamSteel.density) * kBeamDiameter / 4.0 / (kBeamLength * kBeamLength);
}

enum class Plane { kFlap, kLag };  // bending along the spin axis, and across it

// ---- exact: beam from x0 to x0 + 1 of unit mass and stiffness per length, spinning at `eta` about an axis through x =
// 0 across it

// Legendre polynomials of 2 (x - x0) - 1 and their first two derivatives.
struct Legendre {
  double value, slope, curvature;
};
Legendre legendre(int n, double s) {
  double p0 = 1.0, p1 = s, d0 = 0.0, d1 = 1.0, c0 = 0.0, c1 = 0.0;
  if (n == 0) return {1.0, 0.0, 0.0};
  for (int k = 2; k <= n; ++k) {
    const double a = (2.0 * k - 1.0) / k, b = (k - 1.0) / k;
    const double p = a * s * p1 - b * p0, d = a * (p1 + s * d1) - b * d0, c = a * (2.0 * d1 + s * c1) - b * c0;
    p0 = p1, p1 = p, d0 = d1, d1 = d, c0 = c1, c1 = c;
  }
  return {p1, 2.0 * d1, 4.0 * c1};
}

// Ascending squares of the frequencies. Tension T(x) = eta^2 / 2 (x_end^2 - x^2) stiffens; across the axis eta^2
// softens.
// clamped: w = x^2 q(x), else w = q(x); q of degree 11.
Eigen::VectorXd exact_squares(double x0, double eta, Plane plane, bool clamped) {
  constexpr int kTerms = 12, kPoints = 400;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(kTerms, kTerms), M = K;
  const double end = x0 + 1.0;
  for (int i = 0; i < kPoints; ++i) {
    // Three-point Gauss in each of the cells.
    for (int g = -1; g <= 1; ++g) {
      const double share = (i + 0.5 + 0.5 * g * std::sqrt(0.6)) / kPoints,
                   weight = (g == 0 ? 8.0 : 5.0) / 18.0 / kPoints;
      const double x = x0 + share;
      Eigen::Matrix<double, kTerms, 1> w, dw, ddw;
      for (int k = 0; k < kTerms; ++k) {
        const Legendre q = legendre(k, 2.0 * share - 1.0);
        const double f = clamped ? share * share : 1.0, df = clamped ? 2.0 * share : 0.0, ddf = clamped ? 2.0 : 0.0;
        w(k) = f * q.value;
        dw(k) = df * q.value + f * q.slope;
        ddw(k) = ddf * q.value + 2.0 * df * q.slope + f * q.curvature;
      }
      const double tension = 0.5 * eta * eta * (end * end - x * x);
      K += weight * (ddw * ddw.transpose() + tension * dw * dw.transpose());
      if (plane == Plane::kLag) K -= weight * eta * eta * w * w.transpose();
      M += weight * w * w.transpose();
    }
  }
  return test::symmetric_modes(K, M).values;
}

TEST(RotatingBeam, ReferenceReproducesThePublishedFrequencies) {
  // Wright et al., Table 1: uniform cantilever, no hub, flapping; first and second frequency.
  const double table[][3] = {{0, 3.5160, 22.0345}, {1, 3.6816, 22.1810}, {2, 4.1373, 22.6149},  {3, 4.7973, 23.3203},
                             {4, 5.5850, 24.2733}, {6, 7.3604, 26.8091}, {12, 13.1702, 37.6031}};
  for (const auto& [eta, first, second] : table) {
    const Eigen::VectorXd f = exact_squares(0.0, eta, Plane::kFlap, true).cwiseSqrt();
    EXPECT_NEAR(f(0), first, 6e-5);  // printed to four decimals
    EXPECT_NEAR(f(1), second, 6e-5);
  }
  EXPECT_NEAR(std::sqrt(exact_squares(-0.5, 0.0, Plane::kFlap, false)(2)), 22.3733, 6e-5);  // free-free
}

// ---- computed: the same beams as flexible bodies in a run

// First bending mode of the beam at rest, up to a factor: clamped at 0, or free.
double first_shape(double x, bool clamped) {
  const double b = clamped ? 1.875104069 : 4.730040745;
  const double sign = clamped ? -1.0 : 1.0;  // cosh + sign cos
  const double s = clamped ? (std::cosh(b) + std::cos(b)) / (std::sinh(b) + std::sin(b))
                           : (std::cosh(b) - std::cos(b)) / (std::sinh(b) - std::sin(b));
  return std::cosh(b * x) + sign * std::cos(b * x) - s * (std::sinh(b * x) + sign * std::sin(b * x));
}

struct Spinning {
  Spinning(double eta, Plane plane, bool clamped) : rate(eta * unit()), direction(plane == Plane::kFlap ? 2 : 1) {
    constexpr int kBeamElements = 10;
    const double x0 = clamped ? 0.0 : -0.5;
    const FeModel beam =
        test::straight_beam(Eigen::Vector3d(x0 * kBeamLength, 0, 0), Eigen::Vector3d((x0 + 1.0) * kBeamLength, 0, 0),
                            kBeamElements, rod_section(kBeamDiameter), kBeamSteel);
    BasisOptions options;
    options.mode_count = 10;
    options.damping_ratio = {0.0};
    options.kind = clamped ? BasisKind::kCraigBampton : BasisKind::kFreeFree;
    if (clamped) options.interface_nodes = {0};
    modal = std::make_shared<const ModalBody>(reduce(beam, options, "beam").body);
    const Body body("beam", modal);
    tip = kBeamElements;
    // A small velocity in the first mode, split into motion of the frame and of the modes.
    BodyState state;
    state.r = {(x0 + 0.5) * kBeamLength, 0.0, 0.0};
    state.w = {0.0, 0.0, rate};
    state.dr = state.w.cross(state.r);
    state.a = Eigen::VectorXd::Zero(body.mode_count());
    state.da = state.a;
    Eigen::Vector3d spin = Eigen::Vector3d::Zero();
    for (int j = 0; j < modal->node_count(); ++j) {
      const Eigen::Vector3d rho = modal->rho0.col(j);
      Eigen::Vector3d v = Eigen::Vector3d::Zero();
      v(direction) = 1e-4 * first_shape((state.r.x() + rho.x()) / kBeamLength - x0, clamped);
      state.dr += modal->node_mass(j) / body.mass() * v;
      spin += modal->node_mass(j) * rho.cross(v);
      state.da += modal->node_mass(j) * modal->Phi.middleRows(3 * j, 3).transpose() * v;
    }
    for (int i = 1; i < 3; ++i) state.w(i) += spin(i) / body.rigid_inertia()(i, i);
    model.add_body(body, state);
    if (!clamped) return;
    PrescribedMotion motion;
    for (auto& component : motion.translation) component = polynomial({0.0});
    motion.rotation = polynomial({0.0, rate});
    motion.rotation_axis = 2;
    motion.hold_other_rotations = true;
    const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    model.add_joint(prescribed_joint("hub", ground_marker(Eigen::Vector3d::Zero(), axes),
                                     node_marker(0, model.body(0), 0, Eigen::Vector3d::Zero(), axes), motion));
  }

  // Deflection of the tip: against the hub, or against the frame of a free body.
  double deflection(test::Run& run) const {
    const BodyKinematics b = run.body(0);
    if (model.joint_count() == 0) return modal->Phi.row(3 * tip + direction).dot(b.a);
    const Eigen::Vector3d x = b.r + b.A * (modal->rho0.col(tip) + modal->Phi.middleRows(3 * tip, 3) * b.a);
    return direction == 2 ? x.z() : -std::sin(rate * run.state.time) * x.x() + std::cos(rate * run.state.time) * x.y();
  }

  // From the zeros over some periods, in units of unit()^2; `guess`: about the frequency [1/s].
  double frequency_square(double guess) const {
    IntegratorOptions options = test::tight(1e-9);
    test::Run run(model, "one_step", options);
    constexpr int kPeriods = 4, kSamples = 60;
    const double h = 2.0 * kPi / guess / kSamples;
    double first = 0.0, last = 0.0, before = 0.0;
    int zeros = 0;
    for (int i = 1; zeros < 2 * kPeriods + 1 && i < 3 * kPeriods * kSamples; ++i) {
      const double t = run.state.time;
      run.to(i * h);
      const double now = deflection(run);
      if (i > 1 && before * now < 0.0) {
        last = t + h * before / (before - now);
        if (zeros++ == 0) first = last;
      }
      before = now;
    }
    EXPECT_EQ(zeros, 2 * kPeriods + 1);
    return std::pow(2.0 * kPi * kPeriods / (last - first) / unit(), 2);
  }

  double rate;    // [rad/s]
  int direction;  // of the deflection: 1 y, 2 z
  int tip = 0;    // node
  std::shared_ptr<const ModalBody> modal;
  Model model;
};

// Relative error of the computed frequency when the beam spins at `share` of its lowest free frequency.
double error_at(double share, Plane plane, bool clamped) {
  const double lowest = exact_squares(-0.5, 0.0, plane, false).cwiseMax(0.0).cwiseSqrt()(2), eta = share * lowest;
  const double exact = exact_squares(clamped ? 0.0 : -0.5, eta, plane, clamped)(clamped ? 0 : 2);
  const double error =
      std::sqrt(Spinning(eta, plane, clamped).frequency_square(std::sqrt(exact) * unit()) / exact) - 1.0;
  std::printf(
      "  %-13s %s, spin %.3f of the lowest free frequency (%.3f of its own at rest): exact %8.4f, error %+.4f\n",
      clamped ? "clamped," : "free,", plane == Plane::kFlap ? "along the spin axis" : "across the spin axis", share,
      eta / (clamped ? 3.51602 : lowest), std::sqrt(exact), error);
  return std::abs(error);
}

// The range that the docs state and beyond which a run warns: one percent, and no more cautious than it has to be.
TEST(RotatingBeam, FrequenciesErrByOnePercentAtTheEndOfTheStatedRange) {
  const double at_rest = 1e-3;  // discretisation: ten elements, zeros of the motion
  double at_end = 0.0, beyond = 0.0;
  for (bool clamped : {true, false})
    for (Plane plane : {Plane::kFlap, Plane::kLag}) {
      EXPECT_LT(error_at(0.0, plane, clamped), at_rest);
      at_end = std::max(at_end, error_at(kSpinRange, plane, clamped));
      beyond = std::max(beyond, error_at(1.5 * kSpinRange, plane, clamped));
      error_at(3.0 * kSpinRange, plane, clamped);
    }
  EXPECT_LT(at_end, 0.01);
  EXPECT_GT(beyond, 0.01);
}

// Mean axes turn with a clamped beam, and so carry most of its stiffening; a free one gets none: omega^2 = omega_0^2 +
// c eta^2 with c = 0 along the spin axis, -1 across it.
TEST(RotatingBeam, LinearModesOfAFreeBeamFeelNoTension) {
  const double eta = 2.0;
  const double rest = Spinning(0.0, Plane::kFlap, false).frequency_square(22.37 * unit());
  EXPECT_NEAR((Spinning(eta, Plane::kFlap, false).frequency_square(22.37 * unit()) - rest) / (eta * eta), 0.0, 0.15);
  EXPECT_NEAR((Spinning(eta, Plane::kLag, false).frequency_square(22.37 * unit()) - rest) / (eta * eta), -1.0, 0.15);
}

// ---- stretch: rho w^2 L^3 / (3 E) of a bar of length L about its end; a bar spinning about its middle is two of half
// the length

TEST(SpinningBar, StretchesByItsCentrifugalLoad) {
  const double L = 0.8, w = 150.0;
  for (bool about_end : {true, false}) {
    const double x0 = about_end ? 0.0 : -0.5 * L;
    const FeModel bar =
        test::straight_beam(Eigen::Vector3d(x0, 0, 0), Eigen::Vector3d(x0 + L, 0, 0), 8, rod_section(0.06), kBeamSteel);
    BasisOptions options;
    options.mode_count = 6;
    options.damping_ratio = {0.7};  // so that it settles
    options.interface_nodes = {0, 8};
    const Body body("bar", std::make_shared<const ModalBody>(reduce(bar, options, "bar").body));
    BodyState state;
    state.r = {x0 + 0.5 * L, 0.0, 0.0};
    state.w = {0.0, 0.0, w};
    state.dr = state.w.cross(state.r);
    Model model;
    model.add_body(body, state);
    if (about_end) {
      PrescribedMotion motion;
      for (auto& component : motion.translation) component = polynomial({0.0});
      motion.rotation = polynomial({0.0, w});
      motion.rotation_axis = 2;
      motion.hold_other_rotations = true;
      const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
      model.add_joint(prescribed_joint("hub", ground_marker(Eigen::Vector3d::Zero(), axes),
                                       node_marker(0, model.body(0), 0, Eigen::Vector3d::Zero(), axes), motion));
    }
    test::Run run(model, "one_step", test::tight(1e-9));
    run.to(0.1, 10);
    const BodyKinematics b = run.body(0);
    const ModalBody& modal = *body.modal();
    const auto at = [&](int node) {
      return Eigen::Vector3d(modal.rho0.col(node) + modal.Phi.middleRows(3 * node, 3) * b.a);
    };
    const double stretch = (at(8) - at(0)).norm() - L;
    const double radius = about_end ? L : 0.5 * L, parts = about_end ? 1.0 : 2.0;
    const double spin = b.w.norm();  // of a free bar it falls as the bar grows
    const double exact = parts * kBeamSteel.density * spin * spin * std::pow(radius, 3) / (3.0 * kBeamSteel.young);
    std::printf("  about its %s: stretch %.6g m, exact %.6g m (%+.2e)\n", about_end ? "end" : "middle", stretch, exact,
                stretch / exact - 1.0);
    EXPECT_NEAR(stretch, exact, 0.005 * exact);
  }
}

// A cantilever that bends far under its weight against the elastica: how large deflections may be for linear modes.

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
  const FeModel beam = test::straight_beam(Eigen::Vector3d::Zero(), Eigen::Vector3d(kStripLength, 0, 0), 10,
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

}  // namespace geometric_stiffness
}  // namespace footfall
