// The checks of bodies, what all checks share, and the look-ups of a checked scene.
#include "mbd_solver/scene/scene_check.h"

#include "coupler/base/text.h"

namespace footfall {

using namespace code;
namespace {

constexpr double kLeastDensity = 50.0;  // of materials that machines are built of [kg/m3]

template <class Entry>
int index_of(const std::vector<Entry>& entries, const std::string& name) {
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.name == name; });
  FOOTFALL_DEMAND(found != entries.end());
  return static_cast<int>(found - entries.begin());
}

}  // namespace

int Scene::body_index(const std::string& name) const { return name == "ground" ? -1 : index_of(bodies, name); }

int Scene::joint_index(const std::string& name) const { return index_of(joints, name); }

const MaterialSpec& Scene::material(const std::string& name) const {
  return materials[static_cast<std::size_t>(index_of(materials, name))];
}

Coordinate Scene::coordinate_of(const DriveSpec& drive) const {
  return drive.coordinate ? *drive.coordinate : only_coordinate(drive.joint);
}

Coordinate Scene::coordinate_of(const GearSpec& gear, std::size_t index) const {
  if (index < gear.coordinates.size())
    for (const Coordinate coordinate : every<Coordinate>())
      if (gear.coordinates[index] == name_of(coordinate)) return coordinate;
  return only_coordinate(gear.joints[index]);
}

Coordinate Scene::only_coordinate(const std::string& joint) const {
  const std::vector<Coordinate> has = coordinates_of(joints[static_cast<std::size_t>(joint_index(joint))].type);
  FOOTFALL_DEMAND(has.size() == 1);
  return has.front();
}

std::vector<std::string> boundary_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const BoundarySpec& boundary : scene.boundaries) names.push_back(boundary.body);
  return names;
}

void check_known(const EntryFindings& at, const MessageCode& code, const std::string& key, const std::string& what,
                 const std::string& plural, const std::string& name, const std::vector<std::string>& names) {
  if (!name.empty() && !is_in(names, name))
    at.error(code, key, "unknown " + what + " \"" + name + "\"." + known_names(plural, name, names));
}

void check_body_name(const Scene& scene, const EntryFindings& at, const std::string& key, const std::string& name) {
  check_known(at, kUnknownBody, key, "body", "bodies", name, names_in(scene.bodies));
}

void check_signal_name(const Scene& scene, const EntryFindings& at, const std::string& key, const std::string& name) {
  check_known(at, kUnknownSignal, key, "signal", "signals", name, names_in(scene.signals));
}

void check_pair(const Scene& scene, const EntryFindings& at, const std::array<std::string, 2>& bodies) {
  for (const std::string& name : bodies)
    if (name != "ground") check_body_name(scene, at, "bodies", name);
  at.error_if(!bodies[0].empty() && bodies[0] == bodies[1], kListedTwice, "bodies",
              "are both \"" + bodies[0] + "\"; expected two different ones");
}

namespace {

// The elastic model of a flexible body: exactly one, complete, with the material that it needs.
void check_flexible(const Scene& scene, const BodySpec& body, const EntryFindings& at) {
  const FlexibleSpec& f = *body.flexible;
  const int matrices = !f.stiffness_matrix.empty() + !f.mass_matrix.empty() + !f.node_file.empty();
  at.error_if(matrices == 1 || matrices == 2, kNeedsOtherKey, "flexible",
              "has only a part of stiffness_matrix, mass_matrix and node_file; a model in matrices needs all three");
  const int models = !f.file.empty() + !f.mesh.empty() + !f.nodes.empty() + (matrices > 0);
  at.error_if(models > 1, kElasticModel, "flexible", "has more than one of file, mesh, nodes and matrices; keep one");
  if (models == 0 && !(body.shape && !body.source.good("shape.kind"))) {
    const bool bends = body.shape && (body.shape->kind == ShapeKind::kTube || body.shape->kind == ShapeKind::kRod ||
                                      body.shape->kind == ShapeKind::kDisc || body.shape->kind == ShapeKind::kDish);
    at.error_if(!bends, kElasticModel, "flexible",
                "this body has no shape that bends; expected a tube, rod, disc or dish, or flexible = { file, mesh, "
                "nodes or matrices }");
  }
  if (f.file.empty() && matrices == 0) {
    if (body.material.empty()) {
      at.missing("material", "a flexible body needs density, young and poisson");
    } else if (is_in(names_in(scene.materials), body.material) && !(scene.material(body.material).young > 0.0)) {
      at.all().error(kMissingKey, scene.material(body.material).source, "young",
                     "is missing; the flexible body \"" + body.name + "\" needs it");
    }
  }
  at.missing_if(!f.mesh.empty() && f.thickness <= 0.0 && !(body.shape && body.shape->thickness > 0.0),
                "flexible.thickness", "a plate on a mesh needs it");
  const int nodes = static_cast<int>(f.nodes.size());
  for (const MemberSpec& m : f.members) {
    at.error_if(std::max(m.first, m.second) >= nodes || m.first == m.second, kFrameMember, "flexible.members",
                "joins nodes " + std::to_string(m.first) + " and " + std::to_string(m.second) +
                    ", expected two different ones from 0 to " + std::to_string(nodes - 1));
    if (!is_in(names_in(f.sections), m.section))
      at.error(kUnknownSection, "flexible.members",
               "unknown section \"" + m.section + "\"." + known_names("sections", m.section, names_in(f.sections)));
  }
  at.missing_if(nodes > 0 && f.members.empty(), "flexible.members", "nodes without members are no frame");
}

}  // namespace

void check_bodies(const Scene& scene, Findings& findings) {
  if (scene.bodies.empty())
    findings.error(kNoBodies, scene.source, "bodies", "is missing; a scene needs at least one [[bodies]] entry");
  check_unique_names(scene.bodies, "body", findings);
  for (const MaterialSpec& m : scene.materials) {
    const EntryFindings at(findings, m.source);
    if (m.density > 0.0 && m.density < kLeastDensity)
      at.warning(kLightMaterial, "density",
                 "is " + number_text(m.density) +
                     " kg/m3, lighter than foam. If it is in g/cm3, write density_g_cm3 = " + number_text(m.density));
    at.error_if(!(m.poisson > -1.0 && m.poisson < 0.5), kOutOfRange, "poisson",
                "is " + number_text(m.poisson) + ", expected more than -1 and less than 0.5");
  }
  for (const BodySpec& body : scene.bodies) {
    const EntryFindings at(findings, body.source);
    at.error_if(body.name == "ground", kReservedName, "name", "\"ground\" is the inertial frame; choose another name");
    check_known(at, kUnknownMaterial, "material", "material", "materials", body.material, names_in(scene.materials));
    if (body.flexible && body.flexible->enabled) check_flexible(scene, body, at);
  }
  const std::vector<BodyVelocitySpec>& moving = scene.initial.bodies;
  for (auto v = moving.begin(); v != moving.end(); ++v) {
    const EntryFindings at(findings, v->source);
    check_body_name(scene, at, "body", v->body);
    const auto same = std::find_if(moving.begin(), v, [&](const BodyVelocitySpec& o) { return o.body == v->body; });
    at.error_if(!v->body.empty() && same != v, kListedTwice, "body",
                "\"" + v->body + "\" already has a velocity (line " + std::to_string(same->source.line) +
                    "); give each body one entry");
  }
  for (const std::string& name : scene.output.bodies)
    check_body_name(scene, {findings, scene.output.source}, "bodies", name);
}

namespace {

// A body next to a mechanism that nothing connects to it and that touches nothing: mostly a forgotten joint.
void warn_of_loose_bodies(const Scene& scene, Findings& findings) {
  if (scene.joints.empty()) return;
  std::vector<std::string> used = boundary_names(scene);
  const auto use = [&](const auto& entries) {
    for (const auto& entry : entries) used.insert(used.end(), entry.bodies.begin(), entry.bodies.end());
  };
  use(scene.joints);
  use(scene.struts);
  use(scene.springs);
  for (const ForceSpec& force : scene.forces) used.push_back(force.body);
  for (const BodySpec& body : scene.bodies)
    if (!is_in(used, body.name))
      findings.warning(kLooseBody, body.source, "name",
                       "body \"" + body.name +
                           "\" is connected to nothing: no joint, strut, spring, force or boundary names it; add a "
                           "joint, or remove the body");
}

void warn_of_gravity_upwards(const Scene& scene, Findings& findings) {
  if (scene.ground.kind != GroundKind::kPlane || !scene.ground.plane) return;
  const double along = scene.gravity.dot(scene.ground.plane->normal);
  if (along > 1e-9)
    findings.warning(kGravityUpwards, scene.source, "gravity",
                     "points away from the ground, " + number_text(along) +
                         " m/s2 along its normal, so bodies fall off it; expected the other sign, such as "
                         "[0, 0, -9.81]");
}

}  // namespace

void check_scene(const Scene& scene, Findings& findings) {
  check_bodies(scene, findings);
  warn_of_loose_bodies(scene, findings);
  warn_of_gravity_upwards(scene, findings);
  check_joints(scene, findings);
  check_drives(scene, findings);
  check_gears(scene, findings);
  check_initial_joints(scene, findings);
  check_controllers(scene, findings);
  check_signals(scene, findings);
  check_struts(scene, findings);
  check_springs(scene, findings);
  check_forces(scene, findings);
  check_contact(scene, findings);
  check_limits(scene, findings);
  if (scene.particles && scene.touches_particles()) check_script(scene, findings);
}

}  // namespace footfall
