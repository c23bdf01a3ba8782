// Every rank sends the same Start and receives the same Accept; the transport of the link sees to
// it.

#include "liggghts_fix/link/handshake.h"

#include <algorithm>

#include "coupler/base/errors.h"
#include "coupler/schemes/registry.h"
#include "liggghts_fix/link/codes.h"
#include "liggghts_fix/link/number.h"

namespace footfall {
namespace {

std::string vector_text(const Eigen::Vector3d& v) {
  return "(" + ten_digits(v[0]) + ", " + ten_digits(v[1]) + ", " + ten_digits(v[2]) + ")";
}

}  // namespace

void Handshake::set_patience(double seconds) {
  own_patience_ = true;
  if (link_ != nullptr) link_->set_patience(seconds);
}

void Handshake::exchange(Start script, CoupledBodies& bodies) {
  FOOTFALL_DEMAND(bodies.greeted());
  script.bodies = bodies.names();
  for (std::string& warning : bodies.untouched_warnings()) script.warnings.push_back(std::move(warning));
  bodies.close();
  script_ = std::move(script);
  link_->send(script_);
  link_->receive(accept_);
  require_finite(accept_, link_->partner());
  if (accept_.patience > 0.0 && !own_patience_) link_->set_patience(accept_.patience);
  scheme_ = make_scheme(accept_.scheme);
}

double Handshake::gravity() const { return (script_.gravity_known ? script_.gravity : accept_.gravity).norm(); }

void Handshake::require_same(const Start& script) const {
  if (script.dt != script_.dt)
    throw InputError(code::kTimeStepChanged, "couple/mbd: the time step changed from ", ten_digits(script_.dt), " to ",
                     ten_digits(script.dt),
                     " s between two runs; the coupling needs one time step for the whole scene");
  if (script.gravity_known && script_.gravity_known && script.gravity != script_.gravity)
    throw InputError(code::kGravityChanged, "couple/mbd: the gravity of the grains changed from ",
                     vector_text(script_.gravity), " to ", vector_text(script.gravity),
                     " m/s2 between two runs; the gravity of the scene is constant");
  FOOTFALL_DEMAND(script.n == script_.n);
}

void Handshake::require_scene_gravity(const Eigen::Vector3d& gravity) const {
  if (accept_.gravity_known && !is_same_gravity(gravity, accept_.gravity))
    throw InputError(code::kGravityDiffers, gravity_differs(gravity, accept_.gravity, " at the start"));
}

void Handshake::forget_wall(const std::string& name) {
  std::vector<StaticWall>& walls = script_.walls;
  walls.erase(std::remove_if(walls.begin(), walls.end(), [&](const StaticWall& wall) { return wall.name == name; }),
              walls.end());
}

bool Handshake::is_held_by_walls(const std::string& body) const {
  const std::vector<std::string>& held = accept_.held_by_walls;
  return std::find(held.begin(), held.end(), body) != held.end();
}

}  // namespace footfall
