// The steps of building in their order, the bodies, and the inputs.
#include "mbd_solver/assemble/mechanism.h"

#include <algorithm>
#include <unordered_map>

#include "mbd_solver/scene/resolve.h"

namespace footfall {

Eigen::Vector3d origin_D(const BodySpec& body, const FlexibleBody& flexible) {
  return flexible.modal ? flexible.p_DBo : body.position;
}

Eigen::Matrix3d axes_D(const BodySpec& body, const FlexibleBody& flexible) {
  return flexible.modal ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : body.orientation.toRotationMatrix();
}

int add_input(Mechanism& mechanism, double value) {
  const int place = static_cast<int>(mechanism.inputs.size());
  mechanism.inputs.conservativeResize(place + 1);
  mechanism.inputs(place) = value;
  return place;
}

bool Mechanism::has(ContactKind kind) const {
  return std::any_of(contacts.begin(), contacts.end(),
                     [&](const ContactEntry& entry) { return entry.force.of(model).kind() == kind; });
}

void add_contact(std::unique_ptr<ContactElement> element, Mechanism& mechanism, std::shared_ptr<SurfaceSeen> walls,
                 std::vector<ContactPoint> places) {
  std::vector<ContactEntry>& all = mechanism.contacts;
  const ContactKind kind = element->kind();
  ContactEntry entry{mechanism.model.add_force(std::move(element)), std::move(walls), std::move(places)};
  const auto behind = std::find_if(
      all.begin(), all.end(), [&](const ContactEntry& other) { return other.force.of(mechanism.model).kind() > kind; });
  all.insert(behind, std::move(entry));
}

void add_bodies(const Scene& scene, const std::vector<FlexibleBody>& flexible, Mechanism& mechanism) {
  const Placement as_drawn;
  const Eigen::Vector3d p_WC = mechanism.placement.point(mass_centre(scene));
  std::unordered_map<std::string, const BodyVelocitySpec*> moving;
  for (const BodyVelocitySpec& own : scene.initial.bodies) moving.emplace(own.body, &own);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const BodySpec& spec = scene.bodies[i];
    const bool still = stands_still(scene, spec.name);
    const Placement& placement = still ? as_drawn : mechanism.placement;
    BodyState state;
    state.r = placement.point(origin_D(spec, flexible[i]));
    const Eigen::Quaterniond L(placement.R_WD * axes_D(spec, flexible[i]));
    state.L << L.w(), L.x(), L.y(), L.z();
    if (!still) {
      state.w = scene.initial.angular_velocity;
      state.dr = scene.initial.velocity + state.w.cross(state.r - p_WC);
    }
    if (const auto own = moving.find(spec.name); own != moving.end()) {
      if (own->second->velocity) state.dr = *own->second->velocity;
      if (own->second->angular_velocity) state.w = *own->second->angular_velocity;
    }
    mechanism.model.add_body(
        flexible[i].modal ? Body(spec.name, flexible[i].modal) : Body(spec.name, spec.mass, spec.inertia), state);
  }
}

Mechanism build_mechanism(const Scene& scene) {
  std::vector<std::string> warnings = scene.warnings;
  const std::vector<FlexibleBody> flexible = build_flexible_bodies(scene, warnings);
  std::vector<BodyBoundary> boundaries = build_boundaries(scene, flexible, warnings);
  std::shared_ptr<Terrain> terrain = build_terrain(scene);
  Mechanism mechanism(place(scene, boundaries, flexible, terrain.get()), scene.gravity);
  mechanism.terrain = std::move(terrain);
  mechanism.boundaries = std::move(boundaries);
  mechanism.warnings = std::move(warnings);
  add_bodies(scene, flexible, mechanism);
  add_joints(scene, mechanism);
  add_controllers(scene, mechanism);
  add_signal_places(scene, mechanism);
  add_drives(scene, mechanism);
  add_gears(scene, mechanism);
  add_struts(scene, mechanism);
  add_cables(scene, mechanism);
  add_springs(scene, mechanism);
  add_forces(scene, mechanism);
  add_plane(scene, mechanism);
  add_soil_contacts(scene, mechanism);
  add_hulls(scene, flexible, mechanism);
  add_contacts(scene, mechanism);
  add_signals(scene, mechanism);
  warn_of_overlaps(scene, mechanism);
  return mechanism;
}

}  // namespace footfall
