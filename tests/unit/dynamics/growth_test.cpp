// What a start and a Jacobian cost, in counts: entries of factors, derivatives and evaluations per body or signal do not grow
// with their number.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/dynamics/assembly.h"
#include "mbd_solver/dynamics/constraint_rows.h"
#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/model/control/continuous_signals.h"
#include "mbd_solver/model/elements/forces.h"
#include "mbd_solver/model/rotation.h"
#include "tests/unit/dynamics/jacobian_check.h"

namespace footfall {
namespace {

constexpr double kLinear = 1.2;  // growth per part that counts as none: borders of what is ordered and split

BodyState at(const Eigen::Vector3d& r) {
  BodyState state;
  state.r = r;
  return state;
}

Body lump(const std::string& name, double mass) { return Body(name, mass, 0.1 * mass * Eigen::Matrix3d::Identity()); }

// Horizontal direction of leg k of n, and the one across.
std::pair<Eigen::Vector3d, Eigen::Vector3d> directions(int k, int n) {
  const double angle = 2.0 * kPi * k / n;
  const Eigen::Vector3d out(std::cos(angle), std::sin(angle), 0.0);
  return {out, Eigen::Vector3d::UnitZ().cross(out)};
}

void hinge(Model& model, const std::string& name, int a, int b, const Eigen::Vector3d& point,
           const Eigen::Vector3d& axis) {
  model.add_joint(
      revolute_joint(name, model.marker_at(a, point, axes_with_z(axis)), model.marker_at(b, point, axes_with_z(axis))));
}

// A hub with n legs on hinges; off: how far each leg is drawn from its hinge.
Model hub(int n, double off = 0.0) {
  Model model;
  model.add_body(lump("hub", 50.0), {});
  for (int k = 0; k < n; ++k) {
    const auto [out, across] = directions(k, n);
    const Eigen::Vector3d gap = off * Eigen::Vector3d(std::sin(k), std::cos(2 * k), std::sin(3 * k));
    const int leg = model.add_body(lump("leg_" + std::to_string(k), 1.0 + 0.01 * k), at(1.5 * out + gap));
    model.add_joint(revolute_joint("hinge_" + std::to_string(k), model.marker_at(0, out, axes_with_z(across)),
                                   body_marker(leg, model.body(leg), -0.5 * out, axes_with_z(across))));
  }
  return model;
}

// Each leg is a planar parallelogram of four hinges: three of its conditions follow from the others.
Model hub_of_parallelograms(int n) {
  Model model;
  model.add_body(lump("hub", 50.0), {});
  const auto add = [&](const std::string& name, const Eigen::Vector3d& r) {
    return model.add_body(lump(name, 1.0), at(r));
  };
  const Eigen::Vector3d down(0.0, 0.0, -0.5);
  for (int k = 0; k < n; ++k) {
    const auto [out, across] = directions(k, n);
    const std::string number = std::to_string(k);
    const int upper = add("upper_" + number, 1.5 * out), lower = add("lower_" + number, 1.5 * out + down),
              foot = add("foot_" + number, 2.0 * out + 0.5 * down);
    hinge(model, "a_" + number, 0, upper, out, across);
    hinge(model, "b_" + number, 0, lower, out + down, across);
    hinge(model, "c_" + number, upper, foot, 2.0 * out, across);
    hinge(model, "d_" + number, lower, foot, 2.0 * out + down, across);
  }
  return model;
}

double entries_per_leg(const Model& model, int legs) {
  const Layout layout(model);
  ConstraintRows rows(model, layout);
  rows.evaluate(assemble(model).state);
  return static_cast<double>(rows.factor_entries(1e-8)) / legs;
}

TEST(Hub, HasAsManyEntriesPerLegWithManyLegsAsWithFew) {
  EXPECT_LT(entries_per_leg(hub(200), 200), kLinear * entries_per_leg(hub(40), 40));
  EXPECT_LT(entries_per_leg(hub_of_parallelograms(100), 100), kLinear * entries_per_leg(hub_of_parallelograms(25), 25));
}

// The hub is split from 33 joints on (split_bodies.h).
constexpr int kManyLegs = 60;

TEST(Hub, OfManyLegsClosesByTheSmallestMotion) {
  const Model model = hub(kManyLegs, 1e-4);
  const Assembly assembly = assemble(model);
  EXPECT_EQ(assembly.rank, 5 * kManyLegs);
  Equations equations(model, assembly);
  EXPECT_LT(equations.saddle().drift(assembly.state).position, 1e-12);
  // No force from outside: the common mass centre stays where it was drawn, to round-off.
  Eigen::Vector3d moved = Eigen::Vector3d::Zero();
  double mass = 0.0;
  for (int i = 0; i < model.body_count(); ++i) {
    mass += model.body(i).mass();
    moved += model.body(i).mass() * (assembly.state.q.segment<3>(7 * i) - model.initial(i).r);
  }
  EXPECT_LT(moved.norm() / mass, 1e-12);
}

// The smallest change of velocities, M dv = Phi_v^T lambda, is also what the projection of a run makes, by LU.
TEST(Hub, OfManyLegsGetsTheVelocitiesThatAProjectionGives) {
  Model model;
  const Model still = hub(kManyLegs);
  for (int i = 0; i < still.body_count(); ++i) {
    BodyState state = still.initial(i);
    state.dr = Eigen::Vector3d(std::sin(i), std::cos(3 * i), std::sin(5 * i));
    state.w = Eigen::Vector3d(std::cos(2 * i), std::sin(7 * i), std::cos(i));
    model.add_body(still.body(i), state);
  }
  for (int j = 0; j < still.joint_count(); ++j) model.add_joint(still.joint(j));
  const Assembly assembly = assemble(model);
  Equations equations(model, assembly);
  State given = assembly.state;
  for (int i = 0; i < model.body_count(); ++i) given.v.segment<6>(6 * i) << model.initial(i).dr, model.initial(i).w;
  equations.saddle().project(given);
  EXPECT_LT((given.v - assembly.state.v).lpNorm<Eigen::Infinity>(), 1e-9);  // speeds of 1 m/s, eps of the saddle 1e-12
}

TEST(Hub, OfManyLoopsHasTheRedundantConditionsOfEach) {
  const int n = 25;  // 50 joints on the hub
  const Model model = hub_of_parallelograms(n);
  const Assembly assembly = assemble(model);
  EXPECT_EQ(assembly.rank, (4 * 5 - 3) * n);
  ASSERT_EQ(assembly.redundant.size(), static_cast<std::size_t>(n));
  for (int k = 0; k < n; ++k) {
    const RedundantGroup& group = assembly.redundant[static_cast<std::size_t>(k)];
    EXPECT_EQ(group.joints, (std::vector<int>{4 * k, 4 * k + 1, 4 * k + 2, 4 * k + 3}));
    ASSERT_EQ(group.dropped.size(), 3u);
    for (const int row : group.dropped) {
      EXPECT_GE(row, 20 * k);
      EXPECT_LT(row, 20 * (k + 1));
    }
    EXPECT_LT((group.U.transpose() * group.U - Eigen::Matrix3d::Identity()).norm(), 1e-12);
  }
  // Without gravity and at rest nothing moves, whatever rests.
  Equations equations(model, assembly);
  Eigen::VectorXd rates(equations.layout().size());
  Inputs inputs;
  equations.saddle().accelerations(assembly.state, inputs, rates);
  EXPECT_LT(rates.lpNorm<Eigen::Infinity>(), 1e-9);
}

// --- Continuous signals.

// The height of n bodies, each through a filter of its own, pushes each of them; `one`: all of them push the first one.
struct Filtered {
  explicit Filtered(int n, bool chain = false) {
    std::vector<SignalNode> nodes;
    for (int k = 0; k < n; ++k) {
      const std::string number = std::to_string(k);
      model.add_body(lump("b" + number, 1.0), at({2.0 * k, 0.1 * k, 0.3}));
      SignalNode node;
      node.name = "s" + number;
      node.block = std::make_unique<LinearFilter>(LinearFilter::low_pass_2(3.0, 0.4, 0.0));
      node.inputs = {chain && k > 0 ? "signal.s" + std::to_string(k - 1) + " - b" + number + ".z"
                                    : "b" + number + ".z"};
      node.place = k;
      nodes.push_back(std::move(node));
    }
    SignalChain signals(std::move(nodes));
    std::vector<SignalSource> sources;
    std::vector<std::unique_ptr<Sensor>> sensors;
    for (const std::string& name : signals.names()) {
      sources.push_back({SignalSource::Kind::kSensor, sensors.size()});
      sensors.push_back(
          std::make_unique<BodySensor>(model.body_index(name.substr(0, name.find('.'))),
                                       [](const BodyKinematics& b) { return b.r.z() * b.r.z() + b.dr.x(); }));
    }
    model.set_signals(
        std::make_shared<const ContinuousSignals>(std::move(signals), std::move(sources), std::move(sensors)));
    for (int k = 0; k < n; ++k)
      model.add_force(std::make_unique<AppliedForce>("f" + std::to_string(k), model.marker_at(k, model.initial(k).r),
                                                     Eigen::Vector3d(0.0, 0.6, 0.8), Magnitude(nullptr, k),
                                                     Magnitude()));
    inputs.values = Eigen::VectorXd::Zero(n);
  }
  Model model;
  Inputs inputs;
};

Eigen::Index jacobian_entries(const Filtered& filtered) {
  const Assembly assembly = assemble(filtered.model);
  return Equations(filtered.model, assembly).jacobian().matrix().nonZeros();
}

TEST(ContinuousSignals, HaveDerivativesOfWhatTheyReadAlone) {
  // Parts that do not know of each other: as many entries each.
  EXPECT_EQ(jacobian_entries(Filtered(40)), 4 * jacobian_entries(Filtered(10)));
  // In a chain each depends on the one before.
  const Eigen::Index ten = jacobian_entries(Filtered(10, true)), twenty = jacobian_entries(Filtered(20, true));
  EXPECT_EQ(jacobian_entries(Filtered(30, true)) - twenty, twenty - ten);
}

TEST(ContinuousSignals, HaveTheDerivativesOfTheResidual) {
  for (const bool chain : {false, true}) {
    const Filtered filtered(4, chain);
    const Assembly assembly = assemble(filtered.model);
    Equations equations(filtered.model, assembly);
    Eigen::VectorXd y(equations.layout().size()), ydot = Eigen::VectorXd::Zero(y.size());
    equations.layout().pack(assembly.state, Eigen::VectorXd(), y);
    y.segment(equations.layout().v0(), equations.layout().v_size).setLinSpaced(-0.3, 0.4);
    y.segment(equations.layout().z0(), equations.layout().z_size).setLinSpaced(0.1, 0.7);
    std::string where;
    // Signals are differentiated with steps of 1e-6: errors of 1e-16 / 1e-6 times values of 1 to 400 (omega^2), against the
    // largest entry, 355.
    EXPECT_LT(test::jacobian_error(equations, y, ydot, 50.0, filtered.inputs, &where), 1e-8) << where;
  }
}

// Counts how often it is evaluated.
class CountingBlock final : public SignalBlock {
 public:
  explicit CountingBlock(long& count) : count_(count) {}
  int state_count() const override { return 1; }
  bool passes_through() const override { return false; }
  double value(const BlockValues&, const BlockValues& z) const override {
    ++count_;
    return z[0];
  }
  void rates(const BlockValues& u, const BlockValues& z, Eigen::Ref<Eigen::VectorXd> dz) const override {
    dz[0] = u[0] - z[0];
  }

 private:
  long& count_;
};

long evaluations_of_a_jacobian(int n) {
  static long count;
  Model model;
  model.add_body(lump("b", 1.0), {});
  std::vector<SignalNode> nodes;
  for (int k = 0; k < n; ++k) {
    SignalNode node;
    node.name = "s" + std::to_string(k);
    node.block = std::make_unique<CountingBlock>(count);
    node.inputs = {k > 0 ? "signal.s" + std::to_string(k - 1) : "time"};
    node.place = k;
    nodes.push_back(std::move(node));
  }
  model.set_signals(std::make_shared<const ContinuousSignals>(
      SignalChain(std::move(nodes)), std::vector<SignalSource>(1), std::vector<std::unique_ptr<Sensor>>()));
  const Assembly assembly = assemble(model);
  Equations equations(model, assembly);
  Eigen::VectorXd y(equations.layout().size());
  equations.layout().pack(assembly.state, Eigen::VectorXd(), y);
  Inputs inputs;
  inputs.values = Eigen::VectorXd::Zero(n);
  count = 0;
  equations.jacobian().evaluate(0.0, y, Eigen::VectorXd::Zero(y.size()), 1.0, inputs);
  return count;
}

TEST(ContinuousSignals, AreEvaluatedAsOftenEachForADerivative) {
  const long ten = evaluations_of_a_jacobian(10), twenty = evaluations_of_a_jacobian(20);
  EXPECT_GT(ten, 0);
  EXPECT_EQ(evaluations_of_a_jacobian(100) - twenty, 8 * (twenty - ten));
}

}  // namespace
}  // namespace footfall
