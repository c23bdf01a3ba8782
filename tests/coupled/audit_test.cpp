// Balances of momentum over a whole run.
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "coupler/programs.h"
#include "coupler/schemes/registry.h"
#include "mbd_solver/app/audit.h"
#include "tests/coupled/coupled_run.h"
#include "tests/support/refused.h"

namespace footfall::test {
namespace audit {

// A seeded walk through contact models, schemes, ranks, periodic boxes and bodies: what the grains lose, the bodies, the
// walls and gravity get, to round-off, in every window of real LIGGGHTS.

constexpr double kDt = 5e-5;
constexpr int kSteps = 300;

struct Case {
  std::string model, boundary, processors, scheme, words;
  int ranks = 1, bodies = 1, every = 10;
  bool clumps = false;
};

std::string text_of(const Case& c) {
  return c.model + ", boundary " + c.boundary + ", ranks " + std::to_string(c.ranks) + " (" + c.processors +
         "), scheme " + c.scheme + ", bodies " + std::to_string(c.bodies) + ", every " + std::to_string(c.every) +
         (c.clumps ? ", clumps" : "");
}

template <std::size_t N>
const char* any_of(std::mt19937& random, const std::array<const char*, N>& all) {
  return all[random() % N];
}

Case draw(unsigned seed) {
  std::mt19937 random(seed);
  Case c;
  c.model = any_of(random, std::array{"hertz", "hertz", "hooke"});
  c.model += any_of(random, std::array{" tangential history", " tangential history", " tangential no_history"});
  c.model += any_of(random, std::array{"", " cohesion sjkr2"});
  c.model +=
      any_of(random, std::array{"", " rolling_friction cdt", " rolling_friction epsd", " rolling_friction epsd2"});
  c.boundary = any_of(random, std::array{"f f f", "f f f", "p f f", "f p f", "p p f"});
  c.ranks = 1 + static_cast<int>(random() % 2);
  c.processors = c.ranks == 1 ? "1 1 1" : any_of(random, std::array{"2 1 1", "1 2 1", "1 1 2"});
  c.scheme = scheme_names()[seed % scheme_names().size()];
  c.bodies = 1 + static_cast<int>(random() % 3);
  c.every = std::array{1, 5, 10, 25}[random() % 4];
  c.clumps = random() % 6 == 0;
  return c;
}

// A cloud of spinning grains falls on a static mesh, a floor and up to three bodies. Clumps are made of spheres that
// overlap, and multisphere comes after the walls: at the set-up of a run it knows the forces that stand before it.
std::string script(const Case& c) {
  std::string s = script_head("-0.3 0.3 -0.3 0.3 -0.3 0.3", c.processors, kDt);
  const auto replace = [&s](const std::string& old, const std::string& now) {
    s.replace(s.find(old), old.size(), now);
  };
  replace("boundary f f f", "boundary " + c.boundary);
  replace(
      "pair_style gran model hertz tangential history rolling_friction cdt",
      "soft_particles yes\nfix m6 all property/global coefficientRollingViscousDamping peratomtypepair 2 0.3 0.3 0.3 "
      "0.3\nfix m7 all property/global cohesionEnergyDensity peratomtypepair 2 1e4 2e4 2e4 2e4\nfix m8 all "
      "property/global characteristicVelocity scalar 2\npair_style gran model " +
          c.model);
  if (c.clumps) {
    s += "fix pts all particletemplate/multisphere 15485863 atom_type 1 density constant 2600 nspheres 2 ntry 100000 "
         "spheres 0 0 0 0.02 0.02 0 0 0.02 type 1\nfix pdd all particledistribution/discrete 15485867 1 pts 1.0\n"
         "region ins block -0.1 0.1 -0.1 0.1 -0.015 0.13 units box\nfix ins all insert/pack seed 32452843 "
         "distributiontemplate pdd vel constant 0.3 -0.2 -1.5 insert_every once overlapcheck yes all_in yes "
         "particles_in_region 40 region ins\n";
  } else {
    s += "lattice sc 0.041\nregion grains block -0.1 0.1 -0.1 0.1 0.0 0.15 units box\ncreate_atoms 1 region grains\n"
         "set group all diameter 0.04 density 2600\nvelocity all set 0.3 -0.2 -1.5\n"
         "displace_atoms all random 0.0004 0.0004 0.0004 15485863 units box\n";
  }
  s += "fix grav all gravity 9.81 vector 0.1 0.2 -1\nfix floor all wall/gran model " + c.model +
       " primitive type 1 zplane -0.045\nfix still all mesh/surface file still.stl type 2 move 0.12 0 -0.028\n";
  std::string meshes, pairs;
  for (int k = 0; k < c.bodies; ++k) {
    const std::string id = std::to_string(k);
    s += "fix m_" + id + " all mesh/surface file body.stl type 2 move " + std::array{"-0.05", "0.11", "-0.1"}[k] + " " +
         std::array{"0.0", "0.06", "-0.05"}[k] + " " + std::array{"-0.0295", "0.157", "0.156"}[k] + "\n";
    meshes += " m_" + id;
    pairs += " mesh m_" + id + " body_" + id;
  }
  // LIGGGHTS allows one such wall for all meshes.
  s += "fix w all wall/gran model " + c.model + " mesh n_meshes " + std::to_string(c.bodies + 1) + " meshes still" +
       meshes + "\n";
  s += c.clumps ? "fix integr all multisphere\nrun 1\nunfix ins\n" : "fix integr all nve/sphere\n";
  return s + "fix mbd all couple/mbd every " + std::to_string(c.every) + " gravity script" + pairs +
         "\nthermo 1000\nrun 105\nrun " + std::to_string(kSteps - 105) + "\n";
}

std::string partner(const Case& c) {
  std::string s = "until " + std::to_string(kSteps * kDt) + " scheme " + c.scheme;
  const std::array places{"-0.05 0.0 -0.0295", "0.11 0.06 0.157", "-0.1 -0.05 0.156"};
  const std::array motions{"prescribed 0.1 0.2 0.3 0.5 -1.0 2.0", "free 2.0 0 0 0 -2.5 0 0 0",
                           "free 0.5 1e4 0.2 0 -2.5 0 0 0"};
  for (int k = 0; k < c.bodies; ++k)
    s += " body body_" + std::to_string(k) + " body.stl " + places[static_cast<std::size_t>(k)] + " " +
         motions[static_cast<std::size_t>(k)];
  return s;
}

const AuditLine& line(const std::vector<AuditLine>& lines, const std::string& quantity) {
  for (const AuditLine& one : lines)
    if (one.quantity == quantity) return one;
  throw std::runtime_error("no line " + quantity);
}

std::vector<AuditLine> audited(const RunFolder& folder, const Case& c, const std::string& text) {
  write_stl((folder.path() / "body.stl").string(), box({0.2, 0.3, 0.02}, 2));
  write_stl((folder.path() / "still.stl").string(), box({0.12, 0.3, 0.02}, 2));
  folder.write("in", text);
  setenv(kAuditFolder, (folder.path() / "audit").string().c_str(), 1);
  const Outcome outcome = folder.coupled(c.ranks, "-in in -log log", partner(c));
  unsetenv(kAuditFolder);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  return audit_lines(read_grains_audit((folder.path() / "audit/grains.csv").string()), {});
}

class Walk : public testing::TestWithParam<unsigned> {};
constexpr unsigned kWalks = 6, kCases = 7;
INSTANTIATE_TEST_SUITE_P(Seeds, Walk, testing::Range(0U, kWalks));

TEST_P(Walk, WhatGrainsLoseBodiesWallsAndGravityGet) {
  for (unsigned k = 0; k < kCases; ++k) {
    const unsigned seed = 20240 + kCases * GetParam() + k;
    const Case c = draw(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + text_of(c));
    const RunFolder folder("walk_" + std::to_string(seed));
    const std::vector<AuditLine> lines = audited(folder, c, script(c));
    EXPECT_TRUE(audit_holds(lines)) << audit_table(lines);
    for (const char* const quantity :
         {"grains: linear momentum", "walls of bodies: linear impulse", "gravity: linear impulse",
          "load: impulse, summed and sent", "load: mean force, summed and sent", "load: mean moment, summed and sent"})
      EXPECT_EQ(line(lines, quantity).verdict, AuditVerdict::kHolds) << quantity;
    // Two periodic directions leave no component of it alone.
    EXPECT_EQ(line(lines, "grains: angular momentum").verdict,
              c.boundary == "p p f" ? AuditVerdict::kNotChecked : AuditVerdict::kHolds);
    std::printf("seed %u: %s: linear %.1e, angular %.1e of what flowed\n", seed, text_of(c).c_str(),
                line(lines, "grains: linear momentum").relative, line(lines, "grains: angular momentum").relative);
  }
}

TEST(AuditOfARun, ChangesNoBitOfIt) {
  const Case c = draw(7);
  const auto grains = [&](const std::string& name, bool audit) {
    const RunFolder folder(name);
    write_stl((folder.path() / "body.stl").string(), box({0.2, 0.3, 0.02}, 2));
    write_stl((folder.path() / "still.stl").string(), box({0.12, 0.3, 0.02}, 2));
    std::string text = script(c);
    folder.write("in", text.insert(text.find("thermo 1000"), dump_every(kSteps, "grains")));
    if (audit) setenv(kAuditFolder, (folder.path() / "audit").string().c_str(), 1);
    EXPECT_EQ(folder.coupled(c.ranks, "-in in -log log", partner(c)).exit_code, 0);
    unsetenv(kAuditFolder);
    EXPECT_EQ(folder.has("audit/grains.csv"), audit);
    return folder.read("grains." + std::to_string(kSteps));
  };
  EXPECT_TRUE(grains("audit_bits_with", true) == grains("audit_bits_without", false));
}

// LIGGGHTS hands clumps the forces that are there when the set-up comes to fix multisphere: forces of walls behind it are
// missing in the first half step, on stock LIGGGHTS too. The audit sees it, and the run warns.
TEST(AuditOfARun, SeesClumpsThatMissTheForcesOfWallsBehindThem) {
  Case c;
  c.model = "hertz tangential history";
  c.boundary = "f f f";
  c.processors = "1 1 1";
  c.scheme = "css-trapezoid";
  c.clumps = true;
  std::string text = script(c);
  const std::string late = "fix integr all multisphere\nrun 1\nunfix ins\n";
  text.erase(text.find(late), late.size());
  text.insert(text.find("fix grav"), late);
  const std::string from = "-0.015 0.13", deeper = "-0.03 0.13";  // pressed in when the run begins
  text.replace(text.find(from), from.size(), deeper);
  const RunFolder folder("audit_clumps_before_walls");
  const std::vector<AuditLine> lines = audited(folder, c, text);
  EXPECT_EQ(line(lines, "grains: linear momentum").verdict, AuditVerdict::kWrong) << audit_table(lines);
  EXPECT_TRUE(names(folder.read("output.txt"), {"fix integr (multisphere)"}));
}

}  // namespace audit
}  // namespace footfall::test
