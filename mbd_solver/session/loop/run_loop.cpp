// A window ends with its sample, the collisions that it shows, and the events that it leads to.

#include "mbd_solver/session/loop/run_loop.h"

#include <algorithm>
#include <string>

#include "coupler/base/clock.h"

namespace footfall {

void SurfaceWatch::start(const Kinematics& reference) {
  if (moving_.coupled()) {
    walls_ = moving_.coupled()->walls();
    set_walls(walls_, moving_.mechanism());
  }
  collisions_ = std::make_unique<CollisionWatch>(moving_.scene(), moving_.mechanism(), walls_, reference);
  for (const std::string& note : collisions_->notes()) moving_.assembly().notes.push_back(note);
  if (collisions_->empty()) collisions_.reset();
}

void SurfaceWatch::begin() {
  if (collisions_) collisions_->begin(moving_.sample().kinematics);
}

void SurfaceWatch::check() {
  if (moving_.coupled() && !moving_.coupled()->gone_walls().empty()) {
    const std::vector<std::string>& gone = moving_.coupled()->gone_walls();
    const auto is_gone = [&](const StaticWall& wall) {
      return std::find(gone.begin(), gone.end(), wall.name) != gone.end();
    };
    walls_.erase(std::remove_if(walls_.begin(), walls_.end(), is_gone), walls_.end());
    set_walls(walls_, moving_.mechanism());
    if (collisions_) collisions_->remove_walls(gone);
  }
  if (collisions_) collisions_->check(moving_.subject(), moving_.sample());
}

bool RunLoop::begin() {
  begun_ = wall_clock() - moving_.times().total;
  if (run_.resumed) {
    moving_.update_sample();
  } else {
    moving_.renew();
  }
  run_.surfaces.begin();
  if (!run_.resumed) {
    run_.events.apply();
    run_.inputs.sample_at_start();
  } else if (SignalLoop* const signals = run_.inputs.signals()) {
    signals->triggered(moving_.sample(), moving_.inputs().values);  // is read
  }
  return !run_.resumed;
}

void RunLoop::count_time() { moving_.times().total = wall_clock() - begun_; }

bool RunLoop::save(bool undisturbed) {
  count_time();
  return run_.checkpoints.save(undisturbed);
}

void RunLoop::finish_window() {
  moving_.count_window(1);
  moving_.update_sample();
  run_.foresight.end_window();
  run_.surfaces.check();
  run_.events.take_effect();
}

bool RunLoop::watch_step(StepView& step, double window_end) {
  if (!(step.end() < window_end)) return true;  // finish_window() follows
  step.at(step.end(), moving_.state(), moving_.rates());
  if (moving_.scene().output.reactions || !moving_.mechanism().gears.empty()) {
    Equations& equations = moving_.equations();
    equations.saddle().smallest_multipliers(moving_.state(), moving_.rates().tail(equations.layout().row_count));
  }
  moving_.update_sample();
  const bool goes_on = moving_.coupled() || !run_.events.ends_window();
  if (goes_on && run_.observe_step) run_.observe_step(moving_.sample());
  return goes_on;
}

}  // namespace footfall
