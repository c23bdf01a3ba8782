#include "mbd_solver/fe/modal_body_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "coupler/base/errors.h"
#include "mbd_solver/fe/elements.h"
#include "mbd_solver/fe/fe_model.h"
#include "mbd_solver/fe/matrix_model.h"
#include "mbd_solver/fe/turned_model.h"
#include "mbd_solver/model/body.h"
#include "mbd_solver/model/modal_inertia.h"
#include "tests/support/fe_reference.h"
#include "tests/support/linear_algebra.h"
#include "tests/support/temporary_folder.h"
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
  explicit TemporaryFile(const std::string& text = "") : path_(folder_.write("modal.txt", text)) {}
  const std::string& path() const { return path_; }

 private:
  TemporaryFolder folder_;
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

// Before, a byte order mark was part of the first word, and lines ended in LF only.
TEST(ModalBodyFile, MayBeWrittenByAnyEditor) {
  std::string text = kTwoMasses;
  for (const char* const ending : {"\n", "\r\n", "\r"}) {
    std::string other = "\xEF\xBB\xBF";
    for (const char c : text) c == '\n' ? other += ending : other += c;
    const TemporaryFile file(other);
    EXPECT_NEAR(read_modal_body(file.path(), {}, "spring").body.stiffness(0), 300.0, 1e-10);
  }
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
    const TemporaryFile K(matrix_market(model.stiffness, symmetric)), M(matrix_market(mass_matrix(model), symmetric));
    const FeModel read = read_matrix_model({K.path(), M.path(), nodes.path()});
    const VectorXd exact = frequencies(reduce(model, modes(6), "frame").body);
    EXPECT_LT((frequencies(reduce(read, modes(6), "frame").body) - exact).norm(), 1e-9 * exact.norm());
    EXPECT_LT((mass_properties(read).inertia - mass_properties(model).inertia).norm(), 1e-12);
  }
}

// A solid model has three rows per node: a cube of eight nodes whose every pair is joined by a spring, here
// with a full mass matrix.
TEST(MatrixMarket, OfASolidWithConsistentMassIsReducedWithThatMass) {
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
  const FeModel model = read_matrix_model({Kfile.path(), Mfile.path(), nodes.path()});
  EXPECT_FALSE(model.rotations);
  const MassProperties body = mass_properties(model);
  EXPECT_NEAR(body.mass, 8.0, 1e-12);
  EXPECT_LT((body.centre - Vector3d::Constant(0.5)).norm(), 1e-12);
  // Of a cube of 8 kg and 1 m, m a^2 / 6: trilinear elements contain rigid motions.
  EXPECT_LT((body.inertia - 8.0 / 6.0 * Eigen::Matrix3d::Identity()).norm(), 1e-12);
  const VectorXd exact = symmetric_modes(K, M).values;
  BasisOptions options = modes(17);
  options.pinned_nodes = {0, 7};
  const ReducedBody reduced = reduce(model, options, "cube");
  EXPECT_LT((reduced.body.stiffness - exact.tail(18)).norm(), 1e-9 * exact.norm());
  EXPECT_TRUE(reduced.body.Psi.isZero(0.0));
  options.mode_count = 18;
  EXPECT_THROW(reduce(model, options, "cube"), InputError);
}

// --- Beams with consistent mass: cubic bending, linear stretch and torsion, without rotary inertia of bending.

constexpr double kSide = 0.02;   // square bar of steel: section [m]
constexpr double kLength = 1.0;  // [m]
constexpr double kDensityOfBar = 7850.0;
const Material kSteelOfBar{kDensityOfBar, 210e9, 0.3};
constexpr double kMassOfBar = kDensityOfBar * kSide * kSide * kLength;

// Rotary inertia of the section about the axis of the bar, over its length [kg m].
constexpr double kTwist = kDensityOfBar * kSide * kSide * kSide * kSide / 6.0;

// 12 x 12 for an element of length h along x, rotations as derivatives: theta_z = v', theta_y = -w'.
MatrixXd consistent_mass(double h) {
  const double m = kDensityOfBar * kSide * kSide * h;
  MatrixXd M = MatrixXd::Zero(12, 12);
  for (const auto& [i, value] : {std::pair{0, m}, std::pair{3, kTwist * h}}) {
    M(i, i) = M(i + 6, i + 6) = value / 3.0;
    M(i, i + 6) = value / 6.0;
  }
  for (const int axis : {1, 2}) {  // v with theta_z, w with theta_y of the other sign
    const double sign = axis == 1 ? 1.0 : -1.0;
    const int t = axis == 1 ? 5 : 4;
    M(axis, axis) = M(axis + 6, axis + 6) = 156.0 / 420.0 * m;
    M(axis, axis + 6) = 54.0 / 420.0 * m;
    M(axis, t) = sign * 22.0 / 420.0 * m * h;
    M(axis + 6, t + 6) = -M(axis, t);
    M(axis, t + 6) = -sign * 13.0 / 420.0 * m * h;
    M(t, axis + 6) = sign * 13.0 / 420.0 * m * h;
    M(t, t) = M(t + 6, t + 6) = 4.0 / 420.0 * m * h * h;
    M(t, t + 6) = -3.0 / 420.0 * m * h * h;
  }
  return M.selfadjointView<Eigen::Upper>();
}

struct Matrices {
  std::vector<double> x;  // of the nodes on the x axis
  MatrixXd K, M;
};

// n equal elements from -L/2 to L/2.
Matrices consistent_bar(int n) {
  Matrices bar;
  const double h = kLength / n, I = std::pow(kSide, 4) / 12.0;
  const BeamSection section = general_section(kSide * kSide, I, I, 0.1406 * std::pow(kSide, 4), kSide);
  bar.K = bar.M = MatrixXd::Zero(6 * (n + 1), 6 * (n + 1));
  for (int e = 0; e <= n; ++e) {
    bar.x.push_back((e - 0.5 * n) * h);
    if (e == n) break;
    bar.K.block<12, 12>(6 * e, 6 * e) += beam_stiffness(h, section, kSteelOfBar);
    bar.M.block<12, 12>(6 * e, 6 * e) += consistent_mass(h);
  }
  return bar;
}

// Static condensation to every second node (Guyan 1965): u = G u_kept, G = [1; -K_ii^-1 K_ik].
Matrices reduced_statically(const Matrices& full) {
  std::vector<int> kept, inner;
  Matrices result;
  for (int node = 0; node < static_cast<int>(full.x.size()); ++node) {
    for (int i = 0; i < 6; ++i) (node % 2 == 0 ? kept : inner).push_back(6 * node + i);
    if (node % 2 == 0) result.x.push_back(full.x[static_cast<std::size_t>(node)]);
  }
  MatrixXd G = MatrixXd::Zero(full.K.rows(), static_cast<Eigen::Index>(kept.size()));
  G(inner, Eigen::all) = -solve(full.K(inner, inner), full.K(inner, kept));
  for (std::size_t i = 0; i < kept.size(); ++i) G(kept[i], static_cast<Eigen::Index>(i)) = 1.0;
  result.K = G.transpose() * full.K * G;
  result.M = G.transpose() * full.M * G;
  return result;
}

FeModel model_of(const Matrices& given, double y = 0.0) {
  std::ostringstream list;
  list.precision(17);
  for (const double x : given.x) list << x << ' ' << y << " 1\n";
  const auto text = [](const MatrixXd& m) { return matrix_market((0.5 * (m + m.transpose())).sparseView(), true); };
  const TemporaryFile nodes(list.str()), K(text(given.K)), M(text(given.M));
  return read_matrix_model({K.path(), M.path(), nodes.path()});
}

// Diagonal terms, scaled to the mass (Hinton, Rock and Zienkiewicz 1976).
Matrices lumped(Matrices bar) {
  const VectorXd d = bar.M.diagonal();
  double sum = 0.0;
  for (Eigen::Index i = 1; i < d.size(); i += 6) sum += d(i);
  bar.M = MatrixXd::Zero(d.size(), d.size());
  for (Eigen::Index i = 0; i < d.size(); ++i) bar.M(i, i) = d(i) * kMassOfBar / sum;
  for (Eigen::Index i = 0; i < d.size(); i += 6) bar.M(i, i) = bar.M(i + 1, i + 1);
  return bar;
}

// The matrices alone define the model of all bars: inertia m L^2 / 12 of a rod without rotary inertia of bending, 0.2617 kg m2,
// and the frequencies of K x = lambda M x, 127.5 Hz for two nodes; exact is 22.373 / (2 pi L^2) sqrt(E I / rho A) = 106.3 Hz.
TEST(CoupledMass, OfABeamIsUsedAsItIs) {
  for (const auto& [bar, first] : {std::pair{consistent_bar(1), 127.5}, std::pair{consistent_bar(8), 106.3},
                                   std::pair{reduced_statically(consistent_bar(8)), 106.3}}) {
    const FeModel model = model_of(bar);
    const MassProperties body = mass_properties(model);
    EXPECT_NEAR(body.mass, kMassOfBar, 1e-12 * kMassOfBar);
    EXPECT_LT((body.centre - Vector3d(0, 0, 1)).norm(), 1e-12);
    const double J = kMassOfBar * kLength * kLength / 12.0;
    EXPECT_LT((body.inertia - Eigen::Matrix3d(Vector3d(kTwist * kLength, J, J).asDiagonal())).norm(), 1e-12);
    EXPECT_NEAR(J, 0.2617, 5e-5);
    BasisOptions options = modes(6);
    options.kind = BasisKind::kFreeFree;
    const ReducedBody reduced = reduce(model, options, "bar");
    EXPECT_NEAR(frequencies(reduced.body)(0), first, 5e-3 * first) << "four digits of the statement; elements h^4";
    const VectorXd exact = symmetric_modes(bar.K, bar.M).values.segment(6, 6);
    EXPECT_LT((reduced.body.stiffness - exact).norm(), 1e-6 * exact.norm()) << "round-off of K: 1e8 of the first mode";
    EXPECT_TRUE(reduced.warnings.empty());
    // The body that moves has the same mass and inertia, and its modes are free of rigid motion.
    const Body moving("bar", std::make_shared<const ModalBody>(reduced.body));
    EXPECT_NEAR(moving.mass(), kMassOfBar, 1e-12 * kMassOfBar);
    EXPECT_LT((moving.rigid_inertia() - body.inertia).norm(), 1e-12);
    MatrixXd M(12, 12);
    ModalInertia(reduced.body).mass_matrix(VectorXd::Zero(6), M);
    MatrixXd expected = MatrixXd::Identity(12, 12);
    expected.topLeftCorner<3, 3>() *= kMassOfBar;
    expected.block<3, 3>(3, 3) = body.inertia;
    EXPECT_LT((M - expected).norm(), 1e-9);
  }
}

// The same eight elements with lumped mass: the same mass, and frequencies to the error of lumping, (h / L)^2.
TEST(CoupledMass, AgreesWithLumpedMassToTheErrorOfLumping) {
  const Matrices bar = consistent_bar(8);
  const FeModel consistent = model_of(bar), diagonal = model_of(lumped(bar));
  EXPECT_EQ(diagonal.mass.size(), 0);
  EXPECT_GT(consistent.mass.size(), 0);
  EXPECT_NEAR(mass_properties(diagonal).mass, kMassOfBar, 1e-12);
  BasisOptions options = modes(2);
  options.kind = BasisKind::kFreeFree;
  const double f = frequencies(reduce(consistent, options, "bar").body)(0);
  EXPECT_NEAR(frequencies(reduce(diagonal, options, "bar").body)(0), f, 0.06 * f) << "5.4 % with eight elements";
}

// J(a) of a bar that bends, J_xy = -int rho x v dx, and that stretches, dJ_zz = 2 int rho x u dx.
TEST(CoupledMass, InertiaFollowsTheDeflection) {
  const int n = 8;
  const FeModel model = model_of(consistent_bar(n));
  BasisOptions options = modes(10);
  options.kind = BasisKind::kFreeFree;
  const ModalBody body = reduce(model, options, "bar").body;
  const ModalInertia inertia(body);
  const double h = kLength / n, line = kMassOfBar / kLength;
  for (int k = 0; k < body.mode_count(); ++k) {
    const auto shape = [&](int element, double xi, int axis) {  // displacement at x = x_1 + xi h
      const auto at = [&](int node, int i) { return body.Phi(3 * node + i, k); };
      const auto slope = [&](int node) { return axis == 1 ? body.Psi(3 * node + 2, k) : -body.Psi(3 * node + 1, k); };
      if (axis == 0) return (1.0 - xi) * at(element, 0) + xi * at(element + 1, 0);
      const double xi2 = xi * xi, xi3 = xi2 * xi;
      return (1 - 3 * xi2 + 2 * xi3) * at(element, axis) + h * (xi - 2 * xi2 + xi3) * slope(element) +
             (3 * xi2 - 2 * xi3) * at(element + 1, axis) + h * (xi3 - xi2) * slope(element + 1);
    };
    Eigen::Matrix3d exact = Eigen::Matrix3d::Zero();  // dJ/da_k
    const double gauss[3] = {0.5 - std::sqrt(0.15), 0.5, 0.5 + std::sqrt(0.15)},
                 weight[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
    for (int e = 0; e < n; ++e)
      for (int g = 0; g < 3; ++g) {
        const double x = (e + gauss[g]) * h - 0.5 * kLength, w = weight[g] * h * line;
        exact(1, 1) += 2.0 * w * x * shape(e, gauss[g], 0);
        exact(2, 2) += 2.0 * w * x * shape(e, gauss[g], 0);
        for (const int axis : {1, 2}) exact(0, axis) -= w * x * shape(e, gauss[g], axis);
      }
    exact(1, 0) = exact(0, 1);
    exact(2, 0) = exact(0, 2);
    MatrixXd plus(16, 16), minus(16, 16);
    const double step = 1e-3;
    inertia.mass_matrix(step * VectorXd::Unit(10, k), plus);
    inertia.mass_matrix(-step * VectorXd::Unit(10, k), minus);
    const Eigen::Matrix3d found = (plus - minus).block<3, 3>(3, 3) / (2.0 * step);
    // The section turns with the bending, of the size of its twist; stretch has an error of order (h / L)^2 / 5.
    const double tolerance =
        2.0 * kTwist * body.Psi.col(k).cwiseAbs().maxCoeff() + 0.4 * (h * h) * exact.norm() + 1e-12;
    EXPECT_LT((found - exact).norm(), tolerance) << "mode " << k;
  }
}

TEST(CoupledMass, ThatIsNoneIsRefused) {
  Matrices bar = consistent_bar(2);
  EXPECT_EQ(refusal([&] { reduce(model_of(bar), modes(2), "bar"); }), "");
  bar.M(0, 6) = bar.M(6, 0) = 10.0 * bar.M(0, 0);  // indefinite; its row of x keeps a total that differs
  EXPECT_NE(refusal([&] { reduce(model_of(bar), modes(2), "bar"); }), "");
  bar = consistent_bar(2);
  bar.M(1, 5) *= 1.01;  // a rotation about the centre has momentum
  bar.M(5, 1) *= 1.01;
  EXPECT_NE(refusal([&] { reduce(model_of(bar), modes(2), "bar"); }), "");
  bar = consistent_bar(2);
  bar.M(4, 4) = -1e-3;
  EXPECT_TRUE(names(refusal([&] { reduce(model_of(bar), modes(2), "bar"); }), {"node 0"}));
  // One triangle, and one entry of the other.
  const TemporaryFile nodes("0 0 0\n"), K("%%MatrixMarket matrix coordinate real symmetric\n3 3 2\n2 1 1.0\n1 2 1.0\n");
  EXPECT_TRUE(names(refusal([&] { read_matrix_model({K.path(), K.path(), nodes.path()}); }), {":4:"}));
}

// Copies of a coupled model are reduced once and turned.
TEST(CoupledMass, OfACopyIsTurned) {
  const FeModel model = model_of(consistent_bar(4));
  const Eigen::Matrix3d R = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Vector3d p(3, 2, 1);
  FeModel copy = model;
  copy.nodes = (R * model.nodes).colwise() + p;
  MatrixXd T = MatrixXd::Zero(model.mass.rows(), model.mass.rows());
  for (Eigen::Index b = 0; b < T.rows(); b += 3) T.block<3, 3>(b, b) = R;
  copy.mass = (T * MatrixXd(model.mass) * T.transpose()).sparseView();
  copy.stiffness = (T * MatrixXd(model.stiffness) * T.transpose()).sparseView();
  ASSERT_TRUE(place_of_copy(model, copy, R).has_value());
  const ReducedBody made = turned(reduce(model, modes(4), "a"), R, *place_of_copy(model, copy, R), "b");
  EXPECT_LT((MatrixXd(made.body.mass) - MatrixXd(copy.mass)).norm(), 1e-12);
  EXPECT_LT(
      (Body("b", std::make_shared<const ModalBody>(made.body)).rigid_inertia() - mass_properties(copy).inertia).norm(),
      1e-12);
  copy.mass.coeffRef(0, 0) *= 1.0 + 1e-8;
  EXPECT_FALSE(place_of_copy(model, copy, R).has_value());
}

// Nodes in mm with K and M in N/m and kg: sound in themselves, but lighter than air and faster than any material.
TEST(CoupledMass, WithNodesInMillimetresGetsAWordOfUnits) {
  const FeModel model = model_of(consistent_bar(4));
  EXPECT_TRUE(reduce(model, modes(2), "bar").warnings.empty());
  FeModel solid = model;  // a solid cube of 1 kg; see above
  std::vector<Vector3d> p;
  for (int i = 0; i < 8; ++i) p.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  MatrixXd K = MatrixXd::Zero(48, 48), M = MatrixXd::Zero(48, 48);
  solid.nodes.resize(3, 8);
  for (int i = 0; i < 8; ++i) {
    solid.nodes.col(i) = 0.1 * p[static_cast<std::size_t>(i)];
    for (int j = 0; j < 8; ++j) {
      const Vector3d d = p[static_cast<std::size_t>(i)] - p[static_cast<std::size_t>(j)];
      M.block<3, 3>(6 * i, 6 * j) = 1.0 / 27.0 * std::pow(0.5, d.squaredNorm()) * Eigen::Matrix3d::Identity();
      if (i == j) continue;
      const Vector3d e = d.normalized();
      K.block<3, 3>(6 * i, 6 * i) += 1e8 * e * e.transpose();
      K.block<3, 3>(6 * i, 6 * j) -= 1e8 * e * e.transpose();
    }
  }
  solid.stiffness = K.sparseView();
  solid.mass = M.sparseView();
  solid.node_mass = VectorXd::Constant(8, 0.125);
  solid.node_inertia.assign(8, Eigen::Matrix3d::Zero());
  solid.rotations = false;
  solid.stress.resize(0, 48);
  EXPECT_TRUE(reduce(solid, modes(2), "cube").warnings.empty());
  solid.nodes *= 1000.0;
  const ReducedBody reduced = reduce(solid, modes(2), "cube");
  ASSERT_EQ(reduced.warnings.size(), 1u);
  EXPECT_TRUE(names(reduced.warnings[0], {"W1320", "mm"}));
}

TEST(MatrixMarket, NamesFileAndLineOfWhatIsWrong) {
  const FeModel model = test::straight_beam({0, 0, 0}, {1, 0, 0}, 1, rod_section(0.02), kSteel);
  const std::string K = matrix_market(model.stiffness, true), M = matrix_market(mass_matrix(model), true);
  const std::string nodes = node_list(model);
  const auto read = [&](const std::string& k, const std::string& m, const std::string& n) {
    const TemporaryFile kf(k), mf(m), nf(n);
    return refusal([&] { read_matrix_model({kf.path(), mf.path(), nf.path()}); });
  };
  EXPECT_EQ(read(K, M, nodes), "");
  const std::string coordinate = "%%MatrixMarket matrix coordinate real general\n";
  EXPECT_TRUE(names(read("1 2 3\n" + K, M, nodes), {":2:"}));
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
