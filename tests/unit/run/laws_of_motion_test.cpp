// Whole scenes against closed forms: scales, stiff springs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/run/observe/metrics.h"
#include "mbd_solver/run/observe/observation.h"
#include "mbd_solver/run/simulation.h"
#include "tests/unit/run/never.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

std::string text(double x) {
  char out[40];
  std::snprintf(out, sizeof out, "%.17g", x);
  return out;
}
std::string body(const std::string& name, double mass, double inertia, const std::string& position) {
  return "[[bodies]]\nname = \"" + name + "\"\nmass = " + text(mass) + "\ninertia = [" + text(inertia) + ", " +
         text(inertia) + ", " + text(inertia) + "]\nposition = " + position + "\n";
}

// A run, and the columns of every row.
struct Rows {
  Rows(const std::string& toml, const std::vector<std::string>& settings = {}) {
    const SceneText folder;
    const Scene scene = folder.read(toml, settings);
    Simulation simulation(scene, scene.end_time, nullptr);
    Observation observation(simulation.subject());
    MetricRecorder recorder(simulation.subject());
    names = observation.names();
    simulation.run(
        [&](const Sample& s) {
          rows.push_back(observation.row(s));
          recorder.update(s);
        },
        test::kNever);
    balance = recorder.metrics().energy_balance;
    flow = recorder.metrics().energy_flow;
    notes = simulation.assembly().notes;
  }
  std::vector<double> column(const std::string& name) const {
    const auto at = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    std::vector<double> out;
    for (const std::vector<double>& row : rows) out.push_back(row.at(at));
    return out;
  }
  double last(const std::string& name) const { return column(name).back(); }

  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;
  double balance = 0.0, flow = 0.0;  // [J]
  std::vector<std::string> notes;
};

// --- Scales.

// A lander of length L, on three balls, thrown and spinning onto rough ground under the same gravity: times grow with sqrt(L),
// masses with L^3, so that angles are the same in any size.
TEST(Scales, OfALanderDoNotChangeItsAttitude) {
  const auto yaw = [](double L) {
    const double T = std::sqrt(L), m = 100.0 * L * L * L, V = L / T;
    std::string scene = "end_time = " + text(3.0 * T) + "\ngravity = [0, 0, -1.62]\n" +
                        body("hull", m, 20.0 * L * L * L * L * L, "[0, 0, " + text(0.6 * L) + "]");
    for (int k = 0; k < 3; ++k) {
      const double a = 2.0 * kPi * k / 3.0;
      const std::string name = "foot_" + std::to_string(k);
      const std::string place = "[" + text(L * std::cos(a)) + ", " + text(L * std::sin(a)) + ", 0]";
      scene += "[[bodies]]\nname = \"" + name + "\"\nmass = " + text(0.02 * m) +
               "\nshape = { kind = \"sphere\", centre = " + place + ", radius = " + text(0.1 * L) +
               " }\n[[joints]]\nname = \"leg_" + std::to_string(k) + "\"\ntype = \"fixed\"\nbodies = [\"hull\", \"" +
               name + "\"]\npoint = " + place + "\n[[boundaries]]\nbody = \"" + name + "\"\nsurface = {}\n";
    }
    scene += "[ground]\nkind = \"plane\"\n[ground.plane]\nstiffness = " + text(2e5 * m / 100.0 * std::pow(L, -1.5)) +
             "\ndamping = " + text(1.0 / V) + "\nfriction = 0.4\n[initial]\nclearance = " + text(0.01 * L) +
             "\nvelocity = [" + text(0.5 * V) + ", 0, " + text(-0.5 * V) + "]\nangular_velocity = [0, 0, " +
             text(0.5 / T) + "]\n[output]\ninterval = " + text(0.5 * T) +
             "\n[solver]\nrtol = 1e-7\natol = " + text(1e-9 * L) + "\nmax_step = " + text(1e-3 * T) + "\n";
    return Rows(scene).last("hull.yaw");
  };
  const double metres = yaw(1.0);
  EXPECT_GT(std::abs(metres), 0.02);
  // Errors of integration alone; velocities have their tolerance in m/s.
  EXPECT_NEAR(yaw(1e-3), metres, 1e-3 * std::abs(metres));
  EXPECT_NEAR(yaw(1e3), metres, 1e-3 * std::abs(metres));
}

// --- Stiff springs.

// A point mass on a stiff spring swings as a pendulum: z = -sin(angle), from the integral of energy, to some ten tolerances.
TEST(StiffSpring, SwingsAsAPendulum) {
  const auto pendulum = [](double t_end) {  // angle below the horizontal: q'' = g cos q
    double q = 0.0, w = 0.0;
    const int steps = 20000;
    const double h = t_end / steps, g = 9.81;
    for (int i = 0; i < steps; ++i) {  // Runge and Kutta's fourth order
      const double k1 = g * std::cos(q), k2 = g * std::cos(q + 0.5 * h * w);
      const double k3 = g * std::cos(q + 0.5 * h * w + 0.25 * h * h * k1);
      const double k4 = g * std::cos(q + h * w + 0.5 * h * h * k2);
      q += h * w + h * h * (k1 + k2 + k3) / 6.0;
      w += h * (k1 + 2.0 * k2 + 2.0 * k3 + k4) / 6.0;
    }
    return q;
  };
  for (const double stiffness : {1e8, 1e10, 1e12}) {
    const std::string scene = "end_time = 2.0\ngravity = [0, 0, -9.81]\n" + body("a", 1.0, 0.01, "[1, 0, 0]") +
                              "[[struts]]\nname = \"s\"\nbodies = [\"ground\", \"a\"]\npoints = [[0, 0, 0], [1, 0, "
                              "0]]\nspring = { stiffness = " +
                              text(stiffness) + ", free_length = 1.0 }\n[output]\ninterval = 0.2\n";
    const Rows run(scene);
    const std::vector<double> t = run.column("time"), x = run.column("a.x"), z = run.column("a.z");
    for (std::size_t i = 1; i < t.size(); ++i) {
      const double q = pendulum(t[i]),
                   tolerance = 2e-4 + 100.0 / stiffness;  // some 100 steps of rtol, and the spring's stretch
      EXPECT_NEAR(x[i], std::cos(q), tolerance) << stiffness << " " << t[i];
      EXPECT_NEAR(z[i], -std::sin(q), tolerance) << stiffness << " " << t[i];
    }
  }
}

}  // namespace
}  // namespace footfall
