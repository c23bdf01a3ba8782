#pragma once
// The keys of each kind of an entry. Keys of every kind (name, kind, bodies ...) are not listed.

#include <algorithm>
#include <string>
#include <vector>

#include "mbd_solver/scene/body_spec.h"
#include "mbd_solver/scene/force_spec.h"
#include "mbd_solver/scene/joint_spec.h"
#include "mbd_solver/scene/run_spec.h"

namespace footfall {

struct ShapeKeys {
  std::vector<std::string> required, optional = {};
};
inline ShapeKeys keys_of(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::kBox: return {{"size"}, {"centre"}};
    case ShapeKind::kTube: return {{"from", "to", "diameter", "wall"}};
    case ShapeKind::kRod:
    case ShapeKind::kCapsule: return {{"from", "to", "diameter"}};
    case ShapeKind::kDisc: return {{"radius", "thickness"}, {"centre", "axis"}};
    case ShapeKind::kDish: return {{"radius", "depth", "thickness"}, {"centre", "axis"}};
    case ShapeKind::kSphere: return {{"radius"}, {"centre"}};
    case ShapeKind::kCylinder: return {{"radius", "length"}, {"centre", "axis"}};
    case ShapeKind::kMesh: return {{"file"}, {"scale", "position", "orientation"}};
    case ShapeKind::kPoints: return {{"points"}};
  }
  return {};
}

inline std::vector<std::string> keys_of(SpringKind kind) {
  switch (kind) {
    case SpringKind::kTorsion: return {"axis", "rest_angle"};
    case SpringKind::kCentring: return {};
    case SpringKind::kBushing: return {"axis", "axis2", "turning_stiffness", "turning_damping"};
  }
  return {};
}

inline std::vector<std::string> keys_of(MotorKind kind) {
  switch (kind) {
    case MotorKind::kTorque: return {"max_speed", "efficiency"};
    case MotorKind::kSpeed: return {"max_speed", "efficiency", "kp", "ki"};
    case MotorKind::kPosition: return {"max_speed", "efficiency", "kp", "ki", "kd"};
    case MotorKind::kBrake: return {"lag"};
  }
  return {};
}

inline std::vector<std::string> keys_of(ControllerKind kind) {
  switch (kind) {
    case ControllerKind::kConstant: return {"voltages"};
    case ControllerKind::kFuzzy:
      return {"touchdown_acceleration", "touchdown_delay", "file", "tabulated", "grid", "filter_frequency"};
    case ControllerKind::kSkyhook: return {"touchdown_acceleration", "touchdown_delay", "on", "off", "deadband"};
    case ControllerKind::kPid:
      return {"touchdown_acceleration", "touchdown_delay", "filter_frequency", "set_point", "kp", "ki", "kd", "bias"};
  }
  return {};
}

inline std::vector<std::string> keys_of(SignalKind kind) {
  switch (kind) {
    case SignalKind::kExpression: return {"input"};
    case SignalKind::kPid: return {"input", "kp", "ki", "kd", "bias", "rate", "derivative_frequency", "min", "max"};
    case SignalKind::kLowpass: return {"input", "frequency", "initial"};
    case SignalKind::kLowpass2:
    case SignalKind::kNotch: return {"input", "frequency", "damping", "initial"};
    case SignalKind::kRateLimit: return {"input", "max_rate", "initial"};
    case SignalKind::kSaturation: return {"input", "min", "max"};
    case SignalKind::kTable: return {"input", "points"};
    case SignalKind::kTable2: return {"input", "input2", "x", "x2", "values"};
    case SignalKind::kFuzzy: return {"file", "inputs", "output"};
    case SignalKind::kFmu: return {"file", "inputs", "outputs", "start", "time_limit"};
    case SignalKind::kPython: return {"file", "inputs", "function", "stateless", "time_limit"};
    case SignalKind::kHost: return {"initial"};
  }
  return {};
}

// The keys of other kinds that have no effect on this one.
template <class Kind>
std::vector<std::string> keys_of_other_kinds(Kind kind) {
  const std::vector<std::string> own = keys_of(kind);
  std::vector<std::string> foreign;
  for (const Kind other : every<Kind>())
    for (const std::string& key : keys_of(other))
      if (std::find(own.begin(), own.end(), key) == own.end() &&
          std::find(foreign.begin(), foreign.end(), key) == foreign.end())
        foreign.push_back(key);
  return foreign;
}

}  // namespace footfall
