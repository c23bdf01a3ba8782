// Froude's identity: a run whose lengths, gravity, density and stiffness are scaled, time by sqrt(length / gravity) and
// stiffness by density * gravity * length, is the same run in its own units. No number of the code is a length or a time.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/dem/coupled_run.h"

namespace footfall::test {
namespace {

struct Scale {
  double length = 1.0, gravity = 1.0, density = 1.0;
  double time() const { return std::sqrt(length / gravity); }
  double speed() const { return std::sqrt(length * gravity); }
  double mass() const { return density * std::pow(length, 3); }
  double force() const { return mass() * gravity; }
  double pressure() const { return density * gravity * length; }
};

struct Result {
  std::vector<double> force;           // on the plate, over the unit of force
  std::vector<std::vector<double>> x;  // of the grains at the end, over the unit of length
};

// A plate falls on 75 grains that stand on a floor; all of it in the units of the scale.
Result run(const std::string& name, const Scale& s) {
  constexpr int kSteps = 600;
  constexpr double kStep = 5e-5;
  const RunFolder folder("froude_" + name);
  write_stl((folder.path() / "plate.stl").string(), box(s.length * Eigen::Vector3d(0.2, 0.2, 0.02), 2));
  std::ostringstream t;
  t.precision(17);
  const auto l = [&](double value) { return value * s.length; };
  t << "atom_style granular\natom_modify map array\nboundary f f f\nnewton off\ncommunicate single vel yes\nunits si\n"
       "hard_particles yes\nregion reg block "
    << l(-0.3) << " " << l(0.3) << " " << l(-0.3) << " " << l(0.3) << " " << l(-0.05) << " " << l(0.4)
    << " units box\ncreate_box 2 reg\nneighbor " << l(0.01) << " bin\nneigh_modify delay 0\n"
    << "fix m1 all property/global youngsModulus peratomtype " << 35e6 * s.pressure() << " " << 2e9 * s.pressure()
    << "\nfix m2 all property/global poissonsRatio peratomtype 0.25 0.1\n"
       "fix m3 all property/global coefficientRestitution peratomtypepair 2 0.3 0.4 0.4 0.4\n"
       "fix m4 all property/global coefficientFriction peratomtypepair 2 0.44 0.3 0.3 0.3\n"
       "fix m5 all property/global coefficientRollingFriction peratomtypepair 2 0.2 0.1 0.1 0.1\n"
       "pair_style gran model hertz tangential history rolling_friction cdt\npair_coeff * *\ntimestep "
    << kStep * s.time() << "\nfix grav all gravity " << 9.81 * s.gravity
    << " vector 0 0 -1\nfix floor all wall/gran model hertz tangential history rolling_friction cdt primitive type 1 "
       "zplane 0.0\n";
  for (int k = 0; k < 75; ++k)  // somewhat off a lattice
    t << "create_atoms 1 single " << l(0.041 * (k % 5 - 2) + 0.002 * (k / 25) * std::sin(k)) << " "
      << l(0.041 * (k / 5 % 5 - 2) + 0.002 * (k / 25) * std::cos(3.0 * k)) << " " << l(0.0199 + 0.0398 * (k / 25))
      << " units box\n";
  t << "set group all diameter " << l(0.04) << " density " << 2600.0 * s.density
    << "\nfix integr all nve/sphere\nfix m all mesh/surface file plate.stl type 2 precision " << l(1e-8) << " move 0 0 "
    << l(0.131) << "\n"
    << mesh_wall() << "fix mbd all couple/mbd every 5 gravity script mesh m plate\nthermo 100000\n"
    << dump_every(kSteps, "grains") << "run " << kSteps << "\n";
  folder.write("in", t.str());
  std::ostringstream p;
  p.precision(17);
  p << "until " << kSteps * kStep * s.time() << " out table.csv body plate plate.stl 0 0 " << l(0.131) << " free "
    << 3.0 * s.mass() << " 0 " << 0.1 * s.speed() << " 0 " << -1.0 * s.speed() << " 0 0 0";
  const Outcome outcome = folder.coupled(1, "-in in -log log", p.str());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  Result result;
  const Table table(folder.path() / "table.csv");
  for (std::size_t k = 0; k < table.rows(); ++k) result.force.push_back(table["fz"][k] / s.force());
  for (const auto& grain : read_dump(folder.read("grains." + std::to_string(kSteps))))
    result.x.push_back({grain[1] / s.length, grain[2] / s.length, grain[3] / s.length});
  return result;
}

TEST(Froude, ScaledRunsAreOneRunInTheirOwnUnits) {
  const Result one = run("one", {}), other = run("other", {3.0, 1.6, 0.8});
  ASSERT_EQ(one.force.size(), other.force.size());
  ASSERT_EQ(one.x.size(), 75u);
  ASSERT_EQ(other.x.size(), 75u);
  double most = 0.0, force = 0.0, place = 0.0;
  for (const double f : one.force) most = std::max(most, std::abs(f));
  for (std::size_t k = 0; k < one.force.size(); ++k)
    force = std::max(force, std::abs(one.force[k] - other.force[k]) / most);
  for (std::size_t i = 0; i < one.x.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) place = std::max(place, std::abs(one.x[i][c] - other.x[i][c]) / 0.02);
  std::printf("largest force %.4g N; forces differ by %.1e of it, places by %.1e radii\n", most, force, place);
  EXPECT_GT(most, 100.0);
  EXPECT_LT(force, 1e-6);  // round-off of 600 steps, which collisions multiply
  EXPECT_LT(place, 1e-6);
}

}  // namespace
}  // namespace footfall::test
