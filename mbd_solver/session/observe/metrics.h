#pragma once
// Metrics of a run: of flexible bodies, of coordinates of joints, and the peaks in summary.json.

#include <optional>
#include <string>
#include <vector>

#include "coupler/archive.h"
#include "mbd_solver/dynamics/energy_flow.h"
#include "mbd_solver/model/modal_body.h"
#include "mbd_solver/session/observe/landing.h"
#include "mbd_solver/session/observe/sampler.h"

namespace footfall {

// Bodies that the ground does not hold, or only coarsely (assemble/build_hulls.cpp): they have a shape, but no boundary.
class UnheldBodies {
 public:
  explicit UnheldBodies(const Subject& subject);
  void update(const Sample& sample);
  // Names those that went through the surface during the run, the deepest first; empty: none.
  std::string warning() const;
  void visit(Archive& archive) { archive("unheld_bodies", depths_); }

 private:
  struct Watched {
    int body = 0;
    std::string name;
    double size = 0.0;                     // largest distance of a point from the mass centre [m]
    std::vector<Eigen::Vector3d> outline;  // of its shape, in the axes of the body [m]
    bool held = false;                     // by a coarse surface
  };
  struct Depth {
    double start = -1.0, largest = 0.0, time = 0.0;  // below the surface [m], [s]; start < 0: above it, or not seen yet
    void visit(Archive& archive);
  };
  std::vector<Watched> watched_;
  std::vector<Depth> depths_;  // of each
  std::optional<GroundLevel> ground_;
};

struct FlexibleMetrics {
  double strain_energy = 0.0;  // 1/2 a^T K a [J]
  double deflection = 0.0;     // largest |Phi_j a| of all nodes [m]
  double von_mises = 0.0;      // largest of all stress points [Pa]; 0 without stress points
  double spin = 0.0;           // |w| over the lowest elastic frequency [-]
};

// Metrics of every flexible body, now and the largest so far, and warnings when it leaves the range of linear modes.
class FlexibleBodies {
 public:
  // What the subject views must outlive this.
  explicit FlexibleBodies(const Subject& subject);

  void update(const Sample& sample);
  // One per body and cause: it spins too fast or bends too far for linear modes (modal_body.h), or its material yields.
  const std::vector<std::string>& warnings() const { return warnings_; }

  void visit(Archive& archive);

  int count() const { return static_cast<int>(bodies_.size()); }
  int find(int body) const;  // index here of a body of the model, or -1: it is rigid
  const Body& body(int k) const;
  const FlexibleMetrics& now(int k) const { return now_[k]; }
  const FlexibleMetrics& peak(int k) const { return peak_[k]; }  // of each metric separately

 private:
  // Limits of one body, and the warnings given.
  struct Limits {
    double lowest = 0.0;        // elastic frequency [rad/s]
    double extent = 0.0;        // [m]
    double yield_stress = 0.0;  // [Pa]; 0: unknown
    bool spins = false, bends = false, yields = false;
  };
  void warn(double time, int k);

  const Model& model_;
  std::vector<int> bodies_;  // in the model
  std::vector<FlexibleMetrics> now_, peak_;
  std::vector<Limits> limits_;
  std::vector<LargestStress> stresses_;
  std::vector<std::string> warnings_;
};

struct CoordinateValue {
  double value = 0.0;  // [rad or m]
  double rate = 0.0;   // [rad/s or m/s]
  void visit(Archive& archive) {
    archive("value", value);
    archive("rate", rate);
  }
};

// Coordinates of joints with their rates, and reactions, at every sample.
// Angles are over any number of turns (State::angles).
class JointObserver {
 public:
  // What the subject views must outlive this.
  explicit JointObserver(const Subject& subject);

  void update(const Sample& sample);
  const std::vector<std::string>& warnings() const { return warnings_; }  // of turns, at most one
  void visit(Archive& archive) {
    archive("now", now_);
    archive("warnings", warnings_);
    archive("reactions", reactions_);
  }

  // Of mechanism.coordinates[k].
  const CoordinateValue& coordinate(std::size_t k) const { return now_[k]; }
  // Force [N] and moment [N m] of a joint of the scene on its body b, about its point there, in W; only where
  // output.reactions is set.
  const Vector6d& reaction(std::size_t joint) const { return reactions_[joint]; }

 private:
  Subject subject_;
  std::vector<CoordinateValue> now_;
  std::vector<std::string> warnings_;
  std::vector<Vector6d> reactions_;
};

// Pulleys with grip hold their cables also where these would leave them: told once of each.
class GripWatch {
 public:
  // What the subject views must outlive this.
  explicit GripWatch(const Subject& subject);

  void update(const Sample& sample);
  const std::vector<std::string>& warnings() const { return warnings_; }
  bool empty() const { return told_.empty(); }
  void visit(Archive& archive) {
    archive("told", told_);
    archive("warnings", warnings_);
  }

 private:
  Subject subject_;
  std::vector<int> told_;  // per grip: 1 once it has been told of
  std::vector<std::string> warnings_;
};

// Largest acceptable error of the energy balance, of the energy exchanged: usual tolerances reach less.
inline constexpr double kGoodBalance = 0.01;

// Peaks of a run for summary.json: over every step, not only over the rows that are written.

struct Metrics {
  Peak peak_acceleration;  // of the heaviest body [m/s2]
  Peak max_descent;        // of the heaviest body against gravity's direction, from the start [m]
  Peak max_penetration;    // of any boundary below the plane, or below the surface of the grains at the start [m]
  Peak max_contact_force;  // on one body [N]
  double reference_energy = 0.0;  // initial mechanical energy without gravity; else the largest kinetic energy [J]
  double energy_flow = 0.0;       // exchanged between forms of energy: EnergyFlow::scale() [J]
  // Largest |E - E0 + dissipated - work of contact, motions, forces, drives|, or estimated error of these integrals, which
  // cancels where two of them are the same work [J]
  double energy_balance = 0.0;
  double energy_noise = 0.0;   // error of weights and joint forces for position errors of atol [J]
  double contact_work = 0.0;   // of the grains on the mechanism so far [J]
  double contact_force = 0.0;  // on all bodies now [N]
  WorkError work_error;        // the largest of each so far [J]
  WorkError work_size;         // of the integrals themselves; scale: of work_error [J]

  double energy_balance_relative() const { return energy_flow > 0.0 ? energy_balance / energy_flow : 0.0; }
};

// Of an integral of power: the largest error that its rule of integration leaves, alone and with the error of the state.
struct WorkEstimate {
  std::string column;    // of the history
  double rule = 0.0;     // [J]
  double error = 0.0;    // at most, with the state's error [J]
  double largest = 0.0;  // of the integral [J]
};
// state_error: relative error of the state, IntegratorStatistics::summed_error times the relative tolerance. Of those in use.
std::vector<WorkEstimate> work_estimates(const Metrics& metrics, double state_error);
// The error of the balance over the flow, or if larger the error of an integral's rule over the integral.
double energy_balance_relative(const Metrics& metrics, const std::vector<WorkEstimate>& estimates);

class MetricRecorder {
 public:
  // What the subject views must outlive this.
  explicit MetricRecorder(const Subject& subject);
  void update(const Sample& sample);        // at the ends of windows and in rows
  void update_peaks(const Sample& sample);  // between them; update() includes it
  const Metrics& metrics() const { return metrics_; }
  // The state was set from outside: its stored energy grew by this [J], which is no error of the balance.
  void count_jump(double energy) { start_energy_ += energy; }
  // The warning when the energy balance has an error above kGoodBalance and energy_noise; otherwise empty.
  std::string balance_warning() const;
  // The warning when bodies have left the speeds or depths for which the numbers of the soil were fitted; otherwise empty.
  std::string soil_warning() const;
  std::vector<std::string> warnings() const;  // all there are
  void visit(Archive& archive);
  const std::string& body_name() const;  // the heaviest body, whose acceleration and descent are reported

 private:
  double depth(const Sample& sample) const;  // of the lowest point of all boundaries below the ground [m]

  Subject subject_;
  Metrics metrics_;
  UnheldBodies unheld_;
  Peak soil_speed_;  // of a body into the soil that it touches [m/s]
  EnergyFlow flow_;
  Eigen::Vector3d up_, normal_;       // against gravity; out of the ground
  double ground_ = 0.0;               // height of the ground along its normal [m]
  std::unique_ptr<Terrain> terrain_;  // of uneven ground
  int body_ = 0;
  double start_height_ = 0.0;  // [m]
  double start_energy_ = 0.0;  // [J]
  bool started_ = false;
};

}  // namespace footfall
