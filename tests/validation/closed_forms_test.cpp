// Scenes with closed forms or a fine integration of one equation: a value of the history at its end, with both integrators.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/session/observe/observation.h"
#include "mbd_solver/session/simulation.h"
#include "tests/support/scene_texts.h"
#include "tests/unit/scene/scene_text.h"
#include "tests/unit/session/never.h"

namespace footfall {
namespace closed_forms {

struct Value {
  std::string column;
  double expected;
  double scale = 1.0;  // an error of 1e-5 of it is allowed: about 30 times what the tolerances below leave
};

struct Case {
  std::string name;
  double end;  // [s]
  std::string scene;
  std::vector<Value> values;
};

// --- Parts of scenes.

using test::body;
using test::joint;
using test::lines;

std::string rail(const std::string& more = "", const std::string& axis = "x") {
  return joint("p", "prismatic", "ground", "b", "[0, 0, 0]", axis, more);
}
std::string hinge(const std::string& more = "", const std::string& axis = "y", const std::string& point = "[0, 0, 0]") {
  return joint("h", "revolute", "ground", "b", point, axis, more);
}
std::string force(const std::string& what, const std::string& direction = "[1, 0, 0]",
                  const std::string& frame = "inertial") {
  return "[[forces]]\nname = \"f\"\nbody = \"b\"\nframe = \"" + frame + "\"\ndirection = " + direction + "\n" + what +
         "\n";
}
std::string strut(const std::string& law, const std::string& far = "[2, 0, 0]") {
  return "[[struts]]\nname = \"s\"\nbodies = [\"ground\", \"b\"]\npoints = [" + far + ", [0, 0, 0]]\n" + law;
}
std::string pushed(double v) { return lines("[initial]\nvelocity = [", v, ", 0, 0]\n"); }
const std::string kNoGravity = "gravity = [0, 0, 0]\n";
const std::string kGravity = "gravity = [0, 0, -9.81]\n";
constexpr double kG = 9.81;

// --- What is expected.

// x'' = a(x, x', t) by Runge and Kutta's fourth order in 200 000 steps: x, x'.
std::array<double, 2> integrated(const std::function<double(double, double, double)>& a, double x, double v,
                                 double end) {
  constexpr int steps = 200000;
  const double h = end / steps;
  for (int k = 0; k < steps; ++k) {
    const double t = k * h;
    const double k1 = v, l1 = a(x, v, t);
    const double k2 = v + 0.5 * h * l1, l2 = a(x + 0.5 * h * k1, v + 0.5 * h * l1, t + 0.5 * h);
    const double k3 = v + 0.5 * h * l2, l3 = a(x + 0.5 * h * k2, v + 0.5 * h * l2, t + 0.5 * h);
    const double k4 = v + h * l3, l4 = a(x + h * k3, v + h * l3, t + h);
    x += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    v += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
  }
  return {x, v};
}

// m x'' + c x' + k x = 0 from x and v.
std::array<double, 2> oscillator(double m, double c, double k, double x, double v, double t) {
  const double d = c / (2 * m), w2 = k / m - d * d;
  if (w2 > 0) {
    const double w = std::sqrt(w2), e = std::exp(-d * t), s = std::sin(w * t), q = std::cos(w * t);
    return {e * (x * q + (v + d * x) / w * s), e * (v * q - (d * v + k / m * x) / w * s)};
  }
  const double w = std::sqrt(-w2), r1 = -d + w, r2 = -d - w;
  const double b = (v - r1 * x) / (r2 - r1), a = x - b;
  return {a * std::exp(r1 * t) + b * std::exp(r2 * t), a * r1 * std::exp(r1 * t) + b * r2 * std::exp(r2 * t)};
}

// Period of a pendulum of natural frequency w [rad/s] that swings to theta: 4 K / w, K by the arithmetic-geometric mean.
double pendulum_period(double w, double theta) {
  double a = 1.0, g = std::cos(0.5 * theta);
  for (int i = 0; i < 8; ++i) {
    const double mean = 0.5 * (a + g);
    g = std::sqrt(a * g);
    a = mean;
  }
  return 2 * kPi / (w * a);
}

void add_points(std::vector<Case>& all) {
  all.push_back({"free_fall", 1.0, kGravity + body("b", 2, "[0, 0, 5]"), {{"b.z", 5 - 0.5 * kG}, {"b.vz", -kG, 10}}});
  all.push_back({"oblique_throw",
                 1.5,
                 kGravity + body("b", 2, "[0, 0, 0]") + "[initial]\nvelocity = [3, -4, 6]\n",
                 {{"b.x", 4.5, 5}, {"b.y", -6, 5}, {"b.z", 9 - 0.5 * kG * 2.25, 5}}});
  all.push_back(
      {"thrown_and_spinning",
       0.7,
       kGravity + body("b", 2, "[0, 0, 0]") + "[initial]\nvelocity = [1, 0, 0]\nangular_velocity = [0, 0, 7]\n",
       {{"b.x", 0.7}, {"b.z", -0.5 * kG * 0.49}, {"b.yaw", std::remainder(4.9, 2 * kPi)}}});
  for (const double mass : {0.01, 1.0, 3000.0})
    all.push_back(
        {lines("constant_force_", static_cast<int>(100 * mass)),
         1.2,
         kNoGravity + body("b", mass, "[0, 0, 0]") + force(lines("force = { polynomial = [", 5 * mass, "] }")),
         {{"b.x", 3.6}, {"b.vx", 6}}});
  all.push_back({"ramp_of_force",
                 1.5,
                 kNoGravity + body("b", 2, "[0, 0, 0]") + force("force = { polynomial = [0, 3] }"),
                 {{"b.x", 3 * 3.375 / 12}, {"b.vx", 3 * 2.25 / 4}}});
  all.push_back({"cube_of_time",
                 1.0,
                 kNoGravity + body("b", 2, "[0, 0, 0]") + force("force = { polynomial = [0, 0, 0, 8] }"),
                 {{"b.x", 0.2}, {"b.vx", 1.0}}});
  {
    const double w = 2 * kPi * 3, t = 0.9;
    all.push_back({"sine_of_force",
                   t,
                   kNoGravity + body("b", 2, "[0, 0, 0]") + force("force = { amplitude = 10, frequency = 3 }"),
                   {{"b.x", 5 / (w * w) * (w * t - std::sin(w * t))}, {"b.vx", 5 / w * (1 - std::cos(w * t))}}});
    all.push_back(
        {"cosine_of_force",
         t,
         kNoGravity + body("b", 2, "[0, 0, 0]") + force("force = { amplitude = 10, frequency = 3, phase_deg = 90 }"),
         {{"b.x", 5 / (w * w) * (1 - std::cos(w * t))}, {"b.vx", 5 / w * std::sin(w * t)}}});
  }
  all.push_back({"triangle_of_force",
                 1.0,
                 kNoGravity + body("b", 2, "[0, 0, 0]") +
                     force("force = { table = [[0, 0], [0.2, 0], [0.3, 40], [0.4, 0], [1, 0]] }"),
                 {{"b.vx", 2.0}, {"b.x", 2.0 * 0.7}}});
  all.push_back({"pulse_of_a_microsecond",
                 1.0,
                 kNoGravity + body("b", 2, "[0, 0, 0]") +
                     force("force = { table = [[0.5, 0], [0.5000005, 4e6], [0.500001, 0]] }"),
                 {{"b.vx", 1.0}, {"b.x", 0.5 - 0.5e-6}}});
  {
    const double w = 2.0, t = 1.3, a = 3.0;  // the thrust turns with the body
    all.push_back({"thrust_of_a_spinning_body",
                   t,
                   kNoGravity + body("b", 2, "[0, 0, 0]") +
                       force(lines("force = { polynomial = [", 2 * a, "] }"), "[1, 0, 0]", "body") +
                       "[initial]\nangular_velocity = [0, 0, 2]\n",
                   {{"b.vx", a / w * std::sin(w * t)},
                    {"b.vy", a / w * (1 - std::cos(w * t))},
                    {"b.x", a / (w * w) * (1 - std::cos(w * t))},
                    {"b.y", a / w * (t - std::sin(w * t) / w)}}});
  }
  all.push_back({"torque_about_an_axis",
                 1.1,
                 kNoGravity + body("b", 2, "[0, 0, 0]", "[0.2, 0.3, 0.4]") +
                     force("torque = { polynomial = [0, 0.6] }", "[0, 0, 1]", "body"),
                 {{"b.wz", 0.6 * 1.21 / 2 / 0.4}, {"b.yaw", 0.6 * 1.331 / 6 / 0.4}}});
  {
    // A symmetrical top, free: in the body w1 = A cos(L t), w2 = A sin(L t), L = (I3 - I1) / I1 w3; about its momentum it turns at |H| / I1.
    const double I1 = 0.2, I3 = 0.35, w3 = 5.0, A = 1.5, t = 0.8;
    const double H1 = I1 * A, H3 = I3 * w3, H = std::hypot(H1, H3), rate = H / I1;
    // w in W at the start is (A, 0, w3); it turns about the axis (H1, 0, H3) / H by rate t.
    const double n1 = H1 / H, n3 = H3 / H, c = std::cos(rate * t), s = std::sin(rate * t), along = n1 * A + n3 * w3;
    const double cross_y = n3 * A - n1 * w3;
    all.push_back({"free_symmetrical_top",
                   t,
                   kNoGravity + body("b", 1, "[0, 0, 0]", lines("[", I1, ", ", I1, ", ", I3, "]")) +
                       lines("[initial]\nangular_velocity = [", A, ", 0, ", w3, "]\n"),
                   {{"b.wx", A * c + n1 * along * (1 - c), 5},
                    {"b.wy", cross_y * s, 5},
                    {"b.wz", w3 * c + n3 * along * (1 - c), 5}}});
  }
}

void add_oscillators(std::vector<Case>& all) {
  for (const double c : {0.0, 3.0, 28.0, 28.284271247461902, 60.0}) {
    const double t = 0.83;
    const auto [x, v] = oscillator(2, c, 100, 0.1, 0, t);
    all.push_back({lines("spring_and_damper_", static_cast<int>(10 * c)),
                   t,
                   kNoGravity + body("b", 2, "[0, 0, 0]") +
                       rail(lines("displacement = { spring = { stiffness = 100, damping = ", c, " } }\n")) +
                       "[initial.joints]\np = 0.1\n",
                   {{"p.displacement", x, 0.1}, {"p.displacement_rate", v}}});
  }
  for (const double rest : {-0.05, 0.2}) {
    const auto [x, v] = oscillator(2, 1, 100, -rest, 0, 0.6);
    all.push_back({rest < 0 ? "spring_at_rest_behind" : "spring_at_rest_ahead",
                   0.6,
                   kNoGravity + body("b", 2, "[0, 0, 0]") +
                       rail(lines("displacement = { spring = { stiffness = 100, damping = 1, rest = ", rest, " } }\n")),
                   {{"p.displacement", x + rest, 0.1}, {"p.displacement_rate", v}}});
  }
  {
    const auto [x, v] = oscillator(2, 4, 800, 2 * kG / 800, 0, 0.45);
    all.push_back({"hanging_on_a_strut",
                   0.45,
                   kGravity + body("b", 2, "[0, 0, 0]") + rail("", "z") +
                       strut("spring = { stiffness = 800, damping = 4 }\n", "[0, 0, 2]"),
                   {{"b.z", x - 2 * kG / 800, 0.1}, {"b.vz", v}}});
    const auto [y, u] = oscillator(2, 0, 800, -0.05, 0, 0.45);
    all.push_back({"preload_of_a_strut",
                   0.45,
                   kNoGravity + body("b", 2, "[0, 0, 0]") + rail() +
                       strut("spring = { stiffness = 800, preload = 40 }\n", "[-2, 0, 0]"),
                   {{"b.x", y + 0.05, 0.1}, {"b.vx", u}}});
  }
  {
    const double t = 0.9;
    const auto [x, v] = oscillator(0.1, 0.05, 4, 0.5, 0, t);
    all.push_back({"torsion_spring",
                   t,
                   kNoGravity + body("b", 2, "[0, 0, 0]") + hinge() +
                       "[[springs]]\nname = \"t\"\nkind = \"torsion\"\nbodies = [\"ground\", \"b\"]\naxis = "
                       "\"y\"\nstiffness = 4\ndamping = 0.05\n[initial.joints]\nh = 0.5\n",
                   {{"h.angle", x}, {"h.angle_rate", v, 5}}});
    all.push_back({"spring_of_a_hinge",
                   t,
                   kNoGravity + body("b", 2, "[0, 0, 0]") +
                       hinge("angle = { spring = { stiffness = 4, damping = 0.05 } }\n") +
                       "[initial.joints]\nh = 0.5\n",
                   {{"h.angle", x}, {"h.angle_rate", v, 5}}});
    all.push_back({"centring_spring",
                   t,
                   kNoGravity + body("b", 2, "[0, 0, 0]") + joint("h", "revolute", "ground", "b", "[0, 0, 0]", "z") +
                       "[[springs]]\nname = \"t\"\nkind = \"centring\"\nbodies = [\"ground\", \"b\"]\nstiffness = "
                       "4\ndamping = 0.05\n[initial.joints]\nh = 0.5\n",
                   {{"h.angle", x}, {"h.angle_rate", v, 5}}});
    const auto [y, u] = oscillator(2, 3, 90, 0.1, 0, t);
    all.push_back({"bushing",
                   t,
                   kNoGravity + body("b", 2, "[0, 0, 0]") + rail("", "y") +
                       "[[springs]]\nname = \"m\"\nkind = \"bushing\"\nbodies = [\"ground\", \"b\"]\npoint = [0, 0, "
                       "0]\nstiffness = [50, 90, 70]\ndamping = [1, 3, 2]\n[initial.joints]\np = 0.1\n",
                   {{"b.y", y, 0.1}, {"b.vy", u}}});
  }
  {
    // Two masses on a spring, pushed on one side.
    const double m1 = 1, m2 = 3, k = 120, t = 0.7, m = m1 * m2 / (m1 + m2);
    const auto [x, v] = oscillator(m, 0, k, 0, -2, t);  // x_2 - x_1
    const double centre = 2 * m1 / (m1 + m2) * t;
    all.push_back({"two_masses",
                   t,
                   kNoGravity + body("b", m1, "[0, 0, 0]") + body("c", m2, "[1, 0, 0]") + rail() +
                       joint("q", "prismatic", "ground", "c", "[1, 0, 0]", "x") +
                       "[[struts]]\nname = \"s\"\nbodies = [\"b\", \"c\"]\npoints = [[0, 0, 0], [1, 0, 0]]\nspring = { "
                       "stiffness = 120 }\n[[initial.bodies]]\nbody = \"b\"\nvelocity = [2, 0, 0]\n",
                   {{"b.x", centre - m2 / (m1 + m2) * x},
                    {"c.x", 1 + centre + m1 / (m1 + m2) * x},
                    {"c.vx", 2 * m1 / (m1 + m2) + m1 / (m1 + m2) * v}}});
  }
  {
    // Driven at its own frequency: x = F / (2 m w) (sin(w t) / w - t cos(w t)).
    const double w = 2 * kPi * 2, t = 1.3;
    all.push_back({"resonance",
                   t,
                   kNoGravity + body("b", 2, "[0, 0, 0]") +
                       rail(lines("displacement = { spring = { stiffness = ", 2 * w * w, " } }\n")) +
                       force("force = { amplitude = 10, frequency = 2 }"),
                   {{"b.x", 10 / (4 * w) * (std::sin(w * t) / w - t * std::cos(w * t))}}});
  }
  {
    // A bead on a rod that turns: r = r0 cosh(w t).
    all.push_back({"bead_on_a_turning_rod",
                   1.0,
                   kNoGravity + body("rod", 1, "[0, 0, 0]") + body("b", 0.5, "[0.2, 0, 0]") +
                       joint("turn", "prescribed", "ground", "rod", "[0, 0, 0]", "z",
                             "motion = { x = { polynomial = [0] }, y = { polynomial = [0] }, z = { polynomial = [0] }, "
                             "rotation = { polynomial = [0, 2] }, hold_other_rotations = true }\n") +
                       joint("p", "prismatic", "rod", "b", "[0.2, 0, 0]", "x") +
                       "[[initial.bodies]]\nbody = \"rod\"\nangular_velocity = [0, 0, 2]\n[[initial.bodies]]\nbody = "
                       "\"b\"\nvelocity = [0, 0.4, 0]\nangular_velocity = [0, 0, 2]\n",
                   {{"p.displacement", 0.2 * (std::cosh(2.0) - 1)}, {"p.displacement_rate", 0.4 * std::sinh(2.0)}}});
  }
}

void add_pendulums(std::vector<Case>& all) {
  for (const double theta : {0.05, 0.8, 1.5, 2.5}) {
    const double inertia = 0.1 + 2 * 0.49, w = std::sqrt(2 * kG * 0.7 / inertia), period = pendulum_period(w, theta);
    const std::string scene =
        kGravity + body("b", 2, "[0, 0, -0.7]") + hinge() + lines("[initial.joints]\nh = ", theta, "\n");
    all.push_back({lines("pendulum_period_", static_cast<int>(100 * theta)),
                   period,
                   scene,
                   {{"h.angle", theta}, {"h.angle_rate", 0, 5}}});
    all.push_back({lines("pendulum_half_period_", static_cast<int>(100 * theta)),
                   0.5 * period,
                   scene,
                   {{"h.angle", -theta}, {"h.angle_rate", 0, 5}}});
  }
  {
    // The same by a distance and in a plane by a spherical joint.
    const double period = pendulum_period(std::sqrt(kG / 0.7), 1.2), s = 0.7 * std::sin(1.2), c = -0.7 * std::cos(1.2);
    all.push_back({"pendulum_on_a_string",
                   period,
                   kGravity + body("b", 2, lines("[", s, ", 0, ", c, "]")) +
                       lines("[[joints]]\nname = \"d\"\nkind = \"distance\"\nbodies = [\"ground\", \"b\"]\npoint_a = "
                             "[0, 0, 0]\npoint_b = [",
                             s, ", 0, ", c, "]\n"),
                   {{"b.x", s}, {"b.z", c}}});
    const double inertia = 0.1 + 2 * 0.49, around = pendulum_period(std::sqrt(2 * kG * 0.7 / inertia), 1.2);
    all.push_back({"spherical_joint_in_a_plane",
                   around,
                   kGravity + body("b", 2, lines("[", s, ", 0, ", c, "]")) +
                       joint("k", "spherical", "ground", "b", "[0, 0, 0]", ""),
                   {{"b.x", s}, {"b.z", c}}});
  }
  {
    // A mass point on a string in a circle: w = sqrt(g / (l cos a)).
    const double l = 0.9, a = 0.6, w = std::sqrt(kG / (l * std::cos(a))), s = l * std::sin(a), t = 1.1;
    all.push_back({"conical_pendulum",
                   t,
                   kGravity + body("b", 2, lines("[", s, ", 0, ", -l * std::cos(a), "]")) +
                       lines("[[joints]]\nname = \"d\"\nkind = \"distance\"\nbodies = [\"ground\", \"b\"]\npoint_a = "
                             "[0, 0, 0]\npoint_b = [",
                             s, ", 0, ", -l * std::cos(a), "]\n[initial]\nvelocity = [0, ", w * s, ", 0]\n"),
                   {{"b.x", s * std::cos(w * t)}, {"b.y", s * std::sin(w * t)}, {"b.z", -l * std::cos(a)}}});
  }
  {
    const double I = 0.1 + 2 * 0.49;
    const auto [x, v] = integrated(
        [&](double q, double u, double) { return -(2 * kG * 0.7 * std::sin(q) + 0.6 * u) / I; }, 2.0, 0, 2.0);
    all.push_back({"damped_pendulum",
                   2.0,
                   kGravity + body("b", 2, "[0, 0, -0.7]") + hinge("angle = { spring = { damping = 0.6 } }\n") +
                       "[initial.joints]\nh = 2.0\n",
                   {{"h.angle", x}, {"h.angle_rate", v, 5}}});
    const auto [y, u] =
        integrated([&](double q, double r,
                       double t) { return -(2 * 0.7 * (kG + 4 * std::sin(12 * t)) * std::sin(q) + 0.0 * r) / I; },
                   0.3, 0, 1.5);
    all.push_back(
        {"pendulum_on_a_shaken_support",
         1.5,
         kGravity + body("a", 5, "[0, 0, 0]") + body("b", 2, "[0, 0, -0.7]") +
             joint("shake", "prescribed", "ground", "a", "[0, 0, 0]", "z",
                   lines("motion = { x = { polynomial = [0] }, y = { polynomial = [0] }, z = { polynomial = [0, ",
                         -4.0 / 12, "], amplitude = ", -4.0 / 144, ", frequency = ", 12 / (2 * kPi),
                         " }, rotation = { polynomial = [0] }, hold_other_rotations = true }\n")) +
             joint("h", "revolute", "a", "b", "[0, 0, 0]", "y") +
             lines("[initial.joints]\nh = 0.3\n[[initial.bodies]]\nbody = \"a\"\nvelocity = [0, 0, ", -8.0 / 12,
                   "]\n[[initial.bodies]]\nbody = \"b\"\nvelocity = [0, 0, ", -8.0 / 12, "]\n"),
         {{"h.angle", y}, {"h.angle_rate", u, 5}}});
  }
}

void add_struts(std::vector<Case>& all) {
  // The strut is in front of the mass: its stroke is the way x.
  const auto add = [&](const std::string& name, double v, double end, const std::string& law,
                       const std::function<double(double, double)>& strut_force) {
    const auto [x, u] = integrated([&](double q, double r, double) { return -strut_force(q, r) / 2; }, 0, v, end);
    all.push_back({name,
                   end,
                   kNoGravity + body("b", 2, "[0, 0, 0]") + rail() + strut(law) + pushed(v),
                   {{"b.x", x}, {"b.vx", u, 2}, {"s.stroke", x}}});
  };
  const double area = kPi * 0.03 * 0.03 / 4;
  add("gas_spring", 2.0, 0.2,
      "gas = { piston_diameter = 0.03, pressure = 3e5, volume = 4e-4, exponent = 1.2 }\nstops = { max = 0.5 }\n",
      [&](double x, double) { return area * 3e5 * std::pow(4e-4 / (4e-4 - area * x), 1.2); });
  add("gas_spring_outward", -1.0, 0.1,
      "gas = { piston_diameter = 0.03, pressure = 3e5, volume = 4e-4, exponent = 1.2 }\nstops = { max = 0.5 }\n",
      [&](double x, double) { return area * 3e5 * std::pow(4e-4 / (4e-4 - area * x), 1.2); });
  for (const double U : {0.0, 0.4, 1.0})
    add(lines("mr_damper_", static_cast<int>(10 * U)), 3.0, 0.15,
        lines("mr = { yield_force = 20, viscous = 6, regularisation_speed = 0.05, voltage = ", U, " }\n"),
        [U](double, double v) { return U * 20 * std::tanh(v / 0.05) + 6 * v; });
  add("mr_damper_pulled", -3.0, 0.15,
      "mr = { yield_force = 20, viscous = 6, regularisation_speed = 0.05, voltage = 0.5 }\n",
      [](double, double v) { return 10 * std::tanh(v / 0.05) + 6 * v; });
  add("gas_and_damper", 2.0, 0.5,
      "gas = { piston_diameter = 0.03, pressure = 3e5, volume = 4e-4, exponent = 1.2 }\nstops = { max = 0.5 }\nmr = { "
      "yield_force = 20, "
      "viscous = 6, regularisation_speed = 0.05, voltage = 0.3 }\n",
      [&](double x, double v) {
        return area * 3e5 * std::pow(4e-4 / (4e-4 - area * x), 1.2) + 6 * std::tanh(v / 0.05) + 6 * v;
      });
  add("spring_of_a_strut", 2.0, 0.4, "spring = { stiffness = 300, damping = 5, preload = 12 }\n",
      [](double x, double v) { return 300 * x + 5 * v + 12; });
  all.push_back(
      {"sliding_friction",
       0.3,
       kGravity + body("b", 2, "[0, 0, 0]") + rail("displacement = { friction = { coulomb = 4 } }\n") + pushed(2.0),
       {{"b.x", 2 * 0.3 - 0.5 * 2 * 0.09, 3}, {"b.vx", 2 - 2 * 0.3, 3}}});
  all.push_back(
      {"viscous_friction",
       0.9,
       kNoGravity + body("b", 2, "[0, 0, 0]") + rail("displacement = { spring = { damping = 3 } }\n") + pushed(2.0),
       {{"b.vx", 2 * std::exp(-1.35)}, {"b.x", 2 / 1.5 * (1 - std::exp(-1.35))}}});
}

void add_drives(std::vector<Case>& all) {
  all.push_back({"torque_through_a_gear",
                 0.8,
                 kNoGravity + body("b", 2, "[0, 0, 0]") + hinge() +
                     "[[drives]]\nname = \"d\"\nkind = \"torque\"\njoint = \"h\"\ncommand = { polynomial = [0.02] "
                     "}\ngear_ratio = 10\nrotor_inertia = 1e-3\n",
                 {{"h.angle", 0.5 * 0.2 / 0.2 * 0.64}, {"h.angle_rate", 0.8}}});
  all.push_back({"efficiency_of_a_gear",
                 0.8,
                 kNoGravity + body("b", 2, "[0, 0, 0]") + hinge() +
                     "[[drives]]\nname = \"d\"\nkind = \"torque\"\njoint = \"h\"\ncommand = { polynomial = [0.02] "
                     "}\ngear_ratio = 10\nefficiency = 0.75\n",
                 {{"h.angle_rate", 0.15 / 0.1 * 0.8, 50}}});  // no loss at rest: it rises with the first speed
  {
    // kp and ki on the speed: I w' = kp (w0 - w) + ki (w0 t - q).
    const auto [q, w] =
        integrated([](double x, double v, double t) { return (0.8 * (3 - v) + 5 * (3 * t - x)) / 0.1; }, 0, 0, 0.7);
    all.push_back({"speed_drive",
                   0.7,
                   kNoGravity + body("b", 2, "[0, 0, 0]") + hinge() +
                       "[[drives]]\nname = \"d\"\nkind = \"speed\"\njoint = \"h\"\ncommand = { polynomial = [3] }\nkp "
                       "= 0.8\nki = 5\n",
                   {{"h.angle", q}, {"h.angle_rate", w, 3}}});
    const auto [p, v] =
        integrated([](double x, double u, double) { return (9 * (0.4 - x) - 0.7 * u) / 0.1; }, 0, 0, 0.5);
    all.push_back({"position_drive",
                   0.5,
                   kNoGravity + body("b", 2, "[0, 0, 0]") + hinge() +
                       "[[drives]]\nname = \"d\"\nkind = \"position\"\njoint = \"h\"\ncommand = { polynomial = [0.4] "
                       "}\nkp = 9\nkd = 0.7\n",
                   {{"h.angle", p}, {"h.angle_rate", v, 3}}});
  }
  {
    const double w = 2 * kPi * 2.5, t = 0.77;
    all.push_back(
        {"prescribed_sine",
         t,
         kNoGravity + body("b", 2, "[0, 0, 0]") +
             joint("m", "prescribed", "ground", "b", "[0, 0, 0]", "z",
                   "motion = { x = { amplitude = 0.1, frequency = 2.5 }, y = { polynomial = [0] }, z = { polynomial = "
                   "[0] }, rotation = { polynomial = [0, 0, 1.5] }, hold_other_rotations = true }\n") +
             lines("[[initial.bodies]]\nbody = \"b\"\nvelocity = [", 0.1 * w, ", 0, 0]\n"),
         {{"b.x", 0.1 * std::sin(w * t)},
          {"b.vx", 0.1 * w * std::cos(w * t), 2},
          {"b.ax", -0.1 * w * w * std::sin(w * t), 30},
          {"b.yaw", 1.5 * t * t},
          {"work.motion", 0.5 * 2 * 0.01 * w * w * (std::pow(std::cos(w * t), 2) - 1) + 0.5 * 0.1 * 9 * t * t, 5}}});
  }
  for (const double factor : {-3.0, 2.5}) {
    // Two wheels: factor q1 + q2 = 0, so that q2 = -factor q1.
    const double t = 0.6, a = 0.5 / (0.1 + factor * factor * 0.1);
    all.push_back(
        {factor < 0 ? "ring_gear" : "spur_gear",
         t,
         kNoGravity + body("b", 2, "[0, 0, 0]") + body("c", 2, "[0, 0, 1]") +
             joint("h", "revolute", "ground", "b", "[0, 0, 0]", "z") +
             joint("k", "revolute", "ground", "c", "[0, 0, 1]", "z") +
             lines("[[gears]]\nname = \"g\"\njoints = [\"h\", \"k\"]\nfactors = [", factor, ", 1]\n") +
             force("torque = { polynomial = [0.5] }", "[0, 0, 1]"),
         {{"h.angle", 0.5 * a * t * t}, {"k.angle", -factor * 0.5 * a * t * t}, {"k.angle_rate", -factor * a * t}}});
  }
  {
    // A weight on a rack turns its pinion: m' = m + I / r^2.
    const double a = -2 * kG / (2 + 0.1 / 0.01), t = 0.6;
    all.push_back({"rack_and_pinion",
                   t,
                   kGravity + body("b", 2, "[0, 0, 0]") + body("c", 2, "[1, 0, 0]") + rail("", "z") +
                       joint("k", "revolute", "ground", "c", "[1, 0, 0]", "y") +
                       "[[gears]]\nname = \"g\"\njoints = [\"k\", \"p\"]\nfactors = [0.1, -1]\n",
                   {{"b.z", 0.5 * a * t * t}, {"k.angle_rate", a * t / 0.1, 3}}});
    const double lead = 0.02, down = -2 * kG / (2 + 0.1 / (lead * lead));
    all.push_back({"spindle",
                   t,
                   kGravity + body("b", 2, "[0, 0, 0]") + joint("k", "cylindrical", "ground", "b", "[0, 0, 0]", "z") +
                       "[[gears]]\nname = \"g\"\njoints = [\"k\", \"k\"]\ncoordinates = [\"displacement\", "
                       "\"angle\"]\nfactors = [1, -0.02]\n",
                   {{"b.z", 0.5 * down * t * t}, {"k.angle", 0.5 * down * t * t / lead}}});
  }
  for (const double bend : {0.3, 0.9}) {
    // Hooke's joint: tan(q2) = tan(q1) / cos(bend), and the constant-velocity joint for comparison.
    const double t = 1.7, q = 0.8 * t, s = std::sin(bend), c = std::cos(bend);
    const auto shaft = [&](const std::string& type, const std::string& axes) {
      return kNoGravity + body("a", 2, "[0, 0, 0]") + body("b", 2, lines("[", s, ", 0, ", c, "]")) +
             joint("turn", "prescribed", "ground", "a", "[0, 0, 0]", "z",
                   "motion = { x = { polynomial = [0] }, y = { polynomial = [0] }, z = { polynomial = [0] }, rotation "
                   "= { polynomial = [0, 0.8] }, hold_other_rotations = true }\n") +
             "[[joints]]\nname = \"u\"\nkind = \"" + type + "\"\nbodies = [\"a\", \"b\"]\npoint = [0, 0, 0]\n" + axes +
             lines(
                 "[[joints]]\nname = \"out\"\nkind = \"revolute\"\nbodies = [\"ground\", \"b\"]\npoint = [0, 0, "
                 "0]\naxis = [",
                 s, ", 0, ", c, "]\n[[initial.bodies]]\nbody = \"a\"\nangular_velocity = [0, 0, 0.8]\n");
    };
    const double even = 0.8;
    all.push_back(
        {lines("constant_velocity_joint_", static_cast<int>(10 * bend)),
         t,
         shaft("constant_velocity", lines("axis = \"z\"\naxis2 = [", s, ", 0, ", c, "]\n")) +
             lines("[[initial.bodies]]\nbody = \"b\"\nangular_velocity = [", even * s, ", 0, ", even * c, "]\n"),
         {{"out.angle", q}, {"out.angle_rate", even}}});
    // The cross is across the bend at the start (axis y, held by a): tan(q2) = cos(bend) tan(q1).
    const double angle = q + std::atan2((c - 1) * std::tan(q), 1 + c * std::tan(q) * std::tan(q)),
                 rate = 0.8 * c / (std::pow(std::cos(q), 2) + c * c * std::pow(std::sin(q), 2));
    all.push_back(
        {lines("hookes_joint_", static_cast<int>(10 * bend)),
         t,
         shaft("universal", lines("axis = \"y\"\naxis2 = [", c, ", 0, ", -s, "]\n")) +
             lines("[[initial.bodies]]\nbody = \"b\"\nangular_velocity = [", 0.8 * c * s, ", 0, ", 0.8 * c * c, "]\n"),
         {{"out.angle", angle}, {"out.angle_rate", rate}}});
  }
  {
    // Crank r, rod l: x = r cos q + sqrt(l^2 - r^2 sin^2 q).
    const double r = 0.1, l = 0.3, w = 4, t = 0.9, q = w * t;
    all.push_back({"slider_crank",
                   t,
                   kNoGravity + body("a", 1, "[0.05, 0, 0]") + body("rod", 1, "[0.25, 0, 0]") +
                       body("b", 1, "[0.4, 0, 0]") +
                       joint("turn", "prescribed", "ground", "a", "[0, 0, 0]", "z",
                             "motion = { x = { polynomial = [0] }, y = { polynomial = [0] }, z = { polynomial = [0] }, "
                             "rotation = { polynomial = [0, 4] }, hold_other_rotations = true }\n") +
                       joint("pin", "revolute", "a", "rod", "[0.1, 0, 0]", "z") +
                       joint("wrist", "spherical", "rod", "b", "[0.4, 0, 0]", "") +
                       joint("p", "prismatic", "ground", "b", "[0.4, 0, 0]", "x") +
                       lines("[[initial.bodies]]\nbody = \"a\"\nvelocity = [0, 0.2, 0]\nangular_velocity = [0, 0, "
                             "4]\n[[initial.bodies]]\nbody = \"rod\"\nvelocity = [0, ",
                             0.5 * r * w, ", 0]\nangular_velocity = [0, 0, ", -r * w / l, "]\n"),
                   {{"b.x", r * std::cos(q) + std::sqrt(l * l - r * r * std::pow(std::sin(q), 2))},
                    {"b.vx", -r * w * std::sin(q) - r * r * w * std::sin(q) * std::cos(q) /
                                                        std::sqrt(l * l - r * r * std::pow(std::sin(q), 2))}}});
  }
}

void add_slides(std::vector<Case>& all) {
  const double t = 0.8, slope = 0.4, s = std::sin(slope), c = std::cos(slope);
  const std::string tilted = lines("gravity = [", kG * s, ", 0, ", -kG * c, "]\n");
  all.push_back({"point_on_a_slope",
                 t,
                 tilted + body("b", 2, "[0, 0, 0]") +
                     "[[joints]]\nname = \"o\"\nkind = \"point_on_plane\"\nbodies = [\"ground\", \"b\"]\npoint_a = [0, "
                     "0, 0]\npoint_b = [0, 0, 0]\naxis = \"z\"\n",
                 {{"b.x", 0.5 * kG * s * t * t}, {"b.z", 0}}});
  all.push_back({"planar_joint_on_a_slope",
                 t,
                 tilted + body("b", 2, "[0, 0, 0]") + joint("o", "planar", "ground", "b", "[0, 0, 0]", "z") +
                     "[initial]\nangular_velocity = [0, 0, 3]\n",
                 {{"b.x", 0.5 * kG * s * t * t}, {"o.angle", 3 * t}}});
  all.push_back({"ball_rolls_down",
                 t,
                 tilted + body("b", 2, "[0, 0, 0.2]", "[0.032, 0.032, 0.032]") +
                     "[[joints]]\nname = \"o\"\nkind = \"rolling\"\nbodies = [\"ground\", \"b\"]\npoint_a = [0, 0, "
                     "0]\npoint_b = [0, 0, 0.2]\naxis = \"z\"\nradius = 0.2\n",
                 {{"b.x", 0.5 * kG * s / 1.4 * t * t}, {"b.wy", kG * s / 1.4 * t / 0.2, 10}}});
  all.push_back({"disc_rolls_down",
                 t,
                 tilted + body("b", 2, "[0, 0, 0.2]", "[0.02, 0.04, 0.02]") +
                     "[[joints]]\nname = \"o\"\nkind = \"rolling\"\nbodies = [\"ground\", \"b\"]\npoint_a = [0, 0, "
                     "0]\npoint_b = [0, 0, 0.2]\naxis = \"z\"\naxis2 = \"y\"\nradius = 0.2\n",
                 {{"b.x", 0.5 * kG * s / 1.5 * t * t}}});
  const std::string ball =
      "[[bodies]]\nname = \"b\"\nmass = 2\nshape = { kind = \"sphere\", centre = [0, 0, 0], radius = 0.1 "
      "}\n[[boundaries]]\nbody = \"b\"\nsurface = {}\n[ground]\nkind = \"plane\"\n";
  {
    // A ball without friction on a hard plane: until it falls, and back from it with the restitution 0.5 at its speed.
    const double h = 0.2, v = std::sqrt(2 * kG * h), fall = std::sqrt(2 * h / kG), after = 0.1;
    all.push_back({"bounce",
                   fall + after,
                   kGravity + ball +
                       lines("plane = { point = [0, 0, ", -0.1 - h,
                             "], stiffness = 1e11, restitution = 0.5, impact_speed = ", v, ", friction = 0 }\n"),
                   {{"b.z", -h + 0.5 * v * after - 0.5 * kG * after * after, 20},
                    {"b.vz", 0.5 * v - kG * after, 200}}});  // the contact lasts 1e-4 s
  }
}

void add_signals(std::vector<Case>& all) {
  const std::string still = kNoGravity + body("b", 2, "[0, 0, 0]");
  const auto signal = [](const std::string& name, const std::string& kind, const std::string& rest) {
    return "[[signals]]\nname = \"" + name + "\"\nkind = \"" + kind + "\"\n" + rest;
  };
  const double t = 0.31, w = 2 * kPi * 2;
  const std::string step = signal("u", "expression", "input = \"time > 0.1 ? 3 : 0\"\n");
  all.push_back({"lowpass_of_a_step",
                 t,
                 still + step + signal("y", "lowpass", "input = \"signal.u\"\nfrequency = 2\n"),
                 {{"signal.y", 3 * (1 - std::exp(-w * 0.21))}}});
  {
    const double x = oscillator(1, 2 * 0.4 * w, w * w, -3, 0, 0.21)[0];
    all.push_back({"lowpass2_of_a_step",
                   t,
                   still + step + signal("y", "lowpass2", "input = \"signal.u\"\nfrequency = 2\ndamping = 0.4\n"),
                   {{"signal.y", 3 + x}}});
  }
  all.push_back({"integral_of_a_step",
                 t,
                 still + step + signal("y", "pid", "input = \"signal.u\"\nki = 2\n"),
                 {{"signal.y", 2 * 3 * 0.21}}});
  all.push_back({"saturation",
                 t,
                 still + signal("y", "saturation", "input = \"10 * time - 1\"\nmin = -0.5\nmax = 1.5\n"),
                 {{"signal.y", 1.5}}});
  all.push_back({"table_of_a_signal",
                 t,
                 still + signal("y", "table", "input = \"time\"\npoints = [[0, 1], [0.2, 3], [0.6, 7]]\n"),
                 {{"signal.y", 3 + 4 * 0.11 / 0.4}}});
  all.push_back(
      {"table_of_two_inputs",
       t,
       still + signal("y", "table2",
                      "input = \"time\"\ninput2 = \"2 * time\"\nx = [0, 1]\nx2 = [0, 1]\nvalues = [0, 1, 2, 5]\n"),
       {{"signal.y", 2 * 0.31 + 0.62 + 2 * 0.31 * 0.62}}});
  // A double integrator held by a sampled law u = -k x - d v each 20 ms, by the exact map of the held input.
  {
    double x = 0.3, v = 0, T = 0.02;
    for (int k = 0; k < 25; ++k) {
      const double a = (-40 * x - 9 * v) / 2;
      x += T * v + 0.5 * T * T * a;
      v += T * a;
    }
    all.push_back({"sampled_feedback",
                   0.5,
                   kNoGravity + body("b", 2, "[0.3, 0, 0]") +
                       signal("u", "expression", "input = \"-40 * b.x - 9 * b.vx\"\nperiod_ms = 20\n") +
                       force("force = { signal = \"u\" }"),
                   {{"b.x", x}, {"b.vx", v}}});
    const auto [y, u] = oscillator(2, 9, 40, 0.3, 0, 0.5);
    all.push_back({"continuous_feedback",
                   0.5,
                   kNoGravity + body("b", 2, "[0.3, 0, 0]") +
                       signal("u", "expression", "input = \"-40 * b.x - 9 * b.vx\"\n") +
                       force("force = { signal = \"u\" }"),
                   {{"b.x", y}, {"b.vx", u}}});
  }
  const std::string states = "[[states]]\nname = \"on\"\n[[states]]\nname = \"off\"\n";
  all.push_back({"cut_off_in_time",
                 0.9,
                 still + states + "[[events]]\nname = \"cut\"\nwhen = \"time >= 0.4\"\nto = \"off\"\n" +
                     signal("u", "expression", "input = \"state.on * 10\"\n") + force("force = { signal = \"u\" }"),
                 {{"b.vx", 2.0}, {"b.x", 0.4 + 1.0}}});
  all.push_back({"cut_off_at_a_place",
                 0.9,
                 still + states + "[[events]]\nname = \"cut\"\nwhen = \"b.x > 0.4\"\nto = \"off\"\n" +
                     signal("u", "expression", "input = \"state.on * 10\"\n") + force("force = { signal = \"u\" }"),
                 {{"b.vx", 2.0}, {"b.x", 0.4 + 2 * 0.5}}});
}

// What meets another feature on the way: settled and moved starts, gears in a row, wheels by gears, motors at their limits.
void add_combinations(std::vector<Case>& all) {
  const auto gear = [](const std::string& name, const std::string& joints, const std::string& factors,
                       const std::string& more = "") {
    return "[[gears]]\nname = \"" + name + "\"\njoints = " + joints + "\nfactors = " + factors + "\n" + more;
  };
  const auto drive = [](const std::string& kind, const std::string& rest) {
    return "[[drives]]\nname = \"d\"\nkind = \"" + kind + "\"\njoint = \"h\"\n" + rest;
  };
  const std::string settle = "[initial]\nsettle = true\n";
  const std::string hung = kGravity + body("b", 2, "[0, 0, 0]") + rail("", "z") +
                           strut("spring = { stiffness = 800, damping = 4 }\n", "[0, 0, 2]");
  all.push_back({"settled_on_a_strut", 0.3, hung + settle, {{"b.z", -2 * kG / 800}, {"b.vz", 0}}});
  {
    const auto [x, v] = oscillator(2, 4, 800, -30.0 / 800, 0, 0.25);
    all.push_back({"settled_and_pushed_at_a_tenth",
                   0.35,
                   hung + force("force = { table = [[0.1, 0], [0.1000001, 30]] }", "[0, 0, 1]") + settle,
                   {{"b.z", -2 * kG / 800 + 30.0 / 800 + x}, {"b.vz", v}}});
  }
  {
    double q = 0.4;  // k (q - 1) + m g l sin(q) = 0
    for (int i = 0; i < 50; ++i) q -= (12 * (q - 1) + 2 * kG * 0.7 * std::sin(q)) / (12 + 2 * kG * 0.7 * std::cos(q));
    all.push_back({"settled_from_an_initial_angle",
                   0.2,
                   kGravity + body("b", 2, "[0, 0, -0.7]") +
                       hinge("angle = { spring = { stiffness = 12, damping = 1, rest = 1 } }\n") + settle +
                       "[initial.joints]\nh = 0.4\n",
                   {{"h.angle", q}, {"h.angle_rate", 0}}});
  }
  for (const double rest : {8.0, -20.0}) {
    const auto [x, v] = oscillator(0.1, 0, 4, -rest, 0, 0.9);
    all.push_back({rest > 0 ? "spring_wound_by_a_turn" : "spring_wound_back_by_three_turns",
                   0.9,
                   kNoGravity + body("b", 2, "[0, 0, 0]") +
                       hinge(lines("angle = { spring = { stiffness = 4, rest = ", rest, " } }\n")),
                   {{"h.angle", rest + x, 20}, {"h.angle_rate", v, 100}}});
  }
  {
    const std::string wheel = kNoGravity + body("b", 2, "[0, 0, 0]") +
                              joint("h", "planar", "ground", "b", "[0, 0, 0]", "y", "axis2 = \"x\"\n");
    const double a = 6 / (2 + 0.1 / 0.04), t = 0.7;  // a wheel of 0.2 m by a gear
    all.push_back({"wheel_by_a_gear",
                   t,
                   wheel + gear("g", "[\"h\", \"h\"]", "[1, -0.2]", "coordinates = [\"displacement_x\", \"angle\"]\n") +
                       force("force = { polynomial = [6] }"),
                   {{"b.x", 0.5 * a * t * t}, {"h.angle", 0.5 * a * t * t / 0.2}}});
    const auto [x, v] = integrated([](double q, double u, double) { return (50 * (0.2 - q) - 6 * u) / 2; }, 0, 0, 0.6);
    all.push_back(
        {"drive_across_a_planar_joint",
         0.6,
         wheel +
             drive("position", "coordinate = \"displacement_x\"\ncommand = { polynomial = [0.2] }\nkp = 50\nkd = 6\n"),
         {{"b.x", x}, {"b.vx", v}}});
  }
  {
    const std::string shafts = kNoGravity + body("b", 2, "[0, 0, 0]") + body("c", 2, "[0, 0, 1]") +
                               body("e", 2, "[0, 0, 2]") + hinge("", "z") +
                               joint("k", "revolute", "ground", "c", "[0, 0, 1]", "z") +
                               joint("l", "revolute", "ground", "e", "[0, 0, 2]", "z");
    const double t = 0.7, a = 0.4 / (0.1 + 0.1 * 4 + 0.1 * 36);
    const std::string torque = force("torque = { polynomial = [0.4] }", "[0, 0, 1]");
    all.push_back({"gears_in_a_row",
                   t,
                   shafts + gear("g", "[\"h\", \"k\"]", "[2, 1]") + gear("i", "[\"k\", \"l\"]", "[3, 1]") + torque,
                   {{"h.angle", 0.5 * a * t * t}, {"k.angle", -a * t * t}, {"l.angle", 3 * a * t * t}}});
    // A differential, its cage free: q_h + q_k = 2 q_l, torque on one side. With equal inertias I of all three and lambda of the gear:
    //   I a_h = T + lambda, I a_k = lambda, I a_l = -2 lambda,  a_h + a_k = 2 a_l  ->  lambda = -T / 6
    all.push_back({"differential",
                   t,
                   shafts + gear("g", "[\"h\", \"k\", \"l\"]", "[1, 1, -2]") + torque,
                   {{"h.angle", 0.5 * 0.4 * 5 / 6 / 0.1 * t * t},
                    {"k.angle", -0.5 * 0.4 / 6 / 0.1 * t * t},
                    {"l.angle", 0.5 * 0.4 / 3 / 0.1 * t * t}}});
    all.push_back(
        {"straight_cam",
         t,
         shafts + gear("g", "[\"k\", \"h\"]", "[1, -1]", "curve = [[-2, -1], [0, 0], [2, 1], [4, 2]]\n") + torque,
         {{"h.angle", 0.5 * 0.4 / 0.125 * t * t}, {"k.angle", 0.25 * 0.4 / 0.125 * t * t}}});
    all.push_back({"gear_from_an_initial_angle",
                   t,
                   shafts + gear("g", "[\"h\", \"k\"]", "[2, 1]") + "[initial.joints]\nh = 0.5\n" + torque,
                   {{"h.angle", 0.5 + 0.5 * 0.4 / 0.5 * t * t}, {"k.angle", -1 - 0.4 / 0.5 * t * t}}});
  }
  {
    const std::string wheel = kNoGravity + body("b", 2, "[0, 0, 0]") + hinge();
    const double t = 0.5;
    all.push_back({"motor_with_a_largest_speed",
                   t,
                   wheel + drive("torque", "command = { polynomial = [5] }\nmax_torque = 0.3\nmax_speed = 4\n"),
                   {{"h.angle_rate", 4 * (1 - std::exp(-t * 0.3 / (0.1 * 4)))}}});
    all.push_back({"brake",
                   t,
                   wheel + drive("brake", "command = { polynomial = [0.5] }\nmax_torque = 0.6\n") +
                       "[initial]\nangular_velocity = [0, 5, 0]\n",
                   {{"h.angle_rate", 5 - 0.3 / 0.1 * t, 30}}});
    const auto [q, w] =
        integrated([](double x, double v,
                      double u) { return (9 * (0.3 * std::sin(5 * u) - x) + 0.7 * (1.5 * std::cos(5 * u) - v)) / 0.1; },
                   0, 0, 0.8);
    all.push_back({"position_drive_along_a_sine",
                   0.8,
                   wheel + drive("position", lines("command = { amplitude = 0.3, frequency = ", 5 / (2 * kPi),
                                                   " }\nkp = 9\nkd = 0.7\n")),
                   {{"h.angle", q}, {"h.angle_rate", w, 3}}});
  }
  {
    // A damper whose coil lags, at a constant speed.
    const double t = 0.03, lag = 0.02;
    all.push_back(
        {"lag_of_a_coil",
         t,
         kNoGravity + body("b", 2, "[0, 0, 0]") +
             joint("m", "prescribed", "ground", "b", "[0, 0, 0]", "z",
                   "motion = { x = { polynomial = [0, 1] }, y = { polynomial = [0] }, z = { polynomial = [0] }, "
                   "rotation = { polynomial = [0] }, hold_other_rotations = true }\n") +
             strut("mr = { yield_force = 20, viscous = 6, coil_lag_ms = 20, initial_voltage = 0.1, voltage = 0.8 }\n") +
             "[[initial.bodies]]\nbody = \"b\"\nvelocity = [1, 0, 0]\n",
         {{"s.force", 6 + 20 * (0.8 - 0.7 * std::exp(-t / lag)), 5}}});
  }
  {
    // Lifted by a prescribed turn: work is weight times height and energy of motion.
    const double t = 0.9, q = 0.8 * t * t, w = 1.6 * t, I = 0.1 + 2 * 0.49;
    all.push_back(
        {"work_of_a_prescribed_turn",
         t,
         kGravity + body("b", 2, "[0, 0, -0.7]") +
             joint("m", "prescribed", "ground", "b", "[0, 0, 0]", "y",
                   "axis2 = \"z\"\nmotion = { x = { polynomial = [0] }, y = { polynomial = [0] }, z = { polynomial = "
                   "[0] }, rotation = { polynomial = [0, 0, 0.8] }, hold_other_rotations = true }\n"),
         {{"b.z", -0.7 * std::cos(q)}, {"work.motion", 2 * kG * 0.7 * (1 - std::cos(q)) + 0.5 * I * w * w, 20}}});
    // And one while an angle is given.
    all.push_back({"prescribed_motion_with_an_initial_angle",
                   t,
                   kNoGravity + body("a", 1, "[0, 0, 0]") + body("b", 1, "[0, 0, 0.5]") +
                       joint("m", "prescribed", "ground", "a", "[0, 0, 0]", "z",
                             "motion = { x = { polynomial = [0, 0.2, 0.5] }, y = { polynomial = [0] }, z = { "
                             "polynomial = [0] }, rotation = { polynomial = [0] }, hold_other_rotations = true }\n") +
                       joint("h", "revolute", "a", "b", "[0, 0, 0.5]", "z") +
                       "[initial]\nvelocity = [0.2, 0, 0]\n[initial.joints]\nh = 2.5\n",
                   {{"a.x", 0.2 * t + 0.5 * t * t}, {"b.x", 0.2 * t + 0.5 * t * t}, {"h.angle", 2.5}}});
  }
  {
    // Turned before the start: what is fixed in the body turns, what is inertial does not.
    const std::string turned = "[initial]\npitch_deg = 90\n";
    all.push_back(
        {"thrust_of_a_turned_body",
         0.8,
         kNoGravity + body("b", 2, "[0, 0, 0]") + force("force = { polynomial = [6] }", "[1, 0, 0]", "body") + turned,
         {{"b.vz", -2.4}, {"b.vx", 0}}});
    all.push_back({"inertial_force_on_a_turned_body",
                   0.8,
                   kNoGravity + body("b", 2, "[0, 0, 0]") + force("force = { polynomial = [6] }") + turned,
                   {{"b.vx", 2.4}, {"b.vz", 0}}});
  }
  {
    // Three masses on rails around z, each on its spring.
    const auto [x, v] = oscillator(1.5, 0, 60, 0.1, 0, 0.7);
    all.push_back({"array_of_oscillators",
                   0.7,
                   kNoGravity + "[arrays.k]\ncount = 3\nstart_deg = 30\nstep_deg = 120\naxis = [0, 0, 1]\n" +
                       body("b_{k}", 1.5, "[1, 0, 0]") +
                       "[[joints]]\nname = \"p_{k}\"\nkind = \"prismatic\"\nbodies = [\"ground\", \"b_{k}\"]\npoint = "
                       "[1, 0, 0]\naxis = [1, 0, 0]\ndisplacement = { spring = { stiffness = 60 } "
                       "}\n[initial.joints]\np_1 = 0.1\np_2 = 0.1\np_3 = 0.1\n",
                   {{"p_1.displacement", x, 0.1},
                    {"p_3.displacement_rate", v},
                    {"b_1.x", (1 + x) * std::cos(kPi / 6)},
                    {"b_2.y", (1 + x) * std::sin(kPi * 5 / 6)}}});
  }
  {
    // A cantilever that has settled under a force at its end: F l^3 / (3 E I).
    const double I = kPi * std::pow(0.02, 4) / 64, bend = 3.0 / (3 * 2e11 * I);
    all.push_back({"settled_cantilever",
                   0.05,
                   kNoGravity +
                       "[materials.steel]\ndensity = 7800\nyoung = 2e11\npoisson = 0.3\n[[bodies]]\nname = "
                       "\"b\"\nmaterial = \"steel\"\nshape = { kind = \"rod\", from = [0, 0, 0], to = [1, 0, 0], "
                       "diameter = 0.02 }\nflexible = { damping = 0.02 }\n" +
                       joint("w", "fixed", "ground", "b", "[0, 0, 0]", "") +
                       "[[forces]]\nname = \"f\"\nbody = \"b\"\npoint = [1, 0, 0]\nframe = \"inertial\"\ndirection = "
                       "[0, 0, 1]\nforce = { polynomial = [3] }\n" +
                       settle,
                   {{"b.strain_energy", 0.5 * 3 * bend, 0.1}}});
  }
  {
    const std::string balls =
        kNoGravity +
        "[[bodies]]\nname = \"b\"\nmass = 2\nshape = { kind = \"sphere\", centre = [0, 0, 0], radius = 0.1 "
        "}\n[[bodies]]\nname = \"c\"\nmass = 2\nshape = { kind = \"sphere\", centre = [0.3, 0, 0], radius = 0.1 }\n"
        "[[boundaries]]\nbody = \"b\"\nsurface = {}\n[[boundaries]]\nbody = \"c\"\nsurface = {}\n[[contacts]]\nbetween "
        "= [\"b\", \"c\"]\nstiffness = 1e9\nfriction = 0\nimpact_speed = 2\n";
    const std::string moving = "[[initial.bodies]]\nbody = \"b\"\nvelocity = [2, 0, 0]\n";
    all.push_back(
        {"central_elastic_impact", 0.2, balls + "restitution = 1\n" + moving, {{"b.vx", 0, 5}, {"c.vx", 2, 5}}});
    all.push_back({"central_plastic_impact",
                   0.2,
                   balls + "restitution = 0.4\n" + moving,
                   {{"b.vx", 0.6, 20}, {"c.vx", 1.4, 20}}});
  }
}

std::vector<Case> cases() {
  std::vector<Case> all;
  add_points(all);
  add_oscillators(all);
  add_pendulums(all);
  add_struts(all);
  add_drives(all);
  add_slides(all);
  add_signals(all);
  add_combinations(all);
  return all;
}

class ClosedForm : public ::testing::TestWithParam<Case> {};

TEST_P(ClosedForm, ComesOut) {
  const Case& test = GetParam();
  for (const char* integrator : {"one_step", "ida"}) {
    SCOPED_TRACE(integrator);
    const SceneText folder;
    const Scene scene = folder.read(
        lines("end_time = ", test.end, "\n") + test.scene,
        {lines("solver.integrator=\"", integrator, "\""), "solver.rtol=1e-9", "output.vtk=false", "output.interval=1"});
    Simulation simulation(scene, scene.end_time, nullptr);
    Observation observation(simulation.subject());
    const std::vector<std::string> names = observation.names();
    std::vector<double> last;
    simulation.run([&](const Sample& s) { last = observation.row(s); }, test::kNever);
    for (const Value& value : test.values) {
      const auto at = std::find(names.begin(), names.end(), value.column);
      ASSERT_NE(at, names.end()) << "no column " << value.column;
      EXPECT_NEAR(last.at(static_cast<std::size_t>(at - names.begin())), value.expected, 1e-5 * value.scale)
          << value.column;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, ClosedForm, ::testing::ValuesIn(cases()),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace closed_forms
}  // namespace footfall
