#include "tests/validation/famous_mechanisms.h"
#include "tests/support/fe_reference.h"

#include <algorithm>
#include <cmath>

#include "mbd_solver/fe/modal_basis.h"
#include "mbd_solver/model/elements/bushing.h"
#include "mbd_solver/model/elements/forces.h"
#include "mbd_solver/model/elements/strut.h"
#include "mbd_solver/model/laws/motor.h"
#include "mbd_solver/model/laws/springs.h"
#include "tests/physics/mechanisms.h"

namespace footfall::test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

std::unique_ptr<Strut> spring_damper(const std::string& name, const Marker& m1, const Marker& m2, double stiffness,
                                     double damping, double length) {
  std::vector<std::unique_ptr<StrutLaw>> laws;
  laws.push_back(std::make_unique<LinearSpringDamper>(LinearSpringDamperParameters{stiffness, damping, 0.0, 0.0}));
  return std::make_unique<Strut>(name, m1, m2, std::move(laws), length);
}

// A plane body: mass, moment of inertia about z, mass centre, angle.
int add_plate(Model& model, const std::string& name, double mass, double inertia, const Vector2d& centre,
              double angle) {
  BodyState state;
  state.r = {centre.x(), centre.y(), 0.0};
  state.L = quaternion_about(Vector3d::UnitZ(), angle);
  return model.add_body(Body(name, mass, inertia * Matrix3d::Identity()), state);
}

Vector3d in_space(const Vector2d& p) { return {p.x(), p.y(), 0.0}; }
Vector2d along(double angle) { return {std::cos(angle), std::sin(angle)}; }  // direction of an angle
Vector2d across(double angle) { return {std::sin(angle), -std::cos(angle)}; }

// beta, Theta, gamma, Phi, delta, Omega, epsilon [rad]
constexpr double kSqueezerStart[7] = {-0.0617138900142764496, 0.0,
                                      0.455279819163070380,   0.222668390165885885,
                                      0.487364979543842550,   -0.222668390165885885,
                                      1.23054744454982119};
constexpr double kSqueezerEnd[7] = {0.1581077119629904e2, -0.1575637105984298e2, 0.4082224013073101e-1,
                                    -0.5347301163226948,  0.5244099658805304,    0.5347301163226948,
                                    0.1048080741042263e1};

}  // namespace

Model squeezer() {
  const double beta = kSqueezerStart[0], Theta = kSqueezerStart[1], gamma = kSqueezerStart[2], Phi = kSqueezerStart[3],
               delta = kSqueezerStart[4], Omega = kSqueezerStart[5], epsilon = kSqueezerStart[6];
  const double d = 28e-3, da = 115e-4, e = 2e-2, ea = 1421e-5, rr = 7e-3, ra = 92e-5, sa = 1874e-5, sb = 1043e-5,
               sc = 18e-3, sd = 2e-2, ta = 2308e-5, tb = 916e-5, u = 4e-2, ua = 1228e-5, ub = 449e-5, zf = 2e-2,
               zt = 4e-2, fa = 1421e-5;
  const Vector2d A(-0.06934, -0.00227), B(-0.03635, 0.03273), C(0.014, 0.072), O(0.0, 0.0);
  const Vector2d P = rr * along(beta), F = P - d * along(beta + Theta), E = A + zt * along(delta),
                 H = A + u * across(epsilon);
  Model model;
  const int k1 = add_plate(model, "K1", 0.04325, 2.194e-6, ra * along(beta), beta);
  const int k2 = add_plate(model, "K2", 0.00365, 4.410e-7, P - da * along(beta + Theta), beta + Theta);
  const int k3 = add_plate(model, "K3", 0.02373, 5.255e-6, B + sa * across(gamma) + sb * along(gamma), gamma);
  const int k4 = add_plate(model, "K4", 0.00706, 5.667e-7, E + (e - ea) * across(Phi + delta), Phi + delta);
  const int k5 = add_plate(model, "K5", 0.07050, 1.169e-5, A + ta * along(delta) - tb * across(delta), delta);
  const int k6 = add_plate(model, "K6", 0.00706, 5.667e-7, H + (zf - fa) * along(Omega + epsilon), Omega + epsilon);
  const int k7 = add_plate(model, "K7", 0.05498, 1.912e-5, A + ua * across(epsilon) - ub * along(epsilon), epsilon);
  const auto add_hinge = [&](const std::string& name, int body_1, int body_2, const Vector2d& point) {
    model.add_joint(hinge(model, name, body_1, body_2, in_space(point)));
  };
  add_hinge("O", kGround, k1, O);
  add_hinge("P", k1, k2, P);
  add_hinge("F3", k2, k3, F);
  add_hinge("F4", k2, k4, F);
  add_hinge("F6", k2, k6, F);
  add_hinge("B", kGround, k3, B);
  add_hinge("E", k4, k5, E);
  add_hinge("A5", kGround, k5, A);
  add_hinge("H", k6, k7, H);
  add_hinge("A7", kGround, k7, A);
  const Vector2d D = B + sd * along(gamma) + sc * across(gamma);
  model.add_force(spring_damper("spring", model.marker_at(kGround, in_space(C)), model.marker_at(k3, in_space(D)),
                                4530.0, 0.0, 0.07785));
  MotorParameters motor;
  motor.command = polynomial({0.033});
  std::vector<std::unique_ptr<StrutLaw>> laws;
  laws.push_back(std::make_unique<Motor>(motor));
  model.add_force(
      std::make_unique<JointForce>("motor", model.joint(0).m1, model.joint(0).m2, Coordinate::kAngle, std::move(laws)));
  return model;
}

double squeezer_error(Run& run) {
  const double* y = kSqueezerEnd;
  // Angles of K1 to K7 in W.
  const double exact[7] = {y[0], y[0] + y[1], y[2], y[3] + y[4], y[4], y[5] + y[6], y[6]};
  double worst = 0.0;
  for (int i = 0; i < 7; ++i) {
    const BodyKinematics b = run.body(i);
    const double angle = std::atan2(b.A(1, 0), b.A(0, 0));
    worst = std::max(worst, std::abs(std::remainder(angle - exact[i], 2.0 * M_PI)));
  }
  return worst / std::abs(y[0]);
}

Model flyball_governor() {
  const double length = 1.0, width = 0.01, x_AB = 0.1, beta = M_PI / 6.0, spin = 0.16 * 2.0 * M_PI;
  const double rod_mass = 0.3, ball = 5.0, mass = rod_mass + ball, com = ball * 0.5 * length / mass;  // from the middle
  Model model({0.0, 0.0, -9.81});
  const Vector3d w(0.0, 0.0, spin);
  const auto add = [&](const std::string& name, double m, const Matrix3d& inertia, const Vector3d& r, double about_y) {
    BodyState state;
    state.r = r;
    state.L = quaternion_about(Vector3d::UnitY(), about_y);
    state.w = w;
    state.dr = w.cross(r);
    return model.add_body(Body(name, m, inertia), state);
  };
  const int shaft = add("shaft", 0.3, box_properties({width, width, 1.0}, 3000.0).inertia, {0.0, 0.0, 0.5}, 0.0);
  const int slider = add("slider", 3.0, box_properties({0.1, 0.1, 0.1}, 3000.0).inertia, {0.0, 0.0, 0.5}, 0.0);
  // Rod along x with a point mass at one end.
  Matrix3d rod = box_properties({length, width, width}, 3000.0).inertia;
  const double steiner = rod_mass * com * com + ball * std::pow(0.5 * length - com, 2);
  rod(1, 1) += steiner;
  rod(2, 2) += steiner;
  int rods[2];
  for (int i = 0; i < 2; ++i) {
    const double side = i == 0 ? 1.0 : -1.0, reach = 0.5 * length + com;
    rods[i] = add(i == 0 ? "rod AC" : "rod BD", mass, rod,
                  {side * (0.5 * x_AB + reach * std::cos(beta)), 0.0, 1.0 - reach * std::sin(beta)}, side * beta);
  }
  // Everything hangs on bushings: stiffness and damping along and about x, y, z of the first body.
  const double k = 2e4, k_turn = 1e3;
  const auto bush = [&](const std::string& name, int body_1, int body_2, const Vector3d& point, const Vector3d& line,
                        const Vector3d& turn, double damped) {
    Bushing::Parameters bushing;
    bushing.stiffness = k * line;
    bushing.rotational_stiffness = k_turn * turn;
    bushing.damping = 0.05 * damped * bushing.stiffness;
    bushing.rotational_damping = 0.05 * damped * bushing.rotational_stiffness;
    model.add_force(
        std::make_unique<Bushing>(name, model.marker_at(body_1, point), model.marker_at(body_2, point), bushing));
  };
  bush("foot", kGround, shaft, Vector3d::Zero(), {1, 1, 1}, {1, 1, 0}, 1.0);
  bush("guide", shaft, slider, {0.0, 0.0, 0.5}, {1, 1, 0}, {1, 1, 1}, 0.0);
  for (int i = 0; i < 2; ++i) {
    const double side = i == 0 ? 1.0 : -1.0;
    const Vector3d top(side * 0.5 * x_AB, 0.0, 1.0);
    const Vector3d middle = top + 0.5 * length * Vector3d(side * std::cos(beta), 0.0, -std::sin(beta));
    bush(i == 0 ? "A" : "B", shaft, rods[i], top, {1, 1, 1}, {1, 0, 1}, 0.0);
    model.add_force(spring_damper(i == 0 ? "E" : "F", model.marker_at(slider, {side * 0.05, 0.0, 0.5}),
                                  model.marker_at(rods[i], middle), 4000.0, 200.0, 0.5));
  }
  return model;
}

FlippingBody flipping_body() {
  const double J[3] = {1.0, 2.0, 3.0};
  const Vector3d w(0.01, 5.0, 0.01);
  FlippingBody out;
  BodyState state;
  state.w = w;
  out.model.add_body(Body("wing nut", 1.0, Vector3d(J[0], J[1], J[2]).asDiagonal()), state);
  double energy = 0.0, momentum = 0.0;  // 2 E, L^2
  for (int i = 0; i < 3; ++i) {
    energy += J[i] * w[i] * w[i];
    momentum += J[i] * J[i] * w[i] * w[i];
  }
  // Landau and Lifshitz, Mechanics, 37: T = 4 K(k) sqrt(J1 J2 J3 / ((J3 - J2) (L^2 - 2 E J1))) for L^2 > 2 E J2, else
  // with J1 and J3 exchanged.
  const bool high = momentum > energy * J[1];
  const double J1 = high ? J[0] : J[2], J2 = J[1], J3 = high ? J[2] : J[0];
  const double k2 = (J2 - J1) * (energy * J3 - momentum) / ((J3 - J2) * (momentum - energy * J1));
  out.period =
      4.0 * std::comp_ellint_1(std::sqrt(k2)) * std::sqrt(J1 * J2 * J3 / ((J3 - J2) * (momentum - energy * J1)));
  return out;
}

namespace {

constexpr double kBeam = 10.0;  // [m]

// theta = (6 / 15) (t^2 / 2 + (15 / 2 pi)^2 (cos(2 pi t / 15) - 1)) until 15 s, then 6 rad/s.
class SpinUp : public TimeFunction {
 public:
  TimeValue at(double t) const override {
    const double T = 15.0, w = 6.0, a = 2.0 * M_PI / T;
    if (t >= T) return {w * t - 0.5 * w * T, w, 0.0};
    return {w / T * (0.5 * t * t + (std::cos(a * t) - 1.0) / (a * a)), w / T * (t - std::sin(a * t) / a),
            w / T * (1.0 - std::cos(a * t))};
  }
};

std::shared_ptr<const ModalBody> reduced(const FeModel& model, const std::vector<int>& held, int modes, double damping,
                                         const std::string& name) {
  BasisOptions options;
  options.mode_count = modes;
  options.damping_ratio = {damping};
  options.interface_nodes = held;
  return std::make_shared<const ModalBody>(reduce(model, options, name).body);
}

}  // namespace

Model spin_up_beam(int parts) {
  // E A = 2.8e7 N, E I = 1.4e4 N m2, rho A = 1.2 kg/m.
  const Material material{3000.0, 7e10, 0.3};
  const BeamSection section = general_section(4e-4, 2e-7, 2e-7, 4e-7, 0.03);
  const int elements = 2;
  Model model;
  for (int i = 0; i < parts; ++i) {
    const double from = kBeam * i / parts, to = kBeam * (i + 1) / parts;
    const std::string name = "part_" + std::to_string(i + 1);
    BodyState state;
    state.r = {0.5 * (from + to), 0.0, 0.0};
    model.add_body(Body(name, reduced(test::straight_beam({from, 0, 0}, {to, 0, 0}, elements, section, material),
                                      {0, elements}, 1, 0.05, name)),
                   state);
  }
  PrescribedMotion motion;
  for (TimeFunctionPtr& component : motion.translation) component = polynomial({0.0});
  motion.rotation = std::make_shared<SpinUp>();
  motion.hold_other_rotations = true;
  const auto node = [&](int body, int at) { return node_marker(body, model.body(body), at); };
  model.add_joint(prescribed_joint("hub", ground_marker(Vector3d::Zero()), node(0, 0), motion));
  for (int i = 0; i + 1 < parts; ++i)
    model.add_joint(fixed_joint("weld_" + std::to_string(i + 1), node(i, elements), node(i + 1, 0)));
  return model;
}

Eigen::Vector2d spin_up_tip(Run& run) {
  const int last = run.equations.model().body_count() - 1;
  const BodyKinematics b = run.body(last);
  const ModalBody& modal = *run.equations.model().body(last).modal();
  const Vector3d tip = b.r + b.A * (modal.rho0.col(2) + modal.Phi.middleRows(6, 3) * b.a);
  const double theta = SpinUp().at(run.state.time).value;
  const Vector2d x = along(theta), y(-x.y(), x.x()), p(tip.x(), tip.y());
  return {x.dot(p) - kBeam, y.dot(p)};
}

namespace {

constexpr double kShaft = 0.6, kThick = 0.02, kDisc = 8.0;  // [m, m, kg]
const Material kLightSteel{7.85, 207e9, 0.3};

}  // namespace

Model jeffcott_rotor(double speed) {
  FeModel shaft = test::straight_beam({0, 0, 0}, {kShaft, 0, 0}, 4, rod_section(kThick), kLightSteel);
  shaft.node_mass(2) += kDisc;
  shaft.node_inertia[2] += Vector3d(0.09, 0.047, 0.047).asDiagonal();
  BasisOptions options;
  options.mode_count = 2;
  options.damping_ratio = {0.0};
  options.pinned_nodes = {0, 4};
  const Body body("rotor", std::make_shared<const ModalBody>(reduce(shaft, options, "rotor").body));
  BodyState state;
  state.r = {0.5 * kShaft, 0.0, 0.0};
  state.w = {speed, 0.0, 0.0};
  state.dr = {0.0, 0.0, 0.01};
  Model model;
  const int rotor = model.add_body(body, state);
  model.add_joint(spherical_joint("left", ground_marker(Vector3d::Zero()), node_marker(rotor, model.body(rotor), 0)));
  // The other end keeps to the line of the bearings.
  const Vector3d end(kShaft, 0.0, 0.0);
  for (const Vector3d& normal : {Vector3d(Vector3d::UnitY()), Vector3d(Vector3d::UnitZ())})
    model.add_joint(point_on_plane_joint(normal.y() > 0.5 ? "right_y" : "right_z",
                                         ground_marker(end, axes_with_z(normal)),
                                         node_marker(rotor, model.body(rotor), 4)));
  return model;
}

double jeffcott_frequency() {
  const double EI = kLightSteel.young * M_PI * std::pow(kThick, 4) / 64.0;
  const double shaft = kLightSteel.density * 0.25 * M_PI * kThick * kThick * kShaft;
  return std::sqrt(48.0 * EI / std::pow(kShaft, 3) / (kDisc + 17.0 / 35.0 * shaft));
}

double disc_height(Run& run) {
  const BodyKinematics b = run.body(0);
  const ModalBody& modal = *run.equations.model().body(0).modal();
  return (b.r + b.A * (modal.rho0.col(2) + modal.Phi.middleRows(6, 3) * b.a)).z();
}

}  // namespace footfall::test
