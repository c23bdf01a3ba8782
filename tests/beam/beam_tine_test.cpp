// A flexible tine dragged along fixed grains: the whole loop, mbd_solver with modes and LIGGGHTS with a beam
// wall, against beam theory.

#include <gtest/gtest.h>

#include <cmath>

#include "mbd_solver/output/history.h"
#include "tests/beam/beam_run.h"

namespace footfall::test {
namespace {

// A plastic rod hangs from a carriage, is pushed 6 mm against a row of fixed grains, and dragged along it at
// 0.2 m/s. A shoe of 1 g at its end shows where that end is.
const char* const kScene = R"(title = "tine along a row of fixed grains"
end_time = 0.29
gravity = [0, 0, 0]
materials.plastic = { density = 1400, young = 3e9, poisson = 0.3 }
[[bodies]]
name = "carriage"
mass = 1.0
shape = { kind = "box", size = [0.1, 0.1, 0.05], centre = [0, 0, 0.325] }
[[bodies]]
name = "tine"
material = "plastic"
shape = { kind = "rod", from = [0, 0, 0.3], to = [0, 0, 0], diameter = 0.012 }
flexible = { elements = 12, modes = 8, damping = 0.05 }
[[bodies]]
name = "shoe"
mass = 0.001
shape = { kind = "sphere", centre = [0, 0, 0], radius = 0.004 }
[[joints]]
name = "drive"
type = "prescribed"
bodies = ["ground", "carriage"]
point = [0, 0, 0.3]
axis = [0, 0, 1]
axis2 = [1, 0, 0]
[joints.motion]
x = { table = [[0, 0], [0.03, 0.001], [0.06, 0.005], [0.09, 0.006], [0.12, 0.006], [0.3, 0.006]] }
y = { polynomial = [0, 0.2] }
z = { polynomial = [0] }
rotation = { polynomial = [0] }
hold_other_rotations = true
[[joints]]
name = "clamp"
type = "fixed"
bodies = ["carriage", "tine"]
point = [0, 0, 0.3]
[[joints]]
name = "end"
type = "fixed"
bodies = ["tine", "shoe"]
point = [0, 0, 0]
[[boundaries]]
body = "tine"
beams = { segments = 12 }
[ground]
kind = "particles"
[particles]
script = "in.coupled"
ranks = 1
[output]
interval = 5e-4
plots = false
)";

std::string row_of_grains() {
  std::string text = preamble("-0.1 0.1 -0.1 0.2 -0.1 0.4", {0.4, 0.3, 0.1}) +
                     "timestep 2e-5\npair_style gran model hertz tangential history\npair_coeff * *\n";
  for (int i = 0; i < 20; ++i) text += "create_atoms 1 single 0.0165 " + std::to_string(-0.05 + 0.008 * i) + " 0.03\n";
  return text +
         "set group all diameter 0.02 density 2600\nneigh_modify exclude type 1 1\n"
         "fix w all wall/gran/beam model hertz tangential history type 2 body tine\nfix mbd all couple/mbd "
         "every 5\nrun 100000\n";
}

// The means over whole periods of the row (8 mm at 0.2 m/s = 0.04 s) obey statics, as the tine is linear:
// force F at the distance a below the clamp moves the end by F a^2 (3 L - a) / (6 E I). F and its moment,
// which gives a, are what mbd_solver got from LIGGGHTS.
TEST(Tine, BendsAsItsContactForceAsks) {
  const BeamRun folder("tine");
  const Outcome outcome = folder.scene(row_of_grains(), kScene);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
  const History history = read_history(folder.file("out/history.csv"));
  const auto mean = [&history](const std::string& name) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < history.columns[0].size(); ++i) {
      const double t = history.columns[0][i];
      if (t < 0.13 - 1e-9 || t > 0.29 - 1e-9) continue;  // four periods
      sum += history.column(name)[i];
      ++count;
    }
    return sum / count;
  };
  const double L = 0.3, EI = 3e9 * M_PI * std::pow(0.012, 4) / 64.0;
  const double fx = mean("tine.contact.fx"), fy = mean("tine.contact.fy");
  const double height_x = mean("tine.z") + mean("tine.contact.my") / fx;
  const double height_y = mean("tine.z") - mean("tine.contact.mx") / fy;
  EXPECT_NEAR(height_x, 0.03, 2e-3);  // where the grains are
  EXPECT_NEAR(height_y, 0.03, 2e-3);
  const auto deflection = [&](double f, double height) {
    const double a = L - height;
    return f * a * a * (3.0 * L - a) / (6.0 * EI);
  };
  const double dx = mean("shoe.x") - mean("carriage.x"), dy = mean("shoe.y") - mean("carriage.y");
  EXPECT_LT(dx, -5e-3);
  EXPECT_LT(dy, -1e-3);
  // Measured: 0.9996 and 1.0008.
  EXPECT_NEAR(dx / deflection(fx, height_x), 1.0, 0.01);
  EXPECT_NEAR(dy / deflection(fy, height_y), 1.0, 0.01);
}

}  // namespace
}  // namespace footfall::test
