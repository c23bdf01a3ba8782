// While a rank waits for the motion of a window, it is pinned to its core.

#include "liggghts_fix/link/window_exchange.h"

#include <sched.h>

#include <algorithm>
#include <cmath>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "coupler/base/interrupt.h"
#include "coupler/message_fields.h"
#include "liggghts_fix/link/codes.h"
#include "liggghts_fix/link/number.h"

namespace footfall {
namespace {

// Pins this rank to its core while it waits. mbd_solver meanwhile computes on the core of some
// rank; a rank that wakes and finds its core occupied would be moved to another core, whose cache
// holds another rank's grains (on two cores that cost 15 % of the DEM time). While a rank works it
// may be moved, if the system has reasons.
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

// A step ends within a few times the duration of the last one.
void promise_next_step(double& last) {
  constexpr double kLate = 0.3;  // [s]
  const double now = wall_clock();
  promise_progress(4.0 * (last > 0.0 ? now - last : 0.0) + kLate);
  last = now;
}

}  // namespace

void WindowExchange::begin(CoupledBodies& bodies) {
  sent_ = wall_clock();
  for (const std::string& name : bodies.names())
    bodies_.push_back(
        std::make_unique<DemBody>(bodies.scene_body(name, kUnitStyle), agreed_.scheme(), agreed_.gravity()));
  load_.bodies.resize(bodies_.size());
}

double WindowExchange::time() const { return motion_.time + agreed_.script().dt * (motion_.n - substeps_left_); }

// --- A DEM step.

void WindowExchange::begin_substep(std::int64_t step) {
  if (step == step_) return;
  promise_next_step(stepped_);
  FOOTFALL_DEMAND(agreed_.is_done());
  if (finished_)
    throw InputError(code::kSceneHasEnded, "couple/mbd: the scene ended at t = ", ten_digits(agreed_.accept().t_end),
                     " s, but the script continues. Remove every `run` after the end of the scene, or `unfix` the "
                     "coupling before it, if the grains shall continue alone");
  step_ = step;
  opening_.begin_substep();
  if (substeps_left_ == 0) begin_window();
  for (const auto& body : bodies_) {
    body->advance();
    body->clear_contacts();
  }
}

void WindowExchange::begin_window() {
  const double start = wall_clock();
  {
    const PinToCore pinned;
    link_->receive(motion_);
  }
  waited_ = wall_clock() - start;
  require_expected(motion_);
  for (std::size_t i = 0; i < bodies_.size(); ++i) begin_window_of(i);
  work_.begin_window();
  at_last_start_ = motion_.bodies;
  substeps_left_ = motion_.n;
}

void WindowExchange::begin_window_of(std::size_t i) {
  DemBody& body = *bodies_[i];
  const BodyMotion& state = motion_.bodies[i];
  const std::string& name = agreed_.script().bodies[i];
  if (state.mode_count() != body.boundary().mode_count())
    throw ProtocolError(code::kMotionUnexpected, "body \"", name, "\" was sent with ", state.mode_count(),
                        " modal coordinates; its boundary has ", body.boundary().mode_count());
  if (const std::string place = first_not_finite(state); !place.empty())
    throw NumericalError(code::kMotionNotFinite, "the motion of body \"", name, "\" at t = ", ten_digits(motion_.time),
                         " s is not finite (", place, ")");
  if (windows_ > 0) work_.received += body.work_between(at_last_start_[i], state);
  static const KnownPath unknown;
  body.begin_window(state, motion_.n, agreed_.script().dt,
                    agreed_.script().requires_masses ? motion_.inverse_masses[i] : 0.0, motion_.closing,
                    motion_.paths.empty() ? unknown : motion_.paths[i]);
}

void WindowExchange::require_expected(const Motion& motion) const {
  const std::string window = concat("window ", windows_, ": ");
  const int n = agreed_.script().n;
  if (!std::isfinite(motion.time)) throw NumericalError(code::kMotionNotFinite, window, "its time is not finite");
  if (motion.window != windows_ || motion.bodies.size() != bodies_.size() || motion.n < 1 || (n > 0 && motion.n > n))
    throw ProtocolError(code::kMotionUnexpected, window, link_->partner(), " sent a Motion for window ", motion.window,
                        " of ", motion.n, " DEM steps with ", motion.bodies.size(), " bodies; expected at most ", n,
                        " DEM steps and ", bodies_.size(), " bodies");
  const auto fits = [&](const KnownPath& path) {
    return path.cols() == 0 || (path.cols() == motion.n && path.allFinite());
  };
  if (!motion.paths.empty() &&
      (motion.paths.size() != bodies_.size() || !std::all_of(motion.paths.begin(), motion.paths.end(), fits)))
    throw ProtocolError(code::kMotionUnexpected, window, link_->partner(),
                        " sent known paths that do not fit its bodies and DEM steps");
  const std::vector<double>& masses = motion.inverse_masses;
  if (agreed_.script().requires_masses &&
      (masses.size() != bodies_.size() ||
       !std::all_of(masses.begin(), masses.end(), [](double x) { return x >= 0.0 && std::isfinite(x); })))
    throw ProtocolError(code::kMotionUnexpected, window, link_->partner(),
                        " did not send the mass of each body that contacts act on (damping_mass pair)");
}

bool WindowExchange::end_substep() {
  for (const auto& body : bodies_) body->end_substep(agreed_.script().dt);
  return --substeps_left_ == 0;
}

void WindowExchange::write_shares(std::int64_t grains, bool end_requested, std::vector<double>& row) {
  row.assign(1, end_requested ? 1.0 : 0.0);
  grains_.append_share(grains, row);
  for (const auto& body : bodies_) body->append_share(row);
}

void WindowExchange::finish_window(const std::vector<double>& rows, int ranks) {
  add_shares(rows, ranks);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const BodyLoad& load = bodies_[i]->load();
    if (const std::string place = first_not_finite(load); !place.empty())
      throw NumericalError(code::kLoadNotFinite, "the load of the grains on body \"", agreed_.script().bodies[i],
                           "\" after t = ", ten_digits(motion_.time), " s is not finite (", place, ")");
    load_.bodies[i] = load;
    work_.in_window += load.mean.work;
    overlap_ = std::max(overlap_, load.max_overlap_over_radius);
  }
  work_.all += work_.in_window;
  send_load();
  if (motion_.last_window && motion_.checkpoint.empty()) finish();
}

void WindowExchange::add_shares(const std::vector<double>& rows, int ranks) {
  std::size_t of_bodies = 0;
  for (const auto& body : bodies_) of_bodies += body->share_size();
  const std::size_t row_size = 1 + GrainBooks::row_size() + of_bodies;
  FOOTFALL_DEMAND(rows.size() == row_size * static_cast<std::size_t>(ranks));
  for (std::size_t at = 1; at < rows.size(); at += row_size)
    grains_.add_share(&rows[at], agreed_.script().bodies, agreed_.script().dt);
  grains_.finish_window(time(), load_);
  for (const auto& body : bodies_) body->clear_load();
  for (std::size_t at = 0; at < rows.size(); at += row_size) {
    load_.end_requested = rows[at] != 0.0 || load_.end_requested;
    const double* next = &rows[at] + 1 + GrainBooks::row_size();
    for (const auto& body : bodies_) next = body->add_share(next);
  }
  for (const auto& body : bodies_) body->finish_load();
}

void WindowExchange::send_load() {
  load_.window = windows_++;
  const double now = wall_clock();
  load_.wall_seconds = now - sent_ - waited_;
  load_.waited_seconds = waited_;
  sent_ = now;
  link_->send(load_);
  load_.warnings.clear();
  load_.gone_walls.clear();
}

void WindowExchange::finish() {
  finished_ = true;
  grains_.close();
  link_->close();
}

// --- Between two windows.

bool WindowExchange::end_early() {
  finished_ = link_->fail("", Status::kOk);
  if (finished_) grains_.close();
  return finished_;
}

void WindowExchange::checkpoint_done(std::int64_t step, bool done) {
  CheckpointDone answer;
  answer.window = motion_.window;
  answer.step = step;
  answer.done = done;
  motion_.checkpoint.clear();
  link_->send(answer);
  if (motion_.last_window) finish();
}

void WindowExchange::visit(Archive& archive) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) archive(agreed_.script().bodies[i].c_str(), *bodies_[i]);
  archive("opening_forces", opening_.stored());
  archive("at_last_start", at_last_start_);
  archive("windows", windows_);
  grains_.visit(archive);
  archive("window_work", work_.in_window);
  archive("work_given", work_.given);
  archive("work_received", work_.received);
  archive("work", work_.all);
  archive("overlap", overlap_);
}

}  // namespace footfall
