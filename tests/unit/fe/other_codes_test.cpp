// Models of CalculiX, made with gmsh (tests/bench/calculix): bar, plate, bracket and leg of a lander, each with the matrices,
// frequencies and deflections that CalculiX 2.20 gives; and the same numbers in the formats of other codes.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>

#include "coupler/base/errors.h"
#include "mbd_solver/fe/fe_analysis.h"
#include "mbd_solver/fe/fe_mesh.h"
#include "mbd_solver/fe/matrix_model.h"
#include "mbd_solver/fe/modal_basis.h"
#include "mbd_solver/fe/model_text.h"
#include "mbd_solver/fe/spider.h"
#include "mbd_solver/fe/triangle_mesh.h"
#include "mbd_solver/model/body.h"
#include "mbd_solver/model/modal_inertia.h"
#include "tests/support/fe_reference.h"
#include "tests/support/linear_algebra.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/fe/steel_frame.h"

namespace footfall {
namespace {

using namespace test;

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

std::string data(const std::string& file) { return std::string(FOOTFALL_CALCULIX) + "/" + file; }

// A folder of files that is removed with its owner.
struct Files : TemporaryFolder {
  std::string add(const std::string& name, const std::string& text) const { return write(name, text); }
};

// What CalculiX says about a model.
struct Results {
  // Frequencies free, held, lumped_free, lumped_held [Hz]; inertia, lumped_inertia: mass, its centre, and its second moments
  // xx yy zz xy xz yz about the centre [units of the file].
  std::map<std::string, VectorXd> frequencies;
  std::map<long, Vector3d>
      deflections;  // under 10 N against z at each of these nodes, with the root held [units of the file]
};
Results results_of(const std::string& name) {
  Results results;
  std::ifstream file(data(name + ".results"));
  for (std::string line, kind; std::getline(file, line);) {
    std::istringstream words(line);
    words >> kind;
    std::vector<double> numbers;
    for (double x = 0.0; words >> x;) numbers.push_back(x);
    if (kind == "static") {
      results.deflections[static_cast<long>(numbers[0])] = {numbers[1], numbers[2], numbers[3]};
    } else {
      results.frequencies[kind] = Eigen::Map<VectorXd>(numbers.data(), static_cast<Index>(numbers.size()));
    }
  }
  return results;
}

struct Sample {
  const char* name;
  const char* root;  // node sets
  UnitSystem units;
  double length;  // of the unit [m]
};
const Sample kSamples[] = {{"bar", "ROOT", UnitSystem::kMetre, 1.0},
                           {"plate", "ROOT", UnitSystem::kMetre, 1.0},
                           {"bracket", "TOP", UnitSystem::kMillimetreTonne, 1e-3},
                           {"leg", "ROOT", UnitSystem::kMetre, 1.0}};

MatrixFiles files_of(const Sample& sample, bool lumped = false) {
  const std::string name = sample.name;
  MatrixFiles files;
  files.stiffness = data(name + ".sti");
  files.mass = data(name + (lumped ? "_lumped.mas" : ".mas"));
  files.nodes = data(name + ".inp");
  files.units = sample.units;
  return files;
}

// Degrees of freedom of the displacements of a set of nodes. (All nodes of these meshes have rows.)
std::vector<int> held_dofs(const FeMesh& mesh, const std::string& set) {
  std::vector<int> dofs;
  for (const int node : mesh.set(set, "mesh"))
    for (int i = 0; i < 3; ++i) dofs.push_back(6 * node + i);
  std::sort(dofs.begin(), dofs.end());
  return dofs;
}

FeMesh mesh_of(const std::string& path) { return parse_fe_mesh(bytes_of_model(path), path); }

BasisOptions free_modes(int count) {
  BasisOptions options;
  options.kind = BasisKind::kFreeFree;
  options.mode_count = count;
  return options;
}

double largest_difference(const VectorXd& found, const VectorXd& expected) {
  return ((found - expected).array() / expected.array()).abs().maxCoeff();
}

// CalculiX prints frequencies with seven digits. Its own are found without, ours with a shift; the bound of a user is 1e-3.
constexpr double kPrinted = 2e-6;

TEST(CalculixModels, HaveTheFrequenciesThatCalculixFinds) {
  for (const Sample& sample : kSamples)
    for (const bool lumped : {false, true}) {
      const Results results = results_of(sample.name);
      const FeModel model = read_matrix_model(files_of(sample, lumped));
      const FeMesh mesh = mesh_of(data(std::string(sample.name) + ".inp"));
      const std::string kind = lumped ? "lumped_" : "";
      const ReducedBody reduced = reduce(model, free_modes(10), sample.name);
      EXPECT_LT(largest_difference(frequencies(reduced.body), results.frequencies.at(kind + "free")), kPrinted)
          << sample.name << kind;
      EXPECT_TRUE(reduced.warnings.empty()) << sample.name << reduced.warnings.front();
      const VectorXd held = test::natural_frequencies(model, held_dofs(mesh, sample.root), 10);
      EXPECT_LT(largest_difference(held, results.frequencies.at(kind + "held")), kPrinted) << sample.name << kind;
    }
}

// Deflections of the loaded nodes, seven digits.
TEST(CalculixModels, DeflectAsCalculixFinds) {
  for (const Sample& sample : kSamples) {
    const Results results = results_of(sample.name);
    const FeModel model = read_matrix_model(files_of(sample));
    const FeMesh mesh = mesh_of(data(std::string(sample.name) + ".inp"));
    VectorXd load = VectorXd::Zero(model.stiffness.rows());
    for (const auto& [id, u] : results.deflections) load(6 * mesh.index.at(id) + 2) = -10.0;
    const VectorXd found = static_solution(model, held_dofs(mesh, sample.root), load);
    double largest = 0.0, off = 0.0;
    for (const auto& [id, u] : results.deflections) {
      largest = std::max(largest, sample.length * u.norm());
      off = std::max(off, (found.segment<3>(6 * mesh.index.at(id)) - sample.length * u).norm());
    }
    EXPECT_LT(off, kPrinted * largest) << sample.name;
  }
}

// Mass, centre and inertia follow from the matrices, as of the solid that the mesh encloses. Bricks are exact; CalculiX
// integrates linear tetrahedra at one point, which puts their second moments off, and the tapered leg by a finite rule.
TEST(CalculixModels, HaveTheInertiaOfTheirSolid) {
  const double density[] = {7850.0, 7850.0, 2700.0, 2700.0}, off[] = {1e-9, 1e-9, 1e-9, 1e-3},
               off_inertia[] = {1e-9, 1e-9, 1e-2, 1e-3};
  for (std::size_t k = 0; k < 4; ++k) {
    const Sample& sample = kSamples[k];
    const FeModel model = read_matrix_model(files_of(sample));
    TriangleMesh skin;
    for (Index j = 0; j < model.nodes.cols(); ++j) skin.vertices.push_back(model.nodes.col(j));
    skin.triangles = model.triangles;
    const MassProperties solid = polyhedron_properties(skin, density[k], sample.name), found = mass_properties(model);
    EXPECT_NEAR(found.mass, solid.mass, off[k] * solid.mass) << sample.name;
    EXPECT_LT((found.centre - solid.centre).norm(), off[k]) << sample.name;
    EXPECT_LT((found.inertia - solid.inertia).norm(), off_inertia[k] * solid.inertia.norm()) << sample.name;
    // The body that moves has them as well, with the coordinates of incompatible modes (C3D8I), which have no place.
    const ModalBody body = reduce(model, free_modes(6), sample.name).body;
    const Body moving(sample.name, std::make_shared<const ModalBody>(body));
    EXPECT_NEAR(moving.mass(), found.mass, 1e-12 * found.mass) << sample.name;
    EXPECT_LT((moving.rigid_inertia() - found.inertia).norm(), 1e-9 * found.inertia.norm()) << sample.name;
    MatrixXd M(12, 12), expected = MatrixXd::Identity(12, 12);
    ModalInertia(body).mass_matrix(VectorXd::Zero(6), M);
    expected.topLeftCorner<3, 3>() *= found.mass;
    expected.block<3, 3>(3, 3) = found.inertia;
    EXPECT_LT((M - expected).norm(), 1e-6) << sample.name << ": orthonormal, and free of rigid motion";
  }
}

// --- Guyan's reduction in the formats of other codes.

std::string digits(double x) {
  std::ostringstream text;
  text.precision(16);
  text << std::scientific << x;
  return text.str();
}

// K and M on the displacements of some nodes: u = G u_kept, G = [1; -K_ii^-1 K_ik].
struct Condensed {
  std::vector<int> nodes;  // of the mesh
  MatrixXd K, M;
};
Condensed condensed(const FeModel& model, std::vector<int> nodes) {
  std::sort(nodes.begin(), nodes.end());
  std::vector<int> kept;
  for (const int node : nodes)
    for (int i = 0; i < 3; ++i) kept.push_back(6 * node + i);
  const std::vector<int> inner = other_dofs(active_dofs(model), kept);
  const MatrixXd K_ii = MatrixXd(selected(model.stiffness, inner, inner)),
                 K_ik = MatrixXd(selected(model.stiffness, inner, kept));
  const MatrixXd G = scattered(-solve(K_ii, K_ik), inner, model.stiffness.rows()) +
                     scattered(MatrixXd::Identity(K_ik.cols(), K_ik.cols()), kept, model.stiffness.rows());
  const MatrixXd K = G.transpose() * (model.stiffness * G), M = G.transpose() * (mass_matrix(model) * G);
  return {nodes, 0.5 * (K + K.transpose()), 0.5 * (M + M.transpose())};
}

std::string dof_list(const Condensed& model, const FeMesh& mesh) {
  std::string text;
  for (const int node : model.nodes)
    for (int i = 1; i <= 3; ++i)
      text += std::to_string(mesh.ids[static_cast<std::size_t>(node)]) + "." + std::to_string(i) + "\n";
  return text;
}

// `row column value` of one triangle, as CalculiX.
std::string triangle_text(const MatrixXd& A) {
  std::string text;
  for (Index j = 0; j < A.cols(); ++j)
    for (Index i = 0; i <= j; ++i)
      text += std::to_string(i + 1) + " " + std::to_string(j + 1) + "  " + digits(A(i, j)) + "\n";
  return text;
}

// `node, dof, node, dof, value`, as *MATRIX GENERATE of Abaqus.
std::string abaqus_text(const MatrixXd& A, const std::vector<long>& ids) {
  std::string text = "** stiffness or mass\n";
  for (Index i = 0; i < A.rows(); ++i)
    for (Index j = 0; j <= i; ++j) {
      const auto label = [&](Index k) {
        return std::to_string(ids[static_cast<std::size_t>(k / 3)]) + "," + std::to_string(k % 3 + 1);
      };
      text += label(i) + ", " + label(j) + ",  " + digits(A(i, j)) + "\n";
    }
  return text;
}

// DMIG cards of a punch file, large fields and Fortran's exponents.
std::string dmig_text(const std::string& name, const MatrixXd& A, const std::vector<long>& ids) {
  char line[200];
  std::snprintf(line, sizeof line, "DMIG    %-8s%8d%8d%8d%8d\n", name.c_str(), 0, 6, 2, 0);
  std::string text = line;
  for (Index j = 0; j < A.cols(); ++j) {
    std::snprintf(line, sizeof line, "DMIG*   %-16s%16ld%16ld\n", name.c_str(), ids[static_cast<std::size_t>(j / 3)],
                  static_cast<long>(j % 3 + 1));
    text += line;
    for (Index i = 0; i <= j; ++i) {
      std::snprintf(line, sizeof line, "*       %16ld%16ld%16.9E\n", ids[static_cast<std::size_t>(i / 3)],
                    static_cast<long>(i % 3 + 1), A(i, j));
      std::string card = line;
      card.replace(card.rfind('E'), 1, "D");
      text += card;
    }
  }
  return text;
}

// *USER ELEMENT of *SUBSTRUCTURE GENERATE.
std::string substructure_text(const MatrixXd& K, const MatrixXd& M, const std::vector<long>& ids) {
  std::string text = "**\n*USER ELEMENT, NODES=" + std::to_string(ids.size()) + ", LINEAR\n** ELEMENT NODES\n** ";
  for (const long id : ids) text += std::to_string(id) + ", ";
  text += "\n1, 2, 3\n";
  for (const auto& [type, A] : {std::pair<const char*, const MatrixXd&>{"STIFFNESS", K}, {"MASS", M}}) {
    text += std::string("*MATRIX, TYPE=") + type + "\n";
    for (Index i = 0; i < A.rows(); ++i)
      for (Index j = 0; j <= i; ++j) text += digits(A(i, j)) + (j == i || j % 4 == 3 ? ",\n" : ", ");
  }
  return text;
}

// --- The three forms of a model, as the body that moves.

enum class Form { kConsistent, kLumped, kGuyan };

// Nodes that Guyan's reduction keeps: the given sets, then those with the least stiffness over mass.
std::vector<int> kept_nodes(const FeModel& model, const FeMesh& mesh, const std::vector<const char*>& sets,
                            double share) {
  std::vector<int> order(static_cast<std::size_t>(model.node_count()));
  for (std::size_t j = 0; j < order.size(); ++j) order[j] = static_cast<int>(j);
  std::vector<bool> first(order.size(), false);
  for (const char* set : sets)
    for (const int node : mesh.set(set, "mesh")) first[static_cast<std::size_t>(node)] = true;
  const auto ratio = [&](int j) {
    return model.stiffness.diagonal().segment<3>(6 * j).sum() / model.mass.diagonal().segment<3>(6 * j).sum();
  };
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    const bool before = first[static_cast<std::size_t>(a)], behind = first[static_cast<std::size_t>(b)];
    return before != behind ? before : ratio(a) < ratio(b);
  });
  order.resize(static_cast<std::size_t>(share * static_cast<double>(order.size())));
  return order;
}

// Deflection of the node `at` under a force there, with the node `held` held: rigid motion and modes of least energy.
Vector3d deflection_of(const ModalBody& body, int at, int held, const Vector3d& force) {
  const Index s = body.mode_count();
  const auto motion = [&](int node) {
    MatrixXd J(6, s + 6);
    J << body.Phi.middleRows(3 * node, 3), MatrixXd::Identity(3, 3), -skew(body.rho0.col(node)),
        body.Psi.middleRows(3 * node, 3), MatrixXd::Zero(3, 3), MatrixXd::Identity(3, 3);
    return J;
  };
  const MatrixXd J_at = motion(at), J_held = motion(held);
  MatrixXd A = MatrixXd::Zero(s + 12, s + 12);
  A.topLeftCorner(s, s) = body.stiffness.asDiagonal();
  A.topRightCorner(s + 6, 6) = J_held.transpose();
  A.bottomLeftCorner(6, s + 6) = J_held;
  VectorXd b = VectorXd::Zero(s + 12);
  b.head(s + 6) = J_at.topRows(3).transpose() * force;
  const VectorXd x = A.fullPivLu().solve(b);
  return J_at.topRows(3) * x.head(s + 6);
}

// First ten frequencies of the free body, deflection of the loaded end in the mean, mass, centre and inertia, as CalculiX
// prints them (seven digits) for consistent and lumped masses, and within 0.1 % of the consistent ones after Guyan's reduction,
// which is exact for a load on nodes that it keeps.
TEST(CalculixModels, AreTheSameBodyConsistentLumpedAndReducedByGuyan) {
  const std::tuple<Sample, const char*, double> samples[] = {
      {{"bar20", "ROOT", UnitSystem::kMetre, 1.0}, "TIP", 0.75},
      {{"plate20", "ROOT", UnitSystem::kMetre, 1.0}, "TIP", 0.75},
      {kSamples[2], "HOLE", 0.9},
      {kSamples[3], "TIP", 0.9}};
  const Files files;
  for (const auto& [sample, tip, share] : samples)
    for (const Form form : {Form::kConsistent, Form::kLumped, Form::kGuyan}) {
      const std::string who = sample.name + std::to_string(static_cast<int>(form));
      const Results results = results_of(sample.name);
      const std::string prefix = form == Form::kLumped ? "lumped_" : "";
      MatrixFiles f = files_of(sample, form == Form::kLumped);
      const FeMesh mesh = mesh_of(f.nodes);
      if (form == Form::kGuyan) {
        f.units = UnitSystem::kMetre;  // the numbers of the files as they are
        const FeModel full = read_matrix_model(f);
        const Condensed guyan = condensed(full, kept_nodes(full, mesh, {sample.root, tip}, share));
        f.stiffness = files.add(who + ".sti", triangle_text(guyan.K));
        f.mass = files.add(who + ".mas", triangle_text(guyan.M));
        f.rows = files.add(who + ".dof", dof_list(guyan, mesh));
        f.units = sample.units;
      }
      const VectorXd found = frequencies(reduce(read_matrix_model(f), free_modes(10), who).body);
      EXPECT_LT(largest_difference(found, results.frequencies.at(prefix + "free")),
                form == Form::kGuyan ? 1e-3 : kPrinted)
          << who;

      f.interfaces = {{sample.root, SpiderKind::kRigid, {}}, {tip, SpiderKind::kAveraged, {}}};
      const FeModel model = read_matrix_model(f);
      BasisOptions options;
      options.interface_nodes = {0, 1};  // the tip, added last, and the root
      options.mode_count = 4;
      const ReducedBody reduced = reduce(model, options, who);
      Vector3d mean = Vector3d::Zero();
      for (const auto& entry : results.deflections)
        mean += sample.length * entry.second / static_cast<double>(results.deflections.size());
      const Vector3d force(0.0, 0.0, -10.0 * static_cast<double>(results.deflections.size()));
      EXPECT_LT((deflection_of(reduced.body, 0, 1, force) - mean).norm(), 1e-3 * mean.norm()) << who;

      const double density_unit = mass_unit(sample.units), area = sample.length * sample.length;
      const VectorXd& printed = results.frequencies.at(prefix + "inertia");
      const MassProperties moved = mass_properties(model);
      EXPECT_NEAR(moved.mass, density_unit * printed(0), 1e-6 * moved.mass) << who;
      EXPECT_LT((moved.centre - sample.length * printed.segment<3>(1)).norm(), 1e-6 * extent(reduced.body)) << who;
      Eigen::Matrix3d S;
      S << printed(4), printed(7), printed(8), printed(7), printed(5), printed(9), printed(8), printed(9), printed(6);
      S *= density_unit * area;
      const Eigen::Matrix3d inertia = S.trace() * Eigen::Matrix3d::Identity() - S;
      EXPECT_LT((moved.inertia - inertia).norm(), 1e-6 * inertia.norm()) << who;
    }
}

// Corners of every second cross section of the bar, and of its ends. Reduced statically to them the bar keeps mass, centre
// and inertia; frequencies rise with the square of those that are left out.
TEST(ReducedModels, OfGuyanAreTakenAsTheyAreInEveryFormat) {
  const FeModel full = read_matrix_model(files_of(kSamples[0]));
  const FeMesh mesh = mesh_of(data("bar.inp"));
  std::vector<int> kept;
  for (int node = 0; node < 36; ++node)
    if (node % 9 % 2 == 0) kept.push_back(node);
  const Condensed guyan = condensed(full, kept);
  std::vector<long> ids;
  for (const int node : guyan.nodes) ids.push_back(mesh.ids[static_cast<std::size_t>(node)]);
  const VectorXd exact = symmetric_modes(guyan.K, guyan.M).values.segment(6, 10).cwiseSqrt() / (2.0 * M_PI);
  const MassProperties whole = mass_properties(full);

  const Files files;
  const std::string dof = files.add("bar.dof", dof_list(guyan, mesh)), nodes = data("bar.inp");
  const std::string sti = files.add("bar.sti", triangle_text(guyan.K)),
                    mas = files.add("bar.mas", triangle_text(guyan.M));
  const std::string k_mtx = files.add("k.mtx", abaqus_text(guyan.K, ids)),
                    m_mtx = files.add("m.mtx", abaqus_text(guyan.M, ids));
  const std::string pch = files.add("bar.pch", dmig_text("KAAX", guyan.K, ids) + dmig_text("MAAX", guyan.M, ids));
  const std::string sub = files.add("sub.mtx", substructure_text(guyan.K, guyan.M, ids));
  const auto in = [&](const std::string& stiffness, const std::string& mass) {
    MatrixFiles f;
    f.stiffness = stiffness;
    f.mass = mass;
    f.nodes = nodes;
    return f;
  };
  // Printed digits of the stiffest against the softest motion: 1e5 times the last one.
  for (const auto& [f, off] :
       {std::pair{in(sti, mas), 1e-9}, {in(k_mtx, m_mtx), 1e-9}, {in(sub, sub), 1e-9}, {in(pch, pch), 1e-4}}) {
    const FeModel model = read_matrix_model(f);
    EXPECT_EQ(model.node_count(), static_cast<int>(kept.size()));
    EXPECT_GT(model.mass.size(), 0) << "nothing is lumped";
    const MassProperties body = mass_properties(model);
    EXPECT_NEAR(body.mass, whole.mass, 1e-8 * whole.mass) << f.stiffness;
    EXPECT_LT((body.centre - whole.centre).norm(), 1e-8) << f.stiffness;
    EXPECT_LT((body.inertia - whole.inertia).norm(), 1e-6 * whole.inertia.norm()) << f.stiffness;
    const ReducedBody reduced = reduce(model, free_modes(10), "bar");
    EXPECT_LT(largest_difference(frequencies(reduced.body), exact), off) << f.stiffness;
  }
}

// *SUBSTRUCTURE GENERATE of CalculiX 2.20 writes the rows of the retained nodes as they are, with all others held (thirteen
// digits): no free body, which is told.
TEST(ReducedModels, OfCalculixAreReadAndRefusedAsTheyAreHeld) {
  const FeModel full = read_matrix_model(files_of(kSamples[0]));
  const FeMesh mesh = mesh_of(data("bar.inp"));
  std::vector<int> kept, rows;
  for (int corner = 0; corner < 4; ++corner)
    for (const int layer : {0, 4, 8}) kept.push_back(9 * corner + layer);
  std::sort(kept.begin(), kept.end());
  for (const int node : kept)
    for (int i = 0; i < 3; ++i) rows.push_back(6 * node + i);
  const Condensed guyan = condensed(full, kept);
  const Files files;
  MatrixFiles f;
  f.stiffness = data("bar.mtx");
  f.mass = files.add("bar.mas", triangle_text(guyan.M));
  f.rows = files.add("bar.dof", dof_list(guyan, mesh));
  f.nodes = data("bar.inp");
  const FeModel model = read_matrix_model(f);
  const MatrixXd expected = MatrixXd(selected(full.stiffness, rows, rows));
  MatrixXd K(36, 36);
  for (Index i = 0; i < 36; ++i)
    for (Index j = 0; j < 36; ++j) K(i, j) = model.stiffness.coeff(6 * (i / 3) + i % 3, 6 * (j / 3) + j % 3);
  EXPECT_LT((K - expected).norm(), 1e-11 * K.norm());
  EXPECT_TRUE(names(refusal([&] { reduce(model, free_modes(3), "bar"); }), {"E0321"}));
}

// --- Craig and Bampton: rows of modal coordinates, which have no place.

// The leg on the displacements of its root and tip, and fixed-interface modes: its frequencies nearly equal the frequencies of the whole,
// and mass, centre and inertia exactly.
TEST(ReducedModels, OfCraigAndBamptonHaveCoordinatesWithoutPlace) {
  const FeModel full = read_matrix_model(files_of(kSamples[3]));
  const FeMesh mesh = mesh_of(data("leg.inp"));
  std::vector<int> kept = mesh.set("ROOT", "leg");
  for (const int node : mesh.set("TIP", "leg")) kept.push_back(node);
  std::sort(kept.begin(), kept.end());
  std::vector<int> dofs;
  for (const int node : kept)
    for (int i = 0; i < 3; ++i) dofs.push_back(6 * node + i);
  const std::vector<int> inner = other_dofs(active_dofs(full), dofs);
  const MatrixXd K_ii = MatrixXd(selected(full.stiffness, inner, inner)),
                 M_ii = MatrixXd(selected(mass_matrix(full), inner, inner));
  const int modes = 12;
  const auto fixed = symmetric_modes(K_ii, M_ii);
  const Index b = static_cast<Index>(dofs.size()), size = b + modes;
  MatrixXd G = MatrixXd::Zero(full.stiffness.rows(), size);
  G.leftCols(b) = scattered(-solve(K_ii, MatrixXd(selected(full.stiffness, inner, dofs))), inner, G.rows()) +
                  scattered(MatrixXd::Identity(b, b), dofs, G.rows());
  G.rightCols(modes) = scattered(fixed.vectors.leftCols(modes), inner, G.rows());
  const MatrixXd K = G.transpose() * (full.stiffness * G), M = G.transpose() * (mass_matrix(full) * G);
  std::string rows;
  for (const int node : kept)
    for (int i = 1; i <= 3; ++i)
      rows += std::to_string(mesh.ids[static_cast<std::size_t>(node)]) + "." + std::to_string(i) + "\n";
  for (int k = 0; k < modes; ++k) rows += std::to_string(900001 + k) + ".1\n";
  const Files files;
  MatrixFiles f;
  f.stiffness = files.add("leg.sti", triangle_text(0.5 * (K + K.transpose())));
  f.mass = files.add("leg.mas", triangle_text(0.5 * (M + M.transpose())));
  f.rows = files.add("rows.dof", rows);
  f.nodes = data("leg.inp");
  const FeModel model = read_matrix_model(f);
  EXPECT_EQ(model.extra, modes);
  const MassProperties body = mass_properties(model), whole = mass_properties(full);
  EXPECT_NEAR(body.mass, whole.mass, 1e-9 * whole.mass);
  EXPECT_LT((body.centre - whole.centre).norm(), 1e-9);
  EXPECT_LT((body.inertia - whole.inertia).norm(), 1e-9 * whole.inertia.norm());
  const ReducedBody reduced = reduce(model, free_modes(10), "leg");
  const VectorXd free = results_of("leg").frequencies.at("free");
  EXPECT_LT(largest_difference(frequencies(reduced.body).head(6), free.head(6)), 1e-3)
      << "twelve modes hold the first six";
  // The body that moves: the modal coordinates have their kinetic energy.
  MatrixXd mass(16, 16), expected = MatrixXd::Identity(16, 16);
  ModalInertia(reduced.body).mass_matrix(VectorXd::Zero(10), mass);
  expected.topLeftCorner<3, 3>() *= whole.mass;
  expected.block<3, 3>(3, 3) = whole.inertia;
  EXPECT_LT((mass - expected).norm(), 1e-6);
}

// --- Sets of nodes at which joints act.

// Root and tip of the leg as rigid sets. Held at the node of its root, the leg has the frequencies of CalculiX with that set
// held (its rotations do not move either way).
TEST(Interfaces, ThatAreRigidHoldAsTheirSetDoes) {
  MatrixFiles files = files_of(kSamples[3]);
  files.interfaces = {{"root", SpiderKind::kRigid, {}}};  // whatever the case of its letters
  const FeModel model = read_matrix_model(files);
  ASSERT_EQ(model.spiders.size(), 1u);
  EXPECT_LT(model.nodes.col(0).norm(), 1e-12) << "in the mean of the set";
  const FeModel independent = constrained(model).model;
  const VectorXd held = test::natural_frequencies(independent, test::node_dofs(0), 10);
  EXPECT_LT(largest_difference(held, results_of("leg").frequencies.at("held")), kPrinted);
  // In a reduced body, every node of the set moves with it.
  BasisOptions options = free_modes(6);
  options.kind = BasisKind::kCraigBampton;
  options.interface_nodes = {0};
  const ReducedBody reduced = reduce(model, options, "leg");
  const ModalBody& body = reduced.body;
  for (const int node : model.spiders[0].nodes)
    for (int k = 0; k < body.mode_count(); ++k) {
      const Vector3d u = body.Phi.block<3, 1>(0, k), t = body.Psi.block<3, 1>(0, k);
      const Vector3d arm = body.rho0.col(node) - body.rho0.col(0);
      EXPECT_LT((body.Phi.block<3, 1>(3 * node, k) - u - t.cross(arm)).norm(), 1e-9 * body.Phi.norm());
      EXPECT_LT((body.Psi.block<3, 1>(3 * node, k) - t).norm(), 1e-9 * body.Psi.norm());
    }
  const MassProperties whole = mass_properties(read_matrix_model(files_of(kSamples[3])));
  const Body moving("leg", std::make_shared<const ModalBody>(body));
  EXPECT_LT((moving.rigid_inertia() - whole.inertia).norm(), 1e-9 * whole.inertia.norm());
  // A joint in the middle of the set finds it, and one elsewhere finds no rotation.
  EXPECT_EQ(joint_node(model, {0, 0, 0}, 1.0, true), 0);
  EXPECT_THROW(joint_node(model, {0.7, 0, 0}, 1.0, true), InputError);
}

// A load at an averaged set spreads over its nodes: the set's deflection is that under the same forces at its nodes, and its
// node moves by their mean. CalculiX' deflections under 10 N at each node.
TEST(Interfaces, ThatAreAveragedSpreadTheirLoad) {
  for (const std::size_t which : {std::size_t{0}, std::size_t{3}}) {  // all nodes of a set have the same share
    const Sample& sample = kSamples[which];
    MatrixFiles files = files_of(sample);
    files.interfaces = {{"TIP", SpiderKind::kAveraged, {}}};
    const FeModel model = read_matrix_model(files);
    const Results results = results_of(sample.name);
    const FeMesh mesh = mesh_of(files.nodes);
    const Constrained independent = constrained(model);
    std::vector<int> held = held_dofs(mesh, sample.root);
    for (int& dof : held) dof += 6;  // the node of the set is the first
    VectorXd load = VectorXd::Zero(model.stiffness.rows());
    load(2) = -10.0 * static_cast<double>(results.deflections.size());
    const VectorXd found = independent.T * static_solution(independent.model, held, load);
    Vector3d mean = Vector3d::Zero();
    for (const auto& [id, u] : results.deflections) {
      EXPECT_LT((found.segment<3>(6 * mesh.index.at(id) + 6) - u).norm(), 1e-5 * u.norm()) << sample.name << id;
      mean += u / static_cast<double>(results.deflections.size());
    }
    EXPECT_LT((found.head<3>() - mean).norm(), 1e-5 * mean.norm()) << sample.name;
  }
}

// Several of them: each is the mean of its own set, and the leg between both deflects as CalculiX finds.
TEST(Interfaces, MayBeSeveral) {
  MatrixFiles files = files_of(kSamples[3]);
  files.interfaces = {{"ROOT", SpiderKind::kRigid, {}}, {"TIP", SpiderKind::kAveraged, {}}};
  const FeModel model = read_matrix_model(files);
  ASSERT_EQ(model.spiders.size(), 2u);
  for (const Spider& spider : model.spiders) {
    Vector3d mean = Vector3d::Zero();
    for (const int j : spider.nodes) mean += model.nodes.col(j) / static_cast<double>(spider.nodes.size());
    EXPECT_LT((model.nodes.col(spider.node) - mean).norm(), 1e-12);
  }
  const int root = joint_node(model, {0, 0, 0}, 1.0, true), tip = joint_node(model, {1.05, 0, 0}, 1.0, true);
  const Results results = results_of("leg");
  Vector3d mean = Vector3d::Zero();
  for (const auto& [id, u] : results.deflections) mean += u / static_cast<double>(results.deflections.size());
  const Constrained independent = constrained(model);
  VectorXd load = VectorXd::Zero(model.stiffness.rows());
  load(6 * tip + 2) = -10.0 * static_cast<double>(results.deflections.size());
  const VectorXd found = static_solution(independent.model, test::node_dofs(root), load);
  EXPECT_LT((found.segment<3>(6 * tip) - mean).norm(), 1e-5 * mean.norm());
}

// A joint at the point of a set holds the set, where a node of the mesh is at this point, too, to the digits of the scene.
TEST(Interfaces, HoldAJointAtANodeOfTheMesh) {
  MatrixFiles files = files_of(kSamples[3]);
  const FeMesh mesh = mesh_of(files.nodes);
  const Vector3d node = mesh.points[static_cast<std::size_t>(mesh.set("TIP", files.nodes).front())];
  for (const SpiderKind kind : {SpiderKind::kRigid, SpiderKind::kAveraged}) {
    files.interfaces = {{"TIP", kind, Vector3d(node + Vector3d(1e-8, 0, 0))}};
    const FeModel model = read_matrix_model(files);
    EXPECT_EQ(joint_node(model, node, 1.0, true), model.spiders[0].node);
    const ReducedBody reduced = reduce(model, free_modes(6), "leg");
    EXPECT_EQ(joint_node(reduced.body, node - reduced.p_DBo, 1.0, true), model.spiders[0].node);
  }
}

// kg/mm3 instead of t/mm3 makes a thousandfold mass, lb/in3 instead of lbf s2/in4 386 times the mass.
TEST(Units, OfDensitiesThatNoSolidHasAreWarnedOf) {
  const FeModel model = read_matrix_model(files_of(kSamples[2]));
  EXPECT_TRUE(reduce(model, free_modes(6), "bracket").warnings.empty());
  for (const double factor : {1000.0, 386.0886}) {
    const FeModel heavy = with_mass(model, factor * mass_properties(model).mass);
    const std::vector<std::string> warnings = reduce(heavy, free_modes(6), "bracket").warnings;
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_TRUE(names(warnings[0], {"bracket", "more than any solid", "t/mm3", "lbf s2/in4"}));
  }
}

TEST(Interfaces, ThatCannotBeAreRefused) {
  const auto with = [](std::vector<InterfaceSpec> interfaces) {
    MatrixFiles files = files_of(kSamples[0]);
    files.interfaces = std::move(interfaces);
    return refusal([&] { read_matrix_model(files); });
  };
  EXPECT_EQ(with({{"ROOT", SpiderKind::kRigid, {}}, {"TIP", SpiderKind::kAveraged, {}}}), "");
  EXPECT_TRUE(names(with({{"ROT", SpiderKind::kRigid, {}}}), {"E0328", "ROT", "ROOT"}));
  EXPECT_TRUE(names(with({{"ALL", SpiderKind::kRigid, {}}, {"TIP", SpiderKind::kRigid, {}}}), {"E0321"}));
  FeModel model = read_matrix_model(files_of(kSamples[0]));
  EXPECT_THROW(add_spider(model, {0, 1, 2}, SpiderKind::kAveraged, nullptr, "line"), InputError);
}

// --- Stress of the other code.

// The modes of the free bar with their stresses at the nodes: a mode that is among them has its stress.
TEST(StressFile, GivesAModeTheStressThatCalculixFinds) {
  MatrixFiles files = files_of(kSamples[0]);
  files.stress = data("bar.frd");
  const FeModel model = read_matrix_model(files);
  const ReducedBody reduced = reduce(model, free_modes(6), "bar");
  ASSERT_EQ(reduced.body.stress_modes.rows(), 6 * model.node_count());
  EXPECT_TRUE(reduced.warnings.empty());
  const FrdModes modes = parse_frd_modes(bytes_of_model(files.stress), files.stress, mesh_of(files.nodes));
  ASSERT_EQ(modes.stresses.size(), 16u);
  // Pairs of bending modes may be turned in their plane: the sum over the pair is compared, which is the same for any.
  for (const int pair : {0, 2, 4}) {
    const auto k = static_cast<std::size_t>(6 + pair);
    const MatrixXd first = modes.stresses[k], second = modes.stresses[k + 1];
    double expected = 0.0, found = 0.0;
    for (Index j = 0; j < model.node_count(); ++j) {
      expected = std::max(expected, first.col(j).squaredNorm() + second.col(j).squaredNorm());
      found = std::max(found, reduced.body.stress_modes.block<6, 1>(6 * j, pair).squaredNorm() +
                                  reduced.body.stress_modes.block<6, 1>(6 * j, pair + 1).squaredNorm());
    }
    EXPECT_NEAR(found, expected, 1e-4 * expected) << "six digits of the file, " << pair;
  }
  // Cells show the largest of their nodes.
  const VectorXd a = VectorXd::Unit(6, 0), points = von_mises_of_points(reduced.body, a),
                 cells = von_mises_of_cells(reduced.body, a);
  ASSERT_EQ(cells.size(), static_cast<Index>(reduced.body.triangles.size()));
  EXPECT_EQ(cells.maxCoeff(), points.maxCoeff());
  // Static shapes of an attachment are not all within these modes: a word.
  BasisOptions held;
  held.pinned_nodes = {0, 8, 27, 35};
  held.mode_count = 2;
  const ReducedBody with_statics = reduce(model, held, "bar");
  ASSERT_EQ(with_statics.warnings.size(), 1u);
  EXPECT_TRUE(names(with_statics.warnings[0], {"W1322"}));
}

// --- Meshes.

TEST(FeMeshes, OfGmshAreReadAsTextAndBinary) {
  const FeMesh text = mesh_of(data("bracket2.msh")), binary = mesh_of(data("bracket4.msh")),
               first_4 = mesh_of(data("bracket40.msh")), inp = mesh_of(data("bracket.inp"));
  for (const FeMesh* mesh : {&text, &binary, &first_4, &inp}) {
    EXPECT_EQ(mesh->ids.size(), inp.ids.size());
    TriangleMesh skin;
    skin.vertices = mesh->points;
    skin.triangles = skin_of(*mesh);
    MeshDemands demands;
    demands.closed = demands.connected = demands.oriented = true;
    EXPECT_TRUE(mesh_findings(skin, demands).empty());
    const MassProperties solid = polyhedron_properties(skin, 1.0, "bracket");
    EXPECT_NEAR(solid.mass, 39904.0, 100.0)
        << "mm3: 80 x 40 x 8 + 52 x 40 x 8 less a coarse hole of 20 mm through 8 mm";
    EXPECT_EQ(mesh->set("TOP", "").size(), inp.set("TOP", "").size());
    EXPECT_EQ(mesh->set("hole", "").size(), inp.set("HOLE", "").size());
  }
}

// Version 4.0 as bytes, which gmsh itself no longer writes: a tetrahedron, its corner 7 a group.
TEST(FeMeshes, OfGmsh40AreReadAsBinary) {
  std::string bytes = "$MeshFormat\n4 1 8\n";
  const auto add = [&](auto... numbers) {
    const auto one = [&](auto x) { bytes.append(reinterpret_cast<const char*>(&x), sizeof x); };
    (one(numbers), ...);
  };
  add(1);
  bytes += "\n$EndMeshFormat\n$PhysicalNames\n1\n0 3 \"foot\"\n$EndPhysicalNames\n$Entities\n";
  add(1L, 0L, 0L, 1L);
  add(4, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1L, 3);
  add(1, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0L, 0L);
  bytes += "\n$EndEntities\n$Nodes\n";
  add(2L, 4L);
  add(4, 0, 0, 1L, 7, 0.0, 0.0, 0.0);
  add(1, 3, 0, 3L, 8, 1.0, 0.0, 0.0, 9, 0.0, 1.0, 0.0, 10, 0.0, 0.0, 1.0);
  bytes += "\n$EndNodes\n$Elements\n";
  add(2L, 2L);
  add(4, 0, 15, 1L, 1, 7);
  add(1, 3, 4, 1L, 2, 7, 8, 9, 10);
  bytes += "\n$EndElements\n";
  const FeMesh mesh = parse_fe_mesh(bytes, "a.msh");
  EXPECT_EQ(mesh.ids, (std::vector<long>{7, 8, 9, 10}));
  EXPECT_EQ(mesh.points[3], Vector3d(0, 0, 1));
  EXPECT_EQ(mesh.set("foot", ""), std::vector<int>{0});
  EXPECT_EQ(skin_of(mesh).size(), 4u);
}

// One solid of each kind with nodes on its edges, in the order of each code: its skin is closed, and its volume equals the volume of the
// corners, as the edges are straight.
TEST(FeMeshes, HaveClosedSkinsOfQuadraticSolids) {
  const std::map<int, std::vector<Vector3d>> corners = {
      {4, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
      {5, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}}},
      {6, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}},
      {8, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}}};
  const std::map<int, double> volumes = {{4, 1.0 / 6}, {5, 1.0 / 3}, {6, 0.5}, {8, 1.0}};
  using EdgeList = std::vector<std::array<int, 2>>;
  struct Kind {
    const char* end;
    const char* name;
    int corners;
    EdgeList edges;
  };
  const Kind kinds[] = {
      {".inp", "C3D10", 4, {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}},
      {".inp", "C3D15", 6, {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}},
      {".inp",
       "C3D20R",
       8,
       {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}},
      {".bdf", "CTETRA", 4, {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}},
      {".bdf", "CPENTA", 6, {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 4}, {2, 5}, {3, 4}, {4, 5}, {5, 3}}},
      {".bdf", "CPYRAM", 5, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}}},
      {".bdf",
       "CHEXA",
       8,
       {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 5}, {2, 6}, {3, 7}, {4, 5}, {5, 6}, {6, 7}, {7, 4}}},
      {".msh", "11", 4, {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {2, 3}, {1, 3}}},
      {".msh", "18", 6, {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 4}, {2, 5}, {3, 4}, {3, 5}, {4, 5}}},
      {".msh", "19", 5, {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 4}, {2, 3}, {2, 4}, {3, 4}}},
      {".msh",
       "17",
       8,
       {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 5}, {2, 3}, {2, 6}, {3, 7}, {4, 5}, {4, 7}, {5, 6}, {6, 7}}},
  };
  for (const Kind& kind : kinds) {
    std::vector<Vector3d> x = corners.at(kind.corners);
    for (const auto& edge : kind.edges)
      x.push_back(0.5 * (x[static_cast<std::size_t>(edge[0])] + x[static_cast<std::size_t>(edge[1])]));
    std::ostringstream text;
    const std::string end = kind.end;
    if (end == ".inp") {
      text << "*NODE\n";
      for (std::size_t j = 0; j < x.size(); ++j)
        text << j + 1 << "," << x[j].x() << "," << x[j].y() << "," << x[j].z() << "\n";
      text << "*ELEMENT, TYPE=" << kind.name << ", ELSET=E\n1";
      for (std::size_t j = 0; j < x.size(); ++j) text << "," << (j == 10 ? "\n" : "") << j + 1;
    } else if (end == ".bdf") {
      for (std::size_t j = 0; j < x.size(); ++j)
        text << "GRID," << j + 1 << ",," << x[j].x() << "," << x[j].y() << "," << x[j].z() << "\n";
      text << kind.name << ",1,1";
      for (std::size_t j = 0; j < x.size(); ++j) text << (j == 6 || j == 14 ? ",+\n+" : "") << "," << j + 1;
    } else {
      text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << x.size() << "\n";
      for (std::size_t j = 0; j < x.size(); ++j) text << j + 1 << " " << x[j].transpose() << "\n";
      text << "$EndNodes\n$Elements\n1\n1 " << kind.name << " 2 0 0";
      for (std::size_t j = 0; j < x.size(); ++j) text << " " << j + 1;
      text << "\n$EndElements";
    }
    text << "\n";
    const FeMesh mesh = parse_fe_mesh(text.str(), std::string("solid") + kind.end);
    TriangleMesh skin;
    skin.vertices = mesh.points;
    skin.triangles = skin_of(mesh);
    MeshDemands demands;
    demands.closed = demands.connected = demands.oriented = true;
    const auto findings = mesh_findings(skin, demands);
    EXPECT_TRUE(findings.empty()) << kind.end << kind.name << ": " << (findings.empty() ? "" : findings[0]);
    EXPECT_NEAR(polyhedron_properties(skin, 1.0, kind.name).mass, volumes.at(kind.corners), 1e-12)
        << kind.end << kind.name;
  }
}

TEST(FeMeshes, HaveSetsByName) {
  const FeMesh inp = parse_fe_mesh(
      "** a comment\n*Node, nset=Nall\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n 4, 0, 0,1\n*ELEMENT, TYPE=C3D4, ELSET=E\n"
      "7, 1,2,\n3,4\n*NSET, NSET=Odd, GENERATE\n1, 4, 2\n*NSET,NSET=both\nodd, 4\n*ELSET, ELSET=again\n7\n*STEP\n",
      "a.inp");
  EXPECT_EQ(inp.set("ODD", "").size(), 2u);
  EXPECT_EQ(inp.set("both", "").size(), 3u);
  EXPECT_EQ(inp.set("again", "").size(), 4u);
  EXPECT_EQ(inp.set("Nall", "").size(), 4u);
  const FeMesh bdf = parse_fe_mesh(
      "$ a comment\nBEGIN BULK\nGRID*                  1                              0.             0.\n*             "
      "        0.\n"
      "GRID    2               1.      0.      0.\nGRID    3               0.      1.0+0   0.\nGRID,4,,0.,0.,1.-0\n"
      "CTETRA  1       1       1       2       3       4\nSET1    5       1       THRU    3\nENDDATA\n",
      "a.bdf");
  EXPECT_EQ(bdf.set("5", "").size(), 3u);
  // Abaqus: a set continues under its name in other letters, and a set of nodes is not widened by a set of elements of the same name.
  const FeMesh twice = parse_fe_mesh(
      "*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n*ELEMENT,TYPE=C3D4,ELSET=Eall\n7,1,2,3,4\n*NSET,NSET=Foot\n1\n"
      "*Nset, nset=FOOT\n2\n*Elset, elset=Foot\n7\n*NSET, NSET=all, ELSET=EALL\n",
      "a.inp");
  EXPECT_EQ(twice.set("FOOT", ""), (std::vector<int>{0, 1}));
  EXPECT_EQ(twice.set("ALL", "").size(), 4u);
  // Nastran: sets of the case control, and SET3.
  const FeMesh control = parse_fe_mesh(
      "SOL 103\nCEND\n  SET 7 = 1 THRU 4 EXCEPT 2,\n   3\nSET 8 = 4,2\nset 9 = 0.5, 1.5\nBEGIN BULK\nGRID,1,,0.,0.,0.\n"
      "GRID,2,,1.,0.,0.\nGRID,3,,0.,1.,0.\nGRID,4,,0.,0.,1.\nSET3,10,GRID,3,THRU,4\nSET3,11,ELEM,3\nENDDATA\n",
      "a.bdf");
  EXPECT_EQ(control.set("7", ""), (std::vector<int>{0, 3}));
  EXPECT_EQ(control.set("8", ""), (std::vector<int>{3, 1}));
  EXPECT_EQ(control.set("10", ""), (std::vector<int>{2, 3}));
  EXPECT_EQ(control.sets.size(), 3u);
  const Files files;
  files.add("grids.bdf", "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\n");
  const std::string self = files.add("self.inp", "*INCLUDE,INPUT=./self.inp\n"),
                    other = files.add("self.bdf", "INCLUDE 'self.bdf'\n");
  EXPECT_TRUE(names(refusal([&] { mesh_of(self); }), {"self.inp:1: ", "E0328"}));
  EXPECT_TRUE(names(refusal([&] { mesh_of(other); }), {"self.bdf:1: ", "E0328"}));
  EXPECT_EQ(mesh_of(files.add("whole.bdf", "  INCLUDE 'grids.bdf'\nGRID,3,,0.,1.,0.\n")).ids.size(), 3u);
  EXPECT_EQ(skin_of(bdf).size(), 4u);
  EXPECT_EQ(bdf.points[2], Vector3d(0, 1, 0));
}

struct BadFile {
  const char* name;
  const char* text;
  int line;  // 0: of the whole file
};

TEST(FeMeshes, NameFileAndLineOfWhatIsWrong) {
  const BadFile bad[] = {
      {"a.inp", "*NODE\n1,0,0,0\n1,0,0,1\n", 3},
      {"a.inp", "*NODE\n1,0,zero,0\n", 2},
      {"a.inp", "*NODE\n1,0,nan,0\n", 2},
      {"a.inp", "*NODE\n1,0,0,0\n*ELEMENT,TYPE=C3D4\n1,1,2,3,4\n", 4},
      {"a.inp", "*NODE\n1,0,0,0\n*ELEMENT,TYPE=C3D4\n1,1,1\n", 4},
      {"a.inp", "*NODE\n1,0,0,0\n*ELEMENT\n1,1\n", 3},
      {"a.inp", "*NODE\n1,0,0,0\n*INCLUDE,INPUT=not_there.inp\n", 3},
      {"a.inp", "*NODE\n1,0,0,0\n*NSET,NSET=A\nunknown\n", 4},
      {"a.inp", "*NODE\n1,0,0,0\n*INSTANCE,NAME=a,PART=b\n1,0,0\n", 4},
      {"a.inp", "*NODE\n1,0,0,0\n*NSET,NSET=A\n1,2\n", 4},
      {"a.inp", "*NODE\n1,0,0,0\n*NSET,NSET=A,ELSET=E\n", 3},
      {"a.inp", "*HEADING\nnothing\n", 0},
      {"a.msh", "solid\n", 1},
      {"a.msh", "$MeshFormat\n1.0 0 8\n$EndMeshFormat\n", 2},
      {"a.msh", "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 9 1 9\n0 1 0 9\n", 6},
      {"a.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 zero\n", 6},
      {"a.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n1 31 2 0 0 1\n",
       10},
      {"a.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n", 7},
      {"a.bdf", "GRID,1,,0.,0.,0.\nGRID,2,,0.,x,0.\nGRID,3,,0.,0.,0.\n", 2},
      {"a.bdf", "GRID,1,3,0.,0.,0.\n", 1},
      {"a.bdf", "GRID,1,,0.,0.,0.\nINCLUDE\n", 2},
      {"a.bdf", "GRID,1,,0.,0.,0.\nSET1,1,THRU,5\n", 2},
      {"a.bdf", "GRID,1,,0.,0.,0.\nCTRIA3,1,1,1,1,2\n", 2},
      {"a.frd",
       "    2C                             1                                     1\n -1         1 0.00000E+00 "
       "0.00000E+00\n",
       2},
      {"a.frd",
       "    2C                             1                                     1\n"
       " -1         11.00000E-003-2.00000E+0000.00000E+000\n",
       2},
      {"a.nodes", "0 0 0\n0 0\n", 2},
      {"a.nodes", "# nothing\n", 0},
  };
  for (const BadFile& file : bad) {
    const std::string message = refusal([&] { parse_fe_mesh(file.text, file.name); });
    const std::string where = file.line > 0 ? std::string(file.name) + ":" + std::to_string(file.line) + ": " : "";
    EXPECT_EQ(message.rfind(where, 0), 0u) << file.text << message;
    EXPECT_TRUE(names(message, {"E0328"})) << file.text;
  }
}

TEST(FeMeshes, NameTheExponentsOfWindows) {
  const auto of = [](const std::string& node) {
    return refusal([&] {
      parse_fe_mesh("    2C                             1                                     1\n -1         1" + node +
                        "\n -3\n",
                    "a.frd");
    });
  };
  EXPECT_TRUE(names(of("1.00000E-003-2.00000E+0000.00000E+000"), {"a.frd:2", "E-003", "Windows", "E0328"}));
  EXPECT_EQ(of("1.000000E-032.000000E-030.000000E+00"), "");  // of twelve characters each
}

TEST(ForeignMatrices, NameFileAndLineOfWhatIsWrong) {
  const Files files;
  const std::string nodes = files.add("n.inp", "*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n");
  const BadFile bad[] = {
      {"k.sti", "1 1 1.0\n1 2\n", 2},
      {"k.sti", "1 1 one\n", 1},
      {"k.mtx", "1,1, 1,1, 1.0\n1,1, 2\n", 2},
      {"k.mtx", "*USER ELEMENT,NODES=1\n** ELEMENT NODES\n** 1,\n1,2,3\n*MATRIX,TYPE=STIFFNESS\n1.,\n0., 1.,\n", 7},
      {"k.mtx", "*USER ELEMENT,NODES=1\n** ELEMENT NODES\n** 1,\n1\n,,\n*MATRIX,TYPE=DAMPING\n1.,\n", 0},
      {"k.pch", "DMIG    KAAX           0       6       4       0\n", 1},
      {"k.pch", "DMIG    BAAX           0       6       2       0\n", 0},
      {"k.pch",
       "DMIG    KAAX           0       6       2       0\nDMIG*   KAAX                           1               1\n*  "
       "                    1               1\n",
       3},
      {"k.mtx", "some text\n", 1},
      {"k.mtx", "", 0},
  };
  for (const BadFile& file : bad) {
    MatrixFiles f;
    f.stiffness = f.mass = files.add(file.name, file.text);
    f.nodes = nodes;
    const std::string message = refusal([&] { read_matrix_model(f); });
    const std::string where = f.stiffness + (file.line > 0 ? ":" + std::to_string(file.line) + ": " : "");
    if (std::string(file.name) != "k.sti") {
      EXPECT_EQ(message.rfind(where, 0), 0u) << file.text << message;
    }
    EXPECT_TRUE(names(message, {"E0328"})) << file.text;
  }
  // Rows of supports left out: the body is not free.
  const FeModel bar = read_matrix_model(files_of(kSamples[0]));
  MatrixFiles f = files_of(kSamples[0]);
  f.rows = files.add("short.dof", "1.1\n1.2\n");
  EXPECT_TRUE(names(refusal([&] { read_matrix_model(f); }), {"E0328", "short.dof"}));
  f.rows = files.add("twice.dof", bytes_of_model(data("bar.dof")).replace(4, 3, "1.1"));  // as of expanded shells
  EXPECT_TRUE(names(refusal([&] { read_matrix_model(f); }), {"E0328", "1.1"}));
  f.rows.clear();
  f.mass = data("leg.mas");
  EXPECT_TRUE(names(refusal([&] { read_matrix_model(f); }), {"E0328", "leg.mas", "168", "180"}));
  f = files_of(kSamples[0]);
  f.units = UnitSystem::kMillimetreTonne;
  EXPECT_NEAR(mass_properties(read_matrix_model(f)).mass, 1e3 * mass_properties(bar).mass, 1e-6);
}

}  // namespace
}  // namespace footfall
