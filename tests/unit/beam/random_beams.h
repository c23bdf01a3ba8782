#pragma once
// Seeded random vectors and chains for the tests of beams.

#include <Eigen/Dense>
#include <random>
#include <vector>

#include "coupler/modal_boundary.h"

namespace footfall::test {

class Random {
 public:
  explicit Random(unsigned seed) : seed_(seed), engine_(seed) {}
  unsigned seed() const { return seed_; }
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  // Each component between -size and size.
  Eigen::Vector3d vector(double size) {
    const double x = between(-size, size), y = between(-size, size), z = between(-size, size);
    return {x, y, z};
  }

 private:
  unsigned seed_;
  std::mt19937 engine_;
};

// A winding chain inside a box of a few metres: steps of 0.05 to 0.4 m, turning up to about 60 degrees,
// radius 0.02 to 0.1 m.
inline ModalBoundary random_chain(Random& random, int segments) {
  Eigen::Matrix3Xd nodes(3, segments + 1);
  nodes.col(0) = random.vector(1.0);
  Eigen::Vector3d direction = random.vector(1.0).normalized();
  std::vector<BeamSegment> list;
  const double radius = random.between(0.02, 0.1);
  for (int i = 1; i <= segments; ++i) {
    nodes.col(i) = nodes.col(i - 1) + random.between(0.05, 0.4) * direction;
    direction = (direction + random.vector(0.6)).normalized();
    list.push_back({i - 1, i, radius, 0});
  }
  return ModalBoundary("chain", nodes, {}, list);
}

}  // namespace footfall::test
