// Pulses of given functions of time, shorter than steps, in every notation: none is passed over.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "mbd_solver/session/simulation.h"
#include "tests/support/refused.h"
#include "tests/unit/scene/scene_text.h"
#include "tests/unit/session/never.h"

namespace footfall {
namespace {

constexpr double kPulsedMass = 2.0, kImpulse = 0.5;  // [kg], of each pulse [N s]

struct Pulse {
  double begin, width, force;  // [s], [s], [N]
};

std::string number(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

// In the first second, with widths from 1 us to 30 ms.
std::vector<Pulse> random_train(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> place(0.0, 1.0), decade(-6.0, -1.5);
  std::vector<Pulse> train;
  for (int i = 0; i < count; ++i) {
    const double width = std::pow(10.0, decade(random));
    train.push_back({(i + 0.05 + 0.8 * place(random)) / count, width, kImpulse / width});
  }
  return train;
}

// A body that slides along x, and what pushes it.
std::string scene_with(const std::string& pushed, const std::string& solver) {
  return "end_time = 1.1\ngravity = [0, 0, 0]\n[[bodies]]\nname = \"b\"\nmass = 2.0\ninertia = [0.1, 0.1, 0.1]\n"
         "position = [0, 0, 0]\n[[joints]]\nname = \"slide\"\nkind = \"prismatic\"\nbodies = [\"ground\", \"b\"]\n"
         "point = [0, 0, 0]\naxis = \"x\"\n" +
         pushed + "[solver]\n" + solver + "[output]\ninterval = 0.25\n";
}

std::string pushed_by_signal(const std::string& signal) {
  return signal +
         "[[forces]]\nname = \"f\"\nbody = \"b\"\ndirection = [1, 0, 0]\nframe = \"inertial\"\nforce = { signal = "
         "\"s\" }\n";
}
std::string expression(const std::string& text) {
  return "[[signals]]\nname = \"s\"\nkind = \"expression\"\ninput = \"" + text + "\"\n";
}

// A triangle of twice the height has the same impulse.
std::string triangles(const std::vector<Pulse>& train) {
  std::string rows = "[0, 0]";
  for (const Pulse& p : train)
    rows += ", [" + number(p.begin) + ", 0], [" + number(p.begin + 0.3 * p.width) + ", " + number(2.0 * p.force) +
            "], [" + number(p.begin + p.width) + ", 0]";
  return "[" + rows + "]";
}

template <class One>
std::string sum_of(const std::vector<Pulse>& train, const One& one) {
  std::string text;
  for (const Pulse& p : train) text += (text.empty() ? "" : " + ") + one(p);
  return text;
}

struct Notation {
  const char* name;
  std::string (*pushed)(const std::vector<Pulse>&);
};

const Notation kNotations[] = {
    {"table of a force",
     [](const std::vector<Pulse>& train) {
       return "[[forces]]\nname = \"f\"\nbody = \"b\"\ndirection = [1, 0, 0]\nframe = \"inertial\"\nforce = { table "
              "= " +
              triangles(train) + " }\n";
     }},
    {"command of a drive",
     [](const std::vector<Pulse>& train) {
       return "[[drives]]\nname = \"d\"\nkind = \"torque\"\njoint = \"slide\"\ncommand = { table = " +
              triangles(train) + " }\n";
     }},
    {"table of a signal",
     [](const std::vector<Pulse>& train) {
       return pushed_by_signal(
           "[[signals]]\nname = \"s\"\nkind = \"table\"\ninput = \"time\"\npoints = " + triangles(train) + "\n");
     }},
    {"comparisons",
     [](const std::vector<Pulse>& train) {
       return pushed_by_signal(expression(sum_of(train, [](const Pulse& p) {
         return "(time > " + number(p.begin) + " && time <= " + number(p.begin + p.width) + " ? " + number(p.force) +
                " : 0)";
       })));
     }},
    {"factors, together with a measurement",
     [](const std::vector<Pulse>& train) {
       return pushed_by_signal(expression("0 * b.vx + " + sum_of(train, [](const Pulse& p) {
                                            return "(abs(time - " + number(p.begin) + ") < " + number(0.5 * p.width) +
                                                   ") * " + number(p.force);
                                          })));
     }},
    {"lines of max and abs",
     [](const std::vector<Pulse>& train) {
       return pushed_by_signal(expression(sum_of(train, [](const Pulse& p) {
         return "max(0, 1 - abs(time - " + number(p.begin) + ") / " + number(p.width) + ") * " + number(p.force);
       })));
     }},
    {"states with events of time",
     [](const std::vector<Pulse>& train) {
       std::string text = "[[states]]\nname = \"off\"\n[[states]]\nname = \"on\"\n";
       for (std::size_t i = 0; i < train.size(); ++i) {
         const std::string name = std::to_string(i);
         text += "[[events]]\nname = \"on" + name + "\"\nfrom = [\"off\"]\nto = \"on\"\nwhen = \"time > " +
                 number(train[i].begin) + " && time < " + number(train[i].begin + train[i].width) + "\"\n";
         text += "[[events]]\nname = \"off" + name + "\"\nfrom = [\"on\"]\nto = \"off\"\nwhen = \"time > " +
                 number(train[i].begin + train[i].width) + " && time < " +
                 number(i + 1 < train.size() ? train[i + 1].begin : 2.0) + "\"\n";
       }
       // The force of the pulse that is on.
       return text + pushed_by_signal(expression("state.on * (" +
                                                 sum_of(train,
                                                        [](const Pulse& p) {
                                                          return "(abs(time - " + number(p.begin + 0.5 * p.width) +
                                                                 ") < " + number(p.width) + ") * " + number(p.force);
                                                        }) +
                                                 ")"));
     }},
};

double final_speed(const std::string& pushed, const std::string& solver) {
  const SceneText folder;
  const Scene scene = folder.read(scene_with(pushed, solver));
  Simulation simulation(scene, scene.end_time, nullptr);
  double speed = 0.0;
  simulation.run([&](const Sample& sample) { speed = sample.kinematics.of(0).dr.x(); }, test::kNever);
  return speed;
}

class PulseTrain : public testing::TestWithParam<int> {};

// Forces of lines and steps are integrated exactly between corners, by methods of order 2 and more; ida starts with two steps of
// first order.
TEST_P(PulseTrain, GivesItsImpulse) {
  const Notation& notation = kNotations[GetParam()];
  std::mt19937 random(static_cast<unsigned>(GetParam()) + 5);
  for (const char* max_step : {"1e-3", "0.04", "1.0"})
    for (const char* integrator : {"one_step", "ida"}) {
      const std::vector<Pulse> train = random_train(random, 6);
      const std::string solver = std::string("integrator = \"") + integrator + "\"\nmax_step = " + max_step + "\n";
      const double expected = 6.0 * kImpulse / kPulsedMass;
      EXPECT_NEAR(final_speed(notation.pushed(train), solver), expected, 1e-9 * expected)
          << notation.name << ", " << integrator << ", " << max_step << "\n"
          << notation.pushed(train);
    }
}

// x = 2 t. Two comparisons hold together for 0.1 ms, from t = 0.75005 s on, less than a step; then 10 N push 2 kg.
TEST(EventOfAWindow, IsFoundWithinAStep) {
  const std::string states =
      "[[states]]\nname = \"waits\"\n[[states]]\nname = \"pushes\"\n[[events]]\nname = \"e\"\nto = \"pushes\"\n";
  const std::string push = pushed_by_signal(expression("10 * state.pushes")) + "[initial]\nvelocity = [2, 0, 0]\n";
  const auto speed = [&](const std::string& when, const std::string& solver) {
    return final_speed(states + "when = \"" + when + "\"\n" + push, solver);
  };
  for (const char* max_step : {"1e-3", "1.0"})
    for (const char* integrator : {"one_step", "ida"}) {
      const std::string solver = std::string("integrator = \"") + integrator + "\"\nmax_step = " + max_step + "\n";
      for (const char* when : {"b.x > 1.5001 && b.x < 1.5003", "!(b.x < 1.5001 || 1.5003 < b.x)",
                               "slide.displacement > 1.5001 && (slide.displacement < 1.5003 && time > 0.2)"})
        EXPECT_NEAR(speed(when, solver), 2.0 + 5.0 * (1.1 - 0.75005), 1e-8) << when << ", " << solver;
      for (const char* never : {"b.x > 1.5003 && b.x < 1.5001", "b.x > 1.5001 && b.x < 1.5003 && time > 0.8"})
        EXPECT_NEAR(speed(never, solver), 2.0, 1e-8) << never << ", " << solver;
    }
}

// Curved pulses whose impulse is known.
struct CurvedPulse {
  const char* name;
  std::string (*text)(double centre, double width, double force);
  double (*impulse)(double width, double force);
};

const CurvedPulse kCurved[] = {
    {"bell",
     [](double c, double w, double f) {
       return number(f) + " * exp(-((time - " + number(c) + ") / " + number(w) + ")^2)";
     },
     [](double w, double f) { return f * w * std::sqrt(M_PI); }},
    {"two bells",
     [](double c, double w, double f) {
       const std::string x = "(time - " + number(c) + ") / " + number(w);
       return number(f) + " * (" + x + ")^2 * exp(-(" + x + ")^2)";
     },
     [](double w, double f) { return f * w * 0.5 * std::sqrt(M_PI); }},
    {"t^3 exp(-3 t)",
     [](double c, double w, double f) {
       const std::string x = "(time - " + number(c) + ") / " + number(w);
       return "time > " + number(c) + " ? " + number(f) + " * (" + x + ")^3 * exp(-3 * " + x + ") : 0";
     },
     [](double w, double f) { return f * w * 6.0 / 81.0; }},
    {"half a sine",
     [](double c, double w, double f) {
       const std::string x = "(time - " + number(c) + ") / " + number(w);
       return number(f) + " * max(0, (abs(" + x + ") < 1) * cos(1.5707963267948966 * " + x + "))";
     },
     [](double w, double f) { return f * w * 4.0 / M_PI; }},
    {"a power between zeros",
     [](double c, double w, double f) {
       const std::string x = "(time - " + number(c) + ") / " + number(w);
       return "abs(" + x + ") < 1 ? " + number(f) + " * (1 - (" + x + ")^2)^2 : 0";
     },
     [](double w, double f) { return f * w * 16.0 / 15.0; }},
};

class CurvedPulses : public testing::TestWithParam<int> {};

// one_step: the quadrature of its steps, whose ends are chosen for Radau IIA; its own has larger constants: 3.3e-9 at most of fifteen
// pulses. ida follows its own error test, which in the sum of all steps lets pass 1.2e-5 m/s.
TEST_P(CurvedPulses, GiveTheirImpulse) {
  const CurvedPulse& pulse = kCurved[GetParam()];
  std::mt19937 random(static_cast<unsigned>(GetParam()) + 17);
  std::uniform_real_distribution<double> place(0.3, 0.6), decade(-5.0, -1.5);
  for (const char* max_step : {"1e-3", "0.04", "1.0"})
    for (const bool one_step : {true, false}) {
      const double width = std::pow(10.0, decade(random)), centre = place(random);
      const std::string solver =
          std::string("integrator = \"") + (one_step ? "one_step" : "ida") + "\"\nmax_step = " + max_step + "\n";
      const double expected = pulse.impulse(width, kImpulse / width) / kPulsedMass;
      EXPECT_NEAR(final_speed(pushed_by_signal(expression(pulse.text(centre, width, kImpulse / width))), solver),
                  expected, one_step ? 1e-8 * expected : 5e-5)
          << pulse.name << ", width " << width << ", " << solver;
    }
}

INSTANTIATE_TEST_SUITE_P(EveryCurve, CurvedPulses, testing::Range(0, static_cast<int>(std::size(kCurved))));

INSTANTIATE_TEST_SUITE_P(EveryNotation, PulseTrain, testing::Range(0, static_cast<int>(std::size(kNotations))));

// Points that no step can tell apart: the run ends, and names them.
TEST(Tables, WithPointsAtOneInstantEndTheRun) {
  std::string rows = "[0, 0]";
  for (int i = 1; i < 25000; ++i) rows += ", [" + number(1e-18 * i) + ", " + std::to_string(i % 2) + "]";
  const Scene scene = SceneText().read(scene_with(
      "[[forces]]\nname = \"f\"\nbody = \"b\"\ndirection = [1, 0, 0]\nforce = { table = [" + rows + "] }\n", ""));
  Simulation simulation(scene, scene.end_time, nullptr);
  const std::string said = test::refusal<NumericalError>([&] { simulation.run([](const Sample&) {}, test::kNever); });
  EXPECT_TRUE(test::names(said, {"t = ", "forces.f.force", "E0674"}));
}

}  // namespace
}  // namespace footfall
