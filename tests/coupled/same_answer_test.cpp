#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>
#include <random>

#include "coupler/programs.h"
#include "mbd_solver/app/audit.h"
#include "tests/coupled/coupled_run.h"

namespace footfall::test {
namespace same_answer {

// The same answer, whatever should not matter: ranks and their grids, where the box is, a grain written one period
// away, a quarter turn, the mass of a driven body, units of length, mass and time, the order of bodies in scene and
// script. 200 seeded small scenes, 25 at a time side by side in one box, each a few dozen grains and one or two
// bodies; the loads of the first windows of contact agree to round-off. Ranks wait for each other at every mesh in every
// step: what needs several is done with the first nine of them.

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kSide = 5;  // so many scenes side by side in x and y
constexpr int kSideOnRanks = 3;
constexpr double kCell = 0.4;  // [m]
constexpr double kDt = 5e-5;   // [s]
constexpr int kEvery = 5, kWindows = 16;
// LIGGGHTS' `precision` of a mesh is a length: a contact that near to an inner edge of a flat face counts on both triangles.
constexpr double kMeshPrecision = 1e-8;  // [m], its default in the first world
// Of the largest load on the body. Places of 4 m are rounded by 4e-16 m, overlaps of 1e-4 m so by 1e-11 at the worst.
constexpr double kRoundOff = 1e-8;

struct TestBody {
  std::string name;
  Vector3d size, centre, v, w;  // [m], [m/s], [rad/s]
  bool driven;                  // by a prescribed motion; otherwise free
  double mass;                  // [kg]
};
struct TestGrain {
  Vector3d x, v, w;
  double diameter, density;
};

// What is run: many scenes in one box, and how it is written down.
struct World {
  Vector3d low = Vector3d(0, 0, -0.25), high = Vector3d::Zero();
  Vector3d gravity = Vector3d(0.2, -0.1, -9.81);
  std::string model, boundary = "p p f", processors = "1 1 1";
  int ranks = 1;
  double length = 1.0, mass = 1.0, time = 1.0;  // units: one metre is so many of them
  std::vector<TestBody> bodies;                 // in the order of the scene
  std::vector<int> script_order;                // of the bodies
  std::vector<TestGrain> grains;

  double velocity() const { return length / time; }
  double force() const { return mass * length / (time * time); }
  double pressure() const { return force() / (length * length); }
};

Vector3d random_vector(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> any(-size, size);
  const double x = any(random), y = any(random);
  return {x, y, any(random)};
}

// A block of grains that moves at one or two plates, some of which touch from the start.
void add_scene(unsigned seed, const Vector3d& centre, World& world) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const int bodies = 1 + static_cast<int>(random() % 2);
  for (int k = 0; k < bodies; ++k) {
    TestBody body;
    body.name = "b" + std::to_string(seed) + "_" + std::to_string(k);
    // One after the other: compilers differ in the order in which they evaluate arguments.
    const double width = 0.1 + 0.06 * unit(random), length = 0.1 + 0.06 * unit(random);
    body.size = Vector3d(length, width, 0.02);
    const double up = k == 0 ? -0.0302 : 0.1132 + 0.002 * unit(random);
    const double aside = 0.02 * unit(random), ahead = 0.02 * unit(random);
    body.centre = centre + Vector3d(ahead, aside, up);
    body.driven = random() % 2 == 0;
    body.v = Vector3d(0, 0, k == 0 ? 0.5 : -0.5) + random_vector(random, 0.4);
    body.w = body.driven ? Vector3d(0, 0, random_vector(random, 2.0).z()) : random_vector(random, 2.0);
    body.mass = 0.5 + 2.0 * unit(random);
    world.bodies.push_back(body);
  }
  const Vector3d drift = Vector3d(0, 0, bodies == 1 ? -1.0 : 0.0) + random_vector(random, 0.3);
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      for (int k = 0; k < 3; ++k) {
        TestGrain grain;
        grain.diameter = 0.034 + 0.006 * unit(random);
        grain.density = 2000.0 + 1000.0 * unit(random);
        grain.x = centre + Vector3d(0.041 * i, 0.041 * j, 0.041 * k) + random_vector(random, 4e-4);
        grain.v = drift + random_vector(random, 0.2);
        grain.w = random_vector(random, 5.0);
        world.grains.push_back(grain);
      }
}

World make_world(unsigned first_seed, int side, const std::string& model) {
  World world;
  world.model = model;
  world.high = Vector3d(side * kCell, side * kCell, 0.35);
  for (int k = 0; k < side * side; ++k)
    add_scene(first_seed + static_cast<unsigned>(k), Vector3d((k % side + 0.5) * kCell, (k / side + 0.5) * kCell, 0.0),
              world);
  world.script_order.resize(world.bodies.size());
  std::iota(world.script_order.begin(), world.script_order.end(), 0);
  return world;
}

std::string words(const Vector3d& v, const char* between = " ") {
  std::ostringstream s;
  s.precision(17);
  s << v.x() << between << v.y() << between << v.z();
  return s.str();
}

std::string data_file(const World& w) {
  std::ostringstream s;
  s.precision(17);
  s << "grains\n\n" << w.grains.size() << " atoms\n2 atom types\n";
  for (int c = 0; c < 3; ++c)
    s << w.length * w.low[c] << " " << w.length * w.high[c] << " "
      << "xyz"[c] << "lo "
      << "xyz"[c] << "hi\n";
  s << "\nAtoms\n\n";
  for (std::size_t i = 0; i < w.grains.size(); ++i)
    s << i + 1 << " 1 " << w.length * w.grains[i].diameter << " "
      << w.grains[i].density * w.mass / (w.length * w.length * w.length) << " " << words(w.length * w.grains[i].x)
      << "\n";
  s << "\nVelocities\n\n";
  for (std::size_t i = 0; i < w.grains.size(); ++i)
    s << i + 1 << " " << words(w.velocity() * w.grains[i].v) << " " << words(w.grains[i].w / w.time) << "\n";
  return s.str();
}

std::string script_of(const World& w) {
  std::ostringstream s;
  s.precision(17);
  s << "atom_style granular\natom_modify map array\nboundary " << w.boundary
    << "\nnewton off\ncommunicate single vel yes\nunits si\nhard_particles yes\nsoft_particles yes\nprocessors "
    << w.processors << "\nread_data grains.data\nneighbor " << 0.01 * w.length
    << " bin\nneigh_modify delay 0\nfix m1 all property/global youngsModulus peratomtype " << 35e6 * w.pressure() << " "
    << 207e9 * w.pressure()
    << "\nfix m2 all property/global poissonsRatio peratomtype 0.25 0.1\n"
       "fix m3 all property/global coefficientRestitution peratomtypepair 2 0.3 0.4 0.4 0.4\n"
       "fix m4 all property/global coefficientFriction peratomtypepair 2 0.44 0.3 0.3 0.3\n"
       "fix m5 all property/global coefficientRollingFriction peratomtypepair 2 0.2 0.1 0.1 0.1\n"
       "fix m6 all property/global coefficientRollingViscousDamping peratomtypepair 2 0.3 0.3 0.3 0.3\n"
       "fix m7 all property/global characteristicVelocity scalar "
    << 2.0 * w.velocity() << "\nfix m8 all property/global cohesionEnergyDensity peratomtypepair 2";
  for (int k = 0; k < 4; ++k) s << " " << 2e4 * w.pressure();
  s << "\npair_style gran model " << w.model << "\npair_coeff * *\ntimestep " << kDt * w.time
    << "\nfix grav all gravity " << w.gravity.norm() * w.length / (w.time * w.time) << " vector " << words(w.gravity)
    << "\nfix integr all nve/sphere\n";
  std::string meshes, pairs;
  for (const int k : w.script_order) {
    const std::string& name = w.bodies[static_cast<std::size_t>(k)].name;
    s << "fix g_" << name << " all couple/mbd/geometry body " << name << "\nfix m_" << name
      << " all mesh/surface fix g_" << name << " type 2 precision " << kMeshPrecision * w.length << "\n";
    meshes += " m_" + name;
    pairs += " &\n mesh m_" + name + " " + name;
  }
  s << "fix w all wall/gran model " << w.model << " mesh n_meshes " << w.bodies.size() << " meshes" << meshes
    << "\nfix mbd all couple/mbd every " << kEvery << pairs << "\nthermo 100000\nrun 1000000\n";
  return s.str();
}

std::string scene_of(const World& w) {
  std::ostringstream s;
  s.precision(17);
  const double H = kEvery * kDt * w.time;
  s << "end_time = " << kWindows * H << "\ngravity = [" << words(w.gravity * w.length / (w.time * w.time), ", ")
    << "]\n";
  std::string of_bodies;
  for (const TestBody& b : w.bodies) {
    s << "[[bodies]]\nname = \"" << b.name << "\"\nmass = " << b.mass * w.mass << "\nshape = { kind = \"box\", size = ["
      << words(b.size * w.length, ", ") << "], centre = [" << words(b.centre * w.length, ", ")
      << "] }\n[[boundaries]]\nbody = \"" << b.name << "\"\nsurface = {}\n";
    const Vector3d v = b.v * w.velocity(), turn = b.w / w.time;
    if (b.driven) {
      s << "[[joints]]\nname = \"j_" << b.name << "\"\nkind = \"prescribed\"\nbodies = [\"ground\", \"" << b.name
        << "\"]\npoint = [" << words(b.centre * w.length, ", ") << "]\naxis = \"z\"\naxis2 = \"x\"\n[joints.motion]\n";
      for (int c = 0; c < 3; ++c) s << "xyz"[c] << " = { polynomial = [0, " << v[c] << "] }\n";
      s << "rotation = { polynomial = [0, " << turn.z() << "] }\nhold_other_rotations = true\n";
    }
    std::ostringstream initial;
    initial.precision(17);
    initial << "[[initial.bodies]]\nbody = \"" << b.name << "\"\nvelocity = [" << words(v, ", ")
            << "]\nangular_velocity = [" << words(turn, ", ") << "]\n";
    of_bodies += initial.str();
  }
  s << "[ground]\nkind = \"particles\"\n[particles]\nscript = \"in.grains\"\nmax_time_step = 1\n[initial]\n"
    << of_bodies << "[solver]\nerror_control = false\nmax_step = " << H << "\nrtol = 1e-12\natol = 1e-14\n"
    << "[coupling]\nstop_on_energy_gain = false\nstop_on_chatter = false\n[output]\ninterval = " << kWindows * H
    << "\nplots = false\nvtk = false\n";
  return s.str();
}

// Loads of every body in every window, as the mechanism felt them: [F; T] in SI units of the first world.
using Loads = std::map<std::string, std::vector<Eigen::Matrix<double, 6, 1>>>;

Loads run(const World& w, const std::string& name) {
  const RunFolder folder("same_" + name);
  folder.write("grains.data", data_file(w));
  folder.write("in.grains", script_of(w));
  folder.write("scene.toml", scene_of(w));
  setenv(kAuditFolder, (folder.path() / "audit").string().c_str(), 1);
  const Outcome outcome = folder.mpirun("-np " + std::to_string(w.ranks) + " " + RunFolder::program("liggghts_mbd") +
                                            " -in in.grains -log log -screen none : -np 1 " +
                                            RunFolder::program("mbd_solver") + " scene.toml --quiet --out out",
                                        300);
  unsetenv(kAuditFolder);
  EXPECT_EQ(outcome.exit_code, 0) << name << ": " << outcome.text.substr(0, 2000);
  Loads loads;
  if (outcome.exit_code != 0) return loads;
  const MechanismAudit audit = read_mechanism_audit((folder.path() / "audit/mechanism.csv").string());
  for (std::size_t k = 1; k < audit.rows.size(); ++k)
    for (const auto& [body, load] : audit.rows[k].loads) {
      loads[body].emplace_back();
      loads[body].back() << load.F_W / w.force(), load.T_B / (w.force() * w.length);
    }
  std::filesystem::remove_all(folder.path());
  return loads;
}

// Largest difference of any load of any body, of its largest load; by which body.
std::pair<double, std::string> difference(const Loads& expected, const Loads& found, const Matrix3d& turn) {
  std::pair<double, std::string> worst{0.0, "-"};
  for (const auto& [body, loads] : expected) {
    const auto other = found.find(body);
    if (other == found.end() || other->second.size() != loads.size()) return {1.0, body + " (missing)"};
    double force = 0.0, moment = 0.0;
    for (const auto& load : loads) {
      force = std::max(force, load.head<3>().norm());
      moment = std::max(moment, load.tail<3>().norm());
    }
    for (std::size_t k = 0; k < loads.size(); ++k) {
      const double of_force = (turn * loads[k].head<3>() - other->second[k].head<3>()).norm() / std::max(force, 1e-300);
      const double of_moment =
          (turn * loads[k].tail<3>() - other->second[k].tail<3>()).norm() / std::max(moment, 0.01 * force + 1e-300);
      if (std::max(of_force, of_moment) > worst.first) worst = {std::max(of_force, of_moment), body};
    }
  }
  return worst;
}

struct Variant {
  const char* name;
  void (*change)(World&);
  bool turned = false;
};

const Matrix3d kQuarter = (Matrix3d() << 0, -1, 0, 1, 0, 0, 0, 0, 1).finished();  // about z, exact

void on(World& w, int ranks, const char* processors) {
  w.ranks = ranks;
  w.processors = processors;
}
void in_units(World& w, double length, double mass, double time) {
  w.length = length;
  w.mass = mass;
  w.time = time;
}
void move_all(World& w, const Vector3d& by) {
  w.low += by;
  w.high += by;
  for (TestBody& b : w.bodies) b.centre += by;
  for (TestGrain& g : w.grains) g.x += by;
}
void turn_all(World& w) {
  const Vector3d low = w.low, high = w.high;
  w.low = Vector3d(-high.y(), low.x(), low.z());
  w.high = Vector3d(-low.y(), high.x(), high.z());
  w.gravity = kQuarter * w.gravity;
  for (TestBody& b : w.bodies) {
    std::swap(b.size.x(), b.size.y());
    for (Vector3d* const v : {&b.centre, &b.v, &b.w}) *v = kQuarter * *v;
  }
  for (TestGrain& g : w.grains)
    for (Vector3d* const v : {&g.x, &g.v, &g.w}) *v = kQuarter * *v;
}
void shuffle_all(World& w) {
  std::mt19937 random(5);
  std::shuffle(w.bodies.begin(), w.bodies.end(), random);
  std::shuffle(w.script_order.begin(), w.script_order.end(), random);
}

const std::vector<Variant> kOnRanks = {
    {"two_ranks_in_x", [](World& w) { on(w, 2, "2 1 1"); }},
    {"two_ranks_in_y", [](World& w) { on(w, 2, "1 2 1"); }},
    {"three_ranks", [](World& w) { on(w, 3, "3 1 1"); }},
    {"four_ranks", [](World& w) { on(w, 4, "2 2 1"); }},
};
const std::vector<Variant> kVariants = {
    {"again", [](World&) {}},
    {"box_moved", [](World& w) { move_all(w, Vector3d(0.7123, -1.31, 0.05)); }},
    {"grains_a_period_away",
     [](World& w) {
       for (std::size_t i = 0; i < w.grains.size(); i += 3) w.grains[i].x.x() += w.high.x() - w.low.x();
     }},
    {"quarter_turn", turn_all, true},
    {"mass_of_driven_bodies",
     [](World& w) {
       for (TestBody& b : w.bodies) b.mass *= b.driven ? 7.0 : 1.0;
     }},
    {"centimetres_grams", [](World& w) { in_units(w, 100.0, 1000.0, 1.0); }},
    {"ten_metres_minutes", [](World& w) { in_units(w, 0.1, 0.37, 1.0 / 60.0); }},
    {"order_of_bodies", shuffle_all},
};

class SameAnswer : public testing::TestWithParam<std::pair<unsigned, const char*>> {};
class SameAnswerOnRanks : public SameAnswer {};
constexpr const char* kHertz = "hertz tangential history rolling_friction cdt";
constexpr const char* kCohesive = "hertz tangential history cohesion sjkr2 rolling_friction epsd2";
std::string seeds_name(const testing::TestParamInfo<std::pair<unsigned, const char*>>& one) {
  return "seeds_" + std::to_string(one.param.first);
}
INSTANTIATE_TEST_SUITE_P(Scenes, SameAnswer,
                         testing::Values(std::pair(1000U, kHertz), std::pair(1025U, kCohesive),
                                         std::pair(1050U, kHertz), std::pair(1075U, kCohesive),
                                         std::pair(1100U, kHertz), std::pair(1125U, kCohesive),
                                         std::pair(1150U, kHertz), std::pair(1175U, kCohesive)),
                         seeds_name);
INSTANTIATE_TEST_SUITE_P(Scenes, SameAnswerOnRanks,
                         testing::Values(std::pair(1000U, kHertz), std::pair(1025U, kCohesive)), seeds_name);

void expect_same(unsigned seed, const char* model, int side, const std::vector<Variant>& variants) {
  const World world = make_world(seed, side, model);
  const std::string name = std::to_string(seed) + "_" + std::to_string(side) + "_";
  const Loads expected = run(world, name + "base");
  int touched = 0;
  for (const auto& [body, loads] : expected)
    touched += std::any_of(loads.begin(), loads.end(), [](const auto& load) { return !load.isZero(0.0); }) ? 1 : 0;
  std::printf("seeds %u to %u: %zu bodies, %d touched, %zu grains\n", seed,
              seed + static_cast<unsigned>(side * side) - 1, expected.size(), touched, world.grains.size());
  EXPECT_GT(touched, 7 * static_cast<int>(expected.size()) / 10);
  for (const Variant& variant : variants) {
    World other = world;
    variant.change(other);
    const auto [worst, body] = difference(expected, run(other, name + variant.name),
                                          variant.turned ? kQuarter : Matrix3d(Matrix3d::Identity()));
    std::printf("%-24s %.1e of the largest load (%s)\n", variant.name, worst, body.c_str());
    std::fflush(stdout);
    EXPECT_LT(worst, kRoundOff) << variant.name << ": body " << body;
  }
}

TEST_P(SameAnswer, WhateverShouldNotMatter) { expect_same(GetParam().first, GetParam().second, kSide, kVariants); }
TEST_P(SameAnswerOnRanks, WhateverTheGrid) { expect_same(GetParam().first, GetParam().second, kSideOnRanks, kOnRanks); }

}  // namespace same_answer
}  // namespace footfall::test
