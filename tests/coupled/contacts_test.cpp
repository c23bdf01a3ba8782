// Contacts of single grains with a coupled body: closed forms, published tests.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <vector>

#include "tests/coupled/coupled_run.h"
#include "tests/coupled/two_mass.h"

namespace footfall::test {
namespace contacts {

// A body of known motion equation on one grain in real LIGGGHTS: closed forms and observed orders.

std::string text(double value) {
  std::ostringstream s;
  s.precision(17);
  s << value;
  return s.str();
}

// A flat-faced free body dropped on one fixed elastic grain.

struct Drop {
  static constexpr double m = 1.0, v = 0.5, R = 0.02;  // body [kg, m/s], grain radius [m]
  static double E() {                                  // E* of soil (35 MPa, 0.25) against steel (207 GPa, 0.1) [Pa]
    return 1.0 / ((1.0 - 0.25 * 0.25) / 35e6 + (1.0 - 0.1 * 0.1) / 207e9);
  }
  // Hertz: F = 4/3 E* sqrt(R) d^(3/2); energy 1/2 m v^2 = 8/15 E* sqrt(R) d^(5/2).
  static double overlap() { return std::pow(15.0 * m * v * v / (16.0 * E() * std::sqrt(R)), 0.4); }
  static double force() { return 4.0 / 3.0 * E() * std::sqrt(R) * std::pow(overlap(), 1.5); }
  static double duration() { return 2.9432750 * overlap() / v; }
};

// Windows of n substeps; returns the partner's table. The face starts 0.25 mm above the grain.
Table drop(const std::string& name, double dt, int n, double until, std::string* partner_says = nullptr) {
  const RunFolder folder("drop_" + name);
  write_stl((folder.path() / "body.stl").string(), box({0.1, 0.1, 0.05}, 1));
  const double gap = 2.5e-4;
  // The grain is integrated by nobody: it stands still.
  folder.write("in",
               script_head("-0.1 0.1 -0.1 0.1 -0.1 0.1", "* * *", dt) +
                   "create_atoms 1 single 0.011 -0.007 -0.02 units box\nset group all diameter 0.04 density 2600\n"
                   "fix e all property/global coefficientRestitution peratomtypepair 2 1.0 1.0 1.0 1.0\n"
                   "fix geo all couple/mbd/geometry body pad\nfix m all mesh/surface fix geo type 2\n" +
                   mesh_wall() + "fix mbd all couple/mbd every " + std::to_string(n) + " mesh m pad\n" +
                   "thermo 100000\nrun " + std::to_string(std::lround(until / dt)) + "\n");
  std::string script = folder.read("in");
  const std::size_t first = script.find("fix m3 ");  // the restitution of the bed
  script.erase(first, script.find('\n', first) + 1 - first);
  folder.write("in", script);
  const Outcome outcome = folder.coupled(1, "-in in",
                                         "until " + text(until) + " out table.csv body pad body.stl 0 0 " +
                                             text(0.025 + gap) + " free 1.0 0 0 0 " + text(-Drop::v) + " 0 0 0");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  if (partner_says != nullptr) *partner_says = outcome.text;
  return Table(folder.path() / "table.csv");
}

TEST(HertzDrop, ForceOverlapAndDurationAreThoseOfTheClosedForm) {
  const double dt = 5e-6;
  const Table table = drop("closed_form", dt, 2, 0.0085);
  double force = 0.0, overlap = 0.0, first = -1.0, last = 0.0;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    force = std::max(force, table["fz"][k]);
    overlap = std::max(overlap, table["overlap"][k] * Drop::R);
    if (table["contacts"][k] > 0) {
      if (first < 0.0) first = table["time"][k];
      last = table["time"][k] + 2 * dt;
    }
  }
  std::printf("force %.5g N (closed form %.5g), overlap %.5g mm (%.5g), duration %.5g ms (%.5g)\n", force,
              Drop::force(), 1e3 * overlap, 1e3 * Drop::overlap(), 1e3 * (last - first), 1e3 * Drop::duration());
  EXPECT_NEAR(force, Drop::force(), 0.005 * Drop::force());
  EXPECT_NEAR(overlap, Drop::overlap(), 0.005 * Drop::overlap());
  EXPECT_NEAR(last - first, Drop::duration(), 0.005 * Drop::duration());
  // Restitution 1: it leaves as fast as it came.
  EXPECT_NEAR(table["vz"].back(), Drop::v, 0.001 * Drop::v);
}

TEST(HertzDrop, IsOfSecondOrderInTheWindow) {
  const double dt = 5e-6, until = 4.8e-3;  // in mid-contact
  const auto state = [&](int n) {
    std::string said;
    drop("order_" + std::to_string(n), dt, n, until, &said);
    const std::size_t at = said.find("body pad at");
    double x = 0, y = 0, z = 0, vx = 0, vy = 0, vz = 0;
    EXPECT_EQ(std::sscanf(said.c_str() + at, "body pad at %lf %lf %lf velocity %lf %lf %lf", &x, &y, &z, &vx, &vy, &vz),
              6);
    return Eigen::Vector2d(z / Drop::overlap(), vz / Drop::v);
  };
  const Eigen::Vector2d reference = state(1);
  const double coarse = (state(80) - reference).norm(), fine = (state(40) - reference).norm();
  std::printf("error %.3g at n = 80, %.3g at n = 40: order %.2f\n", coarse, fine, std::log2(coarse / fine));
  EXPECT_GE(std::log2(coarse / fine), 1.9);
}

TEST(HertzDrop, ReportsTheContactStiffness) {
  // 2 E* sqrt(R d), at the deepest point 3/2 F / d.
  const Table table = drop("stiffness", 5e-6, 2, 0.0045);
  double stiffness = 0.0;
  for (std::size_t k = 0; k < table.rows(); ++k) stiffness = std::max(stiffness, table["stiffness"][k]);
  EXPECT_NEAR(stiffness, 1.5 * Drop::force() / Drop::overlap(), 0.005 * stiffness);
}

constexpr double kRestitution = 0.4;  // of soil on steel in script_head
constexpr double kSpeed = 0.2;        // of the grain [m/s]

double grain_mass() { return 2600.0 * 4.0 / 3.0 * M_PI * std::pow(0.02, 3); }

// Of a Hertz contact whose damping takes `larger` times the effective mass: beta grows by the root,
//   beta = ln e / sqrt(ln^2 e + pi^2),   e = exp(pi beta / sqrt(1 - beta^2)).
double restitution(double larger) {
  const double log_e = std::log(kRestitution);
  const double beta = log_e / std::sqrt(log_e * log_e + M_PI * M_PI) * std::sqrt(larger);
  return std::exp(M_PI * beta / std::sqrt(1.0 - beta * beta));
}

// The grain flies up against a plate of `masses` grains, in windows of one step. Relative speed after over before.
double found(const std::string& name, double masses, const std::string& words) {
  const RunFolder folder("pair_mass_" + name + "_" + std::to_string(static_cast<int>(masses)));
  write_stl((folder.path() / "body.stl").string(), box({0.1, 0.1, 0.05}, 1));
  const double dt = 5e-6, gap = 1e-5;
  const int steps = 2600;  // the contact lasts 8 ms
  std::ostringstream in;
  in.precision(17);
  in << script_head("-0.2 0.2 -0.2 0.2 -0.2 0.2", "* * *", dt) << "create_atoms 1 single 0.011 -0.007 " << -0.02 - gap
     << " units box\nset group all diameter 0.04 density 2600\nvelocity all set 0 0 " << kSpeed
     << "\nfix integr all nve/sphere\nfix geo all couple/mbd/geometry body pad\nfix m all mesh/surface fix geo type 2\n"
     << "fix wm all wall/gran model hertz tangential history mesh n_meshes 1 meshes m\n"
     << "fix mbd all couple/mbd every 1 " << words << " mesh m pad\n"
     << dump_every(steps, "grains") << "thermo 1000\nrun " << steps << "\n";
  folder.write("in", in.str());
  std::ostringstream partner;
  partner.precision(17);
  partner << "until " << steps * dt << " out table.csv body pad body.stl 0 0 0.025 free " << masses * grain_mass()
          << " 0 0 0 0 0 0 0";
  const Outcome outcome = folder.coupled(1, "-in in", partner.str());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  const Table table(folder.path() / "table.csv");
  EXPECT_EQ(table["contacts"].back(), 0.0) << "the contact continues";
  const double grain = read_dump(folder.read("grains." + std::to_string(steps))).at(0)[6];
  return (table["vz"].back() - grain) / kSpeed;
}

class Masses : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(OfTheBody, Masses, testing::Values(1.0, 2.0, 5.0, 10.0));

// LIGGGHTS' damping gives the restitution of the script within 3e-3 (docs/data/wall_tests.txt, test 3); the windows of one
// step are of the same order.
constexpr double kSteps = 5e-3;

TEST_P(Masses, OfThePairGiveTheRestitutionOfTheScript) {
  const double e = found("pair", GetParam(), "damping_mass pair");
  std::printf("body of %g grains: restitution %.4f, given %.4f\n", GetParam(), e, kRestitution);
  EXPECT_NEAR(e, kRestitution, kSteps);
}

TEST_P(Masses, OfTheGrainAloneDampAsStockDoes) {
  const double larger = 1.0 + 1.0 / GetParam();
  const double e = found("grain", GetParam(), "");
  std::printf("body of %g grains: restitution %.4f, by closed form %.4f\n", GetParam(), e, restitution(larger));
  EXPECT_NEAR(e, restitution(larger), kSteps);
}

// The wall tests of Chung and Ooi (Granular Matter 13, 643, 2011; their numbers 2 to 6): one sphere strikes a rigid
// plane, here a mesh that is coupled to a body at rest, and leaves as Hertz, Coulomb and Newton say.
//
// Materials, sizes and speeds: tests 2 to 4 as in Yade (examples of the same name by Angelidakis, Chareyre and Caulk,
// yade-dev/trunk), 5 and 6 as in Kratos (DEM_application, basic_benchmarks, benchmark5DEM.mdpa and benchmark6DEM.mdpa) and, test 5,
// in PySPH's examples of these tests; Kratos has the same values for 2 to 4.
//
// With FOOTFALL_WALL_TESTS=FILE the rows of docs/data/wall_tests.txt are appended to FILE (docs/data/remake/wall_tests.sh).

using Eigen::Vector3d;

constexpr double kRigid = 1000.0;  // the plane is so much stiffer than the sphere, as in Yade

struct Sphere {
  const char* material;
  double young, poisson, density, radius;  // [Pa], [-], [kg/m3], [m]
  double mass() const { return density * 4.0 / 3.0 * M_PI * std::pow(radius, 3); }
  double inertia() const { return 0.4 * mass() * radius * radius; }
  double K() const {  // F = K s^1.5
    return 4.0 / 3.0 * young / (1.0 + 1.0 / kRigid) / (1.0 - poisson * poisson) * std::sqrt(radius);
  }
};
// The numbers of the tests that use them.
const Sphere kAlloy2{"aluminium alloy", 70e9, 0.30, 2699, 0.1};
const Sphere kMagnesium2{"magnesium alloy", 40e9, 0.35, 1800, 0.1};
const Sphere kOxide34{"aluminium oxide", 380e9, 0.23, 4000, 0.0025};
const Sphere kCastIron3{"cast iron", 100e9, 0.25, 7000, 0.0025};
const Sphere kAlloy4{"aluminium alloy", 70e9, 0.33, 2700, 0.0025};
const Sphere kSteel5{"steel", 208e9, 0.30, 7850, 1e-5};
const Sphere kPolyethylene5{"polyethylene", 1e9, 0.40, 1400, 1e-5};
const Sphere kAlloy6{"aluminium alloy", 70e9, 0.33, 2700, 0.1};

// Hertz: m s'' = -K s^1.5 from s' = v.
struct Hertz {
  double overlap, force, time;  // largest, largest, of the contact
};
Hertz hertz(const Sphere& sphere, double v) {
  const double s = std::pow(1.25 * sphere.mass() * v * v / sphere.K(), 0.4);
  return {s, sphere.K() * std::pow(s, 1.5), 2.943275 * s / v};
}

struct Throw {
  Vector3d v, omega = Vector3d::Zero();  // [m/s], [rad/s]
  double restitution = 1.0;
};
struct Outcomes {
  std::vector<Throw> after;
  Table table;  // of the plate, window by window
  double dt;    // [s]
};

// All spheres at once, side by side.
Outcomes strike(const std::string& name, const Sphere& s, double friction, const std::vector<Throw>& throws,
                const std::string& settings = "") {
  const RunFolder folder("wall_tests_" + name);
  const double spacing = 3.0 * s.radius, gap = 1e-6 * s.radius, half = 2.0 * s.radius;
  const double length = spacing * static_cast<double>(throws.size());
  double longest = 0.0;  // [s], of reaching the plane and of the contact
  for (const Throw& one : throws) longest = std::max(longest, gap / -one.v.z() + 2.5 * hertz(s, -one.v.z()).time);
  const double dt = longest / 2000.0;
  const int types = static_cast<int>(throws.size()) + 1;  // each sphere, and the plane: a pair has its restitution
  std::ostringstream in;
  in.precision(17);
  in << "atom_style granular\natom_modify map array\nboundary f f f\nnewton off\ncommunicate single vel yes\nunits si\n"
        "hard_particles yes\nprocessors 1 1 1\nregion reg block "
     << -half << " " << length + half << " " << -2 * half << " " << 2 * half << " " << -2 * half << " " << 2 * half
     << " units box\ncreate_box " << types << " reg\nneighbor " << 0.2 * s.radius << " bin\nneigh_modify delay 0\n";
  const auto by_type = [&](const char* what, double of_spheres, double of_plane) {
    in << "fix " << what << " all property/global " << what << " peratomtype";
    for (int t = 0; t < types; ++t) in << " " << (t + 1 < types ? of_spheres : of_plane);
    in << "\n";
  };
  by_type("youngsModulus", s.young, kRigid * s.young);
  by_type("poissonsRatio", s.poisson, s.poisson);
  in << "fix e all property/global coefficientRestitution peratomtypepair " << types;
  for (int i = 0; i < types; ++i)
    for (int j = 0; j < types; ++j)
      in << " "
         << (std::min(i, j) + 1 < types && std::max(i, j) + 1 == types
                 ? throws[static_cast<std::size_t>(std::min(i, j))].restitution
                 : 1.0);
  in << "\nfix f all property/global coefficientFriction peratomtypepair " << types;
  for (int i = 0; i < types * types; ++i) in << " " << friction;
  in << "\npair_style gran model hertz tangential history\npair_coeff * *\ntimestep " << dt << "\n";
  for (std::size_t i = 0; i < throws.size(); ++i) {
    in << "create_atoms " << i + 1 << " single " << spacing * (static_cast<double>(i) + 0.5) << " 0 " << s.radius + gap
       << " units box\ngroup g" << i << " type " << i + 1 << "\nset group g" << i << " diameter " << 2.0 * s.radius
       << " density " << s.density << "\nvelocity g" << i << " set " << throws[i].v[0] << " " << throws[i].v[1] << " "
       << throws[i].v[2] << "\nset group g" << i << " omegax " << throws[i].omega[0] << " omegay " << throws[i].omega[1]
       << " omegaz " << throws[i].omega[2] << "\n";
  }
  in << "fix integr all nve/sphere\nfix geo all couple/mbd/geometry body plate\nfix m all mesh/surface fix geo type "
     << types << "\nfix wm all wall/gran model hertz tangential history mesh n_meshes 1 meshes m" << settings << "\n"
     << "fix mbd all couple/mbd every 1 mesh m plate\n"
     << dump_every(2000, "grains") << "thermo 1000\nrun 2000\n";
  folder.write("in", in.str());
  Surface plate = box({length, 2.0 * half, half}, 1);
  plate.nodes.row(0).array() += 0.5 * length;
  plate.nodes.row(2).array() -= 0.5 * half;
  write_stl((folder.path() / "plate.stl").string(), plate);
  std::ostringstream partner;
  partner.precision(17);
  partner << "until " << 2000 * dt << " out table.csv body plate plate.stl 0 0 0 prescribed 0 0 0 0 0 0";
  const Outcome outcome = folder.coupled(1, "-in in", partner.str());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  Outcomes outcomes{{}, Table(folder.path() / "table.csv"), dt};
  for (const std::vector<double>& row : read_dump(folder.read("grains.2000")))
    outcomes.after.push_back({Vector3d(row[4], row[5], row[6]), Vector3d(row[7], row[8], row[9])});
  EXPECT_EQ(outcomes.after.size(), throws.size());
  return outcomes;
}

// A row of the page: what, where, closed form, found.
double compare(const std::string& test, const std::string& what, double closed, double found) {
  const double error = std::abs(found / closed - 1.0);
  std::printf("%s, %s: closed form %.6g, found %.6g, %.2g %%\n", test.c_str(), what.c_str(), closed, found,
              100 * error);
  if (const char* file = std::getenv("FOOTFALL_WALL_TESTS")) {
    char row[300];
    std::snprintf(row, sizeof row, "| %s | %s | %.6g | %.6g | %.2g |\n", test.c_str(), what.c_str(), closed, found,
                  100 * error);
    std::ofstream(file, std::ios::app) << row;
  }
  return error;
}
std::string value(const std::string& name, double x) {
  char text[80];
  std::snprintf(text, sizeof text, "%s = %.3g", name.c_str(), x);
  return text;
}

// Verlet's error of peak and duration at some 800 steps per contact, and the step in which a contact begins.
constexpr double kWallTest = 3e-3;
// Damping presses at once, by overlap^(1/4), and the tangential spring needs some way to follow: at e = 0.5 the sphere
// sticks at first, the less the faster it slides.
constexpr double kSticksAtFirst = 6e-3;

TEST(WallTests, Test2ElasticNormalImpact) {
  const double v = 0.2;
  for (const Sphere& sphere : {kAlloy2, kMagnesium2}) {
    const Hertz closed = hertz(sphere, v);
    const Outcomes found = strike("2", sphere, 0.0, {{Vector3d(0, 0, -v)}});
    double force = 0.0, overlap = 0.0, time = 0.0;
    for (std::size_t k = 0; k < found.table.rows(); ++k) {
      force = std::max(force, -found.table["fz"][k]);
      overlap = std::max(overlap, found.table["overlap"][k] * sphere.radius);
      time += found.table["contacts"][k] > 0.0 ? found.dt : 0.0;
    }
    const std::string test = std::string("2, ") + sphere.material + ", 0.2 m/s";
    EXPECT_LT(compare(test, "peak force [N]", closed.force, force), kWallTest);
    EXPECT_LT(compare(test, "largest overlap [m]", closed.overlap, overlap), kWallTest);
    EXPECT_LT(compare(test, "time of contact [s]", closed.time, time), kWallTest);
    EXPECT_LT(compare(test, "speed after [m/s]", v, found.after[0].v.z()), kWallTest);
  }
}

TEST(WallTests, Test3RestitutionIsTheOneGiven) {
  const double v = 3.9;
  std::vector<Throw> throws;
  for (const double e : {0.2, 0.4, 0.6, 0.8, 1.0}) throws.push_back({Vector3d(0, 0, -v), Vector3d::Zero(), e});
  for (const Sphere& sphere : {kOxide34, kCastIron3}) {
    const Outcomes found = strike("3", sphere, 0.0, throws);
    for (std::size_t i = 0; i < throws.size(); ++i) {
      const double e = throws[i].restitution;
      EXPECT_LT(compare(std::string("3, ") + sphere.material + ", 3.9 m/s", value("restitution at e", e), e,
                        found.after[i].v.z() / v),
                kWallTest);
    }
  }
}

// No pull at the end of a contact, and no friction beyond Coulomb's: LIGGGHTS' tangential damping exceeds it until the
// sphere slides (by 9 % of the impulse at e = 0.5).
const char* const kCoulomb = " limitForce on tangential_damping off";

// While a sphere slides all through the contact, friction gives mu times the normal impulse J = (1 + e) m v_n, with the
// restitution e that is found: along the plane J_t = mu J against the sliding, and the spin changes by J_t a / I. The arm
// a is shorter than the radius by half the overlap, as LIGGGHTS takes it; its mean over an elastic impulse,
//   int s F dt / int F dt = s_max B(1.4, 0.5) / B(1, 0.5),
// matters on polyethylene alone (1.1 %).
void expect_sliding(const std::string& test, const std::string& where, const Sphere& s, double mu, const Throw& before,
                    const Throw& after, double tolerance) {
  const double J_t = mu * s.mass() * (after.v.z() - before.v.z());
  const double slip = before.v.x() - s.radius * before.omega.y();  // of the point of contact
  const double side = slip > 0.0 ? 1.0 : -1.0;
  const double v = before.v.x() - side * J_t / s.mass();
  const double mean_overlap = std::beta(1.4, 0.5) / std::beta(1.0, 0.5) * hertz(s, -before.v.z()).overlap;
  const double omega = before.omega.y() + side * J_t * (s.radius - 0.5 * mean_overlap) / s.inertia();
  EXPECT_LT(compare(test, where + ": speed along the plane [m/s]", v, after.v.x()), tolerance);
  EXPECT_LT(compare(test, where + ": spin [rad/s]", omega, after.omega.y()), tolerance);
}

TEST(WallTests, Test4ObliqueImpactAtConstantSpeed) {
  const double speed = 3.9, mu = 0.092;
  std::vector<Throw> throws;
  const std::vector<double> angles = {40, 50, 60, 70, 80};  // from the normal [degrees]; below 35 the sphere sticks
  for (const double angle : angles) {
    const double a = angle * M_PI / 180.0;
    throws.push_back({speed * Vector3d(std::sin(a), 0, -std::cos(a)), Vector3d::Zero(), 0.98});
  }
  for (const Sphere& sphere : {kOxide34, kAlloy4}) {
    const Outcomes found = strike("4", sphere, mu, throws, kCoulomb);
    for (std::size_t i = 0; i < throws.size(); ++i)
      expect_sliding(std::string("4, ") + sphere.material + ", 3.9 m/s", value("degrees", angles[i]), sphere, mu,
                     throws[i], found.after[i], kWallTest);
  }
}

TEST(WallTests, Test5ObliqueImpactAtConstantNormalSpeed) {
  const double v_n = 5.0, mu = 0.3;
  std::vector<Throw> throws;
  for (const double v_t : {15.0, 20.0, 30.0, 50.0, 70.0})  // below 10 m/s the sphere sticks
    throws.push_back({Vector3d(v_t, 0, -v_n), Vector3d::Zero(), 1.0});
  for (const Sphere& sphere : {kSteel5, kPolyethylene5}) {
    const Outcomes found = strike("5", sphere, mu, throws, kCoulomb);
    for (std::size_t i = 0; i < throws.size(); ++i)
      expect_sliding(std::string("5, ") + sphere.material + ", 5 m/s down", value("m/s along", throws[i].v.x()), sphere,
                     mu, throws[i], found.after[i], kSticksAtFirst);
  }
}

TEST(WallTests, Test6NormalImpactWithSpin) {
  const double v_n = 0.2, mu = 0.4;
  std::vector<Throw> throws;
  for (const double omega : {-24.0, -12.0, 12.0, 18.0, 24.0})
    throws.push_back({Vector3d(0, 0, -v_n), Vector3d(0, omega, 0), 0.5});
  const Outcomes found = strike("6", kAlloy6, mu, throws, kCoulomb);
  for (std::size_t i = 0; i < throws.size(); ++i)
    expect_sliding("6, aluminium alloy, 0.2 m/s down", value("rad/s", throws[i].omega.y()), kAlloy6, mu, throws[i],
                   found.after[i], kSticksAtFirst);
}

}  // namespace contacts
}  // namespace footfall::test
