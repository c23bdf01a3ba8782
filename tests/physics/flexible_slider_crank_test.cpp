// A slider-crank whose connecting rod bends, against an independent solution: Euler-Bernoulli modes of the rod between
// its pins in the frame of its chord, whose motion is that of the rigid mechanism.

#include <cmath>
#include <cstdio>

#include "coupler/base/pi.h"
#include "mbd_solver/fe/modal_basis.h"
#include "mbd_solver/model/mass_properties.h"
#include "tests/unit/dynamics/random_model.h"
#include "tests/unit/dynamics/run.h"

namespace footfall {
namespace {

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
        reduce(straight_beam(pin, wrist, kElements, rod_section(kRodDiameter), steel), options, "rod").body);
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

}  // namespace
}  // namespace footfall
