// Bodies that meet: what nothing holds ends the run; what the scene holds stays where it is.

#include "mbd_solver/session/collision_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "coupler/base/text.h"
#include "mbd_solver/session/simulation.h"
#include "tests/unit/coupling/loopback_grains.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

using test::LoopbackGrains;
using ::testing::AllOf;
using ::testing::HasSubstr;

const volatile std::sig_atomic_t kNever = 0;

// A cube of edge 0.2 m and 8 kg.
std::string cube(const std::string& name, const Eigen::Vector3d& at,
                 const std::string& more = "size = [0.2, 0.2, 0.2]") {
  const std::string place = "[" + number_text(at.x()) + ", " + number_text(at.y()) + ", " + number_text(at.z()) + "]";
  return "[[bodies]]\nname = \"" + name + "\"\nmass = 8.0\nshape = { kind = \"box\", centre = " + place + ", " + more +
         " }\n[[boundaries]]\nbody = \"" + name + "\"\nsurface = { element_size = 0.1 }\n";
}

std::string ball(const std::string& name, const Eigen::Vector3d& at, double radius = 0.1) {
  const std::string place = "[" + number_text(at.x()) + ", " + number_text(at.y()) + ", " + number_text(at.z()) + "]";
  return "[[bodies]]\nname = \"" + name + "\"\nmass = 2.0\nshape = { kind = \"sphere\", centre = " + place +
         ", radius = " + number_text(radius) + " }\n[[boundaries]]\nbody = \"" + name +
         "\"\nsurface = { element_size = 0.05 }\n";
}

std::string moves(const std::string& name, const std::string& velocity) {
  return "[[initial.bodies]]\nbody = \"" + name + "\"\nvelocity = " + velocity + "\n";
}

const std::string kWeightless = "end_time = 0.5\ngravity = [0, 0, 0]\n[output]\ninterval = 0.01\n";

struct Ended {
  std::string why;  // of the failure; empty: it came to its end
  double time = 0.0;
  State state;
  std::vector<std::string> notes;
  bool watched = false;
};

Ended run(const std::string& toml) {
  const Scene scene = SceneText().read(toml);
  Simulation simulation(scene, scene.end_time, nullptr);
  Ended end;
  try {
    simulation.run([](const Sample&) {}, kNever);
  } catch (const NumericalError& error) {
    end.why = error.what();
  }
  end.state = simulation.state();
  end.time = end.state.time;
  end.notes = simulation.assembly().notes;
  end.watched = simulation.collisions() != nullptr;
  return end;
}

TEST(CollisionWatch, BodiesThatNothingHoldsApartEndTheRun) {
  // 0.3 m between them at 1 m/s.
  const Ended end = run(kWeightless + cube("a", {0, 0, 0}) + cube("b", {0.5, 0.02, 0.01}) + moves("b", "[-1, 0, 0]"));
  EXPECT_THAT(end.why, AllOf(HasSubstr("\"a\""), HasSubstr("0.3"), HasSubstr("\"b\"")));
  EXPECT_NEAR(end.time, 0.3, 0.0101);
}

TEST(CollisionWatch, WhatPassesBetweenTwoRowsIsFound) {
  // A thin plate, and a small ball that needs 0.4 ms to pass it; rows are 10 ms apart.
  const Ended end = run(kWeightless + cube("plate", {0, 0, 0}, "size = [0.001, 0.4, 0.4]") +
                        ball("bullet", {1.0, 0.03, 0.02}, 0.01) + moves("bullet", "[-50, 0, 0]"));
  EXPECT_NE(end.why, "");
  EXPECT_LT(end.time, 0.031);
}

TEST(CollisionWatch, BodiesThatMissEachOtherAreNotStopped) {
  const Ended end = run(kWeightless + cube("a", {0, 0, 0}) + cube("b", {0.5, 0.202, 0}) + moves("b", "[-2, 0, 0]"));
  EXPECT_EQ(end.why, "");
  EXPECT_TRUE(end.watched);
}

// Two thin plates of 0.8 m that fly and spin in one plane. When they first cross comes from their exact distance every
// 0.1 ms; the watch tells at the next row. Most of the way the spheres around them tell enough.
TEST(CollisionWatch, SpinningPlatesMeetWhenTheirExactDistanceSays) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const Eigen::Vector3d half(0.4, 0.02, 0.1);
  Eigen::Matrix3Xd corners(3, 8);
  for (int i = 0; i < 8; ++i)
    corners.col(i) = half.cwiseProduct(Eigen::Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  std::vector<Eigen::Vector3i> faces;
  for (const int axis : {0, 1, 2}) {
    const int a = 1 << axis, b = 1 << ((axis + 1) % 3), c = 1 << ((axis + 2) % 3);
    for (const int side : {0, a}) {
      faces.emplace_back(side, side + b, side + b + c);
      faces.emplace_back(side, side + b + c, side + c);
    }
  }
  SurfaceModel plate(corners, faces);
  int met = 0;
  for (int k = 0; k < 24; ++k) {
    const double y = 0.5 * any(random), x = 1.2 + 0.3 * any(random);  // not as arguments, whose order is the compiler's
    const Eigen::Vector3d start(x, y, 0.0), velocity(-2.0, any(random), 0.0);
    const double spin_1 = 10.0 * any(random), spin_2 = 10.0 * any(random);  // [rad/s]
    double exact = 1.0;                                                     // [s]; later than the end: never
    for (double t = 0.0; t < 0.5; t += 1e-4) {
      const auto turn = [&](double spin) {
        return Eigen::AngleAxisd(spin * t, Eigen::Vector3d::UnitZ()).toRotationMatrix();
      };
      const Eigen::Matrix3d R_1 = turn(spin_1);
      if (gap_between(plate, plate, {R_1.transpose() * turn(spin_2), R_1.transpose() * (start + t * velocity)})
              .distance > 0.0)
        continue;
      exact = t;
      break;
    }
    const auto spins = [&](const std::string& name, const Eigen::Vector3d& v, double spin) {
      return moves(name, "[" + number_text(v.x()) + ", " + number_text(v.y()) + ", 0]") + "angular_velocity = [0, 0, " +
             number_text(spin) + "]\n";
    };
    const std::string size = "size = [0.8, 0.04, 0.2]";
    const Ended end = run(kWeightless + cube("a", {0, 0, 0}, size) + cube("b", start, size) +
                          spins("a", Eigen::Vector3d::Zero(), spin_1) + spins("b", velocity, spin_2));
    EXPECT_EQ(end.why.empty(), exact > 0.5) << k << ": exact " << exact << ", told " << end.time;
    if (end.why.empty()) continue;
    EXPECT_NEAR(end.time, exact, 0.0102) << k;
    ++met;
  }
  EXPECT_GT(met, 4);
  EXPECT_LT(met, 22);
}

TEST(CollisionWatch, PairsThatAreJoinedOverlapOrMayPassAreLeftOut) {
  const std::string two = kWeightless + cube("a", {0, 0, 0}) + cube("b", {0.15, 0, 0}) + moves("b", "[1, 0.5, 0]");
  const Ended overlap = run(two);
  EXPECT_EQ(overlap.why, "");
  EXPECT_FALSE(overlap.watched);
  EXPECT_THAT(overlap.notes, testing::Contains(HasSubstr("overlap")));
  const Ended joined = run(two +
                           "[[joints]]\nname = \"j\"\nkind = \"spherical\"\nbodies = [\"a\", \"b\"]\n"
                           "point = [0.1, 0, 0]\n");
  EXPECT_THAT(joined.notes, testing::Not(testing::Contains(HasSubstr("overlap"))));
  const Ended ignored = run(kWeightless + cube("a", {0, 0, 0}) + cube("b", {0.5, 0, 0}) + moves("b", "[-1, 0, 0]") +
                            "[[contacts]]\nbetween = [\"a\", \"b\"]\nignore = true\n");
  EXPECT_EQ(ignored.why, "");
  EXPECT_FALSE(ignored.watched);
}

TEST(CollisionWatch, IsNotMadeForOneBody) { EXPECT_FALSE(run(kWeightless + cube("a", {0, 0, 0})).watched); }

const std::string kLaw = "stiffness = 1e7\ndamping = 5.0\nfriction = 0.4\n";

TEST(BodyContact, BodiesThatTheSceneHoldsApartBounce) {
  const Ended end =
      run(kWeightless + cube("a", {0, 0, 0}) + ball("b", {0.5, 0.013, 0.021}) + moves("b", "[-2, 0, 0]") +
          "[[contacts]]\nbetween = [\"a\", \"b\"]\nstiffness = 1e7\nrestitution = 0.5\nimpact_speed = 2\n");
  EXPECT_EQ(end.why, "");
  const Eigen::Vector3d a = end.state.v.segment<3>(0), b = end.state.v.segment<3>(6);
  EXPECT_LT((8.0 * a + 2.0 * b - Eigen::Vector3d(-4.0, 0, 0)).norm(), 1e-12);
  EXPECT_GT(b.x() - a.x(), 0.5);
}

// A ball that bounces and spins away, and another that rolls off an edge: seen from them, the other body moves on no straight line.
TEST(BodyContact, WhetherABallComesAwayDoesNotDependOnRows) {
  const std::string table =
      "[[bodies]]\nname = \"table\"\nmass = 10\nshape = { kind = \"box\", size = [0.6, 0.4, 0.1], centre = [0, 0, "
      "-0.05] }\n"
      "[[boundaries]]\nbody = \"table\"\nsurface = { element_size = 0.02 }\n[[joints]]\nname = \"f\"\nkind = "
      "\"fixed\"\n"
      "bodies = [\"ground\", \"table\"]\npoint = [0, 0, 0]\n[[contacts]]\nbetween = [\"table\", \"ball\"]\nyoung_MPa = "
      "50\n"
      "contact_radius = 0.03\nrestitution = 0.3\nimpact_speed = 1\nfriction = 0.5\n";
  for (const double interval : {1e-2, 1e-3, 2e-4}) {
    const std::string head = "end_time = 0.08\n[output]\ninterval = " + number_text(interval) + "\n";
    const Ended bounced = run(head + table + ball("ball", {-0.1, 0.03, 0.1}, 0.03) + moves("ball", "[0.5, 0, -1]"));
    EXPECT_EQ(bounced.why, "") << interval;
    EXPECT_NEAR(bounced.state.v[6], 5.0 / 7.0 * 0.5, 2e-3) << interval;  // it leaves rolling
    const Ended rolled =
        run("end_time = 0.16\n[output]\ninterval = " + number_text(interval) + "\n" + table +
            "[[bodies]]\nname = \"ball\"\nmass = 0.03\nshape = { kind = \"sphere\", centre = [0.1, 0.03, "
            "0.01], radius = 0.01 }\n[[boundaries]]\nbody = \"ball\"\nsurface = {}\n" +
            moves("ball", "[1.5, 0, 0]") + "angular_velocity = [0, 150, 0]\n");
    EXPECT_EQ(rolled.why, "") << interval;
    EXPECT_NEAR(rolled.state.q[7], 0.1 + 1.5 * 0.16, 1e-3) << interval;
  }
}

TEST(BodyContact, AStackStaysAtRest) {
  const std::string law = "stiffness = 1e7\ndamping = 30.0\nfriction = 0.4\n";  // it sways for less than a second
  const Ended end =
      run("end_time = 2.0\n" + cube("low", {0, 0, 0.1}, "size = [0.3, 0.3, 0.2]") + cube("middle", {0.01, 0, 0.3}) +
          cube("top", {0.01, 0.005, 0.46}, "size = [0.12, 0.12, 0.12]") +
          "[ground]\nkind = \"plane\"\nplane = { stiffness = 1e7, damping = 30.0, friction = 0.4, bodies = "
          "[\"low\"] }\n[[contacts]]\nbetween = [\"low\", \"middle\"]\n" +
          law + "[[contacts]]\nbetween = [\"middle\", \"top\"]\n" + law);
  EXPECT_EQ(end.why, "");
  EXPECT_LT(end.state.v.cwiseAbs().maxCoeff(), 1e-6);  // [m/s], [rad/s]
  EXPECT_NEAR(end.state.q[7 + 2], 0.3, 1e-3);          // overlaps of some 1e-4 m in each gap
  EXPECT_NEAR(end.state.q[14 + 2], 0.46, 1e-3);
}

TEST(BodyContact, ABallInAFunnelOfFourPlanesComesToRestInItsMiddle) {
  std::string toml = "end_time = 4.0\n" + ball("ball", {0.05, -0.03, 0.3});
  for (const char* normal : {"[1, 0, 1]", "[-1, 0, 1]", "[0, 1, 1]", "[0, -1, 1]"})
    toml += std::string("[[contacts]]\nbetween = [\"ball\", \"plane\"]\nnormal = ") + normal + "\n" + kLaw;
  const Ended end = run(toml);
  EXPECT_EQ(end.why, "");
  const double depth = std::pow(2.0 * 9.81 / (4.0 * std::sqrt(0.5)) / 1e7, 2.0 / 3.0);
  // Friction may hold it a little off the middle.
  EXPECT_LT(end.state.q.head<2>().norm(), 1e-4);
  EXPECT_NEAR(end.state.q[2], (0.1 - depth) * std::sqrt(2.0), 1e-4);
  EXPECT_LT(end.state.v.head<3>().norm(), 1e-6);
}

// ---- walls of a script ----

constexpr double kSubstep = 1e-4;

Start with_floor() {
  Start start;
  start.dt = kSubstep;
  start.n = 10;
  start.bodies = {"ball"};
  StaticWall floor;
  floor.name = "floor";
  for (const Eigen::Vector3d& corner :
       {Eigen::Vector3d(-1, -1, 0), Eigen::Vector3d(1, -1, 0), Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(-1, -1, 0),
        Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(-1, 1, 0)})
    floor.corners.push_back(corner);
  start.walls.push_back(floor);
  return start;
}

struct OverAFloor {
  explicit OverAFloor(const std::string& more)
      : script(folder.write("in.grains",
                            "timestep 1e-4\nfix m all mesh/surface file m.stl type 1\nfix mbd all couple/mbd every 10 "
                            "mesh m ball\nrun 1\n")),
        scene(folder.read("end_time = 0.5\n" + ball("ball", {0.01, 0.02, 0.2}) +
                          "[ground]\nkind = \"particles\"\n[particles]\nscript = \"in.grains\"\n" + more)) {}
  SceneText folder;
  std::string script;
  Scene scene;
};

TEST(CollisionWatch, AStaticMeshOfTheScriptEndsTheRun) {
  const OverAFloor over("");
  LoopbackGrains grains(with_floor(), [](const Motion&, Load&) {});
  Simulation simulation(over.scene, over.scene.end_time, &grains.transport());
  try {
    simulation.run([](const Sample&) {}, kNever);
    ADD_FAILURE() << "it went through";
  } catch (const NumericalError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("\"ball\""), HasSubstr("floor")));
  }
  EXPECT_NEAR(simulation.state().time, std::sqrt(2.0 * 0.1 / 9.81), 2e-3);
}

TEST(BodyContact, AStaticMeshOfTheScriptHoldsABodyUntilItIsGone) {
  const OverAFloor over("[[contacts]]\nwalls = true\n" + kLaw);
  LoopbackGrains grains(with_floor(), [](const Motion& motion, Load& load) {
    if (motion.window == 399) load.gone_walls = {"floor"};
  });
  Simulation simulation(over.scene, over.scene.end_time, &grains.transport());
  double lowest = 1.0, at_400 = 0.0, force = 0.0;
  simulation.run(
      [&](const Sample& sample) {
        if (sample.window <= 400) lowest = std::min(lowest, sample.kinematics.of(0).r.z());
        if (sample.window != 400) return;
        at_400 = sample.kinematics.of(0).r.z();
        force = sample.contact[0].F_W.z();
      },
      kNever);
  EXPECT_GT(lowest, 0.095);
  EXPECT_NEAR(at_400, 0.1, 1e-3);
  EXPECT_GT(force, 0.0);
  EXPECT_LT(simulation.state().q[2], 0.06);  // it falls for 0.1 s
  EXPECT_EQ(grains.join(), "");
  EXPECT_THAT(grains.accept().held_by_walls, testing::ElementsAre("ball"));
}

}  // namespace
}  // namespace footfall
