// Reduction of a model to modes.
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

#include "coupler/base/errors.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/fe/eigen_solver.h"
#include "mbd_solver/fe/fe_analysis.h"
#include "mbd_solver/fe/fe_model.h"
#include "mbd_solver/fe/mesh_generator.h"
#include "mbd_solver/fe/modal_basis.h"
#include "mbd_solver/fe/turned_model.h"
#include "mbd_solver/model/codes.h"
#include "mbd_solver/model/modal_body.h"
#include "mbd_solver/model/modal_inertia.h"
#include "tests/support/fe_reference.h"
#include "tests/support/linear_algebra.h"
#include "tests/unit/fe/steel_frame.h"

namespace footfall {
namespace {

using namespace test;

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

FeModel strut() { return test::straight_beam({0.2, 0.1, 0.0}, {0.7, 0.4, 1.0}, 8, tube_section(0.05, 0.008), kSteel); }
FeModel pad() { return plate_model(disc_mesh(0.2, 0.05), 0.008, kSteel); }
FeModel dish() { return plate_model(dish_mesh(0.2, 0.04, 0.05), 0.004, kSteel); }

BasisOptions craig_bampton(int modes, std::vector<int> interface, std::vector<int> pinned = {}) {
  BasisOptions options;
  options.mode_count = modes;
  options.interface_nodes = std::move(interface);
  options.pinned_nodes = std::move(pinned);
  return options;
}

BasisOptions free_free(int modes) {
  BasisOptions options;
  options.kind = BasisKind::kFreeFree;
  options.mode_count = modes;
  return options;
}

// The contract of modal_body.h, to round-off.
void expect_contract(const ModalBody& body) {
  const int s = body.mode_count();
  Vector3d S0 = Vector3d::Zero();
  MatrixXd S1 = MatrixXd::Zero(3, s), C0 = MatrixXd::Zero(3, s), Mff = MatrixXd::Zero(s, s);
  double size = 0.0;
  for (int j = 0; j < body.node_count(); ++j) {
    const MatrixXd Phi = body.Phi.middleRows(3 * j, 3), Psi = body.Psi.middleRows(3 * j, 3);
    const Vector3d rho = body.rho0.col(j);
    const Matrix3d& J = body.node_inertia[static_cast<std::size_t>(j)];
    S0 += body.node_mass(j) * rho;
    S1 += body.node_mass(j) * Phi;
    for (int k = 0; k < s; ++k) C0.col(k) += body.node_mass(j) * rho.cross(Vector3d(Phi.col(k)));
    C0 += J * Psi;
    Mff += body.node_mass(j) * Phi.transpose() * Phi + Psi.transpose() * J * Psi;
    size = std::max(size, rho.norm());
  }
  const double mass = body.node_mass.sum();
  const double round_off = 1e-13;
  EXPECT_LT(S0.norm(), round_off * mass * size);
  EXPECT_LT(S1.norm(), round_off * std::sqrt(mass * s)) << "orthonormal shapes are of the size 1/sqrt(mass)";
  EXPECT_LT(C0.norm(), round_off * std::sqrt(mass * s) * size);
  EXPECT_LT((Mff - MatrixXd::Identity(s, s)).norm(), round_off * 10.0 * s);
  for (int k = 0; k < s; ++k) {
    EXPECT_GT(body.stiffness(k), k == 0 ? 0.0 : body.stiffness(k - 1) * (1.0 - 1e-9)) << "ascending";
  }
}

TEST(ModalBasis, KeepsTheContractForEveryModelAndBasis) {
  const FeModel beam = strut(), plate = pad(), shell = dish();
  const FeModel frame = beam_model({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.3, 0.2, 0.8}},
                                   {member(0, 1), member(1, 2), member(2, 3), member(3, 0), member(1, 3)},
                                   {tube_section(0.03, 0.002)}, kSteel);
  expect_contract(reduce(beam, craig_bampton(10, {0, 8}), "strut").body);
  expect_contract(reduce(beam, craig_bampton(3, {0, 8}), "strut").body);
  expect_contract(reduce(beam, craig_bampton(8, {0}, {8}), "strut").body);
  expect_contract(reduce(beam, free_free(8), "strut").body);
  expect_contract(reduce(frame, craig_bampton(20, {0, 2, 3}), "frame").body);
  expect_contract(reduce(plate, craig_bampton(8, {}, {0}), "pad").body);
  expect_contract(reduce(plate, craig_bampton(12, {0, 40}), "pad").body);
  expect_contract(reduce(shell, craig_bampton(10, {0}), "dish").body);
  expect_contract(reduce(shell, free_free(10), "dish").body);
}

TEST(ModalBasis, FreeFreeModesAreTheNaturalFrequenciesOfTheModel) {
  const double tolerance = 1e-7;  // round-off of stiffness: short elements are 1e7 times as stiff as the first mode
  for (const FeModel& model : {strut(), pad(), dish()}) {
    const VectorXd f = test::natural_frequencies(model, {}, 14).tail(8);
    const ReducedBody reduced = reduce(model, free_free(8), "body");
    EXPECT_LT((frequencies(reduced.body) - f).cwiseQuotient(f).cwiseAbs().maxCoeff(), tolerance);
    // Without interface Craig-Bampton is the same.
    const ReducedBody same = reduce(model, craig_bampton(8, {}), "body");
    EXPECT_LT((frequencies(same.body) - f).cwiseQuotient(f).cwiseAbs().maxCoeff(), tolerance);
  }
}

// Compliance of self-equilibrated loads at the interface: sum over modes of (Phi^T F)^2 / omega^2 against the
// model's F . u.
TEST(ModalBasis, CraigBamptonAnswersJointForcesExactly) {
  const FeModel model = strut();
  const Vector3d p0 = model.nodes.col(0), p1 = model.nodes.col(8);
  const double tolerance = 1e-8;  // round-off of stiffness
  for (int modes : {1, 4, 10}) {
    const ReducedBody reduced = reduce(model, craig_bampton(modes, {0, 8}), "strut");
    for (int k = 0; k < 6; ++k) {
      VectorXd load = VectorXd::Zero(6 * model.node_count());
      const Vector3d force = k < 3 ? Vector3d(Vector3d::Unit(k)) : Vector3d::Zero();
      const Vector3d moment = k < 3 ? Vector3d::Zero() : Vector3d(Vector3d::Unit(k - 3));
      load.segment<3>(48) = force;
      load.segment<3>(51) = moment;
      load.segment<3>(0) = -force;
      load.segment<3>(3) = -moment - (p1 - p0).cross(force);
      const double exact = load.dot(static_solution(model, test::node_dofs(0), load));
      const ModalBody& body = reduced.body;
      const VectorXd Q = body.Phi.middleRows(24, 3).transpose() * load.segment<3>(48) +
                         body.Phi.topRows(3).transpose() * load.segment<3>(0) +
                         body.Psi.middleRows(24, 3).transpose() * load.segment<3>(51) +
                         body.Psi.topRows(3).transpose() * load.segment<3>(3);
      EXPECT_NEAR(Q.cwiseAbs2().cwiseQuotient(body.stiffness).sum(), exact, tolerance * exact)
          << modes << " modes, load " << k;
    }
  }
}

// The same rod along x and askew: the same frequencies, the same shapes turned with it, and as many sums over two modes that
// are zero. Counts that take one mode of a pair too; 8 elements are solved densely, 60 by iteration.
TEST(ModalBasis, ARodHasTheSameModesInEveryDirection) {
  const Vector3d along = Vector3d(0.64, -0.48, 0.6);
  const Matrix3d R = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitX(), along).toRotationMatrix();
  const auto rod = [](const Vector3d& to, int n) {
    return test::straight_beam(Vector3d::Zero(), to, n, tube_section(0.05, 0.008), kSteel);
  };
  for (const auto& [elements, modes] : {std::pair{8, 4}, {8, 5}, {60, 7}})
    for (const BasisOptions& options :
         {free_free(modes), craig_bampton(modes, {0, elements}), craig_bampton(modes, {}, {0, elements})}) {
      const ModalBody straight = reduce(rod(Vector3d::UnitX(), elements), options, "rod").body;
      const ModalBody askew = reduce(rod(along, elements), options, "rod").body;
      const std::string which = std::to_string(elements) + " elements, " + std::to_string(modes) + " modes";
      ASSERT_EQ(straight.mode_count(), askew.mode_count()) << which;
      EXPECT_LT((frequencies(askew) - frequencies(straight)).cwiseQuotient(frequencies(straight)).cwiseAbs().maxCoeff(),
                1e-7)
          << which;
      for (int k = 0; k < straight.mode_count(); ++k) {
        VectorXd turned = straight.Phi.col(k);
        for (int j = 0; j < straight.node_count(); ++j)
          turned.segment<3>(3 * j) = R * Vector3d(turned.segment<3>(3 * j));
        const double sign = turned.dot(askew.Phi.col(k)) < 0.0 ? -1.0 : 1.0;
        EXPECT_LT((sign * askew.Phi.col(k) - turned).norm(), 1e-5 * (1.0 + turned.norm())) << which << ", mode " << k;
      }
      EXPECT_LT(10 * ModalInertia(askew).products(), 11 * ModalInertia(straight).products()) << which;
    }
}

// As many modes as fixed-interface modes: static shapes of three clamps, 18 - 6; of two balls on a
// line, their distance alone.
TEST(ModalBasis, CraigBamptonKeepsEveryStaticShapeBesideTheModesAskedFor) {
  const FeModel model = strut();
  const auto modes = [&](const BasisOptions& options) { return reduce(model, options, "strut").body.mode_count(); };
  for (int on_top : {1, 4}) {
    EXPECT_EQ(modes(craig_bampton(on_top, {0, 4, 8})), 12 + on_top);
    EXPECT_EQ(modes(craig_bampton(on_top, {0})), on_top);
    EXPECT_EQ(modes(craig_bampton(on_top, {}, {0, 8})), 1 + on_top);
    EXPECT_EQ(modes(craig_bampton(on_top, {}, {0})), on_top);
  }
  BasisOptions low = craig_bampton(0, {0, 4, 8});
  low.mode_count.reset();
  low.max_frequency = 1.0;
  EXPECT_EQ(modes(low), 12) << "a frequency limit spares static shapes";
}

// A beam clamped at both ends under its weight: the first mode has (integral of phi)^2 / lambda = 0.8309^2 / 500.56 of
// L^5 / 720, phi of unit norm: all but 0.69 percent of the mean sag. Nothing else errs.
TEST(StaticError, OfABeamClampedAtBothEndsIsTheSagThatItsModesLack) {
  const FeModel model = test::straight_beam({0, 0, 0}, {1, 0, 0}, 16, rod_section(0.01), kSteel);
  const double lumping = 2e-4;
  const ReducedBody two = reduce(model, craig_bampton(2, {0, 16}), "beam");
  ASSERT_TRUE(two.body.static_error);
  EXPECT_NEAR(*two.body.static_error, 1.0 - 720.0 * std::pow(0.83086, 2) / 500.564, lumping);
  EXPECT_TRUE(two.warnings.empty());
  const ReducedBody one = reduce(model, craig_bampton(1, {0, 16}), "beam");
  EXPECT_NEAR(*one.body.static_error, 1.0, lumping) << "no sag in one of two planes";
  EXPECT_TRUE(one.warnings.empty()) << "the sag under its own weight is told in the summary alone";
}

// Without static shapes the response to loads at the joints errs, and that is warned of.
TEST(StaticError, AtTheAttachmentsIsWarnedOf) {
  const FeModel model = test::straight_beam({0, 0, 0}, {1, 0, 0}, 16, rod_section(0.01), kSteel);
  BasisOptions free = craig_bampton(1, {0, 16});
  free.kind = BasisKind::kFreeFree;
  const ReducedBody one = reduce(model, free, "beam");
  ASSERT_EQ(one.warnings.size(), 1u);
  EXPECT_TRUE(names(one.warnings[0], {"beam", "static_error"}));
}

// With all modes there are, nothing is lost; and of the free modes of a body that is held, a part always is.
TEST(StaticError, FallsToNothingWithTheModes) {
  const double round_off = 1e-6;  // of stiffness, short elements against the whole
  for (const auto& [nodes, pinned] : {std::pair<std::vector<int>, std::vector<int>>{{0, 4, 8}, {}}, {{4}, {0, 8}}}) {
    double before = 1.0;
    for (int modes : {2, 6, 12}) {
      const double now = *reduce(strut(), craig_bampton(modes, nodes, pinned), "strut").body.static_error;
      EXPECT_LE(now, before + round_off);
      before = now;
    }
    BasisOptions all = free_free(6 * 17 - 6);
    all.interface_nodes = nodes;
    all.pinned_nodes = pinned;
    EXPECT_NEAR(*reduce(strut(), all, "strut").body.static_error, 0.0, round_off);
    all.mode_count = 6;
    EXPECT_GT(*reduce(strut(), all, "strut").body.static_error, 1e-3);
  }
  EXPECT_FALSE(reduce(strut(), free_free(6), "strut").body.static_error) << "nothing is attached";
}

TEST(ModalBasis, PinnedInterfaceSpendsNoModesOnLocalKinks) {
  const FeModel model = pad();
  const VectorXd exact = frequencies(reduce(model, free_free(9), "pad").body);
  const VectorXd pinned = frequencies(reduce(model, craig_bampton(12, {}, {0}), "pad").body).head(9);
  // Modes that leave the centre at rest are in the basis; the mode that lifts it is approximated by static
  // shape and held modes.
  EXPECT_LT((pinned - exact).cwiseQuotient(exact).cwiseAbs().maxCoeff(), 2e-3);
  const VectorXd clamped = frequencies(reduce(model, craig_bampton(12, {0}), "pad").body).head(9);
  EXPECT_GT((clamped - exact).cwiseQuotient(exact).cwiseAbs().maxCoeff(), 1e-1) << "what the pin avoids";
}

// Stiffness spans ten decades: axial over bending of a wire 4000 times as long as thick; a box has many modes
// near each other.
TEST(ModalBasis, ManagesWiresAndThinShells) {
  const double d = 0.0005, L = 2.0;
  const FeModel wire = test::straight_beam({0, 0, 0}, {L, 0, 0}, 64, rod_section(d), kSteel);
  const double x = 4.730040745;  // cos x cosh x = 1
  const double exact = x * x / (2.0 * kPi * L * L) * std::sqrt(kSteel.young / kSteel.density) * d / 4.0;
  for (const BasisOptions& options : {free_free(6), craig_bampton(12, {0, 64})}) {
    const ModalBody body = reduce(wire, options, "wire").body;
    const double truncation = options.kind == BasisKind::kFreeFree ? 1e-5 : 1e-3;  // of six held modes
    EXPECT_NEAR(frequencies(body)(0), exact, truncation * exact);
    expect_contract(body);
  }
  const FeModel box = plate_model(box_mesh(Vector3d(0.4, 0.3, 0.2), 0.1), 0.003, kSteel);
  expect_contract(reduce(box, craig_bampton(10, {}, {0}), "box").body);
}

TEST(ElasticScale, IsTheSizeOfTheFirstElasticLambda) {
  for (const FeModel& model : {strut(), pad(), dish()}) {
    const double first = reduce(model, free_free(1), "body").body.stiffness(0);
    EXPECT_GT(elastic_scale(model), 0.99 * first);
    EXPECT_LT(elastic_scale(model), 2.0 * first);
  }
}

TEST(ModalBasis, FrequencyLimitLeavesOutHigherModes) {
  const FeModel model = pad();
  const VectorXd all = frequencies(reduce(model, free_free(20), "pad").body);
  BasisOptions options;
  options.max_frequency = 0.5 * (all(8) + all(9));
  options.kind = BasisKind::kFreeFree;
  EXPECT_EQ(reduce(model, options, "pad").body.mode_count(), 9);
  options.kind = BasisKind::kCraigBampton;
  options.pinned_nodes = {0};
  // Held at its pin the plate turns freely: three zeros. A pin alone has no elastic static shape.
  const VectorXd held = test::natural_frequencies(model, test::node_dofs(0, {0, 1, 2}), 20);
  EXPECT_EQ(reduce(model, options, "pad").body.mode_count(),
            static_cast<int>((held.array() <= *options.max_frequency).count()) - 3);
  options.mode_count = 4;
  EXPECT_EQ(reduce(model, options, "pad").body.mode_count(), 4) << "both limits hold";
  options.mode_count.reset();
  options.max_frequency = 0.5 * all(0);
  const ReducedBody rigid = reduce(model, options, "pad");
  EXPECT_EQ(rigid.body.mode_count(), 0);
  ASSERT_EQ(rigid.warnings.size(), 1u);
  EXPECT_EQ(reduce(model, BasisOptions{}, "pad").body.mode_count(), kDefaultModeCount);
}

TEST(ModalBasis, ZeroModesGiveTheRigidBodyOfTheModel) {
  const FeModel model = strut();
  const MassProperties exact = mass_properties(model);
  const ReducedBody reduced = reduce(model, craig_bampton(0, {0, 8}), "strut");
  EXPECT_EQ(reduced.body.mode_count(), 0);
  EXPECT_TRUE(reduced.warnings.empty());
  EXPECT_LT((reduced.p_DBo - exact.centre).norm(), 1e-14);
  const ModalInertia inertia(reduced.body);
  MatrixXd M(6, 6);
  inertia.mass_matrix(VectorXd(0), M);
  EXPECT_LT((M.bottomRightCorner<3, 3>() - exact.inertia).norm(), 1e-13 * exact.inertia.norm());
  EXPECT_NEAR(inertia.mass(), exact.mass, 1e-13 * exact.mass);
  EXPECT_EQ(LargestStress(reduced.body).at(VectorXd(0)), 0.0);
  EXPECT_EQ(largest_deflection(reduced.body, VectorXd(0)), 0.0);
}

TEST(ModalBasis, DampingIsTwoZetaOmega) {
  BasisOptions options = free_free(4);
  options.damping_ratio = {0.01, 0.03};
  const ModalBody body = reduce(strut(), options, "strut").body;
  const VectorXd omega = body.stiffness.cwiseSqrt();
  EXPECT_NEAR(body.damping(0), 0.02 * omega(0), 1e-12 * omega(0));
  for (int k = 1; k < 4; ++k) EXPECT_NEAR(body.damping(k), 0.06 * omega(k), 1e-12 * omega(k));
}

TEST(ModalBasis, TakesAllModesThereAreButNotOneMore) {
  const FeModel model = test::straight_beam({0, 0, 0}, {1, 0, 0}, 1, tube_section(0.05, 0.005), kSteel);
  const int available = 6 * 3 - 6;  // three nodes with rotary inertia
  EXPECT_EQ(reduce(model, free_free(available), "rod").body.mode_count(), available);
  EXPECT_TRUE(names(error_of([&] { reduce(model, free_free(available + 1), "rod"); }), {"13 modes", "12"}));
  // Both ends held: six static shapes, and the six motions of the node between them.
  EXPECT_EQ(reduce(model, craig_bampton(6, {0, 1}), "rod").body.mode_count(), available);
  EXPECT_TRUE(names(error_of([&] { reduce(model, craig_bampton(7, {0, 1}), "rod"); }), {"7 modes", "6"}));
  const FeModel plate = plate_model(disc_mesh(0.2, 0.2), 0.01, kSteel);
  const int plate_modes = 3 * 7 - 6;  // no rotary inertia
  EXPECT_EQ(reduce(plate, free_free(plate_modes), "pad").body.mode_count(), plate_modes);
  EXPECT_THROW(reduce(plate, free_free(plate_modes + 1), "pad"), InputError);
}

TEST(ModalBasis, RefusesModelsThatAreNoFreeBody) {
  const FeModel good = strut();
  const BasisOptions options = craig_bampton(6, {0, 8});
  const auto with = [&](const FeModel& model) { return refusal([&] { reduce(model, options, "leg"); }); };

  FeModel model = good;
  model.node_mass(3) = -0.1;
  EXPECT_TRUE(names(with(model), {"leg", "node 3"}));
  model = good;
  model.node_mass.setZero();
  EXPECT_NE(with(model), "");
  model = good;
  model.node_inertia[2](0, 0) = -1.0;
  EXPECT_TRUE(names(with(model), {"leg", "node 2"}));
  model = test::straight_beam({0, 0, 0}, {1, 0, 0}, 8, rod_section(0.02), kSteel);
  for (Matrix3d& J : model.node_inertia) J.setZero();
  EXPECT_NE(with(model), "");
  model = good;
  model.stiffness.coeffRef(2, 2) *= 1.01;
  EXPECT_NE(with(model), "");
  model = good;
  model.stiffness.coeffRef(0, 6 * 9) *= 1.01;
  EXPECT_NE(with(model), "");

  model = good;  // a negative spring along the line between two nodes, stiffer than the tube between them
  const Vector3d e = Vector3d(model.nodes.col(1) - model.nodes.col(0)).normalized();
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      const double spring = -2e9 * e(i) * e(k);
      model.stiffness.coeffRef(i, k) += spring;
      model.stiffness.coeffRef(6 + i, 6 + k) += spring;
      model.stiffness.coeffRef(i, 6 + k) -= spring;
      model.stiffness.coeffRef(6 + i, k) -= spring;
    }
  EXPECT_TRUE(names(with(model), {"leg"}));

  EXPECT_THROW(reduce(good, craig_bampton(6, {0, 99}), "leg"), InputError);
  EXPECT_THROW(reduce(good, craig_bampton(-1, {0}), "leg"), InputError);
  BasisOptions bad = options;
  bad.damping_ratio = {-0.01};
  EXPECT_THROW(reduce(good, bad, "leg"), InputError);
}

// Two struts in one model with a common ball joint: connected by stiffness, but free to fold.
TEST(ModalBasis, RefusesAMechanism) {
  const FeModel a = test::straight_beam({0, 0, 0}, {1, 0, 0}, 2, rod_section(0.02), kSteel);
  const FeModel b = test::straight_beam({1, 0, 0}, {1, 1, 0}, 2, rod_section(0.02), kSteel);
  const int n = a.node_count();
  FeModel both;
  both.nodes.resize(3, 2 * n);
  both.nodes << a.nodes, b.nodes;
  both.node_mass.resize(2 * n);
  both.node_mass << a.node_mass, b.node_mass;
  both.node_inertia = a.node_inertia;
  both.node_inertia.insert(both.node_inertia.end(), b.node_inertia.begin(), b.node_inertia.end());
  std::vector<Eigen::Triplet<double>> entries;
  for (int part = 0; part < 2; ++part) {
    const Eigen::SparseMatrix<double>& K = part == 0 ? a.stiffness : b.stiffness;
    for (int j = 0; j < K.cols(); ++j)
      for (Eigen::SparseMatrix<double>::InnerIterator it(K, j); it; ++it)
        entries.emplace_back(6 * n * part + it.row(), 6 * n * part + j, it.value());
  }
  both.stiffness.resize(12 * n, 12 * n);
  both.stiffness.setFromTriplets(entries.begin(), entries.end());
  both.stress.resize(0, 12 * n);
  EXPECT_THROW(reduce(both, free_free(5), "leg"), InputError);
  for (int i = 0; i < 3; ++i) {
    const double k = 1e8;
    entries.emplace_back(12 + i, 12 + i, k);  // node 2, the end of a
    entries.emplace_back(6 * n + i, 6 * n + i, k);
    entries.emplace_back(12 + i, 6 * n + i, -k);
    entries.emplace_back(6 * n + i, 12 + i, -k);
  }
  both.stiffness.setFromTriplets(entries.begin(), entries.end());
  EXPECT_TRUE(names(error_of([&] { reduce(both, free_free(5), "leg"); }), {code::kFeModel.number, " 9 "}));
  EXPECT_THROW(reduce(both, craig_bampton(8, {0}), "leg"), InputError);
}

TEST(ModalBasis, WarnsWhenUnitsAreOffByAThousand) {
  const BeamSection section = rod_section(0.02);
  const FeModel soft = test::straight_beam({0, 0, 0}, {50.0, 0, 0}, 8, section, Material{7850.0, 207e3, 0.3});
  ReducedBody reduced = reduce(soft, free_free(2), "leg");
  ASSERT_EQ(reduced.warnings.size(), 1u);
  EXPECT_TRUE(names(reduced.warnings[0], {"leg"}));
  const FeModel small = test::straight_beam({0, 0, 0}, {1e-3, 0, 0}, 8, rod_section(1e-3), Material{7.85, 207e9, 0.3});
  EXPECT_EQ(reduce(small, free_free(2), "leg").warnings.size(), 1u);
  EXPECT_TRUE(reduce(strut(), free_free(2), "leg").warnings.empty());
}

TEST(OrthonormalModes, OfDependentOrRigidShapesAreRefused) {
  ModalBody raw = reduce(strut(), free_free(3), "leg").body;
  const MatrixXd K = raw.stiffness.asDiagonal();
  ModalBody dependent = raw;
  dependent.Phi.col(2) = dependent.Phi.col(0) + dependent.Phi.col(1);
  dependent.Psi.col(2) = dependent.Psi.col(0) + dependent.Psi.col(1);
  EXPECT_THROW(orthonormalised(dependent, K, BasisOptions{}), InputError);
  ModalBody rigid = raw;
  for (int j = 0; j < rigid.node_count(); ++j) rigid.Phi.block<3, 1>(3 * j, 1) = Vector3d(1, 2, 3);
  rigid.Psi.col(1).setZero();
  EXPECT_THROW(orthonormalised(rigid, K, BasisOptions{}), InputError);
  EXPECT_THROW(orthonormalised(raw, -K, BasisOptions{}), InputError);
}

// Shapes with rigid motion added and mixed with each other, about another origin, describe the same flexible
// body.
TEST(OrthonormalModes, DoNotDependOnTheShapesThatSpanThem) {
  const ReducedBody good = reduce(strut(), free_free(4), "leg");
  ModalBody raw = good.body;
  MatrixXd Y(4, 4);
  Y << 2, 1, 0, 0, 0, 3, 1, 0, 0, 0, 1, 4, 1, 0, 0, 5;
  raw.Phi = (raw.Phi * Y).eval();
  raw.Psi = (raw.Psi * Y).eval();
  for (int j = 0; j < raw.node_count(); ++j) {
    const Vector3d w(0.3, -0.2, 0.5);
    raw.Phi.block<3, 1>(3 * j, 2) += Vector3d(1, 2, 3) + w.cross(Vector3d(raw.rho0.col(j)));
    raw.Psi.block<3, 1>(3 * j, 2) += w;
  }
  raw.rho0.colwise() += good.p_DBo;
  const ReducedBody again = orthonormalised(raw, Y.transpose() * good.body.stiffness.asDiagonal() * Y, free_free(4));
  expect_contract(again.body);
  EXPECT_LT((again.p_DBo - good.p_DBo).norm(), 1e-12);
  EXPECT_LT((frequencies(again.body) - frequencies(good.body)).norm(), 1e-8 * frequencies(good.body).norm());
}

using Sparse = Eigen::SparseMatrix<double>;

// n masses in a row between walls: omega_k = 2 sin(k pi / (2 (n + 1))). Every other mass may be left out.
void chain(int n, bool every_other_massless, Sparse& K, Sparse& M) {
  K.resize(n, n);
  M.resize(n, n);
  for (int i = 0; i < n; ++i) {
    K.insert(i, i) = 2.0;
    if (i > 0) K.insert(i, i - 1) = -1.0;
    if (i + 1 < n) K.insert(i, i + 1) = -1.0;
    if (!every_other_massless || i % 2 == 1) M.insert(i, i) = 1.0;
  }
}

TEST(LowestModes, OfAChainAreTheExactOnesByEitherMethod) {
  Sparse K, M;
  const int n = 60, count = 5;
  chain(n, false, K, M);
  for (EigenMethod method : {EigenMethod::kDense, EigenMethod::kSubspace}) {
    const Modes modes = lowest_modes(K, M, count, 0.0, method);
    for (int k = 0; k < count; ++k) {
      const double omega = 2.0 * std::sin((k + 1) * kPi / (2.0 * (n + 1)));
      EXPECT_NEAR(modes.lambda(k), omega * omega, 1e-10 * omega * omega);
    }
    const Eigen::MatrixXd orthonormal = modes.shapes.transpose() * M * modes.shapes;
    EXPECT_LT((orthonormal - Eigen::MatrixXd::Identity(count, count)).norm(), 1e-10);
  }
}

TEST(LowestModes, OfMasslessDegreesOfFreedomFollowStatically) {
  // Condensed, masses at odd places are joined by springs 1/2, with a whole spring 1 from the last to the
  // wall.
  Sparse K, M;
  chain(21, true, K, M);
  Eigen::MatrixXd K10 = Eigen::MatrixXd::Zero(10, 10);
  for (int i = 0; i < 10; ++i) {
    K10(i, i) = 1.0;
    if (i > 0) K10(i, i - 1) = K10(i - 1, i) = -0.5;
  }
  const Eigen::VectorXd exact = symmetric_modes(K10).values;
  EXPECT_LT((lowest_modes(K, M, 10, 0.0).lambda - exact).norm(), 1e-10);
  EXPECT_LT((lowest_modes(K, M, 4, 0.0, EigenMethod::kSubspace).lambda - exact.head(4)).norm(), 1e-10);
  EXPECT_THROW(lowest_modes(K, M, 11, 0.0), InputError) << "ten masses have ten modes";
  EXPECT_THROW(lowest_modes(K, M, 22, 0.0), InputError) << "more modes than degrees of freedom";
}

TEST(LowestModes, OfAFreePlateAgreeBetweenTheMethods) {
  const FeModel model = plate_model(disc_mesh(0.2, 0.05), 0.004, Material{7850.0, 207e9, 0.3});
  const Sparse M = mass_matrix(model);
  const int count = 16;
  const double shift = elastic_scale(model);
  const Modes dense = lowest_modes(model.stiffness, M, count, shift, EigenMethod::kDense);
  const Modes subspace = lowest_modes(model.stiffness, M, count, shift, EigenMethod::kSubspace);
  const double round_off = 1e-7;  // of lambda: the membrane is 1e6 times as stiff as bending
  for (int k = 6; k < count; ++k) EXPECT_NEAR(subspace.lambda(k), dense.lambda(k), round_off * dense.lambda(k));
  for (int k = 0; k < 6; ++k) EXPECT_LT(std::abs(subspace.lambda(k)), round_off * dense.lambda(6));
  // The same space: mass products of the two sets of elastic modes are an orthogonal matrix (pairs may be
  // turned).
  const Eigen::MatrixXd P = dense.shapes.rightCols(8).transpose() * M * subspace.shapes.rightCols(8);
  EXPECT_GT(std::abs(P.leftCols(2).norm()), std::sqrt(2.0) * (1.0 - 1e-6));
}

TEST(LowestModes, RefuseABodyThatFloatsWithoutShift) {
  Sparse K(2, 2), M(2, 2);
  K.insert(0, 0) = K.insert(1, 1) = 1.0;
  K.insert(0, 1) = K.insert(1, 0) = -1.0;
  M.setIdentity();
  EXPECT_THROW(lowest_modes(K, M, 1, 0.0), InputError);
  EXPECT_NEAR(lowest_modes(K, M, 2, 1.0).lambda(1), 2.0, 1e-12);
}

const Matrix3d kTurn = Eigen::AngleAxisd(1.1, Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
const Vector3d kShift(0.3, -2.0, 0.7);

// A dish and a bent frame, as drawn and moved by x -> R x + p.
FeModel moved_dish(const Matrix3d& R = Matrix3d::Identity(), const Vector3d& p = Vector3d::Zero(),
                   double young = 207e9) {
  return plate_model(moved(dish_mesh(0.2, 0.04, 0.05), R, p), 0.004, {7850.0, young, 0.3});
}

FeModel moved_frame(const Matrix3d& R = Matrix3d::Identity(), const Vector3d& p = Vector3d::Zero(),
                    double wall = 0.008) {
  std::vector<Vector3d> nodes = {{0.2, 0.1, 0.0}, {0.7, 0.4, 1.0}, {0.9, 0.4, 1.1}};
  for (Vector3d& node : nodes) node = R * node + p;
  BeamMember first = member(0, 1), second = member(1, 2);
  first.up = second.up = R * Vector3d::UnitY();
  return beam_model(nodes, {first, second}, {tube_section(0.05, wall)}, kSteel);
}

BasisOptions held(int modes, std::vector<int> nodes) {
  BasisOptions options;
  options.mode_count = modes;
  options.interface_nodes = std::move(nodes);
  return options;
}

// What forces at all nodes do, whatever the modes are: Phi K^-1 Phi^T, Psi K^-1 Phi^T, and the stresses.
MatrixXd compliance(const MatrixXd& rows, const ModalBody& body) {
  return rows * body.stiffness.cwiseInverse().asDiagonal() * body.Phi.transpose();
}

// Forces and answers in vectors of three, turned.
MatrixXd turned_blocks(const MatrixXd& matrix, const Matrix3d& rows, const Matrix3d& columns) {
  MatrixXd out(matrix.rows(), matrix.cols());
  for (Eigen::Index i = 0; i < matrix.rows(); i += 3)
    for (Eigen::Index j = 0; j < matrix.cols(); j += 3)
      out.block<3, 3>(i, j) = rows * matrix.block<3, 3>(i, j) * columns.transpose();
  return out;
}

void expect_same(const MatrixXd& a, const MatrixXd& b, const char* what) {
  ASSERT_EQ(a.rows(), b.rows()) << what;
  ASSERT_EQ(a.cols(), b.cols()) << what;
  EXPECT_LT((a - b).norm(), 1e-7 * b.norm()) << what;
}

void expect_copy_like_its_own(const FeModel& model, const FeModel& copy, const BasisOptions& options) {
  const std::optional<Vector3d> p = place_of_copy(model, copy, kTurn);
  ASSERT_TRUE(p.has_value());
  EXPECT_LT((*p - kShift).norm(), 1e-12);
  const ReducedBody made = turned(reduce(model, options, "first"), kTurn, *p, "second");
  const ReducedBody own = reduce(copy, options, "second");
  EXPECT_EQ(made.body.name, "second");
  EXPECT_LT((made.p_DBo - own.p_DBo).norm(), 1e-12);
  expect_same(made.body.rho0, own.body.rho0, "nodes");
  for (std::size_t j = 0; j < own.body.node_inertia.size(); ++j)
    EXPECT_LT((made.body.node_inertia[j] - own.body.node_inertia[j]).norm(), 1e-12) << "inertia";
  expect_same(frequencies(made.body), frequencies(own.body), "frequencies");
  expect_same(compliance(made.body.Phi, made.body), compliance(own.body.Phi, own.body), "deflection");
  expect_same(compliance(made.body.Psi, made.body), compliance(own.body.Psi, own.body), "rotation");
  expect_same(compliance(made.body.stress_modes, made.body), compliance(own.body.stress_modes, own.body), "stress");
  // and it is the first one's, turned
  const ModalBody first = reduce(model, options, "first").body;
  expect_same(turned_blocks(compliance(first.Phi, first), kTurn, kTurn), compliance(own.body.Phi, own.body), "turned");
}

TEST(TurnedModel, IsReducedLikeAModelOfItsOwn) {
  expect_copy_like_its_own(moved_dish(), moved_dish(kTurn, kShift), held(6, {}));
  expect_copy_like_its_own(moved_frame(), moved_frame(kTurn, kShift), held(4, {0, 2}));
}

TEST(TurnedModel, IsNoOtherModel) {
  EXPECT_FALSE(place_of_copy(moved_dish(), moved_dish(kTurn, kShift), Matrix3d::Identity())) << "another turn";
  EXPECT_FALSE(place_of_copy(moved_dish(), moved_dish(kTurn, kShift, 207e9 * (1.0 + 1e-8)), kTurn))
      << "a little stiffer";
  EXPECT_FALSE(place_of_copy(moved_frame(), moved_frame(kTurn, kShift, 0.008 * (1.0 + 1e-8)), kTurn))
      << "a thicker wall";
  EXPECT_FALSE(place_of_copy(moved_frame(), moved_dish(kTurn, kShift), kTurn));
  FeModel heavier = moved_frame(kTurn, kShift);
  heavier.node_mass[1] *= 1.0 + 1e-8;
  EXPECT_FALSE(place_of_copy(moved_frame(), heavier, kTurn));
  FeModel inert = moved_frame(kTurn, kShift);
  inert.node_inertia[1] *= 1.0 + 1e-8;
  EXPECT_FALSE(place_of_copy(moved_frame(), inert, kTurn));
  FeModel bent = moved_frame(kTurn, kShift);
  bent.nodes(0, 2) += 1e-8;
  EXPECT_FALSE(place_of_copy(moved_frame(), bent, kTurn));
  FeModel otherwise_stressed = moved_frame(kTurn, kShift);
  otherwise_stressed.stress *= 1.0 + 1e-8;
  EXPECT_FALSE(place_of_copy(moved_frame(), otherwise_stressed, kTurn));
  FeModel softer = moved_frame(kTurn, kShift);  // one entry of stiffness alone
  softer.stiffness.coeffRef(3, 3) *= 1.0 + 1e-8;
  EXPECT_FALSE(place_of_copy(moved_frame(), softer, kTurn));
  FeModel otherwise_joined = moved_frame(kTurn, kShift);
  std::swap(otherwise_joined.segments[0], otherwise_joined.segments[1]);
  EXPECT_FALSE(place_of_copy(moved_frame(), otherwise_joined, kTurn));
}

}  // namespace
}  // namespace footfall
