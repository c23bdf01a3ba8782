#pragma once
// The DEM side of the coupling, without LIGGGHTS and MPI: the owner of its parts, its checkpoints,
// and the end of a run. Every rank holds one and calls it in step with the others; the transport of
// the link gives all ranks the same messages.

#include <cstdint>
#include <string>

#include "coupler/archive.h"
#include "coupler/link.h"
#include "liggghts_fix/link/coupled_bodies.h"
#include "liggghts_fix/link/dem_checkpoint.h"
#include "liggghts_fix/link/grain_books.h"
#include "liggghts_fix/link/handshake.h"
#include "liggghts_fix/link/window_exchange.h"

namespace footfall {

// Runs of the script beyond the end of the scene. Loops of the script continue beyond this end: after a
// jump, runs beyond it are left out as long as the script couples.
class ScriptRuns {
 public:
  void script_jumps() { jumps_ = true; }  // after the first run
  // The number of runs left out, including the present run, when the scene has ended; 0: the present run is
  // executed.
  int left_out(bool couples) { return jumps_ && couples ? ++left_out_ : 0; }
  // A loop waits for steps that do not come.
  void end_script() { script_is_over_ = true; }
  bool script_is_over() const { return script_is_over_; }
  void set_repeats(bool every) { repeats_ = every; }  // the run that begins is a `run N every M`
  bool repeats() const { return repeats_; }

 private:
  bool jumps_ = false;    // the script has jumped since the first run
  bool repeats_ = false;  // the present command runs several times
  int left_out_ = 0;      // runs
  bool script_is_over_ = false;
};

class DemLink {
 public:
  // Null when this program runs alone.
  explicit DemLink(Link* link)
      : link_(link), coupled_(link, checkpoint_), handshake_(link), window_(link, handshake_, grains_) {}

  bool has_partner() const { return link_ != nullptr; }
  CoupledBodies& bodies() { return coupled_; }
  Handshake& handshake() { return handshake_; }
  WindowExchange& window() { return window_; }
  GrainBooks& grains() { return grains_; }
  ScriptRuns& runs() { return runs_; }

  // script: all fields except `bodies`. The first call exchanges Start and Accept. Later calls
  // (further runs) throw InputError when the time step or gravity has changed.
  void start(Start script);
  bool started() const { return handshake_.is_done(); }
  bool finished() const { return window_.finished(); }  // the last window is done and both sides have closed
  const Eigen::Vector3d& script_gravity() const { return handshake_.script().gravity; }  // zero when unknown [m/s2]
  bool is_held_by_walls(int body) const { return handshake_.is_held_by_walls(coupled_.name(body)); }

  // Checkpoints, between two windows.
  std::string checkpoint_text(std::int64_t step);         // content of DemCheckpoint::file
  bool resumed() const { return checkpoint_.is_open(); }  // known after the handshake
  std::string grains_not_read() const { return checkpoint_.grains_not_read(); }

  // The script has ended. If the scene has not, informs the partner and throws InputError.
  void script_ended();
  // A command (its name begins the message) removes the coupling: as script_ended, but allowed
  // before the first run.
  void uncoupled_by(const std::string& command);
  // This side failed: the partner gets the reason. True if it has received it.
  bool fail(const std::string& reason, Status status = Status::kFailed) noexcept {
    return link_ == nullptr || link_->fail(reason, status);
  }

 private:
  Link* link_;
  DemCheckpoint checkpoint_;
  CoupledBodies coupled_;
  Handshake handshake_;
  GrainBooks grains_;
  WindowExchange window_;
  ScriptRuns runs_;
};

}  // namespace footfall
