#pragma once
// What evaluations of rigs have in common: histories, means over bins, least squares.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "mbd_solver/cli/rigs/rig.h"
#include "mbd_solver/output/history.h"

namespace footfall {

History history_of(const RigRun& run);
// A body of the scene. Throws InputError naming the rig's need when there is none.
const BodySpec& body_of(const Scene& scene, const std::string& name);
// The shape of one that is the mesh of this file of inputs/rigs/scenes: the rig knows its dimensions by its scale alone.
// Throws InputError for any other.
const ShapeSpec& mesh_of(const Scene& scene, const std::string& name, const std::string& file);
// The bed. Throws InputError when there is none of [particles.box].
const BoxSpec& box_of(const Scene& scene);
// Where the bed's mean surface lies: about a radius of the larger grains below z = 0 [m], negative.
double mean_surface(const RigRun& run);
double gravity_of(const RigRun& run);  // its size [m/s2]

// Means of x and y over `count` equal bins of x in [from, to]; empty bins are left out.
struct Bins {
  std::vector<double> x, y;
};
Bins binned(const std::vector<double>& x, const std::vector<double>& y, double from, double to, int count);

// Mean of the rows after the share `from` of the time.
double late_mean(const History& history, const std::string& column, double from);

// y = A c by least squares. `valid` is false when there are not more rows than coefficients, or A has not full rank; c is
// then NaN. R^2 is about the mean of y.
struct LineFit {
  bool valid = false;
  Eigen::VectorXd c;
  double r_squared = 0.0;
};
LineFit least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& y);

}  // namespace footfall
