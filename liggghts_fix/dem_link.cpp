#include "liggghts_fix/dem_link.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "coupler/interrupt.h"
#include "coupler/message_fields.h"
#include "coupler/messages.h"
#include "liggghts_fix/stay_on_core.h"

namespace footfall {
namespace {

std::string number(double value) { return number_text(value, 10); }

}  // namespace

// Within some times as long as the last step took.
void DemLink::say_alive() {
  constexpr double kLate = 0.3;  // [s]
  const double now = wall_clock();
  promise_progress(4.0 * (stepped_ > 0.0 ? now - stepped_ : 0.0) + kLate);
  stepped_ = now;
}

void DemLink::expect_set_up() {
  for (const auto& body : bodies_) body->clear_contacts();
  forces_are_new_ = true;
}

void DemLink::begin_substep(std::int64_t step) {
  if (step == step_) return;
  say_alive();
  FOOTFALL_DEMAND(started());
  if (finished_)
    throw InputError(
        "couple/mbd: the scene ended at t = " + number(accept_.t_end) +
        " s, and the script wants to go on. Remove the `run` after the one that ends the scene, or `unfix` the "
        "coupling before it, if the grains shall go on alone");
  step_ = step;
  if (forces_are_new_)
    for (const auto& body : bodies_) body->take_standing();
  forces_are_new_ = false;
  if (substeps_left_ == 0) begin_window();
  for (const auto& body : bodies_) {
    body->advance();
    body->clear_contacts();
  }
}

void DemLink::begin_window() {
  const double asked = wall_clock();
  {
    const StayOnCore here;
    link_->receive(motion_);
  }
  waited_ = wall_clock() - asked;
  if (!std::isfinite(motion_.time))
    throw NumericalError("window " + std::to_string(windows_) + ": its time is not finite");
  if (motion_.window != windows_ || motion_.bodies.size() != bodies_.size() || motion_.n < 1 ||
      (n_ > 0 && motion_.n > n_))
    throw ProtocolError("window " + std::to_string(windows_) + ": " + link_->partner() + " sent a Motion for window " +
                        std::to_string(motion_.window) + " of " + std::to_string(motion_.n) + " substeps with " +
                        std::to_string(motion_.bodies.size()) + " bodies; expected at most " + std::to_string(n_) +
                        " substeps and " + std::to_string(bodies_.size()) + " bodies");
  const std::vector<double>& inverse_masses = motion_.inverse_masses;
  if (script_.requires_masses &&
      (inverse_masses.size() != bodies_.size() || !std::all_of(inverse_masses.begin(), inverse_masses.end(),
                                                               [](double x) { return x >= 0.0 && std::isfinite(x); })))
    throw ProtocolError("window " + std::to_string(windows_) + ": " + link_->partner() +
                        " did not send for each body the mass that its contacts meet (damping_mass pair)");
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const BodyMotion& start = motion_.bodies[i];
    if (start.mode_count() != bodies_[i]->boundary().mode_count())
      throw ProtocolError("body \"" + names_[i] + "\" came with " + std::to_string(start.mode_count()) +
                          " modal coordinates; its boundary has " +
                          std::to_string(bodies_[i]->boundary().mode_count()));
    if (const std::string place = first_not_finite(start); !place.empty())
      throw NumericalError("the motion of body \"" + names_[i] + "\" at t = " + number(motion_.time) +
                           " s is not finite (" + place + ")");
    if (windows_ > 0) work_received_ += bodies_[i]->work_between(at_last_start_[i], start);
    bodies_[i]->begin_window(start, motion_.n, dt_, script_.requires_masses ? inverse_masses[i] : 0.0);
  }
  work_given_ += window_work_;
  window_work_ = 0.0;
  at_last_start_ = motion_.bodies;
  last_window_ = motion_.last_window;
  substeps_left_ = motion_.n;
}

bool DemLink::end_substep() {
  for (const auto& body : bodies_) body->end_substep(dt_);
  return --substeps_left_ == 0;
}

// Numbers of the rank itself, before those of bodies: grains, lost ones, asked to end.
constexpr std::size_t kOfTheRank = 3;

void DemLink::write_shares(std::int64_t grains, bool asked_to_end, std::vector<double>& row) {
  row = {static_cast<double>(grains), lost_here_, asked_to_end ? 1.0 : 0.0};
  lost_here_ = 0.0;
  for (const auto& body : bodies_) body->append_share(row);
}

// Of all ranks: how many there are, and how many LIGGGHTS has lost since the start.
void DemLink::count_grains(const std::vector<double>& rows, int ranks) {
  const std::size_t row_size = rows.size() / static_cast<std::size_t>(ranks);
  double grains = 0.0, lost = 0.0;
  for (std::size_t rank = 0; rank < static_cast<std::size_t>(ranks); ++rank) {
    grains += rows[rank * row_size];
    lost += rows[rank * row_size + 1];
  }
  load_.particles = std::llround(grains);
  if (lost <= 0.0) return;
  const bool first = load_.lost == 0;
  load_.lost += std::llround(lost);
  const double all = grains + static_cast<double>(load_.lost);
  const std::string what = "t = " + number(time()) + " s: " + std::to_string(load_.lost) + " of " + number(all) +
                           " grains have left the box, and LIGGGHTS has lost them";
  if (static_cast<double>(load_.lost) > max_lost_ * all)
    throw NumericalError(what + "; fix couple/mbd allows a share of " + number(max_lost_) +
                         ". Make the region of create_box larger, or the bed calmer, or allow more: lost SHARE");
  if (first) warn(what + " (this is said once; summary: grains_lost)");
}

void DemLink::finish_window(const std::vector<double>& rows, int ranks) {
  std::size_t row_size = kOfTheRank;
  for (const auto& body : bodies_) row_size += body->share_size();
  FOOTFALL_DEMAND(rows.size() == row_size * static_cast<std::size_t>(ranks));
  count_grains(rows, ranks);
  for (const auto& body : bodies_) body->clear_load();
  const double* next = rows.data();
  for (int rank = 0; rank < ranks; ++rank) {
    asked_to_end_ = next[2] != 0.0 || asked_to_end_;
    next += kOfTheRank;
    for (const auto& body : bodies_) next = body->add_share(next);
  }

  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const BodyLoad& load = bodies_[i]->load();
    if (const std::string place = first_not_finite(load); !place.empty())
      throw NumericalError("the load of the grains on body \"" + names_[i] + "\" after t = " + number(motion_.time) +
                           " s is not finite (" + place + ")");
    load_.bodies[i] = load;
    window_work_ += load.mean.work;
    overlap_ = std::max(overlap_, load.max_overlap_over_radius);
  }
  work_ += window_work_;
  load_.window = windows_++;
  load_.end_requested = asked_to_end_;
  const double now = wall_clock();
  load_.wall_seconds = now - sent_ - waited_;
  load_.waited_seconds = waited_;
  sent_ = now;
  link_->send(load_);
  load_.warnings.clear();
  load_.gone_walls.clear();
  if (!last_window_) return;
  finished_ = true;
  link_->close();
}

void DemLink::wall_is_gone(const std::string& name) {
  std::vector<StaticWall>& walls = script_.walls;
  walls.erase(std::remove_if(walls.begin(), walls.end(), [&](const StaticWall& wall) { return wall.name == name; }),
              walls.end());
  load_.gone_walls.push_back(name);
}

bool DemLink::is_held_by_walls(int body) const {
  const std::vector<std::string>& held = accept_.held_by_walls;
  return std::find(held.begin(), held.end(), body_name(body)) != held.end();
}

void DemLink::uncoupled_by(const std::string& command) {
  if (!started()) {
    touched_.clear();
    names_.clear();  // what comes now may couple other bodies
    return;
  }
  if (finished_ || link_->closed()) return;
  if (script_.may_end_early) {
    script_ended();
    return;
  }
  throw InputError(command + ": takes the coupling away at t = " + number(time()) +
                   " s, before the end of the scene at t = " + number(accept_.t_end) +
                   " s. If the grains shall go on alone, say so: fix ID all couple/mbd every N end script ...");
}

void DemLink::script_ended() {
  if (link_ == nullptr || link_->closed()) return;
  if (started() && script_.may_end_early) {
    finished_ = link_->fail("", Status::kOk);
    return;
  }
  std::string why;
  if (!started()) {
    why =
        "the LIGGGHTS script ended without running `fix couple/mbd`; the scene expects grains. Add the fix and a "
        "`run`, or run the scene without LIGGGHTS";
  } else {
    why = "the LIGGGHTS script ended at t = " + number(time()) +
          " s, before the end of the scene at t = " + number(accept_.t_end) + " s. `run` at least " +
          number(std::ceil(accept_.t_end / dt_ - 1e-9)) +
          " steps in all, or say that the script may end the run: fix ID all couple/mbd every N end script ...";
  }
  link_->fail(why, Status::kBadInput);
  throw InputError(why);
}

}  // namespace footfall
