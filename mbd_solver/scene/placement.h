#pragma once
// Where [initial] puts the drawing, and how every body moves at the start.

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "mbd_solver/scene/scene.h"

namespace footfall {

// A point x of D stands at p + R x in W; directions turn with R.
struct Placement {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d p = Eigen::Vector3d::Zero();   // [m]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // total mass centre, in W [m]
  Eigen::Vector3d operator()(const Eigen::Vector3d& x_D) const { return p + R * x_D; }
};

// Points of one boundary in D, and how far it reaches beyond them (beams; zero for surfaces).
struct TouchingPoints {
  std::vector<Eigen::Vector3d> x_D;  // [m]
  double radius = 0.0;               // [m]
};
// Of every boundary of the scene, from its surface and chain as drawn.
std::vector<TouchingPoints> touching_points(const Scene& scene);

// With a clearance, the gap is that of the nearest pair: a boundary's lowest point above the highest grain under that boundary, or any
// point and the plane. Throws InputError when a clearance is wanted and the height of the ground is not known.
Placement place(const Scene& scene, const std::vector<TouchingPoints>& touching);
inline Placement place(const Scene& scene) { return place(scene, scene.initial.clearance ? touching_points(scene) : std::vector<TouchingPoints>{}); }

// Motion of body `index` at the start, in W: that of the mechanism as one rigid body, or what [[initial.bodies]] says.
struct InitialMotion {
  Eigen::Vector3d position;          // of the mass centre [m]
  Eigen::Quaterniond orientation;    // R_WB
  Eigen::Vector3d velocity;          // of the mass centre [m/s]
  Eigen::Vector3d angular_velocity;  // [rad/s]
};
InitialMotion initial_motion(const Scene& scene, const Placement& placement, int index);

// Grains of a LIGGGHTS text dump (columns x y z radius). Throws InputError "file:line: ...".
struct Grain {
  Eigen::Vector3d x;  // [m]
  double radius;      // [m]
};
std::vector<Grain> read_grains(const std::string& file);

}  // namespace footfall
