// Walls that the script has removed no longer act, neither on the mechanism nor on the watch.

#include "mbd_solver/session/loop/surface_watch.h"

#include <algorithm>
#include <string>

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

}  // namespace footfall
