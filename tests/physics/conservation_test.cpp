// Energy and momentum of free systems, rigid and flexible; flexible bodies against rigid ones.

#include <cmath>

#include "mbd_solver/model/laws/linear_spring_damper.h"
#include "tests/unit/dynamics/random_model.h"
#include "tests/unit/dynamics/run.h"

namespace footfall {
namespace {

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
    equations.pack(test::as_given(model).state, Eigen::VectorXd::LinSpaced(5, 1.0, 2.0), y);
    F[i].resize(y.size());
    equations.residual(0.0, y, ydot, {}, F[i]);
  }
  EXPECT_LT((F[1] - F[0]).norm(), 1e-13 * F[0].norm());
}

}  // namespace
}  // namespace footfall
