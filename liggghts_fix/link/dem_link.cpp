// A window: Motion is received and moves the boundaries substep by substep; the loads of all ranks are added and sent as
// Load. In between the rank is pinned to its core while it waits.

#include "liggghts_fix/link/dem_link.h"

#include <sched.h>

#include <algorithm>
#include <cmath>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "coupler/base/interrupt.h"
#include "coupler/base/text.h"
#include "coupler/message_fields.h"
#include "coupler/schemes/registry.h"
#include "liggghts_fix/codes.h"

namespace footfall {
namespace {

constexpr int kDigits = 10;

// Numbers of the rank itself at the start of its row: grains, lost grains, end requested, changes, fault.
enum RankNumber : std::size_t {
  kGrains,
  kLost,
  kEndRequested,
  kInserted,
  kLeft,
  kChanged,
  kLostMass,
  kAdded,
  kRemoved,
  kAddedMass,
  kRemovedMass,
  kFault,
  kFaultTime,
  kFaultTag,
  kFaultBody,
  kFaultSpeed,
  kFaultRadius,
  kOfTheRank
};

std::string number(double value) { return number_text(value, kDigits); }

std::string vector_text(const Eigen::Vector3d& v) {
  return "(" + number(v[0]) + ", " + number(v[1]) + ", " + number(v[2]) + ")";
}

// Pins this rank to its core while it waits. mbd_solver meanwhile computes on the core of some rank; a rank that wakes
// and finds its core occupied would be moved to another core, whose cache holds another rank's grains (on two cores that
// cost 15 % of the DEM time). While a rank works it may be moved, if the system has reasons.
class PinToCore {
 public:
  PinToCore() {
    const int core = sched_getcpu();
    if (core < 0 || core >= CPU_SETSIZE || sched_getaffinity(0, sizeof allowed_, &allowed_) != 0) return;
    cpu_set_t here;
    CPU_ZERO(&here);
    CPU_SET(core, &here);
    pinned_ = sched_setaffinity(0, sizeof here, &here) == 0;
  }
  ~PinToCore() {
    if (pinned_) sched_setaffinity(0, sizeof allowed_, &allowed_);
  }
  PinToCore(const PinToCore&) = delete;
  PinToCore& operator=(const PinToCore&) = delete;

 private:
  cpu_set_t allowed_;
  bool pinned_ = false;  // false where the system does not allow it: nothing is changed then
};

}  // namespace

// --- Before the first run.

void DemLink::set_patience(double seconds) {
  own_patience_ = true;
  if (link_ != nullptr) link_->set_patience(seconds);
}

// --- A run.

void DemLink::start(Start script) {
  if (started()) {
    if (script.dt != dt_)
      throw InputError(code::kTimeStepChanged,
                       "couple/mbd: the time step changed from " + number(dt_) + " to " + number(script.dt) +
                           " s between two runs; the coupling needs one time step for the whole scene");
    if (script.gravity_known && script_.gravity_known && script.gravity != script_.gravity)
      throw InputError(code::kGravityChanged, "couple/mbd: the gravity of the grains changed from " +
                                                  vector_text(script_.gravity) + " to " + vector_text(script.gravity) +
                                                  " m/s2 between two runs; that of the scene is constant");
    FOOTFALL_DEMAND(script.n == n_);
    return;
  }
  FOOTFALL_DEMAND(coupled_.greeted());
  dt_ = script.dt;
  n_ = script.n;
  script.bodies = coupled_.names();
  for (std::string& warning : coupled_.untouched_warnings()) script.warnings.push_back(std::move(warning));
  coupled_.close();
  script_ = std::move(script);
  link_->send(script_);
  link_->receive(accept_);
  require_finite(accept_, link_->partner());
  if (accept_.patience > 0.0 && !own_patience_) link_->set_patience(accept_.patience);
  if (accept_.outflow) outflow_ = true;
  sent_ = wall_clock();
  lost_here_ = 0.0;
  changes_here_ = {};
  scheme_ = make_scheme(accept_.scheme);
  for (const std::string& name : coupled_.names())
    bodies_.push_back(std::make_unique<DemBody>(coupled_.scene_body(name, kUnitStyle), *scheme_,
                                                (script_.gravity_known ? script_.gravity : accept_.gravity).norm()));
  load_.bodies.resize(bodies_.size());
  if (!resumed()) return;
  checkpoint_.restore(script_.step, [this](Archive& archive) { visit(archive); });
  if (stored_forces_.size() != opening_forces().size())
    throw InputError(code::kCheckpointDamaged, DemCheckpoint::file(checkpoint_.folder()) +
                                                   ": opening_forces: " + std::to_string(stored_forces_.size()) +
                                                   " numbers, expected " + std::to_string(opening_forces().size()) +
                                                   ": the checkpoint is damaged, or belongs to another scene");
}

void DemLink::require_scene_gravity(const Eigen::Vector3d& gravity) const {
  if (accept_.gravity_known && !is_same_gravity(gravity, accept_.gravity))
    throw InputError(code::kGravityDiffers, gravity_differs(gravity, accept_.gravity, " at the start"));
}

void DemLink::wall_is_gone(const std::string& name) {
  std::vector<StaticWall>& walls = script_.walls;
  walls.erase(std::remove_if(walls.begin(), walls.end(), [&](const StaticWall& wall) { return wall.name == name; }),
              walls.end());
  load_.gone_walls.push_back(name);
}

bool DemLink::is_held_by_walls(int body) const {
  const std::vector<std::string>& held = accept_.held_by_walls;
  return std::find(held.begin(), held.end(), coupled_.name(body)) != held.end();
}

void DemLink::expect_set_up() {
  for (const auto& body : bodies_) body->clear_contacts();
  set_up_forces_ = true;
}

// --- A substep.

// Within a few times the duration of the last step.
void DemLink::promise_next_step() {
  constexpr double kLate = 0.3;  // [s]
  const double now = wall_clock();
  promise_progress(4.0 * (stepped_ > 0.0 ? now - stepped_ : 0.0) + kLate);
  stepped_ = now;
}

void DemLink::begin_substep(std::int64_t step) {
  if (step == step_) return;
  promise_next_step();
  FOOTFALL_DEMAND(started());
  if (finished_)
    throw InputError(code::kSceneHasEnded,
                     "couple/mbd: the scene ended at t = " + number(accept_.t_end) +
                         " s, but the script continues. Remove the `run` after the one that ends the scene, or `unfix` "
                         "the coupling before it, if the grains shall continue alone");
  step_ = step;
  if (set_up_forces_)
    for (const auto& body : bodies_) body->use_as_opening_force();
  set_up_forces_ = false;
  if (substeps_left_ == 0) begin_window();
  for (const auto& body : bodies_) {
    body->advance();
    body->clear_contacts();
  }
}

void DemLink::begin_window() {
  const double start = wall_clock();
  {
    const PinToCore pinned;
    link_->receive(motion_);
  }
  waited_ = wall_clock() - start;
  require_expected(motion_);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const BodyMotion& state = motion_.bodies[i];
    if (state.mode_count() != bodies_[i]->boundary().mode_count())
      throw ProtocolError(code::kMotionUnexpected, "body \"" + coupled_.names()[i] + "\" was sent with " +
                                                       std::to_string(state.mode_count()) +
                                                       " modal coordinates; its boundary has " +
                                                       std::to_string(bodies_[i]->boundary().mode_count()));
    if (const std::string place = first_not_finite(state); !place.empty())
      throw NumericalError(code::kMotionNotFinite, "the motion of body \"" + coupled_.names()[i] + "\" at t = " +
                                                       number(motion_.time) + " s is not finite (" + place + ")");
    if (windows_ > 0) work_received_ += bodies_[i]->work_between(at_last_start_[i], state);
    static const KnownPath unknown;
    bodies_[i]->begin_window(state, motion_.n, dt_, script_.requires_masses ? motion_.inverse_masses[i] : 0.0,
                             motion_.closing, motion_.paths.empty() ? unknown : motion_.paths[i]);
  }
  work_given_ += window_work_;
  window_work_ = 0.0;
  at_last_start_ = motion_.bodies;
  last_window_ = motion_.last_window;
  substeps_left_ = motion_.n;
}

// All but the motions of the bodies.
void DemLink::require_expected(const Motion& motion) const {
  const std::string window = "window " + std::to_string(windows_) + ": ";
  if (!std::isfinite(motion.time)) throw NumericalError(code::kMotionNotFinite, window + "its time is not finite");
  if (motion.window != windows_ || motion.bodies.size() != bodies_.size() || motion.n < 1 || (n_ > 0 && motion.n > n_))
    throw ProtocolError(code::kMotionUnexpected, window + link_->partner() + " sent a Motion for window " +
                                                     std::to_string(motion.window) + " of " + std::to_string(motion.n) +
                                                     " substeps with " + std::to_string(motion.bodies.size()) +
                                                     " bodies; expected at most " + std::to_string(n_) +
                                                     " substeps and " + std::to_string(bodies_.size()) + " bodies");
  const auto fits = [&](const KnownPath& path) {
    return path.cols() == 0 || (path.cols() == motion.n && path.allFinite());
  };
  if (!motion.paths.empty() &&
      (motion.paths.size() != bodies_.size() || !std::all_of(motion.paths.begin(), motion.paths.end(), fits)))
    throw ProtocolError(code::kMotionUnexpected,
                        window + link_->partner() + " sent known paths that do not fit its bodies and substeps");
  const std::vector<double>& masses = motion.inverse_masses;
  if (script_.requires_masses &&
      (masses.size() != bodies_.size() ||
       !std::all_of(masses.begin(), masses.end(), [](double x) { return x >= 0.0 && std::isfinite(x); })))
    throw ProtocolError(
        code::kMotionUnexpected,
        window + link_->partner() + " did not send the mass of each body that contacts act on (damping_mass pair)");
}

bool DemLink::end_substep() {
  for (const auto& body : bodies_) body->end_substep(dt_);
  return --substeps_left_ == 0;
}

void DemLink::write_shares(std::int64_t grains, bool end_requested, std::vector<double>& row) {
  row.assign(kOfTheRank, 0.0);
  row[kGrains] = static_cast<double>(grains);
  row[kLost] = lost_here_;
  row[kEndRequested] = end_requested ? 1.0 : 0.0;
  row[kInserted] = changes_here_.inserted;
  row[kLeft] = changes_here_.left;
  row[kChanged] = changes_here_.changed;
  row[kLostMass] = changes_here_.lost_mass;
  row[kAdded] = changes_here_.added;
  row[kRemoved] = changes_here_.removed;
  row[kAddedMass] = changes_here_.added_mass;
  row[kRemovedMass] = changes_here_.removed_mass;
  row[kFault] = fault_.kind;
  row[kFaultTime] = fault_.time;
  row[kFaultTag] = fault_.tag;
  row[kFaultBody] = fault_.body;
  row[kFaultSpeed] = fault_.speed;
  row[kFaultRadius] = fault_.radius;
  lost_here_ = 0.0;
  changes_here_ = {};
  fault_ = {};
  for (const auto& body : bodies_) body->append_share(row);
}

void DemLink::grains_changed(const GrainChanges& more) {
  changes_here_.lost_mass += more.lost_mass;
  changes_here_.added += more.added;
  changes_here_.removed += more.removed;
  changes_here_.added_mass += more.added_mass;
  changes_here_.removed_mass += more.removed_mass;
  if (!counts_changes()) return;
  changes_here_.inserted += more.inserted;
  changes_here_.left += more.left;
  changes_here_.changed += more.changed;
}

void DemLink::stop_for(const GrainFault& fault) const {
  const std::string which = "t = " + number(fault.time) + " s: grain " + std::to_string(fault.tag);
  const std::string name = "body \"" + coupled_.name(fault.body) + "\"";
  if (fault.kind == GrainFault::kPassed)
    throw NumericalError(code::kGrainPassed,
                         which + " has passed through the surface of " + name +
                             ": its contact was pressed in by more than its radius, " + number_text(fault.radius) +
                             " m. Use stiffer grains, or smaller loads or speeds; a smaller time step if it is fast (" +
                             number_text(fault.speed, 3) + " m/s)");
  const double travel = fault.speed * dt_;
  throw NumericalError(code::kGrainTooFast, which + " meets " + name + " at " + number_text(fault.speed, 3) + " m/s, " +
                                                number_text(travel, 3) + " m in a time step, with a radius of " +
                                                number_text(fault.radius, 3) +
                                                " m: it may pass through without a contact. Use a time step of " +
                                                number_text(0.1 * fault.radius / fault.speed, 2) +
                                                " s or less, or look for what makes the grain so fast");
}

// Of all ranks: present grains, and those lost since the start.
void DemLink::count_grains(const std::vector<double>& rows, int ranks) {
  const std::size_t row_size = rows.size() / static_cast<std::size_t>(ranks);
  double grains = 0.0, lost = 0.0;
  for (std::size_t rank = 0; rank < static_cast<std::size_t>(ranks); ++rank) {
    const double* const row = &rows[rank * row_size];
    grains += row[kGrains];
    lost += row[kLost];
    load_.changes.inserted += row[kInserted];
    load_.changes.left += row[kLeft];
    load_.changes.changed += row[kChanged];
    load_.changes.lost_mass += row[kLostMass];
    load_.changes.added += row[kAdded];
    load_.changes.removed += row[kRemoved];
    load_.changes.added_mass += row[kAddedMass];
    load_.changes.removed_mass += row[kRemovedMass];
    if (row[kFault] != 0.0)
      stop_for({static_cast<GrainFault::Kind>(std::lround(row[kFault])), row[kFaultTime],
                static_cast<int>(std::lround(row[kFaultTag])), static_cast<int>(std::lround(row[kFaultBody])),
                row[kFaultSpeed], row[kFaultRadius]});
  }
  load_.particles = std::llround(grains);
  if (lost <= 0.0) return;
  const bool first = load_.lost == 0;
  load_.lost += std::llround(lost);
  if (outflow_) return;
  const double all = grains + static_cast<double>(load_.lost);
  const std::string what = "t = " + number(time()) + " s: " + std::to_string(load_.lost) + " of " + number(all) +
                           " grains have left the box, and LIGGGHTS has lost them";
  if (static_cast<double>(load_.lost) > max_lost_ * all)
    throw NumericalError(code::kTooManyGrainsLost,
                         what + "; a share of " + number(max_lost_) +
                             " may. Give them more room (headroom and margin of [particles.box]; in a LIGGGHTS script "
                             "the region of create_box), or make the bed calmer; where grains are meant to leave, set "
                             "particles.outflow = true in the scene");
  if (first) warn(with_code(code::kGrainsLost, what + " (reported once; total: grains_lost in the summary)"));
}

void DemLink::finish_window(const std::vector<double>& rows, int ranks) {
  std::size_t row_size = kOfTheRank;
  for (const auto& body : bodies_) row_size += body->share_size();
  FOOTFALL_DEMAND(rows.size() == row_size * static_cast<std::size_t>(ranks));
  count_grains(rows, ranks);
  for (const auto& body : bodies_) body->clear_load();
  const double* next = rows.data();
  for (int rank = 0; rank < ranks; ++rank) {
    end_requested_ = next[kEndRequested] != 0.0 || end_requested_;
    next += kOfTheRank;
    for (const auto& body : bodies_) next = body->add_share(next);
  }
  for (const auto& body : bodies_) body->finish_load();

  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const BodyLoad& load = bodies_[i]->load();
    if (const std::string place = first_not_finite(load); !place.empty())
      throw NumericalError(code::kLoadNotFinite, "the load of the grains on body \"" + coupled_.names()[i] +
                                                     "\" after t = " + number(motion_.time) + " s is not finite (" +
                                                     place + ")");
    load_.bodies[i] = load;
    window_work_ += load.mean.work;
    overlap_ = std::max(overlap_, load.max_overlap_over_radius);
  }
  work_ += window_work_;
  load_.window = windows_++;
  load_.end_requested = end_requested_;
  const double now = wall_clock();
  load_.wall_seconds = now - sent_ - waited_;
  load_.waited_seconds = waited_;
  sent_ = now;
  link_->send(load_);
  load_.warnings.clear();
  load_.gone_walls.clear();
  if (last_window_ && motion_.checkpoint.empty()) finish();
}

void DemLink::finish() {
  finished_ = true;
  link_->close();
}

// --- Checkpoints.

std::string DemLink::checkpoint_text(std::int64_t step) {
  const std::vector<std::string>& names = coupled_.names();
  DemCheckpoint::Poses poses;
  for (const CoupledBody& body : coupled_.of_scene()) {
    const auto place = std::find(names.begin(), names.end(), body.boundary.name());
    poses.emplace_back(body.boundary.name(),
                       place == names.end() ? body.initial : bodies_[place - names.begin()]->pose());
  }
  return DemCheckpoint::text(std::move(poses), step, [this](Archive& archive) { visit(archive); });
}

void DemLink::checkpoint_done(std::int64_t step, bool done) {
  CheckpointDone answer;
  answer.window = motion_.window;
  answer.step = step;
  answer.done = done;
  motion_.checkpoint.clear();
  link_->send(answer);
  if (last_window_) finish();
}

void DemLink::visit(Archive& archive) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) archive(coupled_.names()[i].c_str(), *bodies_[i]);
  archive("opening_forces", stored_forces_);
  archive("at_last_start", at_last_start_);
  archive("windows", windows_);
  archive("lost", load_.lost);
  archive("changes", load_.changes);
  archive("window_work", window_work_);
  archive("work_given", work_given_);
  archive("work_received", work_received_);
  archive("work", work_);
  archive("overlap", overlap_);
}

std::vector<double> DemLink::opening_forces() const {
  std::vector<double> row;
  for (const auto& body : bodies_) {
    const OpeningForce& force = body->opening_force();
    row.insert(row.end(), force.F_W.data(), force.F_W.data() + 3);
    row.insert(row.end(), force.T_B.data(), force.T_B.data() + 3);
    row.insert(row.end(), force.Q_a.data(), force.Q_a.data() + force.Q_a.size());
  }
  return row;
}

void DemLink::restore_opening_forces(bool on_this_rank) {
  const double* next = stored_forces_.data();
  for (const auto& body : bodies_) {
    OpeningForce force(body->boundary().mode_count());
    if (on_this_rank) {
      force.F_W = Eigen::Map<const Eigen::Vector3d>(next);
      force.T_B = Eigen::Map<const Eigen::Vector3d>(next + 3);
      force.Q_a = Eigen::Map<const Eigen::VectorXd>(next + 6, force.Q_a.size());
    }
    next += 6 + force.Q_a.size();
    body->set_opening_force(force);
  }
  FOOTFALL_DEMAND(next == stored_forces_.data() + stored_forces_.size());
  set_up_forces_ = false;
}

// --- The end.

void DemLink::uncoupled_by(const std::string& command) {
  if (!started()) {
    coupled_.clear();
    return;
  }
  if (finished_ || link_->closed()) return;
  if (script_.may_end_early) {
    script_ended();
    return;
  }
  throw InputError(
      code::kCouplingRemoved,
      command + ": removes the coupling at t = " + number(time()) +
          " s, before the end of the scene at t = " + number(accept_.t_end) +
          " s. If the grains shall continue alone, allow it: fix ID all couple/mbd every N end script ...");
}

void DemLink::script_ended() {
  if (link_ == nullptr || link_->closed()) return;
  if (started() && script_.may_end_early) {
    finished_ = link_->fail("", Status::kOk);
    return;
  }
  const InputError error =
      !started() ? InputError(code::kScriptWithoutCoupling,
                              "the LIGGGHTS script ended without running `fix couple/mbd`, but the scene has grains. "
                              "Add the fix and a `run`, or run the scene without LIGGGHTS")
                 : InputError(code::kScriptEndedEarly,
                              "the LIGGGHTS script ended at t = " + number(time()) +
                                  " s, before the end of the scene at t = " + number(accept_.t_end) +
                                  " s. `run` at least " + number(std::ceil(accept_.t_end / dt_ - 1e-9)) +
                                  " steps in all, or allow the script to end the run: fix ID all couple/mbd every N "
                                  "end script ...");
  link_->fail(error.what(), Status::kBadInput);
  throw error;
}

}  // namespace footfall
