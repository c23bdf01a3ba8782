// A body with a mode against fixed grains in LIGGGHTS, every contact dumped: what the coupling sends is what one gets
// by hand from the contact forces and points, with friction. (A plate of the multibody side on such grains:
// plate_on_lattice_test.cpp.)

#include <gtest/gtest.h>

#include "tests/dem/coupled_run.h"

namespace footfall::test {
namespace {

// The grains do not touch each other: the force on one that touches the boundary is the force of its one contact,
// friction included.
struct Contact {
  Eigen::Vector3d force, centre;  // on the body [N]; of the grain [m]
};

// Frames of a dump of x y z fx fy fz: the grains that feel a force.
std::vector<std::vector<Contact>> read_contacts(const std::string& text) {
  std::vector<std::vector<Contact>> frames;
  std::istringstream in(text);
  std::string line;
  while (std::getline(in, line)) {
    if (line.rfind("ITEM: NUMBER OF ATOMS", 0) != 0) continue;
    std::size_t count = 0;
    in >> count;
    while (std::getline(in, line) && line.rfind("ITEM: ATOMS", 0) != 0) {
    }
    frames.emplace_back();
    for (std::size_t k = 0; k < count; ++k) {
      Contact c;
      in >> c.centre[0] >> c.centre[1] >> c.centre[2] >> c.force[0] >> c.force[1] >> c.force[2];
      c.force = -c.force;
      if (!c.force.isZero(0.0)) frames.back().push_back(c);
    }
  }
  return frames;
}

std::string dump_contacts(int every) {
  return "dump touch all custom " + std::to_string(every) +
         " contacts.txt x y z fx fy fz\ndump_modify touch format \"%.17g %.17g %.17g %.17g %.17g %.17g\"\n";
}

// Weights of the corners for the foot of the perpendicular from p.
Eigen::Vector3d barycentric(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                            const Eigen::Vector3d& c) {
  Eigen::Matrix<double, 3, 2> edges;
  edges << b - a, c - a;
  const Eigen::Vector2d uv = edges.colPivHouseholderQr().solve(p - a);
  return {1.0 - uv.sum(), uv[0], uv[1]};
}

constexpr double kDt = 5e-5;

TEST(ModalContacts, LoadAndPowerAreThoseOfTheDumpedForces) {
  const RunFolder folder("modal_contacts");
  const Surface pad = box({0.24, 0.2, 0.02}, 3);
  write_stl((folder.path() / "pad.stl").string(), pad);
  folder.write(
      "in", script_head("-0.4 0.4 -0.3 0.3 -0.2 0.2", "2 1 1", kDt) +
                "lattice sc 0.047\nregion grains block -0.1 0.1 -0.05 0.05 -0.001 0.001 units box\ncreate_atoms 1 "
                "region grains\n"
                "set group all diameter 0.04 density 2600\n"
                "fix geo all couple/mbd/geometry body pad\nfix pad all mesh/surface fix geo type 2\n"
                "fix wm all wall/gran model hertz tangential history rolling_friction cdt mesh n_meshes 1 meshes pad\n"
                "fix mbd all couple/mbd every 1 mesh pad pad\n" +
                dump_contacts(1) + "thermo 1000\nrun 100000\n");
  const Eigen::Vector3d place(0.011, 0.007, 0.02995), v(0.3, -0.1, -0.02);
  const double rate = -0.4;  // of the mode, whose shape is x^2 + y^2 at the nodes
  const Outcome outcome =
      folder.coupled(2, "-in in -log log",
                     "until 0.005 out table.csv body pad pad.stl 0.011 0.007 0.02995 modal 0.3 -0.1 -0.02 bowl -0.4");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
  const Table table(folder.path() / "table.csv");
  const std::vector<std::vector<Contact>> frames = read_contacts(folder.read("contacts.txt"));
  ASSERT_EQ(table.rows(), 100u);
  ASSERT_EQ(frames.size(), 101u);

  // At each step by hand: force, modal force sum Phi(c) . f, and the power sum f . v(c) with the velocity of the
  // boundary at the contact.
  struct ByHand {
    Eigen::Vector3d F = Eigen::Vector3d::Zero();
    double q = 0.0, power = 0.0, size = 0.0;
  };
  std::vector<ByHand> hand(frames.size());
  int sliding_contacts = 0;
  for (std::size_t step = 0; step < frames.size(); ++step) {
    const double t = static_cast<double>(step) * kDt;
    const auto corner = [&](int j) -> Eigen::Vector3d {
      const Eigen::Vector3d x0 = pad.nodes.col(j);
      return place + v * t + x0 + Eigen::Vector3d(0, 0, x0.head<2>().squaredNorm() * rate * t);
    };
    for (const Contact& c : frames[step]) {
      // The face above the grain, and its shape function at the foot of the perpendicular.
      int above = 0;
      double shape = 0.0;
      for (const Eigen::Vector3i& nodes : pad.triangles) {
        if (corner(nodes[0]).z() > 0.03 || corner(nodes[1]).z() > 0.03 || corner(nodes[2]).z() > 0.03) continue;
        const Eigen::Vector3d w = barycentric(c.centre, corner(nodes[0]), corner(nodes[1]), corner(nodes[2]));
        if (w.minCoeff() < 0.0) continue;
        ++above;
        shape = 0.0;
        for (int k = 0; k < 3; ++k) shape += w[k] * pad.nodes.col(nodes[k]).head<2>().squaredNorm();
      }
      ASSERT_EQ(above, 1) << "a grain under an edge: choose another place for the pad";
      hand[step].F += c.force;
      hand[step].q += shape * c.force.z();
      hand[step].power += c.force.dot(v + Eigen::Vector3d(0, 0, shape * rate));
      hand[step].size += c.force.norm();
      sliding_contacts += std::hypot(c.force.x(), c.force.y()) > 0.0;
    }
  }
  EXPECT_GT(sliding_contacts, 100);
  // The mean of a window of one step weighs both ends equally; signs as the program's.
  double largest_force = 0.0, largest_q = 0.0;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const ByHand &a = hand[k], &b = hand[k + 1];
    const Eigen::Vector3d F = table.vector(k, "fx", "fy", "fz");
    const double scale = std::max(1.0, 0.5 * (a.size + b.size));
    EXPECT_LT((F - 0.5 * (a.F + b.F)).norm(), 1e-10 * scale) << "window " << k;
    EXPECT_NEAR(table["q"][k], 0.5 * (a.q + b.q), 1e-10 * scale * 0.02) << "window " << k;  // shapes up to 0.02
    // Virtual work: F . v + q da = sum over contacts of f . v(c).
    EXPECT_NEAR(F.dot(v) + table["q"][k] * rate, 0.5 * (a.power + b.power), 1e-12 * scale) << "window " << k;
    EXPECT_NEAR(table["work"][k], 0.5 * (a.power + b.power) * kDt, 1e-10 * scale * kDt) << "window " << k;
    largest_force = std::max(largest_force, F.norm());
    largest_q = std::max(largest_q, std::abs(table["q"][k]));
  }
  EXPECT_GT(largest_force, 10.0);
  EXPECT_GT(largest_q, 0.01);
}

}  // namespace
}  // namespace footfall::test
