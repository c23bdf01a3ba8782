// A bent beam against the same tube as a triangle mesh of stock LIGGGHTS.

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "tests/beam/beam_run.h"
#include "tests/beam/tube.h"

namespace footfall::test {
namespace {

const char* const kModel = "model hertz tangential history rolling_friction cdt";

// Grains pressed into the tube beside the middles of its segments, on 12 lines around it, and held there.
std::string held_grains(const BentTube& tube, double r, double overlap) {
  std::ostringstream text;
  text.precision(17);
  int id = 0;
  for (int s = 0; s < tube.segments; ++s)
    for (int k = 0; k < 12; ++k) {
      const Eigen::Vector3d x = tube.beside(s, 0.4 + 0.02 * k, 2.0 * M_PI * k / 12.0, tube.radius + r - overlap);
      text << "create_atoms 1 single " << x.transpose() << "\ngroup g id " << ++id << "\nset group g diameter "
           << 2.0 * r << " density 2600\ngroup g delete\n";
    }
  text << "neigh_modify exclude type 1 1\n";
  return text.str();
}

// A stock mesh adds up all facets that a grain overlaps: finer than the patch of the contact it gives too
// much force (a factor of 2 where the facets are half as wide as the patch). The comparison is fair where a
// grain touches one facet: facets no narrower than the patch, 2 sqrt(2 r overlap), and grains over the
// middles of facets. What is left is the facet's distance from the tube, R (1 - cos(pi / n)), which lowers
// the overlap: second order in the width of the facets.
TEST(BentBeam, ForceOfAMeshConvergesToThatOfTheBeam) {
  const BentTube tube;
  const double r = 5e-4, overlap = 5e-5;  // the patch is 0.45 mm wide; 384 facets are 0.49 mm wide
  const BeamRun folder("bent");
  const auto hold = [&](const std::string& wall, const std::string& file) {
    return preamble("-0.1 0.2 -0.1 0.1 -0.1 0.2") + "neighbor 0.001 bin\ntimestep 1e-7\npair_style gran " + kModel +
           "\npair_coeff * *\n" + held_grains(tube, r, overlap) + wall + dump_command(file, 1, "fx fy fz");
  };
  const Outcome beam =
      folder.coupled(hold(std::string("fix w all wall/gran/beam ") + kModel + " type 2 body arm\n", "beam.txt") +
                         "fix mbd all couple/mbd every 1\nrun 1\n",
                     "end 1e-7\nbody arm\n" + chain(tube.nodes(), tube.radius));
  ASSERT_EQ(beam.exit_code, 0) << beam.text;
  const Rows expected = folder.dump("beam.txt").at(0);
  ASSERT_EQ(expected.size(), 48u);

  std::vector<double> error;
  for (const int around : {96, 192, 384}) {
    const std::string name = "mesh" + std::to_string(around);
    tube.write_stl(folder.file(name + ".stl"), around);
    const Outcome mesh =
        folder.stock(hold("fix tube all mesh/surface file " + name + ".stl type 2\nfix w all wall/gran " + kModel +
                              " mesh n_meshes 1 meshes tube\n",
                          name + ".txt") +
                     "run 0\n");
    ASSERT_EQ(mesh.exit_code, 0) << mesh.text;
    const Rows found = folder.dump(name + ".txt").at(0);
    double worst = 0.0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const auto force = [i](const Rows& rows) { return Eigen::Vector3d(rows[i][1], rows[i][2], rows[i][3]); };
      ASSERT_GT(force(expected).norm(), 0.0);
      worst = std::max(worst, (force(found) - force(expected)).norm() / force(expected).norm());
    }
    // Hertz' force of an overlap that is smaller by the facet's distance from the tube.
    const double sagitta = tube.radius * (1.0 - std::cos(M_PI / around));
    EXPECT_NEAR(worst, 1.0 - std::pow(1.0 - sagitta / overlap, 1.5), 1e-3);
    error.push_back(worst);
  }
  EXPECT_LT(error[2], 0.04);
  EXPECT_GT(error[0] / error[1], 3.5);  // second order
  EXPECT_GT(error[1] / error[2], 3.8);
}

}  // namespace
}  // namespace footfall::test
