// mbd_solver/cli/analysis/replay_script.h: the stock script that replays a run's motion, as text.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "coupler/base/errors.h"
#include "mbd_solver/cli/analysis/replay_script.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

class ReplayTest : public ::testing::Test, protected TemporaryFolder {
 protected:
  ReplayTest() { std::filesystem::create_directories(folder_ / "motion"); }
  Replay replay(const std::string& script) const {
    return stock_replay(write("in.coupled", script), (folder_ / "motion").string(), (folder_ / "out").string(), 1e-3);
  }
  // Falls at 2 m/s, then faster, and turns about z at 5 rad/s; windows of 2 steps.
  void record_pad() const {
    write(
        "motion/pad.csv",
        "# units: s,m,m,m,rad,rad,rad,m,N,N,N\ntime,x,y,z,rx,ry,rz,bend,fx,fy,fz\n0,1,2,3,0,0,0,0,0,0,0\n"
        "0.002,1,2,2.996,0,0,0.01,0,0,0,0\n0.004,1,2,2.990,0,0,0.02,0.001,0,0,7\n0.005,1,2,2.987,0,0,0.025,0,0,0,9\n");
  }
};

const char* const kScript =
    "timestep 1e-3\nfix geo all couple/mbd/geometry body pad\nfix mesh all mesh/surface fix geo type 2\n"
    "fix wall all wall/gran model hertz mesh n_meshes 1 meshes mesh\nfix rod all wall/gran/beam model hertz &\n  type "
    "2 body rod\n"
    "fix mbd all couple/mbd every 2 mesh mesh pad\nthermo_style custom step f_mbd[1] f_rod[1] &\n cpu\nfix p all print "
    "10 \"f_mbd[2]\"\n"
    "dump grains all custom 2 ${out}/grains_*.txt id x y z radius\nrun 1000000\nprint after\n";

TEST_F(ReplayTest, TakesTheCouplingOutAndPutsMoversIn) {
  record_pad();
  const Replay r = replay(kScript);
  EXPECT_EQ(r.script.find("couple/mbd"), std::string::npos) << r.script;
  EXPECT_EQ(r.script.find("gran/beam"), std::string::npos);
  EXPECT_EQ(r.script.find("f_mbd"), std::string::npos);
  EXPECT_NE(r.script.find("fix mesh all mesh/surface/stress file " + (folder_ / "motion/pad.stl").string() + " type 2"),
            std::string::npos);
  EXPECT_NE(r.script.find("fix wall all wall/gran model hertz mesh n_meshes 1 meshes mesh"), std::string::npos);
  EXPECT_NE(
      r.script.find("fix replay1_move all move/mesh mesh mesh linear/variable v_replay1_vx v_replay1_vy v_replay1_vz"),
      std::string::npos);
  EXPECT_NE(r.script.find("rotate/variable origin 1 2 3 axis 0 0 1 omega v_replay1_wz"), std::string::npos);
  EXPECT_NE(r.script.find("thermo_style custom step cpu\n"), std::string::npos);
  EXPECT_NE(r.script.find("dump grains all custom 2 ${out}/grains_*.txt id x y z radius"), std::string::npos);
  EXPECT_NE(r.script.find("run 5 pre no post no every 2 \"next "), std::string::npos);
  EXPECT_EQ(r.bodies, std::vector<std::string>{"pad"});
  ASSERT_EQ(r.notes.size(), 1u);
  EXPECT_NE(r.notes[0].find("fix rod"), std::string::npos);
}

// The script of [particles.box] names its meshes in a loop over a variable.
TEST_F(ReplayTest, WritesLoopsOverMeshesOut) {
  record_pad();
  std::filesystem::copy_file(folder_ / "motion/pad.csv", folder_ / "motion/foot.csv");
  const std::map<std::string, std::string> variables = {{"mesh_bodies", "pad foot"},
                                                        {"mesh_count", "2"},
                                                        {"beam_count", "1"},
                                                        {"meshes", "mesh_pad mesh_foot"},
                                                        {"couples", "mesh mesh_pad pad mesh mesh_foot foot"}};
  const Replay r = stock_replay(FOOTFALL_SOURCE_DIR "/inputs/box/in.grains", (folder_ / "motion").string(),
                                (folder_ / "out").string(), 1e-3, variables);
  EXPECT_EQ(r.bodies, (std::vector<std::string>{"pad", "foot"}));
  for (const char* body : {"pad", "foot"})
    EXPECT_NE(r.script.find("fix mesh_" + std::string(body) + " all mesh/surface/stress file " +
                            (folder_ / "motion" / body).string() + ".stl type 2"),
              std::string::npos)
        << r.script;
  for (const char* gone : {"all couple/mbd", "${body}", "next_body", "gran/beam", "f_mbd"})
    EXPECT_EQ(r.script.find(gone), std::string::npos) << gone << "\n" << r.script;
  EXPECT_NE(r.script.find("fix contact all wall/gran model ${model} mesh n_meshes ${mesh_count} meshes ${meshes}"),
            std::string::npos);
  ASSERT_EQ(r.notes.size(), 1u);
  EXPECT_NE(r.notes[0].find("beams"), std::string::npos);
}

TEST_F(ReplayTest, VelocitiesAreThoseOfTheWindows) {
  record_pad();
  const Replay r = replay(kScript);
  EXPECT_EQ(r.steps, 5);
  EXPECT_EQ(r.every, 2);
  const auto numbers = [&](const std::string& name) {
    std::istringstream text(r.files.at(name));
    std::vector<double> values;
    for (double value; text >> value;) values.push_back(value);
    return values;
  };
  const std::vector<double> vz = numbers("replay1_vz.txt"), wz = numbers("replay1_wz.txt"),
                            vx = numbers("replay1_vx.txt");
  ASSERT_EQ(vz.size(), 4u);  // three spans of two steps, and one line for the last `next`
  EXPECT_NEAR(vz[0], -2.0, 1e-9);
  EXPECT_NEAR(vz[1], -3.0, 1e-9);
  EXPECT_NEAR(wz[0], 5.0, 1e-9);
  EXPECT_NEAR(wz[1], 5.0, 1e-9);
  EXPECT_EQ(vx[0], 0.0);
}

TEST_F(ReplayTest, SaysWhatItCannotReplay) {
  EXPECT_THROW(replay("run 100\n"), InputError);                                 // no coupling
  EXPECT_THROW(replay(kScript), InputError);                                     // the motion was not recorded
  EXPECT_THROW(replay("fix mbd all couple/mbd every 2\nrun 10\n"), InputError);  // no mesh
}

}  // namespace
}  // namespace footfall
