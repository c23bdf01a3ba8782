#pragma once
// The half of a coupled run that belongs to the mechanism: in every window, motion out and load in. It exists only in
// runs that touch grains. theory 7.
//
// Window k, of n substeps, H = n dt:
//   begin_window   n; the motion at t_k, as the scheme lets the grains see it, goes out; the mean load comes in
//   (the mechanism moves from t_k to t_k + H under that load)
//   end_window     work that arrived, gap between computed and predicted motion: watch, and n of the next window

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "coupler/base/clock.h"
#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/coupling/body_window.h"
#include "mbd_solver/coupling/contact_mass.h"
#include "mbd_solver/coupling/coupling_sample.h"
#include "mbd_solver/coupling/coupling_watch.h"
#include "mbd_solver/coupling/dem_partner.h"
#include "mbd_solver/coupling/window_choice.h"
#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/model/state.h"

namespace footfall {

// A checkpoint that shall be made at the end of a window.
struct WantedSet {
  std::string folder;    // empty: none
  bool quietly = false;  // the grains' side writes it without a trace in what follows
};

class CoupledRun {
 public:
  // Shakes hands with LIGGGHTS. start: of the mechanism. mechanism, equations and transport must outlive this. resume:
  // folder of the checkpoint from which both sides go on; visit() then follows. Throws ProtocolError, PartnerError.
  CoupledRun(const Scene& scene, const Mechanism& mechanism, Equations& equations, const Kinematics& start,
             double t_end, Transport& transport, const std::string& resume = "");

  // Sends the motion, waits for the load, writes it into inputs.loads (one per body of the model, sized by the caller).
  // meanwhile: called when the motion is out, before the load is waited for; it leaves inputs.loads alone.
  // kinematics: with accelerations. checkpoint_at: how the grains' side shall keep itself at the window's end [s].
  // Returns the window's end [s]; the present time when the script has ended, as it may: script_has_ended(). Throws
  // NumericalError for a load that is not finite, PartnerError.
  double begin_window(const State& state, const Kinematics& kinematics,
                      const std::function<WantedSet(double t_end)>& checkpoint_at,
                      const std::function<void()>& meanwhile, Inputs& inputs);
  // The mechanism has come to the window's end. Throws NumericalError when the coupling pumps energy or chatters
  // (CouplingWatch).
  void end_window(const State& state, const Kinematics& kinematics);

  // The grains' side was asked to keep itself at the end of the last window.
  bool keeps() const { return !motion_.checkpoint.empty(); }
  bool keeps_quietly() const { return motion_.undisturbed; }
  bool wait_until_kept();        // then its files are there; false: it could not be done quietly
  void visit(Archive& archive);  // between two windows

  void close() { partner_.close(); }  // after the last window
  void fail(const std::string& reason, Status status) noexcept { partner_.fail(reason, status); }

  const Agreement& agreement() const { return agreement_; }
  const CouplingSample& sample() const { return sample_; }  // of the last window
  const Load& load() const { return partner_.load(); }      // likewise; empty before the first
  // The LIGGGHTS script has said that it may end before the scene does, and has.
  bool script_has_ended() const { return partner_.script_has_ended(); }
  // Planes and static meshes of the script, as it began to run; those that have gone since, told with the last load.
  const std::vector<StaticWall>& walls() const { return partner_.walls(); }
  const std::vector<std::string>& gone_walls() const { return partner_.load().gone_walls; }
  bool asked_to_end() const { return partner_.load().end_requested; }  // by a signal to a rank of LIGGGHTS
  const CouplingWatch& watch() const { return *watch_; }
  const std::string& grains_version() const { return partner_.grains_version(); }  // of LIGGGHTS
  double dem_seconds() const { return dem_seconds_; }        // spent by LIGGGHTS on its windows, waiting apart [s]
  double waited_seconds() const { return waited_seconds_; }  // LIGGGHTS stood still for motions [s]
  // Of that what goes beyond the work of the mechanism for them: what the exchange costs [s].
  double exchange_seconds() const { return exchange_seconds_; }
  // The mechanism's work for motions while LIGGGHTS did not wait for them yet [s].
  double beside_seconds() const { return beside_seconds_; }

 private:
  // One body that the script couples.
  struct Coupled {
    const BodyBoundary& entry;
    const Body& body;
    const LandingSite* site;  // under it at the start; null when not known
    BodyWindow window;        // what the scheme makes of it
    ContactMass contact_mass;
    BodyMotion end;    // computed, at the window's end
    double reach;      // largest |rho0| [m]
    int mass_age = 0;  // windows of contact since contact_mass was found
  };

  void prepare_masses(const State& state);
  void choose_window();  // n of the next window, after one
  void receive(const Load& load, Inputs& inputs);
  void judge(const State& state);  // a window that has ended

  const Mechanism& mechanism_;
  Equations& equations_;
  double t_end_;             // [s]
  Eigen::Vector3d gravity_;  // [m/s2]
  Eigen::Vector3d up_;       // unit vector against gravity, in W
  std::unique_ptr<Scheme> scheme_;
  DemPartner partner_;
  Agreement agreement_;
  // Memory from window to window:
  std::vector<Coupled> bodies_;  // in the order of Motion and Load
  Motion motion_;                // of this window, as sent
  std::unique_ptr<CouplingWatch> watch_;
  std::unique_ptr<WindowChoice> choice_;  // null when the script fixes n
  std::vector<WindowChoice::Body> choice_bodies_;
  CouplingSample sample_;
  Eigen::VectorXd work_before_;               // State::load_work at the window's start [J]
  std::vector<CouplingWatch::Body> watched_;  // of the window, per coupled body
  double dem_seconds_ = 0.0, waited_seconds_ = 0.0, exchange_seconds_ = 0.0, beside_seconds_ = 0.0;  // [s]
  double exchanged_ = wall_clock();  // when the last load had come [s]
};

}  // namespace footfall
