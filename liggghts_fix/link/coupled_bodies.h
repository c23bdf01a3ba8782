#pragma once
// The bodies of the scene that the script couples. The first access to a body performs the handshake with mbd_solver:
// Hello is sent, and Geometry brings the boundaries of all bodies.

#include <set>
#include <string>
#include <vector>

#include "coupler/link.h"
#include "liggghts_fix/link/dem_checkpoint.h"

namespace footfall {

class CoupledBodies {
 public:
  // link: null when this program runs alone; any use then throws InputError that says how to start both programs. The
  // checkpoint is opened in the handshake if the run resumes.
  CoupledBodies(Link* link, DemCheckpoint& checkpoint) : link_(link), checkpoint_(checkpoint) {}

  // A body of the scene. Throws InputError for an unknown name, with a suggestion.
  const CoupledBody& scene_body(const std::string& name, const std::string& unit_style);
  // Couples the body and returns its index; the same index for a body that is coupled already. Throws InputError for a
  // new one after close().
  int couple(const std::string& name, const std::string& unit_style);

  // Grains touch the surface of the body, or its beam chain of this number.
  void touch_surface(int body) { touched_[body].surface = true; }
  void touch_chain(int body, int chain) { touched_[body].chains.insert(chain); }
  // A warning for each body with surfaces or beams that no grain can touch.
  std::vector<std::string> untouched_warnings() const;

  // No further body can be coupled.
  void close() { closed_ = true; }
  // The script starts again and may couple other bodies.
  void clear();

  int count() const { return static_cast<int>(names_.size()); }
  const std::string& name(int body) const { return names_[body]; }
  const std::vector<std::string>& names() const { return names_; }
  int most_modes() const;                                            // of a coupled body; 0 before the handshake
  bool greeted() const { return greeted_; }                          // the handshake is done
  std::vector<CoupledBody>& of_scene() { return geometry_.bodies; }  // all that grains may touch

 private:
  void greet(const std::string& unit_style);

  struct Touched {
    bool surface = false;
    std::set<int> chains;
  };

  Link* link_;
  DemCheckpoint& checkpoint_;
  bool greeted_ = false, closed_ = false;
  Geometry geometry_;
  std::vector<std::string> names_;  // in the order of coupling
  std::vector<Touched> touched_;    // in the same order
};

}  // namespace footfall
