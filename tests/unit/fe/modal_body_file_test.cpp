#include "mbd_solver/fe/modal_body_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "coupler/base/errors.h"
#include "mbd_solver/fe/fe_model.h"
#include "tests/support/linear_algebra.h"
#include "tests/unit/fe/steel_frame.h"

namespace footfall {
namespace {

using namespace test;

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// A file that is removed with its owner.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& text = "") {
    static int number = 0;
    path_ =
        ::testing::TempDir() + "footfall_modal_" + std::to_string(::getpid()) + "_" + std::to_string(number++) + ".txt";
    std::ofstream(path_) << text;
  }
  ~TemporaryFile() { std::remove(path_.c_str()); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

FeModel frame() {
  return beam_model({{0, 0, 0}, {0.5, 0, 0.1}, {0.4, 0.6, 0}}, {member(0, 1), member(1, 2), member(2, 0)},
                    {tube_section(0.04, 0.004)}, kSteel);
}

BasisOptions modes(int count) {
  BasisOptions options;
  options.mode_count = count;
  return options;
}

TEST(ModalBodyFile, GivesBackWhatWasWritten) {
  const ReducedBody out = reduce(frame(), modes(5), "frame");
  const TemporaryFile file;
  write_modal_body(file.path(), out.body, out.p_DBo);
  BasisOptions options;
  options.damping_ratio = {0.5};  // not used: the file has its own
  const ReducedBody in = read_modal_body(file.path(), options, "frame");
  const double round_off = 1e-12;
  EXPECT_LT((in.p_DBo - out.p_DBo).norm(), round_off);
  EXPECT_LT((in.body.rho0 - out.body.rho0).norm(), round_off);
  EXPECT_LT((in.body.node_mass - out.body.node_mass).norm(), round_off);
  EXPECT_LT((in.body.node_inertia[2] - out.body.node_inertia[2]).norm(), round_off);
  EXPECT_LT((in.body.Phi - out.body.Phi).norm(), round_off * out.body.Phi.norm());
  EXPECT_LT((in.body.Psi - out.body.Psi).norm(), round_off * out.body.Psi.norm());
  EXPECT_LT((in.body.stiffness - out.body.stiffness).norm(), round_off * out.body.stiffness.norm());
  EXPECT_LT((in.body.damping - out.body.damping).norm(), round_off * out.body.damping.norm());
  EXPECT_LT((in.body.stress_modes - out.body.stress_modes).norm(), round_off * out.body.stress_modes.norm());
  EXPECT_EQ(in.body.segments, out.body.segments);
  EXPECT_EQ(read_modal_body(file.path(), modes(2), "frame").body.mode_count(), 2);
  EXPECT_THROW(read_modal_body(file.path(), modes(6), "frame"), InputError);
}

// Two masses on a spring, one of them as the whole file.
const char* const kTwoMasses =
    "footfall-modal-body 1   # two masses on a spring, and its stretch\n"
    "nodes 4\n"
    "0 0 0 2\n"
    "1 0 0 2\n"
    "\n"
    "0.5 1 0 0.5\n"
    "0.5 0 1 0.5\n"
    "modes 1\n"
    "mode 0\n"
    "0 0 0\n"
    "1 0 0\n"
    "0.5 0 0\n"
    "0.5 0 0\n"
    "stiffness\n"
    "300\n"
    "end\n";

TEST(ModalBodyFile, IsReadAsItsDescriptionSays) {
  const TemporaryFile file(kTwoMasses);
  BasisOptions options;
  options.damping_ratio = {0.02};
  const ReducedBody reduced = read_modal_body(file.path(), options, "spring");
  // The stretch 1 moves both masses of 2 kg by 1/2 from the mean: modal mass 1 kg, omega^2 = 300.
  EXPECT_NEAR(reduced.body.stiffness(0), 300.0, 1e-10);
  EXPECT_NEAR(std::abs(reduced.body.Phi(3, 0)), 0.5, 1e-14);
  EXPECT_NEAR(reduced.body.Phi(0, 0), -reduced.body.Phi(3, 0), 1e-14);
  EXPECT_NEAR(reduced.body.damping(0), 0.04 * std::sqrt(300.0), 1e-12);
  EXPECT_LT((reduced.p_DBo - Vector3d(0.5, 0.1, 0.1)).norm(), 1e-14);
  // Without rotations no joint that holds an orientation can attach.
  EXPECT_EQ(joint_node(reduced.body, reduced.body.rho0.col(1), 1e-9, false), 1);
  EXPECT_THROW(joint_node(reduced.body, reduced.body.rho0.col(1), 1e-9, true), InputError);
}

struct Damage {
  const char* from;
  const char* to;
  int line;
};

TEST(ModalBodyFile, NamesFileAndLineOfWhatIsWrong) {
  const Damage damages[] = {
      {"footfall-modal-body 1", "solid cube", 1},
      {"footfall-modal-body 1", "footfall-modal-body 2", 1},
      {"nodes 4", "nodes four", 2},
      {"nodes 4", "nodes -4", 2},
      {"nodes 4", "node 4", 2},
      {"1 0 0 2", "1 0 0", 4},
      {"1 0 0 2", "1 0 0 -2", 4},
      {"1 0 0 2", "1 0 nan 2", 4},
      {"1 0 0 2", "1 0 0 2 -1 1 1 0 0 0", 4},
      {"nodes 4", "nodes 5", 8},
      {"modes 1", "modes 99", 8},
      {"mode 0", "mode 1", 9},
      {"1 0 0\n0.5 0 0", "1 0 0 0\n0.5 0 0", 11},
      {"stiffness", "stiffnes", 14},
      {"300", "3OO", 15},
      {"300", "-300", 0},
      {"1 0 0\n0.5 0 0\n0.5 0 0", "0 0 0\n0 0 0\n0 0 0", 0},
      {"end", "triangles 1\n0 1 4\nend", 17},
      {"end", "triangle 1\n0 1 2\nend", 16},
      {"end", "damping\n-0.1\nend", 17},
      {"end", "stress 1\n1\n2\nend", 0},
      {"end\n", "", 15},
      {"end\n", "end\n1 2 3\n", 17},
  };
  for (const Damage& damage : damages) {
    std::string text = kTwoMasses;
    const std::size_t at = text.find(damage.from);
    ASSERT_NE(at, std::string::npos) << damage.from;
    text.replace(at, std::string(damage.from).size(), damage.to);
    const TemporaryFile file(text);
    const std::string message = refusal([&] { read_modal_body(file.path(), BasisOptions{}, "spring"); });
    const std::string where = file.path() + (damage.line > 0 ? ":" + std::to_string(damage.line) + ": " : "");
    EXPECT_EQ(message.rfind(where, 0), 0u) << damage.to << ": " << message;
  }
  EXPECT_THROW(read_modal_body("no/such/file", BasisOptions{}, "x"), InputError);
}

std::string matrix_market(const Eigen::SparseMatrix<double>& matrix, bool symmetric) {
  std::ostringstream text;
  text.precision(17);
  int entries = 0;
  std::ostringstream body;
  body.precision(17);
  for (int j = 0; j < matrix.cols(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, j); it; ++it) {
      if (symmetric && it.row() < j) continue;
      body << it.row() + 1 << ' ' << j + 1 << ' ' << it.value() << '\n';
      ++entries;
    }
  text << "%%MatrixMarket matrix coordinate real " << (symmetric ? "symmetric" : "general") << "\n% a comment\n"
       << matrix.rows() << ' ' << matrix.cols() << ' ' << entries << '\n'
       << body.str();
  return text.str();
}

std::string node_list(const FeModel& model) {
  std::ostringstream text;
  text.precision(17);
  text << "# x y z\n";
  for (int j = 0; j < model.node_count(); ++j) text << model.nodes.col(j).transpose() << '\n';
  return text.str();
}

TEST(MatrixMarket, OfALumpedModelGivesTheSameBody) {
  const FeModel model = frame();
  const TemporaryFile nodes(node_list(model));
  for (bool symmetric : {true, false}) {
    const TemporaryFile K(matrix_market(model.stiffness, symmetric)),
        M(matrix_market(lumped_mass_matrix(model), symmetric));
    const FeModel read = read_matrix_market(K.path(), M.path(), nodes.path());
    const VectorXd exact = frequencies(reduce(model, modes(6), "frame").body);
    EXPECT_LT((frequencies(reduce(read, modes(6), "frame").body) - exact).norm(), 1e-9 * exact.norm());
    EXPECT_LT((mass_properties(read).inertia - mass_properties(model).inertia).norm(), 1e-12);
  }
}

// A solid model has three rows per node: a cube of eight nodes whose every pair is joined by a spring, here
// with a full mass matrix.
TEST(MatrixMarket, OfASolidWithConsistentMassIsLumpedAndReduced) {
  std::vector<Vector3d> p;
  for (int i = 0; i < 8; ++i) p.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  MatrixXd K = MatrixXd::Zero(24, 24), M = MatrixXd::Zero(24, 24);
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) {
      // Trilinear brick of 8 kg: 8/27 on the diagonal, halved with each edge between two nodes.
      const double distance2 = (p[static_cast<std::size_t>(i)] - p[static_cast<std::size_t>(j)]).squaredNorm();
      for (int k = 0; k < 3; ++k) M(3 * i + k, 3 * j + k) = 8.0 / 27.0 * std::pow(0.5, distance2);
      if (i == j) continue;
      const Vector3d e = (p[static_cast<std::size_t>(i)] - p[static_cast<std::size_t>(j)]).normalized();
      K.block<3, 3>(3 * i, 3 * i) += 1e6 * e * e.transpose();
      K.block<3, 3>(3 * i, 3 * j) -= 1e6 * e * e.transpose();
    }
  std::ostringstream list;
  for (const Vector3d& x : p) list << x.transpose() << '\n';
  const TemporaryFile nodes(list.str()), Kfile(matrix_market(K.sparseView(), true)),
      Mfile(matrix_market(M.sparseView(), true));
  const FeModel model = read_matrix_market(Kfile.path(), Mfile.path(), nodes.path());
  EXPECT_FALSE(model.rotations);
  EXPECT_LT((model.node_mass - VectorXd::Ones(8)).norm(), 1e-12) << "8 kg in equal parts";
  const VectorXd exact = symmetric_modes(K).values;  // with unit masses
  BasisOptions options = modes(17);
  options.pinned_nodes = {0, 7};
  const ReducedBody reduced = reduce(model, options, "cube");
  EXPECT_LT((reduced.body.stiffness - exact.tail(18)).norm(), 1e-9 * exact.norm());
  EXPECT_TRUE(reduced.body.Psi.isZero(0.0));
  options.mode_count = 18;
  EXPECT_THROW(reduce(model, options, "cube"), InputError);
}

TEST(MatrixMarket, NamesFileAndLineOfWhatIsWrong) {
  const FeModel model = straight_beam({0, 0, 0}, {1, 0, 0}, 1, rod_section(0.02), kSteel);
  const std::string K = matrix_market(model.stiffness, true), M = matrix_market(lumped_mass_matrix(model), true);
  const std::string nodes = node_list(model);
  const auto read = [&](const std::string& k, const std::string& m, const std::string& n) {
    const TemporaryFile kf(k), mf(m), nf(n);
    return refusal([&] { read_matrix_market(kf.path(), mf.path(), nf.path()); });
  };
  EXPECT_EQ(read(K, M, nodes), "");
  const std::string coordinate = "%%MatrixMarket matrix coordinate real general\n";
  EXPECT_TRUE(names(read("1 2 3\n" + K, M, nodes), {":1:"}));
  EXPECT_TRUE(names(read("%%MatrixMarket matrix array real general\n2 2\n1\n2\n3\n4\n", M, nodes), {":1:"}));
  EXPECT_NE(read(K + "1 1 5\n", M, nodes), "");
  EXPECT_NE(read(K.substr(0, K.size() - 30), M, nodes), "");
  EXPECT_TRUE(names(read(coordinate + "18 18 1\n19 1 1.0\n", M, nodes), {":3:", "19", "18"}));
  EXPECT_TRUE(names(read(K, coordinate + "12 12 1\n1 1 1.0\n", nodes), {"12", "18"}));
  EXPECT_NE(read(K, coordinate + "18 18 1\n1 1 -1.0\n", nodes), "");
  EXPECT_NE(read(K, coordinate + "18 18 3\n1 1 1.0\n2 2 1.0\n3 3 2.0\n", nodes), "");
  EXPECT_TRUE(names(read(K, M, nodes + "1 2\n"), {":5:"}));
  EXPECT_TRUE(names(read(K, M, nodes + "1 2 3\n"), {"12", "24"}));
  EXPECT_NE(read(K, M, "# nothing\n"), "");
}

}  // namespace
}  // namespace footfall
