#pragma once
// The grains' side of the coupling, without LIGGGHTS and without MPI: handshake, windows, and how a run ends. Every
// rank holds one and calls it in step with the others; the link's transport makes them all hear the same.

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "coupler/archive.h"
#include "coupler/link.h"
#include "liggghts_fix/dem_body.h"

namespace footfall {

class DemLink {
 public:
  // Null when this program runs alone: any use then throws InputError that says how to start both.
  explicit DemLink(Link* link) : link_(link) {}

  // A body of the scene; the first call makes the handshake. Throws InputError for a name that the scene does not know,
  // with a guess.
  const CoupledBody& scene_body(const std::string& name, const std::string& unit_style);
  // The body will be moved and loaded here; returns its index, also to all who ask again. Throws InputError for a new
  // one after start().
  int couple(const std::string& name, const std::string& unit_style);

  // Grains touch the body's surface, or its chain of beams of this number: what nothing touches is told at the start.
  void touch_surface(int body) { touched_[static_cast<std::size_t>(body)].surface = true; }
  void touch_chain(int body, int chain) { touched_[static_cast<std::size_t>(body)].chains.insert(chain); }

  // What the script says (all of it but the names). First call: Start and Accept. Later calls (further runs) check that
  // nothing has changed: InputError.
  void start(Start script);
  double dt() const { return dt_; }  // as started [s]
  bool started() const { return scheme_ != nullptr; }
  const Scheme& scheme() const { return *scheme_; }  // after start()
  bool finished() const { return finished_; }        // the last window is done and both sides have closed

  int body_count() const { return static_cast<int>(names_.size()); }
  DemBody& body(int index) { return *bodies_[static_cast<std::size_t>(index)]; }
  const std::string& body_name(int index) const { return names_[static_cast<std::size_t>(index)]; }

  // A run is set up: LIGGGHTS evaluates all forces anew, and they stand before the next substep. After start().
  void expect_set_up();
  // Not so behind a checkpoint, where the forces of the last step stand on. standing: of this rank, all bodies in a row
  // of numbers; the sum of all ranks is kept, and then stands on one of them.
  std::vector<double> standing() const;
  void keep_standing(std::vector<double> of_all_ranks) { kept_standing_ = std::move(of_all_ranks); }
  void stand_as_kept(bool on_this_rank);
  // Before the grains' substep `step`: opens a window if none is open (receives Motion), advances every boundary, and
  // forgets the contacts of the last step. Every fix that needs the new poses calls it; the first one of a step acts.
  void begin_substep(std::int64_t step);
  // True during the last substep of the scene.
  bool in_last_substep() const { return last_window_ && substeps_left_ == 1; }
  // After it. True when the window is complete: then write_shares, gather, and finish_window follow.
  bool end_substep();
  // One row of numbers: what the grains of this rank did to the bodies in the window, how many they are, and how many
  // LIGGGHTS has lost since the last one; and whether this rank was asked to end.
  void write_shares(std::int64_t grains, bool asked_to_end, std::vector<double>& row);
  // Grains have changed ranks. This rank had so many before, and has so many now: what the sum over ranks has lost
  // stood outside of the box.
  void grains_exchanged(std::int64_t before, std::int64_t now) { lost_here_ += static_cast<double>(before - now); }
  // rows: those of all ranks, one behind the other. Throws NumericalError for a load that is not finite, and when more
  // than the share max_lost of all grains is lost.
  void finish_window(const std::vector<double>& rows, int ranks);

  // A rank was asked to end by a signal: known to all ranks after the same window, so that all leave LIGGGHTS' loop at
  // the same step (a signal may reach one rank alone, and LIGGGHTS would wait for the others for ever).
  bool asked_to_end() const { return asked_to_end_; }

  // Checkpoints: the folder in which this side has to keep itself after the window that has just ended; empty: it has
  // not. `step` as for start().
  std::string checkpoint() const { return substeps_left_ == 0 && windows_ > 0 ? motion_.checkpoint : ""; }
  bool keeps_quietly() const { return motion_.undisturbed; }  // without a trace in what follows
  static std::string memory_file(const std::string& folder) { return folder + "/grains.txt"; }
  std::string memory(std::int64_t step);  // what stands in that file
  // All files of the folder are there; done false: none is, as it could not be done quietly.
  void kept(std::int64_t step, bool done);
  // The run goes on from a checkpoint. After the handshake.
  bool resumed() const { return memory_.has_value(); }
  std::string wrong_grains() const;  // what to say when LIGGGHTS has not read the grains of the checkpoint

  // Of the grains, zero where it is not known [m/s2]. After start().
  const Eigen::Vector3d& script_gravity() const { return script_.gravity; }
  // Of the grains at the start, where it varies and could not be told before [m/s2]. Throws InputError where it is not
  // the scene's. After start().
  void hold_against_scene(const Eigen::Vector3d& gravity) const;
  // As sent at the start. One that has gone since, or moves now, is told with the next load, once. After start().
  const std::vector<StaticWall>& script_walls() const { return script_.walls; }
  void wall_is_gone(const std::string& name);
  // Planes and static meshes of the script stop this body: the scene says so. After start().
  bool is_held_by_walls(int body) const;
  // For the user, with the next load.
  void warn(const std::string& text) { load_.warnings.push_back(text); }
  double time() const { return motion_.time + dt_ * (motion_.n - substeps_left_); }  // at the end of this substep [s]

  // For thermo output.
  std::int64_t windows() const { return windows_; }  // completed
  // Over all windows whose next state is known [J].
  double energy_residual() const { return work_given_ - work_received_; }
  double work() const { return work_; }  // of the grains on all boundaries [J]
  double max_overlap_over_radius() const { return overlap_; }

  // The script has ended. If the scene has not, tells the partner and throws InputError: too early, or never started.
  void script_ended();
  // A command (its name begins the message) takes the coupling away: as script_ended, but nothing is wrong before the
  // first run.
  void uncoupled_by(const std::string& command);
  // This side failed: the partner hears why. True if it has.
  bool fail(const std::string& reason, Status status = Status::kFailed) noexcept {
    return link_ == nullptr || link_->fail(reason, status);
  }
  bool has_partner() const { return link_ != nullptr; }
  // How long the partner may be silent before it counts as lost [s].
  void set_patience(double seconds);
  void set_max_lost(double share) { max_lost_ = share; }  // of all grains [-]

 private:
  void greet(const std::string& unit_style);
  void read_memory();
  void go_on_from_memory();
  void visit(Archive& archive);
  void begin_window();
  void say_alive();
  void tell_untouched(std::vector<std::string>& warnings) const;
  void count_grains(const std::vector<double>& rows, int ranks);

  Link* link_;
  bool greeted_ = false;
  Geometry geometry_;
  std::vector<std::string> names_;
  struct Touched {
    bool surface = false;
    std::set<int> chains;
  };
  std::vector<Touched> touched_;  // in the order of names_
  std::unique_ptr<Scheme> scheme_;
  std::vector<std::unique_ptr<DemBody>> bodies_;
  bool own_patience_ = false;  // the script has its own
  double lost_here_ = 0.0;     // given to other ranks and not taken from them, since the last write_shares
  double max_lost_ = 1.0;      // of all grains [-]
  double dt_ = 0.0;            // [s]
  int n_ = 0;
  Start script_;                   // what the script said at the first run
  std::optional<Archive> memory_;  // of the checkpoint that the run goes on from
  Accept accept_;
  Motion motion_;                          // of the open window
  std::vector<BodyMotion> at_last_start_;  // computed states at the last window's start
  Load load_;
  bool last_window_ = false;
  bool finished_ = false;
  bool asked_to_end_ = false;
  bool forces_are_new_ = false;  // the set-up of a run has evaluated them
  std::vector<double> kept_standing_;
  std::int64_t step_ = -1;  // the last one begun
  int substeps_left_ = 0;   // of the open window; 0: none is open
  std::int64_t windows_ = 0;
  double window_work_ = 0.0;    // of the last complete window [J]
  double work_given_ = 0.0;     // [J]
  double work_received_ = 0.0;  // [J]
  double work_ = 0.0;           // [J]
  double overlap_ = 0.0;
  // Wall clock [s]: when the last load was sent (0: none yet) and the motion after it was asked for, and how long it was
  // waited for.
  double sent_ = 0.0, waited_ = 0.0;
  double stepped_ = 0.0;  // when the last substep began
};

}  // namespace footfall
