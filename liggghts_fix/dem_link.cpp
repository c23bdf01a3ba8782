#include "liggghts_fix/dem_link.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "coupler/base/nearest_name.h"
#include "coupler/base/text.h"
#include "coupler/base/whole_file.h"
#include "coupler/message_fields.h"
#include "coupler/programs.h"
#include "coupler/schemes/registry.h"
#include "liggghts_fix/stay_on_core.h"

namespace footfall {
namespace {

std::string number(double value) { return number_text(value, 10); }

// The link's own file of a checkpoint.
std::string memory_file(const std::string& folder) { return folder + "/grains.txt"; }

Archive memory_in(const std::string& folder) {
  const std::string file = memory_file(folder);
  const std::optional<std::string> text = read_whole_file(file);
  if (!text) throw InputError(file + ": cannot be read, but the run goes on from there");
  return Archive(file, *text);
}

}  // namespace

void DemLink::greet(const std::string& unit_style) {
  if (greeted_) return;
  if (link_ == nullptr)
    throw InputError(
        std::string("couple/mbd: this LIGGGHTS runs without a multibody partner. Start both programs together: ") +
        kStartBoth);
  if (unit_style != kUnitStyle)
    throw InputError("couple/mbd: the script has \"units " + unit_style + "\"; footfall couples in \"units si\" only");
  Hello hello;
  hello.unit_style = unit_style;
  link_->send(hello);
  link_->receive(geometry_);
  check_partner(link_->partner(), kProtocolVersion, geometry_.footfall_version);
  greeted_ = true;
  if (geometry_.resume.empty()) return;
  // Where the boundaries stand now: what meshes are held against, and beams start from.
  memory_ = memory_in(geometry_.resume);
  for (CoupledBody& body : geometry_.bodies) (*memory_)(body.boundary.name().c_str(), body.initial);
}

std::string DemLink::wrong_grains() const {
  return "couple/mbd: the run goes on from " + geometry_.resume +
         ", but the script has not read its grains: " + "`read_restart` must read " + geometry_.resume +
         "/grains.restart (scripts of footfall: -var bed FILE), without reset_timestep and without a `run` before the "
         "coupled one";
}

void DemLink::keep(std::int64_t step, bool writes) {
  Archive archive;
  for (CoupledBody& body : geometry_.bodies) {
    const auto coupled = std::find(names_.begin(), names_.end(), body.boundary.name());
    BodyMotion pose =
        coupled == names_.end() ? body.initial : bodies_[static_cast<std::size_t>(coupled - names_.begin())]->pose();
    archive(body.boundary.name().c_str(), pose);
  }
  archive("step", step);
  visit(archive);
  if (writes) write_whole_file(memory_file(motion_.checkpoint), archive.text());
  Kept kept;
  kept.window = motion_.window;
  kept.step = step;
  motion_.checkpoint.clear();
  link_->send(kept);
}

// Between two windows.
void DemLink::visit(Archive& archive) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) archive(names_[i].c_str(), *bodies_[i]);
  archive("at_last_start", at_last_start_);
  archive("windows", windows_);
  archive("window_work", window_work_);
  archive("work_given", work_given_);
  archive("work_received", work_received_);
  archive("work", work_);
  archive("overlap", overlap_);
}

void DemLink::set_patience(double seconds) {
  own_patience_ = true;
  if (link_ != nullptr) link_->set_patience(seconds);
}

const CoupledBody& DemLink::scene_body(const std::string& name, const std::string& unit_style) {
  greet(unit_style);
  std::vector<std::string> known;
  for (const CoupledBody& body : geometry_.bodies) {
    if (body.boundary.name() == name) return body;
    known.push_back(body.boundary.name());
  }
  const std::string guess = nearest_name(name, known);
  throw InputError("couple/mbd: the scene has no body \"" + name +
                   "\" that grains may touch. Known bodies: " + (known.empty() ? "none" : joined(known)) + "." +
                   (guess.empty() ? "" : " Did you mean \"" + guess + "\"?"));
}

int DemLink::couple(const std::string& name, const std::string& unit_style) {
  scene_body(name, unit_style);
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found != names_.end()) return static_cast<int>(found - names_.begin());
  if (started())
    throw InputError("couple/mbd: body \"" + name + "\" cannot join after the first run; name it in the script before");
  names_.push_back(name);
  return static_cast<int>(names_.size()) - 1;
}

void DemLink::start(double dt, int n, std::int64_t step) {
  if (started()) {
    if (dt != dt_)
      throw InputError("couple/mbd: the time step changed from " + number(dt_) + " to " + number(dt) +
                       " s between two runs; the windows of the coupling need one time step for the whole scene");
    FOOTFALL_DEMAND(n == n_);
    return;
  }
  FOOTFALL_DEMAND(greeted_);
  dt_ = dt;
  n_ = n;
  Start start;
  start.dt = dt;
  start.n = n;
  start.step = step;
  start.bodies = names_;
  link_->send(start);
  link_->receive(accept_);
  if (accept_.patience > 0.0 && !own_patience_) link_->set_patience(accept_.patience);
  sent_ = wall_clock();
  scheme_ = make_scheme(accept_.scheme);
  for (const std::string& name : names_)
    bodies_.push_back(std::make_unique<DemBody>(scene_body(name, kUnitStyle), *scheme_));
  load_.bodies.resize(names_.size());
  if (!memory_) return;
  std::int64_t kept_step = 0;
  (*memory_)("step", kept_step);
  if (kept_step != step) throw InputError(wrong_grains());
  visit(*memory_);
  memory_->finish();
}

void DemLink::expect_set_up() {
  for (const auto& body : bodies_) body->clear_contacts();
  forces_are_new_ = true;
}

void DemLink::begin_substep(std::int64_t step) {
  if (step == step_) return;
  FOOTFALL_DEMAND(started());
  if (finished_)
    throw InputError("couple/mbd: the scene ended at t = " + number(accept_.t_end) +
                     " s, and the script wants to go on. Remove the `run` after the one that ends the scene");
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
  if (motion_.window != windows_ || motion_.bodies.size() != bodies_.size() || motion_.n < 1 ||
      (n_ > 0 && motion_.n > n_))
    throw ProtocolError("window " + std::to_string(windows_) + ": " + link_->partner() + " sent a Motion for window " +
                        std::to_string(motion_.window) + " of " + std::to_string(motion_.n) + " substeps with " +
                        std::to_string(motion_.bodies.size()) + " bodies; expected at most " + std::to_string(n_) +
                        " substeps and " + std::to_string(bodies_.size()) + " bodies");
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const BodyMotion& start = motion_.bodies[i];
    if (start.mode_count() != bodies_[i]->boundary().mode_count())
      throw ProtocolError("body \"" + names_[i] + "\" came with " + std::to_string(start.mode_count()) +
                          " modal coordinates; its boundary has " +
                          std::to_string(bodies_[i]->boundary().mode_count()));
    if (!start.all_finite())
      throw NumericalError("the motion of body \"" + names_[i] + "\" at t = " + number(motion_.time) +
                           " s is not finite");
    if (windows_ > 0) work_received_ += bodies_[i]->work_between(at_last_start_[i], start);
    bodies_[i]->begin_window(start, motion_.n, dt_);
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

void DemLink::write_shares(std::vector<double>& row) {
  row.clear();
  for (const auto& body : bodies_) body->append_share(row);
}

void DemLink::finish_window(const std::vector<double>& rows, int ranks, std::int64_t particles) {
  std::size_t row_size = 0;
  for (const auto& body : bodies_) row_size += body->share_size();
  FOOTFALL_DEMAND(rows.size() == row_size * static_cast<std::size_t>(ranks));
  for (const auto& body : bodies_) body->clear_load();
  const double* next = rows.data();
  for (int rank = 0; rank < ranks; ++rank)
    for (const auto& body : bodies_) next = body->add_share(next);

  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const BodyLoad& load = bodies_[i]->load();
    if (!load.mean.F_W.allFinite() || !load.mean.T_B.allFinite() || !load.mean.Q_a.allFinite())
      throw NumericalError("the load of the grains on body \"" + names_[i] + "\" after t = " + number(motion_.time) +
                           " s is not finite");
    load_.bodies[i] = load;
    window_work_ += load.mean.work;
    overlap_ = std::max(overlap_, load.max_overlap_over_radius);
  }
  work_ += window_work_;
  load_.window = windows_++;
  load_.particles = particles;
  const double now = wall_clock();
  load_.wall_seconds = now - sent_ - waited_;
  sent_ = now;
  link_->send(load_);
  if (!last_window_) return;
  finished_ = true;
  link_->close();
}

void DemLink::script_ended() {
  if (link_ == nullptr || link_->closed()) return;
  std::string why;
  if (!started()) {
    why =
        "the LIGGGHTS script ended without running `fix couple/mbd`; the scene expects grains. Add the fix and a "
        "`run`, or run the scene without LIGGGHTS";
  } else {
    const double t = motion_.time + dt_ * (motion_.n - substeps_left_);
    why = "the LIGGGHTS script ended at t = " + number(t) +
          " s, before the end of the scene at t = " + number(accept_.t_end) + " s. `run` at least " +
          number(std::ceil((accept_.t_end - accept_.t_start) / dt_ - 1e-9)) + " steps in all";
  }
  link_->fail(why, Status::kBadInput);
  throw InputError(why);
}

}  // namespace footfall
