// Mass, mass centre and inertia of every body.
#include <optional>

#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/fe/triangle_mesh.h"
#include "mbd_solver/model/mass_properties.h"
#include "mbd_solver/model/rotation.h"
#include "mbd_solver/scene/boundary_surface.h"
#include "mbd_solver/scene/resolve.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {

using namespace code;

namespace {

// The keys of each kind of shape. Those before "|" are required.
std::vector<std::string> keys_of(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::kBox: return {"size", "|", "centre"};
    case ShapeKind::kTube: return {"from", "to", "diameter", "wall"};
    case ShapeKind::kRod:
    case ShapeKind::kCapsule: return {"from", "to", "diameter"};
    case ShapeKind::kDisc: return {"radius", "thickness", "|", "centre", "axis"};
    case ShapeKind::kDish: return {"radius", "depth", "thickness", "|", "centre", "axis"};
    case ShapeKind::kSphere: return {"radius", "|", "centre"};
    case ShapeKind::kCylinder: return {"radius", "length", "|", "centre", "axis"};
    case ShapeKind::kMesh: return {"file", "|", "scale", "position", "orientation"};
    case ShapeKind::kPoints: return {"points"};
  }
  return {};
}

bool check_shape(const BodySpec& body, Findings& findings) {
  const ShapeSpec& shape = *body.shape;
  const EntryFindings at(findings, body.source);
  if (!body.source.good("shape.kind")) return false;  // reported when it was read
  const std::vector<std::string> keys = keys_of(shape.kind);
  const std::string kind(name_of(shape.kind));
  const int before = findings.error_count();
  for (auto key = keys.begin(); key != keys.end() && *key != "|"; ++key)
    at.missing_if(!at.given("shape." + *key), "shape." + *key, "a " + kind + " needs it");
  for (const auto& [path, line] : body.source.lines) {
    const std::string key = path.rfind("shape.", 0) == 0 ? path.substr(6) : "kind";
    at.no_effect_if(key != "kind" && !is_in(keys, key), path, "a " + kind);
  }
  const std::set<std::string>& refused = body.source.refused;
  if (std::any_of(refused.begin(), refused.end(), [](const std::string& k) { return k.rfind("shape.", 0) == 0; }))
    return false;
  const bool long_body =
      shape.kind == ShapeKind::kTube || shape.kind == ShapeKind::kRod || shape.kind == ShapeKind::kCapsule;
  at.error_if(long_body && !((shape.to - shape.from).norm() > 0.0), kShape, "shape.to",
              "is the same point as \"from\", expected a different one");
  at.error_if(
      shape.kind == ShapeKind::kTube && 2.0 * shape.wall > shape.diameter, kShape, "shape.wall",
      "is " + number_text(shape.wall) + " m, expected at most half the diameter; for a solid bar use kind = \"rod\"");
  at.error_if(shape.kind == ShapeKind::kDish && shape.depth > shape.radius, kShape, "shape.depth",
              "is " + number_text(shape.depth) + " m, expected at most the radius");
  at.error_if(shape.kind == ShapeKind::kPoints && shape.points.size() < 3, kShape, "shape.points",
              "contains " + std::to_string(shape.points.size()) + " points, expected at least three, not on one line");
  return findings.error_count() == before;
}

MassProperties turned(MassProperties p, const Eigen::Vector3d& axis, const Eigen::Vector3d& centre) {
  const Eigen::Matrix3d R = shortest_turn(Eigen::Vector3d::UnitZ(), axis.normalized());
  p.centre = R * p.centre + centre;
  p.inertia = R * p.inertia * R.transpose();
  return p;
}

// Thin spherical cap of rim radius a and depth h, lowest point at the origin, opening along z. On a sphere of radius s
// = (a^2 + h^2) / (2h) equal heights hold equal areas 2 pi s dz, so all moments are means over z in [0, h] with r^2 = 2
// s z - z^2.
MassProperties dish_properties(const ShapeSpec& shape, double density) {
  const double a = shape.radius, h = shape.depth, s = (a * a + h * h) / (2.0 * h);
  MassProperties p;
  p.mass = density * shape.thickness * 2.0 * kPi * s * h;
  p.centre = {0.0, 0.0, 0.5 * h};
  const double r2 = s * h - h * h / 3.0;
  const double across = 0.5 * r2 + h * h / 3.0 - 0.25 * h * h;
  p.inertia = Eigen::Vector3d(across, across, r2).asDiagonal();
  p.inertia *= p.mass;
  return p;
}

// Equal point masses of total mass 1.
MassProperties point_properties(const std::vector<Eigen::Vector3d>& points) {
  MassProperties p;
  p.mass = 1.0;
  for (const Eigen::Vector3d& x : points) p.centre += x / static_cast<double>(points.size());
  for (const Eigen::Vector3d& x : points) {
    const Eigen::Vector3d d = x - p.centre;
    p.inertia +=
        (d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose()) / static_cast<double>(points.size());
  }
  return p;
}

// In D. A box's edges are along the body's axes.
MassProperties shape_properties(const BodySpec& body, double density) {
  const ShapeSpec& s = *body.shape;
  switch (s.kind) {
    case ShapeKind::kBox: {
      MassProperties p = box_properties(s.size, density);
      const Eigen::Matrix3d R = body.orientation.toRotationMatrix();
      p.inertia = R * p.inertia * R.transpose();
      p.centre = s.centre;
      return p;
    }
    case ShapeKind::kTube: return tube_properties(s.from, s.to, s.diameter, s.wall, density);
    case ShapeKind::kRod: return rod_properties(s.from, s.to, s.diameter, density);
    case ShapeKind::kDisc: return turned(disc_properties(s.radius, s.thickness, density), s.axis, s.centre);
    case ShapeKind::kDish: return turned(dish_properties(s, density), s.axis, s.centre);
    case ShapeKind::kSphere: return turned(sphere_properties(s.radius, density), Eigen::Vector3d::UnitZ(), s.centre);
    case ShapeKind::kCylinder: return turned(disc_properties(s.radius, s.length, density), s.axis, s.centre);
    case ShapeKind::kCapsule: return capsule_properties(s.from, s.to, s.diameter, density);
    case ShapeKind::kMesh: return polyhedron_properties(mesh_of_shape(s), density, s.file);
    case ShapeKind::kPoints: break;
  }
  return point_properties(s.points);
}

// The body's numbers; where the mass is not known yet, those of mass 1. False: unknown, which is reported.
bool resolve_body(const Scene& scene, BodySpec& body, Findings& findings) {
  const EntryFindings at(findings, body.source);
  const bool mass_given = at.given("mass"), inertia_given = at.given("inertia");
  if (!body.shape) {
    for (const char* key : {"mass", "inertia", "position"})
      at.missing_if(!at.given(key), key, "give it, or give a shape (with a material, or with the mass)");
    return body.source.good("mass") && inertia_given && at.given("position");
  }
  if (!check_shape(body, findings)) return false;
  if (mass_given && !body.mass_is_remainder && !(body.mass > 0.0)) return false;  // reported when it was read
  double density = 1.0;
  if (!mass_given) {
    const bool points = body.shape->kind == ShapeKind::kPoints;
    if (body.material.empty() || points) {
      at.error(
          kMissingKey, "mass",
          std::string("is missing; give it") + (points ? ": points have no volume" : ", or a material for the shape"));
      return false;
    }
    check_known(at, kUnknownMaterial, "material", "material", "materials", body.material, names_in(scene.materials));
    density = 0.0;
    for (const MaterialSpec& material : scene.materials)
      if (material.name == body.material) density = material.density;
    if (!(density > 0.0)) return false;  // unknown or refused
  }
  MassProperties p;
  try {
    p = shape_properties(body, density);
  } catch (const InputError& e) {
    findings.coded_error(body.source, "shape", e.what());
    return false;
  }
  if (mass_given && !body.mass_is_remainder) p = with_mass(p, body.mass);
  if (body.mass_is_remainder) p = with_mass(p, 1.0);
  body.mass = p.mass;
  if (!at.given("position")) body.position = p.centre;
  const Eigen::Matrix3d R = body.orientation.toRotationMatrix();
  if (!inertia_given) body.inertia = R.transpose() * p.inertia * R;
  return true;
}

void resolve_remainder(Scene& scene, Findings& findings) {
  BodySpec* rest = nullptr;
  double others = 0.0;
  for (BodySpec& body : scene.bodies) {
    if (!body.mass_is_remainder) {
      others += body.mass;
    } else if (rest) {
      findings.error(kTotalMass, body.source, "mass",
                     "is the remainder, as is that of \"" + rest->name + "\"; only one body can have it");
    } else {
      rest = &body;
    }
  }
  if (!rest) {
    if (scene.total_mass && std::abs(others - *scene.total_mass) > 1e-6 * *scene.total_mass && !findings.has_errors())
      findings.error(kTotalMass, scene.source, "total_mass",
                     "is " + number_text(*scene.total_mass) + " kg, but the bodies weigh " + number_text(others) +
                         " kg; remove it, or let one body have mass = \"remainder\"");
    return;
  }
  const EntryFindings at(findings, rest->source);
  const double mass = scene.total_mass.value_or(0.0) - others;
  if (!scene.total_mass) {
    at.error(kNeedsOtherKey, "mass", "is the remainder of total_mass, which is missing at the top of the scene");
  } else if (!(mass > 0.0)) {
    at.error(kTotalMass, "mass",
             "is the remainder, but the other bodies weigh " + number_text(others) + " kg of the total_mass of " +
                 number_text(*scene.total_mass) + " kg");
  } else {
    rest->mass = mass;
    if (!rest->source.given("inertia")) rest->inertia *= mass;
  }
}

// A real body: symmetric positive definite, and no principal value above the sum of the other two.
void check_inertia(const BodySpec& body, Findings& findings) {
  const Eigen::Vector3d e = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(body.inertia).eigenvalues();
  const EntryFindings at(findings, body.source);
  if (!(e[0] > 0.0)) {
    at.error(kInertia, "inertia",
             "is not positive definite (smallest principal value " + number_text(e[0]) +
                 " kg m2), expected [Ixx, Iyy, Izz] > 0, in kg m2 about the mass centre");
  } else if (e[2] > (e[0] + e[1]) * (1.0 + 1e-9)) {
    at.error(kInertia, "inertia",
             "has a largest principal value of " + number_text(e[2]) +
                 " kg m2, expected at most the sum of the other two, " + number_text(e[0] + e[1]) + " kg m2");
  }
}

}  // namespace

void resolve_masses(Scene& scene, Findings& findings) {
  bool known = true;
  for (BodySpec& body : scene.bodies) known = resolve_body(scene, body, findings) && known;
  if (!known) return;  // the masses are unknown, which is reported
  resolve_remainder(scene, findings);
  for (const BodySpec& body : scene.bodies) {
    if (body.mass > 0.0 && body.source.refused.count("inertia") == 0) check_inertia(body, findings);
  }
}

}  // namespace footfall
