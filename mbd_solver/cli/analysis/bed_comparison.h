#pragma once
// Two beds of grains side by side, moment by moment, and the forces on what touched them.

#include <Eigen/Dense>
#include <string>
#include <vector>

namespace footfall {

// Of one run. Times are ends of windows [s].
struct ComparedBody {
  std::vector<double> time;
  std::vector<Eigen::Vector3d> force;  // mean of the grains on the body in the window that ends then [N]
};
struct ComparedRun {
  std::string label;                 // "coupled"
  std::string frames;                // folder of the dumps of grains
  std::vector<ComparedBody> bodies;  // the same, in the same order, in both runs
};

// Where a surface was, for what lies under it.
struct SurfacePath {
  std::string body;
  double radius = 0.0;  // of the surface about its mean, level [m]
  std::vector<double> time;
  std::vector<Eigen::Vector3d> place;  // mean of its nodes [m]
};

struct Comparison {
  std::string beds;     // CSV: figures of both beds at every moment that both dumped
  std::string forces;   // CSV: size of the forces of both runs on each body
  std::string profile;  // CSV: height of the surface around the first body at the last moment
  std::string table;    // for people
  // largest relative difference of the impulse on one body in the first 0.1 s of contact [-]
  double worst_impulse = 0.0;
  bool has_beds = false;  // both runs dumped their grains
};

Comparison compare_beds(const ComparedRun& a, const ComparedRun& b, const std::vector<SurfacePath>& surfaces,
                        double dt);

}  // namespace footfall
