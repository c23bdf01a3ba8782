// Contacts with planes, with the walls of the script, and of bodies with each other.

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/build/codes.h"
#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

// Points deeper than this share of the smaller body have passed through and are not pushed back.
constexpr double kDepth = 0.1;
// So many points decide on which side of a surface a body is.
constexpr std::size_t kSamples = 32;

ContactLaw contact_law(const ContactLawSpec& spec, const Scene& scene) {
  ContactLaw law;
  law.friction = spec.friction;
  if (spec.friction_speed) {
    law.slip_speed = *spec.friction_speed;
    law.stick_time = 0.0;
  }
  // Hertz on a flat: k = 4/3 E* sqrt(R), E* = E / (1 - nu^2).
  law.stiffness = spec.stiffness ? *spec.stiffness
                                 : 4.0 / 3.0 * spec.young.value_or(0.0) / (1.0 - spec.poisson * spec.poisson) *
                                       std::sqrt(spec.contact_radius);
  const double speed = spec.impact_speed.value_or(scene.initial.velocity.norm());
  law.damping = spec.damping       ? *spec.damping
                : spec.restitution ? contact_damping_for_restitution(*spec.restitution, speed > 0.0 ? speed : 1.0)
                                   : 0.0;
  return law;
}

RigidPlane::Parameters plane_parameters(const ContactLaw& law, const Eigen::Vector3d& point,
                                        const Eigen::Vector3d& normal) {
  RigidPlane::Parameters p;
  static_cast<ContactLaw&>(p) = law;
  p.point = point;
  p.normal = normal;
  return p;
}

const BodyBoundary& boundary_of(const Mechanism& mechanism, int body) {
  for (const BodyBoundary& entry : mechanism.boundaries)
    if (entry.body == body) return entry;
  FOOTFALL_DEMAND(false);
}

double reach(const BodyBoundary& entry) { return entry.boundary.rho0().colwise().norm().maxCoeff(); }

bool is_ball(const Scene& scene, const BodyBoundary& entry) {
  const BodySpec& body = scene.bodies[static_cast<std::size_t>(entry.body)];
  return body.shape && body.shape->kind == ShapeKind::kSphere && entry.boundary.segments().empty() &&
         entry.boundary.mode_count() == 0;
}

// In the frame of the body; null for a flexible one.
std::shared_ptr<const ContactSurface> surface_of(const Scene& scene, const Mechanism& mechanism,
                                                 const BodyBoundary& entry) {
  const ModalBoundary& boundary = entry.boundary;
  if (boundary.mode_count() > 0) return nullptr;
  auto surface = std::make_shared<ContactSurface>();
  for (const BeamSegment& segment : boundary.segments())
    surface->add_capsule(boundary.rho0().col(segment.start), boundary.rho0().col(segment.end), segment.radius);
  if (boundary.triangles().empty()) return surface;
  const ShapeSpec* const shape = round_shape(scene, entry);
  const std::vector<ContactPoint> places = contact_places(scene, mechanism.model.body(entry.body), entry);
  if (shape != nullptr) {
    surface->add_capsule(places.front().marker.s0,
                         shape->kind == ShapeKind::kSphere ? places.front().marker.s0 : places[1].marker.s0,
                         places.front().radius);
  } else {
    surface->add_triangles(boundary.rho0(), boundary.triangles());
  }
  return surface;
}

// Some of the points, in the frame of a body (or of the walls, kGround), at the start.
std::vector<Eigen::Vector3d> places_at_start(const Model& model, const std::vector<ContactPoint>& places, int frame) {
  std::vector<Eigen::Vector3d> out;
  const std::size_t stride = std::max<std::size_t>(1, places.size() / kSamples);
  for (std::size_t i = 0; i < places.size(); i += stride) {
    const Eigen::Vector3d p = model.initial_position(places[i].marker);
    if (frame == kGround) {
      out.push_back(p);
      continue;
    }
    const BodyState& body = model.initial(frame);
    out.push_back(rotation_matrix(body.L).transpose() * (p - body.r));
  }
  return out;
}

// The points of A against the surface of B; nothing where B has none.
void add_side(const Scene& scene, const Mechanism& mechanism, const BodyBoundary& A, const BodyBoundary& B, int slot,
              std::vector<SurfaceContact::Side>& sides) {
  auto seen = std::make_shared<SurfaceSeen>();
  seen->surface = surface_of(scene, mechanism, B);
  if (seen->surface == nullptr) return;
  SurfaceContact::Side side;
  side.slot = slot;
  side.points = contact_places(scene, mechanism.model.body(A.body), A);
  double across = 0.0;
  seen->sides = seen->surface->sides_of(places_at_start(mechanism.model, side.points, B.body), across);
  side.seen = seen;
  side.depth = kDepth * std::min(reach(A), reach(B));
  sides.push_back(std::move(side));
}

void add_pair(const Scene& scene, const ContactSpec& spec, Mechanism& mechanism) {
  const BodyBoundary& A = boundary_of(mechanism, scene.body_index(spec.between[0]));
  const BodyBoundary& B = boundary_of(mechanism, scene.body_index(spec.between[1]));
  std::vector<SurfaceContact::Side> sides;
  // A ball touches a surface exactly: then the points of the other body need not be tested against the ball.
  const bool a_is_ball = is_ball(scene, A), b_is_ball = is_ball(scene, B);
  const bool b_bends = B.boundary.mode_count() > 0;
  if (a_is_ball || !b_is_ball) add_side(scene, mechanism, A, B, 0, sides);
  if (!a_is_ball || b_bends) add_side(scene, mechanism, B, A, 1, sides);
  ContactEntry entry;
  entry.body_1 = A.body;
  entry.body_2 = B.body;
  entry.force = mechanism.model.add_force(
      std::make_unique<SurfaceContact>("contact/" + spec.between[0] + "/" + spec.between[1], A.body, B.body,
                                       std::move(sides), contact_law(spec, scene)));
  mechanism.contacts.push_back(std::move(entry));
}

void add_walls(const Scene& scene, const ContactSpec& spec, Mechanism& mechanism) {
  for (const BodyBoundary& A : mechanism.boundaries) {
    const std::vector<std::string>& wanted = spec.bodies;
    if (!wanted.empty() && std::count(wanted.begin(), wanted.end(), A.boundary.name()) == 0) continue;
    ContactEntry entry;
    entry.body_1 = A.body;
    entry.walls = std::make_shared<SurfaceSeen>();
    entry.places = contact_places(scene, mechanism.model.body(A.body), A);
    SurfaceContact::Side side;
    side.points = entry.places;
    side.seen = entry.walls;
    side.depth = kDepth * reach(A);
    entry.force = mechanism.model.add_force(
        std::make_unique<SurfaceContact>("walls/" + A.boundary.name(), A.body, kGround,
                                         std::vector<SurfaceContact::Side>{std::move(side)}, contact_law(spec, scene)));
    mechanism.contacts.push_back(std::move(entry));
  }
}

void add_one_plane(const BodyBoundary& entry, const std::string& name, const RigidPlane::Parameters& p,
                   Mechanism& mechanism) {
  mechanism.planes.push_back(
      mechanism.model.add_force(std::make_unique<RigidPlane>(name, entry.points, p, entry.rims)));
  mechanism.plane_bodies.push_back(entry.body);
}

}  // namespace

void add_plane(const Scene& scene, Mechanism& mechanism) {
  if (scene.ground.kind != GroundKind::kPlane) return;
  const PlaneSpec& spec = *scene.ground.plane;
  const RigidPlane::Parameters p = plane_parameters(contact_law(spec, scene), spec.point, spec.normal);
  for (const BodyBoundary& entry : mechanism.boundaries) {
    if (entry.points.empty() && entry.rims.empty()) continue;
    add_one_plane(entry, "ground/" + entry.boundary.name(), p, mechanism);
  }
}

void add_contacts(const Scene& scene, Mechanism& mechanism) {
  for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
    const ContactSpec& spec = scene.contacts[i];
    if (spec.ignore) continue;
    if (spec.walls) {
      add_walls(scene, spec, mechanism);
    } else if (spec.with_plane()) {
      const int body = scene.body_index(spec.between[0]);
      BodyBoundary touching{body, boundary_of(mechanism, body).boundary, {}, {}};
      add_plane_places(scene, mechanism.model.body(body), touching);
      add_one_plane(touching, "plane_" + std::to_string(i + 1) + "/" + spec.between[0],
                    plane_parameters(contact_law(spec, scene), spec.point, spec.normal), mechanism);
    } else {
      add_pair(scene, spec, mechanism);
    }
  }
}

void set_walls(const std::vector<StaticWall>& walls, Mechanism& mechanism) {
  std::shared_ptr<ContactSurface> surface;
  for (const ContactEntry& entry : mechanism.contacts) {
    if (entry.walls == nullptr) continue;
    entry.walls->surface = nullptr;
    if (surface == nullptr) {
      surface = std::make_shared<ContactSurface>();
      for (const StaticWall& wall : walls)
        if (wall.corners.empty()) surface->add_plane(wall.point, wall.normal);
      for (const StaticWall& wall : walls) {
        if (wall.corners.empty()) continue;
        const auto count = static_cast<Eigen::Index>(wall.corners.size());
        const Eigen::Matrix3Xd vertices = Eigen::Map<const Eigen::Matrix3Xd>(wall.corners.front().data(), 3, count);
        std::vector<Eigen::Vector3i> triangles;
        for (int i = 0; i < static_cast<int>(count); i += 3) triangles.emplace_back(i, i + 1, i + 2);
        try {
          surface->add_triangles(vertices, triangles);
        } catch (const InputError& error) {
          throw InputError("mesh " + wall.name + " of the script: " + error.what());
        }
      }
    }
    if (surface->empty()) continue;
    double across = 0.0;
    entry.walls->sides = surface->sides_of(places_at_start(mechanism.model, entry.places, kGround), across);
    const std::string& name = mechanism.model.body(entry.body_1).name();
    if (across > kDepth * reach(boundary_of(mechanism, entry.body_1)))
      throw InputError(code::kAcrossWall,
                       "contacts: body \"" + name + "\" is on both sides of a wall of the script at the start, by " +
                           number_text(across) +
                           " m, so the wall cannot hold it; move it, or exclude it from the entry with walls = true "
                           "(bodies)");
    entry.walls->surface = surface;
  }
}

}  // namespace footfall
