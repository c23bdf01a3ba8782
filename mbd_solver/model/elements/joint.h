#pragma once
// A joint: two markers and a list of scalar conditions. The functions below make all kinds from the rows of
// constraint_row.h; the equations of motion know no kinds of joints.

#include <array>
#include <string>
#include <vector>

#include "coupler/body_motion.h"
#include "mbd_solver/model/elements/constraint_row.h"
#include "mbd_solver/model/marker.h"

namespace footfall {

struct Joint {
  std::string name;
  std::string kind;  // "revolute", ...
  Marker m1, m2;     // on bodies m1.body and m2.body (or kGround)
  std::vector<ConstraintRow> rows;
  // Of a member of a gear (gear.h) after the first: the first member's joint, to whose row it contributes.
  int row_of = -1;
  int turn_counter = -1;      // of a gear's angle: the force element that counts its turns
  bool counts_turns = false;  // its angle about z is reported over any number of turns (State::angles)
};

// Force and moment [N, N m] that the joint exerts on its body 2, about the point of marker 2, in W.
// lambda: of its rows.
Vector6d joint_wrench(const Joint& joint, const PairMotion& pair, double t,
                      const Eigen::Ref<const Eigen::VectorXd>& lambda);

// Number of rows, and the motion of body 2 against body 1 that remains. z is the joint axis of both markers.
Joint fixed_joint(std::string name, Marker m1, Marker m2);      // 6: axes of the markers coincide
Joint spherical_joint(std::string name, Marker m1, Marker m2);  // 3: points coincide
// 4: points coincide, x1 stays perpendicular to y2
Joint universal_joint(std::string name, Marker m1, Marker m2);
Joint revolute_joint(std::string name, Marker m1, Marker m2);     // 5: rotation about z
Joint prismatic_joint(std::string name, Marker m1, Marker m2);    // 5: displacement along z, attitudes coincide
Joint cylindrical_joint(std::string name, Marker m1, Marker m2);  // 4: rotation about and displacement along z
Joint planar_joint(std::string name, Marker m1, Marker m2);       // 3: displacement along x1 and y1, rotation about z
// 4: points coincide; z1 and z2 may form an angle, and the bodies rotate about them at the same speed
Joint constant_velocity_joint(std::string name, Marker m1, Marker m2);
// No condition: a rotor that turns with a joint coordinate. inertia, reduced to the coordinate: J > 0 [kg m2 or kg]
Joint rotor(std::string name, Marker m1, Marker m2, Coordinate coordinate, double inertia);
// 3: a wheel of radius > 0 [m] rolls without slip on the plane of marker 1 (normal z1), its centre at marker 2: a thin disc
// with the axis z2, or a sphere.
Joint rolling_joint(std::string name, Marker m1, Marker m2, double radius, bool disc);
// 1: |p2 - p1| = length > 0 [m] (InputError)
Joint distance_joint(std::string name, Marker m1, Marker m2, double length);
// 1: z1.(p2 - p1) = height [m]
Joint point_on_plane_joint(std::string name, Marker m1, Marker m2, double height = 0.0);

// Motion of marker 2 against marker 1, along and about the axes of marker 1. Null coordinates are free.
struct PrescribedMotion {
  std::array<TimeFunctionPtr, 3> translation;  // of p2 - p1 along x1, y1, z1 [m]
  TimeFunctionPtr rotation;                    // about `rotation_axis` of marker 1 [rad]
  int rotation_axis = 2;                       // 0, 1, 2
  bool hold_other_rotations = false;           // two more rows: `rotation_axis` of both markers stays parallel
};
Joint prescribed_joint(std::string name, Marker m1, Marker m2, const PrescribedMotion& motion);

}  // namespace footfall
