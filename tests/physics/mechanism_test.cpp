// Mechanisms with exact or published motion.
#include <gtest/gtest.h>
#include <Eigen/Dense>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "coupler/base/errors.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/elements/strut.h"
#include "mbd_solver/model/laws/mr_damper.h"
#include "mbd_solver/model/laws/springs.h"
#include "mbd_solver/model/mass_properties.h"
#include "tests/physics/mechanisms.h"
#include "tests/physics/motion_of.h"
#include "tests/support/linear_algebra.h"
#include "tests/support/refused.h"
#include "tests/unit/dynamics/random_model.h"
#include "tests/unit/dynamics/run.h"
#include "tests/validation/famous_mechanisms.h"

namespace footfall {
namespace mechanisms {

// Mechanisms with exact or published solutions: pendulum, slider-crank, N four-bar.

const Eigen::Matrix3d kAxesOfW = Eigen::Matrix3d::Identity();

// A thin uniform rod of 1 kg between two points, with its angular velocity about z.
int add_rod(Model& model, const std::string& name, const Eigen::Vector3d& from, const Eigen::Vector3d& to, double w) {
  return test::add_rod(model, name, from, to, w * Eigen::Vector3d::UnitZ());
}

using test::hinge;
using test::n_four_bar;

class MechanismBy : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Integrators, MechanismBy, ::testing::Values("one_step", "ida"));

TEST_P(MechanismBy, PendulumKeepsItsPeriod) {
  // Rod of length l about its end, released at rest at amplitude A: T = 4 sqrt(2 l / (3 g)) K(sin(A/2)).
  const double amplitude = 2.0, g = 9.81;
  Model model({0.0, -g, 0.0});
  const Eigen::Vector3d tip(std::sin(amplitude), -std::cos(amplitude), 0.0);
  const int rod = add_rod(model, "rod", Eigen::Vector3d::Zero(), tip, 0.0);
  model.add_joint(hinge(model, "pivot", kGround, rod, Eigen::Vector3d::Zero()));
  const double stiffness_ratio = std::sqrt(3.0 * g / 2.0 / (1.0 + 0.0));  // thin rod: J about the end = m l^2 / 3
  const double period = 4.0 / stiffness_ratio * std::comp_ellint_1(std::sin(0.5 * amplitude));
  test::Run run(model, GetParam(), test::tight(1e-8));
  const Eigen::Vector3d start = run.body(rod).r;
  run.to(period, 20);
  // The rod is 10 mm thick: its inertia about the end is larger by 3/16 d^2 = 1.9e-5 of itself, so the period
  // by 0.9e-5; the position at the turning point errs with the square of that, the velocity with its first
  // power.
  EXPECT_LT((run.body(rod).r - start).norm(), 1e-5);
  EXPECT_LT(run.body(rod).dr.norm(), 3e-4);
  // tolerance times some thousand steps of the second-order method
  EXPECT_LT(std::abs(run.imbalance()), 1e-5 * g);
}

// A force constant in W at a point of a body.
class PointForce : public ForceElement {
 public:
  PointForce(Marker marker, const Eigen::Vector3d& force)
      : ForceElement("force", marker.body, kGround), marker_(std::move(marker)), force_(force) {}
  void add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q, Eigen::Ref<Eigen::VectorXd>) const override {
    KinematicVector::point(in.pair, 0, marker_).add_transposed(force_, Q);
  }
  bool add_derivatives(const ElementInput& in, ElementDerivatives& out) const override {
    KinematicVector::point(in.pair, 0, marker_).add_second(force_, out.dQ_dx);
    return true;
  }
  void add_energy(const ElementInput& in, StoredEnergy& stored, Dissipated&) const override {
    stored[Stored::kStrain] -= force_.dot(KinematicVector::point(in.pair, 0, marker_).value());
  }

 private:
  Marker marker_;
  Eigen::Vector3d force_;
};

TEST_P(MechanismBy, SliderCrankReachesThePublishedState) {
  // The mechanism of the SUNDIALS example idaSlCrank_dns: crank of radius 0.5 and inertia 1 about the origin;
  // connecting rod of mass 1 and inertia 2 whose centre slides along x, with the crank pin at -1 and a
  // constant force of 1 N along x at +1 on its own axis; spring and damper (1 N/m, free length 1 m, 1 N s/m)
  // between the middle of the crank and the point at -1/2 on the rod.
  Model model;
  const double a = 0.5, p = std::asin(-a);
  BodyState crank_state, rod_state;
  crank_state.L = quaternion_about(Eigen::Vector3d::UnitZ(), 0.5 * kPi);
  rod_state.r = {std::cos(p), 0.0, 0.0};
  rod_state.L = quaternion_about(Eigen::Vector3d::UnitZ(), p);
  const int crank = model.add_body(Body("crank", 1.0, Eigen::Matrix3d::Identity()), crank_state);
  const int rod = model.add_body(Body("rod", 1.0, 2.0 * Eigen::Matrix3d::Identity()), rod_state);
  const Marker origin = ground_marker(Eigen::Vector3d::Zero());
  const auto at = [&](int body, double x) { return body_marker(body, model.body(body), {x, 0.0, 0.0}); };
  model.add_joint(revolute_joint("bearing", origin, at(crank, 0.0)));
  model.add_joint(revolute_joint("pin", at(crank, a), at(rod, -1.0)));
  model.add_joint(point_on_plane_joint(
      "slide", ground_marker(Eigen::Vector3d::Zero(), axes_with_z(Eigen::Vector3d::UnitY())), at(rod, 0.0)));
  std::vector<std::unique_ptr<StrutLaw>> laws;
  laws.push_back(std::make_unique<LinearSpringDamper>(LinearSpringDamperParameters{1.0, 1.0, 0.0, 0.0}));
  model.add_force(std::make_unique<Strut>("spring", at(crank, 0.5 * a), at(rod, -0.5), std::move(laws), 1.0));
  model.add_force(std::make_unique<PointForce>(at(rod, 1.0), Eigen::Vector3d::UnitX()));

  test::Run run(model, GetParam(), test::tight(1e-7));
  run.to(10.0, 40);
  const BodyKinematics c = run.body(crank), r = run.body(rod);
  // Printed: 1.2757, 1.0236, -0.49881 with rtol = atol = 1e-6: half a unit of the last digit, plus that
  // example's own error of 1e-5.
  EXPECT_NEAR(std::atan2(c.A(1, 0), c.A(0, 0)), 1.2757, 6e-5);
  EXPECT_NEAR(r.r.x(), 1.0236, 6e-5);
  EXPECT_NEAR(std::atan2(r.A(1, 0), r.A(0, 0)), -0.49881, 1.5e-5);
  EXPECT_NEAR(r.r.z(), 0.0, 1e-10);
  EXPECT_LT(std::abs(run.imbalance()), 1e-5);
}

TEST_P(MechanismBy, FourBarPassesItsSingularPositionsWithItsEnergy) {
  // Whenever all posts lie flat the mechanism could change its branch and Phi_v loses rank. The benchmark
  // asks for 10 s with an energy error below 0.1 J; at this tolerance a hundred times less must come out.
  const Model model = n_four_bar(2);
  test::Run run(model, GetParam(), test::tight(1e-8));
  EXPECT_EQ(run.assembly.rank, 29);  // 5 bodies of 6, one degree of freedom
  EXPECT_FALSE(run.assembly.notes.empty());
  int passes = 0;
  double last = run.body(0).r.y();
  for (int i = 1; i <= 1000; ++i) {
    run.to(0.01 * i);
    const double height = run.body(0).r.y();
    if (height * last < 0.0) ++passes;
    last = height;
    ASSERT_LT(std::abs(run.imbalance()), 1e-3) << "t = " << run.state.time;
  }
  EXPECT_GT(passes, 2);
  EXPECT_LT(run.equations.saddle().drift(run.state).position, 1e-8);
}

TEST(FourBar, ReactionsAreFiniteAndNamed) {
  const Model model = n_four_bar(1);
  test::Run run(model, "one_step", test::tight(1e-8));
  ASSERT_FALSE(run.assembly.notes.empty());
  EXPECT_TRUE(test::names(run.assembly.notes[0], {"redundant"}));
  run.to(0.2);
  run.equations.load(run.state);
  // Forces on one post: both hinges and gravity make its acceleration.
  const Eigen::VectorXd rates = run.integrator->end_rates();
  const Layout& layout = run.equations.layout();
  const Eigen::Vector3d foot = run.equations.joint_wrench(0, run.state.time, rates.tail(layout.row_count)).head<3>();
  const Eigen::Vector3d top = -run.equations.joint_wrench(1, run.state.time, rates.tail(layout.row_count)).head<3>();
  const Eigen::Vector3d ddr = rates.segment<3>(layout.v0());
  // N; drift removed after the rates were taken
  EXPECT_LT((foot + top + model.gravity() - ddr).norm(), 1e-7);
}

// Reactions of mechanisms with more conditions than they need: of all multipliers that give the same forces on the bodies,
// both integrators hand out the reactions of the smallest sum (s_i lambda_i)^2 (theory 2.2).

struct RedundantMechanism {
  std::string name;
  std::function<Model()> make;
  double t_end;  // [s], a regular position
  int too_many;  // conditions
  double rtol = 1e-8;
};

void PrintTo(const RedundantMechanism& mechanism, std::ostream* out) { *out << mechanism.name; }

const std::vector<RedundantMechanism>& redundant_mechanisms() {
  static const std::vector<RedundantMechanism> all = {
      {"Bennett", [] { return test::bennett(); }, 0.8, 3},
      {"Bricard",
       [] {
         return test::bricard(
             0.01, [] { return 0.0; }, [] { return false; });
       },
       0.8, 1},
      {"FourBars", [] { return test::n_four_bar(2); }, 0.4, 6},
      {"CrankRocker", [] { return test::crank_rocker(3, false); }, 0.5, 3},
      {"Squeezer", [] { return test::squeezer(); }, 0.01, 9}};
  return all;
}

class Reactions : public ::testing::TestWithParam<RedundantMechanism> {};
INSTANTIATE_TEST_SUITE_P(Of, Reactions, ::testing::ValuesIn(redundant_mechanisms()),
                         [](const auto& mechanism) { return mechanism.param.name; });

// What the page says of them, written down anew with dense matrices: nothing of it is taken from the solver but M and Phi_v.
struct Page {
  Eigen::MatrixXd M, Phi_v;
  Eigen::VectorXd s;  // of every row, at the start

  // Of all reactions equal to `lambda` in effect, the set of the smallest sum (s_i lambda_i)^2: lambda = S^-1 (Phi_v^T S^-1)^+ Phi_v^T lambda.
  Eigen::VectorXd smallest(const Eigen::VectorXd& lambda, int rank) const {
    const Eigen::VectorXd inverse = s.cwiseInverse();
    const Eigen::MatrixXd A = Phi_v.transpose() * inverse.asDiagonal();
    const test::SingularValues svd = test::singular_values(A);
    const Eigen::VectorXd f = Phi_v.transpose() * lambda;
    const Eigen::VectorXd part = svd.U.leftCols(rank).transpose() * f;
    return inverse.cwiseProduct(svd.V.leftCols(rank) * part.cwiseQuotient(svd.s.head(rank)));
  }
  double size(const Eigen::VectorXd& lambda) const { return s.cwiseProduct(lambda).norm(); }
};

Page page_at(test::Run& run) {
  const Layout& layout = run.equations.layout();
  const int n = layout.v_size, rows = layout.row_count;
  Eigen::VectorXd rates(layout.size()), y(layout.size()), x = Eigen::VectorXd::Zero(layout.size()), Mx = x;
  run.equations.saddle().accelerations(run.state, run.inputs, rates);
  run.equations.layout().pack(run.state, rates.tail(rows), y);
  Page page;
  page.M = Eigen::MatrixXd(n, n);
  page.Phi_v = Eigen::MatrixXd(rows, n);
  for (int k = 0; k < n; ++k) {
    x.setZero();
    x[layout.v0() + k] = 1.0;
    run.equations.apply_mass(y, x, run.state.time, Mx);  // dF/dydot x
    page.M.col(k) = Mx.segment(layout.v0(), n);
    page.Phi_v.col(k) = Mx.tail(rows);
  }
  return page;
}

// s_i^2: mean of (Phi_v M^-1 Phi_v^T)_kk over the joint's lengths, or angles.
Eigen::VectorXd sizes_of_rows(const Page& page, const Model& model, const Layout& layout) {
  const Eigen::VectorXd each = (page.Phi_v * test::solve(page.M, page.Phi_v.transpose())).diagonal();
  Eigen::VectorXd s(each.size());
  for (int j = 0; j < model.joint_count(); ++j) {
    const std::vector<ConstraintRow>& rows = model.joint(j).rows;
    const int first = layout.joint_row[static_cast<std::size_t>(j)];
    for (std::size_t i = 0; i < rows.size(); ++i) {
      double sum = 0.0, count = 0.0;
      for (std::size_t k = 0; k < rows.size(); ++k) {
        if (rows[k].unit != rows[i].unit) continue;
        sum += each[first + static_cast<int>(k)];
        count += 1.0;
      }
      s[first + static_cast<int>(i)] = std::sqrt(sum / count);
    }
  }
  return s;
}

struct Found {
  State state;
  Eigen::VectorXd lambda;
};

// At a row on the way and at the end.
std::vector<Found> reactions_of(const Model& model, const std::string& kind, const RedundantMechanism& mechanism) {
  test::Run run(model, kind, test::as_a_scene(mechanism.rtol));
  const int rows_of_joints = run.equations.layout().row_count;
  std::vector<Found> out;
  Rows rows;
  const double middle = 0.5 * mechanism.t_end;
  rows.next = [=](double time) { return time < middle ? middle : HUGE_VAL; };
  rows.on_row = [&](const State& state, const Eigen::VectorXd& rates) {
    out.push_back({state, rates.tail(rows_of_joints)});
    return true;
  };
  run.integrator->advance(run.state, mechanism.t_end, run.inputs, rows);
  out.push_back({run.state, run.integrator->end_rates().tail(rows_of_joints)});
  return out;
}

TEST_P(Reactions, AreTheSmallestByBothIntegrators) {
  const RedundantMechanism& mechanism = GetParam();
  const Model model = mechanism.make();
  test::Run here(model, "one_step", test::as_a_scene(mechanism.rtol));
  const Layout& layout = here.equations.layout();
  ASSERT_EQ(layout.row_count - here.assembly.rank, mechanism.too_many);
  const Eigen::VectorXd s = sizes_of_rows(page_at(here), model, layout);

  const std::vector<Found> one_step = reactions_of(model, "one_step", mechanism),
                           ida = reactions_of(model, "ida", mechanism);
  ASSERT_EQ(one_step.size(), 2u);
  ASSERT_EQ(ida.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    for (const std::vector<Found>* by : {&one_step, &ida}) {
      const Found& found = (*by)[i];
      const std::string where = (by == &ida ? "ida" : "one_step") + std::string(i == 0 ? ", in a row" : ", at the end");
      here.state = found.state;
      Page page = page_at(here);
      page.s = s;
      const Eigen::VectorXd smallest = page.smallest(found.lambda, here.assembly.rank);
      // kSoft of make_smallest(), three times refined, leaves far less; drift of 1e-10 tilts Phi_v by as much.
      EXPECT_LT(page.size(found.lambda - smallest), 1e-7 * page.size(smallest)) << where;
      // As a direct solve at the same state has them: the multipliers of a step err by what Newton leaves.
      Eigen::VectorXd rates(layout.size());
      here.equations.saddle().accelerations(found.state, here.inputs, rates);
      EXPECT_LT(page.size(found.lambda - rates.tail(layout.row_count)), 1e-4 * page.size(smallest)) << where;
    }
    // A thousand tolerances: the motions differ by up to a hundred, and reactions follow the accelerations.
    EXPECT_LT(s.cwiseProduct(one_step[i].lambda - ida[i].lambda).norm(),
              1e3 * mechanism.rtol * s.cwiseProduct(one_step[i].lambda).norm());
  }
}

// Chains whose neighbours differ by many orders of magnitude in mass: right, or told with a name.

// Rods of 1 m on hinges, level at the start; every other one, the first included, weighs 1 / ratio kg, the rest 1 kg.
Model chain(int rods, double ratio) {
  Model model({0.0, -9.81, 0.0});
  int last = kGround;
  for (int i = 0; i < rods; ++i) {
    const std::string number = std::to_string(i);
    const Eigen::Vector3d from(i, 0.0, 0.0), to(i + 1.0, 0.0, 0.0), none = Eigen::Vector3d::Zero();
    const int rod = test::add_rod(model, "rod_" + number, from, to, none, none, i % 2 == 0 ? 1.0 / ratio : 1.0, 0.1);
    model.add_joint(test::hinge(model, "hinge_" + number, last, rod, from));
    last = rod;
  }
  return model;
}

class MassRatios : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Integrators, MassRatios, ::testing::Values("one_step", "ida"));

TEST_P(MassRatios, LightRodsBetweenHeavyOnesHoldThemAsRodsWithoutMassDo) {
  // All ratios have the same limit, which they reach to 1 / ratio. They hold some 60 J.
  constexpr double kEnd = 0.5, kRtol = 1e-6;
  for (const int rods : {3, 6}) {
    const Model almost_none = chain(rods, 1e9);
    test::Run limit(almost_none, "one_step", test::as_a_scene(1e-8));
    const test::Motion start = test::motion_of(limit);
    limit.to(kEnd);
    const test::Motion end = test::motion_of(limit);
    const test::Size size = test::size_of(start, end);
    for (const double ratio : {1e8, 1e10, 1e12, 1e14}) {
      const Model model = chain(rods, ratio);
      test::Run run(model, GetParam(), test::as_a_scene(kRtol));
      run.to(kEnd);
      EXPECT_LT(test::difference(test::motion_of(run), end, size), 100.0 * kRtol) << rods << " rods, " << ratio;
      EXPECT_LT(std::abs(run.imbalance()), 2e-3) << rods << " rods, " << ratio;
    }
  }
}

TEST(MassRatio, BeyondDoublePrecisionNamesTheBody) {
  std::string said = "nothing";
  try {
    const Model model = chain(4, 1e20);
    test::Run run(model, "one_step", test::as_a_scene(1e-6));
  } catch (const InputError& error) {
    said = error.what();
  }
  EXPECT_TRUE(test::names(said, {"rod_0"}));
}

// One body at a time, against closed forms: free top, damped oscillators, impact and rolling on the rigid
// plane.

class SingleBodyBy : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Integrators, SingleBodyBy, ::testing::Values("one_step", "ida"));

TEST_P(SingleBodyBy, SymmetricTopNutatesAsInClosedForm) {
  // w = H / J1 + w3 (1 - J3 / J1) e3: the attitude turns about H at |H| / J1 and about its own axis at w3 (1
  // - J3 / J1).
  Model model;
  const double J1 = 2.0, J3 = 3.0;
  BodyState state;
  state.L = quaternion_about({1.0, 2.0, -0.5}, 0.7);
  const Eigen::Matrix3d A0 = rotation_matrix(state.L);
  const Eigen::Vector3d w_B(1.0, 0.5, 4.0);
  state.w = A0 * w_B;
  state.dr = {0.1, 0.2, 0.3};
  const Eigen::Matrix3d J = Eigen::Vector3d(J1, J1, J3).asDiagonal();
  const int top = model.add_body(Body("top", 1.5, J), state);
  const Eigen::Vector3d H = A0 * J * w_B;
  test::Run run(model, GetParam(), test::tight(1e-9));
  const double t = 2.0;
  run.to(t, 4);
  const Eigen::Matrix3d expected =
      rotation_matrix(quaternion_about(H, H.norm() / J1 * t)) * A0 *
      rotation_matrix(quaternion_about(Eigen::Vector3d::UnitZ(), w_B[2] * (1.0 - J3 / J1) * t));
  const BodyKinematics now = run.body(top);
  // second-order method at 1e-9 per step: steps of 2e-4 s, 1e4 of them
  EXPECT_LT((now.A - expected).norm(), 1e-5);
  EXPECT_LT((now.A * J * now.A.transpose() * now.w - H).norm(), 1e-5 * H.norm());
  EXPECT_LT((now.r - t * state.dr).norm(), 1e-12);  // free flight is linear: exact
}

// A body that slides along z over the ground, tied to it by a strut of the given law; its free length is 1 m.
struct Oscillator {
  explicit Oscillator(std::unique_ptr<StrutLaw> spring, std::unique_ptr<StrutLaw> damper, double mass, double z0) {
    BodyState state;
    state.r = {0.0, 0.0, 1.0 + z0};
    body = model.add_body(Body("mass", mass, Eigen::Matrix3d::Identity()), state);
    const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    model.add_joint(prismatic_joint("slide", model.marker_at(kGround, origin), model.marker_at(body, state.r)));
    std::vector<std::unique_ptr<StrutLaw>> laws;
    laws.push_back(std::move(spring));
    laws.push_back(std::move(damper));
    model.add_force(std::make_unique<Strut>("strut", ground_marker(origin), model.marker_at(body, state.r),
                                            std::move(laws), 1.0, 0));
  }
  Model model;
  int body = 0;
};

std::unique_ptr<StrutLaw> spring(double k) {
  return std::make_unique<LinearSpringDamper>(LinearSpringDamperParameters{k, 0.0, 0.0, 0.0});
}
std::unique_ptr<StrutLaw> dashpot(double c) {
  return std::make_unique<LinearSpringDamper>(LinearSpringDamperParameters{0.0, c, 0.0, 0.0});
}

TEST_P(SingleBodyBy, ViscousOscillatorDecaysAsInClosedForm) {
  const double k = 200.0, m = 2.0, c = 4.0, z0 = 0.1, t = 1.3;
  Oscillator o(spring(k), dashpot(c), m, z0);
  test::Run run(o.model, GetParam(), test::tight(1e-9));
  run.to(t, 5);
  const double delta = 0.5 * c / m, omega = std::sqrt(k / m - delta * delta);
  const double z = z0 * std::exp(-delta * t) * (std::cos(omega * t) + delta / omega * std::sin(omega * t));
  EXPECT_NEAR(run.body(o.body).r.z() - 1.0, z, 1e-5 * z0);
  // Dissipated energy has its place, its name, and the size of what is missing.
  EXPECT_GT(run.state.dissipated[Dissipation::kDamper], 0.5);
  // second-order method, tolerance 1e-9 over 1e4 steps
  EXPECT_LT(std::abs(run.imbalance()), 1e-5 * run.start_energy());
}

TEST_P(SingleBodyBy, CoulombOscillatorLosesTheSameAmplitudeEveryHalfPeriod) {
  // Turning points 2 F / k closer to the middle after each half period. Regularised at 1e-5 m/s, against
  // speeds of 1 m/s.
  const double k = 400.0, m = 1.0, F = 2.0, z0 = 0.05;
  Oscillator o(spring(k), std::make_unique<MrDamper>(MrDamperParameters{F, 0.0, 1e-5, 0.0, 0.0, {}}), m, z0);
  test::Run run(o.model, GetParam(), test::tight(1e-8));
  run.inputs.values = Eigen::VectorXd::Ones(1);
  const double half_period = kPi * std::sqrt(m / k);
  for (int i = 1; i <= 4; ++i) {
    run.to(i * half_period, 3);
    const double expected = (i % 2 == 0 ? 1.0 : -1.0) * (z0 - i * 2.0 * F / k);
    EXPECT_NEAR(run.body(o.body).r.z() - 1.0, expected, 1e-5)
        << i;  // v_s times the time spent at that speed, and tolerance
  }
  // After 4 half periods the rest amplitude is 0.01; the fifth ends where the spring cannot overcome friction
  // (k z < F): it stays.
  run.to(5.5 * half_period, 3);
  const double rest = run.body(o.body).r.z();
  run.to(8.0 * half_period, 3);
  EXPECT_NEAR(run.body(o.body).r.z(), rest, 1e-5);  // creep at most 1e-5 m/s for 0.4 s
  EXPECT_LT(std::abs(run.imbalance()), 1e-4 * run.start_energy());
}

// A ball on the plane z = 0.
struct Ball {
  Ball(const RigidPlane::Parameters& plane, double radius, const BodyState& state, const Eigen::Vector3d& gravity)
      : model(gravity) {
    const MassProperties sphere = with_mass(sphere_properties(radius, 1.0), 2.0);
    body = model.add_body(Body("ball", sphere.mass, sphere.inertia), state);
    auto contact = std::make_unique<RigidPlane>(
        "plane", std::vector<ContactPoint>{{body_marker(body, model.body(body), Eigen::Vector3d::Zero()), radius}},
        plane);
    element = contact.get();
    model.add_force(std::move(contact));
  }
  Model model;
  int body = 0;
  const RigidPlane* element = nullptr;
};

TEST_P(SingleBodyBy, ElasticImpactHasHertzDepthAndDuration) {
  RigidPlane::Parameters plane;
  plane.stiffness = 1e6;
  plane.friction = 0.0;
  const double radius = 0.1, v = 2.0, m = 2.0;
  BodyState state;
  state.r = {0.0, 0.0, radius + 1e-9};
  state.dr = {0.0, 0.0, -v};
  Ball ball(plane, radius, state, Eigen::Vector3d::Zero());
  // depth = (5 m v^2 / (4 k))^(2/5), duration 2.9432 depth / v
  const double depth = std::pow(1.25 * m * v * v / plane.stiffness, 0.4), duration = 2.9432 * depth / v;
  test::Run run(ball.model, GetParam(), test::tight(1e-9));
  run.to(0.5 * duration, 3);
  run.equations.load(run.state);
  const ElementInput in = run.equations.element_input(0, run.state, run.inputs);
  EXPECT_NEAR(ball.element->largest_overlap(in), depth, 1e-4 * depth);
  EXPECT_NEAR(ball.element->wrench(in)[2], plane.stiffness * std::pow(depth, 1.5),
              1e-3 * plane.stiffness * std::pow(depth, 1.5));
  run.to(0.999 * duration);
  EXPECT_LT(run.body(ball.body).r.z(), radius);
  run.to(1.001 * duration);
  EXPECT_GT(run.body(ball.body).r.z(), radius);
  EXPECT_NEAR(run.body(ball.body).dr.z(), v, 1e-5 * v);
}

TEST_P(SingleBodyBy, BounceHasItsRestitution) {
  for (double e : {0.3, 0.8}) {
    RigidPlane::Parameters plane;
    plane.stiffness = 1e6;
    plane.friction = 0.0;
    const double radius = 0.1, v = 2.0;
    plane.damping = contact_damping_for_restitution(e, v);
    BodyState state;
    state.r = {0.0, 0.0, radius + 1e-3};
    state.dr = {0.0, 0.0, -v};
    Ball ball(plane, radius, state, Eigen::Vector3d::Zero());
    test::Run run(ball.model, GetParam(), test::tight(1e-9));
    run.to(0.05, 10);
    EXPECT_GT(run.body(ball.body).r.z(), radius);
    EXPECT_NEAR(run.body(ball.body).dr.z(), e * v, 1e-5 * v) << e;
    EXPECT_NEAR(run.state.dissipated[Dissipation::kContact], 0.5 * 2.0 * v * v * (1.0 - e * e), 1e-4) << e;
  }
}

TEST_P(SingleBodyBy, SlidingBallEndsUpRollingAtFiveSevenths) {
  // Friction at the lowest point: m v changes by its impulse, J w by its moment; rolling without slip leaves
  // 5/7 of the speed.
  RigidPlane::Parameters plane;
  plane.stiffness = 1e6;
  plane.damping = 0.5;
  plane.friction = 0.5;
  plane.slip_speed = 1e-4;
  const double radius = 0.1, g = 9.81, v = 1.0;
  BodyState state;
  state.r = {0.0, 0.0, radius - std::pow(2.0 * g / plane.stiffness, 2.0 / 3.0)};  // resting overlap
  state.dr = {v, 0.0, 0.0};
  Ball ball(plane, radius, state, {0.0, 0.0, -g});
  test::Run run(ball.model, GetParam(), test::tight(1e-7));
  run.to(0.3, 10);  // slips for 2/7 v / (mu g) = 0.06 s
  EXPECT_NEAR(run.body(ball.body).dr.x(), 5.0 / 7.0 * v, 1e-4 * v);
  EXPECT_NEAR(run.body(ball.body).w.y(), 5.0 / 7.0 * v / radius, 2e-4 * v / radius);
  EXPECT_NEAR(run.state.dissipated[Dissipation::kFriction], 0.5 * 2.0 * v * v * 2.0 / 7.0, 1e-3);
  EXPECT_LT(std::abs(run.imbalance()), 1e-5);
}

TEST_P(SingleBodyBy, PrescribedMotionDoesTheWorkItReports) {
  // A mass shaken along z, turned about z: kinetic energy comes from the drive alone.
  Model model({0.0, 0.0, -2.0});
  const int body = model.add_body(Body("plate", 3.0, Eigen::Vector3d(1.0, 1.0, 2.0).asDiagonal()), {});
  PrescribedMotion motion;
  motion.translation = {polynomial({0.0}), polynomial({0.0, 0.5}), ramp(0.0, 0.4, 0.0, 1.0)};
  motion.rotation = ramp(0.0, 7.0, 0.0, 0.8);  // more than one turn
  motion.hold_other_rotations = true;
  model.add_joint(prescribed_joint("drive", ground_marker(Eigen::Vector3d::Zero()),
                                   body_marker(body, model.body(body), Eigen::Vector3d::Zero()), motion));
  test::Run run(model, GetParam(), test::tight(1e-8));
  run.to(0.6, 7);
  const BodyKinematics now = run.body(body);
  const TimeValue height = motion.translation[2]->at(0.6), angle = motion.rotation->at(0.6);
  // Position constraints: projected after every step, with IDA where a drift of 1e-9 is passed (5e-9 of a speed).
  const bool always = std::string(GetParam()) == "one_step";
  const double place = always ? 1e-12 : 1e-9, speed = always ? 1e-11 : 5e-9;
  EXPECT_NEAR(now.r.z(), height.value, place);
  EXPECT_NEAR(now.dr.z(), height.rate, speed);
  EXPECT_NEAR(now.r.y(), 0.3, place);
  EXPECT_NEAR(std::atan2(now.A(1, 0), now.A(0, 0)), std::remainder(angle.value, 2.0 * kPi), place);
  EXPECT_NEAR(now.w.z(), angle.rate, speed);
  EXPECT_GT(run.state.supplied[Supply::kMotion], 1.0);
  EXPECT_LT(std::abs(run.imbalance()), 1e-5 * run.state.supplied[Supply::kMotion]);
}

TEST_P(SingleBodyBy, ConstantLoadDoesForceTimesWay) {
  Model model;
  const int body = model.add_body(Body("body", 2.0, Eigen::Vector3d(1.0, 2.0, 2.5).asDiagonal()), {});
  test::Run run(model, GetParam(), test::tight(1e-8));
  run.inputs.loads.resize(1);
  run.inputs.loads[0].F_W = {1.0, -2.0, 0.5};
  run.inputs.loads[0].T_B = {0.0, 0.0, 0.7};  // about a principal axis: w = T t / J
  run.to(1.5, 4);
  // quadratic in t: exact for both
  EXPECT_LT((run.body(body).r - 0.5 * 1.5 * 1.5 * run.inputs.loads[0].F_W / 2.0).norm(), 1e-8);
  EXPECT_NEAR(run.body(body).w.z(), 0.7 * 1.5 / 2.5, 1e-8);
  const double expected = run.inputs.loads[0].F_W.dot(run.body(body).r) + 0.5 * 2.5 * run.body(body).w.squaredNorm();
  EXPECT_NEAR(run.state.load_work[0], expected, 1e-7);
}

}  // namespace mechanisms
}  // namespace footfall
