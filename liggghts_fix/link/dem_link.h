#pragma once
// The DEM side of the coupling, without LIGGGHTS and MPI: windows, loads, and the end of a run. Every rank holds one and
// calls it in step with the others; the transport of the link gives all ranks the same messages.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "coupler/archive.h"
#include "coupler/link.h"
#include "liggghts_fix/link/coupled_bodies.h"
#include "liggghts_fix/link/dem_body.h"
#include "liggghts_fix/link/dem_checkpoint.h"

namespace footfall {

// A grain that a body cannot stop, so that the run must end.
struct GrainFault {
  enum Kind { kNone, kTooFast, kPassed };
  Kind kind = kNone;
  double time = 0.0;    // [s]
  int tag = 0;          // of the grain
  int body = 0;         // index in the link
  double speed = 0.0;   // relative to the body [m/s]
  double radius = 0.0;  // of the grain [m]
};

class DemLink {
 public:
  // Null when this program runs alone.
  explicit DemLink(Link* link) : link_(link), coupled_(link, checkpoint_) {}

  // --- Before the first run.

  bool has_partner() const { return link_ != nullptr; }
  CoupledBodies& bodies() { return coupled_; }
  const CoupledBodies& bodies() const { return coupled_; }
  void set_patience(double seconds);                      // how long the partner may be silent [s]
  void set_max_lost(double share) { max_lost_ = share; }  // of all grains [-]; the run stops when more are lost
  void expect_outflow() { outflow_ = true; }              // grains are meant to leave the box, however many

  // --- A run.

  // script: all fields except `bodies`. The first call exchanges Start and Accept. Later calls (further runs) throw
  // InputError when the time step or gravity has changed.
  void start(Start script);
  bool started() const { return scheme_ != nullptr; }
  bool finished() const { return finished_; }  // the last window is done and both sides have closed
  double dt() const { return dt_; }            // as started [s]
  // After start():
  const Scheme& scheme() const { return *scheme_; }
  DemBody& body(int index) { return *bodies_[index]; }
  const Eigen::Vector3d& script_gravity() const { return script_.gravity; }  // zero when unknown [m/s2]
  // For gravity that varies and was unknown before the start. Throws InputError unless it is that of the scene [m/s2].
  void require_scene_gravity(const Eigen::Vector3d& gravity) const;
  // Static walls as sent at the start. One that is gone or moves now is reported with the next load, once.
  const std::vector<StaticWall>& script_walls() const { return script_.walls; }
  void wall_is_gone(const std::string& name);
  bool is_held_by_walls(int body) const;  // the scene has contacts of this body with the script's walls

  // A run is set up: LIGGGHTS evaluates all forces, which open the next substep. After start().
  void expect_set_up();

  // Loops of the script do not know the end of the scene. After a jump, runs beyond it are left out as long as the script
  // couples. The number of runs left out, with the one that begins now; 0: it is executed.
  void script_jumps() { jumps_ = jumps_ || started(); }
  int runs_left_out(bool couples) { return finished_ && jumps_ && couples ? ++left_out_ : 0; }
  // A loop waits for steps that do not come.
  void end_script() { script_is_over_ = true; }
  bool script_is_over() const { return script_is_over_; }
  void run_repeats(bool every) { repeats_ = every; }  // the run that begins is a `run N every M`
  bool repeats() const { return repeats_; }

  // --- A substep.

  // Before DEM step `step`: begins a window if none is open (receives Motion), moves every boundary, and clears the
  // contacts of the last step. Every fix that needs the new poses calls it; only the first call of a step acts.
  void begin_substep(std::int64_t step);
  bool in_last_substep() const { return last_window_ && substeps_left_ == 1; }  // of the scene
  // After the forces. True when the window is complete: write_shares, a gather over the ranks, and finish_window follow.
  bool end_substep();
  // One row of numbers: this rank's grains, those lost since the last row, whether it was asked to end, changes and faults
  // of its grains, and their loads on the bodies.
  void write_shares(std::int64_t grains, bool end_requested, std::vector<double>& row);
  // rows: those of all ranks in order. Throws NumericalError for a load that is not finite, for the first fault of a
  // grain, and when more grains are lost than allowed.
  void finish_window(const std::vector<double>& rows, int ranks);
  // Grains have changed ranks: numbers of this rank before and after. Their difference, summed over the ranks, is lost.
  void grains_exchanged(std::int64_t before, std::int64_t now) { lost_here_ += static_cast<double>(before - now); }
  // Grains of this rank have changed otherwise than by forces. Energies count once the first run is set up.
  void grains_changed(const GrainChanges& more);
  void count_changes() { counts_changes_ = started(); }
  bool counts_changes() const { return counts_changes_ && !finished_; }
  // Until the end of the last window, of all ranks; since then, of this rank.
  const GrainChanges& changes() const { return load_.changes; }
  const GrainChanges& changes_here() const { return changes_here_; }
  // Of a grain of this rank; the first since the last row counts.
  void grain_fault(const GrainFault& fault) {
    if (fault_.kind == GrainFault::kNone) fault_ = fault;
  }
  bool window_begins() const { return substeps_left_ == motion_.n; }  // the present substep is its first
  int substeps_left() const { return substeps_left_; }
  void warn(const std::string& coded_text) { load_.warnings.push_back(coded_text); }  // with the next load
  double time() const { return motion_.time + dt_ * (motion_.n - substeps_left_); }   // at the end of the substep [s]

  // --- Checkpoints, between two windows.

  // Folder into which this side has to save its state now; empty: no checkpoint is required.
  std::string checkpoint_folder() const { return substeps_left_ == 0 && windows_ > 0 ? motion_.checkpoint : ""; }
  bool checkpoint_undisturbed() const { return motion_.undisturbed; }  // only if the run's bits stay the same
  std::string checkpoint_text(std::int64_t step);                      // content of DemCheckpoint::file
  // All files are written, or (done false) none, because this was impossible undisturbed.
  void checkpoint_done(std::int64_t step, bool done);
  // Forces at the start of the next substep, of this rank, all bodies in one row of numbers. A checkpoint holds the sum
  // over the ranks; it is restored on one of them, since forces that LIGGGHTS evaluates anew would differ.
  std::vector<double> opening_forces() const;
  void store_opening_forces(std::vector<double> of_all_ranks) { stored_forces_ = std::move(of_all_ranks); }
  void restore_opening_forces(bool on_this_rank);
  bool resumed() const { return checkpoint_.is_open(); }  // known after the handshake
  std::string grains_not_read() const { return checkpoint_.grains_not_read(); }

  // --- Output.

  std::int64_t windows() const { return windows_; }  // completed
  // Work given by the grains minus work received by the mechanism, over all windows whose next state is known [J].
  double energy_residual() const { return work_given_ - work_received_; }
  double work() const { return work_; }  // of the grains on all boundaries [J]
  double max_overlap_over_radius() const { return overlap_; }

  // --- The end.

  // A rank was asked to end by a signal. All ranks know after the same window and leave LIGGGHTS' loop at the same step;
  // a signal may reach one rank only, and LIGGGHTS would wait for the others for ever.
  bool end_requested() const { return end_requested_; }
  // The script has ended. If the scene has not, informs the partner and throws InputError.
  void script_ended();
  // A command (its name begins the message) removes the coupling: as script_ended, but allowed before the first run.
  void uncoupled_by(const std::string& command);
  // This side failed: the partner gets the reason. True if it has received it.
  bool fail(const std::string& reason, Status status = Status::kFailed) noexcept {
    return link_ == nullptr || link_->fail(reason, status);
  }

 private:
  void finish();  // the last window is done
  void begin_window();
  void require_expected(const Motion& motion) const;
  void promise_next_step();
  void count_grains(const std::vector<double>& rows, int ranks);
  [[noreturn]] void stop_for(const GrainFault& fault) const;
  void visit(Archive& archive);

  Link* link_;
  DemCheckpoint checkpoint_;
  CoupledBodies coupled_;
  bool own_patience_ = false;  // set by the script
  double max_lost_ = 1.0;      // of all grains [-]
  bool outflow_ = false;

  Start script_;  // of the first run
  Accept accept_;
  double dt_ = 0.0;  // [s]
  int n_ = 0;        // largest number of substeps per window; 0: any
  std::unique_ptr<Scheme> scheme_;
  std::vector<std::unique_ptr<DemBody>> bodies_;

  Motion motion_;                          // of the open window
  std::vector<BodyMotion> at_last_start_;  // computed states at the start of the last window
  Load load_;
  std::int64_t step_ = -1;  // the last one begun
  int substeps_left_ = 0;   // of the open window; 0: none is open
  std::int64_t windows_ = 0;
  bool last_window_ = false;
  bool finished_ = false;
  bool jumps_ = false;    // the script has jumped since the first run
  bool repeats_ = false;  // the present command runs several times
  int left_out_ = 0;      // runs
  bool script_is_over_ = false;
  bool end_requested_ = false;
  bool set_up_forces_ = false;         // a set-up has evaluated forces that open the next substep
  std::vector<double> stored_forces_;  // opening forces of a checkpoint
  // Of this rank since the last write_shares.
  double lost_here_ = 0.0;  // grains sent to other ranks minus received
  GrainChanges changes_here_;
  bool counts_changes_ = false;
  GrainFault fault_;

  double window_work_ = 0.0;    // of the last complete window [J]
  double work_given_ = 0.0;     // [J]
  double work_received_ = 0.0;  // [J]
  double work_ = 0.0;           // [J]
  double overlap_ = 0.0;        // largest over radius [-]

  // Wall-clock times [s]: of the last Load (0: none yet), of the wait for the Motion after it, of the last substep.
  double sent_ = 0.0, waited_ = 0.0, stepped_ = 0.0;
};

}  // namespace footfall
