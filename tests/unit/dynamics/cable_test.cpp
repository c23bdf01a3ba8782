// Cables over pulleys: derivatives and energy on many bodies; pulleys, drums, hoisting, slack and snap against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "coupler/base/errors.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/control/continuous_signals.h"
#include "mbd_solver/model/elements/cable.h"
#include "mbd_solver/model/elements/forces.h"
#include "mbd_solver/model/elements/joint.h"
#include "tests/support/refused.h"
#include "tests/unit/dynamics/jacobian_check.h"
#include "tests/unit/dynamics/random_model.h"
#include "tests/unit/dynamics/run.h"

namespace footfall {
namespace {

constexpr double kEarthGravity = 9.81;  // [m/s2]
const Eigen::Vector3d kEarthsPull(0.0, 0.0, -kEarthGravity);

CableGuide cable_point(const Model& model, int body, const Eigen::Vector3d& p_W) {
  return {model.marker_at(body, p_W), 0.0, 0.0};
}
// from: direction from which its angle counts. angle: at the start [rad].
CableGuide cable_round(const Model& model, int body, const Eigen::Vector3d& c_W, const Eigen::Vector3d& axis,
                       double radius, const Eigen::Vector3d& from, double angle = 0.0) {
  return {model.marker_at(body, c_W, axes_with_z(axis, from)), radius, angle};
}

CableParameters cable_of(double stiffness, double length, double damping = 0.0) {
  CableParameters p;
  p.stiffness = stiffness;
  p.length = length;
  p.damping = damping;
  return p;
}

int add_mass(Model& model, const std::string& name, double mass, const Eigen::Vector3d& r,
             const Eigen::Vector3d& dr = Eigen::Vector3d::Zero(), double inertia = 0.01) {
  BodyState state;
  state.r = r;
  state.dr = dr;
  return model.add_body(Body(name, mass, inertia * Eigen::Matrix3d::Identity()), state);
}

// From a drum over a pulley and an eyelet to a drum, each on another body, two of them flexible. The axes are oblique, so that
// spans leave the planes of their rounds. lifted: the pulley is out of the way.
std::unique_ptr<Cable> oblique_cable(const Model& model, const CableParameters& parameters, bool lifted) {
  const auto tilted = [](double x, double y, double z) { return Eigen::Vector3d(x, y, z).normalized(); };
  std::vector<CableGuide> guides = {
      cable_round(model, 0, {0.0, 0.0, 0.0}, tilted(0.1, -0.05, 1.0), 0.2, {0.3, 1.0, 0.0}, 0.4),
      cable_round(model, 1, {2.0, lifted ? 1.9 : -0.4, 0.1}, tilted(-0.05, 0.1, 1.0), 0.3, {1.0, 0.2, 0.0}, 0.1),
      cable_point(model, 2, {3.0, 1.5, 0.2}),
      cable_round(model, 3, {1.5, 3.0, -0.1}, tilted(0.02, 0.08, -1.0), 0.25, {1.0, 0.5, 0.1}, 0.2)};
  return std::make_unique<Cable>("cable", std::move(guides), parameters);
}

class ObliqueCable : public ::testing::TestWithParam<std::pair<bool, bool>> {
 protected:
  ObliqueCable() : random_(31), model_(test::random_bodies(random_)) {
    CableParameters parameters = cable_of(GetParam().second ? 0.0 : 40.0, GetParam().first ? 3.0 : 5.0, 3.0);
    if (GetParam().second) parameters.axial_stiffness = 150.0;
    cable_ = model_.add_force(oblique_cable(model_, parameters, GetParam().first));
  }
  test::Random random_;
  Model model_;
  Handle<Cable> cable_;
};

TEST_P(ObliqueCable, HasTheDerivativesOfItsForces) {
  const Assembly assembly = test::as_given(model_);
  Equations equations(model_, assembly);
  Eigen::VectorXd y(equations.layout().size());
  equations.layout().pack(assembly.state, Eigen::VectorXd(), y);
  const Eigen::VectorXd ydot = random_.vector_x(y.size());
  Inputs inputs;
  inputs.values = Eigen::Vector2d(0.3, 0.8);
  equations.load(assembly.state);
  EXPECT_GT(cable_.of(model_).sample(equations.element_input(0, assembly.state, inputs)).force, 1.0);
  std::string where;
  EXPECT_LT(test::jacobian_error(equations, y, ydot, 20.0, inputs, &where), 1e-8) << where;  // error of the differences
}

// Each number of the cable pushes a body, through a signal.
TEST_P(ObliqueCable, IsReadByContinuousSignalsWithTheirDerivatives) {
  std::vector<SignalNode> nodes;
  for (const auto& entry : kCableEntries) {
    const int k = static_cast<int>(nodes.size());
    SignalNode node;
    node.name = "s" + std::to_string(k);
    node.block = std::make_unique<Saturation>(-1e6, 1e6);
    node.inputs = {"0.1 * n" + std::to_string(k) + ".x"};
    node.place = k;
    nodes.push_back(std::move(node));
    model_.add_force(std::make_unique<AppliedForce>("f" + std::to_string(k), model_.marker_at(k, model_.initial(k).r),
                                                    Eigen::Vector3d(0.0, 0.6, 0.8), Magnitude(nullptr, k),
                                                    Magnitude()));
    (void)entry;
  }
  SignalChain chain(std::move(nodes));
  std::vector<SignalSource> sources;
  std::vector<std::unique_ptr<Sensor>> sensors;
  for (const std::string& name : chain.names()) {
    sources.push_back({SignalSource::Kind::kSensor, sensors.size()});
    sensors.push_back(std::make_unique<CableSensor>(cable_.of(model_), 0,
                                                    kCableEntries[static_cast<std::size_t>(name[1] - '0')].value));
  }
  model_.set_signals(
      std::make_shared<const ContinuousSignals>(std::move(chain), std::move(sources), std::move(sensors)));
  const Assembly assembly = test::as_given(model_);
  Equations equations(model_, assembly);
  Eigen::VectorXd y(equations.layout().size());
  equations.layout().pack(assembly.state, Eigen::VectorXd(), y);
  const Eigen::VectorXd ydot = random_.vector_x(y.size());
  Inputs inputs;
  inputs.values = Eigen::VectorXd::Zero(4);
  Eigen::VectorXd values;
  equations.signals(assembly.state, inputs, values);
  equations.load(assembly.state);
  const CableSample sample = cable_.of(model_).sample(equations.element_input(0, assembly.state, inputs));
  EXPECT_NEAR(values[1], 0.1 * sample.force, 1e-13 * sample.force);
  EXPECT_GT(values[1], 0.1);
  EXPECT_NEAR(values[3], 0.1 * (sample.length - sample.stretch), 1e-13);
  std::string where;
  // Signals are differentiated with steps of 1e-6 of the forces, whose second derivatives are like the first.
  EXPECT_LT(test::jacobian_error(equations, y, ydot, 20.0, inputs, &where), 1e-8) << where;
}

TEST_P(ObliqueCable, StoresOrDissipatesWhatItTakes) {
  const Layout layout(model_);
  State state = test::as_given(model_).state;
  Kinematics kinematics(model_);
  const ForceElement& element = model_.force(0);
  const Eigen::VectorXd inputs = Eigen::Vector2d::Zero();
  const auto input_at = [&](const State& at) {
    kinematics.load(layout, at.q, at.v, Eigen::VectorXd());
    return element_input(element, kinematics, at.z, inputs, 0.0, nullptr);
  };
  const ElementInput in = input_at(state);
  Eigen::VectorXd Q = Eigen::VectorXd::Zero(in.size()), dz(element.state_count());
  element.add_force(in, Q, dz);
  StoredEnergy stored;
  Dissipated power;
  element.add_energy(in, stored, power);
  EXPECT_GE(power.total(), 0.0);
  const double taken = -Q.dot(state.v);  // its bodies are all of the model, in order
  double at[2];
  const double dt = 1e-6;
  for (const int side : {0, 1}) {
    State moved = state;
    add_increment(layout, (side == 0 ? -dt : dt) * state.v, moved.q);
    StoredEnergy energy;
    element.add_energy(input_at(moved), energy, power);
    at[side] = energy.total();
  }
  power = {};
  element.add_energy(input_at(state), stored, power);
  EXPECT_NEAR(taken, (at[1] - at[0]) / (2.0 * dt) + power.total(), 1e-7 * std::abs(taken));  // error of the difference
  // The sums of all forces and of their moments are zero.
  Eigen::Vector3d F = Eigen::Vector3d::Zero(), T = F;
  for (int i = 0; i < model_.body_count(); ++i) {
    const int v = layout.body_v[static_cast<std::size_t>(i)];
    F += Q.segment<3>(v);
    T += Q.segment<3>(v + 3) + kinematics.of(i).r.cross(Q.segment<3>(v));
  }
  EXPECT_LT(F.norm(), 1e-12 * Q.norm());
  EXPECT_LT(T.norm(), 1e-11 * Q.norm());
}

INSTANTIATE_TEST_SUITE_P(OfBothStiffnesses, ObliqueCable,
                         ::testing::Values(std::make_pair(false, false), std::make_pair(false, true),
                                           std::make_pair(true, false)));

// Atwood's machine. The pulley turns with the cable: it divides it, and each part has the tension of the closed form
//   a = (m_1 - m_2) g / (m_1 + m_2 + J / R^2),   T_1 = m_1 (g - a),   T_2 = m_2 (g + a)
// With these tensions at the start nothing oscillates.
TEST(Atwood, WithAHeavyPulleyHasTheAccelerationOfTheClosedForm) {
  const double m_1 = 3.0, m_2 = 2.0, J = 0.02, R = 0.1, k = 2e4;
  const double a = (m_1 - m_2) * kEarthGravity / (m_1 + m_2 + J / (R * R)), T_1 = m_1 * (kEarthGravity - a),
               T_2 = m_2 * (kEarthGravity + a);
  Model model(kEarthsPull);
  const int pulley = add_mass(model, "pulley", 4.0, {0.0, 0.0, 3.0}, Eigen::Vector3d::Zero(), J);
  const int first = add_mass(model, "first", m_1, {R, 0.0, 1.0}),
            second = add_mass(model, "second", m_2, {-R, 0.0, 1.5});
  const Eigen::Matrix3d along_y = axes_with_z(Eigen::Vector3d::UnitY());
  model.add_joint(revolute_joint("axle", model.marker_at(kGround, {0.0, 0.0, 3.0}, along_y),
                                 model.marker_at(pulley, {0.0, 0.0, 3.0}, along_y)));
  // Over the top from the second, at -R, to the first, at R: about +y by the right hand.
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY(), x = Eigen::Vector3d::UnitX();
  const Handle<Cable> rising = model.add_force(
      std::make_unique<Cable>("rising",
                              std::vector<CableGuide>{cable_point(model, second, {-R, 0.0, 1.5}),
                                                      cable_round(model, pulley, {0.0, 0.0, 3.0}, y, R, -x)},
                              cable_of(k, 1.5 - T_2 / k)));
  const Handle<Cable> falling = model.add_force(
      std::make_unique<Cable>("falling",
                              std::vector<CableGuide>{cable_round(model, pulley, {0.0, 0.0, 3.0}, y, R, x),
                                                      cable_point(model, first, {R, 0.0, 1.0})},
                              cable_of(k, 2.0 - T_1 / k)));
  test::Run run(model, "one_step", test::precise(1e-9));
  run.to(0.8, 4);
  const double fallen = 0.5 * a * 0.8 * 0.8;
  EXPECT_NEAR(run.state.q[9], 1.0 - fallen, 1e-7);  // tolerance of the integrator, through a spring of 20 kN/m
  EXPECT_NEAR(run.state.q[16], 1.5 + fallen, 1e-7);
  EXPECT_NEAR(run.state.v[4], a * 0.8 / R, 1e-6);
  EXPECT_NEAR(sample_of(run, rising).force, T_2, 1e-3);  // 5e-8 m of the spring
  EXPECT_NEAR(sample_of(run, falling).force, T_1, 1e-3);
}

// Without friction the tension is the same on both sides of a pulley, whatever the wrap, and so is what the pulley bears:
// T (e_out - e_in) through its axis, without a moment about it.
TEST(Capstan, WithoutFrictionBearsTheDifferenceOfTwoEqualTensions) {
  for (const double turns : {0.0, 3.0}) {
    Model model;
    const int pulley = add_mass(model, "pulley", 1.0, {0.0, 0.0, 0.0});
    const int load = add_mass(model, "load", 1.0, {0.2, 0.0, -1.0});
    // From a point of the ground at the left, over the top, down to the load: a wrap of a quarter.
    const double R = 0.2, wrap = 0.5 * kPi + 2.0 * kPi * turns, k = 1000.0, stretch = 0.05;
    const double way = 1.0 + 1.0 + R * wrap;
    const Handle<Cable> cable = model.add_force(std::make_unique<Cable>(
        "cable",
        std::vector<CableGuide>{
            cable_point(model, kGround, {-1.0, 0.0, R}),
            cable_round(model, pulley, {0.0, 0.0, 0.0}, Eigen::Vector3d::UnitY(), R, Eigen::Vector3d::UnitZ(), wrap),
            cable_point(model, load, {R, 0.0, -1.0})},
        cable_of(k, way - stretch)));
    const Layout layout(model);
    const State state = test::as_given(model).state;
    Kinematics kinematics(model);
    kinematics.load(layout, state.q, state.v, Eigen::VectorXd());
    const ElementInput in = element_input(model.force(0), kinematics, state.z, Eigen::VectorXd(), 0.0, nullptr);
    Eigen::VectorXd Q = Eigen::VectorXd::Zero(12), dz(1);
    model.force(0).add_force(in, Q, dz);
    const double T = k * stretch;
    Eigen::VectorXd expected = Eigen::VectorXd::Zero(12);
    expected.head<3>() << -T, 0.0, -T;
    expected.segment<3>(6) << 0.0, 0.0, T;
    EXPECT_LT((Q - expected).norm(), 1e-10 * T) << turns;
    EXPECT_NEAR(cable.of(model).sample(in).length, way, 1e-13);
  }
}

// The load of a winch swings while it is hoisted. The drum (radius R at the origin) takes up the cable at the rate R w; the
// load is a mass point in the plane, integrated here by Runge and Kutta's method with fine steps:
//   f = sqrt(r^2 - R^2),   theta = phi - acos(R / r) of the tangent point,   e = f + R (theta - theta_0 + w t) - s_0
double fine_stretch(const std::array<double, 4>& y, double t, double R, double w, double s_0, Eigen::Vector2d* pull) {
  const double r2 = y[0] * y[0] + y[1] * y[1], f = std::sqrt(r2 - R * R);
  // About the axis +y by the right hand from z to x: the load at the angle phi from +x downwards.
  const double phi = std::atan2(-y[1], y[0]), theta = phi - std::acos(R / std::sqrt(r2));
  const Eigen::Vector2d tangent(R * std::cos(theta), -R * std::sin(theta));
  *pull = (tangent - Eigen::Vector2d(y[0], y[1])) / f;
  return f + R * (theta + w * t) - s_0;
}

TEST(Hoist, OfASwingingLoadIsThatOfItsTwoEquations) {
  const double R = 0.1, w = 3.0, m = 2.0, k = 5e3, c = 40.0, s_0 = 2.0, swing = 0.4;  // 0.3 m/s
  // At the start the cable hangs from (R, 0), turned by the angle of the swing about it.
  const Eigen::Vector2d start(R + s_0 * std::sin(swing) * 1.0, -s_0 * std::cos(swing));
  Model model(kEarthsPull);
  const int drum = add_mass(model, "drum", 1.0, {0.0, 0.0, 0.0}, Eigen::Vector3d::Zero(), 1e9);
  const int load = add_mass(model, "load", m, {start.x(), 0.0, start.y()});
  const Eigen::Matrix3d along_y = axes_with_z(Eigen::Vector3d::UnitY());
  model.add_joint(revolute_joint("axle", model.marker_at(kGround, {0.0, 0.0, 0.0}, along_y),
                                 model.marker_at(drum, {0.0, 0.0, 0.0}, along_y)));
  // theta counts from +x; at the start it is the tangent's angle.
  Eigen::Vector2d pull;
  std::array<double, 4> y = {start.x(), start.y(), 0.0, 0.0};
  const double e_start = fine_stretch(y, 0.0, R, w, 0.0, &pull);
  const double length = e_start - 0.001;
  const Handle<Cable> cable = model.add_force(std::make_unique<Cable>(
      "cable",
      std::vector<CableGuide>{
          cable_round(model, drum, {0.0, 0.0, 0.0}, Eigen::Vector3d::UnitY(), R, Eigen::Vector3d::UnitX()),
          cable_point(model, load, {start.x(), 0.0, start.y()})},
      cable_of(k, length, c)));
  test::Run run(model, "one_step", test::precise(1e-9));
  run.state.v[4] = -w;  // so heavy a drum keeps its speed
  const double t_end = 3.0;
  run.to(t_end, 3);

  const auto rate = [&](double t, const std::array<double, 4>& at) {
    Eigen::Vector2d e;
    const double stretch = fine_stretch(at, t, R, w, length, &e);
    const double speed = -e.dot(Eigen::Vector2d(at[2], at[3])) + R * w;  // of the stretch
    const double toe = 1e-4 * length;
    const double F = stretch > 0.0 ? std::max(0.0, k * stretch + c * speed * std::min(1.0, stretch / toe)) : 0.0;
    return std::array<double, 4>{at[2], at[3], F * e.x() / m, F * e.y() / m - kEarthGravity};
  };
  const int steps = 60000;
  const double h = t_end / steps;
  for (int i = 0; i < steps; ++i) {
    const double t = i * h;
    const auto moved = [&](const std::array<double, 4>& by, double f) {
      std::array<double, 4> out = y;
      for (std::size_t n = 0; n < 4; ++n) out[n] += f * by[n];
      return out;
    };
    const auto k1 = rate(t, y), k2 = rate(t + 0.5 * h, moved(k1, 0.5 * h)), k3 = rate(t + 0.5 * h, moved(k2, 0.5 * h)),
               k4 = rate(t + h, moved(k3, h));
    for (std::size_t n = 0; n < 4; ++n) y[n] += h / 6.0 * (k1[n] + 2.0 * k2[n] + 2.0 * k3[n] + k4[n]);
  }
  EXPECT_NEAR(run.state.q[7], y[0], 1e-6);  // both to their tolerances
  EXPECT_NEAR(run.state.q[9], y[1], 1e-6);
  EXPECT_NEAR(run.state.v[6], y[2], 1e-5);
  EXPECT_NEAR(run.state.v[8], y[3], 1e-5);
  // The load has come closer by the cable that the drum has taken up, three quarters of a turn more than one.
  EXPECT_LT(sample_of(run, cable).length, length - 0.8 * R * w * t_end);
}

// A mass falls by h into its cable: 1/2 k e^2 = m g (h + e) at the largest stretch. It flies up again and again, and never
// higher than it was.
TEST(SlackCable, SnapsWithoutGainingEnergy) {
  const double m = 2.0, k = 3000.0, h = 0.5, length = 1.0;
  for (const double c : {0.0, 15.0, 2000.0}) {
    Model model(kEarthsPull);
    const int mass = add_mass(model, "mass", m, {0.0, 0.0, -length + h});
    const Handle<Cable> cable = model.add_force(
        std::make_unique<Cable>("rope",
                                std::vector<CableGuide>{cable_point(model, kGround, {0.0, 0.0, 0.0}),
                                                        cable_point(model, mass, {0.0, 0.0, -length + h})},
                                cable_of(k, length, c)));
    test::Run run(model, "one_step", test::precise(1e-8));
    double largest = 0.0, energy = run.energy().stored.total();
    const double start = energy;
    int flights = 0;
    bool flying = true;
    for (int i = 1; i <= 1200; ++i) {
      run.to(1e-3 * i);
      const CableSample sample = sample_of(run, cable);
      EXPECT_GE(sample.force, 0.0);
      EXPECT_TRUE(sample.stretch > 0.0 || sample.force == 0.0);
      if (flying && sample.stretch > 0.0) ++flights;
      flying = !(sample.stretch > 0.0);
      largest = std::max(largest, sample.force);
      const double now = run.energy().stored.total();
      EXPECT_LT(now, energy + 1e-5 * m * kEarthGravity * h) << c << ' ' << i;  // tolerance of the integrator
      energy = now;
    }
    EXPECT_NEAR(run.imbalance(), 0.0, 1e-4 * m * kEarthGravity * h) << c;
    if (c > 0.0) continue;
    EXPECT_GE(flights, 2);
    EXPECT_NEAR(energy, start, 1e-5 * m * kEarthGravity * h);
    const double weight = m * kEarthGravity, peak = weight + std::sqrt(weight * weight + 2.0 * k * weight * h);
    EXPECT_NEAR(largest, peak, 1e-3 * peak);  // the largest of samples every millisecond
  }
}

// A drum of 0.1 m takes up ten turns; what is left is counted, and with EA the cable becomes stiffer.
TEST(Drum, CountsItsTurns) {
  const double R = 0.1, EA = 5000.0, length = 8.0;
  Model model;
  const int drum = add_mass(model, "drum", 1.0, {0.0, 0.0, 0.0}, Eigen::Vector3d::Zero(), 1e9);
  const int load = add_mass(model, "load", 1.0, {R, 0.0, -length});
  const Eigen::Matrix3d along_y = axes_with_z(Eigen::Vector3d::UnitY());
  model.add_joint(revolute_joint("axle", model.marker_at(kGround, {0.0, 0.0, 0.0}, along_y),
                                 model.marker_at(drum, {0.0, 0.0, 0.0}, along_y)));
  model.add_joint(
      prismatic_joint("guide", model.marker_at(kGround, {R, 0.0, -length}), model.marker_at(load, {R, 0.0, -length})));
  CableParameters parameters;
  parameters.axial_stiffness = EA;
  parameters.length = length;
  parameters.damping = 2000.0;
  const Handle<Cable> cable = model.add_force(std::make_unique<Cable>(
      "cable",
      std::vector<CableGuide>{
          cable_round(model, drum, {0.0, 0.0, 0.0}, Eigen::Vector3d::UnitY(), R, Eigen::Vector3d::UnitX()),
          cable_point(model, load, {R, 0.0, -length})},
      parameters));
  test::Run run(model, "one_step", test::precise(1e-9));
  const double turns = 10.0, w = 2.0 * kPi;
  run.state.v[4] = -w;
  run.state.v[8] = R * w;  // the load moves with the cable
  run.to(turns, 10);
  const double left = length - R * w * turns;
  EXPECT_NEAR(sample_of(run, cable).length, left, 2e-5);  // it hangs in the cable with a force of some 1e-2 N
  EXPECT_NEAR(run.state.q[9], -left, 2e-5);
  // Pushed away by 1 mm it has the stiffness of what is left.
  run.state.q[9] = -left - 0.001;
  run.state.v.setZero();
  const CableSample sample = sample_of(run, cable);
  EXPECT_NEAR(sample.force, EA * sample.stretch / left, 1e-9 * sample.force);
  EXPECT_NEAR(sample.stretch, 0.001, 1e-6);
}

TEST(Pulley, ThatTheCableLeavesIsNotInItsWay) {
  for (const double height : {-0.5, -0.1, 0.0, 0.3}) {  // of the load; above the line the cable runs free
    Model model;
    const int load = add_mass(model, "load", 1.0, {1.0, 0.0, height});
    const Handle<Cable> cable = model.add_force(std::make_unique<Cable>(
        "cable",
        std::vector<CableGuide>{
            cable_point(model, kGround, {-1.0, 0.0, 0.1}),
            cable_round(model, kGround, {0.0, 0.0, 0.0}, Eigen::Vector3d::UnitY(), 0.1, Eigen::Vector3d::UnitZ()),
            cable_point(model, load, {1.0, 0.0, height})},
        cable_of(100.0, 1.9)));
    test::Run run(model);
    const CableSample sample = sample_of(run, cable);
    const double straight = std::hypot(2.0, height - 0.1);
    if (height >= 0.1) {
      EXPECT_NEAR(sample.length, straight, 1e-14);
    } else {
      const double r = std::hypot(1.0, height), span = std::sqrt(r * r - 0.01);
      const double wrap = 0.5 * kPi - std::acos(0.1 / r) - std::atan2(height, 1.0);
      EXPECT_NEAR(sample.length, 1.0 + span + 0.1 * wrap, 1e-14) << height;
      EXPECT_GT(sample.length, straight);
    }
    EXPECT_EQ(cable.of(model).points(run.equations.element_input(0, run.state, run.inputs)).size(),
              height >= 0.1 ? 2u : 4u);
  }
}

TEST(Cables, RefuseWhatIsNoWay) {
  Model model;
  const int load = add_mass(model, "load", 1.0, {0.05, 0.0, 0.0});
  const Cable cable(
      "rope",
      {cable_round(model, kGround, {0.0, 0.0, 0.0}, Eigen::Vector3d::UnitY(), 0.1, Eigen::Vector3d::UnitX()),
       cable_point(model, load, {0.05, 0.0, 0.0})},
      cable_of(1.0, 1.0));
  const Layout layout(model);
  const State state = test::as_given(model).state;
  Kinematics kinematics(model);
  kinematics.load(layout, state.q, state.v, Eigen::VectorXd());
  EXPECT_THROW(
      cable.sample(element_input(cable, kinematics, Eigen::VectorXd::Zero(1), Eigen::VectorXd(), 0.0, nullptr)),
      NumericalError);
}

}  // namespace
}  // namespace footfall
