// Flexible bodies in motion.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <sstream>
#include <string>

#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/fe/modal_basis.h"
#include "mbd_solver/model/laws/springs.h"
#include "mbd_solver/model/mass_properties.h"
#include "mbd_solver/session/settle.h"
#include "tests/physics/motion_of.h"
#include "tests/support/fe_reference.h"
#include "tests/unit/dynamics/random_model.h"
#include "tests/unit/dynamics/run.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace flexible_bodies {

// Energy and momentum of free systems, rigid and flexible; flexible bodies against rigid ones.

struct Momentum {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();   // [N s]
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();  // about the origin of W [N m s]
};

// Node by node for flexible bodies, which uses nothing of the inertia integrals.
Momentum momentum(const Model& model, test::Run& run) {
  Momentum out;
  for (int i = 0; i < model.body_count(); ++i) {
    const BodyKinematics b = run.body(i);
    if (b.modes == 0) {
      out.linear += model.body(i).mass() * b.dr;
      out.angular +=
          model.body(i).mass() * b.r.cross(b.dr) + b.A * model.body(i).rigid_inertia() * b.A.transpose() * b.w;
      continue;
    }
    const ModalBody& modal = *model.body(i).modal();
    for (int j = 0; j < modal.node_count(); ++j) {
      const Eigen::Vector3d rho = modal.rho0.col(j) + modal.Phi.middleRows(3 * j, 3) * b.a;
      const Eigen::Vector3d arm = b.A * rho;
      const Eigen::Vector3d dr = b.dr + b.w.cross(arm) + b.A * (modal.Phi.middleRows(3 * j, 3) * b.da);
      // The node's own: J_j turns with it by t, J to second order with w and to first order with da (theory 1.2).
      const Eigen::Matrix3d& J = modal.node_inertia[static_cast<std::size_t>(j)];
      const Eigen::Vector3d w_B = b.A.transpose() * b.w, t = modal.Psi.middleRows(3 * j, 3) * b.a,
                            dt = modal.Psi.middleRows(3 * j, 3) * b.da;
      const Eigen::Matrix3d T = skew(t);
      const Eigen::Vector3d own = (J + T * J - J * T + 0.5 * (T * T * J + J * T * T) - T * J * T) * w_B +
                                  (J + T * J - J * T) * dt + 0.5 * J * t.cross(dt);
      out.linear += modal.node_mass[j] * dr;
      out.angular += modal.node_mass[j] * (b.r + arm).cross(dr) + b.A * own;
    }
  }
  return out;
}

TEST(Conservation, FreeFlexibleBodyKeepsEnergyAndMomentum) {
  // Required: 1e-8. IDA at 1e-11 leaves only its own accumulated error.
  test::Random random(11);
  Model model;
  const Body body("body", test::hand_made_body(random, 5, 6, 500.0));
  BodyState state = test::random_state(random, body);
  state.a *= 0.3;
  model.add_body(body, state);
  test::Run run(model, "ida", test::tight(1e-11));
  const Momentum before = momentum(model, run);
  run.to(1.0);
  const Momentum after = momentum(model, run);
  EXPECT_LT((after.linear - before.linear).norm(), 1e-8 * before.linear.norm());
  EXPECT_LT((after.angular - before.angular).norm(), 1e-8 * before.angular.norm());
  EXPECT_LT(std::abs(run.imbalance()), 1e-8 * run.start_energy());
  EXPECT_GT((run.body(0).a - state.a).norm(), 0.01);  // it did bend
}

TEST(Conservation, ChainWithJointsAndSpringsKeepsEnergyAndMomentum) {
  // Rigid, flexible, rigid body: spherical joint, universal joint, a spring between the ends. Projection acts
  // in every window.
  test::Random random(12);
  Model model;
  const Body parts[3] = {Body("first", 1.0, random.inertia(0.3)),
                         Body("middle", test::hand_made_body(random, 5, 4, 2000.0)),
                         Body("last", 2.0, random.inertia(0.4))};
  for (int i = 0; i < 3; ++i) {
    BodyState state;
    state.r = {1.5 * i, 0.0, 0.0};
    state.L = random.quaternion();
    state.dr = random.vector();
    state.w = random.vector();
    model.add_body(parts[i], state);
  }
  const Eigen::Vector3d p1(0.7, 0.1, 0.0), p2(2.2, -0.1, 0.2);
  model.add_joint(spherical_joint("ball", model.marker_at(0, p1), model.marker_at(1, p1)));
  model.add_joint(universal_joint("cross", model.marker_at(1, p2), model.marker_at(2, p2)));
  std::vector<std::unique_ptr<StrutLaw>> laws;
  laws.push_back(std::make_unique<LinearSpringDamper>(LinearSpringDamperParameters{30.0, 0.0, 0.0, 0.0}));
  model.add_force(std::make_unique<Strut>("spring", model.marker_at(0, {0.0, 0.5, 0.0}),
                                          model.marker_at(2, {3.0, 0.5, 0.0}), std::move(laws), 2.5));
  test::Run run(model, "ida", test::tight(1e-11));
  const Momentum before = momentum(model, run);
  run.to(1.0, 4);
  const Momentum after = momentum(model, run);
  EXPECT_LT((after.linear - before.linear).norm(), 1e-8 * before.linear.norm());
  EXPECT_LT((after.angular - before.angular).norm(), 1e-8 * before.angular.norm());
  EXPECT_LT(std::abs(run.imbalance()), 1e-8 * run.start_energy());
}

TEST(Conservation, DampedFlexibleBodyBalancesWithItsModalDissipation) {
  test::Random random(13);
  Model model({0.0, 0.0, -3.0});
  const Body body("body", test::hand_made_body(random, 5, 6, 2000.0, 0.05));
  BodyState state = test::random_state(random, body);
  model.add_body(body, state);
  test::Run run(model, "ida", test::tight(1e-10));
  run.to(1.0, 3);
  EXPECT_GT(run.state.dissipated[Dissipation::kModal], 1e-2 * run.start_energy());
  EXPECT_LT(std::abs(run.imbalance()), 1e-7 * std::abs(run.start_energy()));
}

TEST(Conservation, StiffBodyMovesAsTheRigidOne) {
  // Static deflections fall with stiffness: 1e10 leaves w^2 / omega^2 = 1e-8 and smaller. Damped, so that the
  // vibration of the start (whose period nobody wants to resolve) dies out.
  test::Random random(14);
  Eigen::Vector3d r[2];
  Eigen::Matrix3d A[2];
  const std::shared_ptr<ModalBody> modal = test::hand_made_body(random, 5, 6, 1e10, 0.5);
  BodyState state;
  state.w = {1.0, -2.0, 0.5};
  state.dr = {0.3, 0.2, 0.1};
  for (int i = 0; i < 2; ++i) {
    const Body flexible("body", modal);
    Model model({0.0, -2.0, 1.0});
    model.add_body(i == 0 ? flexible : Body("body", flexible.mass(), flexible.rigid_inertia()), state);
    test::Run run(model, "one_step", test::tight(1e-9));
    run.to(1.0, 4);
    r[i] = run.body(0).r;
    A[i] = run.body(0).A;
  }
  EXPECT_LT((r[1] - r[0]).norm(), 1e-6);
  EXPECT_LT((A[1] - A[0]).norm(), 1e-6);
}

TEST(Conservation, BodyWithoutModesIsTheRigidBody) {
  // Same equations, not merely the same motion: residuals agree to round-off of the inertia sums.
  test::Random random(15);
  const std::shared_ptr<ModalBody> none = test::hand_made_body(random, 5, 0);
  const Body flexible("body", none);
  BodyState state = test::random_state(random, flexible);
  Eigen::VectorXd F[2];
  for (int i = 0; i < 2; ++i) {
    Model model({0.0, -2.0, 1.0});
    model.add_body(i == 0 ? flexible : Body("body", flexible.mass(), flexible.rigid_inertia()), state);
    model.add_joint(revolute_joint("hinge", ground_marker(Eigen::Vector3d::Zero()),
                                   body_marker(0, model.body(0), Eigen::Vector3d(0.2, 0.3, 0.1))));
    Equations equations(model, test::as_given(model));
    Eigen::VectorXd y(equations.layout().size()),
        ydot = Eigen::VectorXd::LinSpaced(equations.layout().size(), -1.0, 2.0);
    equations.layout().pack(test::as_given(model).state, Eigen::VectorXd::LinSpaced(5, 1.0, 2.0), y);
    F[i].resize(y.size());
    equations.residual(0.0, y, ydot, {}, F[i]);
  }
  EXPECT_LT((F[1] - F[0]).norm(), 1e-13 * F[0].norm());
}

// A slider-crank whose connecting rod bends, against an independent solution: Euler-Bernoulli modes of the rod between
// its pins in the frame of its chord, which moves as the rigid mechanism does.

constexpr double kCrank = 0.15, kRod = 0.3, kRodDiameter = 0.006;  // [m]
constexpr double kGain = 5.0;  // crank angle kGain t^4 [rad]: a start without a jolt
constexpr int kElements = 8, kMiddle = 4;

double crank_angle(double t) { return kGain * std::pow(t, 4); }

struct SliderCrank {
  // young: of the rod; 0 makes it rigid.
  explicit SliderCrank(double young, int modes = 9, double damping = 0.0) {
    const Material steel{7850.0, young > 0.0 ? young : 207e9, 0.3};
    const Eigen::Vector3d pin(kCrank, 0, 0), wrist(kCrank + kRod, 0, 0);
    const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    const MassProperties arm = rod_properties(Eigen::Vector3d::Zero(), pin, 0.02, 7850.0);
    BodyState state;
    state.r = arm.centre;
    const int crank = model.add_body(Body("crank", arm.mass, arm.inertia), state);
    BasisOptions options;
    options.mode_count = modes;
    options.damping_ratio = {damping};
    options.interface_nodes = {0};
    options.pinned_nodes = {kElements};
    modal = std::make_shared<const ModalBody>(
        reduce(test::straight_beam(pin, wrist, kElements, rod_section(kRodDiameter), steel), options, "rod").body);
    const Body flexible("rod", modal);
    state.r = 0.5 * (pin + wrist);
    rod = model.add_body(young > 0.0 ? flexible : Body("rod", flexible.mass(), flexible.rigid_inertia()), state);
    const MassProperties block = with_mass(sphere_properties(0.01, 7850.0), 0.02);
    state.r = wrist;
    slider = model.add_body(Body("slider", block.mass, block.inertia), state);
    PrescribedMotion drive;
    for (auto& component : drive.translation) component = polynomial({0.0});
    drive.rotation = polynomial({0.0, 0.0, 0.0, 0.0, kGain});
    drive.rotation_axis = 2;
    drive.hold_other_rotations = true;
    model.add_joint(prescribed_joint("drive", ground_marker(Eigen::Vector3d::Zero(), axes),
                                     model.marker_at(crank, Eigen::Vector3d::Zero(), axes), drive));
    // Of a pin all but what the way holds already: the rod may not turn about itself.
    // x1 is W's z
    const Eigen::Matrix3d cross = Eigen::AngleAxisd(-0.5 * kPi, Eigen::Vector3d::UnitY()).toRotationMatrix();
    model.add_joint(universal_joint("pin", model.marker_at(crank, pin, cross), model.marker_at(rod, pin, cross)));
    model.add_joint(spherical_joint("wrist", model.marker_at(rod, wrist), model.marker_at(slider, wrist)));
    const Eigen::Matrix3d along_x = axes_with_z(Eigen::Vector3d::UnitX());
    model.add_joint(prismatic_joint("way", ground_marker(wrist, along_x), model.marker_at(slider, wrist, along_x)));
  }
  // Of the middle of the rod from its chord, towards +y at the start [m].
  double deflection(test::Run& run) const {
    const BodyKinematics b = run.body(rod);
    const auto node = [&](int j) {
      return Eigen::Vector3d(b.r + b.A * (modal->rho0.col(j) + modal->Phi.middleRows(3 * j, 3) * b.a));
    };
    const Eigen::Vector3d chord = (node(kElements) - node(0)).normalized();
    return Eigen::Vector3d(-chord.y(), chord.x(), 0.0).dot(node(kMiddle) - node(0));
  }
  Model model;
  int rod = 0, slider = 0;
  std::shared_ptr<const ModalBody> modal;
};

// Transverse acceleration of the rod's points in the rigid mechanism: at the pin, and its rise per length along the
// rod.
void rigid_load(double t, double* at_pin, double* per_length, double* spin) {
  const double theta = crank_angle(t), w = 4.0 * kGain * std::pow(t, 3), dw = 12.0 * kGain * t * t;
  // Rod at the angle phi: kRod sin phi = -kCrank sin theta.
  const double sin_phi = -kCrank / kRod * std::sin(theta), cos_phi = std::sqrt(1.0 - sin_phi * sin_phi);
  const double dphi = -kCrank / kRod * std::cos(theta) * w / cos_phi;
  const double ddphi =
      (-kCrank / kRod * (std::cos(theta) * dw - std::sin(theta) * w * w) + sin_phi * dphi * dphi) / cos_phi;
  const double ax = -kCrank * (std::sin(theta) * dw + std::cos(theta) * w * w),
               ay = kCrank * (std::cos(theta) * dw - std::sin(theta) * w * w);
  *at_pin = -sin_phi * ax + cos_phi * ay;
  *per_length = ddphi;
  *spin = dphi;
}

// Mode n: shape sin(n pi x / L); q'' + (omega_n^2 - dphi^2) q = -(2/L) integral of (a + b x) sin(n pi x / L). Leapfrog,
// until t.
class ChordSolution {
 public:
  void to(double t_end) {
    while (t_ < t_end - 1e-12) {
      const double h = std::min(kStep, t_end - t_);
      double a, b, spin;
      for (int half = 0; half < 2; ++half) {
        if (half == 1) {
          for (int n = 1; n <= kModes; n += 2) q_[n] += h * dq_[n];
          t_ += h;
        }
        rigid_load(t_, &a, &b, &spin);
        for (int n = 1; n <= kModes; n += 2) {  // even ones have their node in the middle
          const double load = -(4.0 * a + 2.0 * b * kRod) / (n * kPi);
          dq_[n] += 0.5 * h * (load - (omega2(n) - spin * spin) * q_[n]);
        }
      }
    }
  }
  double middle() const { return q_[1] - q_[3] + q_[5]; }

 private:
  static constexpr int kModes = 5;
  static constexpr double kStep = 1e-5;  // [s]; the fifth mode has 2.1e4 rad/s
  static double omega2(int n) {
    return std::pow(n * kPi / kRod, 4) * 207e9 / 7850.0 * kRodDiameter * kRodDiameter / 16.0;
  }
  double t_ = 0.0, q_[kModes + 1] = {}, dq_[kModes + 1] = {};
};

TEST(FlexibleSliderCrank, RodBendsAsInTheChordFrame) {
  const double t_end = 1.0;
  const SliderCrank mechanism(207e9), more(207e9, 21);
  test::Run run(mechanism.model, "one_step", test::tight(1e-7)), finer(more.model, "one_step", test::tight(1e-7));
  ChordSolution exact;
  double largest = 0.0, error = 0.0, modes = 0.0;
  for (int i = 1; i <= 50; ++i) {
    const double t = t_end * i / 50;
    run.to(t);
    finer.to(t);
    exact.to(t);
    largest = std::max(largest, std::abs(exact.middle()));
    error = std::max(error, std::abs(mechanism.deflection(run) - exact.middle()));
    modes = std::max(modes, std::abs(mechanism.deflection(run) - more.deflection(finer)));
  }
  std::printf("  largest deflection %.5g mm; error %.2e of it, change with twice the modes %.2e\n", 1e3 * largest,
              error / largest, modes / largest);
  EXPECT_GT(largest, 1e-5);
  // Axial force over the rod's buckling load, which neither solution holds in full, and the integrator's tolerance.
  EXPECT_LT(error, 2e-3 * largest);
  EXPECT_LT(modes, 2e-3 * largest);
}

TEST(FlexibleSliderCrank, WithAStiffRodIsTheRigidOne) {
  // Damped: nobody wants to resolve vibrations of a stiff rod.
  const SliderCrank stiff(207e9 * 1e4, 9, 0.5), rigid(0.0);
  test::Run bent(stiff.model, "one_step", test::tight(1e-8)), straight(rigid.model, "one_step", test::tight(1e-8));
  for (int i = 1; i <= 10; ++i) {
    bent.to(0.1 * i);
    straight.to(0.1 * i);
    EXPECT_LT((bent.body(stiff.slider).r - straight.body(rigid.slider).r).norm(), 1e-6);
    EXPECT_LT((bent.body(stiff.rod).r - straight.body(rigid.rod).r).norm(), 1e-6);
    EXPECT_LT((bent.body(stiff.rod).A - straight.body(rigid.rod).A).norm(), 1e-6);
  }
}

// Torsional springs and bushings turn a flexible body where their point is, not elsewhere: a clamped rod under the moment
// of a spring at x = p bends as theta(p) = M p / (EI), and the spring gives M = k (phi0 - theta(p)).

constexpr double kYoung = 207e9, kThick = 0.02, kSpring = 1000.0, kTwist = 0.01;  // [Pa, m, N m/rad, rad]

// A rod of 1 m, clamped at x = 0, drawn so that its middle, and the node nearest to the drawing's origin, are elsewhere.
std::string clamped_rod(const std::string& spring) {
  return "end_time = 1\ngravity = [0, 0, 0]\n[materials.steel]\ndensity = 7850\nyoung_GPa = 207\n[[bodies]]\nname = "
         "\"rod\"\nmaterial = \"steel\"\nshape = { kind = \"rod\", from = [0, 0, 0], to = [1, 0, 0], diameter = 0.02 "
         "}\n"
         "flexible = { modes = 3, elements = 8 }\n[[joints]]\nname = \"clamp\"\nkind = \"fixed\"\nbodies = "
         "[\"ground\", "
         "\"rod\"]\npoint = [0, 0, 0]\n" +
         spring;
}

TEST(TorsionalSpring, TurnsAFlexibleBodyWhereItsPointIs) {
  const double EI = kYoung * kPi * std::pow(kThick, 4) / 64.0;
  for (const double p : {0.25, 0.5, 1.0}) {
    const Scene scene = SceneText().read(clamped_rod(
        "[[springs]]\nname = \"twist\"\nkind = \"torsion\"\nbodies = [\"ground\", \"rod\"]\naxis = \"y\"\npoint = [" +
        std::to_string(p) + ", 0, 0]\nstiffness = 1000\nrest_angle = 0.01\n"));
    const Mechanism mechanism = build_mechanism(scene);
    test::Run run(mechanism.model);
    run.state = settle(scene, {}, test::as_a_scene(1e-6)).state;
    const double theta = kTwist * kSpring / (kSpring + EI / p);
    // Of rod and spring together. Modes are exact for what is attached, and what is left of the motion counts in second
    // order: the square of the angle and the figures of the scene are left.
    const double stored = 0.5 * EI / p * theta * theta + 0.5 * kSpring * (kTwist - theta) * (kTwist - theta);
    EXPECT_NEAR(run.energy().stored[Stored::kStrain], stored, 1e-4 * stored) << "at " << p << " m";
  }
}

// Segments (mbd_solver/scene/resolve.cpp) bring what a floating frame with linear modes leaves out: a spinning rod
// stiffens by its own tension. Exact: Wright, Smith, Thresher and Wang, J. Appl. Mech. 49 (1982), 197, Table 1: uniform
// cantilever without hub, first flapping frequency over sqrt(EI / (m L^4)) at spin rates eta in the same unit.

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
       << ", damping = 0 }\n[[joints]]\nname = \"hub\"\nkind = \"prescribed\"\n"
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

}  // namespace flexible_bodies
}  // namespace footfall
