#pragma once
// Joints of a scene, between two bodies or a body and the ground.

#include <Eigen/Dense>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "coupler/base/kinds.h"
#include "mbd_solver/scene/source.h"

namespace footfall {

enum class JointType {
  kFixed,
  kSpherical,
  kUniversal,
  kRevolute,
  kPrismatic,
  kCylindrical,
  kDistance,
  kPointOnPlane,
  kPrescribed
};

enum class KeyUse { kUnused, kOptional, kRequired };

// What each type of joint is, for the reader (its name), the checks (its keys beside name, bodies and points) and the
// builder of flexible bodies.
struct JointTraits {
  std::string_view name;
  KeyUse axis;
  KeyUse axis2;
  KeyUse length;
  KeyUse motion;
  bool points_may_differ;  // in the drawing
  bool holds_attitude;     // transmits moments
};
constexpr JointTraits traits_of(JointType type) {
  constexpr KeyUse no = KeyUse::kUnused, may = KeyUse::kOptional, must = KeyUse::kRequired;
  switch (type) {  //                                                axis  axis2 length motion differ attitude
    case JointType::kFixed: return {"fixed", may, no, no, no, false, true};
    case JointType::kSpherical: return {"spherical", may, no, no, no, false, false};
    case JointType::kUniversal: return {"universal", must, must, no, no, false, false};
    case JointType::kRevolute: return {"revolute", must, no, no, no, false, true};
    case JointType::kPrismatic: return {"prismatic", must, no, no, no, false, true};
    case JointType::kCylindrical: return {"cylindrical", must, no, no, no, false, true};
    case JointType::kDistance: return {"distance", may, no, may, no, true, false};
    case JointType::kPointOnPlane: return {"point_on_plane", must, no, no, no, true, false};
    case JointType::kPrescribed: return {"prescribed", may, may, no, must, false, true};
  }
  return {};
}
constexpr std::string_view name_of(JointType type) { return traits_of(type).name; }

// f(t) = sum_k c_k t^k + amplitude sin(2 pi frequency t + phase) + table(t). Unit: the one of what it moves ([m] or
// [rad]).
struct TimeFunctionSpec {
  std::vector<double> polynomial;      // c_0, c_1, ... [unit / s^k]
  double amplitude = 0.0;              // [unit]
  double frequency = 0.0;              // [Hz]
  double phase = 0.0;                  // [rad]
  std::vector<Eigen::Vector2d> table;  // (t [s], value [unit]), t rising: a cubic spline through them
};

// Motion of body b relative to body a (or the ground), in the joint's frame, which turns with a: z = axis, x = axis2
// (made perpendicular to it), y = z cross x. A coordinate that is not given is free.
struct MotionSpec {
  std::optional<TimeFunctionSpec> x, y, z;   // displacement of the point on b from the point on a [m]
  std::optional<TimeFunctionSpec> rotation;  // about z [rad]
  bool hold_other_rotations = false;         // keeps z of both bodies parallel
};

struct JointSpec {
  Source source;
  std::string name;
  JointType type = JointType::kFixed;
  std::array<std::string, 2> bodies;     // a, b; "ground" is allowed for one of them
  std::optional<Eigen::Vector3d> point;  // gives both of the next two [m]
  // The joint's point on a and on b in D [m], resolved by scene_reader. They may differ for distance and point_on_plane
  // (a: a point of the plane) only; else the gap is checked.
  Eigen::Vector3d point_a = Eigen::Vector3d::Zero();
  Eigen::Vector3d point_b = Eigen::Vector3d::Zero();
  // unit vector; revolute, prismatic, cylindrical, prescribed; universal: axis
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  // fixed in a; point_on_plane: normal of the plane, fixed in a
  // universal: axis fixed in b, perpendicular to `axis`; prescribed: x axis
  Eigen::Vector3d axis2 = Eigen::Vector3d::UnitX();
  std::optional<double> length;      // distance [m]; not given: that of the points
  std::optional<MotionSpec> motion;  // prescribed
};

}  // namespace footfall
