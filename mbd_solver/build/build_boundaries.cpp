// What of each body may touch the ground: triangles and beams, in the body's own frame, moving with its modes.

#include <algorithm>
#include <limits>

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
    if (flexible.modal && spec.surface->file.empty() && !flexible.modal->triangles.empty()) {
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

bool touches_ground(const GroundSpec& ground, const std::string& body) {
  if (ground.kind != GroundKind::kPlane || ground.plane->bodies.empty()) return true;
  return std::find(ground.plane->bodies.begin(), ground.plane->bodies.end(), body) != ground.plane->bodies.end();
}

}  // namespace

double lowest_place(const BodyBoundary& entry, const Eigen::Vector3d& n_B, const Eigen::VectorXd& a) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const ContactPoint& point : entry.points) {
    double height = n_B.dot(point.marker.s0) - point.radius;
    if (a.size() > 0) height += n_B.dot(point.marker.S * a);
    lowest = std::min(lowest, height);
  }
  return lowest;
}

std::vector<BodyBoundary> build_boundaries(const Scene& scene, const std::vector<FlexibleBody>& flexible) {
  std::vector<BodyBoundary> boundaries;
  for (const BoundarySpec& spec : scene.boundaries) {
    const int index = scene.body_index(spec.body);
    const auto i = static_cast<std::size_t>(index);
    const BodySpec& body = scene.bodies[i];
    boundaries.push_back({index, build(scene, body, spec, flexible[i]), {}});
    if (!touches_ground(scene.ground, body.name)) continue;
    const Body carrier =
        flexible[i].modal ? Body(body.name, flexible[i].modal) : Body(body.name, body.mass, body.inertia);
    boundaries.back().points = contact_points(index, carrier, boundaries.back().boundary);
  }
  return boundaries;
}

}  // namespace footfall
