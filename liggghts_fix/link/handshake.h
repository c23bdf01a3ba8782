#pragma once
// The messages of both sides before the first window: Start, which describes the script,
// and Accept, which describes the run.

#include <memory>
#include <string>

#include "coupler/link.h"
#include "liggghts_fix/link/coupled_bodies.h"

namespace footfall {

class Handshake {
 public:
  explicit Handshake(Link* link) : link_(link) {}

  void set_patience(double seconds);  // longest silence of the partner [s]; replaces the value of the scene
  // Sends Start, with the coupled bodies, and receives Accept.
  void exchange(Start script, CoupledBodies& bodies);
  bool is_done() const { return scheme_ != nullptr; }
  // After exchange():
  const Start& script() const { return script_; }  // of the first run
  const Accept& accept() const { return accept_; }
  const Scheme& scheme() const { return *scheme_; }
  double gravity() const;  // its magnitude [m/s2]
  // Throws InputError when another run has another time step or gravity.
  void require_same(const Start& script) const;
  // For gravity that varies and was unknown before the start. Throws InputError unless it equals
  // the scene's gravity [m/s2].
  void require_scene_gravity(const Eigen::Vector3d& gravity) const;
  void forget_wall(const std::string& name);             // of the script: it is gone, or moves now
  bool is_held_by_walls(const std::string& body) const;  // the scene has contacts of this body with the script's walls

 private:
  Link* link_;
  bool own_patience_ = false;  // set by the script
  Start script_;
  Accept accept_;
  std::unique_ptr<Scheme> scheme_;
};

}  // namespace footfall
