#pragma once
// Joints of a scene, between two bodies or a body and the ground.

#include <Eigen/Dense>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/scene/source.h"

namespace footfall {

enum class JointType {
  kFixed, kSpherical, kUniversal, kRevolute, kPrismatic, kCylindrical, kDistance, kPointOnPlane, kPrescribed
};

// f(t) = sum_k c_k t^k + amplitude sin(2 pi frequency t + phase) + table(t). Unit: the one of what it moves ([m] or [rad]).
struct TimeFunctionSpec {
  std::vector<double> polynomial;             // c_0, c_1, ... [unit / s^k]
  double amplitude = 0.0;                     // [unit]
  double frequency = 0.0;                     // [Hz]
  double phase = 0.0;                         // [rad]
  std::vector<Eigen::Vector2d> table;         // (t [s], value [unit]), t rising; a C2 cubic spline through them, from file or given
  bool is_zero() const { return polynomial.empty() && amplitude == 0.0 && table.empty(); }
};

// Motion of body b relative to body a (or the ground), both at the joint's point: displacement along the axes of D as they
// turn with a, then rotation about the joint's axis. Zero functions hold that coordinate at its design value.
struct MotionSpec {
  TimeFunctionSpec x, y, z;                   // [m]
  TimeFunctionSpec rotation;                  // about `axis` [rad]
};

struct JointSpec {
  Source source;
  std::string name;
  JointType type = JointType::kFixed;
  std::array<std::string, 2> bodies;          // a, b; "ground" is allowed for one of them
  std::optional<Eigen::Vector3d> point;       // gives both of the next two [m]
  // The joint's point on a and on b in D [m], resolved by scene_reader. They may differ for distance and point_on_plane (a: a
  // point of the plane) only; else the gap is checked.
  Eigen::Vector3d point_a = Eigen::Vector3d::Zero();
  Eigen::Vector3d point_b = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();    // unit vector; revolute, prismatic, cylindrical, prescribed; universal: axis
                                                      // fixed in a; point_on_plane: normal of the plane, fixed in a
  Eigen::Vector3d axis2 = Eigen::Vector3d::UnitX();   // universal: axis fixed in b, perpendicular to `axis`
  std::optional<double> length;               // distance [m]; not given: that of the points
  std::optional<MotionSpec> motion;           // prescribed
};

}  // namespace footfall
