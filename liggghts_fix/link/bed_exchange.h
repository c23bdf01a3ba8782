#pragma once
// What becomes of the grains where a bed that follows a body moves on by a slab: the grains of the slab go, others come there.
// Neighbouring grains that would be pressed into the new ones are laid on top of the bed behind. What is then missing or too
// much, in all since the start, has been pushed across an end of the bed by bodies: so many of the uppermost grains that would
// go are laid there instead, or so many of those there go as well. So the mass that goes is that which comes, to half of
// a grain, unless a body is in the way or it is more than half of a slab; then the next slab makes up for it.

#include <Eigen/Dense>
#include <map>
#include <vector>

namespace footfall {

struct BedGrain {
  int tag = 0;
  Eigen::Vector3d x = Eigen::Vector3d::Zero();  // in the box [m]
  double radius = 0.0, mass = 0.0;              // [m], [kg]
};

struct SlabChange {
  int axis = 0;                                      // 0: x, 1: y
  int way = 1;                                       // of the window along it: 1 or -1
  double end = 0.0;                                  // of the slab, behind which the bed has been passed [m]
  double room = 0.0;                                 // behind that end to the nearest body [m]
  Eigen::Vector2d period = Eigen::Vector2d::Zero();  // of the box along x and y; 0: none [m]
  double allowed_overlap = 0.0;  // of grains that stay with those that come, over the smaller radius [-]
  double excess = 0.0;           // mass that went over mass that came, before this slab [kg]
  std::vector<BedGrain> in_slab, beside, coming;  // beside: all that may touch those that come, and those in the room
};

struct BedExchange {
  std::vector<int> removed;               // tags, ascending
  std::map<int, Eigen::Vector3d> lifted;  // new places by tags, at which they touch nothing
};

BedExchange bed_exchange(const SlabChange& change);

}  // namespace footfall
