// How the grains' side of a coupling begins: which bodies the script couples, what both programs tell each other of the
// scene, and what may not change between two runs.

#include <algorithm>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "coupler/messages.h"
#include "coupler/programs.h"
#include "coupler/schemes/registry.h"
#include "liggghts_fix/dem_link.h"

namespace footfall {
namespace {

constexpr int kStartDigits = 10;

std::string vector_text(const Eigen::Vector3d& v) {
  return "(" + number_text(v[0], kStartDigits) + ", " + number_text(v[1], kStartDigits) + ", " +
         number_text(v[2], kStartDigits) + ")";
}

}  // namespace

void DemLink::greet(const std::string& unit_style) {
  if (greeted_) return;
  if (link_ == nullptr)
    throw InputError(
        std::string("couple/mbd: this LIGGGHTS runs without a multibody partner. Start both programs together: ") +
        kStartBoth);
  if (unit_style != kUnitStyle)
    throw InputError("couple/mbd: the script has \"units " + unit_style +
                     "\"; footfall couples in \"units si\" only: write it in metres, kilograms and seconds");
  Hello hello;
  hello.unit_style = unit_style;
  link_->send(hello);
  link_->receive(geometry_);
  check_partner(link_->partner(), kProtocolVersion, geometry_.footfall_version);
  require_finite(geometry_, link_->partner());
  greeted_ = true;
  if (!geometry_.resume.empty()) read_memory();
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
  touched_.emplace_back();
  return static_cast<int>(names_.size()) - 1;
}

// What the scene has for grains to touch, and the script does not use.
void DemLink::tell_untouched(std::vector<std::string>& warnings) const {
  for (const CoupledBody& body : geometry_.bodies) {
    const ModalBoundary& boundary = body.boundary;
    const auto name = std::find(names_.begin(), names_.end(), boundary.name());
    const Touched touched =
        name == names_.end() ? Touched{} : touched_[static_cast<std::size_t>(name - names_.begin())];
    std::vector<std::string> missed;
    if (!boundary.triangles().empty() && !touched.surface) missed.emplace_back("its surface (by a mesh)");
    std::set<int> chains;
    for (const BeamSegment& segment : boundary.segments())
      if (touched.chains.count(segment.chain) == 0) chains.insert(segment.chain);
    for (const int chain : chains) missed.push_back("beam " + std::to_string(chain) + " of it (by fix wall/gran/beam)");
    if (missed.empty()) continue;
    warnings.push_back("the scene has a boundary of body \"" + boundary.name() +
                       "\" for the grains, but the script does not couple " + joined(missed) + ": grains pass through");
  }
}

void DemLink::hold_against_scene(const Eigen::Vector3d& gravity) const {
  if (accept_.gravity_known && !is_same_gravity(gravity, accept_.gravity))
    throw InputError(gravity_differs(gravity, accept_.gravity, " at the start"));
}

void DemLink::start(Start script) {
  if (started()) {
    if (script.dt != dt_)
      throw InputError("couple/mbd: the time step changed from " + number_text(dt_, kStartDigits) + " to " +
                       number_text(script.dt, kStartDigits) +
                       " s between two runs; the windows of the coupling need one time step for the whole scene");
    if (script.gravity_known && script_.gravity_known && script.gravity != script_.gravity)
      throw InputError("couple/mbd: the gravity of the grains changed from " + vector_text(script_.gravity) + " to " +
                       vector_text(script.gravity) + " m/s2 between two runs, and that of the scene does not");
    FOOTFALL_DEMAND(script.n == n_);
    return;
  }
  FOOTFALL_DEMAND(greeted_);
  dt_ = script.dt;
  n_ = script.n;
  script.bodies = names_;
  tell_untouched(script.warnings);
  script_ = std::move(script);
  link_->send(script_);
  link_->receive(accept_);
  require_finite(accept_, link_->partner());
  if (accept_.patience > 0.0 && !own_patience_) link_->set_patience(accept_.patience);
  sent_ = wall_clock();
  lost_here_ = 0.0;
  scheme_ = make_scheme(accept_.scheme);
  for (const std::string& name : names_)
    bodies_.push_back(std::make_unique<DemBody>(scene_body(name, kUnitStyle), *scheme_));
  load_.bodies.resize(names_.size());
  if (memory_) go_on_from_memory();
}

}  // namespace footfall
