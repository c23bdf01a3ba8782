#pragma once
// The run of one scene: windows of the mechanism, with grains or alone, and everything that is observed on the way.
// Data runs one way: Scene -> Mechanism -> State -> window (motion out, load in) -> Sample -> files.

#include <csignal>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/coupling/body_window.h"
#include "mbd_solver/coupling/coupling_watch.h"
#include "mbd_solver/coupling/dem_partner.h"
#include "mbd_solver/coupling/window_choice.h"
#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/integrator/integrator.h"
#include "mbd_solver/run/control_loop.h"

namespace footfall {

// What is known at the end of a window: all that history, summary and progress are made of.
struct Sample {
  const State& state;
  const EnergySample& energy;
  const Eigen::VectorXd& rates;  // [dq; dv; dz; lambda] at state.time
  const std::vector<GeneralizedForce>&
      contact;  // per body of the scene, F_W and T_W about Bo, of the window's ground contact
  const Inputs& inputs;
  const CouplingWatch* coupling;  // null without grains
  long window;                    // windows done
  int substeps;                   // of the last window, 0 without grains
  double estimate;                // of the last window's force error, when windows are chosen [-]
};

struct RunTimes {
  double total = 0.0;    // wall time of the loop [s]
  double dem = 0.0;      // spent by LIGGGHTS on its windows [s]
  double mbd = 0.0;      // in the integrator [s]
  double control = 0.0;  // in controllers [s]
  double waiting = 0.0;  // for the partner, its work included [s]
};

class Simulation {
 public:
  // `partner_transport`: null when the scene touches no grains. Throws InputError, ProtocolError.
  Simulation(const Scene& scene, double t_end, Transport* partner_transport);

  // Runs to the end, or until `interrupted` is set. Calls `observe` for the start and after every window.
  // Throws NumericalError, PartnerError.
  void run(const std::function<void(const Sample&)>& observe, const volatile std::sig_atomic_t& interrupted);

  const Scene& scene() const { return scene_; }
  const Mechanism& mechanism() const { return mechanism_; }
  Equations& equations() { return *equations_; }
  const Layout& layout() const { return equations_->layout(); }
  const Assembly& assembly() const { return assembly_; }
  const State& state() const { return state_; }
  const Integrator& integrator() const { return *integrator_; }
  const RunTimes& times() const { return times_; }
  const DemPartner* partner() const { return partner_.get(); }
  DemPartner* partner() { return partner_.get(); }
  const CouplingWatch* watch() const { return watch_.get(); }  // null without grains
  bool finished() const;                                       // the end time has been reached
  long particles() const { return particles_; }
  double t_end() const { return t_end_; }
  const Scheme& scheme() const { return *scheme_; }      // only with grains
  void fill_motion(int body, BodyMotion& motion) const;  // as computed; `motion` is sized for the body's modes

 private:
  double next_stop() const;         // end of the next window without grains
  double exchange_window();         // with grains: trades motion for loads, returns the window's end
  void prepare_windows();           // what the scheme and `every auto` need
  double pending_interface_work();  // after a window [J]
  void choose_window(bool first);   // after a window: substeps of the next one
  // of coupled body k, until it can meet a grain [s]
  double time_of_flight(std::size_t k, const BodyMotion& motion) const;
  void update_contact();  // contact_ from loads or planes
  void check_finite() const;

  const Scene& scene_;
  double t_end_;
  Mechanism mechanism_;
  Assembly assembly_;
  std::unique_ptr<Equations> equations_;
  std::unique_ptr<Integrator> integrator_;
  std::unique_ptr<DemPartner> partner_;
  std::unique_ptr<CouplingWatch> watch_;
  ControlLoop control_;
  State state_;
  Inputs inputs_;
  Eigen::VectorXd rates_;
  Eigen::VectorXd y_;
  EnergySample energy_;
  std::vector<GeneralizedForce> contact_;
  Motion motion_;
  std::unique_ptr<Scheme> scheme_;
  std::vector<BodyWindow> windows_;       // per coupled body
  std::unique_ptr<WindowChoice> choice_;  // null when the script fixes n
  std::vector<WindowChoice::Body> windows_of_bodies_;
  RunTimes times_;
  long window_ = 0;
  long particles_ = 0;
};

}  // namespace footfall
