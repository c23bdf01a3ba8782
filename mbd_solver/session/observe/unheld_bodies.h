#pragma once
// Bodies that the ground does not hold, or only coarsely (assemble/build_hulls.cpp): they have a shape, but no boundary.

#include <optional>
#include <string>
#include <vector>

#include "coupler/archive.h"
#include "mbd_solver/session/observe/landing.h"
#include "mbd_solver/session/observe/sampler.h"

namespace footfall {

class UnheldBodies {
 public:
  explicit UnheldBodies(const Subject& subject);
  void update(const Sample& sample);
  // Names those that went through the surface during the run, the deepest first; empty: none.
  std::string warning() const;
  void visit(Archive& archive) { archive("unheld_bodies", depths_); }

 private:
  struct Watched {
    int body = 0;
    std::string name;
    double size = 0.0;                     // largest distance of a point from the mass centre [m]
    std::vector<Eigen::Vector3d> outline;  // of its shape, in the axes of the body [m]
    bool held = false;                     // by a coarse surface
  };
  struct Depth {
    double start = -1.0, largest = 0.0, time = 0.0;  // below the surface [m], [s]; start < 0: above it, or not seen yet
    void visit(Archive& archive);
  };
  std::vector<Watched> watched_;
  std::vector<Depth> depths_;  // of each
  std::optional<GroundLevel> ground_;
};

}  // namespace footfall
