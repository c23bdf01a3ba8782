// What of each body may touch the ground: triangles and beams, in the body's own frame, moving with its modes.

#include <algorithm>
#include <limits>

#include "coupler/base/errors.h"
#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/model/marker.h"
#include "mbd_solver/model/rotation.h"
#include "mbd_solver/scene/boundary_surface.h"

namespace footfall {
namespace {

// Nodes collected in B with their mode shapes.
struct Nodes {
  std::vector<Eigen::Vector3d> rho0;
  std::vector<Marker> markers;  // of a flexible body: carries S = Phi - off~ Psi and Psi
};

ModalBoundary assemble(const std::string& name, const Nodes& nodes, std::vector<Eigen::Vector3i> triangles,
                       std::vector<BeamSegment> segments, int modes) {
  const auto count = static_cast<Eigen::Index>(nodes.rho0.size());
  Eigen::Matrix3Xd rho0(3, count);
  Eigen::MatrixXd Phi, Psi;
  if (modes > 0) {
    Phi.resize(3 * count, modes);
    Psi.resize(3 * count, modes);
  }
  for (Eigen::Index j = 0; j < count; ++j) {
    const auto i = static_cast<std::size_t>(j);
    rho0.col(j) = nodes.rho0[i];
    if (modes > 0) {
      Phi.middleRows(3 * j, 3) = nodes.markers[i].S;
      Psi.middleRows(3 * j, 3) = nodes.markers[i].Psi;
    }
  }
  return ModalBoundary(name, std::move(rho0), std::move(triangles), std::move(segments), std::move(Phi),
                       std::move(Psi));
}

ModalBoundary build(const Scene& scene, const BodySpec& body, const BoundarySpec& spec, const FlexibleBody& flexible) {
  const Eigen::Matrix3d R_BD = axes_D(body, flexible).transpose();
  const Eigen::Vector3d p_DBo = origin_D(body, flexible);
  const int modes = flexible.modal ? flexible.modal->mode_count() : 0;
  Nodes nodes;
  std::vector<Eigen::Vector3i> triangles;
  std::vector<BeamSegment> segments;
  const std::unique_ptr<Body> carrier = modes > 0 ? std::make_unique<Body>(body.name, flexible.modal) : nullptr;
  const auto add_node = [&](const Eigen::Vector3d& rho0) {
    nodes.rho0.push_back(rho0);
    if (carrier) nodes.markers.push_back(body_marker(0, *carrier, rho0));
    return static_cast<int>(nodes.rho0.size()) - 1;
  };

  if (spec.surface) {
    // A flexible plate is its own surface; anything else is generated or read, and rides on the nearest nodes.
    if (flexible.modal && spec.surface->file.empty() && !flexible.modal->triangles.empty() &&
        spec.surface->faces != SurfaceFaces::kBoth) {
      triangles = flexible.modal->triangles;
      for (Eigen::Index j = 0; j < flexible.modal->rho0.cols(); ++j) add_node(flexible.modal->rho0.col(j));
    } else {
      const TriangleMesh mesh = boundary_surface(scene, spec);
      triangles = mesh.triangles;
      for (const Eigen::Vector3d& vertex : mesh.vertices) add_node(R_BD * (vertex - p_DBo));
    }
  }
  if (spec.beams) {
    std::vector<Eigen::Vector3d> chain = spec.beams->points;
    if (chain.empty())
      for (int k = 0; k <= spec.beams->segments; ++k)
        chain.push_back(body.shape->from + (body.shape->to - body.shape->from) * k / spec.beams->segments);
    const double radius = spec.beams->radius > 0.0 ? spec.beams->radius : 0.5 * body.shape->diameter;
    int last = add_node(R_BD * (chain.front() - p_DBo));
    for (std::size_t k = 1; k < chain.size(); ++k) {
      const int next = add_node(R_BD * (chain[k] - p_DBo));
      segments.push_back({last, next, radius, 0});
      last = next;
    }
  }
  return assemble(body.name, nodes, std::move(triangles), std::move(segments), modes);
}

// The nodes as they meet a plane: each a ball as thick as the beams that end there.
std::vector<ContactPoint> contact_points(int index, const Body& body, const ModalBoundary& boundary) {
  Eigen::VectorXd radius = Eigen::VectorXd::Zero(boundary.node_count());
  for (const BeamSegment& segment : boundary.segments())
    for (const int end : {segment.start, segment.end}) radius(end) = std::max(radius(end), segment.radius);
  std::vector<ContactPoint> points;
  for (int j = 0; j < boundary.node_count(); ++j)
    points.push_back({body_marker(index, body, boundary.rho0().col(j)), radius(j)});
  return points;
}

Marker rigid_marker(int index, const Eigen::Vector3d& s0, const Eigen::Vector3d& axis = Eigen::Vector3d::UnitZ()) {
  Marker marker;
  marker.body = index;
  marker.s0 = s0;
  marker.axes = axes_with_z(axis);
  return marker;
}

// The surface of a rigid round body on a plane, in place of its nodes; false where the nodes are the surface.
bool add_round_shape(const BodySpec& body, const BoundarySpec& spec, BodyBoundary& entry) {
  if (!spec.surface || !spec.surface->file.empty()) return false;
  if (spec.surface->faces == SurfaceFaces::kMiddle) return false;
  const ShapeSpec& shape = *body.shape;
  const Eigen::Matrix3d R_BD = body.orientation.toRotationMatrix().transpose();
  const auto add_rim = [&](const Eigen::Vector3d& centre, const Eigen::Vector3d& axis, double radius) {
    entry.rims.push_back({rigid_marker(entry.body, R_BD * (centre - body.position), R_BD * axis), radius});
  };
  switch (shape.kind) {
    case ShapeKind::kSphere:
      entry.points.push_back({rigid_marker(entry.body, R_BD * (shape.centre - body.position)), shape.radius});
      return true;
    case ShapeKind::kTube:
    case ShapeKind::kRod:
      for (const Eigen::Vector3d& end : {shape.from, shape.to})
        add_rim(end, shape.to - shape.from, 0.5 * shape.diameter);
      return true;
    case ShapeKind::kDisc:
    case ShapeKind::kCylinder: {
      const double length = shape.kind == ShapeKind::kDisc ? shape.thickness : shape.length;
      for (const double side : {-0.5, 0.5})
        add_rim(shape.centre + side * length * shape.axis.normalized(), shape.axis, shape.radius);
      return true;
    }
    case ShapeKind::kCapsule:
      for (const Eigen::Vector3d& end : {shape.from, shape.to})
        entry.points.push_back({rigid_marker(entry.body, R_BD * (end - body.position)), 0.5 * shape.diameter});
      return true;
    case ShapeKind::kBox:
    case ShapeKind::kDish:
    case ShapeKind::kMesh:
    case ShapeKind::kPoints: return false;
  }
  FOOTFALL_DEMAND(false);
}

bool touches_ground(const GroundSpec& ground, const std::string& body) {
  if (ground.kind != GroundKind::kPlane || ground.plane->bodies.empty()) return true;
  return std::find(ground.plane->bodies.begin(), ground.plane->bodies.end(), body) != ground.plane->bodies.end();
}

const BoundarySpec& spec_of(const Scene& scene, const BodyBoundary& entry) {
  for (const BoundarySpec& spec : scene.boundaries)
    if (spec.body == entry.boundary.name()) return spec;
  FOOTFALL_DEMAND(false);
}

}  // namespace

void add_plane_places(const Scene& scene, const Body& body, BodyBoundary& entry) {
  const BodySpec& spec = scene.bodies[static_cast<std::size_t>(entry.body)];
  const bool round = body.modal() == nullptr && add_round_shape(spec, spec_of(scene, entry), entry);
  for (ContactPoint& point : contact_points(entry.body, body, entry.boundary))
    if (!round || point.radius > 0.0) entry.points.push_back(std::move(point));  // of beams
}

const ShapeSpec* round_shape(const Scene& scene, const BodyBoundary& entry) {
  const BodySpec& body = scene.bodies[static_cast<std::size_t>(entry.body)];
  const BoundarySpec& spec = spec_of(scene, entry);
  if (entry.boundary.mode_count() > 0 || !spec.surface || !spec.surface->file.empty() || !body.shape) return nullptr;
  const bool ball = body.shape->kind == ShapeKind::kSphere || body.shape->kind == ShapeKind::kCapsule;
  return ball ? &*body.shape : nullptr;
}

std::vector<ContactPoint> contact_places(const Scene& scene, const Body& body, const BodyBoundary& entry) {
  if (round_shape(scene, entry) == nullptr) return contact_points(entry.body, body, entry.boundary);
  BodyBoundary round{entry.body, entry.boundary, {}, {}};
  add_plane_places(scene, body, round);
  return round.points;
}

double lowest_place(const BodyBoundary& entry, const Eigen::Vector3d& n_B, const Eigen::VectorXd& a) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const ContactPoint& point : entry.points) {
    double height = n_B.dot(point.marker.s0) - point.radius;
    if (a.size() > 0) height += n_B.dot(point.marker.S * a);
    lowest = std::min(lowest, height);
  }
  for (const ContactRim& rim : entry.rims)  // n.c - R |n x axis|
    lowest = std::min(lowest, n_B.dot(rim.marker.s0) - rim.radius * n_B.cross(rim.marker.axes.col(2)).norm());
  return lowest;
}

std::vector<BodyBoundary> build_boundaries(const Scene& scene, const std::vector<FlexibleBody>& flexible) {
  std::vector<BodyBoundary> boundaries;
  for (const BoundarySpec& spec : scene.boundaries) {
    const int index = scene.body_index(spec.body);
    const auto i = static_cast<std::size_t>(index);
    const BodySpec& body = scene.bodies[i];
    boundaries.push_back({index, build(scene, body, spec, flexible[i]), {}, {}});
    if (!touches_ground(scene.ground, body.name)) continue;
    const Body carrier =
        flexible[i].modal ? Body(body.name, flexible[i].modal) : Body(body.name, body.mass, body.inertia);
    BodyBoundary& entry = boundaries.back();
    if (scene.ground.kind == GroundKind::kPlane) {
      add_plane_places(scene, carrier, entry);
    } else {
      entry.points = contact_points(index, carrier, entry.boundary);
    }
  }
  return boundaries;
}

}  // namespace footfall
