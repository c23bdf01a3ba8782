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

void check_plane(const Scene& scene, Findings& findings) {
  const PlaneSpec& plane = *scene.ground.plane;
  const Source& source = scene.ground.source;
  if (plane.young && plane.stiffness)
    findings.error(source, "plane.stiffness", "stands beside young, from which it follows; keep one");
  if (!plane.young && !plane.stiffness)
    findings.error(source, "plane.young", "is missing; give young [Pa] or stiffness [N/m^1.5]");
  if (plane.restitution && plane.damping)
    findings.error(source, "plane.damping", "stands beside restitution, from which it follows; keep one");
  if (plane.restitution && *plane.restitution <= 0.0)
    findings.error(source, "plane.restitution", "is 0, expected more than 0 (up to 1)");
  if (plane.restitution && *plane.restitution < 1.0 && !plane.impact_speed && scene.initial.velocity.isZero())
    findings.error(source, "plane.impact_speed",
                   "is missing; restitution holds at one speed, and initial.velocity gives none");
  if (!(plane.poisson > -1.0 && plane.poisson < 0.5))
    findings.error(source, "plane.poisson",
                   "is " + number_text(plane.poisson) + ", expected more than -1 and less than 0.5");
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
