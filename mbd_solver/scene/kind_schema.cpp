// Walks through all kinds.
#include "mbd_solver/scene/kind_schema.h"

#include "mbd_solver/scene/joint_spec.h"
#include "mbd_solver/scene/kind_keys.h"

namespace footfall {
namespace {

Json keys_of_joint(JointType type) {
  const JointTraits traits = traits_of(type);
  Json required = Json::array(), optional = Json::array();
  const auto add = [&](const char* key, KeyUse use) {
    if (use == KeyUse::kRequired) required.push_back(key);
    if (use == KeyUse::kOptional) optional.push_back(key);
  };
  add("axis", traits.axis);
  add("axis2", traits.axis2);
  add("length", traits.length);
  add("radius", traits.radius);
  add("motion", traits.motion);
  for (const CoordinateChoice coordinate : coordinates_of(type)) optional.push_back(name_of(coordinate));
  return {{"required", required}, {"optional", optional}};
}

// Which of them are required only the checks know.
template <class Kind>
Json every_kind() {
  Json all = Json::object();
  for (const Kind kind : every<Kind>())
    all[std::string(name_of(kind))] = {{"required", Json::array()}, {"optional", keys_of(kind)}};
  return all;
}

}  // namespace

Json kind_schema() {
  Json joints = Json::object();
  for (const JointType type : every<JointType>()) joints[std::string(name_of(type))] = keys_of_joint(type);
  return {{"joints", joints},
          {"springs", every_kind<SpringKind>()},
          {"drives", every_kind<MotorKind>()},
          {"controllers", every_kind<ControllerKind>()},
          {"signals", every_kind<SignalKind>()}};
}

}  // namespace footfall
