#pragma once
// A joint: two markers and a list of scalar conditions. All kinds are made by the functions below from the
// primitives of constraint_row.h; none has code of its own in the equations of motion.

#include <array>
#include <string>
#include <vector>

#include "mbd_solver/model/joints/constraint_row.h"
#include "mbd_solver/model/marker.h"

namespace footfall {

struct Joint {
  std::string name;
  std::string kind;  // "revolute", ...
  Marker m1, m2;     // on bodies m1.body and m2.body (or kGround)
  std::vector<ConstraintRow> rows;
};

// Rows and the freedom they leave (body 2 against body 1). z is the joint axis of both markers.
Joint fixed_joint(std::string name, Marker m1, Marker m2);      // 6: axes of the markers coincide
Joint spherical_joint(std::string name, Marker m1, Marker m2);  // 3: points coincide
// 4: points coincide, x1 stays perpendicular to y2
Joint universal_joint(std::string name, Marker m1, Marker m2);
Joint revolute_joint(std::string name, Marker m1, Marker m2);     // 5: turns about z
Joint prismatic_joint(std::string name, Marker m1, Marker m2);    // 5: slides along z, attitudes coincide
Joint cylindrical_joint(std::string name, Marker m1, Marker m2);  // 4: turns about and slides along z
// 1: |p2 - p1| = length > 0 [m] (InputError)
Joint distance_joint(std::string name, Marker m1, Marker m2, double length);
// 1: z1.(p2 - p1) = height [m]
Joint point_on_plane_joint(std::string name, Marker m1, Marker m2, double height = 0.0);

// Motion of marker 2 against marker 1, along and about the axes of marker 1. Coordinates left null are free.
struct PrescribedMotion {
  std::array<TimeFunctionPtr, 3> translation;  // of p2 - p1 along x1, y1, z1 [m]
  TimeFunctionPtr rotation;                    // about `rotation_axis` of marker 1 [rad]
  int rotation_axis = 2;                       // 0, 1, 2
  bool hold_other_rotations = false;           // adds the two rows that keep `rotation_axis` of both markers parallel
};
Joint prescribed_joint(std::string name, Marker m1, Marker m2, const PrescribedMotion& motion);

}  // namespace footfall
