#pragma once
// The multibody side of a coupled run: in every window it sends the motion and receives the load. Constructed only for
// runs with grains. theory 7.
//
// Window k, of n DEM steps, H = n dt:
//   exchange     chooses n; sends the motion at t_k, as the scheme presents it to the grains; receives the mean load
//   (the mechanism moves from t_k to t_k + H under that load)
//   end_window   work received, gap between computed and predicted motion: CouplingWatch, and n of the next window

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "coupler/base/clock.h"
#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/coupling/body_window.h"
#include "mbd_solver/coupling/contact_mass.h"
#include "mbd_solver/coupling/coupling_sample.h"
#include "mbd_solver/coupling/coupling_watch.h"
#include "mbd_solver/coupling/dem_partner.h"
#include "mbd_solver/coupling/known_motion.h"
#include "mbd_solver/coupling/window_choice.h"
#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/model/state.h"

namespace footfall {

// A checkpoint that is required at the end of a window.
struct CheckpointRequest {
  std::string folder;        // empty: none
  bool undisturbed = false;  // only if the DEM side can write it without changing the run
};

// Wall-clock times [s].
struct CouplingTimes {
  double dem = 0.0;         // work of LIGGGHTS on its windows, without waiting
  double waited = 0.0;      // LIGGGHTS waited for motions
  double exchange = 0.0;    // of that, beyond the work of the mechanism for them: the cost of the exchange
  double overlapped = 0.0;  // work of the mechanism for motions before LIGGGHTS waited for them
};

class CoupledRun {
 public:
  // Performs the handshake with LIGGGHTS. start: of the mechanism. mechanism, assembly, equations and transport must
  // outlive this. resume: folder of the checkpoint from which both sides resume; visit() then follows. Throws
  // ProtocolError, PartnerError.
  CoupledRun(const Scene& scene, const Mechanism& mechanism, const Assembly& assembly, Equations& equations,
             const Kinematics& start, double t_end, Transport& transport, const std::string& resume = "");

  // Sends the motion, waits for the load, writes it into inputs.loads (one per body of the model, sized by the caller).
  // meanwhile: called after sending, before waiting for the load; must not change inputs.loads. kinematics: with accelerations.
  // stop: a known time of an abrupt change, where the window must end if it comes so far [s]. last: the end of the run, after
  // whole DEM steps, at most the agreed one [s]. checkpoint_at: the checkpoint required at the window's end [s]. Returns the
  // window's end [s], or the present time when the script has ended (script_has_ended()). Throws NumericalError for a load that is
  // not finite, PartnerError.
  double exchange(const State& state, const Kinematics& kinematics, double stop, double last,
                  const std::function<CheckpointRequest(double t_end)>& checkpoint_at,
                  const std::function<void()>& meanwhile, Inputs& inputs);
  // Something has changed abruptly at the start of the next window: chosen windows begin with the shortest.
  void restart() { restarts_ = true; }
  // An event has been found at the end of the last window; late: it was not foreseen. share: change of velocities over the
  // largest velocity, if the event acts this window late.
  void tell_of_event(const std::string& event, double time, double share, bool late) {
    watch_->tell_of_event(event, {time, window_length(), motion_.n, motion_.last_window}, share, late);
  }
  double window_length() const { return motion_.n * agreement_.dt; }  // of the last window [s]
  bool chooses_windows() const { return agreement_.substeps == 0; }
  // The latest end of a window that starts at `time` [s].
  double longest_window_end(double time) const { return time + wanted_substeps() * agreement_.dt; }
  // The mechanism has reached the window's end in `state`. A body whose motion was known to the grains has received their
  // work on its path; its prescribed motions have supplied the difference from the work of the mean load.
  void settle_work(State& state) const;
  // The mechanism has reached the window's end. Throws NumericalError when the coupling creates energy or chatters
  // (CouplingWatch).
  void end_window(const State& state, const Kinematics& kinematics);

  // A checkpoint was required at the end of the last window.
  bool checkpoint_required() const { return !motion_.checkpoint.empty(); }
  bool checkpoint_undisturbed() const { return motion_.undisturbed; }
  bool wait_for_checkpoint();    // of the DEM side; false: it could not be written without disturbing the run
  void visit(Archive& archive);  // between two windows

  void close() { partner_.close(); }  // after the last window
  void fail(const std::string& reason, Status status) noexcept { partner_.fail(reason, status); }

  const Agreement& agreement() const { return agreement_; }
  const CouplingSample& sample() const { return sample_; }  // of the last window
  const Load& load() const { return partner_.load(); }      // likewise; empty before the first
  // The LIGGGHTS script may end before the scene does, and has.
  bool script_has_ended() const { return partner_.script_has_ended(); }
  // Planes and static meshes of the script at its start; those removed since, as reported with the last load.
  const std::vector<StaticWall>& walls() const { return partner_.walls(); }
  const std::vector<std::string>& gone_walls() const { return partner_.load().gone_walls; }
  bool end_requested() const { return partner_.load().end_requested; }  // by a signal to a rank of LIGGGHTS
  const CouplingWatch& watch() const { return *watch_; }
  const std::string& dem_version() const { return partner_.dem_version(); }  // of LIGGGHTS
  const CouplingTimes& times() const { return times_; }

 private:
  // A body that the script couples.
  struct Coupled {
    const BodyBoundary& entry;
    const Body& body;
    const LandingSite* site;  // grains under it at the start; null when unknown
    BodyWindow window;        // motion sent and load applied
    ContactMass contact_mass;
    BodyMotion end;    // computed, at the window's end
    double reach;      // largest |rho0| [m]
    int mass_age = 0;  // windows of contact since contact_mass was computed
  };

  int wanted_substeps() const;  // in the next window, unless the scheme or an end cuts it
  void prepare_masses(const State& state);
  void choose_window();  // after a window: its force error, and n of the next one
  void receive(const Load& load, Inputs& inputs);
  void observe(const State& state);  // a window that has ended

  const Mechanism& mechanism_;
  Equations& equations_;
  Eigen::Vector3d gravity_;  // [m/s2]
  Eigen::Vector3d up_;       // unit vector against gravity, in W
  std::unique_ptr<Scheme> scheme_;
  DemPartner partner_;
  Agreement agreement_;
  std::unique_ptr<KnownMotion> known_motion_;
  // State from window to window:
  std::vector<Coupled> bodies_;  // in the order of Motion and Load
  Motion motion_;                // of this window, as sent
  std::unique_ptr<CouplingWatch> watch_;
  std::unique_ptr<WindowChoice> choice_;  // estimates errors; chooses n unless the script fixes it
  std::vector<WindowChoice::Body> choice_bodies_;
  bool restarts_ = false;  // the next window
  CouplingSample sample_;
  Eigen::VectorXd work_before_;               // State::load_work at the window's start [J]
  std::vector<CouplingWatch::Body> watched_;  // of the window, per coupled body
  CouplingTimes times_;
  double exchanged_ = wall_clock();  // arrival of the last load [s]
};

}  // namespace footfall
