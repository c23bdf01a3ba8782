// The contacts of boundaries with a soil without grains: the facets around each node.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/elements/soil_contact.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

constexpr double kOneFacet = 0.94;  // cosine of 20 degrees

Eigen::Vector3d corner(const ModalBoundary& boundary, int node) { return boundary.rho0().col(node); }

// Every edge is passed once in each direction.
bool encloses(const ModalBoundary& boundary) {
  std::map<std::array<int, 2>, int> edges;
  for (const Eigen::Vector3i& t : boundary.triangles())
    for (int k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  return std::all_of(edges.begin(), edges.end(), [&](const auto& edge) {
    const auto back = edges.find({edge.first[1], edge.first[0]});
    return edge.second == 1 && back != edges.end() && back->second == 1;
  });
}

double six_volumes(const ModalBoundary& boundary) {
  double sum = 0.0;
  for (const Eigen::Vector3i& t : boundary.triangles())
    sum += corner(boundary, t[0]).dot(corner(boundary, t[1]).cross(corner(boundary, t[2])));
  return sum;
}

// Facets around a node whose normals differ by less than 20 degrees are one: a third of their area, at the node. A stress that
// is linear over a triangle has its exact mean at the corners. fades: they count by the share of their faces that is in the ground.
std::vector<SoilFacet> facets_of(const BodyBoundary& entry, double side, bool fades, const Model& model) {
  const ModalBoundary& boundary = entry.boundary;
  const int modes = boundary.mode_count();
  struct Share {
    int node;
    Eigen::Vector3d area;      // along the normal [m2]
    std::vector<int> corners;  // the others of its triangles
  };
  std::vector<std::vector<Share>> around(boundary.node_count());
  for (const Eigen::Vector3i& t : boundary.triangles()) {
    const Eigen::Vector3d a = corner(boundary, t[0]);
    const Eigen::Vector3d third =
        side / 6.0 * (corner(boundary, t[1]) - a).cross(Eigen::Vector3d(corner(boundary, t[2]) - a));
    if (!(third.norm() > 0.0)) continue;
    for (const int node : {t[0], t[1], t[2]}) {
      std::vector<Share>& shares = around[node];
      const auto alike = std::find_if(shares.begin(), shares.end(), [&](const Share& share) {
        return share.area.normalized().dot(third.normalized()) > kOneFacet;
      });
      Share& share = alike == shares.end() ? shares.emplace_back(Share{node, Eigen::Vector3d::Zero(), {}}) : *alike;
      share.area += third;
      for (const int other : {t[0], t[1], t[2]})
        if (other != node && std::find(share.corners.begin(), share.corners.end(), other) == share.corners.end())
          share.corners.push_back(other);
    }
  }
  std::vector<SoilFacet> facets;
  for (const std::vector<Share>& shares : around) {
    for (const Share& share : shares) {
      SoilFacet facet;
      facet.marker.body = entry.body;
      facet.marker.s0 = corner(boundary, share.node);
      facet.marker.S = Eigen::Matrix3Xd::Zero(3, modes);
      if (modes > 0) facet.marker.S = boundary.Phi().middleRows(3 * share.node, 3);
      facet.marker.Psi = Eigen::Matrix3Xd::Zero(3, modes);
      for (Eigen::Matrix3Xd& U : facet.marker.U) U = Eigen::Matrix3Xd::Zero(3, modes);
      facet.normal = share.area.normalized();
      facet.area = share.area.norm();
      facet.start = model.initial_position(facet.marker);
      if (fades)
        for (const int other : share.corners) facet.corners.push_back(corner(boundary, other) - facet.marker.s0);
      facets.push_back(std::move(facet));
    }
  }
  return facets;
}

// The faces of a disc or cylinder are polygons on its circle, smaller by (2 pi / corners)^2 / 6: their facets get the area of the
// circle.
void round_off(const BodySpec& body, const Eigen::Matrix3d& R_DB, std::vector<SoilFacet>& facets) {
  constexpr double kPolygon = 1.3;  // of the areas of a circle and a polygon of six corners, at most: 1.21
  if (!body.shape || (body.shape->kind != ShapeKind::kDisc && body.shape->kind != ShapeKind::kCylinder)) return;
  for (const double side : {1.0, -1.0}) {
    const Eigen::Vector3d out = side * R_DB.transpose() * body.shape->axis.normalized();
    double area = 0.0;
    for (const SoilFacet& facet : facets)
      if (facet.normal.dot(out) > kOneFacet) area += facet.area;
    const double factor = kPi * body.shape->radius * body.shape->radius / area;
    if (!(factor > 1.0 && factor < kPolygon)) continue;  // none, or not the mesh of the shape
    for (SoilFacet& facet : facets)
      if (facet.normal.dot(out) > kOneFacet) facet.area *= factor;
  }
}

// The smaller side of a boundary seen along the axis in which it is thinnest.
double width_of(const ModalBoundary& boundary) {
  Eigen::Vector3d sides = boundary.rho0().rowwise().maxCoeff() - boundary.rho0().rowwise().minCoeff();
  std::sort(sides.data(), sides.data() + 3);
  return sides[1];
}

constexpr double kAnyDepth = 1e6;  // of a soil [m]

std::shared_ptr<const SoilLaw> soil_law(const Scene& scene, const ModalBoundary& boundary) {
  const SoilSpec& spec = *scene.ground.law;
  const auto set_common = [&](SoilLaw::Common& c) {
    c.density = spec.density;
    c.inertia = spec.inertia;
    c.speed_resistance = spec.speed_resistance;
    c.speed_depth = spec.speed_depth.value_or(kAnyDepth);
    c.cohesion = spec.cohesion;
    c.surface_friction = spec.surface_friction.value_or(1e3);
    c.rebound = spec.rebound;
    c.damping = spec.damping;
  };
  if (spec.kind == SoilLawKind::kRft) {
    RftParameters p;
    set_common(p);
    const double g = scene.gravity.norm();
    p.friction = spec.friction;
    p.resistance = spec.resistance ? *spec.resistance * (spec.gravity ? g / *spec.gravity : 1.0)
                                   : rft_resistance(spec.density, spec.friction, g);
    return make_rft(p, "ground.law: ");
  }
  SinkageParameters p;
  set_common(p);
  p.stiffness = spec.cohesive_modulus / spec.width.value_or(width_of(boundary)) + spec.frictional_modulus.value_or(0.0);
  p.exponent = spec.exponent;
  p.friction = spec.friction;
  p.shear_length = spec.shear_length.value_or(0.0);
  return make_pressure_sinkage(p, "ground.law: ");
}

}  // namespace

void add_soil_contacts(const Scene& scene, const std::vector<SoilSurface>& surfaces, const std::string& prefix,
                       Mechanism& mechanism) {
  if (scene.ground.kind != GroundKind::kSoil) return;
  const SoilSpec& spec = *scene.ground.law;
  std::shared_ptr<const SoilGround> ground;
  std::vector<std::pair<const SoilSurface*, std::vector<SoilFacet>>> touching;
  double largest = 0.0;  // area of a facet [m2]
  for (const SoilSurface& surface : surfaces) {
    const BodyBoundary& entry = *surface.entry;
    if (entry.points.empty() && entry.rims.empty()) continue;
    const bool closed = encloses(entry.boundary);
    std::vector<SoilFacet> facets = facets_of(entry, closed && six_volumes(entry.boundary) < 0.0 ? -1.0 : 1.0,
                                              spec.kind == SoilLawKind::kRft, mechanism.model);
    if (facets.empty()) continue;
    const Eigen::Matrix3d A = rotation_matrix(mechanism.model.initial(entry.body).L);
    round_off(scene.bodies[entry.body], mechanism.placement.R_WD.transpose() * A, facets);
    for (const SoilFacet& facet : facets) largest = std::max(largest, facet.area);
    touching.emplace_back(&surface, std::move(facets));
  }
  for (auto& [surface, facets] : touching) {
    const bool first = ground == nullptr;
    if (first) ground = std::make_shared<const SoilGround>(std::sqrt(largest));
    const ModalBoundary& boundary = surface->entry->boundary;
    add_contact(std::make_unique<SoilContact>(
                    prefix + boundary.name(), std::move(facets), !encloses(boundary),
                    SoilContact::Surface{spec.point - surface->below * spec.normal, spec.normal, surface->terrain},
                    soil_law(scene, boundary), ground, first),
                mechanism);
  }
}

void add_soil_contacts(const Scene& scene, Mechanism& mechanism) {
  std::vector<SoilSurface> surfaces;
  for (const BodyBoundary& entry : mechanism.boundaries) surfaces.push_back({&entry, 0.0, mechanism.terrain});
  add_soil_contacts(scene, surfaces, "ground/", mechanism);
}

}  // namespace footfall
