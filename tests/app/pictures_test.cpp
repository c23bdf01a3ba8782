// What is made of the folder of a run: plots, pictures, pages, comparisons. They read runs that tests of CMakeLists.txt make once: `plate`
// (a plate on grains, dumped) and `plane` (the lander on the rigid plane).
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "coupler/base/text.h"
#include "mbd_solver/session/output/history.h"
#include "mbd_solver/session/output/vtk_writer.h"
#include "tests/app/programs.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;
using app::count;
using app::holds;

class Pictures : public ::testing::Test {
 protected:
  const app::Folder folder{"pictures"};
  // A copy of a shared run, called RUN in this folder.
  std::string copy_of(const std::string& run) const {
    fs::copy(app::shared_run(run), folder.file(run), fs::copy_options::recursive);
    return run;
  }
  // Pixels of an .rgb file: how many are grey (mechanism), how many sandy (grains).
  std::pair<int, int> pixels(const std::string& file) const {
    const std::string bytes = folder.read(file);
    int grey = 0, sand = 0;
    for (std::size_t k = 0; k + 2 < bytes.size(); k += 3) {
      const int r = static_cast<unsigned char>(bytes[k]), b = static_cast<unsigned char>(bytes[k + 2]);
      grey += r > 100 && b > r ? 1 : 0;
      sand += r > b + 15 ? 1 : 0;
    }
    return {grey, sand};
  }
};

TEST_F(Pictures, OfColumns) {
  const std::string run = copy_of("plane"), plot = "plot " + run + " ";
  EXPECT_TRUE(holds(folder.done(plot).text, "cabin.az [m/s2]\n"));
  EXPECT_TRUE(holds(folder.done(plot + "cabin.az").text, "plots/cabin.az.png"));
  folder.done(plot + "'struts.*.force'");
  const std::string script = folder.read(run + "/plots/struts.all.force.gp");
  // Four legs of three struts: four panels with one scale, three curves each.
  EXPECT_EQ(count(script, "\nset title"), 9);  // and the title of the page
  EXPECT_EQ(count(script, "with lines"), 24);
  std::set<std::string> ranges;
  std::istringstream lines(script);
  for (std::string line; std::getline(lines, line);)
    if (line.rfind("set yrange [", 0) == 0 && line[12] != '*') ranges.insert(line);
  EXPECT_EQ(ranges.size(), 1u);
  folder.done(plot + "cabin.v cabin.az --out both.svg");
  EXPECT_TRUE(holds(folder.read("both.svg"), "<svg"));
  EXPECT_TRUE(holds(folder.refused(plot + "cabin.aw", "E0521").text, "cabin.a"));
  folder.refused("plot .", "E0506");
  EXPECT_TRUE(holds(folder.refused(plot + "cabin.az --out x.bmp", "E0500").text, "x.bmp"));
}

TEST_F(Pictures, OfGrains) {
  const std::string run = copy_of("plate"), draw = "view " + run + " --pictures ";
  const std::string said = folder.done(draw + "--times 0.021 --fastest 100").text;
  EXPECT_TRUE(holds(said, "grains_0.0200s.png")) << "the nearest dump: " << said;
  const auto [grey, sand] = pixels(run + "/pictures/grains_0.0200s.rgb");
  EXPECT_GT(grey, 1000);
  EXPECT_GT(sand, 1000) << "slow against 100 m/s";
  EXPECT_EQ(folder.read(run + "/pictures/grains_0.0200s.png").substr(1, 3), "PNG");
  folder.refused("view . --pictures", "E0506");
  folder.refused(draw + "--times=-1", "E0528");
  folder.refused(draw + "--cut-at 5", "E0527");
}

TEST_F(Pictures, OfCutsAndOfBodiesThatWereNotDrawn) {
  const std::string run = copy_of("plate");
  folder.done("view " + run + " --pictures --times 0,0.02 --cut --camera=-80,10 --fastest 100 --width 1000");
  for (const char* name : {"cut_0.0000s", "cut_0.0200s"})
    EXPECT_GT(pixels(run + "/pictures/" + name + ".rgb").second, 1000);
  // Without drawn bodies the recorded motion of their surfaces is drawn, which is said.
  for (const auto& entry : fs::directory_iterator(folder.file(run)))
    if (entry.path().filename().string().rfind("bodies", 0) == 0) fs::remove(entry.path());
  EXPECT_TRUE(holds(folder.done("view " + run + " --pictures --times 0.02 --fastest 100").text, "output.vtk"));
  EXPECT_GT(pixels(run + "/pictures/grains_0.0200s.rgb").first, 1000);
  fs::create_directory(folder.file("blind"));
  fs::copy(folder.file(run + "/summary.json"), folder.file("blind/summary.json"));
  fs::copy(folder.file(run + "/run.json"), folder.file("blind/run.json"));
  folder.refused("view blind --pictures", "E0572");
  EXPECT_FALSE(folder.has("blind/pictures"));
}

// Distance of the ends of a strut of the lander in its design position [m]: inputs/landing_mr/scene.toml.
double undeformed_length(const std::string& strut) {
  if (holds(strut, "primary")) return Eigen::Vector3d(0.75, 0, -1.27).norm();
  return Eigen::Vector3d(0.5568, -0.55, 0.11115).norm();
}

// A page loads nothing: no source, no address but the name of XHTML, and the browser is told to refuse any.
void expect_alone(const app::Folder& folder, const std::string& page) {
  const std::string sources = "grep -cE '<(script|img|iframe|link)[^>]* (src|href)=\"[^dv]|@import' " + page;
  EXPECT_EQ(folder.shell(sources).text, "0\n");
  const std::string addresses = "grep -oE 'https?://[^\" ]*' " + page + " | grep -vxc http://www.w3.org/1999/xhtml";
  EXPECT_EQ(folder.shell(addresses).text, "0\n");
  EXPECT_TRUE(holds(folder.read(page), "Content-Security-Policy\" content=\"default-src 'none'"));
}

TEST_F(Pictures, InThePageOfARun) {
  for (const std::string name : {"plate", "plane"}) {
    const std::string run = copy_of(name), said = folder.done("view " + run).text;
    EXPECT_TRUE(holds(said, run + "/view.html")) << said;
    EXPECT_EQ(app::lines_of(said), 1) << "a whole run has no warnings: " << said;
    const std::string page = folder.read(run + "/view.html");
    EXPECT_LT(page.size(), 3000000u);
    expect_alone(folder, run + "/view.html");
    EXPECT_EQ(holds(page, "id=\"footfall-grains-0\""), name == "plate");
    EXPECT_TRUE(holds(page, "id=\"footfall-bodies-0\""));
  }
  // A run that drew nothing: the page says how to get it.
  for (const auto& entry : fs::directory_iterator(folder.file("plate"))) {
    const std::string name = entry.path().filename();
    if (name == "motion" || name.rfind("bodies", 0) == 0 || name.rfind("grains_", 0) == 0) fs::remove_all(entry.path());
  }
  const std::string said = folder.done("view plate").text;
  EXPECT_TRUE(holds(said, "particles.box.frame_interval") && holds(said, "output.vtk")) << said;
  folder.refused("view .", "E0506");
  std::string last;
  for (const auto& entry : fs::directory_iterator(folder.file("plane")))
    if (entry.path().extension() == ".vtu") last = std::max(last, entry.path().string());
  fs::resize_file(last, 400);
  const test::Outcome damaged = folder.footfall("view plane");
  EXPECT_EQ(damaged.exit_code, 2);
  EXPECT_TRUE(holds(damaged.text, fs::path(last).filename().string())) << damaged.text;
}

// Each drawing has the places of joints, struts and bodies and the loads of the ground. They equal history.csv at the same time:
// nine digits in one file, all in the other; lengths are of the order of metres, loads of 10 kN.
TEST_F(Pictures, HoldTheMarksOfAllPartsWhereTheHistoryHasThem) {
  const std::string run = app::shared_run("plane");
  const History history = read_history(run + "/history.csv");
  const std::vector<double>& time = history.column("time");
  int compared = 0;
  for (const auto& [t, file] : read_vtk_series(run + "/bodies.pvd")) {
    std::size_t row = 0;
    while (row + 1 < time.size() && std::abs(time[row] - t) > 1e-12) ++row;
    if (std::abs(time[row] - t) > 1e-12) continue;
    const VtkFrame frame = read_vtk_frame(run + "/" + file);
    std::vector<std::string> texts;
    for (const auto& [name, found] : frame.texts)
      if (name == "mark_names") texts = found;
    ASSERT_EQ(frame.field_vectors.size(), 1u);
    const Eigen::Matrix3Xd& vectors = frame.field_vectors[0].second;
    ASSERT_EQ(vectors.cols(), 4 * static_cast<Eigen::Index>(texts.size()));
    const auto column = [&](const std::string& name) { return history.column(name)[row]; };
    for (std::size_t i = 0; i < texts.size(); ++i) {
      const std::vector<std::string> words = split(texts[i], '\t');
      ASSERT_EQ(words.size(), 5u) << texts[i];
      const std::string &kind = words[0], &type = words[1], &name = words[2];
      const auto vector = [&](int k) { return Eigen::Vector3d(vectors.col(4 * static_cast<Eigen::Index>(i) + k)); };
      const double length = (vector(1) - vector(0)).norm();
      if (kind == "strut") {
        EXPECT_NEAR(length + column(name + ".stroke"), undeformed_length(name), 1e-7) << name;
        EXPECT_NEAR(vector(2).norm(), std::abs(column(name + ".force")), 1e-4) << name;
        ++compared;
      }
      if (kind == "joint" && type != "prismatic") {
        EXPECT_LT(length, 1e-6) << name << ": one point on both bodies, to the largest gap of the joints";
        EXPECT_NEAR(vector(2).norm(), 1.0, 1e-3)
            << name << ": axes of flexible bodies turn to first order, by up to 0.02 rad";
      }
      if (kind == "body" && history.find(name + ".contact.fz") >= 0) {
        for (int k = 0; k < 3; ++k) {
          EXPECT_NEAR(vector(0)(k), column(name + "." + "xyz"[k]), 1e-7) << name;
          EXPECT_NEAR(vector(2)(k), column(name + ".contact.f" + "xyz"[k]), 1e-4) << name;
        }
        ++compared;
      }
    }
  }
  EXPECT_GE(compared, 2 * (12 + 4)) << "twelve struts and four pads in at least two drawings";
}

// What is drawn by other programs says which of them is missing, before anything is written.
TEST_F(Pictures, OfThePageNeedABrowser) {
  const std::string run = copy_of("plane");
  const auto without_programs = [&](const std::string& line) {
    return folder.shell("PATH=/nowhere " + app::quoted(app::Folder::program("footfall")) + " " + line);
  };
  const test::Outcome png = without_programs("view " + run + " --png a.png"),
                      video = without_programs("view " + run + " --video a.mp4");
  for (const test::Outcome& outcome : {png, video}) {
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(holds(outcome.text, "[E0540 ") && holds(outcome.text, "apt install chromium")) << outcome.text;
  }
  EXPECT_TRUE(holds(video.text, "ffmpeg"));
  folder.refused("view " + run + " --png a.gif", "E0500");
  for (const char* show : {"speed", "grain=force", "names", "grains=force&colour=red"})
    folder.refused("view " + run + " --png a.png --show " + app::quoted(show), "E0500");
  folder.refused("view " + run + " --video a.avi", "E0500");
  folder.refused("view " + run + " --video missing/a.mp4", "E0500");
  folder.refused("view " + run + " --video a.mp4 --size 641,480", "E0500");
  folder.refused("view " + run + " --camera=-65,20", "E0500");
  EXPECT_FALSE(folder.has("a.png") || folder.has("a.mp4"));
}

TEST_F(Pictures, OfTheReferenceConfiguration) {
  const std::string check = "check " + app::kInputs + "/rigid_plane --picture ";
  folder.done(check + "lander.html");
  const std::string page = folder.read("lander.html");
  expect_alone(folder, "lander.html");
  EXPECT_TRUE(holds(page, "\"kind\":\"joint\",\"type\":\"universal\",\"name\":\"leg_1_hip\"")) << "joints";
  EXPECT_TRUE(holds(page, "id=\"footfall-marks\"") && holds(page, "id=\"footfall-bodies-0\""));
  // Without a browser gnuplot draws; browser.sh draws with one.
  folder.shell("mkdir only && ln -s $(command -v gnuplot) only/");
  EXPECT_EQ(folder.shell("PATH=$PWD/only " + app::quoted(app::Folder::program("footfall")) + " " + check + "lander.png")
                .exit_code,
            0);
  EXPECT_EQ(folder.read("lander.png").substr(1, 3), "PNG");
  folder.refused(check + "lander.pdf", "E0500");
}

TEST_F(Pictures, InAReport) {
  const std::string run = copy_of("plate");
  // The page draws itself: no other program is started.
  const test::Outcome alone =
      folder.shell("PATH=/nowhere " + app::quoted(app::Folder::program("footfall")) + " report " + run);
  EXPECT_EQ(alone.exit_code, 0) << alone.text;
  const std::string page = folder.read(run + "/report.html");
  expect_alone(folder, run + "/report.html");
  EXPECT_GE(count(page, "<h2"), 6);
  EXPECT_TRUE(holds(page, "A square plate comes down"));
  EXPECT_TRUE(holds(page, "<a href=\"view.html\">")) << "the run can be played";
  EXPECT_TRUE(folder.has(run + "/view.html"));
  // The mechanism, the standard figures, the energy balance, and any column.
  for (const char* part : {"footfall-mechanism\"", "footfall-figures\" data-group=\"0\"",
                           "footfall-figures\" data-group=\"1\"", "footfall-plots\""})
    EXPECT_EQ(count(page, "class=\"" + std::string(part)), 1) << part;
  EXPECT_FALSE(holds(page, "data:image/png"));
  // Of the pictures in plots/ it has those that the user has drawn.
  folder.done("plot " + run + " plate.vz");
  folder.done("report " + run);
  EXPECT_EQ(count(folder.read(run + "/report.html"), "src=\"data:image/png;base64,"), 1);
}

TEST_F(Pictures, OfControlSurfaces) {
  folder.done("check " + app::kInputs + "/reference --surfaces surfaces");
  int pictures = 0;
  for (const auto& entry : fs::directory_iterator(folder.file("surfaces")))
    pictures += entry.path().extension() == ".png";
  EXPECT_GE(pictures, 1);
}

// Stock LIGGGHTS replays the motion of the plate: the same impulse and the same bed.
TEST_F(Pictures, BesideStockLiggghts) {
  const std::string run = copy_of("plate");
  folder.done("compare " + run + " --quiet");
  const auto row_of_plate = [&] {
    std::istringstream text(folder.read(run + "/compare/comparison.txt"));
    for (std::string line; std::getline(text, line);) {
      std::istringstream words(line);
      std::vector<std::string> row{std::istream_iterator<std::string>(words), {}};
      if (row.size() >= 8 && row[0] == "plate") return row;
    }
    return std::vector<std::string>(8, "0");
  };
  // The replay moves the plate along the chord of each window of five steps: impulse to half a per cent (measured: 0.03).
  EXPECT_GT(std::stod(row_of_plate()[1]), 1.0) << "impulse [N s]";
  EXPECT_LT(std::stod(row_of_plate()[7]), 0.5) << "difference of the impulses [%]";
  for (const char* file : {"beds.csv", "forces.csv", "profile.csv", "in.stock", "plots/forces.png", "plots/crater.png"})
    EXPECT_TRUE(folder.has(run + "/compare/" + std::string(file))) << file;
  std::ifstream beds(folder.file(run + "/compare/beds.csv"));
  EXPECT_TRUE(beds.good());
  // Without stock LIGGGHTS its package is named; the comparison remains.
  const test::Outcome none = folder.shell("PATH=/nowhere " + test::RunFolder::program("footfall") + " compare " + run);
  EXPECT_EQ(none.exit_code, 2) << none.text;
  EXPECT_TRUE(holds(none.text, "liggghts")) << none.text;
  EXPECT_TRUE(folder.has(run + "/compare/comparison.txt"));
  // With itself nothing differs.
  folder.done("compare " + run + " " + run + " --quiet");
  EXPECT_EQ(std::stod(row_of_plate()[7]), 0.0);
  folder.refused("compare .", "E0506");
}

// A run is followed to its end; its exit code is the run's.
TEST_F(Pictures, ThatFollowARun) {
  const app::Background run(folder,
                            test::RunFolder::program("footfall") + " run " + app::kInputs +
                                "/rigid_plane --set flexible=false --until 0.4 --out run",
                            "run/history.csv");
  std::string once;
  do once = folder.done("view run --follow --once").text;  // the file of the rows is there before they are
  while (holds(once, "before the first row"));
  EXPECT_TRUE(std::regex_search(once, std::regex("of 0\\.4 s \\([0-9]+ %\\)|done"))) << once;
  const std::string followed = folder.done("view run --follow --interval 0.2").text;
  EXPECT_TRUE(holds(followed, "100 %")) << followed;
  const std::string said = folder.read("background.txt");
  EXPECT_TRUE(holds(said, "(100 %)")) << said;
  EXPECT_LE(count(said, "\nt = "), 101) << "output into a file has a line for each per cent";
  std::string summary = folder.read("run/summary.json");
  folder.write("run/summary.json",
               std::regex_replace(summary, std::regex("\"status\": \"done\""), "\"status\": \"failed\""));
  EXPECT_EQ(folder.footfall("view run --follow").exit_code, 1);
  folder.refused("view . --follow", "E0506");
}

// Energies of grains: elastic grains without friction keep what they receive as motion and height, so nothing is left over once nothing
// touches; with restitution 0.4 most of it stays in the grains.
class EnergyBalance : public Pictures {
 protected:
  nlohmann::json run(const std::string& restitution, int ranks) const {
    const std::string out = "r" + restitution + "_" + std::to_string(ranks);
    start(app::kPlate + "/energy.in", ranks, "--out " + out + " --set particles.variables.restitution=" + restitution);
    return folder.summary(out)["ledger"];
  }
  // Of the plate with this script.
  void start(const std::string& script, int ranks, const std::string& options) const {
    folder.done("run " + app::kPlate + " --set particles.script='\"" + script + "\"'" +
                " --set particles.variables.dt=2e-5 --set particles.variables.every=1 --set output.interval=1e-4" +
                " --set particles.variables.energy_every=5e-4 --set output.vtk=false --quiet --force --ranks " +
                std::to_string(ranks) + " " + options);
  }
  std::vector<double> dissipated(const std::string& out) const {
    return read_history(folder.file(out + "/ledger.csv")).column("grains.dissipated");
  }
};

TEST_F(EnergyBalance, ClosesForElasticGrainsOnAnyRanks) {
  const nlohmann::json one = run("1", 1), two = run("1", 2);
  const std::vector<double> stored = dissipated("r1_1");
  const double most = *std::max_element(stored.begin(), stored.end());
  EXPECT_GT(most, 0.4) << "of the 0.58 J of the plate are in the contacts";
  // Measured: 1e-6 of it. Steps of the grains are of second order; rows of the plate are joined by lines of 0.1 ms.
  EXPECT_LT(std::abs(one["grains_dissipated_J"].get<double>()), 1e-5 * most);
  EXPECT_LT(one["closing_error_relative"].get<double>(), 1e-6);
  EXPECT_NEAR(one["energy_to_grains_J"].get<double>(), two["energy_to_grains_J"].get<double>(), 1e-6);
}

TEST_F(EnergyBalance, HoldsWhatGrainsDissipate) {
  const nlohmann::json soft = run("0.4", 1);
  EXPECT_GT(soft["grains_dissipated_J"].get<double>(), 0.9 * soft["energy_to_grains_J"].get<double>());
  const std::vector<double> all = dissipated("r0.4_1");
  double top = 0.0, fall = 0.0;
  for (const double e : all) {
    top = std::max(top, e);
    fall = std::max(fall, top - e);
  }
  EXPECT_LT(fall, 0.5) << "elastic energy that comes back [J]";
  const auto [low, high] = std::minmax_element(all.end() - 40, all.end());
  EXPECT_LT(*high - *low, 1e-4) << "nothing changes after the last contact";
}

// Grains rain, one is given another velocity and place and is deleted, one leaves the box: energies that no contact has
// exchanged. The elastic grains again keep all that they received.
class ChangedGrains : public EnergyBalance {
 protected:
  static std::string plate(const std::string& file) { return "include " + app::kPlate + "/" + file + "\n"; }
  // Its ledger; the run is `run`.
  History ledger_of(const std::string& script, int ranks) const {
    start(folder.file(script), ranks, "--out run");
    return read_history(folder.file("run/ledger.csv"));
  }
};

TEST_F(ChangedGrains, AreLinesOfTheBalance) {
  folder.write(
      "in.rain",
      "variable gravity index 9.81\nvariable out index .\n" + plate("box.lammps") +
          "fix restitution all property/global coefficientRestitution peratomtypepair 2 1 1 1 1\n"
          "fix friction all property/global coefficientFriction peratomtypepair 2 0 0 0 0\n"
          "create_atoms 1 single 0.2 0.2 0.1\ncreate_atoms 1 single 0.25 -0.2 0.2\n"
          "set group all density 2600 diameter 0.04\ngroup lone id 5\ngroup fast id 6\n"
          "velocity fast set 5 0 0\n"
          "fix kind all particletemplate/sphere 15485867 atom_type 1 density constant 2600 radius constant 0.01\n"
          "fix kinds all particledistribution/discrete 32452843 1 kind 1.0\n"
          "region source block -0.25 -0.15 -0.25 -0.15 0.2 0.28 units box\n"
          "fix rain all insert/rate/region seed 49979687 distributiontemplate kinds nparticles 6 particlerate "
          "200 insert_every 500 overlapcheck yes vel constant 0 0 -1 region source\n"
          "fix geo all couple/mbd/geometry body plate\nfix plate all mesh/surface fix geo type 2\n"
          "fix touch all wall/gran model hertz tangential history mesh n_meshes 1 meshes plate\n"
          "fix mbd all couple/mbd every ${every} outflow yes mesh plate plate\n"
          "include " +
          app::kInputs +
          "/regolith/energy.lammps\nthermo_modify lost ignore\nrun 1000\nvelocity lone set 2 0 0\n"
          "displace_atoms lone move 0 0 0.05 units box\nrun 600\ndelete_atoms group lone\nrun 100000\n");
  for (const int ranks : {1, 2}) {
    const History ledger = ledger_of("in.rain", ranks);
    const auto last = [&](const char* name) { return ledger.column(name).back(); };
    const double m = 2600 * 4.0 / 3.0 * M_PI * 8e-6, g = 9.81, v = g * 0.02;  // after 1000 steps of 0.02 ms
    const double set = 0.5 * m * (4.0 - v * v) + m * g * 0.05;
    EXPECT_NEAR(last("grains.changed"), set, 1e-8);
    // Both that leave have fallen since the start, the one after 0.012 s and a velocity, the other until it is 0.3 m away.
    const double lone = 0.5 * m * 4.0 + m * g * (0.15 - 0.5 * g * 0.02 * 0.02), fast = 0.5 * m * 25.0 + m * g * 0.2;
    // LIGGGHTS loses the latter in the middle of a step: half a time step of its fall is missing, m v g dt / 2.
    EXPECT_NEAR(last("grains.left"), -lone - fast, 2.0 * m * (g * 0.012) * g * 1e-5);
    EXPECT_GT(last("grains.inserted"), 6 * 2600 * 4.0 / 3.0 * M_PI * 1e-6 * (0.5 + g * 0.2));
    // As of the balance above: the files hold six digits of energies up to 10 J.
    EXPECT_LT(std::abs(last("grains.dissipated")), 3e-5);
    const nlohmann::json summary = folder.summary("run");
    EXPECT_EQ(summary["grains_lost"], 1);
    EXPECT_NEAR(summary["grains_lost_kg"].get<double>(), m, 1e-12);
  }
}

// One grain is lifted from the first step on, and becomes twice as heavy between two runs; another grows as it falls.
TEST_F(ChangedGrains, AreLiftedGrownAndSet) {
  folder.write("in.grow", "variable gravity index 9.81\nvariable out index .\n" + plate("box.lammps") +
                              "fix restitution all property/global coefficientRestitution peratomtypepair 2 1 1 1 1\n"
                              "fix friction all property/global coefficientFriction peratomtypepair 2 0 0 0 0\n"
                              "create_atoms 1 single 0.2 0.2 0.1\ncreate_atoms 1 single 0.25 -0.2 0.2\n"
                              "set group all density 2600 diameter 0.04\ngroup lifted id 5\ngroup grows id 6\n"
                              "group free subtract all lifted\nunfix integrate\nfix integrate free nve/sphere\n"
                              "fix lift lifted move linear 0 0 0.5\nvariable d equal \"0.04 + 4e-6*step\"\n"
                              "fix grow grows adapt 50 atom diameter v_d\n" +
                              plate("couple.lammps") + "include " + app::kInputs +
                              "/regolith/energy.lammps\nrun 1000\nset group lifted density 5200\nrun 100000\n");
  for (const int ranks : {1, 2}) {
    const History ledger = ledger_of("in.grow", ranks);
    const double volume = 2600 * 4.0 / 3.0 * M_PI, m = volume * 8e-6, g = 9.81, half_v2 = 0.5 * 0.25;
    const double lifted = m * (half_v2 + g * 0.5 * 0.02) + 2 * m * g * 0.5 * 0.03;  // from rest, to 0.02 s, to 0.05 s
    const double set = m * (half_v2 + g * 0.11);
    // v^2/2 + g z keeps its value in free fall, whatever the mass.
    const double grown = volume * (std::pow(0.02 + 2e-6 * 2500, 3) - 8e-6) * g * 0.2;
    // It grows in the middle of a step: half a step's gain of its fall is missing, at most 0.09 kg g^2 0.05 s dt / 2.
    EXPECT_NEAR(ledger.column("grains.changed").back(), lifted + set + grown, 0.09 * g * g * 0.05 * 1e-5);
    EXPECT_LT(std::abs(ledger.column("grains.dissipated").back()), 3e-5);  // as above
  }
}

TEST_F(EnergyBalance, HasNoGrainsOnAPlane) {
  const nlohmann::json summary = nlohmann::json::parse(std::ifstream(app::shared_run("plane") + "/summary.json"));
  EXPECT_LT(summary["ledger"]["closing_error_relative"].get<double>(), 1e-4);
  for (const std::string& name : read_history(app::shared_run("plane") + "/ledger.csv").names)
    EXPECT_FALSE(holds(name, "grains"));
}

}  // namespace
}  // namespace footfall
