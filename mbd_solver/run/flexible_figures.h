#pragma once
// Strain energy, largest deflection and largest von Mises stress of every flexible body: now, and the largest so far.

#include <vector>

#include "mbd_solver/run/simulation.h"

namespace footfall {

struct FlexibleFigures {
  double strain_energy = 0.0;  // 1/2 a^T K a [J]
  double deflection = 0.0;     // largest |Phi_j a| of all nodes [m]
  double von_mises = 0.0;      // largest of all stress points [Pa]; 0 for a body without
};

class FlexibleBodies {
 public:
  explicit FlexibleBodies(const Simulation& simulation);

  void take(const Sample& sample);

  int count() const { return static_cast<int>(bodies_.size()); }
  int find(int body) const;                                  // place of a body of the model here, or -1: it is rigid
  const Body& body(int k) const;
  const FlexibleFigures& now(int k) const { return now_[static_cast<std::size_t>(k)]; }
  const FlexibleFigures& peak(int k) const { return peak_[static_cast<std::size_t>(k)]; }  // of each figure by itself

 private:
  const Simulation& simulation_;
  std::vector<int> bodies_;  // in the model
  std::vector<FlexibleFigures> now_, peak_;
};

}  // namespace footfall
