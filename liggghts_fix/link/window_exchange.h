#pragma once
// A coupling interval on the DEM side: Motion is received and moves the boundaries DEM step by
// DEM step; the loads of all ranks are added and sent as Load.

#include <cstdint>
#include <string>
#include <vector>

#include "coupler/archive.h"
#include "coupler/link.h"
#include "liggghts_fix/link/dem_body.h"
#include "liggghts_fix/link/grain_books.h"
#include "liggghts_fix/link/handshake.h"
#include "liggghts_fix/link/opening_forces.h"

namespace footfall {

// Work on the boundaries [J].
struct BoundaryWork {
  double in_window = 0.0;  // by the grains, in the last complete window
  double given = 0.0;      // by the grains, over all windows whose next state is known
  double received = 0.0;   // by the mechanism, over the same windows
  double all = 0.0;        // by the grains

  double residual() const { return given - received; }
  void begin_window() {
    given += in_window;
    in_window = 0.0;
  }
};

class WindowExchange {
 public:
  // All must outlive this; link: null without a partner.
  WindowExchange(Link* link, const Handshake& agreed, GrainBooks& grains)
      : link_(link), agreed_(agreed), grains_(grains), opening_(bodies_) {}
  // After the handshake: the coupled bodies, in their order.
  void begin(CoupledBodies& bodies);

  DemBody& body(int index) { return *bodies_[index]; }
  OpeningForces& opening_forces() { return opening_; }

  // --- A DEM step.

  // Before DEM step `step`: begins a window if none is open (receives Motion), moves every
  // boundary, and clears the contacts of the last step. Every fix that needs the new poses calls
  // it; only the first call of a step acts.
  void begin_substep(std::int64_t step);
  bool in_last_substep() const { return motion_.last_window && substeps_left_ == 1; }  // of the scene
  bool window_begins() const { return substeps_left_ == motion_.n; }  // the present DEM step is its first
  int substeps_left() const { return substeps_left_; }
  double time() const;  // at the end of the DEM step [s]
  // After the forces. True when the window is complete: write_shares, a gather over the ranks, and
  // finish_window follow.
  bool end_substep();
  // One row of numbers: whether this rank must end, numbers of its grains (GrainBooks), and
  // their loads on the bodies.
  void write_shares(std::int64_t grains, bool end_requested, std::vector<double>& row);
  // rows: the rows of all ranks in order. Throws NumericalError for a load that is not finite, and as
  // GrainBooks does.
  void finish_window(const std::vector<double>& rows, int ranks);
  void warn(const std::string& coded_text) { load_.warnings.push_back(coded_text); }  // with the next load
  void wall_is_gone(const std::string& name) { load_.gone_walls.push_back(name); }    // likewise

  // --- Between two windows.

  std::int64_t count() const { return windows_; }  // completed
  bool finished() const { return finished_; }      // the last window is done and both sides have closed
  bool end_early();  // the script ends before the scene, as it may; true: the partner knows
  // A signal requested the end of a rank. All ranks know after the same window and leave LIGGGHTS'
  // loop at the same step; a signal may reach one rank only, and LIGGGHTS would wait for the others
  // for ever.
  bool end_requested() const { return load_.end_requested; }
  // Folder into which this side has to save its state now; empty: no checkpoint is required.
  std::string checkpoint_folder() const { return substeps_left_ == 0 && windows_ > 0 ? motion_.checkpoint : ""; }
  bool checkpoint_undisturbed() const { return motion_.undisturbed; }  // only if the run's bits stay the same
  // All files are written, or (done false) none, because this was impossible undisturbed.
  void checkpoint_done(std::int64_t step, bool done);
  const BoundaryWork& work() const { return work_; }
  double max_overlap_over_radius() const { return overlap_; }

  void visit(Archive& archive);

 private:
  void begin_window();
  void require_expected(const Motion& motion) const;  // all but the motions of the bodies
  void begin_window_of(std::size_t body);
  void add_shares(const std::vector<double>& rows, int ranks);
  void send_load();
  void finish();  // the last window is done

  Link* link_;
  const Handshake& agreed_;
  GrainBooks& grains_;
  OpeningForces::Bodies bodies_;
  OpeningForces opening_;
  Motion motion_;                          // of the open window
  std::vector<BodyMotion> at_last_start_;  // computed states at the start of the last window
  Load load_;
  std::int64_t step_ = -1;  // the last one begun
  int substeps_left_ = 0;   // of the open window; 0: none is open
  std::int64_t windows_ = 0;
  bool finished_ = false;
  BoundaryWork work_;
  double overlap_ = 0.0;  // largest over radius [-]
  // Wall-clock times [s]: of the last Load (0: none yet), of the wait for the Motion after it, of
  // the last DEM step.
  double sent_ = 0.0, waited_ = 0.0, stepped_ = 0.0;
};

}  // namespace footfall
