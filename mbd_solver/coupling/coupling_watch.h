#pragma once
// How well the two programs agree, measured in every window: energy that the interface creates or dissipates, omega H
// of each body, forces that alternate. theory 7.9.

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "coupler/archive.h"
#include "coupler/messages.h"
#include "coupler/schemes/window_map.h"
#include "mbd_solver/scene/run_spec.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// Settings by which the user of a scene can correct a coupling interval that is too long, or grains that are too soft.
struct CouplingAdvice {
  // Windows of n DEM steps: "`--set particles.variables.every=2`", or "`every 2`" where no variable sets them.
  std::function<std::string(int n)> interval;
  std::string shorter_step;  // of the grains: "a smaller timestep in the script"
  // Grains f times as stiff. Their time step shrinks by sqrt(f), as the Rayleigh time does.
  std::function<std::string(double f)> stiffer;
};

// scene: must outlive the advice, which reads the script only when advice is needed.
CouplingAdvice coupling_advice(const Scene& scene, bool chooses_windows);

// The energy of the interface is compared with the energy that the contacts exchange, whatever the mechanism does:
//   E = sum over bodies of the larger of
//         range of (work received from the grains + work of gravity) so far: the energy exchanged, without the work that the
//         weight of a body that swings on its contacts does back and forth
//         its largest 1/2 m0 v^2 so far: the energy available to contacts that begin
//         + the largest energy of a grain at a contact: m (v^2/2 + g R) + k overlap^2/2, m reduced with the body's mass
//     + kFloor J^2 / 2m, J = |F| H the largest impulse of a window: at rest everything else is round-off
// The first step of a contact is not judged: a gain or loss counts when it persists at the ends of two windows in a row.
// m: the mass that the contacts meet (contact_mass.h). A body that is held or driven (m infinite) can neither receive
// spurious energy nor chatter: it is left out, and omega H = 0.
class CouplingWatch {
 public:
  struct Window {
    double time = 0.0;  // of its end [s]
    double H = 0.0;     // [s]
    int n = 1;          // DEM steps
    bool last = false;  // of the run: pending work will never be done
  };
  // One coupled body in a window.
  struct Body {
    double mass = 0.0;           // that its contacts meet; infinity: held [kg]
    double work_received = 0.0;  // by the body [J]
    double gravity = 0.0;        // work of its weight [J]
    double kinetic = 0.0;        // 1/2 m0 v^2 at the window's end [J]
    double pending = 0.0;        // work that the body has received and the grains will do when the next window starts
                                 // from the computed motion [J]
    double pending_modes = 0.0;  // the same of its modes: judged, but no part of energy_residual() [J]
    double force_error = 0.0;    // of the predicted path at the window's end (WindowChoice) [N]
    double speed = 0.0;          // of its mass centre at the window's end [m/s]
  };

  // Names of the coupled bodies in the order of Load; limits of the scene; the scheme must outlive this.
  CouplingWatch(const std::vector<std::string>& names, const CouplingSpec& limits, const Scheme& scheme,
                CouplingAdvice advice);

  // A window has ended: the effect of the grains (load) and the loads of the bodies. Throws NumericalError, naming
  // time and body, when the interface creates energy or a mean force chatters.
  void observe(const Window& window, const Load& load, const std::vector<Body>& bodies);

  // Scheme `tangent`, per window: impulse that body i received in addition to the grains' impulse, and the latter's size [N s].
  void add_surplus_impulse(std::size_t i, double time, const Eigen::Vector3d& surplus, double given);

  // Loads of the window that ends have triggered an event in it, or at its end where it was foreseen (late = false). share: of
  // CoupledRun::tell_of_event.
  void tell_of_event(const std::string& event, const Window& window, double share, bool late);

  void visit(Archive& archive);

  double energy_residual() const {
    return energy_.residual;
  }  // sum of (work on the boundary - work received), + pending [J]
  double largest_energy_residual() const { return energy_.largest_residual; }
  double largest_overlap() const { return deepest_.overlap; }  // of radius [-]
  double largest_force() const { return largest_force_; }      // mean over a window, on one body [N]
  std::size_t body_count() const { return records_.size(); }
  const std::string& name(std::size_t i) const { return records_[i].name; }
  double largest_omega_h(std::size_t i) const { return records_[i].largest_omega_h; }
  std::vector<double> omega_h() const;                                    // of the last window, per body [-]
  void warn(const std::string& text) { warnings_.push_back(text); }       // of the DEM side
  const std::vector<std::string>& warnings() const { return warnings_; }  // as they are reported
  // Findings that depend on the whole run so far, one for each kind of trouble, with its worst body first: intervals
  // that are too long for the contacts (omega H), rebounds and forces that they do not resolve, overlaps.
  std::vector<std::string> conclusions() const;

  // The largest force on one body, mean over a DEM step.
  struct Peak {
    double force = 0.0;  // [N]
    double time = 0.0;   // of the end of that step [s]
    int steps = 0;       // in a row with at least kOfPeak of it
    int n = 1;           // DEM steps of its window
    void visit(Archive& archive);
  };
  Peak peak() const;  // of all bodies

 private:
  // A touch of one body, from no contact to no contact.
  struct Touch {
    double contact_time = 0.0;   // sum over its contacts [s]
    double most_contacts = 1.0;  // at ends of windows
    double longest_H = 0.0;      // of its windows [s]
    double impulse = 0.0;        // [N s]
    void visit(Archive& archive);
  };
  // Energy that the contacts of one body exchange.
  struct Work {
    double sum = 0.0, largest = 0.0, smallest = 0.0;  // since the start, with gravity [J]
    double kinetic = 0.0;                             // largest [J]
    double surplus = 0.0;                             // work of the grains - work received, while it is not held [J]
    double grain = 0.0;                               // largest energy of a grain at a contact [J]
    void visit(Archive& archive);
  };
  // Everything that is recorded of one body.
  struct Record {
    std::string name;
    double omega_h = 0.0, largest_omega_h = 0.0;  // [-]
    double most_excess = 1.0;                     // largest omega H over its limit [-]
    double worst_omega_h = 0.0;                   // in that window [-]
    int worst_n = 1;                              // DEM steps of that window
    bool led = false;                             // held or driven in the last window
    Work work;
    Touch touch;                                                // the present one
    bool touches = false;                                       // at the end of the last window
    double impulse = 0.0;                                       // since the start [N s]
    double unresolved = 0.0;                                    // impulse of touches shorter than a window [N s]
    double shortest = std::numeric_limits<double>::infinity();  // of these [s]
    Eigen::Vector3d surplus = Eigen::Vector3d::Zero();          // impulse of scheme `tangent` since the start [N s]
    double given = 0.0;                                         // impulse of the grains, likewise [N s]
    Eigen::Vector3d force = Eigen::Vector3d::Zero();            // mean of the last window [N]
    Eigen::Vector3d change = Eigen::Vector3d::Zero();           // of that, from the window before [N]
    Eigen::Vector3d sizes = Eigen::Vector3d::Zero();            // |force| of the last three windows, newest first [N]
    double largest_force = 0.0;                                 // [N]
    Peak inner_peak;                                            // largest on a known path, or within a window
    double smoothed = 0.0;                                      // largest part of a peak that a mean leaves out [N]
    int smoothed_n = 1;                                         // DEM steps of its window
    Peak peak;                                                  // largest of a DEM step
    double error = 0.0, error_before = 0.0;                     // largest and last force_error [N]
    int error_n = 1;                                            // DEM steps of its window
    int alternations = 0;  // windows in a row in which the force alternated by more than half of its magnitude
    void visit(Archive& archive);
  };

  void watch_omega_h(Record& record, const Window& window, const BodyLoad& load, double mass);
  void watch_energy(const Window& window, const Load& load, const std::vector<Body>& bodies);
  void watch_touch(Record& record, const Window& window, const BodyLoad& load);
  void watch_grains(const Window& window, const Load& load, const std::vector<Body>& bodies);
  void watch_chatter(Record& record, const Eigen::Vector3d& force, const Window& window, bool free);
  void watch_peaks(Record& record, const Window& window, const BodyLoad& load, const Body& body);
  double left_out_of_peak(const Eigen::Vector3d& sizes, double size, double H) const;  // [N]
  // "use `every 3` or less": to windows of at most this many DEM steps, or to shorter DEM steps. No later message advises
  // longer windows than an earlier one: advised.
  std::string shorter(double steps, int& advised) const;
  std::string shorter_than_now(double share) { return shorter(share * n_longest_, advised_); }

  // Some bodies have the same trouble, each to a degree.
  struct Finding {
    double degree = 0.0;  // [-]
    std::string body, text;
    double steps = 0.0;  // DEM steps of a window that mends it
  };
  // "body pad_1 ...; use ...; the same to a lesser degree: pad_2, pad_3"
  std::string told(std::vector<Finding> findings, int& advised) const;
  std::vector<Finding> long_intervals() const, unresolved_touches() const, unresolved_forces() const;
  std::string soft_grains() const;  // empty: they are stiff enough
  std::string bed_mass() const;     // empty: a bed that follows holds its mass to two grains, or none follows

  CouplingSpec limits_;
  OmegaHLimit omega_h_limit_;
  CouplingAdvice advice_;
  double dt_ = 0.0;                                // of the grains [s]
  int n_before_ = 0, n_longest_ = 1;               // DEM steps of the last window; of the longer one of the last two
  int advised_ = std::numeric_limits<int>::max();  // DEM steps
  Eigen::Vector3d lengths_ = Eigen::Vector3d::Zero();  // of the last three windows, newest first [s]; 0: none yet
  std::vector<Record> records_;                        // per coupled body
  struct Energy {
    double sum = 0.0;                               // of work on the boundary - work received [J]
    double residual = 0.0, largest_residual = 0.0;  // [J]
    double largest_kick = 0.0;                      // sum over bodies of J^2 / 2m, largest of any window [J]
    double gain_before = 0.0;                       // at the end of the last window [J]
    double error = 0.0;                             // largest gain or loss, of the energy exchanged in contacts [-]
  } energy_;
  bool began_ = false;
  struct Warned {
    bool gain = false, loss = false, facets = false, surplus = false, event = false;
  } warned_of_;
  struct Deepest {
    double overlap = 0.0;  // largest, of radius [-]
    double time = 0.0;     // [s]
    int body = 0;
    double patch = 0.0;          // largest patch radius over the width of a facet [-]
    bool starts_in_bed = false;  // a body overlaps the bed in the first window
  } deepest_;
  struct Bed {
    GrainChanges changes;
    double grains = 0.0;  // now
  } bed_;                 // of the last window
  double largest_force_ = 0.0;
  double largest_impulse_ = 0.0;  // largest Record::given [N s]
  int surplus_windows_ = 0;
  std::vector<std::string> warnings_;
};

}  // namespace footfall
