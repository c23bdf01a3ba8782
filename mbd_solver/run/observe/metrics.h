#pragma once
// Strain energy, largest deflection and largest von Mises stress of every flexible body: now, and the largest so far;
// and whether the body is still where linear modes hold.

#include <string>
#include <vector>

#include "coupler/archive.h"
#include "mbd_solver/dynamics/energy_flow.h"
#include "mbd_solver/run/observe/sampler.h"

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

// Coordinates of joints with their rates, and reactions, at every sample.
// An angle goes on over any number of turns. Between two samples it is predicted from the rates and their derivatives,
//   q_1 ~ q_0 + h (q'_0 + q'_1) / 2 + h^2 (q''_0 - q''_1) / 12,   off by O(h^5)
// and the turn nearest to that is taken; where it is off by more than a quarter of a turn, the samples are too far
// apart to tell, and a warning says so.

struct CoordinateFigures {
  double value = 0.0;  // [rad or m]
  double rate = 0.0;   // [rad/s or m/s]
  void visit(Archive& archive) {
    archive("value", value);
    archive("rate", rate);
  }
};

class JointFigures {
 public:
  // What the subject views must outlive this.
  explicit JointFigures(const Subject& subject);

  void take(const Sample& sample);
  const std::vector<std::string>& warnings() const { return warnings_; }  // once per joint
  void visit(Archive& archive) {
    archive("started", started_);
    archive("time", time_);
    archive("now", now_);
    archive("acc", acc_);
    archive("warned", warned_);
    archive("warnings", warnings_);
    archive("reactions", reactions_);
  }

  // Of mechanism.coordinates[k].
  const CoordinateFigures& coordinate(std::size_t k) const { return now_[k]; }
  // Force [N] and moment [N m] of a joint of the scene on its body b, about its point there, in W; only where
  // output.reactions is set.
  const Vector6d& reaction(std::size_t joint) const { return reactions_[joint]; }

 private:
  void follow(std::size_t k, double h, const JointCoordinate& at);

  Subject subject_;
  bool started_ = false;
  double time_ = 0.0;  // of the last sample [s]
  std::vector<CoordinateFigures> now_;
  std::vector<double> acc_;  // q'' [rad/s2 or m/s2]
  std::vector<bool> warned_;
  std::vector<std::string> warnings_;
  std::vector<Vector6d> reactions_;
};

// The figures of summary.json that are peaks of a run: largest values over every window, not only over the rows that
// are written.

// of the energy that flowed: more than time integration with usual tolerances leaves open
inline constexpr double kGoodBalance = 0.01;

struct Figures {
  double peak_acceleration = 0.0;  // of the heaviest body [m/s2]
  double max_descent = 0.0;        // of the heaviest body against gravity's direction, from the start [m]
  double max_penetration = 0.0;    // of any boundary below the plane, or below the grains' height at the start [m]
  double max_contact_force = 0.0;  // on one body [N]
  double reference_energy = 0.0;   // initial mechanical energy without gravity; else the largest kinetic energy [J]
  double energy_flow = 0.0;        // moved from one form to another: EnergyFlow::scale() [J]
  double energy_balance = 0.0;     // largest |E - E0 + dissipated - work of contact, motions, forces, drives| [J]
  double energy_noise = 0.0;       // what errors of atol in place alone make of weights and of what joints hold [J]
  double contact_work = 0.0;       // done by the ground's grains on the mechanism so far [J]
  double contact_force = 0.0;      // on all bodies now [N]

  double energy_balance_relative() const { return energy_flow > 0.0 ? energy_balance / energy_flow : 0.0; }
};

class FigureTaker {
 public:
  // What the subject views must outlive this.
  explicit FigureTaker(const Subject& subject);
  void take(const Sample& sample);
  const Figures& figures() const { return figures_; }
  // What to tell when the mechanism's energy did not close to kGoodBalance, by more than energy_noise; empty otherwise.
  std::string balance_warning() const;
  void visit(Archive& archive);
  const std::string& body_name() const;  // the heaviest body, whose acceleration and descent are reported

 private:
  double depth(const Sample& sample) const;  // of the lowest place of all boundaries below the ground [m]

  Subject subject_;
  Figures figures_;
  EnergyFlow flow_;
  Eigen::Vector3d up_, normal_;  // against gravity; out of the ground
  double ground_;                // height of the ground along its normal [m]
  int body_ = 0;
  double start_height_ = 0.0;  // [m]
  double start_energy_ = 0.0;  // [J]
  bool started_ = false;
};

}  // namespace footfall
