#pragma once
// How well the two programs fit together, measured in every window: energy that the interface makes or loses, omega H
// of each body, forces that chatter. theory 7.9.

#include <string>
#include <vector>

#include "coupler/archive.h"
#include "coupler/messages.h"
#include "mbd_solver/scene/run_spec.h"

namespace footfall {

// The scale of the interface's energy is what the contacts move, whatever else the mechanism does:
//   E = sum over bodies of the larger of
//         range of (work received from the grains + work of gravity) so far: what was exchanged, without what the weight
//         of a body that swings on its contacts gives and takes back
//         its largest 1/2 m0 v^2 so far: what contacts that begin have before them
//     + kFloor J^2 / 2m, J = |F| H the largest impulse of a window: rest, where all else is round-off
// with m the mass that the contacts meet (contact_mass.h). A body that is held or led (m infinite) can neither be
// pumped nor chatter: it has no part in this, and omega H = 0.
class CouplingWatch {
 public:
  struct Window {
    double time = 0.0;  // of its end [s]
    double H = 0.0;     // [s]
    int n = 1;          // substeps
    bool last = false;  // of the run: what is pending will never be given
  };
  // Of one coupled body in a window.
  struct Body {
    double mass = 0.0;           // that its contacts meet; infinity: held [kg]
    double work_received = 0.0;  // by the body [J]
    double gravity = 0.0;        // work of its weight [J]
    double kinetic = 0.0;        // 1/2 m0 v^2 at the window's end [J]
    double pending = 0.0;  // what the grains will do when the next window starts from the computed motion, and the
                           // body has received already [J]
  };

  // Names of the coupled bodies in the order of Load; limits of the scene.
  CouplingWatch(std::vector<std::string> names, const CouplingSpec& limits);

  // What the grains did (load) and the bodies received. Throws NumericalError when the interface pumps energy or the
  // mean force chatters, naming time, body and what to do.
  void window(const Window& window, const Load& load, const std::vector<Body>& bodies);

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
  void warn(const std::string& text) { warnings_.push_back(text); }  // what the grains' side has to tell
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  // A touch of one body, from no contact to no contact.
  struct Touch {
    double contact_time = 0.0;   // sum over its contacts [s]
    double most_contacts = 1.0;  // met at ends of windows
    double longest_H = 0.0;      // of its windows [s]
    double impulse = 0.0;        // [N s]
    void visit(Archive& archive) {
      archive("contact_time", contact_time);
      archive("most_contacts", most_contacts);
      archive("longest_H", longest_H);
      archive("impulse", impulse);
    }
  };
  // What the contacts of one body move.
  struct Work {
    double sum = 0.0, largest = 0.0, smallest = 0.0;  // since the start, with that of gravity [J]
    double kinetic = 0.0;                             // largest [J]
    double surplus = 0.0;                             // work of the grains - work received, while it is not held [J]
    void visit(Archive& archive) {
      archive("sum", sum);
      archive("largest", largest);
      archive("smallest", smallest);
      archive("surplus", surplus);
    }
  };

  void watch_omega_h(std::size_t body, const Window& window, double stiffness, double mass);
  void watch_energy(const Window& window, const Load& load, const std::vector<Body>& bodies);
  void watch_touch(std::size_t body, const Window& window, const BodyLoad& load);
  void watch_grains(double time);
  void watch_chatter(std::size_t body, const Eigen::Vector3d& force, double time, int n);

  std::vector<std::string> names_;
  CouplingSpec limits_;
  double sum_ = 0.0;                                // of work on the boundary - work received [J]
  double residual_ = 0.0, largest_residual_ = 0.0;  // [J]
  std::vector<Work> work_;                          // per body
  double largest_kick_ = 0.0;                       // sum over bodies of J^2 / 2m, largest of any window [J]
  bool began_ = false;
  bool warned_of_gain_ = false, warned_of_loss_ = false, warned_of_overlap_ = false, warned_of_facets_ = false;
  double largest_overlap_ = 0.0, largest_patch_ = 0.0, largest_force_ = 0.0;
  std::vector<double> omega_h_, largest_omega_h_, warn_omega_h_;
  std::vector<bool> warned_;
  std::vector<Touch> touch_;              // per body, the present one
  std::vector<bool> touches_;             // per body, at the end of the last window
  std::vector<double> impulse_;           // per body, since the start [N s]
  std::vector<double> unresolved_;        // of touches shorter than a window [N s]
  std::vector<double> shortest_;          // of these [s]
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
