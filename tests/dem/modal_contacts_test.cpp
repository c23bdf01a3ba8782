// A body with a mode against fixed grains in LIGGGHTS, every contact dumped: what the coupling sends is what one gets by hand from the
// contact forces and points. And a flexible plate of the multibody side that comes to rest on such grains.

#include <gtest/gtest.h>

#include "mbd_solver/model/flexible/fe_model.h"
#include "mbd_solver/model/flexible/mesh_generator.h"
#include "mbd_solver/output/history.h"
#include "tests/dem/coupled_run.h"

namespace footfall::test {
namespace {

// The grains do not touch each other: the force on one that touches the boundary is the force of its one contact, friction included.
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
Eigen::Vector3d barycentric(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
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
  folder.write("in", script_head("-0.4 0.4 -0.3 0.3 -0.2 0.2", "2 1 1", kDt) +
                         "lattice sc 0.047\nregion grains block -0.1 0.1 -0.05 0.05 -0.001 0.001 units box\ncreate_atoms 1 region grains\n"
                         "set group all diameter 0.04 density 2600\n"
                         "fix geo all couple/mbd/geometry body pad\nfix pad all mesh/surface fix geo type 2\n"
                         "fix wm all wall/gran model hertz tangential history rolling_friction cdt mesh n_meshes 1 meshes pad\n"
                         "fix mbd all couple/mbd every 1 mesh pad pad\n" +
                         dump_contacts(1) + "thermo 1000\nrun 100000\n");
  const Eigen::Vector3d place(0.011, 0.007, 0.02995), v(0.3, -0.1, -0.02);
  const double rate = -0.4;  // of the mode, whose shape is x^2 + y^2 at the nodes
  const Outcome outcome = folder.coupled(2, "-in in -log log", "until 0.005 out table.csv body pad pad.stl 0.011 0.007 0.02995 modal 0.3 -0.1 -0.02 bowl -0.4");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
  const Table table(folder.path() / "table.csv");
  const std::vector<std::vector<Contact>> frames = read_contacts(folder.read("contacts.txt"));
  ASSERT_EQ(table.rows(), 100u);
  ASSERT_EQ(frames.size(), 101u);

  // At each step by hand: force, modal force sum Phi(c) . f, and the power sum f . v(c) with the velocity of the boundary at the contact.
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

constexpr double kRadius = 0.12, kThickness = 0.002, kEdge = 0.02;

constexpr const char* kPlateScene = R"(title = "Plate at rest on four fixed grains"
end_time = 0.6
gravity = [0, 0, -9.81]
[materials.metal]
density = 7850
young = 207e9
poisson = 0.3
[[bodies]]
name = "plate"
material = "metal"
shape = { kind = "disc", centre = [0, 0, 0.02], axis = "z", radius = 0.12, thickness = 0.002 }
flexible = { modes = MODES, mesh_size = 0.02, damping = 0.5 }
[[boundaries]]
body = "plate"
surface = {}
[ground]
kind = "particles"
[particles]
script = "in"
surface_height = 0.02
max_time_step = 1e-3
[initial]
clearance = 1e-6
[output]
interval = END
plots = false
)";

std::string plate_scene(const std::string& end, const std::string& interval) {
  std::string scene = kPlateScene;
  scene.replace(scene.find("MODES"), 5, "40");
  scene.replace(scene.find("interval = END"), 14, "interval = " + interval);
  scene.replace(scene.find("end_time = 0.6"), 14, "end_time = " + end);
  return scene;
}

// Four grains under a free round plate, not on a symmetric square: it bends into a saddle and a bowl.
std::string plate_script(const std::string& processors, int every, const std::string& more) {
  std::string head = script_head("-0.2 0.2 -0.2 0.2 -0.1 0.2", processors, 2e-5);
  head.replace(head.find("hard_particles yes"), 18, "hard_particles yes\nsoft_particles yes");
  head.replace(head.find("35e6"), 4, "1e6 ");  // soft: the plate sinks in visibly and comes to rest soon
  return head +
         "create_atoms 1 single 0.071 0.013 0.0 units box\ncreate_atoms 1 single -0.063 0.031 0.0 units box\n"
         "create_atoms 1 single -0.013 0.083 0.0 units box\ncreate_atoms 1 single 0.009 -0.057 0.0 units box\n"
         "set group all diameter 0.04 density 2600\n"
         "fix geo all couple/mbd/geometry body plate\nfix plate all mesh/surface fix geo type 2\n"
         "fix wm all wall/gran model hertz tangential history mesh n_meshes 1 meshes plate\n"
         "fix mbd all couple/mbd every " + std::to_string(every) + " mesh plate plate\nthermo 10000\n" + more + "run 100000000\n";
}

Outcome run_plate(const RunFolder& folder, int ranks) {
  return folder.command("mpirun --oversubscribe -np " + std::to_string(ranks) + " " + RunFolder::program("liggghts_mbd") + " -in in -log log : -np 1 " +
                            RunFolder::program("mbd_solver") + " scene.toml --quiet --out out",
                        120);
}

TEST(FlexiblePlate, AtRestBendsAsThePlateUnderTheDumpedForces) {
  const RunFolder folder("plate_rest");
  folder.write("scene.toml", plate_scene("0.6", "0.01"));
  folder.write("in", plate_script("1 1 1", 10, dump_contacts(30000)));
  const Outcome outcome = run_plate(folder, 1);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
  const History history = read_history((folder.path() / "out/history.csv").string());
  const std::vector<std::vector<Contact>> frames = read_contacts(folder.read("contacts.txt"));
  ASSERT_FALSE(frames.empty());
  const std::vector<Contact>& contacts = frames.back();
  ASSERT_EQ(contacts.size(), 4u);
  ASSERT_LT(std::abs(history.column("plate.vz").back()), 1e-6);

  // The same plate by finite elements without any modes: K u = f of contacts and weight. A free plate: u is what is left after its
  // mean translation and rotation (mass-weighted), as in the axes of the body.
  Material metal;
  metal.density = 7850;
  metal.young = 207e9;
  metal.poisson = 0.3;
  const FeModel fe = with_mass(plate_model(disc_mesh(kRadius, kEdge), kThickness, metal),
                               metal.density * M_PI * kRadius * kRadius * kThickness);  // of the disc, not of its polygon
  const Eigen::Index n = 6 * fe.nodes.cols();
  const Eigen::Vector3d Bo(history.column("plate.x").back(), history.column("plate.y").back(), history.column("plate.z").back());
  Eigen::VectorXd f = Eigen::VectorXd::Zero(n);
  double weight = 0.0, lift = 0.0;
  for (Eigen::Index j = 0; j < fe.nodes.cols(); ++j) {
    f[6 * j + 2] -= 9.81 * fe.node_mass[j];
    weight += 9.81 * fe.node_mass[j];
  }
  for (const Contact& c : contacts) {
    const Eigen::Vector3d local(c.centre.x() - Bo.x(), c.centre.y() - Bo.y(), 0.0);
    bool found = false;
    for (const Eigen::Vector3i& t : fe.triangles) {
      const Eigen::Vector3d w = barycentric(local, fe.nodes.col(t[0]), fe.nodes.col(t[1]), fe.nodes.col(t[2]));
      if (found || w.minCoeff() < -1e-9) continue;
      found = true;
      for (int k = 0; k < 3; ++k) f[6 * t[k] + 2] += w[k] * c.force.z();
    }
    ASSERT_TRUE(found);
    lift += c.force.z();
  }
  ASSERT_NEAR(lift, weight, 1e-4 * weight);  // it is at rest
  // Rigid motions R, and the conditions R^T M u = 0 as a bordered system.
  Eigen::MatrixXd R = Eigen::MatrixXd::Zero(n, 6);
  for (Eigen::Index j = 0; j < fe.nodes.cols(); ++j) {
    const Eigen::Vector3d x = fe.nodes.col(j);
    for (int i = 0; i < 3; ++i) {
      R(6 * j + i, i) = 1.0;
      const Eigen::Vector3d turn = Eigen::Vector3d::Unit(i).cross(x);
      R.block<3, 1>(6 * j, 3 + i) = turn;
      R(6 * j + 3 + i, 3 + i) = 1.0;
    }
  }
  const Eigen::MatrixXd MR = lumped_mass_matrix(fe) * R;
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + 6, n + 6);
  system.topLeftCorner(n, n) = Eigen::MatrixXd(fe.stiffness);
  system.topRightCorner(n, 6) = MR;
  system.bottomLeftCorner(6, n) = MR.transpose();
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n + 6);
  right.head(n) = f;
  const Eigen::VectorXd u = system.fullPivLu().solve(right).head(n);
  double deflection = 0.0;
  for (Eigen::Index j = 0; j < fe.nodes.cols(); ++j) deflection = std::max(deflection, u.segment<3>(6 * j).norm());
  const double found = history.column("plate.deflection").back();
  std::printf("deflection %.6g m, by the plate alone %.6g m\n", found, deflection);
  EXPECT_GT(deflection, 1e-6);
  EXPECT_NEAR(found, deflection, 0.01 * deflection);
}

TEST(FlexiblePlate, OneAndTwoRanksAgreeToRoundOffOverAHundredSteps) {
  History results[2];
  for (const int ranks : {1, 2}) {
    const RunFolder folder("plate_ranks_" + std::to_string(ranks));
    folder.write("scene.toml", plate_scene("0.002", "2e-5"));  // 100 steps of LIGGGHTS
    folder.write("in", plate_script(ranks == 1 ? "1 1 1" : "2 1 1", 1, ""));
    const Outcome outcome = run_plate(folder, ranks);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
    results[ranks - 1] = read_history((folder.path() / "out/history.csv").string());
  }
  for (const char* name : {"plate.z", "plate.vz", "plate.deflection", "plate.strain_energy", "plate.contact.fz", "plate.contact.mx"}) {
    const std::vector<double>&one = results[0].column(name), &two = results[1].column(name);
    ASSERT_EQ(one.size(), two.size());
    double scale = 1e-300;
    for (const double x : one) scale = std::max(scale, std::abs(x));
    for (std::size_t k = 0; k < one.size(); ++k) EXPECT_NEAR(one[k], two[k], 1e-8 * scale) << name << " row " << k;
  }
}

// The work the grains do on the deforming boundary against what body and modes receive: the difference falls at least with H.
TEST(FlexiblePlate, WorkOnTheBoundaryIsWorkReceivedByTheModesToTheOrderOfTheWindow) {
  std::vector<double> residual;
  for (const int every : {20, 10, 5}) {
    const RunFolder folder("plate_work_" + std::to_string(every));
    folder.write("scene.toml", plate_scene("0.06", "1e-3"));
    folder.write("in", plate_script("1 1 1", every, ""));
    const Outcome outcome = run_plate(folder, 1);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
    const History history = read_history((folder.path() / "out/history.csv").string());
    double largest = 0.0;
    for (const double x : history.column("coupling.energy_residual")) largest = std::max(largest, std::abs(x));
    residual.push_back(largest);
  }
  std::printf("energy residual at 20, 10, 5 steps: %.3g %.3g %.3g J\n", residual[0], residual[1], residual[2]);
  EXPECT_LT(residual[1], 0.7 * residual[0]);
  EXPECT_LT(residual[2], 0.7 * residual[1]);
}

}  // namespace
}  // namespace footfall::test
