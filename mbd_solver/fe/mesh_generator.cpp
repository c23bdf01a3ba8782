// Discs, dishes and capsules are rings of six sectors mapped to their surface; a box is six grids, welded.

#include "mbd_solver/fe/mesh_generator.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "mbd_solver/base/codes.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/codes.h"

namespace footfall {
namespace {

using Eigen::Vector3d;

constexpr double kMaxTriangles = 2e6;  // more indicates a wrong unit

void require_length(double value, const char* what) {
  if (!(value > 0.0) || !std::isfinite(value))
    throw InputError(code::kParameterOutOfRange,
                     std::string("mesh: ") + what + " is " + plain_text(value) + " m, expected a positive number.");
}

// Number of equal parts of a length so that none is longer than the edge.
int parts(double length, double edge) { return std::max(1, static_cast<int>(std::ceil(length / edge - 1e-9))); }

void require_affordable(double triangles) {
  if (triangles > kMaxTriangles)
    throw InputError(code::kParameterOutOfRange, "mesh: edge length requires " + std::to_string(triangles) +
                                                     " triangles, expected at most " + std::to_string(kMaxTriangles) +
                                                     ". Use longer edges, in metres.");
}

// Ring k has 6 k vertices; each of the six sectors between rings k-1 and k has k triangles pointing inward and k-1 pointing
// outward. place(s, phi): position at the fraction s from centre to rim and at the angle phi.
TriangleMesh ring_mesh(int rings, const std::function<Vector3d(double, double)>& place) {
  require_affordable(6.0 * rings * rings);
  TriangleMesh mesh;
  const auto vertex = [](int ring, int i) { return ring == 0 ? 0 : 3 * ring * (ring - 1) + 1 + i % (6 * ring); };
  mesh.vertices.push_back(place(0.0, 0.0));
  for (int k = 1; k <= rings; ++k) {
    for (int i = 0; i < 6 * k; ++i)
      mesh.vertices.push_back(place(static_cast<double>(k) / rings, 2.0 * kPi * i / (6.0 * k)));
    for (int sector = 0; sector < 6; ++sector)
      for (int i = 0; i < k; ++i) {
        const int outer = sector * k + i;
        const int inner = sector * (k - 1) + i;
        mesh.triangles.emplace_back(vertex(k - 1, inner), vertex(k, outer), vertex(k, outer + 1));
        if (i + 1 < k)
          mesh.triangles.emplace_back(vertex(k - 1, inner), vertex(k, outer + 1), vertex(k - 1, inner + 1));
      }
  }
  return mesh;
}

// Closed surface between a cap and its mirror image in z = 0. The last `around` vertices of the cap are its rim, a circle
// at z = length / 2; its normals point outward. The vertices of the cap come first.
TriangleMesh capped(const TriangleMesh& cap, int around, double length, double edge) {
  const int nodes = static_cast<int>(cap.vertices.size());
  const int layers = parts(length, edge);
  require_affordable(2.0 * static_cast<double>(cap.triangles.size()) + 2.0 * around * layers);
  TriangleMesh mesh = cap;
  for (const Vector3d& x : cap.vertices) mesh.vertices.emplace_back(x.x(), x.y(), -x.z());
  for (int layer = 1; layer < layers; ++layer)
    for (int i = 0; i < around; ++i) {
      const Vector3d& x = cap.vertices[nodes - around + i];
      mesh.vertices.emplace_back(x.x(), x.y(), length * (static_cast<double>(layer) / layers - 0.5));
    }
  mesh.triangles.clear();
  for (const Eigen::Vector3i& t : cap.triangles) {
    mesh.triangles.push_back(t);
    mesh.triangles.emplace_back(nodes + t[0], nodes + t[2], nodes + t[1]);
  }
  const auto on_rim = [&](int layer, int i) {  // from the lower cap, layer 0, to the upper one
    if (layer == 0) return 2 * nodes - around + i % around;
    if (layer == layers) return nodes - around + i % around;
    return 2 * nodes + (layer - 1) * around + i % around;
  };
  for (int layer = 0; layer < layers; ++layer)
    for (int i = 0; i < around; ++i) {
      mesh.triangles.emplace_back(on_rim(layer, i), on_rim(layer, i + 1), on_rim(layer + 1, i + 1));
      mesh.triangles.emplace_back(on_rim(layer, i), on_rim(layer + 1, i + 1), on_rim(layer + 1, i));
    }
  return mesh;
}

}  // namespace

TriangleMesh disc_mesh(double radius, double edge) {
  require_length(radius, "disc radius");
  require_length(edge, "edge length");
  return ring_mesh(parts(radius, edge), [radius](double s, double phi) {
    return Vector3d(s * radius * std::cos(phi), s * radius * std::sin(phi), 0.0);
  });
}

TriangleMesh thick_disc_mesh(double radius, double thickness, double edge) {
  const TriangleMesh face = disc_mesh(radius, edge);
  require_length(thickness, "disc thickness");
  return capped(moved(face, Eigen::Matrix3d::Identity(), {0.0, 0.0, 0.5 * thickness}), 6 * parts(radius, edge),
                thickness, edge);
}

TriangleMesh dish_mesh(double rim_radius, double depth, double edge) {
  require_length(rim_radius, "dish radius");
  require_length(depth, "dish depth");
  require_length(edge, "edge length");
  if (depth > rim_radius)
    throw InputError(code::kParametersDisagree, "mesh: dish depth is " + plain_text(depth) +
                                                    " m, expected at most the radius of the rim, " +
                                                    plain_text(rim_radius) + " m.");
  const double sphere = (rim_radius * rim_radius + depth * depth) / (2.0 * depth);
  const double opening = std::atan2(rim_radius, sphere - depth);
  return ring_mesh(parts(sphere * opening, edge), [sphere, opening](double s, double phi) {
    const double theta = s * opening;
    const double r = sphere * std::sin(theta);
    return Vector3d(r * std::cos(phi), r * std::sin(phi), 2.0 * sphere * std::pow(std::sin(0.5 * theta), 2));
  });
}

TriangleMesh capsule_mesh(double radius, double length, double edge) {
  require_length(length, "capsule length");
  TriangleMesh cap = dish_mesh(radius, radius, edge);  // mirrored, its normals point outward
  for (Vector3d& x : cap.vertices) x.z() = 0.5 * length + radius - x.z();
  const int around = 6 * parts(0.5 * kPi * radius, edge);
  for (auto rim = cap.vertices.end() - around; rim != cap.vertices.end(); ++rim) rim->z() = 0.5 * length;
  return capped(cap, around, length, edge);
}

// Six faces of right-angled triangles, their common edges welded.
TriangleMesh box_mesh(const Vector3d& size, double edge) {
  for (int i = 0; i < 3; ++i) require_length(size(i), "box edge");
  require_length(edge, "edge length");
  require_affordable(4.0 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x()) / (edge * edge));
  TriangleMesh faces;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      const int u = (axis + (side > 0.0 ? 1 : 2)) % 3;  // u x v points outward
      const int v = (axis + (side > 0.0 ? 2 : 1)) % 3;
      const int nu = parts(size(u), edge);
      const int nv = parts(size(v), edge);
      const int first = static_cast<int>(faces.vertices.size());
      for (int j = 0; j <= nv; ++j)
        for (int i = 0; i <= nu; ++i) {
          Vector3d x;
          x(axis) = 0.5 * side * size(axis);
          x(u) = size(u) * (static_cast<double>(i) / nu - 0.5);
          x(v) = size(v) * (static_cast<double>(j) / nv - 0.5);
          faces.vertices.push_back(x);
        }
      for (int j = 0; j < nv; ++j)
        for (int i = 0; i < nu; ++i) {
          const int corner = first + j * (nu + 1) + i;
          faces.triangles.emplace_back(corner, corner + 1, corner + nu + 2);
          faces.triangles.emplace_back(corner, corner + nu + 2, corner + nu + 1);
        }
    }
  return welded(faces, 1e-9 * size.minCoeff());
}

}  // namespace footfall
