// Meshes of shapes, by the generators of mbd_solver/fe, and of files; tubes and spheres are made here.
#include "mbd_solver/scene/boundary_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "coupler/base/errors.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/fe/mesh_generator.h"
#include "mbd_solver/fe/triangle_mesh.h"
#include "mbd_solver/model/rotation.h"
#include "mbd_solver/scene/mesh_reader.h"

namespace footfall {

namespace {

constexpr double kDefaultElements = 10.0;  // elements along the largest size of a shape, when no element size is given

double largest_size(const ShapeSpec& s) {
  switch (s.kind) {
    case ShapeKind::kBox: return s.size.maxCoeff();
    case ShapeKind::kTube:
    case ShapeKind::kRod: return (s.to - s.from).norm();
    case ShapeKind::kDisc:
    case ShapeKind::kDish:
    case ShapeKind::kSphere:
    case ShapeKind::kMesh:
    case ShapeKind::kPoints: return 2.0 * s.radius;
    case ShapeKind::kCylinder: return std::max(2.0 * s.radius, s.length);
    case ShapeKind::kCapsule: return (s.to - s.from).norm() + s.diameter;
  }
  FOOTFALL_DEMAND(false);
}

}  // namespace

TriangleMesh mesh_of_shape(const ShapeSpec& shape) {
  return moved(read_mesh(shape.file, shape.scale), shape.orientation.toRotationMatrix(), shape.position);
}

TriangleMesh shape_surface(const BodySpec& body, const SurfaceSpec& surface) {
  const ShapeSpec& s = *body.shape;
  const double edge = surface.element_size > 0.0 ? surface.element_size : largest_size(s) / kDefaultElements;
  switch (s.kind) {
    case ShapeKind::kBox: return moved(box_mesh(s.size, edge), body.orientation.toRotationMatrix(), s.centre);
    case ShapeKind::kTube:
    case ShapeKind::kRod: return cylinder_mesh(s.from, s.to, s.diameter, edge);
    case ShapeKind::kDisc:
      return moved(surface.faces == SurfaceFaces::kMiddle ? disc_mesh(s.radius, edge)
                                                          : thick_disc_mesh(s.radius, s.thickness, edge),
                   axes_with_z(s.axis), s.centre);
    case ShapeKind::kDish: return moved(dish_mesh(s.radius, s.depth, edge), axes_with_z(s.axis), s.centre);
    case ShapeKind::kSphere: return moved(sphere_mesh(s.radius, edge), Eigen::Matrix3d::Identity(), s.centre);
    case ShapeKind::kCylinder: return moved(thick_disc_mesh(s.radius, s.length, edge), axes_with_z(s.axis), s.centre);
    case ShapeKind::kCapsule:
      return moved(capsule_mesh(0.5 * s.diameter, (s.to - s.from).norm(), edge), axes_with_z(s.to - s.from),
                   0.5 * (s.from + s.to));
    case ShapeKind::kMesh: return mesh_of_shape(s);
    case ShapeKind::kPoints: break;
  }
  return {};
}

TriangleMesh cylinder_mesh(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double diameter, double edge) {
  const double length = (to - from).norm(), radius = 0.5 * diameter;
  const Eigen::Matrix3d R = axes_with_z(to - from);
  const int around = std::max(6, static_cast<int>(std::ceil(kPi * diameter / edge)));
  const int along = std::max(1, static_cast<int>(std::ceil(length / edge)));
  TriangleMesh mesh;
  for (int i = 0; i <= along; ++i) {
    for (int k = 0; k < around; ++k) {
      const double angle = 2.0 * kPi * k / around;
      mesh.vertices.push_back(
          from + R * Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), length * i / along));
    }
  }
  const int bottom = static_cast<int>(mesh.vertices.size()), top = bottom + 1, last = along * around;
  mesh.vertices.push_back(from);
  mesh.vertices.push_back(to);
  for (int k = 0; k < around; ++k) {
    const int next = (k + 1) % around;
    for (int i = 0; i < along; ++i) {
      const int a = i * around + k, b = i * around + next, c = a + around, d = b + around;
      mesh.triangles.emplace_back(a, b, d);
      mesh.triangles.emplace_back(a, d, c);
    }
    mesh.triangles.emplace_back(bottom, next, k);
    mesh.triangles.emplace_back(top, last + k, last + next);
  }
  return mesh;
}

// An icosahedron whose triangles are halved until their edges are short enough, vertices pushed out to the sphere.
TriangleMesh sphere_mesh(double radius, double edge) {
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  TriangleMesh mesh;
  const double points[12][3] = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (const auto& p : points) mesh.vertices.push_back(radius * Eigen::Vector3d(p[0], p[1], p[2]).normalized());
  const int faces[20][3] = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                            {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                            {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (const auto& f : faces) mesh.triangles.emplace_back(f[0], f[1], f[2]);
  double longest = (mesh.vertices[0] - mesh.vertices[11]).norm();
  for (; longest > edge; longest *= 0.5) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [entry, fresh] =
          middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(mesh.vertices.size()));
      if (fresh) {
        const Eigen::Vector3d sum =
            mesh.vertices[static_cast<std::size_t>(a)] + mesh.vertices[static_cast<std::size_t>(b)];
        mesh.vertices.push_back(radius * sum.normalized());
      }
      return entry->second;
    };
    std::vector<Eigen::Vector3i> finer;
    for (const Eigen::Vector3i& t : mesh.triangles) {
      const int ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], ab, ca}, {t[1], bc, ab}, {t[2], ca, bc}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  return mesh;
}

TriangleMesh boundary_surface(const Scene& scene, const BoundarySpec& boundary) {
  if (!boundary.surface) return {};
  const SurfaceSpec& surface = *boundary.surface;
  const BodySpec& body = scene.bodies[static_cast<std::size_t>(scene.body_index(boundary.body))];
  const bool from_file = !surface.file.empty();
  const TriangleMesh mesh = from_file ? moved(read_mesh(surface.file, surface.scale),
                                              surface.orientation.toRotationMatrix(), surface.position)
                                      : shape_surface(body, surface);
  MeshDemands demands;
  demands.closed = surface.closed;
  check_mesh(mesh, demands, from_file ? surface.file : "surface of body \"" + body.name + "\"");
  return mesh;
}

}  // namespace footfall
