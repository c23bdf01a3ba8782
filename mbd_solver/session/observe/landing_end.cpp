// Two clocks, each set back by what contradicts its state.

#include "mbd_solver/session/observe/landing_end.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/text.h"

namespace footfall {
namespace {

constexpr int kStands = 3;  // pads

}  // namespace

LandingEnd::LandingEnd(const Subject& subject, const LandingWatch& landing)
    : spec_(*subject.scene.landing), base_(landing.base_body()), bodies_(landing.bodies()) {
  const Model& model = subject.mechanism.model;
  const Eigen::Vector3d r_base = model.initial(base_).r;
  for (const int i : bodies_) length_ = std::max(length_, (model.initial(i).r - r_base).norm());
  const Body& base = model.body(base_);
  length_ += std::sqrt(base.rigid_inertia().selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff() / base.mass());
}

bool LandingEnd::moves(const Sample& sample, const LandingWatch& landing) const {
  bool touches = false;
  for (const int i : bodies_) {
    if (!(sample.kinematics.of(i).dr.norm() <= spec_.rest_speed)) return true;
    touches = touches || !sample.contact[i].F_W.isZero(0.0);
  }
  if (!(sample.kinematics.of(base_).w.norm() * length_ <= spec_.rest_speed)) return true;
  return landing.now().pads_touching < kStands && !(touches && landing.tipped());
}

void LandingEnd::update(const Sample& sample, const LandingWatch& landing) {
  const double time = sample.state.time;
  if (moves(sample, landing)) moved_ = std::max(moved_, time);
  if (!landing.now().fallen) upright_ = std::max(upright_, time);
  if (is_over()) return;
  rests_ = spec_.end_at_rest && time - moved_ >= spec_.rest_time;
  tipped_ = !rests_ && spec_.end_when_tipped && time - upright_ >= spec_.rest_time;
}

std::string LandingEnd::reason() const {
  const std::string time = number_text(spec_.rest_time, 3) + " s";
  if (rests_)
    return "the lander is at rest: for " + time + " nothing of it moved faster than " +
           number_text(spec_.rest_speed, 3) + " m/s";
  if (tipped_)
    return "the lander has tipped over: for " + time + " it was beyond its pads without the energy to return";
  return "";
}

void LandingEnd::visit(Archive& archive) {
  archive("moved", moved_);
  archive("upright", upright_);
  archive("rests", rests_);
  archive("fallen", tipped_);
}

}  // namespace footfall
