#pragma once
// Seeded random vectors and chains, and the search over all segments, for the tests of beams.

#include <Eigen/Dense>
#include <random>
#include <vector>

#include "coupler/modal_boundary.h"
#include "liggghts_fix/link/beam_chain.h"

namespace footfall::test {

class RandomBeams {
 public:
  explicit RandomBeams(unsigned seed) : seed_(seed), engine_(seed) {}
  unsigned seed() const { return seed_; }
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
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
inline ModalBoundary random_chain(RandomBeams& random, int segments) {
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

// The touch of a sphere with the smallest gap over all segments.
inline BeamTouch closest(const BeamChain& chain, const Eigen::Vector3d& x, double r) {
  BeamTouch best = chain.touch(0, x, r);
  for (int s = 1; s < chain.segment_count(); ++s) {
    const BeamTouch other = chain.touch(s, x, r);
    if (other.gap < best.gap) best = other;
  }
  return best;
}

}  // namespace footfall::test
