#include "mbd_solver/fe/fe_model.h"

#include <numeric>

#include "coupler/base/errors.h"
#include "mbd_solver/fe/beam_element.h"
#include "mbd_solver/fe/element_axes.h"
#include "mbd_solver/fe/mesh_check.h"
#include "mbd_solver/fe/plate_element.h"

namespace footfall {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Triplets = std::vector<Eigen::Triplet<double>>;

Matrix3d skew(const Vector3d& x) {
  Matrix3d m;
  m << 0.0, -x.z(), x.y(), x.z(), 0.0, -x.x(), -x.y(), x.x(), 0.0;
  return m;
}

Eigen::SparseMatrix<double> assembled(int rows, int columns, const Triplets& entries) {
  Eigen::SparseMatrix<double> matrix(rows, columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// Adds an element matrix whose columns (and rows, if it is a stiffness) belong to the nodes, six degrees of
// freedom each.
template <typename Matrix>
void add_stiffness(const Matrix& K, const std::vector<int>& nodes, Triplets& entries) {
  const int n = 6 * static_cast<int>(nodes.size());
  const auto dof = [&nodes](int i) { return 6 * nodes[static_cast<std::size_t>(i / 6)] + i % 6; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      if (K(i, j) != 0.0) entries.emplace_back(dof(i), dof(j), K(i, j));
}

template <typename Matrix>
void add_stress(const Matrix& S, int first_row, const std::vector<int>& nodes, Triplets& entries) {
  for (Index i = 0; i < S.rows(); ++i)
    for (Index j = 0; j < S.cols(); ++j)
      if (S(i, j) != 0.0)
        entries.emplace_back(first_row + static_cast<int>(i),
                             6 * nodes[static_cast<std::size_t>(j / 6)] + static_cast<int>(j % 6), S(i, j));
}

void require_members(const std::vector<Vector3d>& nodes, const std::vector<BeamMember>& members,
                     const std::vector<BeamSection>& sections) {
  const int n = static_cast<int>(nodes.size());
  if (members.empty()) throw InputError("beam model: no members, expected at least one.");
  std::vector<int> piece(nodes.size());
  std::iota(piece.begin(), piece.end(), 0);
  const auto root = [&piece](int i) {
    while (piece[static_cast<std::size_t>(i)] != i) i = piece[static_cast<std::size_t>(i)];
    return i;
  };
  std::vector<bool> used(nodes.size(), false);
  for (std::size_t e = 0; e < members.size(); ++e) {
    const BeamMember& member = members[e];
    const std::string who = "beam model: member " + std::to_string(e);
    for (int node : {member.first, member.second}) {
      if (node < 0 || node >= n)
        throw InputError(who + ": unknown node " + std::to_string(node) + ", expected 0 to " + std::to_string(n - 1) +
                         ".");
      used[static_cast<std::size_t>(node)] = true;
    }
    if (member.section < 0 || member.section >= static_cast<int>(sections.size()))
      throw InputError(who + ": unknown section " + std::to_string(member.section) + ", expected 0 to " +
                       std::to_string(static_cast<int>(sections.size()) - 1) + ".");
    const Vector3d& a = nodes[static_cast<std::size_t>(member.first)];
    const Vector3d& b = nodes[static_cast<std::size_t>(member.second)];
    if (!a.allFinite() || !b.allFinite() || !member.up.allFinite())
      throw InputError(who + ": the coordinates of its nodes or its up direction are not finite numbers.");
    if (!((b - a).norm() > 0.0))
      throw InputError(who + ": its nodes " + std::to_string(member.first) + " and " + std::to_string(member.second) +
                       " are at the same place, expected two different points.");
    piece[static_cast<std::size_t>(root(member.second))] = root(member.first);
  }
  for (int j = 0; j < n; ++j) {
    if (!used[static_cast<std::size_t>(j)])
      throw InputError("beam model: node " + std::to_string(j) +
                       " belongs to no member, so no joint can attach to it. Connect it or remove it.");
    if (root(j) != root(0))
      throw InputError("beam model: disconnected pieces: no chain of members leads from node 0 to node " +
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
  for (int j = 0; j < corners; ++j) model.nodes.col(j) = nodes[static_cast<std::size_t>(j)];

  Triplets stiffness, stress;
  for (int e = 0; e < static_cast<int>(members.size()); ++e) {
    const BeamMember& member = members[static_cast<std::size_t>(e)];
    const BeamSection& section = sections[static_cast<std::size_t>(member.section)];
    const int middle = corners + e;
    const Vector3d from = nodes[static_cast<std::size_t>(member.first)];
    const Vector3d to = nodes[static_cast<std::size_t>(member.second)];
    model.nodes.col(middle) = 0.5 * (from + to);
    const Matrix3d R_DE = beam_axes(from, to, member.up);
    const double length = (to - from).norm();

    const double mass = material.density * section.area * length;
    const Vector3d rotary(section.bending_y + section.bending_z, section.bending_y, section.bending_z);
    const Matrix3d inertia = material.density * length * R_DE * rotary.asDiagonal() * R_DE.transpose();
    for (const auto& [node, weight] :
         {std::pair{member.first, 1.0 / 6.0}, std::pair{middle, 4.0 / 6.0}, std::pair{member.second, 1.0 / 6.0}}) {
      model.node_mass(node) += weight * mass;
      model.node_inertia[static_cast<std::size_t>(node)] += weight * inertia;
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

FeModel straight_beam(const Vector3d& from, const Vector3d& to, int n, const BeamSection& section,
                      const Material& material) {
  if (n < 1) throw InputError("beam: " + std::to_string(n) + " elements, expected at least 1.");
  std::vector<Vector3d> nodes;
  std::vector<BeamMember> members;
  for (int i = 0; i <= n; ++i) {
    nodes.push_back(from + (to - from) * (static_cast<double>(i) / n));
    if (i > 0) {
      BeamMember member;
      member.first = i - 1;
      member.second = i;
      members.push_back(member);
    }
  }
  return beam_model(nodes, members, {section}, material);
}

FeModel plate_model(const TriangleMesh& mesh, double thickness, const Material& material, const std::string& where) {
  check(material);
  if (!(thickness > 0.0))
    throw InputError(where + ": thickness is " + std::to_string(thickness) + " m, expected a positive number.");
  MeshDemands demands;
  demands.connected = true;
  demands.oriented = true;
  check_mesh(mesh, demands, where);
  const int count = static_cast<int>(mesh.vertices.size());
  FeModel model;
  model.nodes.resize(3, count);
  model.node_mass.setZero(count);
  model.node_inertia.assign(static_cast<std::size_t>(count), Matrix3d::Zero());
  for (int j = 0; j < count; ++j) model.nodes.col(j) = mesh.vertices[static_cast<std::size_t>(j)];
  model.triangles = mesh.triangles;

  Triplets stiffness, stress;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const Eigen::Vector3i& corner = mesh.triangles[static_cast<std::size_t>(t)];
    const PlateElement element(model.nodes.col(corner(0)), model.nodes.col(corner(1)), model.nodes.col(corner(2)),
                               thickness, material);
    const std::vector<int> nodes = {corner(0), corner(1), corner(2)};
    add_stiffness(element.stiffness(), nodes, stiffness);
    add_stress(element.stress(), 12 * t, nodes, stress);
    for (int node : nodes) model.node_mass(node) += material.density * thickness * element.area() / 3.0;
  }
  for (int j = 0; j < count; ++j)
    if (model.node_mass(j) == 0.0)
      throw InputError(where + ": vertex " + std::to_string(j) +
                       " belongs to no triangle, so no joint can attach to it. Remove it.");
  model.stiffness = assembled(6 * count, 6 * count, stiffness);
  model.stress = assembled(12 * static_cast<int>(mesh.triangles.size()), 6 * count, stress);
  return model;
}

MassProperties mass_properties(const FeModel& model) {
  MassProperties result;
  result.mass = model.node_mass.sum();
  result.centre = model.nodes * model.node_mass / result.mass;
  result.inertia.setZero();
  for (int j = 0; j < model.node_count(); ++j) {
    const Matrix3d r = skew(model.nodes.col(j) - result.centre);
    result.inertia += model.node_inertia[static_cast<std::size_t>(j)] - model.node_mass(j) * r * r;
  }
  return result;
}

Eigen::SparseMatrix<double> lumped_mass_matrix(const FeModel& model) {
  Triplets entries;
  for (int j = 0; j < model.node_count(); ++j) {
    const Matrix3d& J = model.node_inertia[static_cast<std::size_t>(j)];
    for (int i = 0; i < 3; ++i) {
      if (model.node_mass(j) != 0.0) entries.emplace_back(6 * j + i, 6 * j + i, model.node_mass(j));
      for (int k = 0; k < 3; ++k)
        if (J(i, k) != 0.0) entries.emplace_back(6 * j + 3 + i, 6 * j + 3 + k, J(i, k));
    }
  }
  return assembled(6 * model.node_count(), 6 * model.node_count(), entries);
}

FeModel with_mass(FeModel model, double mass) {
  if (!(mass > 0.0)) throw InputError("body: mass is " + std::to_string(mass) + " kg, expected a positive number.");
  const double factor = mass / model.node_mass.sum();
  model.node_mass *= factor;
  for (Matrix3d& J : model.node_inertia) J *= factor;
  return model;
}

}  // namespace footfall
