// A straight beam at rest, or sliding along itself, is a cylinder that stock LIGGGHTS has: the same forces,
// history and motion of the grains.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "tests/beam/beam_run.h"

namespace footfall::test {
namespace {

struct Case {
  std::string name;
  std::string model;     // of pairs and walls
  int history;           // numbers per contact
  std::string axis;      // x or z
  double sliding = 0.0;  // of the cylinder along its axis [m/s]
};

// Grains thrown and pressed (3 N) on a cylinder of 0.055 m from all sides: they hit, slide, roll and fly off,
// past the joints of the beam.
std::string grains(const Case& c) {
  std::string text;
  int id = 0;
  for (int i = 0; i < 8; ++i) {
    const double angle = 2.0 * M_PI * i / 8.0, along = -0.18 + 0.045 * i;
    const double y = 0.078 * std::cos(angle), z = 0.078 * std::sin(angle);
    const double vy = -0.3 * std::cos(angle) - 0.4 * std::sin(angle),
                 vz = -0.3 * std::sin(angle) + 0.4 * std::cos(angle);
    const double v = i % 2 == 0 ? 0.6 : -0.5;
    const auto vec = [&](double a, double b, double d) {
      return std::to_string(c.axis == "x" ? a : b) + " " + std::to_string(c.axis == "x" ? b : d) + " " +
             std::to_string(c.axis == "x" ? d : a);
    };
    ++id;
    text += "create_atoms 1 single " + vec(along, y, z) + "\n";
    text += "group g" + std::to_string(id) + " id " + std::to_string(id) + "\n";
    text += "set group g" + std::to_string(id) + " diameter 0.04 density 2600\n";
    text += "velocity g" + std::to_string(id) + " set " + vec(v, vy, vz) + "\n";
    text += "fix press" + std::to_string(id) + " g" + std::to_string(id) + " addforce " +
            vec(0.0, -3.0 * std::cos(angle), -3.0 * std::sin(angle)) + "\n";
  }
  return text;
}

std::string script(const Case& c, const std::string& wall, const std::string& file) {
  std::string columns = "x y z vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz";
  for (int i = 1; i <= c.history; ++i) columns += " f_history_w[" + std::to_string(i) + "]";
  return preamble("-0.5 0.5 -0.5 0.5 -0.5 0.5") + "pair_style gran " + c.model + "\npair_coeff * *\n" +
         grains(c) + "fix w all wall/gran" + wall + "\nfix integr all nve/sphere\n" +
         "fix g all gravity 9.81 vector 0.1 -0.2 -1\n" + dump_command(file, 50, columns);
}

std::ostream& operator<<(std::ostream& out, const Case& c) {
  return out << c.name;
}

class BeamLikeCylinder : public testing::TestWithParam<Case> {};

TEST_P(BeamLikeCylinder, SameForcesHistoryAndMotionToRoundOff) {
  const Case& c = GetParam();
  const RunFolder folder("cylinder_" + c.name);
  const std::string shear = c.sliding != 0.0 ? " shear " + c.axis + " " + std::to_string(c.sliding) : "";
  const Outcome stock = folder.stock(
      script(c, " " + c.model + " primitive type 2 " + c.axis + "cylinder 0.055 0 0" + shear, "stock.txt") +
      "run 3000\n");
  ASSERT_EQ(stock.code, 0) << stock.output;

  std::vector<std::string> nodes;
  for (const char* s : {"-0.4", "-0.11", "0.0", "0.033", "0.4"})
    nodes.push_back(c.axis == "x" ? std::string(s) + " 0 0" : std::string("0 0 ") + s);
  std::string motion = "end 0.06\n" + straight_chain("tine", nodes, 0.055);
  if (c.sliding != 0.0)
    motion += "velocity " + (c.axis == "x" ? std::to_string(c.sliding) + " 0 0\n"
                                           : "0 0 " + std::to_string(c.sliding) + "\n");
  const Outcome beam = folder.coupled(script(c, "/beam " + c.model + " type 2 body tine", "beam.txt") +
                                          "fix mbd all couple/mbd every 5\nrun 3000\n",
                                      motion);
  ASSERT_EQ(beam.code, 0) << beam.output;

  const Dump expected = folder.dump("stock.txt"), found = folder.dump("beam.txt");
  ASSERT_EQ(expected.size(), 61u);
  ASSERT_EQ(found.size(), expected.size());
  std::vector<double> largest;  // of each column: what a difference is measured against
  for (const auto& [step, rows] : expected)
    for (const auto& row : rows) {
      largest.resize(row.size(), 0.0);
      for (std::size_t k = 0; k < row.size(); ++k) largest[k] = std::max(largest[k], std::abs(row[k]));
    }
  double worst = 0.0;
  int touching = 0;  // friction turns a grain that touches
  for (const auto& [step, rows] : expected) {
    ASSERT_EQ(rows.size(), 8u);
    ASSERT_EQ(found.at(step).size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      touching += std::abs(rows[i][13]) + std::abs(rows[i][14]) + std::abs(rows[i][15]) > 0.0 ? 1 : 0;
      for (std::size_t k = 0; k < rows[i].size(); ++k) {
        const double difference = std::abs(rows[i][k] - found.at(step)[i][k]);
        if (difference > 0.0) worst = std::max(worst, difference / largest[k]);
      }
    }
  }
  // Round-off of 3000 steps, relative to the largest number of each column: measured below 2e-13.
  EXPECT_LT(worst, 1e-11);
  EXPECT_GT(touching, 100);
}

INSTANTIATE_TEST_SUITE_P(
    Models, BeamLikeCylinder,
    testing::Values(Case{"hertz", "model hertz tangential history rolling_friction cdt", 3, "x"},
                    Case{"hertz_z", "model hertz tangential history rolling_friction cdt", 3, "z"},
                    Case{"sliding", "model hertz tangential history rolling_friction cdt", 3, "x", 0.7},
                    Case{"hooke", "model hooke tangential history rolling_friction epsd2", 6, "z"},
                    Case{"cohesion", "model hertz tangential history cohesion sjkr rolling_friction cdt", 3,
                         "x"},
                    Case{"no_history", "model hertz tangential no_history", 0, "x"}),
    [](const auto& model) { return model.param.name; });

}  // namespace
}  // namespace footfall::test
