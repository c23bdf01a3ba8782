// Coupling intervals against single DEM steps, with LIGGGHTS: prescribed motions, events, first contacts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/coupled/coupled_run.h"

namespace footfall::test {
namespace {

constexpr double kDt = 2e-5;  // [s]

// Nine grains of radius 2 cm, apart from each other so that no chaos makes two runs differ, at rest at this height.
std::string grains(double z, const std::string& every, const std::string& body) {
  std::ostringstream s;
  s << "atom_style granular\natom_modify map array\nboundary f f f\nnewton off\ncommunicate single vel yes\nunits si\n"
       "hard_particles yes\nregion box block -0.3 0.3 -0.3 0.3 -0.1 0.6 units box\ncreate_box 2 box\n"
       "neighbor 0.01 bin\nneigh_modify delay 0\n"
       "fix m1 all property/global youngsModulus peratomtype 1e7 2e11\n"
       "fix m2 all property/global poissonsRatio peratomtype 0.3 0.3\n"
       "fix m3 all property/global coefficientRestitution peratomtypepair 2 0.5 0.5 0.5 0.5\n"
       "fix m4 all property/global coefficientFriction peratomtypepair 2 0.4 0.4 0.4 0.4\n"
       "pair_style gran model hertz tangential history\npair_coeff * *\ntimestep "
    << kDt << "\n";
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      s << "create_atoms 1 single " << 0.05 * i << " " << 0.05 * j << " " << z + 0.02 + 0.001 * i << " units box\n";
  s << "set group all diameter 0.04 density 2600\nfix g all gravity 9.81 vector 0 0 -1\nfix i all nve/sphere\n"
       "fix floor all wall/gran model hertz tangential history primitive type 1 zplane -0.0001\n"
       "fix geo all couple/mbd/geometry body "
    << body << "\nfix m all mesh/surface/stress fix geo type 2\n"
    << "fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes m\n"
    << "fix mbd all couple/mbd every " << every << " mesh m " << body
    << "\nthermo_style custom step f_m[3]\nthermo 1\nthermo_modify norm no format float %.17g\nrun 1000000\n";
  return s.str();
}

std::string plate(double z, double mass) {
  std::ostringstream s;
  s << "gravity = [0, 0, -9.81]\nground = { kind = \"particles\" }\nparticles = { script = \"in.coupled\" }\n"
    << "[output]\nplots = false\nvtk = false\n[[bodies]]\nname = \"plate\"\nmass = " << mass
    << "\nshape = { kind = \"box\", size = [0.3, 0.3, 0.01], centre = [0, 0, " << z << "] }\n[[boundaries]]\n"
    << "body = \"plate\"\nsurface = {}\n";
  return s.str();
}

std::string moved(const std::string& z) {
  return "[[joints]]\nname = \"p\"\nkind = \"prescribed\"\nbodies = [\"ground\", \"plate\"]\npoint = [0, 0, 0]\n"
         "axis = \"z\"\naxis2 = \"x\"\n[joints.motion]\nx = { polynomial = [0] }\ny = { polynomial = [0] }\nz = " +
         z + "\nrotation = { polynomial = [0] }\nhold_other_rotations = true\n";
}

struct Ran {
  std::vector<double> force;  // on the mesh after every DEM step [N]
  nlohmann::json summary;
};

Ran run(const std::string& name, const std::string& script, const std::string& scene) {
  const BeamRun folder(name);
  const Outcome outcome = folder.scene(script, scene);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  Ran ran;
  ran.summary = nlohmann::json::parse(folder.read("out/summary.json"));
  std::istringstream log(folder.read("log.liggghts"));
  long step = 0;
  double force = 0.0;
  for (std::string line; std::getline(log, line);) {
    std::istringstream words(line);
    std::string more;
    if (words >> step >> force && !(words >> more)) ran.force.push_back(force);
  }
  return ran;
}

bool warns(const Ran& ran, const std::string& code) {
  return ran.summary["warnings"].dump().find(code) != std::string::npos;
}

double largest(const std::vector<double>& values) {
  double most = 0.0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

// Poses differ by the projection on the joints, 1e-12 m; a sphere's impact magnifies that by less than a thousand.
TEST(PrescribedMotion, GivesTheSameForcesInLongWindows) {
  const std::string scene = "end_time = 0.03\n" + plate(0.025, 20.0) +
                            moved("{ amplitude = 0.0005, frequency = 100.0 }") + "[solver]\nrtol = 1e-7\n";
  const Ran single = run("tray_1", grains(0.0301, "1", "plate"), scene);
  ASSERT_GT(largest(single.force), 100.0);
  for (const std::string every : {"100", "auto"}) {
    const Ran ran = run("tray_" + every, grains(0.0301, every, "plate"), scene);
    ASSERT_EQ(ran.force.size(), single.force.size());
    double off = 0.0;
    for (std::size_t i = 0; i < ran.force.size(); ++i) off = std::max(off, std::abs(ran.force[i] - single.force[i]));
    EXPECT_LT(off, 1e-5 * largest(single.force)) << every;
    // The body receives what the grains give.
    EXPECT_LT(ran.summary["coupling_energy_error_relative"].get<double>(), 1e-9) << every;
    EXPECT_LT(ran.summary["energy_balance_relative"].get<double>(), 1e-3) << every;
  }
}

// z = -60 t^2 onto the grains: 60 m/s2 bend the path by 0.24 mm in 2 ms.
TEST(PrescribedMotion, AcceleratesWithinAWindow) {
  const std::string scene = "end_time = 0.006\n" + plate(0.0455, 20.0) + moved("{ polynomial = [0, 0, -60] }");
  const Ran single = run("press_1", grains(0.0, "1", "plate"), scene),
            windows = run("press_100", grains(0.0, "100", "plate"), scene);
  EXPECT_NEAR(largest(windows.force), largest(single.force), 1e-5 * largest(single.force));
}

// A plate meets grains one after another, of which each gives a jump of the force: the run tells where means hide the peak, and has
// the force of every DEM step in any window.
TEST(PrescribedMotion, TellsThePeakOfADemStep) {
  const std::string scene =
      "end_time = 0.01\n" + plate(0.0475, 20.0) + moved("{ amplitude = -0.002, frequency = 40.0 }");
  const nlohmann::json single = run("peak_1", grains(0.0, "1", "plate"), scene).summary;
  const double force = single["max_contact_force_N"];
  EXPECT_DOUBLE_EQ(single["max_step_force_N"].get<double>(), force);
  for (const std::string every : {"auto", "30", "3"}) {
    const Ran ran = run("peak_" + every, grains(0.0, every, "plate"), scene);
    EXPECT_NEAR(ran.summary["max_step_force_N"].get<double>(), force, 1e-5 * force) << every;
    EXPECT_EQ(1.05 * ran.summary["max_contact_force_N"].get<double>() < force, warns(ran, "W0659")) << every;
  }
}

// A grain of 87 g touches for 4 ms: a mean over 2 ms hides its peak, and the run tells so.
TEST(PrescribedMotion, OfLongWindowsTellsThatMeansHidePeaks) {
  const std::string scene =
      "end_time = 0.03\n" + plate(0.025, 20.0) + moved("{ amplitude = 0.0005, frequency = 100.0 }");
  EXPECT_TRUE(warns(run("peaks_100", grains(0.0301, "100", "plate"), scene), "W0659"));
  EXPECT_FALSE(warns(run("peaks_5", grains(0.0301, "5", "plate"), scene), "W0659"));
}

// A motor of 100 N switches on at 10.5 ms: windows end at the sample, and catching up does no work.
TEST(Events, InLongWindowsCreateNoEnergy) {
  const std::string scene = "end_time = 0.03\n" + plate(0.0451, 1.0) +
                            "[[joints]]\nname = \"slide\"\nkind = \"prismatic\"\nbodies = [\"ground\", \"plate\"]\n"
                            "point = [0, 0, 0]\naxis = \"z\"\n[[drives]]\nname = \"motor\"\nkind = \"torque\"\n"
                            "joint = \"slide\"\ncommand = { signal = \"push\" }\n[[signals]]\nname = \"push\"\n"
                            "kind = \"expression\"\ninput = \"time > 0.01 ? -100 : 9.81\"\nperiod = 0.0005\n";
  const Ran ran = run("event_auto", grains(0.0, "auto", "plate"), scene);
  const Ran single = run("event_1", grains(0.0, "1", "plate"), scene);
  EXPECT_FALSE(warns(ran, "W0651"));
  // Twice coupling.tolerance.
  const double force = single.summary["max_contact_force_N"];
  EXPECT_NEAR(ran.summary["max_contact_force_N"].get<double>(), force, 0.02 * force);
}

// A plate rests on grains until a body next to it, which falls, is fast enough: that state lets 300 N push. The window that comes
// ends there, and 1 ms of windows before it is no place to catch up in two DEM steps.
TEST(Events, OfStatesInLongWindowsCreateNoEnergy) {
  const std::string slide = "\"\nkind = \"prismatic\"\npoint = [0, 0, 0.1]\naxis = \"z\"\nbodies = ";
  const std::string scene =
      "end_time = 0.03\n" + plate(0.0459, 1.0) +
      "[[bodies]]\nname = \"weight\"\nmass = 20\ninertia = [1, 1, 1]\nposition = [0, 0, 0.3]\n[[joints]]\nname = "
      "\"rail" +
      slide + "[\"ground\", \"weight\"]\n[[joints]]\nname = \"leg" + slide +
      "[\"ground\", \"plate\"]\n[[drives]]\nname = \"motor\"\nkind = \"torque\"\njoint = \"leg\"\n"
      "command = { signal = \"push\" }\n[[signals]]\nname = \"push\"\nkind = \"expression\"\n"
      "input = \"state.pushes * -300\"\n[[states]]\nname = \"waits\"\n[[states]]\nname = \"pushes\"\n"
      "[[events]]\nname = \"fast\"\nto = \"pushes\"\nwhen = \"weight.vz < -0.1021\"\n";
  const Ran ran = run("state_auto", grains(0.0, "auto", "plate"), scene);
  const Ran single = run("state_1", grains(0.0, "1", "plate"), scene);
  EXPECT_FALSE(warns(ran, "W0651"));
  EXPECT_LT(ran.summary["coupling_energy_error_relative"].get<double>(), 0.01);
  const double force = single.summary["max_contact_force_N"];
  EXPECT_NEAR(ran.summary["max_contact_force_N"].get<double>(), force, 0.02 * force);
}

// A plate of 2 kg falls onto grains; a motor pushes from a contact force of 50 N on. Windows end where the force of the last two goes
// through it: the peak, 3.5 % lower at the end of a window of 0.4 ms, is right within what a mean over 0.4 ms leaves out, 1.7 %.
TEST(Events, OfLoadsEndLongWindows) {
  const std::string scene =
      "end_time = 0.02\n" + plate(0.0465, 2.0) +
      "[[joints]]\nname = \"leg\"\nkind = \"prismatic\"\npoint = [0, 0, 0.1]\naxis = \"z\"\n"
      "bodies = [\"ground\", \"plate\"]\n[[drives]]\nname = \"motor\"\nkind = \"torque\"\njoint = \"leg\"\n"
      "command = { signal = \"push\" }\n[[signals]]\nname = \"push\"\nkind = \"expression\"\n"
      "input = \"state.pushes * -200\"\n[[states]]\nname = \"waits\"\n[[states]]\nname = \"pushes\"\n"
      "[[events]]\nname = \"loaded\"\nto = \"pushes\"\nwhen = \"plate.contact.fz > 50\"\n"
      "[initial]\nvelocity = [0, 0, -0.3]\n";
  const double force = run("loaded_1", grains(0.0, "1", "plate"), scene).summary["max_contact_force_N"];
  ASSERT_GT(force, 100.0);
  const Ran ran = run("loaded_20", grains(0.0, "20", "plate"), scene);
  EXPECT_NEAR(ran.summary["max_contact_force_N"].get<double>(), force, 0.025 * force);
  EXPECT_FALSE(warns(ran, "W1640"));
}

// Grains rest on the gate of a shaft until it opens: no step of their contacts with it is taken for energy of the coupling.
TEST(Gate, OpensUnderItsGrains) {
  const std::string sides = [] {
    std::ostringstream s;
    s << "solid sides\n";
    const double corners[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const auto vertex = [&s](const double* c, double z) {
      s << "vertex " << 0.027 * c[0] << " " << 0.027 * c[1] << " " << z << "\n";
    };
    for (int i = 0; i < 8; ++i) {
      const double *a = corners[i / 2], *b = corners[(i / 2 + 1) % 4];
      s << "facet normal 0 0 0\nouter loop\n";
      vertex(a, 0.0005);
      vertex(b, i % 2 ? 0.15 : 0.0005);
      vertex(i % 2 ? a : b, 0.15);
      s << "endloop\nendfacet\n";
    }
    s << "endsolid sides\n";
    return s.str();
  }();
  std::ostringstream script;
  script << "atom_style granular\natom_modify map array\nboundary f f f\nnewton off\ncommunicate single vel yes\nunits "
            "si\n"
            "region box block -0.3 0.3 -0.1 0.1 -0.3 0.2 units box\ncreate_box 2 box\nneighbor 0.003 bin\n"
            "neigh_modify delay 0\nfix m1 all property/global youngsModulus peratomtype 5e6 5e6\n"
            "fix m2 all property/global poissonsRatio peratomtype 0.3 0.3\n"
            "fix m3 all property/global coefficientRestitution peratomtypepair 2 0.5 0.5 0.5 0.5\n"
            "fix m4 all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5\n"
            "pair_style gran model hertz tangential history\npair_coeff * *\ntimestep 2e-5\n";
  for (int k = 0; k < 48; ++k)
    script << "create_atoms 1 single " << 0.0121 * (k % 4 - 1.5) + 0.0004 * (k % 5 - 2) << " "
           << 0.0121 * (k / 4 % 4 - 1.5) + 0.0004 * (k % 3 - 1) << " " << 0.00601 + 0.0123 * (k / 16) << " units box\n";
  script << "set group all diameter 0.012 density 2600\nfix g all gravity 9.81 vector 0 0 -1\nfix i all nve/sphere\n"
            "fix sides all mesh/surface file sides.stl type 2\nfix geo all couple/mbd/geometry body gate\n"
            "fix gate all mesh/surface fix geo type 2\n"
            "fix w all wall/gran model hertz tangential history mesh n_meshes 2 meshes sides gate\n";
  const std::string gate =
      "end_time = 0.15\ngravity = [0, 0, -9.81]\nground = { kind = \"particles\" }\nparticles = { script = "
      "\"in.coupled\" }\n[output]\nplots = false\nvtk = false\n[[bodies]]\nname = \"gate\"\nmass = 0.1\nshape = { kind "
      "= "
      "\"box\", size = [0.08, 0.08, 0.004], centre = [0, 0, -0.002] }\n[[boundaries]]\nbody = \"gate\"\nsurface = {}\n";
  const std::string slides =
      "[[joints]]\nname = \"rail\"\nkind = \"prismatic\"\nbodies = [\"ground\", \"gate\"]\npoint = [0, 0, 0]\naxis = "
      "\"x\"\n[[drives]]\nname = \"motor\"\nkind = \"torque\"\njoint = \"rail\"\ncommand = { table = [[0, 0], [0.06, "
      "0], "
      "[0.0601, 5], [1, 5]] }\n";
  const std::string flap =
      "[[joints]]\nname = \"hinge\"\nkind = \"revolute\"\nbodies = [\"ground\", \"gate\"]\npoint = [-0.04, 0, -0.002]\n"
      "axis = \"y\"\n[[drives]]\nname = \"latch\"\nkind = \"torque\"\njoint = \"hinge\"\ncommand = { signal = \"hold\" "
      "}\n"
      "[[signals]]\nname = \"hold\"\nkind = \"expression\"\n"
      "input = \"time < 0.06 ? -100 * hinge.angle - 0.2 * gate.wy : 0\"\n";
  for (const std::string& opens : {slides, flap})
    for (const std::string every : {"10", "auto"}) {
      const BeamRun folder("gate");
      folder.write("sides.stl", sides);
      const Outcome outcome = folder.scene(
          script.str() + "fix mbd all couple/mbd every " + every + " mesh gate gate\nthermo 100000\nrun 1000000\n",
          gate + opens);
      EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
      EXPECT_EQ(outcome.text.find("W065"), std::string::npos) << outcome.text;
    }
}

}  // namespace
}  // namespace footfall::test
