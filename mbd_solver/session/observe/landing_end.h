#pragma once
// When a landing is over, as [landing] has it: at rest, or tipped over.
//   at rest      for rest_time no body of the lander moves faster than rest_speed, its base does not turn faster than
//                rest_speed / L, and it stands on three pads or lies, touching the ground, beyond the plane of two of them;
//                L = max_i |r_i - r_base| + sqrt(J / m), J the largest principal inertia of the base. Two pads are no rest:
//                a lander that rocks over them stops at the top, too
//   tipped over  for rest_time the mass centre is beyond the plane of two pads, without the energy to come back:
//                LandingValues::fallen
// Samples between steps count; the run ends at the next output row, with grains at the end of the next coupling interval.

#include <string>
#include <vector>

#include "coupler/archive.h"
#include "mbd_solver/session/observe/landing.h"

namespace footfall {

class LandingEnd {
 public:
  // The scene has [landing]. What the subject views must outlive this.
  LandingEnd(const Subject& subject, const LandingWatch& landing);

  // Behind landing.update(sample).
  void update(const Sample& sample, const LandingWatch& landing);
  bool is_over() const { return rests_ || tipped_; }
  const char* name() const { return rests_ ? "rest" : tipped_ ? "tipped" : "end_time"; }
  std::string reason() const;  // a sentence; empty: it is not over

  void visit(Archive& archive);

 private:
  bool moves(const Sample& sample, const LandingWatch& landing) const;

  const LandingSpec& spec_;
  int base_;
  std::vector<int> bodies_;
  double length_ = 0.0;                 // L [m]
  double moved_ = 0.0, upright_ = 0.0;  // the last times at which it was not at rest, and not fallen [s]
  bool rests_ = false, tipped_ = false;
};

}  // namespace footfall
