#pragma once
// The figures of summary.json that are peaks of a run: largest values over every window, not only over the rows that
// are written.

#include <string>

#include "coupler/archive.h"
#include "mbd_solver/dynamics/energy_flow.h"
#include "mbd_solver/observe/sample.h"

namespace footfall {

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
