// Boundaries, contacts, ground and particles.
#include <cmath>

#include "coupler/base/text.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {

using namespace code;

namespace {

bool is_flexible(const BodySpec& body) { return body.flexible && body.flexible->enabled; }

void check_surface(const BodySpec& body, const SurfaceSpec& surface, const EntryFindings& at) {
  const bool own_mesh = is_flexible(body) && (!body.flexible->mesh.empty() || !body.flexible->file.empty());
  const bool from_file = !surface.file.empty();
  at.error_if(
      !from_file && !own_mesh && (!body.shape || body.shape->kind == ShapeKind::kPoints), kNoSurface, "surface",
      "cannot be generated: body \"" + body.name + "\" has no shape with a surface; give surface.file or a shape");
  const bool shape_is_mesh = body.shape && body.shape->kind == ShapeKind::kMesh && !own_mesh;
  at.no_effect_if((from_file || shape_is_mesh) && at.given("surface.element_size") && surface.from_script.empty(),
                  "surface.element_size", "a mesh from a file");
  for (const char* key : {"surface.scale", "surface.position", "surface.orientation"})
    at.error_if(!from_file && at.given(key), kKeyWithoutEffect, key, "belongs to a surface from a file; remove it");
  if (!at.given("surface.faces")) return;
  const bool drawn = !from_file && body.shape && !own_mesh;
  const bool disc = drawn && body.shape->kind == ShapeKind::kDisc, dish = drawn && body.shape->kind == ShapeKind::kDish;
  at.error_if(!disc && !dish, kKeyWithoutEffect, "surface.faces",
              "belongs to a disc or dish, which the surface of \"" + body.name + "\" is not; remove it");
  at.error_if(dish && surface.faces == SurfaceFaces::kBoth, kUnknownChoice, "surface.faces",
              "is \"both\", but a dish has its mid-surface only; expected \"middle\"");
}

void check_beams(const BodySpec& body, const BeamsSpec& beams, const EntryFindings& at) {
  const bool round = body.shape && (body.shape->kind == ShapeKind::kTube || body.shape->kind == ShapeKind::kRod);
  const bool frame = is_flexible(body) && !body.flexible->nodes.empty();
  at.missing_if(!round && !frame && beams.points.empty(), "beams.points", "only a tube or rod has an axis to follow");
  at.error_if(beams.points.size() == 1, kWrongCount, "beams.points", "is one point, expected two or more");
  at.missing_if(!round && !(beams.radius > 0.0), "beams.radius", "only a tube or rod has a diameter");
}

void check_boundary(const Scene& scene, const BoundarySpec& boundary, const EntryFindings& at) {
  at.error_if(!boundary.surface && !boundary.beams, kEmptyEntry, "",
              "has neither a surface nor beams; give surface = {} or beams = {}");
  for (const BodySpec& body : scene.bodies) {
    if (body.name != boundary.body) continue;
    if (boundary.surface) check_surface(body, *boundary.surface, at);
    if (boundary.beams) check_beams(body, *boundary.beams, at);
    return;
  }
}

// prefix: before the keys in a message.
void check_law(const Scene& scene, const std::string& prefix, const ContactLawSpec& law, const EntryFindings& at) {
  at.error_if(law.young && law.stiffness, kConflictingKeys, prefix + "stiffness",
              "follows from young, which is given as well; keep one of the two");
  at.missing_if(!law.young && !law.stiffness, prefix + "young", "give young [Pa] or stiffness [N/m^1.5]");
  at.error_if(law.restitution && law.damping, kConflictingKeys, prefix + "damping",
              "follows from restitution, which is given as well; keep one of the two");
  at.error_if(law.restitution && *law.restitution <= 0.0, kOutOfRange, prefix + "restitution",
              "is 0, expected more than 0, at most 1");
  at.missing_if(law.restitution && *law.restitution < 1.0 && !law.impact_speed && scene.initial.velocity.isZero(),
                prefix + "impact_speed",
                "the coefficient of restitution holds at one impact speed, and initial.velocity does not give it");
  at.error_if(!(law.poisson > -1.0 && law.poisson < 0.5), kOutOfRange, prefix + "poisson",
              "is " + number_text(law.poisson) + ", expected more than -1 and less than 0.5");
}

void check_has_boundary(const Scene& scene, const EntryFindings& at, const char* key, const std::string& name) {
  const std::vector<std::string> names = boundary_names(scene);
  if (!is_in(names, name))
    at.error(kUnknownBoundary, key,
             "\"" + name + "\" has no entry in [[boundaries]]." + known_names("boundaries", name, names));
}

// A flexible body in a scene that is not rigid as a whole.
bool deforms(const Scene& scene, const std::string& name) {
  return scene.flexible && std::any_of(scene.bodies.begin(), scene.bodies.end(),
                                       [&](const BodySpec& body) { return body.name == name && is_flexible(body); });
}

void check_between(const Scene& scene, const ContactSpec& contact, const EntryFindings& at) {
  if (contact.between.size() != 2) {
    at.error(kWrongCount, "between",
             "contains " + std::to_string(contact.between.size()) +
                 " names, expected two bodies, or a body and \"plane\" (or walls = true instead)");
    return;
  }
  const std::string &first = contact.between[0], &second = contact.between[1];
  check_has_boundary(scene, at, "between", first);
  if (!contact.with_plane()) check_has_boundary(scene, at, "between", second);
  at.error_if(first == second, kListedTwice, "between", "contains \"" + first + "\" twice");
  at.error_if(contact.ignore && contact.with_plane(), kConflictingKeys, "ignore",
              "is for two bodies; a body without contact with a plane needs no entry");
  at.error_if(!contact.ignore && deforms(scene, first) && deforms(scene, second), kFlexibleContact, "between",
              "names two flexible bodies; expected at most one, whose nodes touch the surface of the rigid one");
}

void check_contacts(const Scene& scene, Findings& findings) {
  for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
    const ContactSpec& contact = scene.contacts[i];
    const EntryFindings at(findings, contact.source);
    if (contact.walls) {
      at.error_if(!contact.between.empty(), kConflictingKeys, "walls", "excludes between; give each of them an entry");
      at.error_if(contact.ignore, kConflictingKeys, "ignore", "is for two bodies, not for walls");
      at.error_if(!scene.touches_particles(), kGroundIncomplete, "walls",
                  "are those of a LIGGGHTS script, but ground.kind is not \"particles\"");
      at.error_if(scene.boundaries.empty(), kGroundIncomplete, "walls", "touch [[boundaries]], but the scene has none");
      for (const std::string& name : contact.bodies) check_has_boundary(scene, at, "bodies", name);
    } else {
      check_between(scene, contact, at);
      at.error_if(!contact.bodies.empty(), kConflictingKeys, "bodies",
                  "belongs to walls = true; between names its bodies");
    }
    for (const char* key : {"point", "normal"})
      at.error_if(at.given(key) && !contact.with_plane(), kKeyWithoutEffect, key,
                  "belongs to a plane: between = [\"BODY\", \"plane\"]");
    if (!contact.ignore) check_law(scene, "", contact, at);
    for (std::size_t j = 0; j < i; ++j) {
      const ContactSpec& other = scene.contacts[j];
      const bool same = contact.between.size() == 2 && !contact.with_plane() && other.between.size() == 2 &&
                        std::is_permutation(contact.between.begin(), contact.between.end(), other.between.begin());
      const bool shared = contact.bodies.empty() || other.bodies.empty() ||
                          std::find_first_of(contact.bodies.begin(), contact.bodies.end(), other.bodies.begin(),
                                             other.bodies.end()) != contact.bodies.end();
      at.error_if(same || (contact.walls && other.walls && shared), kListedTwice, contact.walls ? "walls" : "between",
                  "are in an earlier entry already: the contact would count twice");
    }
  }
}

}  // namespace

void check_contact(const Scene& scene, Findings& findings) {
  for (std::size_t i = 0; i < scene.boundaries.size(); ++i) {
    const BoundarySpec& boundary = scene.boundaries[i];
    const EntryFindings at(findings, boundary.source);
    check_body_name(scene, at, "body", boundary.body);
    for (std::size_t j = 0; j < i; ++j)
      at.error_if(!boundary.body.empty() && scene.boundaries[j].body == boundary.body, kListedTwice, "body",
                  "\"" + boundary.body + "\" already has a boundary; put surface and beams into one entry");
    check_boundary(scene, boundary, at);
  }
  check_contacts(scene, findings);
  const GroundKind kind = scene.ground.kind;
  const EntryFindings at(findings, scene.ground.source);
  if (scene.ground.plane) {
    check_law(scene, "plane.", *scene.ground.plane, at);
    for (const std::string& name : scene.ground.plane->bodies) check_has_boundary(scene, at, "plane.bodies", name);
  }
  at.error_if(kind == GroundKind::kPlane && !scene.ground.plane, kGroundIncomplete, "plane",
              "is missing; ground.kind = \"plane\" needs [ground.plane]");
  at.error_if(kind == GroundKind::kParticles && !scene.particles, kGroundIncomplete, "kind",
              "is \"particles\", but there is no [particles] section with a script or a box");
  if (kind == GroundKind::kParticles && scene.particles && scene.particles->script.empty() && !scene.particles->box)
    findings.error(kMissingKey, scene.particles->source, "script",
                   "is missing; name a LIGGGHTS script, or give [particles.box] for a simple bed");
  at.error_if(kind != GroundKind::kNone && scene.boundaries.empty(), kGroundIncomplete, "kind",
              "gives a ground that nothing touches; add [[boundaries]], or set kind = \"none\"");
  if (scene.initial.clearance && kind == GroundKind::kNone)
    findings.error(kGroundIncomplete, scene.initial.source, "clearance",
                   "is measured from the ground, but ground.kind is \"none\"; remove it, or give a ground");
}

}  // namespace footfall
