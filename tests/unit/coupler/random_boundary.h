#pragma once
// Seeded random boundaries and motions for tests of the coupler.

#include <random>

#include "coupler/modal_boundary.h"

namespace footfall::test {

class RandomNumbers {
 public:
  explicit RandomNumbers(unsigned seed) : generator_(seed) {}
  double number() { return std::uniform_real_distribution<double>(-1.0, 1.0)(generator_); }
  double share() { return 0.5 * (1.0 + number()); }
  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(generator_); }
  Eigen::Vector3d vector() { return {number(), number(), number()}; }
  template <class Matrix>
  void fill(Matrix& m) {
    for (Eigen::Index i = 0; i < m.size(); ++i) m.data()[i] = number();
  }
  BodyMotion motion(int modes) {
    BodyMotion m(modes);
    m.r = vector();
    m.L = turned(m.L, 3.0 * vector());
    m.dr = vector();
    m.w = 2.0 * vector();
    m.ddr = 5.0 * vector();
    m.dw = 5.0 * vector();
    fill(m.a);
    fill(m.da);
    fill(m.dda);
    m.a *= 0.1;
    return m;
  }
  // Nodes, triangles and one chain of segments; s = modes.
  ModalBoundary boundary(int nodes, int modes) {
    Eigen::Matrix3Xd rho0(3, nodes);
    fill(rho0);
    std::vector<Eigen::Vector3i> triangles;
    std::vector<BeamSegment> segments;
    for (int j = 0; j + 2 < nodes; ++j) triangles.emplace_back(j, j + 1, j + 2);
    for (int j = 0; j + 1 < nodes; ++j) segments.push_back({j, j + 1, 0.1, 0});
    Eigen::MatrixXd Phi(modes > 0 ? 3 * nodes : 0, modes), Psi(modes > 0 ? 3 * nodes : 0, modes);
    fill(Phi);
    fill(Psi);
    return ModalBoundary("random", rho0, triangles, segments, Phi, Psi);
  }
  Eigen::Vector3d weights() {
    const Eigen::Vector3d w{share(), share(), share()};  // in braces: from left to right with every compiler
    return w / w.sum();
  }

 private:
  std::mt19937 generator_;
};

}  // namespace footfall::test
