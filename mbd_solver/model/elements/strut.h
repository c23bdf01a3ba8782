#pragma once
// A strut: a line of force between two markers, with any number of laws that share stroke and rate.
//   d = p2 - p1, length l = |d|, e = d/l;  stroke x = l0 - l, rate = -e.d'
//   force F(x, rate, U, z) along e, positive when it pushes the ends apart
// A point-to-point spring-damper is a strut with a spring and a damper law.

#include <memory>
#include <vector>

#include "mbd_solver/model/force_element.h"
#include "mbd_solver/model/laws/strut_law.h"

namespace footfall {

struct StrutSample {
  double stroke = 0.0;  // [m], compression positive
  double rate = 0.0;    // [m/s]
  double force = 0.0;   // [N], compression positive
};

struct StrutMotion {
  double stroke = 0.0;  // [m], compression positive
  double rate = 0.0;    // [m/s]
};

class Strut : public ForceElement {
 public:
  // undeformed_length [m] > 0: length at zero stroke. voltage_index: of the voltage among the inputs; -1: U = 0. Throws
  // InputError if the length is not positive.
  Strut(std::string name, Marker m1, Marker m2, std::vector<std::unique_ptr<StrutLaw>> laws, double undeformed_length,
        int voltage_index = -1);

  int state_count() const override { return states_; }
  std::array<int, 2> read_inputs() const override { return {voltage_index_, -1}; }
  Eigen::VectorXd initial_state() const override;
  std::unique_ptr<ElementScratch> scratch(SharedCopies& shared) const override;
  void add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q, Eigen::Ref<Eigen::VectorXd> dz) const override;
  bool add_derivatives(const ElementInput& in, ElementDerivatives& out) const override;
  void add_energy(const ElementInput& in, StoredEnergy& stored, Dissipated& power) const override;

  StrutSample sample(const ElementInput& in) const;
  StrutMotion motion(const PairMotion& pair) const;
  double undeformed_length() const { return length_; }
  const std::vector<std::unique_ptr<StrutLaw>>& laws() const { return laws_; }
  int first_state(std::size_t law) const { return first_state_[law]; }  // of this law within the element's z

 private:
  struct Scratch;
  struct Line {
    KinematicVector d;
    double length, stroke, rate;
    Eigen::Vector3d e;
  };
  Line line(const PairMotion& pair) const;  // throws NumericalError if the two points coincide
  StrutInput law_input(const ElementInput& in, const Line& line, std::size_t law) const;
  // adds the strut's name to errors
  const StrutOutput& evaluate(const ElementInput& in, const Line& line, std::size_t law) const;

  Marker m1_, m2_;
  std::vector<std::unique_ptr<StrutLaw>> laws_;
  std::vector<int> first_state_;
  double length_;  // [m]
  int voltage_index_;
  int states_ = 0;
};

}  // namespace footfall
