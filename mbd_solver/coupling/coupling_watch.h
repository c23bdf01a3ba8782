#pragma once
// How well the two programs fit together, measured in every window: energy that the interface makes or loses, omega H
// of each body, forces that chatter. theory 7.9.

#include <string>
#include <vector>

#include "coupler/archive.h"
#include "coupler/messages.h"
#include "mbd_solver/scene/run_spec.h"

namespace footfall {

class CouplingWatch {
 public:
  // Names and masses [kg] of the coupled bodies in the order of Load; limits of the scene.
  CouplingWatch(std::vector<std::string> names, std::vector<double> masses, const CouplingSpec& limits);

  // One window of n substeps, H [s] long: what the grains did (load) and the work that arrived at each body [J].
  // reference_energy [J]: the scale against which the residual is judged. pending [J]: work that the grains will do
  // when the next window starts from the computed motion, and that the bodies have received already. Throws
  // NumericalError when the interface pumps energy or the mean force chatters, naming time, body and what to do.
  void window(double time, double H, int n, const Load& load, const std::vector<double>& work_received,
              double reference_energy, double pending = 0.0);

  // `every auto`: omega H above which body i is warned of, in place of warn_omega_h, from now on.
  void allow(std::size_t i, double omega_h) { warn_omega_h_[i] = omega_h; }

  // Scheme `tangent`, per window: impulse that body i has felt beyond what the grains gave, and the size of what they
  // gave [N s].
  void count_surplus(std::size_t i, double time, const Eigen::Vector3d& surplus, double given);

  void visit(Archive& archive);

  double energy_residual() const { return residual_; }  // sum of (work on the boundary - work received), + pending [J]
  double largest_energy_residual() const { return largest_residual_; }
  double largest_overlap() const { return largest_overlap_; }      // of radius [-]
  double largest_force() const { return largest_force_; }          // mean over a window, on one body [N]
  const std::vector<double>& omega_h() const { return omega_h_; }  // of the last window, per body [-]
  const std::vector<double>& largest_omega_h() const { return largest_omega_h_; }
  const std::vector<std::string>& names() const { return names_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  void watch_overlap(double time);
  void watch_chatter(std::size_t body, const Eigen::Vector3d& force, double time, int n);

  std::vector<std::string> names_;
  std::vector<double> masses_;
  CouplingSpec limits_;
  double sum_ = 0.0;                                // of work on the boundary - work received [J]
  double residual_ = 0.0, largest_residual_ = 0.0;  // [J]
  bool warned_of_gain_ = false, warned_of_overlap_ = false;
  double largest_overlap_ = 0.0, largest_force_ = 0.0;
  std::vector<double> omega_h_, largest_omega_h_, warn_omega_h_;
  std::vector<bool> warned_;
  std::vector<Eigen::Vector3d> surplus_;  // per body, since the start [N s]
  std::vector<double> given_;             // likewise [N s]
  bool warned_of_surplus_ = false;
  double largest_impulse_ = 0.0;  // of given_ [N s]
  int surplus_windows_ = 0;
  std::vector<Eigen::Vector3d> force_, change_;  // of the last window, per body [N]
  std::vector<int> alternations_;  // windows in a row in which the force swung by more than half of itself
  std::vector<std::string> warnings_;
};

}  // namespace footfall
