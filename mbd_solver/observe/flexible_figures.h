#pragma once
// Strain energy, largest deflection and largest von Mises stress of every flexible body: now, and the largest so far;
// and whether the body is still where linear modes hold.

#include <string>
#include <vector>

#include "coupler/archive.h"
#include "mbd_solver/observe/sample.h"

namespace footfall {

struct FlexibleFigures {
  double strain_energy = 0.0;  // 1/2 a^T K a [J]
  double deflection = 0.0;     // largest |Phi_j a| of all nodes [m]
  double von_mises = 0.0;      // largest of all stress points [Pa]; 0 for a body without
  double spin = 0.0;           // |w| over the lowest elastic frequency [-]
};

class FlexibleBodies {
 public:
  // What the subject views must outlive this.
  explicit FlexibleBodies(const Subject& subject);

  void take(const Sample& sample);
  // Told once per body and cause: it spins too fast or bends too far for linear modes (linear_range.h), or its material
  // yields.
  const std::vector<std::string>& warnings() const { return warnings_; }

  void visit(Archive& archive);

  int count() const { return static_cast<int>(bodies_.size()); }
  int find(int body) const;  // place of a body of the model here, or -1: it is rigid
  const Body& body(int k) const;
  const FlexibleFigures& now(int k) const { return now_[static_cast<std::size_t>(k)]; }
  const FlexibleFigures& peak(int k) const { return peak_[static_cast<std::size_t>(k)]; }  // of each figure by itself

 private:
  // What a body is watched with, and what has been told of it.
  struct Watch {
    double lowest = 0.0;        // elastic frequency [rad/s]
    double extent = 0.0;        // [m]
    double yield_stress = 0.0;  // [Pa]; 0: not known
    bool spins = false, bends = false, yields = false;
  };
  void warn(double time, int k);

  const Model& model_;
  std::vector<int> bodies_;  // in the model
  std::vector<FlexibleFigures> now_, peak_;
  std::vector<Watch> watch_;
  std::vector<std::string> warnings_;
};

}  // namespace footfall
