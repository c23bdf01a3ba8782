// Torsional springs and bushings turn a flexible body where their point is, not elsewhere: a clamped rod under the moment
// of a spring at x = p bends as theta(p) = M p / (EI), and the spring gives M = k (phi0 - theta(p)).

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "coupler/base/pi.h"
#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/run/settle.h"
#include "tests/physics/motion_of.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

constexpr double kYoung = 207e9, kThick = 0.02, kSpring = 1000.0, kTwist = 0.01;  // [Pa, m, N m/rad, rad]

// A rod of 1 m, clamped at x = 0, drawn so that its middle, and the node nearest to the drawing's origin, are elsewhere.
std::string clamped_rod(const std::string& spring) {
  return "end_time = 1\ngravity = [0, 0, 0]\n[materials.steel]\ndensity = 7850\nyoung_GPa = 207\n[[bodies]]\nname = "
         "\"rod\"\nmaterial = \"steel\"\nshape = { kind = \"rod\", from = [0, 0, 0], to = [1, 0, 0], diameter = 0.02 "
         "}\n"
         "flexible = { modes = 3, elements = 8 }\n[[joints]]\nname = \"clamp\"\ntype = \"fixed\"\nbodies = "
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

}  // namespace
}  // namespace footfall
