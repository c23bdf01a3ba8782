// Assembly by triplets; checks of members, mass, connection and freedom from supports.

#include "mbd_solver/fe/fe_model.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <locale>
#include <numeric>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "mbd_solver/base/codes.h"
#include "mbd_solver/fe/elements.h"
#include "mbd_solver/fe/fe_analysis.h"
#include "mbd_solver/model/codes.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Triplets = std::vector<Eigen::Triplet<double>>;

Eigen::SparseMatrix<double> assembled(int rows, int columns, const Triplets& entries) {
  Eigen::SparseMatrix<double> matrix(rows, columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// Adds an element matrix with six columns (and rows, of a stiffness) per node.
template <typename Matrix>
void add_stiffness(const Matrix& K, const std::vector<int>& nodes, Triplets& entries) {
  const int n = 6 * static_cast<int>(nodes.size());
  const auto dof = [&nodes](int i) { return 6 * nodes[i / 6] + i % 6; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      if (K(i, j) != 0.0) entries.emplace_back(dof(i), dof(j), K(i, j));
}

template <typename Matrix>
void add_stress(const Matrix& S, int first_row, const std::vector<int>& nodes, Triplets& entries) {
  for (Index i = 0; i < S.rows(); ++i)
    for (Index j = 0; j < S.cols(); ++j)
      if (S(i, j) != 0.0)
        entries.emplace_back(first_row + static_cast<int>(i), 6 * nodes[j / 6] + static_cast<int>(j % 6), S(i, j));
}

void require_members(const std::vector<Vector3d>& nodes, const std::vector<BeamMember>& members,
                     const std::vector<BeamSection>& sections) {
  const int n = static_cast<int>(nodes.size());
  if (members.empty()) throw InputError(code::kFeModel, "beam model: no members, expected at least one.");
  std::vector<int> piece(nodes.size());
  std::iota(piece.begin(), piece.end(), 0);
  const auto root = [&piece](int i) {
    while (piece[i] != i) i = piece[i];
    return i;
  };
  std::vector<bool> used(nodes.size(), false);
  for (std::size_t e = 0; e < members.size(); ++e) {
    const BeamMember& member = members[e];
    const std::string who = "beam model: member " + std::to_string(e);
    for (int node : {member.first, member.second}) {
      if (node < 0 || node >= n)
        throw InputError(code::kFeModel, who + ": unknown node " + std::to_string(node) + ", expected 0 to " +
                                             std::to_string(n - 1) + ".");
      used[node] = true;
    }
    if (member.section < 0 || member.section >= static_cast<int>(sections.size()))
      throw InputError(code::kFeModel, who + ": unknown section " + std::to_string(member.section) +
                                           ", expected 0 to " + std::to_string(static_cast<int>(sections.size()) - 1) +
                                           ".");
    const Vector3d& a = nodes[member.first];
    const Vector3d& b = nodes[member.second];
    if (!a.allFinite() || !b.allFinite() || !member.up.allFinite())
      throw InputError(code::kFeModel,
                       who + ": the coordinates of its nodes or its up direction are not finite numbers.");
    if (!((b - a).norm() > 0.0))
      throw InputError(code::kFeModel, who + ": its nodes " + std::to_string(member.first) + " and " +
                                           std::to_string(member.second) + " coincide; expected two different points.");
    piece[root(member.second)] = root(member.first);
  }
  for (int j = 0; j < n; ++j) {
    if (!used[j])
      throw InputError(code::kFeModel,
                       "beam model: node " + std::to_string(j) +
                           " belongs to no member, so no joint can attach to it. Connect it or remove it.");
    if (root(j) != root(0))
      throw InputError(code::kFeModel,
                       "beam model: disconnected pieces: no chain of members leads from node 0 to node " +
                           std::to_string(j) + ". A body must be one piece.");
  }
}

}  // namespace

FeModel beam_model(const std::vector<Vector3d>& nodes, const std::vector<BeamMember>& members,
                   const std::vector<BeamSection>& sections, const Material& material) {
  check(material);
  require_members(nodes, members, sections);
  const int corners = static_cast<int>(nodes.size());
  const int count = corners + static_cast<int>(members.size());
  FeModel model;
  model.nodes.resize(3, count);
  model.node_mass.setZero(count);
  model.node_inertia.assign(static_cast<std::size_t>(count), Matrix3d::Zero());
  for (int j = 0; j < corners; ++j) model.nodes.col(j) = nodes[j];

  Triplets stiffness, stress;
  for (int e = 0; e < static_cast<int>(members.size()); ++e) {
    const BeamMember& member = members[e];
    const BeamSection& section = sections[member.section];
    const int middle = corners + e;
    const Vector3d from = nodes[member.first];
    const Vector3d to = nodes[member.second];
    model.nodes.col(middle) = 0.5 * (from + to);
    const Matrix3d R_DE = beam_axes(from, to, member.up);
    const double length = (to - from).norm();

    const double mass = material.density * section.area * length;
    const Vector3d rotary(section.bending_y + section.bending_z, section.bending_y, section.bending_z);
    const Matrix3d inertia = material.density * length * R_DE * rotary.asDiagonal() * R_DE.transpose();
    for (const auto& [node, weight] :
         {std::pair{member.first, 1.0 / 6.0}, std::pair{middle, 4.0 / 6.0}, std::pair{member.second, 1.0 / 6.0}}) {
      model.node_mass(node) += weight * mass;
      model.node_inertia[node] += weight * inertia;
    }

    const Matrix12d K = turned_stiffness(beam_stiffness(0.5 * length, section, material), R_DE);
    const BeamStressMatrix S = turned_stress(beam_stress(0.5 * length, section, material), R_DE);
    for (const Eigen::Vector2i& half :
         {Eigen::Vector2i(member.first, middle), Eigen::Vector2i(middle, member.second)}) {
      add_stiffness(K, {half(0), half(1)}, stiffness);
      add_stress(S, 6 * kBeamStressPoints * static_cast<int>(model.segments.size()), {half(0), half(1)}, stress);
      model.segments.push_back(half);
    }
  }
  model.stiffness = assembled(6 * count, 6 * count, stiffness);
  model.stress = assembled(6 * kBeamStressPoints * static_cast<int>(model.segments.size()), 6 * count, stress);
  return model;
}

FeModel plate_model(const TriangleMesh& mesh, double thickness, const Material& material, const std::string& where) {
  check(material);
  if (!(thickness > 0.0))
    throw InputError(code::kParameterOutOfRange,
                     where + ": thickness is " + plain_text(thickness) + " m, expected a positive number.");
  MeshDemands demands;
  demands.connected = true;
  demands.oriented = true;
  check_mesh(mesh, demands, where);
  const int count = static_cast<int>(mesh.vertices.size());
  FeModel model;
  model.nodes.resize(3, count);
  model.node_mass.setZero(count);
  model.node_inertia.assign(static_cast<std::size_t>(count), Matrix3d::Zero());
  for (int j = 0; j < count; ++j) model.nodes.col(j) = mesh.vertices[j];
  model.triangles = mesh.triangles;

  Triplets stiffness, stress;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const Eigen::Vector3i& corner = mesh.triangles[t];
    const PlateElement element(model.nodes.col(corner(0)), model.nodes.col(corner(1)), model.nodes.col(corner(2)),
                               thickness, material);
    const std::vector<int> nodes = {corner(0), corner(1), corner(2)};
    add_stiffness(element.stiffness(), nodes, stiffness);
    add_stress(element.stress(), 12 * t, nodes, stress);
    for (int node : nodes) model.node_mass(node) += material.density * thickness * element.area() / 3.0;
  }
  for (int j = 0; j < count; ++j)
    if (model.node_mass(j) == 0.0)
      throw InputError(code::kFeModel, where + ": vertex " + std::to_string(j) +
                                           " belongs to no triangle, so no joint can attach to it. Remove it.");
  model.stiffness = assembled(6 * count, 6 * count, stiffness);
  model.stress = assembled(12 * static_cast<int>(mesh.triangles.size()), 6 * count, stress);
  return model;
}

MassProperties mass_properties(const FeModel& model) {
  if (model.mass.size() > 0) return mass_properties(model.nodes, model.mass);
  MassProperties result;
  result.mass = model.node_mass.sum();
  result.centre = model.nodes * model.node_mass / result.mass;
  result.inertia.setZero();
  for (int j = 0; j < model.node_count(); ++j) {
    const Matrix3d r = skew(model.nodes.col(j) - result.centre);
    result.inertia += model.node_inertia[j] - model.node_mass(j) * r * r;
  }
  return result;
}

Eigen::SparseMatrix<double> mass_matrix(const FeModel& model) {
  if (model.mass.size() > 0) return model.mass;
  Triplets entries;
  for (int j = 0; j < model.node_count(); ++j) {
    const Matrix3d& J = model.node_inertia[j];
    for (int i = 0; i < 3; ++i) {
      if (model.node_mass(j) != 0.0) entries.emplace_back(6 * j + i, 6 * j + i, model.node_mass(j));
      for (int k = 0; k < 3; ++k)
        if (J(i, k) != 0.0) entries.emplace_back(6 * j + 3 + i, 6 * j + 3 + k, J(i, k));
    }
  }
  const int size = 6 * model.node_count() + model.extra;
  return assembled(size, size, entries);
}

FeModel with_mass(FeModel model, double mass) {
  if (!(mass > 0.0))
    throw InputError(code::kParameterOutOfRange,
                     "body: mass is " + plain_text(mass) + " kg, expected a positive number.");
  const double factor = mass / mass_properties(model).mass;
  model.node_mass *= factor;
  model.mass *= factor;
  for (Matrix3d& J : model.node_inertia) J *= factor;
  return model;
}

namespace {

constexpr double kSamePlace = 1e-6;  // of the size: nodes that are so near are at one place

// Nodes of sets precede the nodes of the mesh: of two nodes at one place the joint holds the set.
int nearest(const Eigen::Matrix3Xd& nodes, const Vector3d& p) {
  FOOTFALL_DEMAND(nodes.cols() > 0);
  const Eigen::RowVectorXd distance = (nodes.colwise() - p).colwise().norm();
  const double size = (nodes.rowwise().maxCoeff() - nodes.rowwise().minCoeff()).norm();
  const double most = distance.minCoeff() + kSamePlace * size;
  Eigen::Index first = 0;
  while (first + 1 < distance.size() && !(distance(first) <= most)) ++first;
  return static_cast<int>(first);
}

// turns: nodes with rotations; empty: all.
int joint_node(const Eigen::Matrix3Xd& nodes, const std::vector<bool>& turns, const Vector3d& p, double tolerance,
               bool needs_rotation) {
  const int node = nearest(nodes, p);
  const double distance = (nodes.col(node) - p).norm();
  std::ostringstream message;
  message.imbue(std::locale::classic());
  if (!(distance <= tolerance)) {
    message << "no joint can attach at (" << p.transpose() << ") m: the nearest node, " << node << ", at ("
            << nodes.col(node).transpose() << ") m, is " << distance << " m away, expected at most " << tolerance
            << " m. Move the joint to a node, or add a node there.";
    throw InputError(code::kNoSuchNode, message.str());
  }
  if (needs_rotation && !turns.empty() && !turns[node]) {
    message
        << "no joint that holds an orientation can attach to node " << node << ", at (" << nodes.col(node).transpose()
        << ") m, which has no rotations. Give flexible.interfaces with a set of nodes there, use a spherical joint, "
           "or a model with rotations.";
    throw InputError(code::kNodeWithoutRotation, message.str());
  }
  return node;
}

}  // namespace

int nearest_node(const FeModel& model, const Vector3d& p_D) { return nearest(model.nodes, p_D); }

int nearest_node(const ModalBody& body, const Vector3d& p_B) { return nearest(body.rho0, p_B); }

int joint_node(const FeModel& model, const Vector3d& p_D, double tolerance, bool needs_rotation) {
  const int node = joint_node(model.nodes, turning_nodes(model), p_D, tolerance, needs_rotation);
  for (const Spider& spider : model.spiders)
    if (spider.kind == SpiderKind::kRigid && std::binary_search(spider.nodes.begin(), spider.nodes.end(), node))
      return spider.node;
  return node;
}

std::vector<bool> turning_nodes(const FeModel& model) {
  const std::size_t n = model.node_count();
  std::vector<bool> turns(n, false);
  const Eigen::VectorXd stiffness = model.stiffness.diagonal();
  for (std::size_t j = 0; j < n; ++j) turns[j] = !stiffness.segment<3>(6 * static_cast<Index>(j) + 3).isZero(0.0);
  for (const Spider& spider : model.spiders) {
    turns[spider.node] = true;
    if (spider.kind == SpiderKind::kRigid)
      for (const int j : spider.nodes) turns[j] = true;
  }
  return turns;
}

int joint_node(const ModalBody& body, const Vector3d& p_B, double tolerance, bool needs_rotation) {
  const bool rotations = body.mode_count() == 0 || !body.Psi.isZero(0.0);
  const std::vector<bool> turns(rotations ? 0 : static_cast<std::size_t>(body.node_count()), false);
  return joint_node(body.rho0, turns, p_B, tolerance, needs_rotation);
}

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr double kSymmetric = 1e-6;    // largest |K - K^T| over largest |K|: files print six digits or more
constexpr double kRounded = 1e-3;      // below, coordinates of three to six digits are likelier than supports
constexpr double kUnsupported = 1e-6;  // force of a rigid-body motion over the sum of its magnitudes
constexpr double kOneCentre = 1e-4;    // momentum of a unit rotation about the centre, over sqrt(mass inertia)
constexpr double kMassRank = 1e-12;    // singular below this fraction of the largest eigenvalue

// Symmetric, with one total mass and one centre along all axes, and without a motion of negative energy.
void check_mass_matrix(const FeModel& model, const std::string& who) {
  const Sparse& M = model.mass;
  const Sparse skewed = M - Sparse(M.transpose());
  if (!(skewed.norm() <= kSymmetric * M.norm()))
    throw InputError(code::kFeModel, who + ": the mass matrix is not symmetric.");
  const MassProperties body = mass_properties(model);
  const MatrixXd R = rigid_motions(model, body.centre), rigid = R.transpose() * (M * R);
  const double size = std::sqrt(std::max(0.0, body.mass * body.inertia.trace()));
  if (!(rigid.topRightCorner<3, 3>().cwiseAbs().maxCoeff() <= kOneCentre * size))
    throw InputError(code::kFeModel,
                     who +
                         ": the mass matrix has no mass centre: a rotation of the whole body about it has momentum. "
                         "Expected rows in the order of the nodes, rotations in rad, and all nodes in the same unit.");
  // Unit diagonal, a little larger: pivots of a positive matrix remain positive in spite of its round-off.
  VectorXd scale = M.diagonal();
  for (Index i = 0; i < scale.size(); ++i) {
    if (!(scale(i) >= 0.0))
      throw InputError(code::kFeModel, who + ": mass matrix is not positive: row " + std::to_string(i % 6 + 1) +
                                           " of node " + std::to_string(i / 6) + " has the mass " +
                                           std::to_string(scale(i)) + ", expected 0 or more.");
    scale(i) = scale(i) > 0.0 ? 1.0 / std::sqrt(scale(i)) : 0.0;
  }
  Triplets shift;
  for (int i = 0; i < scale.size(); ++i) shift.emplace_back(i, i, scale(i) > 0.0 ? kSymmetric : 1.0);
  const Sparse unit = scale.asDiagonal() * M * scale.asDiagonal();
  const auto size_of_M = static_cast<int>(M.rows());
  const Eigen::SimplicialLDLT<Sparse> factor(Sparse(unit + assembled(size_of_M, size_of_M, shift)));
  if (factor.info() != Eigen::Success || !(factor.vectorD().minCoeff() > 0.0))
    throw InputError(code::kFeModel, who + ": mass matrix is not positive: some motion has negative kinetic energy.");
}

void check_mass(const FeModel& model, const std::string& who) {
  const std::string not_positive = who + ": mass matrix is not positive: ";
  if (model.mass.size() > 0) check_mass_matrix(model, who);
  for (int j = 0; j < model.node_count(); ++j) {
    if (!(model.node_mass(j) >= 0.0))
      throw InputError(code::kFeModel, not_positive + "node " + std::to_string(j) + " has the mass " +
                                           std::to_string(model.node_mass(j)) + " kg, expected 0 or more.");
    const Matrix3d& J = model.node_inertia[j];
    const Vector3d moments = Eigen::SelfAdjointEigenSolver<Matrix3d>(J, Eigen::EigenvaluesOnly).eigenvalues();
    if (!(moments.minCoeff() >= -kMassRank * moments.cwiseAbs().maxCoeff()))
      throw InputError(code::kFeModel, not_positive + "node " + std::to_string(j) +
                                           " has a rotary inertia with the principal value " +
                                           plain_text(moments.minCoeff()) + " kg m2, expected 0 or more.");
  }
  if (!(mass_properties(model).mass > 0.0)) throw InputError(code::kFeModel, not_positive + "the body has no mass.");
  const Vector3d moments =
      Eigen::SelfAdjointEigenSolver<Matrix3d>(mass_properties(model).inertia, Eigen::EigenvaluesOnly).eigenvalues();
  if (!(moments.minCoeff() > kMassRank * moments.maxCoeff()))
    throw InputError(
        code::kFeModel,
        not_positive +
            "the body has no inertia about one of its axes; expected nodes that are not all on one line, or nodes "
            "with rotary inertia.");
}

bool has_own_motion(const FeModel& model, Index row) { return model.follows.empty() || !model.follows[row]; }

// All displacements of the node follow from others.
bool is_led(const FeModel& model, int node) {
  for (int i = 0; i < 3; ++i)
    if (has_own_motion(model, 6 * node + i)) return false;
  return true;
}

// Nodes coupled by the stiffness form one piece, directly or by coordinates of modes.
void check_connected(const FeModel& model, const std::string& who) {
  const int n = model.node_count();
  int first = 0;
  while (first + 1 < n && is_led(model, first)) ++first;
  std::vector<bool> reached(static_cast<std::size_t>(n + model.extra), false);
  std::vector<int> todo = {first};
  reached[first] = true;
  while (!todo.empty()) {
    const int node = todo.back();
    todo.pop_back();
    for (int i = 0; i < (node < n ? 6 : 1); ++i)
      for (Sparse::InnerIterator it(model.stiffness, node < n ? 6 * node + i : 5 * n + node); it; ++it) {
        const int other = static_cast<int>(it.row() < 6 * n ? it.row() / 6 : it.row() - 5 * n);
        if (it.value() == 0.0 || reached[other]) continue;
        reached[other] = true;
        todo.push_back(other);
      }
  }
  for (int j = 0; j < n; ++j)
    if (!reached[j] && !is_led(model, j))
      throw InputError(code::kFeModel, who + ": disconnected pieces: no stiffness leads from node " +
                                           std::to_string(first) + " to node " + std::to_string(j) +
                                           ", expected a body of one piece.");
}

void check_free(const FeModel& model, const std::string& who) {
  const MatrixXd R = rigid_motions(model, mass_properties(model).centre);
  const Sparse magnitude = model.stiffness.cwiseAbs();
  for (int k = 0; k < 6; ++k) {
    const double force = (model.stiffness * R.col(k)).norm();
    const double parts = (magnitude * R.col(k).cwiseAbs()).norm();
    const bool rounded = k >= 3 && force < kRounded * parts;
    if (!(force <= kUnsupported * parts))
      throw InputError(code::kFeModel,
                       who + ": the stiffness matrix resists " + (k < 3 ? "translation along " : "rotation about ") +
                           std::string(1, "xyz"[k % 3]) + " of the whole body (relative force " +
                           plain_text(force / parts) + "), expected a free body. " +
                           (rounded ? "The coordinates of its nodes seem to be rounded: write them with more digits"
                                    : "Remove its supports; joints are given in the scene") +
                           "." + model.remark);
  }
}

}  // namespace

void check_model(const FeModel& model, const std::string& who) {
  const Index n = model.node_count();
  FOOTFALL_DEMAND(model.node_mass.size() == n && static_cast<Index>(model.node_inertia.size()) == n);
  const Index size = 6 * n + model.extra;
  FOOTFALL_DEMAND(model.stiffness.rows() == size && model.stiffness.cols() == size);
  FOOTFALL_DEMAND(model.mass.size() == 0 || (model.mass.rows() == size && model.mass.cols() == size));
  if (n == 0) throw InputError(code::kFeModel, who + ": the model has no nodes.");
  check_mass(model, who);
  const VectorXd diagonal = model.stiffness.diagonal();
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < 3; ++i)
      if (has_own_motion(model, 6 * j + i) && !(diagonal(6 * j + i) > 0.0))
        throw InputError(code::kFeModel,
                         who + ": node " + std::to_string(j) +
                             " has no stiffness against some displacement: it belongs to no element, so no joint "
                             "can attach to it.");
  const Sparse skewed = model.stiffness - Sparse(model.stiffness.transpose());
  if (!(skewed.norm() <= kSymmetric * model.stiffness.norm()))
    throw InputError(code::kFeModel, who + ": the stiffness matrix is not symmetric.");
  check_connected(model, who);
  check_free(model, who);
}

void check_interface(const FeModel& model, const std::vector<int>& nodes, const std::string& who) {
  for (int node : nodes)
    if (node < 0 || node >= model.node_count())
      throw InputError(code::kNoSuchNode, who + ": interface node " + std::to_string(node) +
                                              " does not exist, so no joint can attach to it; expected 0 to " +
                                              std::to_string(model.node_count() - 1) + ".");
}

}  // namespace footfall
