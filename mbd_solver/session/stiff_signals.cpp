// What a signal s moves follows from the equations alone, for forces on bodies, joints and struts alike. With the accelerations
// b = d(dv/dt)/ds of a small change of s:
//   M b + Phi_v^T l = Q,   Phi_v b = 0     Q: generalized force of s = 1
//   1/m = b^T M b                          mass against which it acts
//   x' = Q^T v = b^T M v                   velocity in its direction
// A force -k x that is held for a period H and acts with a mean delay of c H feeds the motion like a damping ratio of
// -c omega H / 2, omega = sqrt(k/m); c = 1/2, and 3/2 where outputs answer the inputs of the sample before.

#include "mbd_solver/session/stiff_signals.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/model/control/expression_parts.h"
#include "mbd_solver/session/codes.h"

namespace footfall {
namespace {

constexpr double kMostOmegaH = 0.1;  // beyond which it is told [-]
constexpr double kNoLoad = 1e-12;    // of a signal that moves nothing now, relative

void add_names(const ExpressionPart& part, std::set<std::string>& names) {
  if (part.kind == ExpressionPart::Kind::kName) names.insert(part.name);
  for (const ExpressionPart& each : part.parts) add_names(each, names);
}

// The signal NAME, of which NAME.OUTPUT may be another output.
const SignalSpec* signal_named(const Scene& scene, std::string name) {
  for (;; name.resize(name.rfind('.'))) {
    for (const SignalSpec& spec : scene.signals)
      if (spec.name == name) return &spec;
    if (name.rfind('.') == std::string::npos) return nullptr;
  }
}

// Whether a column of the mechanism is among what it reads, also through other signals. seen: those that were asked.
bool reads_motion(const Scene& scene, const SignalSpec& spec, std::set<std::string>& seen) {
  if (!seen.insert(spec.name).second) return false;
  std::set<std::string> names;
  std::vector<std::string> texts = spec.inputs;
  texts.insert(texts.end(), {spec.input, spec.input2, spec.rate});
  for (const std::string& text : texts)
    if (const auto parts = parts_of(text)) add_names(*parts, names);
  for (const std::string& name : names) {
    const SignalSpec* const other = name.rfind("signal.", 0) == 0 ? signal_named(scene, name.substr(7)) : nullptr;
    const bool column = !other && name.find('.') != std::string::npos && name.rfind("state.", 0) != 0;
    if (column || (other && reads_motion(scene, *other, seen))) return true;
  }
  return false;
}

}  // namespace

StiffSignals::StiffSignals(const Scene& scene, const Mechanism& mechanism, const Assembly& assembly,
                           const Baumgarte& baumgarte)
    : equations_(mechanism.model, assembly, baumgarte) {
  for (const SignalSpec& spec : scene.signals) {
    std::set<std::string> seen;
    if (!spec.is_foreign() || !reads_motion(scene, spec, seen)) continue;
    std::vector<std::string> names = spec.output_signals();
    names.push_back(spec.name);
    for (const PlaceEntry& entry : mechanism.signals) {
      if (std::find(names.begin(), names.end(), entry.name) == names.end()) continue;
      Watched w;
      w.signal = entry.name;
      w.program = spec.file.substr(spec.file.rfind('/') + 1);
      w.place = entry.place;
      w.period = spec.period;
      w.late = spec.kind == SignalKind::kFmu;
      watched_.push_back(std::move(w));
    }
  }
}

void StiffSignals::observe(const State& state, const Inputs& inputs) {
  for (Watched& w : watched_) {
    if (w.told || state.time < (static_cast<double>(w.samples) - 1e-6) * w.period) continue;
    w.samples = static_cast<long>(std::floor(state.time / w.period + 1e-6)) + 1;
    try {
      observe(w, state, inputs);
    } catch (const NumericalError&) {  // of a changed value; the run itself reports its own
    }
  }
}

void StiffSignals::observe(Watched& w, const State& state, const Inputs& inputs) {
  const Layout& layout = equations_.layout();
  const double s = inputs.values(w.place), change = std::max(1.0, std::abs(s));
  rates_.resize(layout.size());
  response_.setZero(layout.size());
  momentum_.resize(layout.size());
  varied_ = inputs;
  equations_.saddle().accelerations(state, varied_, rates_);
  Eigen::VectorXd b = -rates_.segment(layout.v0(), layout.v_size);
  const double size = b.norm();
  varied_.values(w.place) = s + change;
  equations_.saddle().accelerations(state, varied_, rates_);
  b += rates_.segment(layout.v0(), layout.v_size);
  if (!(b.norm() > kNoLoad * size)) return;
  b /= change;
  response_.segment(layout.v0(), layout.v_size) = b;
  y_.setZero(layout.size());
  y_.head(layout.q_size) = state.q;
  y_.segment(layout.v0(), layout.v_size) = state.v;
  y_.segment(layout.z0(), layout.z_size) = state.z;
  equations_.apply_mass(y_, response_, state.time, momentum_);
  const auto Mb = momentum_.segment(layout.v0(), layout.v_size);
  const double inverse_mass = b.dot(Mb), velocity = Mb.dot(state.v);
  if (!(inverse_mass > 0.0)) return;

  w.last_x = w.x;
  w.last_v = w.v;
  w.x += 0.5 * w.period * (w.v + velocity);  // [m]: the trapezoidal rule
  w.v = velocity;
  const auto found = w.late ? w.fit.add(w.last_x, w.last_v, s) : w.fit.add(w.x, w.v, s);
  if (found) tell(w, state.time, *found, 1.0 / inverse_mass);
}

void StiffSignals::tell(Watched& w, double time, const SpringAndDamper& found, double mass) {
  const double omega_h = found.k > 0.0 ? w.period * std::sqrt(found.k / mass) : 0.0;
  if (omega_h < kMostOmegaH) return;
  w.told = true;
  const double ratio = (w.late ? -0.75 : -0.25) * omega_h;
  warnings_.push_back(with_code(
      code::kSignalOmegaH,
      "t = " + number_text(time) + " s: signal \"" + w.signal + "\" (" + w.program +
          ") answers the motion that it causes like a spring of " + number_text(found.k, 3) + " on " +
          number_text(mass, 3) + " (SI): omega H = " + number_text(omega_h, 2) + " with its period of H = " +
          number_text(w.period, 3) + " s. Values held for a period feed this motion like a damping ratio of " +
          number_text(ratio, 2) + "; shorten period to at most " + number_text(w.period * kMostOmegaH / omega_h, 2) +
          " s, or move the spring into the scene"));
}

}  // namespace footfall
