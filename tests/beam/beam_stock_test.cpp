// A straight beam at rest, or sliding along itself, is a cylinder that stock LIGGGHTS has: the same forces,
// history and motion of the grains.

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

#include "tests/beam/beam_run.h"

namespace footfall::test {
namespace {

// Round-off of a few thousand steps, relative to the largest number of each column: measured below 2e-13.
constexpr double kRoundOff = 1e-11;

const char* const kHertz = "model hertz tangential history rolling_friction cdt";

struct Case {
  std::string name;
  std::string model;                 // of pairs and walls
  std::vector<std::string> columns;  // dumped besides motion, force and torque: history and what keywords store
  std::string axis;                  // x, y or z
  double sliding = 0.0;              // of the cylinder along its axis [m/s]
  std::string keywords = {};         // of the wall
  std::string constants = {};        // of the model, besides those of all
};

std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

std::vector<std::string> history(int count) {
  std::vector<std::string> columns;
  for (int i = 1; i <= count; ++i) columns.push_back("f_history_w[" + std::to_string(i) + "]");
  return columns;
}

// Grains thrown and pressed (3 N) on a cylinder of 0.055 m from all sides: they hit, slide, roll and fly off,
// past the joints of the beam.
std::string grains(const Case& c) {
  std::string text;
  for (int i = 0; i < 8; ++i) {
    const double angle = 2.0 * M_PI * i / 8.0, along = -0.18 + 0.045 * i;
    const double cosine = std::cos(angle), sine = std::sin(angle);
    const auto turned_to_axis = [&c](double a, double b, double d) {
      const std::string u = std::to_string(a), v = std::to_string(b), w = std::to_string(d);
      return c.axis == "x" ? u + " " + v + " " + w : c.axis == "y" ? w + " " + u + " " + v : v + " " + w + " " + u;
    };
    const std::string id = std::to_string(i + 1), group = "g" + id;
    text += "create_atoms 1 single " + turned_to_axis(along, 0.078 * cosine, 0.078 * sine) + "\n";
    text += "group " + group + " id " + id + "\n";
    text += "set group " + group + " diameter 0.04 density 2600\n";
    text += "velocity " + group + " set " +
            turned_to_axis(i % 2 == 0 ? 0.6 : -0.5, -0.3 * cosine - 0.4 * sine, -0.3 * sine + 0.4 * cosine) + "\n";
    text += "fix press" + id + " " + group + " addforce " + turned_to_axis(0.0, -3.0 * cosine, -3.0 * sine) + "\n";
  }
  return text;
}

std::string script(const Case& c, const std::string& wall, const std::string& file) {
  std::string columns = "x y z vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz";
  for (const std::string& column : c.columns) columns += " " + column;
  return preamble("-0.5 0.5 -0.5 0.5 -0.5 0.5") + c.constants + "timestep 2e-5\npair_style gran " + c.model +
         "\npair_coeff * *\n" +
         "fix c1 all property/global thermalConductivity peratomtype 5 5\n"
         "fix c2 all property/global thermalCapacity peratomtype 20 20\n"
         "fix heat all heat/gran/conduction initial_temperature 300\n" +
         grains(c) + "fix w all wall/gran" + wall + "\nfix integr all nve/sphere\n" +
         "fix g all gravity 9.81 vector 0.1 -0.2 -1\n" + dump_command(file, 50, columns);
}

// Constants of contact models: one value for all pairs of types, for each type, or for all.
std::string of_pairs(const std::string& name, const std::string& value) {
  return "fix c_" + name + " all property/global " + name + " peratomtypepair 2 " + value + " " + value + " " + value +
         " " + value + "\n";
}
std::string of_types(const std::string& name, const std::string& value) {
  return "fix c_" + name + " all property/global " + name + " peratomtype " + value + " " + value + "\n";
}
std::string of_all(const std::string& name, const std::string& value) {
  return "fix c_" + name + " all property/global " + name + " scalar " + value + "\n";
}

// Springs and dashpots of the stiffness variants; k in N/m, or N/m^2 for Hertz.
std::string springs(const std::string& k, const std::string& gamma) {
  return of_pairs("kn", k) + of_pairs("kt", k) + of_pairs("gamman", gamma) + of_pairs("gammat", gamma);
}

const std::string kPlastic =
    of_pairs("coefficientAdhesionStiffness", "0.2") + of_pairs("coefficientPlasticityDepth", "0.05");
const std::string kLuding = kPlastic + of_pairs("LoadingStiffness", "2e5") + of_pairs("UnloadingStiffness", "1.5") +
                            of_pairs("pullOffForce", "0.1");
const std::string kEdinburgh = of_pairs("coefficientAdhesionStiffness", "0.2") + of_pairs("UnloadingStiffness", "2") +
                               of_all("adhesionExponent", "1.5") + of_all("overlapExponent", "1.5") +
                               of_pairs("pullOffForce", "-0.1") + of_pairs("surfaceEnergy", "1");
const std::string kWet = of_all("surfaceLiquidContentInitial", "0.01") + of_all("surfaceTension", "0.073") +
                         of_all("fluidViscosity", "0.001") + of_types("contactAngle", "0.5") +
                         of_all("minSeparationDistanceRatio", "1.01") + of_all("maxSeparationDistanceRatio", "1.1");

class BeamLikeCylinder : public testing::TestWithParam<Case> {};

TEST_P(BeamLikeCylinder, SameForcesHistoryAndMotionToRoundOff) {
  const Case& c = GetParam();
  const BeamRun folder("cylinder_" + c.name);
  std::string wall = " " + c.model + " primitive type 2 " + c.axis + "cylinder 0.055 0 0";
  if (c.sliding != 0.0) wall += " shear " + c.axis + " " + std::to_string(c.sliding);
  const Outcome stock = folder.stock(script(c, wall + c.keywords, "stock.txt") + "run 3000\n");
  ASSERT_EQ(stock.exit_code, 0) << stock.text;

  const auto on_axis = [&c](const std::string& s) {
    return c.axis == "x" ? s + " 0 0" : c.axis == "y" ? "0 " + s + " 0" : "0 0 " + s;
  };
  std::vector<std::string> nodes;
  for (const char* station : {"-0.4", "-0.11", "0.0", "0.033", "0.4"}) nodes.push_back(on_axis(station));
  const std::string motion =
      "end 0.06\nbody tine\n" + chain(nodes, 0.055) + "velocity " + on_axis(std::to_string(c.sliding)) + "\n";
  const Outcome beam = folder.coupled(script(c, "/beam " + c.model + " type 2 body tine" + c.keywords, "beam.txt") +
                                          "fix mbd all couple/mbd every 5\nrun 3000\n",
                                      motion);
  ASSERT_EQ(beam.exit_code, 0) << beam.text;

  const Dump expected = folder.dump("stock.txt");
  ASSERT_EQ(expected.size(), 61u);
  EXPECT_LT(relative_difference(expected, folder.dump("beam.txt")), kRoundOff);
  int touching = 0;  // friction turns a grain that touches
  for (const auto& [step, rows] : expected)
    for (const auto& row : rows) touching += row[13] != 0.0 || row[14] != 0.0 || row[15] != 0.0 ? 1 : 0;
  EXPECT_GT(touching, 50);
}

INSTANTIATE_TEST_SUITE_P(
    Models, BeamLikeCylinder,
    testing::Values(
        Case{"hertz", kHertz, history(3), "x"},  //
        Case{"hertz_y", kHertz, history(3), "y"}, Case{"hertz_z", kHertz, history(3), "z"},
        Case{"sliding", kHertz, history(3), "x", 0.7},
        Case{"hooke", "model hooke tangential history rolling_friction epsd2", history(6), "z"},
        Case{"cohesion", "model hertz tangential history cohesion sjkr rolling_friction cdt", history(3), "x"},
        Case{"no_history", "model hertz tangential no_history", {}, "x"},
        Case{"stored_force", kHertz, {"f_force_w[1]", "f_force_w[2]", "f_force_w[3]"}, "x", 0.0, " store_force yes"},
        Case{"warm", kHertz, {"f_Temp", "f_heatFlux"}, "x", 0.0, " temperature 600"}),
    [](const auto& model) { return model.param.name; });

// Every normal, tangential, rolling friction and cohesion model that stock walls take.
INSTANTIATE_TEST_SUITE_P(
    EveryModel, BeamLikeCylinder,
    testing::Values(Case{"hertz_stiffness", "model hertz/stiffness tangential history", history(3), "x", 0, "",
                         springs("2e7", "3e5")},
                    Case{"hooke_stiffness", "model hooke/stiffness tangential history", history(3), "y", 0, "",
                         springs("1e5", "500")},
                    Case{"hooke_hysteresis", "model hooke/hysteresis tangential history", history(4), "z", 0, "",
                         kPlastic + of_pairs("coefficientMaxElasticStiffness", "1.5")},
                    Case{"luding", "model luding tangential no_history", history(3), "x", 0, "", kLuding},
                    Case{"edinburgh", "model edinburgh tangential no_history", history(4), "x", 0, "", kEdinburgh},
                    Case{"edinburgh_stiffness", "model edinburgh/stiffness tangential no_history", history(4), "x", 0,
                         "", kEdinburgh + of_pairs("LoadingStiffness", "2e5")},
                    Case{"thornton_ning", "model thornton_ning tangential history", history(3), "y", 0, "",
                         of_pairs("surfaceEnergy", "20") + of_types("coefficientYieldRatio", "0.3")},
                    Case{"tan_luding", "model hooke tangential tan_luding", history(3), "x", 0, "",
                         of_pairs("coeffFrictionStiffness", "0.5") + of_pairs("FrictionViscosity", "0.1") +
                             of_pairs("FluidViscosity", "0.1")},
                    Case{"epsd", "model hertz tangential history rolling_friction epsd", history(6), "x"},
                    Case{"epsd3", "model hooke tangential history rolling_friction epsd3", history(6), "x", 0, "",
                         of_all("rollingStiffness", "100")},
                    Case{"roll_luding", "model hooke tangential history rolling_friction luding", history(6), "x", 0,
                         "", of_pairs("coeffRollingStiffness", "0.2")},
                    Case{"sjkr2", "model hertz tangential history cohesion sjkr2", history(3), "z"},
                    Case{"washino", "model hertz tangential history cohesion washino/capillary/viscous", history(4),
                         "x", 0, "", kWet},
                    Case{"easo", "model hertz tangential history cohesion easo/capillary/viscous", history(4), "x", 0,
                         "", kWet}),
    [](const auto& model) { return model.param.name; });

// Two beams are two contacts: a grain falls between two cylinders and stays there, as between two of stock
// LIGGGHTS'.
TEST(TwoBeams, HoldAGrainBetweenThemLikeTwoCylinders) {
  const BeamRun folder("two_beams");
  const auto fall = [](const std::string& walls, const std::string& file) {
    return preamble("-0.5 0.5 -0.5 0.5 -0.5 0.5") + "timestep 2e-5\npair_style gran " + kHertz + "\npair_coeff * *\n" +
           "create_atoms 1 single 0.004 0.1 0.06\nset group all diameter 0.08 density 2600\nvelocity all set "
           "0.02 0.15 -0.1\n" +
           walls + "fix integr all nve/sphere\nfix g all gravity 9.81 vector 0 0 -1\n" +
           dump_command(file, 50,
                        "x y z vx vy vz omegax omegay omegaz fx fy fz f_history_w1[1] f_history_w1[2] "
                        "f_history_w2[1] f_history_w2[2]");
  };
  const std::string wall = std::string(" all wall/gran ") + kHertz + " primitive type 2 ycylinder ";
  const Outcome stock = folder.stock(
      fall("fix w1" + wall + "0.03 0 -0.05\nfix w2" + wall + "0.02 0 0.045\n", "stock.txt") + "run 10000\n");
  ASSERT_EQ(stock.exit_code, 0) << stock.text;
  const std::string beam = std::string(" all wall/gran/beam ") + kHertz + " type 2 body fork";
  const std::string fork = "end 0.2\nbody fork\n" + chain({"-0.05 -0.4 0", "-0.05 0.1 0", "-0.05 0.4 0"}, 0.03) +
                           chain({"0.045 -0.4 0", "0.045 0.12 0", "0.045 0.4 0"}, 0.02, 3, 7);
  const std::string run = "fix mbd all couple/mbd every 10\nrun 10000\n";
  const Outcome coupled =
      folder.coupled(fall("fix w1" + beam + " chain 0\nfix w2" + beam + " chain 7\n", "beam.txt") + run, fork);
  ASSERT_EQ(coupled.exit_code, 0) << coupled.text;
  const Dump expected = folder.dump("stock.txt");
  EXPECT_LT(relative_difference(expected, folder.dump("beam.txt")), kRoundOff);

  // One fix for both: the same contacts, and its second history has a name of its own.
  std::string script = fall("fix w1" + beam + "\n", "one_fix.txt") + run;
  for (std::size_t at; (at = script.find("history_w2[")) != std::string::npos;) script.replace(at, 11, "history_w1_2[");
  const Outcome one_fix = folder.coupled(script, fork);
  ASSERT_EQ(one_fix.exit_code, 0) << one_fix.text;
  EXPECT_EQ(relative_difference(folder.dump("beam.txt"), folder.dump("one_fix.txt")), 0.0);
  const std::vector<double>& end = expected.rbegin()->second.at(0);
  EXPECT_NE(end[13], 0.0);  // touches both
  EXPECT_NE(end[15], 0.0);
}

}  // namespace
}  // namespace footfall::test
