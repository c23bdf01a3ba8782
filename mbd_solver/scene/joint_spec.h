#pragma once
// Joints of a scene, between two bodies or a body and the ground.

#include <Eigen/Dense>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/base/kinds.h"
#include "mbd_solver/model/elements/joint_coordinate.h"
#include "mbd_solver/model/laws/friction.h"
#include "mbd_solver/model/laws/motor.h"
#include "mbd_solver/model/laws/springs.h"
#include "mbd_solver/scene/findings.h"

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
  kPlanar,
  kConstantVelocity,
  kRolling,
  kPrescribed
};

enum class KeyUse { kUnused, kOptional, kRequired };

// Facts of a type of joint: its name, its keys besides name, bodies and points, and its free coordinates.
struct JointTraits {
  std::string_view name;
  KeyUse axis;
  KeyUse axis2;
  KeyUse length;
  KeyUse radius;
  KeyUse motion;
  bool points_may_differ;  // in the reference configuration
  bool holds_attitude;     // transmits moments
  bool turns;              // its angle about `axis` is a coordinate
  bool slides;             // its displacement along `axis` is a coordinate
  bool slides_across;      // those along x and y of its frame are (z = axis, x = axis2)
};
constexpr JointTraits traits_of(JointType type) {
  constexpr KeyUse no = KeyUse::kUnused, may = KeyUse::kOptional, must = KeyUse::kRequired;
  switch (
      type) {  //                                            axis axis2 length radius motion differ attitude turns slides across
    case JointType::kFixed: return {"fixed", may, no, no, no, no, false, true, false, false, false};
    case JointType::kSpherical: return {"spherical", may, no, no, no, no, false, false, false, false, false};
    case JointType::kUniversal: return {"universal", must, must, no, no, no, false, false, false, false, false};
    case JointType::kRevolute: return {"revolute", must, no, no, no, no, false, true, true, false, false};
    case JointType::kPrismatic: return {"prismatic", must, no, no, no, no, false, true, false, true, false};
    case JointType::kCylindrical: return {"cylindrical", must, no, no, no, no, false, true, true, true, false};
    case JointType::kDistance: return {"distance", may, no, may, no, no, true, false, false, false, false};
    case JointType::kPointOnPlane: return {"point_on_plane", must, no, no, no, no, true, false, false, false, false};
    case JointType::kPlanar: return {"planar", must, may, no, no, no, false, true, true, false, true};
    case JointType::kConstantVelocity:
      return {"constant_velocity", must, may, no, no, no, false, true, false, false, false};
    case JointType::kRolling: return {"rolling", must, may, no, must, no, true, true, false, false, false};
    case JointType::kPrescribed: return {"prescribed", may, may, no, no, must, false, true, false, false, false};
  }
  return {};
}
constexpr std::string_view name_of(JointType type) { return traits_of(type).name; }

// f(t) = sum_k c_k t^k + amplitude sin(2 pi frequency t + phase) + table(t) + signal. The unit belongs to its key ([m], [rad],
// [N] ...).
struct TimeFunctionSpec {
  std::vector<double> polynomial;      // c_0, c_1, ... [unit / s^k]
  double amplitude = 0.0;              // [unit]
  double frequency = 0.0;              // [Hz]
  double phase = 0.0;                  // [rad]
  std::vector<Eigen::Vector2d> table;  // (t [s], value [unit]), t rising: a cubic spline through them
  std::string signal;                  // name of a signal in this unit; not for a prescribed motion
};

// Motion of body b relative to body a (or the ground), in the joint's frame, which turns with a: z = axis, x = axis2
// (made perpendicular to it), y = z cross x. A coordinate that is not given is free.
struct MotionSpec {
  std::optional<TimeFunctionSpec> x, y, z;   // displacement of the point on b from the point on a [m]
  std::optional<TimeFunctionSpec> rotation;  // about z [rad]
  bool hold_other_rotations = false;         // keeps z of both bodies parallel
};

// The coordinates that a type of joint leaves free: body b relative to body a, zero in the reference configuration. x is the
// x axis of the joint's frame, which turns with a: axis2, made perpendicular to the axis.
std::vector<Coordinate> coordinates_of(JointType type);
bool has_coordinate(JointType type, Coordinate coordinate);
// For messages: "angle", "displacement_x" or "displacement_y"
std::string coordinate_names(JointType type);

// What acts on one coordinate of a joint, by the laws of struts: lengths are then angles [rad] and forces torques [N m] on
// an angle. friction: dry with stick, and viscous. spring: torque = -stiffness (coordinate - free_stroke) - damping rate.
struct CoordinateSpec {
  std::optional<EndStopParameters> stops;
  std::optional<JointFrictionParameters> friction;
  std::optional<LinearSpringDamperParameters> spring;
};

struct JointSpec {
  Source source;
  std::string name;
  JointType type = JointType::kFixed;
  std::array<std::string, 2> bodies;     // a, b; "ground" is allowed for one of them
  std::optional<Eigen::Vector3d> point;  // gives both of the next two [m]
  // The joint's point on a and on b in D [m]. They may differ for distance and point_on_plane
  // (a: a point of the plane), and rolling (likewise; b: the centre of the wheel) only; else the gap is checked.
  Eigen::Vector3d point_a = Eigen::Vector3d::Zero();
  Eigen::Vector3d point_b = Eigen::Vector3d::Zero();
  // unit vector; revolute, prismatic, cylindrical, planar, prescribed; universal: axis
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  // fixed in a; point_on_plane, rolling: normal of the plane, fixed in a
  // universal: axis fixed in b, perpendicular to `axis`; constant_velocity: axis of the shaft b (not given: `axis`);
  // prescribed, planar: x axis; rolling: axis of a disc, fixed in b (not given: a sphere)
  Eigen::Vector3d axis2 = Eigen::Vector3d::UnitX();
  std::optional<double> length;      // distance [m]; not given: between the points
  std::optional<double> radius;      // rolling [m] > 0
  std::optional<MotionSpec> motion;  // prescribed
  // Force laws on its coordinates, where it has them.
  std::optional<CoordinateSpec> angle, displacement, displacement_x, displacement_y;
  const std::optional<CoordinateSpec>& acting_on(Coordinate coordinate) const;
};

// Motors and brakes of a scene: each acts on one coordinate of a joint, by a limited torque or force. Torque and speed are
// measured at the motor; at the joint they are gear_ratio times larger and smaller. On a displacement the joint has a force
// instead of a torque, and the gear ratio the unit rad/m.
struct DriveSpec {
  Source source;
  std::string name;
  MotorParameters motor;  // kind, gains, limits and gear; its command is made of `command`
  std::string joint;
  std::optional<Coordinate> coordinate;  // not given ("auto"): the only one of the joint
  // kTorque: of the motor [N m]; kSpeed: of the joint [rad/s or m/s]; kPosition: of the joint [rad or m]; kBrake: pressing,
  // limited to [0, 1] [-]
  std::optional<TimeFunctionSpec> command;
  double lag = BrakeParameters{}.lag;                      // of the brake behind its command [s] > 0
  double rotor_inertia = 0.0;                              // about the motor's axis [kg m2] >= 0
  double stick_damping = BrakeParameters{}.damping_ratio;  // of the brake; not a key
};

// Gears of a scene: a weighted sum of coordinates of joints that remains zero, as in the reference configuration.
// sum_i factors[i] q_i = 0. Two external wheels with n1 and n2 teeth: [n1, n2] about parallel axes; an internal one:
// [n1, -n2]. A rack: [pitch radius, -1]. A differential: [1, 1, -2]. A cam: the last coordinate is replaced by y(q) - y(0).
struct GearSpec {
  Source source;
  std::string name;
  std::vector<std::string> joints;  // two or more
  std::vector<double> factors;      // of each joint, none zero [1/rad or 1/m, times a common unit]
  // Of each joint: "angle", "displacement" ... or "auto" (its only one); empty: all "auto"
  std::vector<std::string> coordinates;
  std::vector<Eigen::Vector2d> curve;  // of a cam: (q [rad or m], y), q rising; empty: none
  bool closed = false;                 // the curve is periodic: over one turn of an angle, any length of a displacement
};

}  // namespace footfall
