// Boundaries, ground and particles.
#include <algorithm>
#include <cmath>

#include "coupler/base/nearest_name.h"
#include "coupler/base/text.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {

namespace {

void check_boundary(const Scene& scene, const BoundarySpec& boundary, Findings& findings) {
  const Source& source = boundary.source;
  if (!boundary.surface && !boundary.beams)
    findings.error(source, "", "is neither a surface nor beams; give surface = {} or beams = {}");
  const auto found = std::find_if(scene.bodies.begin(), scene.bodies.end(),
                                  [&](const BodySpec& b) { return b.name == boundary.body; });
  if (found == scene.bodies.end()) return;
  const BodySpec& body = *found;
  const bool flexible = body.flexible && body.flexible->enabled;
  const bool own_mesh = flexible && (!body.flexible->mesh.empty() || !body.flexible->file.empty());
  if (boundary.surface && boundary.surface->file.empty() && !own_mesh &&
      (!body.shape || body.shape->kind == ShapeKind::kPoints))
    findings.error(
        source, "surface",
        "cannot be generated: body \"" + body.name + "\" has no shape with a surface; give surface.file or a shape");
  const bool from_file = boundary.surface && (!boundary.surface->file.empty() ||
                                              (body.shape && body.shape->kind == ShapeKind::kMesh && !own_mesh));
  if (from_file && source.given("surface.element_size") && boundary.surface->from_script.empty())
    findings.error(source, "surface.element_size", "means nothing for a mesh from a file; leave it out");
  if (boundary.surface && boundary.surface->file.empty()) {
    for (const char* key : {"scale", "position", "orientation"}) {
      if (source.given(std::string("surface.") + key))
        findings.error(source, std::string("surface.") + key, "belongs to a surface from a file; there is none");
    }
  }
  if (source.given("surface.faces")) {
    const bool drawn = boundary.surface && boundary.surface->file.empty() && body.shape && !own_mesh;
    const bool disc = drawn && body.shape->kind == ShapeKind::kDisc,
               dish = drawn && body.shape->kind == ShapeKind::kDish;
    if (!disc && !dish)
      findings.error(source, "surface.faces",
                     "belongs to a disc or dish; the surface of \"" + body.name + "\" is none");
    if (dish && boundary.surface->faces == SurfaceFaces::kBoth)
      findings.error(source, "surface.faces", "is \"both\", but a dish has its mid-surface only; expected \"middle\"");
  }
  if (!boundary.beams) return;
  const bool round = body.shape && (body.shape->kind == ShapeKind::kTube || body.shape->kind == ShapeKind::kRod);
  const bool frame = flexible && !body.flexible->nodes.empty();
  if (!round && !frame && boundary.beams->points.empty())
    findings.error(source, "beams.points", "are missing; only a tube or rod has an axis to follow");
  if (boundary.beams->points.size() == 1)
    findings.error(source, "beams.points", "is one point; a chain needs two or more");
  if (!round && !(boundary.beams->radius > 0.0))
    findings.error(source, "beams.radius", "is missing; only a tube or rod has a diameter");
}

// prefix: before the keys in a message.
void check_law(const Scene& scene, const Source& source, const std::string& prefix, const ContactLawSpec& law,
               Findings& findings) {
  if (law.young && law.stiffness)
    findings.error(source, prefix + "stiffness", "stands beside young, from which it follows; keep one");
  if (!law.young && !law.stiffness)
    findings.error(source, prefix + "young", "is missing; give young [Pa] or stiffness [N/m^1.5]");
  if (law.restitution && law.damping)
    findings.error(source, prefix + "damping", "stands beside restitution, from which it follows; keep one");
  if (law.restitution && *law.restitution <= 0.0)
    findings.error(source, prefix + "restitution", "is 0, expected more than 0 (up to 1)");
  if (law.restitution && *law.restitution < 1.0 && !law.impact_speed && scene.initial.velocity.isZero())
    findings.error(source, prefix + "impact_speed",
                   "is missing; restitution holds at one speed, and initial.velocity gives none");
  if (!(law.poisson > -1.0 && law.poisson < 0.5))
    findings.error(source, prefix + "poisson",
                   "is " + number_text(law.poisson) + ", expected more than -1 and less than 0.5");
}

void check_has_boundary(const Scene& scene, const Source& source, const char* key, const std::string& name,
                        Findings& findings) {
  std::vector<std::string> names;
  for (const BoundarySpec& b : scene.boundaries) names.push_back(b.body);
  if (std::find(names.begin(), names.end(), name) == names.end())
    findings.error(source, key,
                   "\"" + name + "\" has no entry in [[boundaries]]." + known_names("boundaries", name, names));
}

bool is_bent(const Scene& scene, const std::string& name) {
  for (const BodySpec& body : scene.bodies)
    if (body.name == name) return scene.flexible && body.flexible && body.flexible->enabled;
  return false;
}

void check_pair(const Scene& scene, const ContactSpec& contact, Findings& findings) {
  const Source& source = contact.source;
  if (contact.between.size() != 2) {
    findings.error(source, "between",
                   "names " + std::to_string(contact.between.size()) +
                       ", expected two bodies, or a body and \"plane\" (or walls = true instead)");
    return;
  }
  const std::string &first = contact.between[0], &second = contact.between[1];
  check_has_boundary(scene, source, "between", first, findings);
  if (!contact.with_plane()) check_has_boundary(scene, source, "between", second, findings);
  if (first == second) findings.error(source, "between", "names \"" + first + "\" twice");
  if (contact.ignore && contact.with_plane())
    findings.error(source, "ignore", "is for two bodies; for a body without contact with a plane give none");
  if (!contact.ignore && is_bent(scene, first) && is_bent(scene, second))
    findings.error(source, "between",
                   "names two flexible bodies: one of them must be rigid, the other's places touch its "
                   "surface");
}

void check_contacts(const Scene& scene, Findings& findings) {
  for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
    const ContactSpec& contact = scene.contacts[i];
    const Source& source = contact.source;
    if (contact.walls) {
      if (!contact.between.empty()) findings.error(source, "walls", "stands beside between; give each its own entry");
      if (contact.ignore) findings.error(source, "ignore", "is for two bodies, not for walls");
      if (!scene.touches_particles())
        findings.error(source, "walls", "are those of a LIGGGHTS script, but ground.kind is not \"particles\"");
      if (scene.boundaries.empty()) findings.error(source, "walls", "touch [[boundaries]], but there are none");
      for (const std::string& name : contact.bodies) check_has_boundary(scene, source, "bodies", name, findings);
    } else {
      check_pair(scene, contact, findings);
      if (!contact.bodies.empty()) findings.error(source, "bodies", "belong to walls = true; between names its bodies");
    }
    for (const char* key : {"point", "normal"})
      if (source.given(key) && !contact.with_plane())
        findings.error(source, key, "belongs to a plane: between = [\"BODY\", \"plane\"]");
    if (!contact.ignore) check_law(scene, source, "", contact, findings);
    for (std::size_t j = 0; j < i; ++j) {
      const ContactSpec& other = scene.contacts[j];
      const bool same = contact.between.size() == 2 && !contact.with_plane() && other.between.size() == 2 &&
                        std::is_permutation(contact.between.begin(), contact.between.end(), other.between.begin());
      const bool shared = contact.bodies.empty() || other.bodies.empty() ||
                          std::find_first_of(contact.bodies.begin(), contact.bodies.end(), other.bodies.begin(),
                                             other.bodies.end()) != contact.bodies.end();
      if (same || (contact.walls && other.walls && shared))
        findings.error(source, contact.walls ? "walls" : "between",
                       "stand in an earlier entry already: the contact would count twice");
    }
  }
}

void check_plane(const Scene& scene, Findings& findings) {
  const PlaneSpec& plane = *scene.ground.plane;
  const Source& source = scene.ground.source;
  check_law(scene, source, "plane.", plane, findings);
  std::vector<std::string> names;
  for (const BoundarySpec& b : scene.boundaries) names.push_back(b.body);
  for (const std::string& name : plane.bodies) {
    if (std::find(names.begin(), names.end(), name) == names.end())
      findings.error(source, "plane.bodies",
                     "\"" + name + "\" has no entry in [[boundaries]]." + known_names("boundaries", name, names));
  }
}

}  // namespace

void check_contact(const Scene& scene, Findings& findings) {
  for (std::size_t i = 0; i < scene.boundaries.size(); ++i) {
    const BoundarySpec& boundary = scene.boundaries[i];
    check_body_name(scene, boundary.source, "body", boundary.body, findings);
    for (std::size_t j = 0; j < i; ++j) {
      if (!boundary.body.empty() && scene.boundaries[j].body == boundary.body)
        findings.error(boundary.source, "body",
                       "\"" + boundary.body + "\" already has a boundary; put surface and beams into one entry");
    }
    check_boundary(scene, boundary, findings);
  }
  check_contacts(scene, findings);
  if (scene.ground.plane) check_plane(scene, findings);
  const GroundKind kind = scene.ground.kind;
  if (kind == GroundKind::kPlane && !scene.ground.plane)
    findings.error(scene.ground.source, "plane", "is missing; ground.kind = \"plane\" needs [ground.plane]");
  if (kind == GroundKind::kParticles && !scene.particles)
    findings.error(scene.ground.source, "kind",
                   "is \"particles\", but there is no [particles] section with a script or a box");
  if (kind == GroundKind::kParticles && scene.particles && scene.particles->script.empty() && !scene.particles->box)
    findings.error(scene.particles->source, "script",
                   "is missing; name a LIGGGHTS script, or give [particles.box] for a plain bed");
  if (kind != GroundKind::kNone && scene.boundaries.empty())
    findings.error(scene.ground.source, "kind",
                   "gives a ground that nothing touches; add [[boundaries]], or set kind = \"none\"");
  if (scene.initial.clearance && kind == GroundKind::kNone)
    findings.error(scene.initial.source, "clearance", "counts from the ground, but ground.kind is \"none\"");
}

}  // namespace footfall
