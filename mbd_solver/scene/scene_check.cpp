#include "mbd_solver/scene/scene_check.h"

#include <algorithm>

#include "coupler/base/errors.h"
#include "coupler/base/nearest_name.h"
#include "coupler/base/text.h"

namespace footfall {
namespace {
constexpr double kLeastDensity = 50.0;  // [kg/m3] of what machines are built of
}  // namespace

int Scene::body_index(const std::string& name) const {
  if (name == "ground") return -1;
  const auto found = std::find_if(bodies.begin(), bodies.end(), [&](const BodySpec& b) { return b.name == name; });
  FOOTFALL_DEMAND(found != bodies.end());
  return static_cast<int>(found - bodies.begin());
}

int Scene::joint_index(const std::string& name) const {
  const auto found = std::find_if(joints.begin(), joints.end(), [&](const JointSpec& j) { return j.name == name; });
  FOOTFALL_DEMAND(found != joints.end());
  return static_cast<int>(found - joints.begin());
}

CoordinateChoice Scene::coordinate_of(const DriveSpec& drive) const {
  return drive.coordinate != CoordinateChoice::kAuto ? drive.coordinate : only_coordinate(drive.joint);
}

CoordinateChoice Scene::coordinate_of(const GearSpec& gear, std::size_t index) const {
  if (index < gear.coordinates.size())
    for (const CoordinateChoice choice : every<CoordinateChoice>())
      if (choice != CoordinateChoice::kAuto && gear.coordinates[index] == name_of(choice)) return choice;
  return only_coordinate(gear.joints[index]);
}

CoordinateChoice Scene::only_coordinate(const std::string& joint) const {
  const std::vector<CoordinateChoice> has = coordinates_of(joints[static_cast<std::size_t>(joint_index(joint))].type);
  FOOTFALL_DEMAND(has.size() == 1);
  return has.front();
}

const MaterialSpec& Scene::material(const std::string& name) const {
  const auto found =
      std::find_if(materials.begin(), materials.end(), [&](const MaterialSpec& m) { return m.name == name; });
  FOOTFALL_DEMAND(found != materials.end());
  return *found;
}

std::vector<std::string> body_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const BodySpec& body : scene.bodies) names.push_back(body.name);
  return names;
}

void check_body_name(const Scene& scene, const Source& source, const std::string& key, const std::string& name,
                     Findings& findings) {
  const std::vector<std::string> names = body_names(scene);
  const bool known = std::find(names.begin(), names.end(), name) != names.end();
  if (name.empty() || known) return;
  findings.error(source, key, "unknown body \"" + name + "\"." + known_names("bodies", name, names));
}

void check_pair(const Scene& scene, const Source& source, const std::array<std::string, 2>& bodies,
                Findings& findings) {
  for (const std::string& name : bodies) {
    if (name != "ground") check_body_name(scene, source, "bodies", name, findings);
  }
  if (!bodies[0].empty() && bodies[0] == bodies[1])
    findings.error(source, "bodies", "are both \"" + bodies[0] + "\"; expected two that differ");
}

void check_bodies(const Scene& scene, Findings& findings) {
  if (scene.bodies.empty())
    findings.error(scene.source, "bodies", "there are none; a scene needs at least one [[bodies]] entry");
  check_unique_names(scene.bodies, "body", findings);
  std::vector<std::string> materials;
  for (const MaterialSpec& m : scene.materials) {
    materials.push_back(m.name);
    if (m.density > 0.0 && m.density < kLeastDensity)
      findings.warning(
          m.source, "density",
          "is " + number_text(m.density) +
              " kg/m3, lighter than foam. Is it in g/cm3? Then write density_g_cm3 = " + number_text(m.density));
    if (!(m.poisson > -1.0 && m.poisson < 0.5))
      findings.error(m.source, "poisson", "is " + number_text(m.poisson) + ", expected more than -1 and less than 0.5");
  }
  for (const BodySpec& body : scene.bodies) {
    if (body.name == "ground")
      findings.error(body.source, "name", "\"ground\" means the inertial frame; choose another name");
    const bool known = std::find(materials.begin(), materials.end(), body.material) != materials.end();
    if (!body.material.empty() && !known)
      findings.error(
          body.source, "material",
          "there is no material \"" + body.material + "\"." + known_names("materials", body.material, materials));
    if (!body.flexible || !body.flexible->enabled) continue;
    const FlexibleSpec& f = *body.flexible;
    const int matrices =
        (f.stiffness_matrix.empty() ? 0 : 1) + (f.mass_matrix.empty() ? 0 : 1) + (f.node_file.empty() ? 0 : 1);
    if (matrices == 1 || matrices == 2)
      findings.error(
          body.source, "flexible",
          "gives a part of stiffness_matrix, mass_matrix and node_file; a model in matrices needs all three");
    const int models =
        (f.file.empty() ? 0 : 1) + (f.mesh.empty() ? 0 : 1) + (f.nodes.empty() ? 0 : 1) + (matrices > 0 ? 1 : 0);
    if (models > 1)
      findings.error(body.source, "flexible", "names more than one of file, mesh, nodes and matrices; keep one");
    if (models == 0 && !(body.shape && !body.source.good("shape.kind"))) {
      const bool can = body.shape && (body.shape->kind == ShapeKind::kTube || body.shape->kind == ShapeKind::kRod ||
                                      body.shape->kind == ShapeKind::kDisc || body.shape->kind == ShapeKind::kDish);
      if (!can)
        findings.error(body.source, "flexible",
                       "this body has no shape that bends; expected a tube, rod, disc or dish, or flexible = { file, "
                       "mesh, nodes or matrices }");
    }
    if (f.file.empty() && matrices == 0) {
      if (body.material.empty()) {
        findings.error(body.source, "material", "is missing; a flexible body needs density, young and poisson");
      } else if (known && !(scene.material(body.material).young > 0.0)) {
        findings.error(scene.material(body.material).source, "young",
                       "is missing; the flexible body \"" + body.name + "\" needs it");
      }
    }
    if (!f.mesh.empty() && f.thickness <= 0.0 && !(body.shape && body.shape->thickness > 0.0))
      findings.error(body.source, "flexible.thickness", "is missing; a plate on a mesh needs it");
    for (const MemberSpec& m : f.members) {
      if (std::max(m.first, m.second) >= static_cast<int>(f.nodes.size()) || m.first == m.second)
        findings.error(body.source, "flexible.members",
                       "joins nodes " + std::to_string(m.first) + " and " + std::to_string(m.second) +
                           ", expected two different ones from 0 to " +
                           std::to_string(static_cast<int>(f.nodes.size()) - 1));
      std::vector<std::string> sections;
      for (const SectionSpec& s : f.sections) sections.push_back(s.name);
      if (std::find(sections.begin(), sections.end(), m.section) == sections.end())
        findings.error(body.source, "flexible.members",
                       "there is no section \"" + m.section + "\"." + known_names("sections", m.section, sections));
    }
    if (!f.nodes.empty() && f.members.empty())
      findings.error(body.source, "flexible.members", "are missing; nodes alone are no frame");
  }
  const std::vector<BodyVelocitySpec>& moving = scene.initial.bodies;
  for (auto v = moving.begin(); v != moving.end(); ++v) {
    check_body_name(scene, v->source, "body", v->body, findings);
    const auto same = std::find_if(moving.begin(), v, [&](const BodyVelocitySpec& o) { return o.body == v->body; });
    if (!v->body.empty() && same != v)
      findings.error(v->source, "body",
                     "\"" + v->body + "\" already has a velocity (line " + std::to_string(same->source.line) +
                         "); give each body one entry");
  }
  for (const std::string& name : scene.output.bodies)
    check_body_name(scene, scene.output.source, "bodies", name, findings);
}

// A body beside a mechanism that nothing connects to it and that touches nothing is mostly a joint that was forgotten.
void warn_of_loose_bodies(const Scene& scene, Findings& findings) {
  if (scene.joints.empty()) return;
  std::vector<std::string> used;
  const auto use = [&](const auto& entries) {
    for (const auto& entry : entries) used.insert(used.end(), entry.bodies.begin(), entry.bodies.end());
  };
  use(scene.joints);
  use(scene.struts);
  use(scene.springs);
  for (const ForceSpec& force : scene.forces) used.push_back(force.body);
  for (const BoundarySpec& boundary : scene.boundaries) used.push_back(boundary.body);
  for (const BodySpec& body : scene.bodies)
    if (std::find(used.begin(), used.end(), body.name) == used.end())
      findings.warning(body.source, "name",
                       "nothing is connected to \"" + body.name +
                           "\": no joint, strut, spring, force or boundary names it; add a joint, or take it out");
}

// A plane is stood on along gravity.
void warn_of_gravity_upwards(const Scene& scene, Findings& findings) {
  if (scene.ground.kind != GroundKind::kPlane || !scene.ground.plane) return;
  const double along = scene.gravity.dot(scene.ground.plane->normal);
  if (along > 1e-9)
    findings.warning(scene.source, "gravity",
                     "points away from the ground, " + number_text(along) +
                         " m/s2 along its normal: bodies fall off it; expected the other sign, such as [0, 0, -9.81]");
}

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
