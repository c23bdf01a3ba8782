// Look-ups by name.

#include "mbd_solver/scene/scene.h"

#include "coupler/base/errors.h"

namespace footfall {
namespace {

template <class Entry>
int index_of(const std::vector<Entry>& entries, const std::string& name, const NameIndex& index) {
  const std::optional<std::size_t> found = index.find(entries, name);
  FOOTFALL_DEMAND(found.has_value());
  return static_cast<int>(*found);
}

template <class Entry>
const Entry* entry_of(const std::vector<Entry>& entries, const std::optional<std::size_t>& place) {
  return place ? &entries[*place] : nullptr;
}

}  // namespace

const BodySpec* Scene::body(const std::string& name) const {
  return entry_of(this->bodies, indices.bodies.find(this->bodies, name));
}

const JointSpec* Scene::joint(const std::string& name) const {
  return entry_of(this->joints, indices.joints.find(this->joints, name));
}

const MaterialSpec* Scene::material_or_null(const std::string& name) const {
  return entry_of(this->materials, indices.materials.find(this->materials, name));
}

const BoundarySpec* Scene::boundary_of(const std::string& name) const {
  const auto body_of = [](const BoundarySpec& boundary) -> const std::string& { return boundary.body; };
  return entry_of(this->boundaries, indices.boundaries.find(this->boundaries, name, body_of));
}

int Scene::body_index(const std::string& name) const {
  return name == "ground" ? -1 : index_of(this->bodies, name, indices.bodies);
}

int Scene::joint_index(const std::string& name) const { return index_of(this->joints, name, indices.joints); }

const MaterialSpec& Scene::material(const std::string& name) const {
  return this->materials[index_of(this->materials, name, indices.materials)];
}

const std::string* Scene::accepted_reason(const std::string& warning) const {
  if (!has_code(warning)) return nullptr;
  const auto found = this->accepted.find(warning.substr(warning.rfind(" [") + 2, 5));
  return found == this->accepted.end() ? nullptr : &found->second;
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
  const std::vector<Coordinate> has = coordinates_of(joints[joint_index(joint)].type);
  FOOTFALL_DEMAND(has.size() == 1);
  return has.front();
}

}  // namespace footfall
