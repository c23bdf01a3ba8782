// Mass, mass centre and inertia of every body.
#include <algorithm>
#include <optional>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/fe/triangle_mesh.h"
#include "mbd_solver/model/mass_properties.h"
#include "mbd_solver/model/rotation.h"
#include "mbd_solver/scene/boundary_surface.h"
#include "mbd_solver/scene/resolve.h"

namespace footfall {

namespace {

// Which keys a shape needs; all others of the shape must stay away.
std::vector<std::string> needed_keys(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::kBox: return {"size", "centre"};
    case ShapeKind::kTube: return {"from", "to", "diameter", "wall"};
    case ShapeKind::kRod: return {"from", "to", "diameter"};
    case ShapeKind::kDisc: return {"centre", "axis", "radius", "thickness"};
    case ShapeKind::kDish: return {"centre", "axis", "radius", "depth", "thickness"};
    case ShapeKind::kSphere: return {"centre", "radius"};
    case ShapeKind::kCylinder: return {"centre", "axis", "radius", "length"};
    case ShapeKind::kCapsule: return {"from", "to", "diameter"};
    case ShapeKind::kMesh: return {"file", "scale", "position", "orientation"};
    case ShapeKind::kPoints: return {"points"};
  }
  return {};
}

bool check_shape(const BodySpec& body, Findings& findings) {
  const ShapeSpec& shape = *body.shape;
  if (!body.source.good("shape.kind")) return false;  // reported when it was read
  const std::vector<std::string> needed = needed_keys(shape.kind);
  const int before = findings.error_count();
  for (const std::string& key : needed) {
    const bool has_default =
        key == "axis" || key == "centre" || key == "scale" || key == "position" || key == "orientation";
    if (!has_default && !body.source.given("shape." + key))
      findings.error(body.source, "shape." + key, "is missing; a " + std::string(name_of(shape.kind)) + " needs it");
  }
  for (const char* key : {"centre", "axis", "from", "to", "size", "diameter", "wall", "radius", "length", "thickness",
                          "depth", "points", "file", "scale", "position", "orientation"}) {
    if (body.source.given(std::string("shape.") + key) && std::find(needed.begin(), needed.end(), key) == needed.end())
      findings.error(body.source, std::string("shape.") + key,
                     "means nothing for a " + std::string(name_of(shape.kind)) + "; leave it out");
  }
  const std::set<std::string>& refused = body.source.refused;
  if (std::any_of(refused.begin(), refused.end(), [](const std::string& k) { return k.rfind("shape.", 0) == 0; }))
    return false;
  const bool long_body =
      shape.kind == ShapeKind::kTube || shape.kind == ShapeKind::kRod || shape.kind == ShapeKind::kCapsule;
  if (long_body && !((shape.to - shape.from).norm() > 0.0))
    findings.error(body.source, "shape.to", "is the same point as \"from\"");
  if (shape.kind == ShapeKind::kTube && 2.0 * shape.wall > shape.diameter)
    findings.error(
        body.source, "shape.wall",
        "is " + number_text(shape.wall) + " m, expected at most half the diameter; for a solid bar use kind = \"rod\"");
  if (shape.kind == ShapeKind::kDish && shape.depth > shape.radius)
    findings.error(body.source, "shape.depth", "is " + number_text(shape.depth) + " m, expected at most the radius");
  if (shape.kind == ShapeKind::kPoints && shape.points.size() < 3)
    findings.error(body.source, "shape.points",
                   "are " + std::to_string(shape.points.size()) + ", expected at least three, not on one line");
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

// Density of the body's material, or nothing after a finding.
std::optional<double> density_of(const Scene& scene, const BodySpec& body, Findings& findings) {
  std::vector<std::string> names;
  for (const MaterialSpec& material : scene.materials) {
    if (material.name == body.material)
      return material.density > 0.0 ? std::optional<double>(material.density) : std::nullopt;
    names.push_back(material.name);
  }
  findings.error(body.source, "material",
                 "there is no material \"" + body.material + "\"." + known_names("materials", body.material, names));
  return std::nullopt;
}

// The body's numbers; where the mass is not known yet, those of mass 1. False: they are not known, as was reported.
bool resolve_body(const Scene& scene, BodySpec& body, Findings& findings) {
  const bool mass_given = body.source.given("mass");
  const bool inertia_given = body.source.given("inertia");
  if (!body.shape) {
    const std::string expected = "; give it, or give a shape (with a material, or with the mass)";
    if (!mass_given) findings.error(body.source, "mass", "is missing" + expected);
    if (!inertia_given) findings.error(body.source, "inertia", "is missing" + expected);
    if (!body.source.given("position"))
      findings.error(body.source, "position", "of the mass centre is missing" + expected);
    return body.source.good("mass") && inertia_given && body.source.given("position");
  }
  if (!check_shape(body, findings)) return false;
  if (mass_given && !body.mass_is_remainder && !(body.mass > 0.0)) return false;  // reported when it was read
  double density = 1.0;
  if (!mass_given) {
    if (body.material.empty() || body.shape->kind == ShapeKind::kPoints) {
      findings.error(
          body.source, "mass",
          std::string("is missing; give the mass") +
              (body.shape->kind == ShapeKind::kPoints ? " (points have no volume)" : ", or a material for the shape"));
      return false;
    }
    const std::optional<double> found = density_of(scene, body, findings);
    if (!found) return false;
    density = *found;
  }
  MassProperties p;
  try {
    p = shape_properties(body, density);
  } catch (const InputError& e) {
    findings.error(body.source, "shape", e.what());
    return false;
  }
  if (mass_given && !body.mass_is_remainder) p = with_mass(p, body.mass);
  if (body.mass_is_remainder) p = with_mass(p, 1.0);
  body.mass = p.mass;
  if (!body.source.given("position")) body.position = p.centre;
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
      findings.error(body.source, "mass",
                     "is the remainder, but so is that of \"" + rest->name + "\"; only one body can be");
    } else {
      rest = &body;
    }
  }
  if (!rest) {
    if (scene.total_mass && std::abs(others - *scene.total_mass) > 1e-6 * *scene.total_mass && !findings.has_errors())
      findings.error(scene.source, "total_mass",
                     "is " + number_text(*scene.total_mass) + " kg, but the bodies weigh " + number_text(others) +
                         " kg; leave it out, or let one body have mass = \"remainder\"");
    return;
  }
  if (!scene.total_mass) {
    findings.error(rest->source, "mass",
                   "is the remainder of a total_mass that is not given; set total_mass at the top of the scene");
    return;
  }
  const double mass = *scene.total_mass - others;
  if (!(mass > 0.0)) {
    findings.error(rest->source, "mass",
                   "is the remainder, but the other bodies already weigh " + number_text(others) +
                       " kg of the total_mass of " + number_text(*scene.total_mass) + " kg");
    return;
  }
  rest->mass = mass;
  if (!rest->source.given("inertia")) rest->inertia *= mass;
}

// A real body: symmetric positive definite, and no axis heavier than the other two together.
void check_inertia(const BodySpec& body, Findings& findings) {
  const Eigen::Vector3d e = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(body.inertia).eigenvalues();
  if (!(e[0] > 0.0)) {
    findings.error(body.source, "inertia",
                   "is not positive definite (smallest principal value " + number_text(e[0]) +
                       " kg m2); expected [Ixx, Iyy, Izz] > 0, in kg m2 about the mass centre");
  } else if (e[2] > (e[0] + e[1]) * (1.0 + 1e-9)) {
    findings.error(body.source, "inertia",
                   "belongs to no real body: the largest principal value " + number_text(e[2]) +
                       " kg m2 exceeds the sum of the other two, " + number_text(e[0] + e[1]) + " kg m2");
  }
}

}  // namespace

void resolve_masses(Scene& scene, Findings& findings) {
  bool known = true;
  for (BodySpec& body : scene.bodies) known = resolve_body(scene, body, findings) && known;
  if (!known) return;  // masses are not known: the rest would only repeat it
  resolve_remainder(scene, findings);
  for (const BodySpec& body : scene.bodies) {
    if (body.mass > 0.0 && body.source.refused.count("inertia") == 0) check_inertia(body, findings);
  }
}

}  // namespace footfall
