// Bodies that have a shape, but no boundary, on a plane or a soil: a coarse surface of the shape touches a ground that lies
// lower, so that a lander that tips over comes to lie instead of falling through. As long as none of them goes that deep, a run
// is the same to the last bit as one without: the contacts have no inner states, and their forces are zero.

#include <algorithm>
#include <map>
#include <set>

#include "coupler/base/errors.h"
#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/model/rotation.h"
#include "mbd_solver/scene/resolve.h"
#include "mbd_solver/scene/shape_outline.h"

namespace footfall {
namespace {

constexpr double kEdge = 0.25;  // of generated triangles, over the size of the body

// Uneven ground that lies lower by `below` [m]; one for all bodies of the same depth.
class LoweredGround {
 public:
  LoweredGround(const Scene& scene, bool uneven) : scene_(scene), uneven_(uneven) {}
  std::shared_ptr<Terrain> at(double below) {
    if (!uneven_) return nullptr;
    std::shared_ptr<Terrain>& terrain = made_[below];
    if (terrain) return terrain;
    TerrainSpec spec = *scene_.ground.terrain;
    spec.position.z() -= below;
    return terrain = terrain_of(spec);
  }

 private:
  const Scene& scene_;
  bool uneven_;
  std::map<double, std::shared_ptr<Terrain>> made_;
};

// A leg on its pad: a joint connects it to one body with a boundary, and it is not the heaviest body. It goes into the soil with
// its pad, which touches for both.
bool stands_on_another(const Scene& scene, const BodySpec& spec) {
  std::set<std::string> feet;
  for (const JointSpec& joint : scene.joints)
    for (const int side : {0, 1})
      if (joint.bodies[side] == spec.name && scene.boundary_of(joint.bodies[1 - side]) != nullptr)
        feet.insert(joint.bodies[1 - side]);
  return feet.size() == 1 && std::any_of(scene.bodies.begin(), scene.bodies.end(),
                                         [&](const BodySpec& other) { return other.mass > spec.mass; });
}

// The deepest place of a shape below the ground at the start [m]; negative: above it.
double depth_at_start(const Scene& scene, const Mechanism& mechanism, int body, const UnheldShape& shape) {
  const BodyState& start = mechanism.model.initial(body);
  const Eigen::Matrix3d R_WB = rotation_matrix(start.L);
  const std::unique_ptr<Terrain> terrain = mechanism.terrain ? std::make_unique<Terrain>(*mechanism.terrain) : nullptr;
  double deepest = -shape.size;
  for (const Eigen::Vector3d& s : shape.outline) {
    const Eigen::Vector3d p = start.r + R_WB * s;
    const double above = terrain ? terrain->distance(p) : scene.ground.normal().dot(p - scene.ground.point());
    deepest = std::max(deepest, -above);
  }
  return deepest;
}

}  // namespace

std::optional<UnheldShape> unheld_shape(const Scene& scene, const BodySpec& spec) {
  if (!scene.ground.is_flat() || scene.boundary_of(spec.name) != nullptr || stands_still(scene, spec.name))
    return std::nullopt;
  UnheldShape shape{0.0, shape_outline(spec)};
  for (Eigen::Vector3d& p : shape.outline) {
    p = spec.orientation.conjugate() * (p - spec.position);
    shape.size = std::max(shape.size, p.norm());
  }
  if (shape.outline.empty()) return std::nullopt;
  return shape;
}

void add_hulls(const Scene& scene, const std::vector<FlexibleBody>& flexible, Mechanism& mechanism) {
  if (!scene.ground.is_flat() || !scene.ground.bodies().empty() || !scene.initial.joints.empty()) return;
  LoweredGround ground(scene, mechanism.terrain != nullptr);
  std::vector<BodyBoundary> surfaces;
  for (const BodySpec& spec : scene.bodies) {
    const std::optional<UnheldShape> shape = unheld_shape(scene, spec);
    const int body = scene.body_index(spec.name);
    if (!shape || spec.shape->kind == ShapeKind::kPoints || flexible[body].modal) continue;
    if (stands_on_another(scene, spec)) continue;
    if (depth_at_start(scene, mechanism, body, *shape) > 0.0) continue;  // it is meant to be there
    BoundarySpec boundary;
    boundary.body = spec.name;
    boundary.surface = SurfaceSpec();
    boundary.surface->element_size = kEdge * shape->size;
    std::vector<std::string> unused;
    surfaces.push_back(build_boundary(scene, boundary, FlexibleBody(), unused));
    mechanism.hulls.push_back({body, kHullDepth * shape->size});
  }
  std::vector<SoilSurface> touching;
  for (std::size_t k = 0; k < surfaces.size(); ++k) {
    const double below = mechanism.hulls[k].below;
    add_plane_contact(scene, surfaces[k], "hull/", below, ground.at(below), mechanism);
    touching.push_back({&surfaces[k], below, ground.at(below)});
  }
  add_soil_contacts(scene, touching, "hull/", mechanism);
}

}  // namespace footfall
