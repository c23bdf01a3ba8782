#pragma once
// A mechanism of rigid bodies as plain data in W at its start, so that it can be shifted, turned, reordered and written
// with other joints before it becomes a Model. All points and axes belong to the initial position.

#include <Eigen/Dense>
#include <functional>
#include <string>
#include <vector>

#include "mbd_solver/model/model.h"

namespace footfall::test {

struct PlannedBody {
  std::string name;
  double mass = 1.0;                                      // [kg]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Identity();  // about the mass centre, in B [kg m2]
  BodyState state;
};

enum class JointKind {
  kFixed,
  kSpherical,
  kUniversal,
  kRevolute,
  kPrismatic,
  kCylindrical,
  kDistance,
  kPlane,      // point of body 2 in the plane through the point of body 1
  kDriven,     // a hinge whose angle is a given function of time
  kAxialHold,  // point on plane across the axis: with a cylinder it is a hinge
  kDisc,       // a thin disc on body 2 rolls on a plane of body 1: centre point_2, axis z of axes_2
  kSphere      // a sphere likewise
};

struct PlannedJoint {
  std::string name;
  JointKind kind = JointKind::kFixed;
  int body_1 = kGround, body_2 = kGround;
  Eigen::Vector3d point_1 = Eigen::Vector3d::Zero(), point_2 = point_1;  // they differ for kDistance alone [m]
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();                    // of both markers
  Eigen::Matrix3d axes_2 = Eigen::Matrix3d::Identity();                  // kDisc, kSphere: of marker 2
  double drive_rate = 0.0, drive_sway = 0.0;                             // kDriven: angle = rate t + sway sin(2 pi t)
};

struct PlannedForce {
  std::string name;
  int body_1 = kGround, body_2 = kGround;
  Eigen::Vector3d point_1 = Eigen::Vector3d::Zero(), point_2 = point_1;  // [m]
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  // Makes the element between two markers `length` apart.
  std::function<std::unique_ptr<ForceElement>(const std::string& name, const Marker& m1, const Marker& m2,
                                              double length)>
      make;
};

// A gear between angles and displacements of joints, which are zero at the start.
struct PlannedGear {
  std::string name;
  struct Member {
    std::string joint;
    Coordinate coordinate;
    double factor;
  };
  std::vector<Member> members;
};

// The inertia of a rotor on a coordinate of a joint.
struct PlannedRotor {
  std::string joint;
  Coordinate coordinate = Coordinate::kAngle;
  double inertia = 0.0;  // [kg m2 or kg]
};

struct Plan {
  std::string what;  // for messages: family and seed
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
  std::vector<PlannedBody> bodies;
  std::vector<PlannedJoint> joints;
  std::vector<PlannedForce> forces;
  std::vector<PlannedGear> gears;
  std::vector<PlannedRotor> rotors;
  bool rough = false;          // a force has kinks or steep places: no order of convergence is expected
  double duration = 0.5;       // [s]
  double regular_until = 0.5;  // so long no position is near a singular one, in which the motion may branch [s]
};

Model build(const Plan& plan);

// The same with the initial state that the assembly finds: joints closed to round-off, velocities that fit them.
Plan settled(Plan plan);

// The joint of the model that is called so.
int joint_index(const Model& model, const std::string& name);

// The same mechanism elsewhere: every point p at R p + d.
Plan moved(Plan plan, const Eigen::Matrix3d& R, const Eigen::Vector3d& d);
// With other names, and bodies, joints and forces in another order: body i becomes body order[i].
Plan reordered(Plan plan, const std::vector<int>& order);
// Every hinge as a cylinder and a point on a plane across its axis.
Plan with_split_hinges(Plan plan);
// Another body of mass `mass` held by a fixed joint at `offset` (in W) from the mass centre of body `index` ...
Plan with_passenger(Plan plan, int index, double mass, const Eigen::Vector3d& offset);
// ... and the same as one body, whose mass centre lies at mass / (m + mass) offset.
Plan with_merged_passenger(Plan plan, int index, double mass, const Eigen::Vector3d& offset);

}  // namespace footfall::test
