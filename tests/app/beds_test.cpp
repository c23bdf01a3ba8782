// Beds of grains: made by numbers, as the same scripts taken over or written by hand; of every kind; of clumps. And what `check` reports of
// them and of the time that a run takes.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <regex>
#include <sstream>

#include "mbd_solver/assemble/grain_dump.h"
#include "mbd_solver/session/output/history.h"
#include "tests/app/programs.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;
using app::holds;

const std::string kPlateAndTine = R"(end_time = 0.03
[[bodies]]
name = "plate"
mass = 0.5
shape = { kind = "cylinder", centre = [0, 0, 0.01], radius = 0.04, length = 0.01 }
[[bodies]]
name = "tine"
mass = 0.1
shape = { kind = "capsule", from = [0.05, -0.03, 0.01], to = [0.05, 0.03, 0.01], diameter = 0.01 }
[[boundaries]]
body = "plate"
surface = { element_size = 0.02 }
[[boundaries]]
body = "tine"
beams = { radius = 0.005, points = [[0.05, -0.03, 0.01], [0.05, 0.03, 0.01]] }
[ground]
kind = "particles"
[initial]
velocity = [0, 0, -1]
[output]
plots = false
)";

// The landing on a bed that is poured in seconds.
const std::string kSmallLanding = R"(depth = 0.2
radius = 0.05
zones = [{ under = ["footpad_{leg}"], size = [0.4, 0.4], depth = 0.06, radius = 0.02 }]
[particles.box.pour]
settle_time = 0.05
)";

class Bed : public ::testing::Test {
 protected:
  const app::Folder folder{"bed"};
  // Its folder, as check reports it.
  std::string bed_of(const std::string& checked) const {
    std::smatch line;  // of one word
    return std::regex_search(checked, line, std::regex("\n  (\\S+)(\n|$)")) ? line[1].str() : "";
  }
  std::string history(const std::string& run) const { return folder.read(run + "/history.csv"); }
};

TEST_F(Bed, ByNumbersIsTheOneOfItsScripts) {
  constexpr double kDepth = 0.05, kX = 0.2, kY = 0.16;  // [m]
  folder.write("box.toml", kPlateAndTine + "[particles]\nranks = 1\n[particles.box]\nsize = [0.2, 0.16]\n" +
                               "depth = 0.05\nradius = [0.007, 0.009]\nexchange_steps = 3\n");
  folder.done("run box.toml --quiet --out box");
  const std::string checked = folder.done("check box.toml").text;
  const std::vector<GrainPlace> grains = read_grains(bed_of(checked) + "/bed.restart.grains");
  EXPECT_TRUE(holds(checked, " " + std::to_string(grains.size()) + " grains")) << checked;
  double top = -1.0, low = 1.0, mass = 0.0, small = 0.0, volume = 0.0;
  std::map<std::pair<int, int>, double> surface;  // highest point in cells of 2 cm
  for (const GrainPlace& g : grains) {
    const double z = g.centre.z(), r = g.radius, cube = r * r * r;
    top = std::max(top, z + r);
    low = std::min(low, z - r);
    mass += cube;
    small += r < 0.008 ? cube : 0.0;
    double& high =
        surface.try_emplace({int(g.centre.x() / 0.02 + 100), int(g.centre.y() / 0.02 + 100)}, -1.0).first->second;
    high = std::max(high, z + r);
    // The part of the sphere in the middle half of the bed.
    const double a = std::max(-0.75 * kDepth - z, -r), b = std::min(-0.25 * kDepth - z, r);
    if (b > a) volume += 3.14159265 * (r * r * (b - a) - (b * b * b - a * a * a) / 3);
  }
  double mean = 0.0;
  for (const auto& [cell, high] : surface) mean += high / static_cast<double>(surface.size());
  EXPECT_LT(top, 0.002) << "a quarter of a radius above the surface";
  EXPECT_GT(low, -kDepth - 0.001);
  EXPECT_GT(mean, -0.012) << "a radius and a half below the surface";
  // A loose bed of spheres has 0.54 to 0.60, less at walls, which are near everywhere in this one.
  EXPECT_NEAR(volume / (kX * kY * 0.5 * kDepth), 0.55, 0.07);
  EXPECT_NEAR(small / mass, 0.5, 0.1) << "the two radii share the mass";

  // The stored scripts in the place of the box.
  fs::copy(folder.file("box/script"), folder.file("script"), fs::copy_options::recursive);
  const std::string particles = folder.read("script/particles.toml");
  folder.write("taken.toml", kPlateAndTine + particles);
  folder.done("run taken.toml --quiet --out taken");
  EXPECT_TRUE(history("taken") == history("box"));
  EXPECT_TRUE(folder.read("taken/grains_energy.txt") == folder.read("box/grains_energy.txt"));

  // By hand: no variable but ${bed}, no loop, no include.
  std::smatch dt;
  ASSERT_TRUE(std::regex_search(particles, dt, std::regex("\ndt = \"(.*)\"")));
  const std::string model = " model hertz tangential history rolling_friction cdt ";
  const std::string hand = R"(atom_modify map array
newton off
communicate single vel yes
units si
hard_particles yes
processors * * 1
read_restart ${bed}
neighbor 0.0024 bin
neigh_modify delay 0
fix young    all property/global youngsModulus peratomtype 1e7 2e11
fix poisson  all property/global poissonsRatio peratomtype 0.3 0.3
fix restitution all property/global coefficientRestitution peratomtypepair 2 0.3 0.3 0.3 0.3
fix friction all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5
fix rolling  all property/global coefficientRollingFriction peratomtypepair 2 0.2 0.2 0.2 0.2
pair_style gran)" + model + "\npair_coeff * *\nfix floor all wall/gran" +
                           model + "primitive type 1 zplane -0.05\n" + "fix wall_x1 all wall/gran" + model +
                           "primitive type 1 xplane -0.1\nfix wall_x2 all wall/gran" + model +
                           "primitive type 1 xplane 0.1\nfix wall_y1 all wall/gran" + model +
                           "primitive type 1 yplane -0.08\nfix wall_y2 all wall/gran" + model +
                           "primitive type 1 yplane 0.08\ntimestep " + dt[1].str() + R"(
fix gravity all gravity 9.81 vector 0 0 -1
fix integrate all nve/sphere
fix geo all couple/mbd/geometry body plate
fix plate all mesh/surface fix geo type 2
fix touch all wall/gran)" + model +
                           "mesh n_meshes 1 meshes plate\nfix beam all wall/gran/beam" + model +
                           "type 2 body tine\nfix mbd all couple/mbd every 3 mesh plate plate\nrun 1000000000\n";
  folder.write("hand.in", hand);
  const std::string bed = particles.substr(particles.find("[particles.bed]"));
  const std::string by_hand = "[particles]\nscript = \"hand.in\"\nranks = 1\nsurface_height = 0\n" + bed;
  folder.write("hand.toml", kPlateAndTine + by_hand);
  folder.done("run hand.toml --quiet --out hand");
  EXPECT_TRUE(history("hand") == history("box"));
  EXPECT_GT(app::lines_of(history("box")), 20);

  // A mesh of the script, taken over as it is there: LIGGGHTS compares it with the scene's, triangle by triangle.
  folder.write("mesh.in", std::regex_replace(
                              std::regex_replace(hand, std::regex("fix geo all.*\n"), ""), std::regex("fix plate .*"),
                              "fix plate all mesh/surface file " + app::kInputs +
                                  "/reference/rock.stl type 2 scale 0.0005 rotate axis 1 1 0 angle 40 move 0 0 0.02"));
  std::string scene =
      std::regex_replace(kPlateAndTine, std::regex("surface = .*"), "surface = { from_script = \"plate\" }");
  scene = std::regex_replace(scene, std::regex("end_time = .*"), "end_time = 0.003");
  folder.write("mesh.toml", scene + std::regex_replace(by_hand, std::regex("hand.in"), "mesh.in"));
  folder.done("run mesh.toml --quiet --out mesh");
}

// The default landing by [particles.box] and by a script of LIGGGHTS, on one settled bed: the same bits.
TEST_F(Bed, OfTheLandingHasTheSameBitsUnderAScript) {
  const std::string options = " --quiet --until 0.006 --ranks 1 --set output.plots=false --out ";
  folder.write("box.toml",
               "base = \"" + app::kInputs + "/landing_mr\"\n[particles.box]\nsize = [3.2, 3.2]\n" + kSmallLanding);
  folder.done("run box.toml" + options + "box", 600);
  const std::string particles = folder.read("box/script/particles.toml");
  folder.write("script.toml", "base = \"" + app::kInputs + "/landing_script\"\n[particles]\nwithout = [\"bed\"]\n" +
                                  "surface_height = 0\nvariables = { floor = -0.2, centre = 0.8, width = 1.6 }\n" +
                                  std::regex_replace(particles.substr(particles.find("[particles.bed]")),
                                                     std::regex("\"script/"), "\"box/script/"));
  folder.done("run script.toml" + options + "script", 600);
  EXPECT_TRUE(history("script") == history("box"));
  EXPECT_GT(folder.summary("box").at("max_contact_force_N").get<double>(), 100.0) << "the pads touch grains";
}

// Finer grains under a plate: as many as their share of the bed weighs, and where they lie after they have settled.
TEST_F(Bed, HasFinerGrainsUnderABody) {
  constexpr double kFine = 0.006, kCoarse = 0.016, kHalf = 0.1, kDeep = 0.06;  // [m]
  folder.write("zone.toml",
               std::regex_replace(kPlateAndTine, std::regex("end_time.*"), "end_time = 0.002") +
                   "[particles]\nranks = 1\n[particles.box]\nsize = [0.6, 0.5]\ndepth = 0.15\nradius = 0.016\n" +
                   "zones = [{ under = [\"plate\"], size = [0.2, 0.2], depth = 0.06, radius = 0.006 }]\n" +
                   "pour = { friction = 0.05, rolling_friction = 0, settle_time = 0.3 }\n");
  folder.done("run zone.toml --quiet --out zone", 600);
  const std::string checked = folder.done("check zone.toml").text;
  EXPECT_TRUE(holds(checked, "zone under plate: 0.2 x 0.2 m, 0.06 m deep, of radius 0.006 m")) << checked;
  double fine = 0.0, all = 0.0, inside = 0.0, intruders = 0.0, core = 0.0, highest = -1.0;  // volumes [4/3 pi m3]
  for (const GrainPlace& g : read_grains(bed_of(checked) + "/bed.restart.grains")) {
    const double volume = std::pow(g.radius, 3), away = g.centre.head<2>().cwiseAbs().maxCoeff();
    all += volume;
    if (g.radius == kFine) {
      fine += volume;
      highest = std::max(highest, g.centre.z());
      if (away < kHalf + 2.0 * kCoarse && g.centre.z() > -kDeep - 2.0 * kCoarse) inside += volume;
    }
    if (away > kHalf - 2.0 * kCoarse || g.centre.z() < -kDeep + kCoarse) continue;
    core += volume;
    if (g.radius == kCoarse) intruders += volume;
  }
  const double whole = 0.6 * 0.5 * 0.15, zone = 4.0 * kHalf * kHalf * kDeep;
  EXPECT_NEAR(fine / all, zone / whole, 0.2 * zone / whole);
  EXPECT_GT(inside / fine, 0.88);
  EXPECT_LT(intruders / core, 0.1);
  EXPECT_LE(highest, -kFine + 1e-3);
}

// The radii of a distribution have their shares in the mass of the settled bed.
TEST_F(Bed, HasTheSharesOfASizeDistribution) {
  folder.write("sizes.toml",
               std::regex_replace(kPlateAndTine, std::regex("end_time.*"), "end_time = 0.002") +
                   "[particles]\nranks = 1\n[particles.box]\nsize = [0.5, 0.4]\ndepth = "
                   "0.15\n[particles.box.size_distribution]\n" +
                   "kind = \"sieve\"\ndiameters = [0.014, 0.018, 0.024, 0.032]\npassing = [0.1, 0.4, 0.8, 1]\n");
  folder.done("run sizes.toml --quiet --out sizes", 600);
  const std::string checked = folder.done("check sizes.toml").text;
  std::map<double, double> share;
  double all = 0.0;
  for (const GrainPlace& g : read_grains(bed_of(checked) + "/bed.restart.grains")) {
    share[g.radius] += std::pow(g.radius, 3);
    all += std::pow(g.radius, 3);
  }
  ASSERT_EQ(share.size(), 3u) << checked;
  std::vector<double> shares;
  for (const auto& [radius, volume] : share) shares.push_back(volume / all);
  EXPECT_NEAR(shares[0], 0.3 / 0.9, 0.03);
  EXPECT_NEAR(shares[1], 0.4 / 0.9, 0.03);
  EXPECT_NEAR(shares[2], 0.2 / 0.9, 0.03);
}

// Beds of every kind come to rest and carry a plate.
TEST_F(Bed, UnderATerrainHasItsSurface) {
  // A slope of 12 degrees with a rock in its middle: the highest grains of each cell reach the surface, within a radius or two,
  // and none is within the rock. A plate comes down on the rock before it meets a grain.
  const std::string terrain =
      "[ground.plane]\nstiffness = 1e6\n[ground.terrain]\nslope_deg = 12\n"
      "[[ground.terrain.rocks]]\ndiameter = 0.08\nburied = 0.3\n";
  std::string scene = kPlateAndTine;
  scene.replace(scene.find("[initial]"), 9, terrain + "[initial]\nclearance = 0.003");
  folder.write("slope.toml", scene +
                                 "[particles]\nranks = 1\n[particles.box]\nsize = [0.3, 0.2]\ndepth = 0.05\n"
                                 "radius = 0.008\nexchange_steps = 3\n");
  folder.done("run slope.toml --quiet --out slope");
  const std::string checked = folder.done("check slope.toml").text;
  const std::vector<GrainPlace> grains = read_grains(bed_of(checked) + "/bed.restart.grains");
  const auto surface = [](double x) { return -std::tan(12.0 * 3.14159265358979 / 180.0) * x; };
  const Eigen::Vector3d rock(0.0, 0.0, 0.4 * 0.04);
  std::map<std::pair<int, int>, double> over;  // highest point over the surface in cells of 3 cm
  for (const GrainPlace& g : grains) {
    EXPECT_GT((g.centre - rock).norm(), 0.04 + g.radius - 1e-5);
    if ((g.centre - rock).head<2>().norm() < 0.07) continue;
    double& high =
        over.try_emplace({int((g.centre.x() + 0.15) / 0.03), int((g.centre.y() + 0.1) / 0.03)}, -1.0).first->second;
    high = std::max(high, g.centre.z() + g.radius - surface(g.centre.x()));
  }
  double mean = 0.0;
  for (const auto& [cell, high] : over) mean += high / static_cast<double>(over.size());
  EXPECT_NEAR(mean, 0.0, 0.008);
  // At 1 m/s the plate meets the rock after 3 ms; before it has turned, only the rock pushes it.
  EXPECT_EQ(folder.summary("slope").at("status"), "done");
  EXPECT_GT(folder.summary("slope").at("max_contact_force_N").get<double>(), 1.0);
  // Without dumps of grains the page shows the surface and the rock, without a joint that holds it.
  folder.done("view slope");
  const std::string page = folder.command("cat slope/view.html", 10).text;
  EXPECT_NE(page.find("\"heights\""), std::string::npos);
  EXPECT_EQ(page.find("rock_1_in_the_ground"), std::string::npos);
  // A steeper slope stands not.
  folder.refused("check slope.toml --set ground.terrain.slope_deg=28", "E0197");
}

TEST_F(Bed, OfEveryKindComesToRest) {
  folder.write("box.toml", R"(end_time = 0.02
[[bodies]]
name = "plate"
mass = 0.5
shape = { kind = "cylinder", centre = [0, 0, 0.01], radius = 0.04, length = 0.01 }
[[boundaries]]
body = "plate"
surface = { element_size = 0.02 }
[ground]
kind = "particles"
[initial]
clearance = 0.001
[particles]
ranks = 1
[particles.box]
size = [0.2, 0.16]
depth = 0.05
radius = 0.008
[output]
plots = false
)");
  std::map<std::string, double> fraction;
  const auto kind = [&](const std::string& name, const std::vector<std::string>& settings) {
    std::string options;
    for (const std::string& setting : settings) options += " --set " + app::quoted(setting);
    folder.done("run box.toml --quiet --out " + name + options);
    const std::string checked = folder.done("check box.toml" + options).text;
    std::smatch part;
    ASSERT_TRUE(std::regex_search(checked, part, std::regex("fraction ([0-9.]+)"))) << checked;
    fraction[name] = std::stod(part[1]);
    ASSERT_TRUE(std::regex_search(checked, part, std::regex("mean speed ([0-9.e-]+) m/s"))) << checked;
    EXPECT_LT(std::stod(part[1]), 2e-4) << name << " [m/s]; a loose grain among 300 is 1e-4";
  };
  kind("loose", {});
  kind("dense", {"particles.box.packing=\"dense\""});
  EXPECT_GT(fraction["dense"], fraction["loose"] + 0.02);
  kind("periodic",
       {"particles.box.periodic=true", "gravity=[0.8,0,-9.7]", "particles.box.material.rolling_model=\"epsd2\""});
  kind("cohesive", {"particles.box.material.cohesion=1e4", "particles.box.material.rolling_model=\"none\"",
                    "particles.box.bodies.cohesion=0"});
  kind("moon", {"gravity=[0,0,-1.62]", "particles.box.centre=[0.02,-0.02]", "particles.box.radius=[0.007,0.01]",
                "particles.box.shares=[0.7,0.3]", "particles.box.frame_interval=0.01"});
  EXPECT_EQ(folder.command("ls moon/grains_*.vtp", 10).exit_code, 0) << "dumps";
}

// Clumps are bodies: whole in the bed, with energies and momenta of rigid bodies; stock LIGGGHTS replays them.
TEST_F(Bed, OfClumps) {
  const std::string scene = app::kSource + "/tests/app/clumps.toml";
  folder.done("run " + scene + " --quiet --out run");
  const std::string checked = folder.done("check " + scene).text;
  const std::vector<GrainPlace> spheres = read_grains(bed_of(checked) + "/bed.restart.grains");
  std::map<int, std::vector<double>> clumps;
  for (const GrainPlace& g : spheres) clumps[g.clump].push_back(g.radius);
  for (const auto& [number, radii] : clumps)
    EXPECT_EQ(radii.size(), radii[0] < 0.006 ? 4u : 2u) << "a clump lost a sphere";
  EXPECT_TRUE(holds(checked, " " + std::to_string(clumps.size()) + " clumps of " + std::to_string(spheres.size())))
      << checked;
  std::smatch part;
  ASSERT_TRUE(std::regex_search(checked, part, std::regex("fraction ([0-9.]+)")));
  EXPECT_NEAR(std::stod(part[1]), 0.54, 0.12);
  // Rows: step, time, energy of motion, of that in rotation.
  std::istringstream energies(folder.read("run/grains_energy.txt"));
  double spin = 0.0, most = 0.0;
  for (std::string line; std::getline(energies, line);) {
    std::istringstream row(line);
    double step, time, motion, rotation;
    if (line[0] == '#' || !(row >> step >> time >> motion >> rotation)) continue;
    most = std::max(most, motion);
    spin = std::max(spin, rotation);
  }
  EXPECT_TRUE(spin > 1e-5 && most > 1e-3 && most < 0.3) << spin << " " << most;
  const History balance = read_history(folder.file("run/ledger.csv"));
  EXPECT_NEAR(balance.column("closing_error").back(), 0.0, 1e-5);
  EXPECT_GT(balance.column("grains.dissipated").back(), 0.0);
  const std::string audit = folder.done("run " + scene + " --audit --out audit --until 0.03").text;
  EXPECT_TRUE(holds(audit, "linear momentum") && holds(audit, "angular momentum")) << audit;
  folder.done("compare run --quiet");
  EXPECT_TRUE(folder.has("run/compare/beds.csv"));
}

TEST_F(Bed, OfASweepIsMadeOnceForRunsThatShareIt) {
  setenv("FOOTFALL_CACHE", folder.file("cache").c_str(), 1);
  const auto sweep = [&](const std::string& seeds, const std::string& options = "--beds") {
    folder.write("beds.toml", "scene = \"" + app::kInputs + R"(/dropped_sphere/scene.toml"
settings = ["particles.ranks=1", "particles.bed.variables.width=0.42", "particles.variables.width=0.42",
  "bodies.ball.shape.radius=0.07", "particles.bed.variables.depth=0.1", "particles.bed.variables.settle=0.1",
  "particles.bed.variables.rest=0.01"]
[[parameters]]
name = "seed"
settings = ["particles.bed.variables.seed={value}"]
values = [)" + seeds + R"(]
[[parameters]]
name = "window"
settings = ["particles.variables.every={value}"]
values = [2, 3]
[[figures]]
name = "peak acceleration [g]"
key = "peak_acceleration_g"
)");
    return folder.footfall("sweep beds.toml --out sweep --jobs 2 " + options);
  };
  const test::Outcome listed = sweep("15485863, 32452843", "--list");
  EXPECT_EQ(listed.exit_code, 0) << listed.text;
  EXPECT_TRUE(holds(listed.text, "3  seed_32452843__window_3\n") && holds(listed.text, "seed=32452843")) << listed.text;
  EXPECT_FALSE(folder.has("cache") || folder.has("sweep")) << "a list makes nothing";
  const auto beds = [&] { return folder.shell("ls --full-time cache/beds/*/bed.restart").text; };
  EXPECT_EQ(sweep("15485863, 32452843").exit_code, 0);
  const std::string made = beds();
  EXPECT_EQ(app::lines_of(made), 2) << made;
  EXPECT_EQ(sweep("15485863, 32452843").exit_code, 0);
  EXPECT_EQ(sweep("15485863, 32452843", "--beds --only 3").exit_code, 0);
  EXPECT_EQ(beds(), made) << "made again";
  EXPECT_FALSE(folder.has("sweep/runs/seed_15485863__window_2")) << "--beds carries out no run";
  const test::Outcome wrong = sweep("15485863, 4");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_TRUE(holds(wrong.text, "random seed")) << "LIGGGHTS' own message: " << wrong.text;
  unsetenv("FOOTFALL_CACHE");
}

TEST_F(Bed, OfDrawnRunsIsMadeWithoutThem) {
  if (!fs::exists(test::RunFolder::program("footfall_campaign"))) GTEST_SKIP() << "footfall_campaign is not built";
  setenv("FOOTFALL_CACHE", folder.file("cache").c_str(), 1);
  folder.write("drawn.toml", "scene = \"" + app::kInputs + R"(/dropped_sphere/scene.toml"
settings = ["particles.ranks=1", "particles.bed.variables.width=0.42", "particles.variables.width=0.42",
  "bodies.ball.shape.radius=0.07", "particles.bed.variables.depth=0.1", "particles.bed.variables.settle=0.1",
  "particles.bed.variables.rest=0.01"]
runs = 3
[[parameters]]
name = "speed"
settings = ["initial.velocity=[0,0,-{value}]"]
distribution = "uniform"
least = 1
most = 2
[[figures]]
name = "peak acceleration [g]"
key = "peak_acceleration_g"
[[outcomes]]
name = "hard"
when = "peak_acceleration > 5"
)");
  folder.done("sweep drawn.toml --out drawn --list");
  EXPECT_FALSE(folder.has("cache") || folder.has("drawn")) << "a list makes nothing";
  folder.done("sweep drawn.toml --out drawn --beds");
  EXPECT_EQ(app::lines_of(folder.shell("ls cache/beds/*/bed.restart").text), 1) << "all rows share one";
  EXPECT_TRUE(folder.shell("find drawn -name summary.json").text.empty()) << "--beds carries out no run";
  unsetenv("FOOTFALL_CACHE");
}

// A static mesh of the script holds a body for which [[contacts]] has walls = true, on one rank and on two alike.
TEST_F(Bed, WithAShelfHoldsABody) {
  folder.write("scene.toml", "base = \"" + app::kPlate + R"(/scene.toml"
end_time = 0.15
[[contacts]]
walls = true
stiffness = 1e8
damping = 10.0
friction = 0.4
[particles]
script = ")" + app::kPlate + R"(/on_shelf.in"
[output]
interval = 1e-3
)");
  for (const std::string ranks : {"1", "2"}) folder.done("run scene.toml --quiet --ranks " + ranks + " --out " + ranks);
  EXPECT_TRUE(history("1") == history("2"));
  const History run = read_history(folder.file("1/history.csv"));
  const std::vector<double>&z = run.column("plate.z"), &force = run.column("plate.contact.fz");
  // It rests on z = 0.045 with half its thickness, 0.01; contacts of that stiffness deflect by less than 1 mm.
  EXPECT_GT(*std::min_element(z.begin(), z.end()), 0.054);
  EXPECT_LT(z.back(), 0.06);
  EXPECT_GT(*std::max_element(force.begin(), force.end()), 0.0);
}

// damping_mass pair, on beams and with the mass that mbd_solver sends: restitution is the script's, and less with `grain`.
TEST_F(Bed, DampsContactsWithTheMassOfTheBody) {
  const auto restitution = [&](const std::string& word) {
    folder.done("run " + app::kSource + "/tests/app/pair_mass.toml --quiet --set particles.variables.word=" + word +
                " --out " + word);
    std::istringstream grain(folder.command("tail -n 1 " + word + "/grain.2600", 10).text);
    double id = 0.0, velocity = 0.0;
    grain >> id >> velocity;
    return (read_history(folder.file(word + "/history.csv")).column("beam.vz").back() - velocity) / 0.2;
  };
  EXPECT_NEAR(restitution("pair"), 0.4, 0.005) << "windows of one step";
  EXPECT_NEAR(restitution("grain"), 0.26, 0.01) << "the same mass again";
}

// What check reports: time steps from the text of the scripts, and with --time the time of the run. Nothing of the trial remains.
TEST_F(Bed, IsReportedByCheckWithTheTimeOfTheRun) {
  setenv("TMPDIR", folder.path().c_str(), 1);
  const std::string landing = folder.done("check " + app::kInputs + "/landing_script").text;
  for (const char* number :
       {" 0.02 to 0.05 m", " 0.0001 s", " 11 %", " 5.2 %", " 2 steps", "5 % error: 0.0001 s", "1 %: 6.1e-05 s"})
    EXPECT_TRUE(holds(landing, number)) << number << "\n" << landing;
  const std::regex estimate("about [0-9.]+ (s|min|h) \\([0-9.]+ .* to [0-9.]+ .*\\)");
  const std::string plane = folder.done("check " + app::kInputs + "/rigid_plane --set flexible=false --time 0.5").text;
  EXPECT_TRUE(std::regex_search(plane, estimate)) << plane;
  folder.done("check " + app::kInputs + "/rigid_plane --set flexible=false --set end_time=0.005 --time=60");
  folder.done("run " + app::kExamples + "/01_pendulum --until 0.001 --quiet --out pendulum", 300);  // makes the bed
  fs::remove_all(folder.file("pendulum"));
  const std::string grains = folder.done("check " + app::kExamples + "/01_pendulum --time 1", 300).text;
  EXPECT_TRUE(std::regex_search(grains, estimate)) << grains;
  EXPECT_TRUE(std::regex_search(grains, std::regex("[1-9][0-9]* MB")) && holds(grains, "omega H")) << grains;
  for (const auto& entry : fs::directory_iterator(folder.path()))
    EXPECT_FALSE(entry.is_directory()) << entry.path() << " is left";
  unsetenv("TMPDIR");
}

// Four equal grains above one another, 1 mm apart; the topmost comes down with 0.5 m/s and each gives its motion on to the next by a
// contact of 0.1 ms.
constexpr const char* kColumn = R"(variable restitution index 1
atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
units si
hard_particles yes
region box block -0.1 0.1 -0.1 0.1 -0.01 0.2 units box
create_box 2 box
variable length equal 0.2
variable width equal 0.2
variable depth equal 0
variable x equal 0
variable y equal 0
variable periodic index 0
variable dt equal 5e-7
variable young index 1e9
variable grain_friction equal 0.5
variable pair_friction equal 0.5
variable grain_rolling equal 0
variable pair_rolling equal 0
neighbor 0.005 bin
neigh_modify delay 0
include ${here}/material.lammps
include ${here}/observed_walls.lammps
timestep ${dt}
fix integrate all nve/sphere
create_atoms 1 single 0 0 0.011 units box
create_atoms 1 single 0 0 0.032 units box
create_atoms 1 single 0 0 0.053 units box
create_atoms 1 single 0 0 0.074 units box
set group all density 2500 diameter 0.02
region top block -0.1 0.1 -0.1 0.1 0.07 0.09 units box
group top region top
velocity top set 0 0 -0.5 units box
run ${steps}
)";

// A collision of equal grains gives (1 + e)^2 / 4 of the energy on, so that the floor gets m v^2 / 2 ((1 + e) / 2)^6 of it. It is all
// there when the last grain stands still; without damping it comes back.
TEST_F(Bed, ColumnGivesItsPulseToTheFloor) {
  folder.write("in.column", kColumn);
  const double energy = 0.5 * 2500.0 * 4.0 / 3.0 * 3.14159265358979 * 1e-6 * 0.25;  // [J]
  for (const double e : {1.0, 0.6}) {
    for (const bool periodic : {false, true}) {
      const test::Outcome run =
          folder.alone(test::RunFolder::program("liggghts_mbd"), 1,
                       "-in in.column -log none -var out . -var here " + app::kInputs + "/box -var steps " +
                           (e == 1.0 ? "20000" : "40000") + " -var restitution " + std::to_string(e) +
                           " -var periodic " + (periodic ? "1" : "0"));
      ASSERT_EQ(run.exit_code, 0) << run.text;
      std::istringstream rows(folder.read("walls_energy.txt"));
      double sum = 0.0, most = 0.0, sides = 0.0;
      for (std::string line; std::getline(rows, line);) {
        std::istringstream row(line);
        double step, time, floor, side;
        if (line[0] == '#' || !(row >> step >> time >> floor >> side)) continue;
        sum += floor * 1e-5;
        most = std::max(most, sum);
        sides = std::max(sides, std::abs(side));
      }
      const double arrives = energy * std::pow(0.5 * (1.0 + e), 6);
      EXPECT_NEAR(most, arrives, 5e-3 * arrives) << e;  // five samples of a row, 40 rows in the contact
      if (e == 1.0) {
        EXPECT_NEAR(sum, 0.0, 1e-4 * arrives);
      }
      EXPECT_EQ(sides, 0.0);
    }
  }
}

// A plate dropped on a shallow bed: the floor feels it; what was there at one time is at most what the grains got.
TEST_F(Bed, TellsWhatReachedItsWalls) {
  folder.write("scene.toml", kPlateAndTine + "[particles]\nranks = 1\n[particles.box]\nsize = [0.2, 0.16]\n" +
                                 "depth = 0.05\nradius = [0.007, 0.009]\nexchange_steps = 3\n");
  folder.done("run scene.toml --quiet --out runs/plain");
  const std::string text = folder.done("run scene.toml --out runs/scene --set particles.variables.wall_energy=1").text;
  EXPECT_TRUE(history("runs/scene") == history("runs/plain"));  // to the bit
  const nlohmann::json ledger = nlohmann::json::parse(folder.read("runs/scene/summary.json")).at("ledger");
  const double floor = ledger.at("energy_to_floor_share"), sides = ledger.at("energy_to_sides_share");
  EXPECT_TRUE(floor > 0.005 && floor < 1.0) << floor;
  EXPECT_TRUE(sides > 0.0 && sides < floor) << sides;
  EXPECT_TRUE(holds(text, "of the energy given, at the floor")) << text;
  const std::string checked = folder.done("check scene.toml").text;
  EXPECT_TRUE(holds(checked, "The last run (runs/scene): of the energy given to the grains at most")) << checked;
  EXPECT_FALSE(
      nlohmann::json::parse(folder.read("runs/plain/summary.json")).at("ledger").contains("energy_to_floor_J"));
}

// Four patches, and one bed where they meet.
TEST_F(Bed, ObservingTheWallsOfTheLandingChangesNoBit) {
  for (const std::string width : {"0.5", "1.3"}) {
    const std::string command = "run " + app::kInputs +
                                "/landing_script --force --until 0.012 --ranks 1 --set output.plots=false" +
                                " --set particles.variables.frames=0 --set particles.variables.width=" + width +
                                " --set particles.bed.variables.width=" + width +
                                " --set particles.bed.variables.depth=0.1 --set particles.bed.variables.settle=0.1" +
                                " --set particles.bed.variables.fine=0.5 --set particles.bed.variables.fine_depth=0.05";
    folder.done(command + " --quiet --out runs/plain");
    const std::string text = folder.done(command + " --out runs/walls --set particles.variables.wall_energy=1").text;
    EXPECT_TRUE(history("runs/walls") == history("runs/plain")) << width;
    const nlohmann::json ledger = nlohmann::json::parse(folder.read("runs/walls/summary.json")).at("ledger");
    EXPECT_GT(ledger.at("energy_to_floor_J").get<double>(), 0.0);
    EXPECT_GT(ledger.at("energy_to_sides_J").get<double>(), 0.0);
    EXPECT_TRUE(holds(text, "of the energy given, at the floor")) << text;
  }
}

}  // namespace
}  // namespace footfall
