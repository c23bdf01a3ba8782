#include "mbd_solver/observe/flexible_figures.h"

#include <algorithm>

#include "coupler/base/text.h"
#include "mbd_solver/model/linear_range.h"
#include "mbd_solver/model/stress_recovery.h"

namespace footfall {

template <>
inline constexpr auto kFields<FlexibleFigures> = std::tuple{
    Field{"strain_energy", &FlexibleFigures::strain_energy}, Field{"deflection", &FlexibleFigures::deflection},
    Field{"von_mises", &FlexibleFigures::von_mises}, Field{"spin", &FlexibleFigures::spin}};

FlexibleBodies::FlexibleBodies(const Subject& subject) : model_(subject.mechanism.model) {
  for (int i = 0; i < model_.body_count(); ++i)
    if (model_.body(i).mode_count() > 0) bodies_.push_back(i);
  now_.resize(bodies_.size());
  peak_.resize(bodies_.size());
  const Scene& scene = subject.scene;
  for (const int i : bodies_) {
    const ModalBody& modal = *model_.body(i).modal();
    Watch watch;
    watch.lowest = lowest_frequency(modal);
    watch.extent = extent(modal);
    const std::string& material = scene.bodies[static_cast<std::size_t>(i)].material;
    if (!material.empty()) watch.yield_stress = scene.material(material).yield_stress;
    watch_.push_back(watch);
  }
}

void FlexibleBodies::visit(Archive& archive) {
  archive("now", now_);
  archive("peak", peak_);
  for (std::size_t k = 0; k < watch_.size(); ++k) {
    archive("spins", watch_[k].spins);
    archive("bends", watch_[k].bends);
    archive("yields", watch_[k].yields);
  }
  archive("warnings", warnings_);
}

int FlexibleBodies::find(int body) const {
  const auto found = std::find(bodies_.begin(), bodies_.end(), body);
  return found == bodies_.end() ? -1 : static_cast<int>(found - bodies_.begin());
}

const Body& FlexibleBodies::body(int k) const { return model_.body(bodies_[static_cast<std::size_t>(k)]); }

void FlexibleBodies::take(const Sample& sample) {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const Body& body = model_.body(bodies_[k]);
    const BodyKinematics& at = sample.kinematics.of(bodies_[k]);
    now_[k] = {body.inertia().strain_energy(at.a), largest_deflection(*body.modal(), at.a),
               von_mises(*body.modal(), at.a), at.w.norm() / watch_[k].lowest};
    peak_[k].strain_energy = std::max(peak_[k].strain_energy, now_[k].strain_energy);
    peak_[k].deflection = std::max(peak_[k].deflection, now_[k].deflection);
    peak_[k].von_mises = std::max(peak_[k].von_mises, now_[k].von_mises);
    peak_[k].spin = std::max(peak_[k].spin, now_[k].spin);
    warn(sample.state.time, static_cast<int>(k));
  }
}

void FlexibleBodies::warn(double time, int k) {
  Watch& watch = watch_[static_cast<std::size_t>(k)];
  const FlexibleFigures& now = this->now(k);
  const auto number = [](double x) { return number_text(x, 3); };
  const std::string where = "t = " + number(time) + " s: body " + body(k).name();
  const auto tell = [&](bool& told, const std::string& what) {
    told = true;
    warnings_.push_back(where + what);
  };
  if (!watch.spins && now.spin > kSpinRange)
    tell(watch.spins, " spins at " + number(now.spin) + " of its lowest elastic frequency (" + number(watch.lowest) +
                          " rad/s): beyond " + number(kSpinRange) +
                          " linear modes, which centrifugal tension does not stiffen, err by more than 1 %; divide the "
                          "body into several");
  if (!watch.bends && now.deflection > kDeflectionRange * watch.extent)
    tell(watch.bends, " bends by " + number(now.deflection) + " m, " + number(now.deflection / watch.extent) +
                          " of its extent: beyond " + number(kDeflectionRange) +
                          " linear modes err by more than 1 %; divide the body into several");
  if (!watch.yields && watch.yield_stress > 0.0 && now.von_mises > watch.yield_stress)
    tell(watch.yields, " has a von Mises stress of " + number(1e-6 * now.von_mises) +
                           " MPa, more than the yield stress of its material, " + number(1e-6 * watch.yield_stress) +
                           " MPa: it would stay bent, which elastic modes cannot show");
}

}  // namespace footfall
