#pragma once
// Forces and torques of a scene as functions of time, at a point of a body.

#include <Eigen/Dense>
#include <optional>
#include <string>

#include "mbd_solver/base/kinds.h"
#include "mbd_solver/scene/joint_spec.h"

namespace footfall {

enum class ForceFrame {
  kBody,     // the direction is given in D and turns with the body
  kInertial  // the direction is fixed in W; the point moves with the body
};
constexpr std::string_view name_of(ForceFrame kind) { return name_in(kind, "body", "inertial"); }

struct ForceSpec {
  Source source;
  std::string name;
  std::string body;
  std::optional<Eigen::Vector3d> point;                  // in D [m]; not given: the mass centre of a rigid body
  ForceFrame frame = ForceFrame::kBody;                  // of the direction
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  // unit vector
  std::optional<TimeFunctionSpec> force;                 // along the direction [N]
  std::optional<TimeFunctionSpec> torque;                // about the direction [N m]
};

}  // namespace footfall
