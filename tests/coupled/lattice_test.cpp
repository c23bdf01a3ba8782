// A flexible plate of mbd_solver on a lattice of grains, every number written down.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "coupler/body_motion.h"
#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/coupling/body_window.h"
#include "mbd_solver/fe/fe_analysis.h"
#include "mbd_solver/fe/mesh_generator.h"
#include "mbd_solver/fe/modal_basis.h"
#include "mbd_solver/scene/scene_reader.h"
#include "tests/coupled/coupled_run.h"
#include "tests/support/fe_reference.h"
#include "tests/support/linear_algebra.h"

namespace footfall::test {
namespace lattice {

// A flexible plate on a lattice of fixed grains, mbd_solver with its modes, and real LIGGGHTS. What LIGGGHTS says of
// each contact (compute wall/gran/local) is projected by hand on force, moment and modes, and compared with what
// mbd_solver got.

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kGrain = 0.02, kPlate = 0.2, kThickness = 0.002;  // radii of grains and plate, its thickness [m]
constexpr double kSpacing = 0.06;                                  // of the lattice [m]
constexpr int kRings = 14;                                         // of the mesh of the plate at rest
const Material kAluminium{2700.0, 70e9, 0.33};

const char* const kScene = R"(
end_time = 0.02
gravity = [0, 0, -9.81]
[materials.aluminium]
density = 2700
young = 70e9
poisson = 0.33
[[bodies]]
name = "plate"
material = "aluminium"
shape = { kind = "disc", centre = [0, 0, 0], axis = [0, 0, 1], radius = 0.2, thickness = 0.002 }
flexible = { modes = 30, mesh_size = 0.02, basis = "free_free", damping = 0.2 }
[[boundaries]]
body = "plate"
surface = {}
[ground]
kind = "particles"
[particles]
script = "in.lattice"
ranks = 1
[solver]
rtol = 1e-8
atol = 1e-10
[output]
plots = false
)";

// Nine fixed grains, their tops at z = 0; dumps every contact every `dump` steps.
std::string lattice(const std::string& processors, double dt, int every, int dump) {
  std::string s = script_head("-0.4 0.4 -0.4 0.4 -0.2 0.2", processors, dt);
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j) {
      std::ostringstream line;
      line << "create_atoms 1 single " << kSpacing * i + 0.013 << " " << kSpacing * j + 0.007 << " " << -kGrain
           << " units box\n";
      s += line.str();
    }
  s += "set group all diameter 0.04 density 2600\n"
       "fix geo all couple/mbd/geometry body plate\nfix m all mesh/surface fix geo type 2\n" +
       mesh_wall() + "fix mbd all couple/mbd every " + std::to_string(every) +
       " mesh m plate\ncompute touch all wall/gran/local pos vel id force\ndump c all local " + std::to_string(dump) +
       " contacts.dump";
  std::string format;
  for (int k = 1; k <= 18; ++k) {
    s += " c_touch[" + std::to_string(k) + "]";
    format += k == 1 ? "%.17g" : " %.17g";
  }
  return s + "\ndump_modify c format \"" + format + "\"\ndump f all custom " + std::to_string(dump) +
         " forces.dump id fx fy fz\ndump_modify f format \"%d %.17g %.17g %.17g\"\nthermo 100000\nrun 10000000\n";
}

// One row of compute wall/gran/local.
struct Contact {
  Vector3d point, grain, v_wall, force;  // force on the plate
  int triangle;
  long id;  // of the grain
};

// Rows of a dump by step.
std::map<long, std::vector<std::vector<double>>> read_steps(const std::string& text) {
  std::map<long, std::vector<std::vector<double>>> steps;
  std::istringstream in(text);
  long step = 0;
  bool rows = false;
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("ITEM: TIMESTEP", 0) == 0) {
      std::getline(in, line);
      step = std::stol(line);
      steps[step];
      rows = false;
    } else if (line.rfind("ITEM: ", 0) == 0) {
      rows = line.rfind("ITEM: ENTRIES", 0) == 0 || line.rfind("ITEM: ATOMS", 0) == 0;
    } else if (rows) {
      std::istringstream words(line);
      steps[step].emplace_back();
      for (double x = 0.0; words >> x;) steps[step].back().push_back(x);
    }
  }
  return steps;
}

// compute wall/gran/local says what a contact would give if it were evaluated now, without moving its history on. Where
// it slides, that is not what it gave: the force of a grain with one contact is the force that LIGGGHTS left on the
// grain.
std::map<long, std::vector<Contact>> read_contacts(const std::string& local, const std::string& grains) {
  std::map<long, std::vector<Contact>> steps;
  const auto forces = read_steps(grains);
  for (const auto& [step, rows] : read_steps(local)) {
    std::vector<Contact>& contacts = steps[step];
    for (const std::vector<double>& row : rows) {
      const auto column = [&row](std::size_t k) { return Vector3d(row.at(k), row.at(k + 1), row.at(k + 2)); };
      contacts.push_back(
          {column(0), column(3), column(6), -column(15), static_cast<int>(row.at(13)), std::lround(row.at(14))});
    }
    for (const std::vector<double>& row : forces.at(step)) {
      const auto same = [&row](const Contact& c) { return c.id == std::lround(row[0]); };
      if (std::count_if(contacts.begin(), contacts.end(), same) == 1)
        std::find_if(contacts.begin(), contacts.end(), same)->force = -Vector3d(row.at(1), row.at(2), row.at(3));
    }
  }
  return steps;
}

struct PlateRun {
  PlateRun(const std::string& name, int ranks, double dt, int every, int dump, const std::vector<std::string>& settings,
           int limit = 120)
      : folder("plate_" + name), modes(0) {
    folder.write("scene.toml", kScene);
    folder.write("in.lattice", lattice(ranks == 1 ? "1 1 1" : "2 1 1", dt, every, dump));
    std::string arguments = "scene.toml table.csv";
    for (const std::string& setting : settings) arguments += " '" + setting + "'";
    const Outcome outcome = folder.command("mpirun --oversubscribe -np " + std::to_string(ranks) + " " +
                                               RunFolder::program("liggghts_mbd") + " -in in.lattice : -np 1 " +
                                               RunFolder::program("recording_solver") + " " + arguments,
                                           limit);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
    const Scene scene = read_scene((folder.path() / "scene.toml").string(), settings);
    const Mechanism mechanism = build_mechanism(scene);
    modal = *mechanism.model.body(0).modal();
    boundary = std::make_unique<ModalBoundary>(mechanism.boundaries.at(0).boundary);
    modes = modal.mode_count();
    table = std::make_unique<Table>(folder.path() / "table.csv");
    contacts = read_contacts(folder.read("contacts.dump"), folder.read("forces.dump"));
  }
  VectorXd modal_column(const std::string& name, std::size_t row) const {
    VectorXd x(modes);
    for (int k = 0; k < modes; ++k) x(k) = (*table)[name + std::to_string(k)][row];
    return x;
  }
  // What the body was sent from in the window after this row.
  BodyMotion state(std::size_t row) const {
    BodyMotion s(modes);
    s.r = table->vector(row, "x", "y", "z");
    s.L << (*table)["l0"][row], (*table)["l1"][row], (*table)["l2"][row], (*table)["l3"][row];
    s.a = modal_column("a", row);
    s.dr = table->vector(row, "vx", "vy", "vz");
    s.w = table->vector(row, "wx", "wy", "wz");
    s.da = modal_column("da", row);
    s.dda = modal_column("dda", row);
    return s;
  }
  // Where the boundary is at the end of that window of length H, and the rates on the way.
  BodyMotion predicted(std::size_t row, double H) const {
    BodyMotion s = state(row);
    slow_down_fast_modes(state(row), modal.stiffness, H, s);
    s.r += H * s.dr;
    s.L = turned(s.L, H * s.w);
    s.a += H * s.da;
    return s;
  }
  RunFolder folder;
  int modes;
  ModalBody modal;
  std::unique_ptr<ModalBoundary> boundary;
  std::unique_ptr<Table> table;
  std::map<long, std::vector<Contact>> contacts;
};

// By hand, of one contact on the plate in this pose: force, moment about Bo in B, modal forces; and its power at the
// velocities of `pose`, from point and material there. Nothing of the coupler is used.
struct ByHand {
  Vector3d F = Vector3d::Zero(), T_B = Vector3d::Zero();
  VectorXd Q;
  double power = 0.0;       // sum of f . v and m . w at the contacts [W]
  double power_wall = 0.0;  // the same with LIGGGHTS' own velocity of the wall [W]
  double scale = 0.0;       // sum of the magnitudes of the parts of `power` [W]
  VectorXd Q_scale;         // sum of the magnitudes
};

ByHand project(const PlateRun& run, const std::vector<Contact>& contacts, const BodyMotion& pose) {
  const Matrix3d A = Eigen::Quaterniond(pose.L[0], pose.L[1], pose.L[2], pose.L[3]).toRotationMatrix();
  ByHand out;
  out.Q = out.Q_scale = VectorXd::Zero(run.modes);
  for (const Contact& contact : contacts) {
    const Eigen::Vector3i corners = run.boundary->triangles()[static_cast<std::size_t>(contact.triangle)];
    Matrix3d rho;
    for (int k = 0; k < 3; ++k)
      rho.col(k) = run.modal.rho0.col(corners[k]) + run.modal.Phi.middleRows(3 * corners[k], 3) * pose.a;
    // c = w0 x0 + w1 x1 + w2 x2 with w0 + w1 + w2 = 1.
    const Vector3d c_B = A.transpose() * (contact.point - pose.r);
    Eigen::Matrix<double, 3, 2> edges;
    edges << rho.col(1) - rho.col(0), rho.col(2) - rho.col(0);
    const Eigen::Vector2d w12 = solve(edges, c_B - rho.col(0));
    const Vector3d weights(1.0 - w12.sum(), w12[0], w12[1]);
    EXPECT_GT(weights.minCoeff(), -1e-9);
    EXPECT_LT((rho * weights - c_B).norm(), 1e-12) << "the contact point lies on its triangle";
    Eigen::MatrixXd Phi = Eigen::MatrixXd::Zero(3, run.modes), Psi = Phi;
    for (int k = 0; k < 3; ++k) {
      Phi += weights[k] * run.modal.Phi.middleRows(3 * corners[k], 3);
      Psi += weights[k] * run.modal.Psi.middleRows(3 * corners[k], 3);
    }
    const Vector3d f_B = A.transpose() * contact.force;
    // The force acts in the middle of the overlap, where LIGGGHTS turns the grain.
    const Vector3d to_wall = contact.point - contact.grain;
    const Vector3d arm_B = A.transpose() * (0.5 * (kGrain - to_wall.norm()) * to_wall.normalized());
    const Vector3d m_B = arm_B.cross(f_B);
    const Vector3d rho_c = rho * weights;
    out.F += contact.force;
    out.T_B += rho_c.cross(f_B) + m_B;
    out.Q += Phi.transpose() * f_B + Psi.transpose() * m_B;
    out.Q_scale += (Phi.transpose() * f_B).cwiseAbs();
    const Vector3d w_B = A.transpose() * pose.w;
    const Vector3d v_B = A.transpose() * pose.dr + w_B.cross(rho_c) + Phi * pose.da;
    const double turning = m_B.dot(w_B + Psi * pose.da);
    out.power += f_B.dot(v_B) + turning;
    out.power_wall += contact.force.dot(contact.v_wall) + turning;
    out.scale += std::abs(f_B.dot(v_B)) + std::abs(turning);
  }
  return out;
}

// The plate comes down askew, sliding and turning. Windows of one step under the scheme whose mean is the force at the
// end of the step: every row of the table is one set of contacts.
const std::vector<std::string> kImpact = {"coupling.scheme=\"css\"", "initial.velocity=[0.1,0.05,-0.3]",
                                          "initial.angular_velocity=[0.5,-0.3,0.8]", "initial.position=[0,0,0.002]"};
constexpr double kDt = 5e-5;

const PlateRun& impact() {
  static const PlateRun run("impact", 1, kDt, 1, 1, kImpact);
  return run;
}

TEST(PlateOnLattice, ModalForcesAreThoseOfTheContactsThatLiggghtsReports) {
  const PlateRun& run = impact();
  ASSERT_EQ(run.table->rows(), 401U);
  double worst = 0.0, largest_modal = 0.0;
  int loaded = 0;
  for (std::size_t k = 1; k < run.table->rows(); ++k) {
    const std::vector<Contact>& contacts = run.contacts.at(static_cast<long>(k));
    if (contacts.empty()) continue;
    ++loaded;
    const ByHand hand = project(run, contacts, run.predicted(k - 1, kDt));
    const VectorXd Q = run.modal_column("q", k);
    const double error = (Q - hand.Q).norm() / hand.Q_scale.norm();
    worst = std::max(worst, error);
    largest_modal = std::max(largest_modal, Q.norm());
    ASSERT_LT(error, 1e-10) << "window " << k;
    ASSERT_LT((run.table->vector(k, "fx", "fy", "fz") - hand.F).norm(), 1e-10 * hand.F.norm());
    ASSERT_LT((run.table->vector(k, "mx", "my", "mz") - hand.T_B).norm(), 1e-10 * kPlate * hand.F.norm());
  }
  std::printf("  %d loaded windows, largest modal force %.3g, largest relative error %.2g\n", loaded, largest_modal,
              worst);
  EXPECT_GT(loaded, 100);
}

// By hand from the nodes of the deformed plate: which triangle is over each grain, how far, and its normal.
TEST(PlateOnLattice, LiggghtsSeesTheDeformedTrianglesAndTheirNormals) {
  const PlateRun& run = impact();
  double largest_turn = 0.0;
  int touching = 0;
  for (std::size_t k = 1; k < run.table->rows(); ++k) {
    const BodyMotion pose = run.predicted(k - 1, kDt);
    Eigen::Matrix3Xd bent(3, run.boundary->node_count()), flat = bent;
    for (int j = 0; j < bent.cols(); ++j) {
      bent.col(j) = run.modal.rho0.col(j) + run.modal.Phi.middleRows(3 * j, 3) * pose.a;
      flat.col(j) = run.modal.rho0.col(j);
    }
    const auto normal = [](const Eigen::Matrix3Xd& x, const Eigen::Vector3i& t) {
      return Vector3d((x.col(t[1]) - x.col(t[0])).cross(Vector3d(x.col(t[2]) - x.col(t[0]))).normalized());
    };
    const std::vector<Contact>& contacts = run.contacts.at(static_cast<long>(k));
    long grain = 0;
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j) {
        ++grain;  // ids in the order of the script
        const Vector3d p =
            pose.rotation().transpose() * (Vector3d(kSpacing * i + 0.013, kSpacing * j + 0.007, -kGrain) - pose.r);
        double height = 1.0;
        Vector3d n_B = Vector3d::Zero();
        for (const Eigen::Vector3i& t : run.boundary->triangles()) {
          Matrix3d frame;  // p = x0 + frame * (w1, w2, height)
          frame << bent.col(t[1]) - bent.col(t[0]), bent.col(t[2]) - bent.col(t[0]), normal(bent, t);
          const Vector3d local = frame.inverse() * (p - bent.col(t[0]));
          if (local[0] < 0.0 || local[1] < 0.0 || local[0] + local[1] > 1.0 || std::abs(local[2]) > height) continue;
          height = std::abs(local[2]);
          n_B = normal(bent, t);
          if (height < kGrain) largest_turn = std::max(largest_turn, n_B.cross(normal(flat, t)).norm());
        }
        ASSERT_LT(height, 1.0);
        const auto found =
            std::find_if(contacts.begin(), contacts.end(), [&](const Contact& c) { return c.id == grain; });
        ASSERT_EQ(found != contacts.end(), height < kGrain) << "grain " << grain << " in window " << k;
        if (found == contacts.end()) continue;
        ++touching;
        const Vector3d to_wall = pose.rotation().transpose() * (found->point - found->grain);
        ASSERT_NEAR(to_wall.norm(), height, 1e-12);
        ASSERT_LT(to_wall.normalized().cross(n_B).norm(), 1e-10);
      }
  }
  std::printf("  %d contacts; modes turn the normals there by up to %.2g rad\n", touching, largest_turn);
  EXPECT_GT(touching, 500);
  EXPECT_GT(largest_turn, 1e-3);
}

TEST(PlateOnLattice, VirtualWorkIsConservedOnTheContactsThatLiggghtsReports) {
  const PlateRun& run = impact();
  double worst = 0.0, worst_wall = 0.0;
  for (std::size_t k = 1; k < run.table->rows(); ++k) {
    const std::vector<Contact>& contacts = run.contacts.at(static_cast<long>(k));
    if (contacts.empty()) continue;
    const BodyMotion pose = run.predicted(k - 1, kDt);
    const auto power_of_load = [&](const BodyMotion& v) {
      const Vector3d T_W = pose.rotation() * run.table->vector(k, "mx", "my", "mz");
      return run.table->vector(k, "fx", "fy", "fz").dot(v.dr) + T_W.dot(v.w) + run.modal_column("q", k).dot(v.da);
    };
    // At any velocities, here of the state.
    const ByHand hand = project(run, contacts, pose);
    worst = std::max(worst, std::abs(power_of_load(pose) - hand.power) / hand.scale);
    ASSERT_LT(std::abs(power_of_load(pose) - hand.power), 1e-12 * hand.scale) << "window " << k;
    // At the velocities of LIGGGHTS' wall: prediction, and the gap to where the boundary stood, which closes at the rate 2 / H
    // at the window's end.
    BodyMotion path = pose;
    const BodyMotion before = k > 1 ? run.predicted(k - 2, kDt) : run.state(0), start = run.state(k - 1);
    path.dr += 2.0 / kDt * (before.r - start.r);
    path.w += Eigen::AngleAxisd(kDt * start.w.norm(), start.w.normalized()) *
              (2.0 / kDt * rotation_vector(start.L, before.L));
    path.da += 2.0 / kDt * (before.a - start.a);
    const ByHand wall = project(run, contacts, path);
    worst_wall = std::max(worst_wall, std::abs(power_of_load(path) - wall.power_wall) / wall.scale);
    ASSERT_LT(std::abs(power_of_load(path) - wall.power_wall), 1e-9 * wall.scale)
        << "window " << k;  // differences of round-off over dt
  }
  std::printf("  largest relative error of virtual work: %.2g, with the velocities of LIGGGHTS' wall %.2g\n", worst,
              worst_wall);
}

TEST(PlateOnLattice, TwoRanksAgreeWithOneToRoundOff) {
  const PlateRun two("impact_2", 2, kDt, 1, 1, kImpact);
  const PlateRun& one = impact();
  ASSERT_EQ(one.table->rows(), two.table->rows());
  double worst = 0.0;
  std::vector<std::string> names = {"fx", "fy", "fz", "mx", "my", "mz", "x", "y", "z", "work", "received"};
  for (int k = 0; k < one.modes; ++k) {
    names.push_back("q" + std::to_string(k));
    names.push_back("a" + std::to_string(k));
  }
  // From the first touch on, 100 steps; every column relative to its largest value there.
  std::size_t touch = 1;
  while (one.contacts.at(static_cast<long>(touch)).empty()) ++touch;
  ASSERT_LT(touch + 100, one.table->rows());
  for (const std::string& name : names) {
    double scale = 1e-300;
    for (std::size_t i = touch; i < touch + 100; ++i) scale = std::max(scale, std::abs((*one.table)[name][i]));
    for (std::size_t i = 0; i < touch + 100; ++i) {
      const double error = std::abs((*one.table)[name][i] - (*two.table)[name][i]) / scale;
      worst = std::max(worst, error);
      ASSERT_LT(error, 1e-10) << name << " in window " << i;
    }
  }
  std::printf("  largest relative difference: %.2g\n", worst);
}

// ---- at rest

void expect_the_modal_force_of_the_standing_contacts(const PlateRun& run) {
  const std::size_t last = run.table->rows() - 1;
  const std::vector<Contact>& contacts = run.contacts.rbegin()->second;
  ASSERT_EQ(run.contacts.rbegin()->first, 10000);
  EXPECT_GE(contacts.size(), 3U);
  const ByHand hand = project(run, contacts, run.predicted(last - 1, 2 * kDt));
  const double error = (run.modal_column("q", last) - hand.Q).norm() / hand.Q_scale.norm();
  const double weight = 9.81 * run.modal.node_mass.sum();
  std::printf("  %zu contacts, force %.10g N (weight %.10g N), relative error of the mean modal force %.2g\n",
              contacts.size(), hand.F.z(), weight, error);
  EXPECT_LT(error, 1e-10);
  EXPECT_NEAR(hand.F.z(), weight, 1e-6 * weight);
  // And the modes carry it: K a = Q.
  const VectorXd a = run.modal_column("a", last), Q = run.modal_column("q", last);
  EXPECT_LT((run.modal.stiffness.cwiseProduct(a) - Q).norm(), 1e-6 * Q.norm());
}

// The whole plate, unreduced, on a mesh twice as fine, under the dumped forces and its weight.
TEST(PlateOnLattice, AtRestTheModalForceIsThatOfTheContactsAndBendsThePlateAsTheyDo) {
  const PlateRun run("rest", 1, kDt, 2, 100,
                     {"end_time=0.5", "bodies.plate.flexible.mesh_size=0.0142857143", "initial.position=[0,0,0.0001]",
                      "bodies.plate.flexible.modes=60", "bodies.plate.flexible.damping=1.0"});
  expect_the_modal_force_of_the_standing_contacts(run);
  const std::size_t last = run.table->rows() - 1;
  const FeModel fine = plate_model(disc_mesh(kPlate, kPlate / (2 * kRings)), kThickness, kAluminium);
  VectorXd load = VectorXd::Zero(6 * fine.node_count());
  const double g = 9.81 * run.modal.node_mass.sum() / fine.node_mass.sum();
  for (int j = 0; j < fine.node_count(); ++j) load(6 * j + 2) = -g * fine.node_mass(j);
  const BodyMotion pose = run.state(last);
  for (const Contact& contact : run.contacts.rbegin()->second) {
    const Vector3d c = pose.rotation().transpose() * (contact.point - pose.r);
    bool found = false;
    for (const Eigen::Vector3i& t : fine.triangles) {
      Matrix3d corners;
      for (int k = 0; k < 3; ++k) corners.col(k) = Vector3d(fine.nodes(0, t[k]), fine.nodes(1, t[k]), 1.0);
      const Vector3d weights = corners.inverse() * Vector3d(c.x(), c.y(), 1.0);
      if (found || weights.minCoeff() < -1e-12) continue;
      for (int k = 0; k < 3; ++k) load(6 * t[k] + 2) += weights[k] * contact.force.z();
      found = true;
    }
    ASSERT_TRUE(found);
  }
  // Balanced loads: supports that only hold the rigid motion carry nothing.
  std::vector<int> held = test::node_dofs(0, {0, 1, 2, 5});
  held.push_back(6 * (fine.node_count() - 1) + 2);
  held.push_back(6 * (fine.node_count() - 1 - 3 * kRings) + 2);
  const VectorXd u = static_solution(fine, held, load);
  // Deflections at the common nodes, both without their mean plane, by the masses.
  const int n = run.modal.node_count();
  VectorXd coarse(n), reference(n), weight(n);
  Eigen::MatrixXd plane(n, 3);
  const VectorXd modal = run.modal.Phi * pose.a;
  for (int j = 0; j < n; ++j) {
    int at = 0;
    (fine.nodes.colwise() - run.modal.rho0.col(j)).colwise().norm().minCoeff(&at);
    ASSERT_LT((fine.nodes.col(at) - run.modal.rho0.col(j)).norm(), 1e-9);
    coarse(j) = modal(3 * j + 2);
    reference(j) = u(6 * at + 2);
    plane.row(j) << 1.0, run.modal.rho0(0, j), run.modal.rho0(1, j);
    weight(j) = run.modal.node_mass(j);
  }
  const auto level = [&](VectorXd& w) {
    const Eigen::MatrixXd normal = plane.transpose() * weight.asDiagonal() * plane;
    w -= plane * solve(normal, plane.transpose() * weight.asDiagonal() * w);
  };
  level(coarse);
  level(reference);
  const double largest = reference.cwiseAbs().maxCoeff();
  const double error = (coarse - reference).cwiseAbs().maxCoeff() / largest;
  std::printf("  largest deflection %.5g mm (plate solution %.5g mm), largest difference %.2g of it\n",
              1e3 * coarse.cwiseAbs().maxCoeff(), 1e3 * largest, error);
  EXPECT_NEAR(coarse.cwiseAbs().maxCoeff(), largest, 0.01 * largest);
  EXPECT_LT(error, 0.01);
}

// ---- energy over the interface

// |work done on the boundary - work received by the body| over the work, with windows of n steps.
double interface_residual(const std::string& scheme, int n) {
  const PlateRun run("work_" + scheme + "_" + std::to_string(n), 1, 1e-5, n, 1000000,
                     {"coupling.scheme=\"" + scheme + "\"", "initial.velocity=[0,0,-0.3]",
                      "initial.position=[0,0,0.0005]", "end_time=0.004", "bodies.plate.flexible.modes=8"});
  const std::size_t last = run.table->rows() - 1;
  double work = 0.0, modal = 0.0;
  for (std::size_t k = 1; k <= last; ++k) {
    work += std::abs((*run.table)["received"][k] - (*run.table)["received"][k - 1]);
    modal += std::abs(run.modal_column("q", k).dot(run.modal_column("a", k) - run.modal_column("a", k - 1)));
  }
  const double residual = std::abs((*run.table)["work"][last] - (*run.table)["received"][last]) / work;
  std::printf("  %s, windows of %d steps: residual %.3e of the work; of the modes: %.2f of it\n", scheme.c_str(), n,
              residual, modal / work);
  EXPECT_GT(modal, 0.1 * work);
  return residual;
}

TEST(PlateOnLattice, WorkOnTheDeformingBoundaryIsWorkReceivedToTheOrderOfTheScheme) {
  for (const char* scheme : {"css-trapezoid", "quadratic"}) {
    const double order = 0.5 * std::log2(interface_residual(scheme, 16) / interface_residual(scheme, 4));
    std::printf("  %s: observed order %.2f\n", scheme, order);
    EXPECT_GT(order, 1.7);
  }
}

}  // namespace lattice
}  // namespace footfall::test
