#include "mbd_solver/fe/polyhedron.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/fe/mesh_check.h"

namespace footfall {
namespace {

using Eigen::Vector3d;

constexpr double kNoVolume = 1e-12;  // of the cube of the mesh's size

struct Corners {
  Vector3d a, b, c;
  double volume() const { return a.dot(b.cross(c)) / 6.0; }
};

Corners corners_of(const TriangleMesh& mesh, const Eigen::Vector3i& t, const Vector3d& o) {
  const auto at = [&](int i) { return Vector3d(mesh.vertices[static_cast<std::size_t>(t(i))] - o); };
  return {at(0), at(1), at(2)};
}

Vector3d middle_of(const TriangleMesh& mesh) {
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& x : mesh.vertices) sum += x;
  return sum / static_cast<double>(mesh.vertices.size());
}

struct Piece {
  double volume = 0.0;  // negative: faces inward
  Eigen::AlignedBox3d box;
};

// Triangles that share a vertex are one piece.
std::vector<Piece> pieces_of(const TriangleMesh& mesh, const Vector3d& o) {
  std::vector<std::size_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](int vertex) {
    auto i = static_cast<std::size_t>(vertex);
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const Eigen::Vector3i& t : mesh.triangles)
    for (int i = 1; i < 3; ++i) parent[root(t(i))] = root(t(0));
  std::vector<Piece> by_root(mesh.vertices.size());
  for (const Eigen::Vector3i& t : mesh.triangles) {
    Piece& piece = by_root[root(t(0))];
    piece.volume += corners_of(mesh, t, o).volume();
    for (int i = 0; i < 3; ++i) piece.box.extend(mesh.vertices[static_cast<std::size_t>(t(i))]);
  }
  by_root.erase(std::remove_if(by_root.begin(), by_root.end(), [](const Piece& p) { return p.box.isEmpty(); }),
                by_root.end());
  return by_root;
}

void demand_outward(const std::vector<Piece>& pieces, double smallest, const std::string& where) {
  for (const Piece& piece : pieces) {
    if (std::abs(piece.volume) <= smallest)
      throw InputError(where + ": the surface encloses no volume, so it has no mass; expected a solid body");
    if (piece.volume > 0.0) continue;
    const bool cavity = std::any_of(pieces.begin(), pieces.end(), [&](const Piece& other) {
      return other.volume > -piece.volume && other.box.contains(piece.box);
    });
    if (!cavity)
      throw InputError(where + ": the surface faces inward (its volume is " + number_text(piece.volume) +
                       " m3), expected corners counter-clockwise seen from outside; turn its triangles round (flip "
                       "normals)");
  }
}

}  // namespace

MassProperties polyhedron_properties(const TriangleMesh& mesh, double density, const std::string& where) {
  if (!(density > 0.0)) throw InputError(where + ": the density is " + number_text(density) + ", expected more than 0");
  MeshDemands demands;
  demands.closed = demands.oriented = true;
  check_mesh(mesh, demands, where);
  const Vector3d o = middle_of(mesh);
  Eigen::AlignedBox3d box;
  for (const Vector3d& x : mesh.vertices) box.extend(x);
  demand_outward(pieces_of(mesh, o), kNoVolume * std::pow(box.diagonal().norm(), 3), where);

  double volume = 0.0;
  Vector3d moment = Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const Corners k = corners_of(mesh, t, o);
    const double v = k.volume();
    const Vector3d s = k.a + k.b + k.c;
    volume += v;
    moment += v / 4.0 * s;
    second += v / 20.0 * (k.a * k.a.transpose() + k.b * k.b.transpose() + k.c * k.c.transpose() + s * s.transpose());
  }
  const Vector3d p = moment / volume;
  const Eigen::Matrix3d about_centre = second - volume * p * p.transpose();
  MassProperties out;
  out.mass = density * volume;
  out.centre = o + p;
  out.inertia = density * (about_centre.trace() * Eigen::Matrix3d::Identity() - about_centre);
  return out;
}

}  // namespace footfall
