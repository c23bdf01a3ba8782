// The handshake, and the list of coupled bodies that Start will send.

#include "liggghts_fix/link/coupled_bodies.h"

#include <algorithm>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "coupler/programs.h"
#include "liggghts_fix/link/codes.h"

namespace footfall {

void CoupledBodies::greet(const std::string& unit_style) {
  if (greeted_) return;
  if (link_ == nullptr)
    throw InputError(
        code::kNoPartner,
        std::string("couple/mbd: LIGGGHTS runs without mbd_solver. Start both programs together: ") + kStartBoth);
  if (unit_style != kUnitStyle)
    throw InputError(
        code::kUnitsNotSi, "couple/mbd: the script has \"units ", unit_style,
        "\", but footfall couples in \"units si\" only: write the script in metres, kilograms and seconds");
  Hello hello;
  hello.unit_style = unit_style;
  link_->send(hello);
  link_->receive(geometry_);
  check_partner(link_->partner(), kProtocolVersion, geometry_.footfall_version);
  require_finite(geometry_, link_->partner());
  greeted_ = true;
  if (!geometry_.resume.empty()) checkpoint_.open(geometry_.resume, geometry_.bodies);
}

const CoupledBody& CoupledBodies::scene_body(const std::string& name, const std::string& unit_style) {
  greet(unit_style);
  std::vector<std::string> known;
  for (const CoupledBody& body : geometry_.bodies) {
    if (body.boundary.name() == name) return body;
    known.push_back(body.boundary.name());
  }
  const std::string nearest = nearest_name(name, known);
  throw InputError(code::kBodyNotInScene, "couple/mbd: the scene has no body \"", name,
                   "\" that grains may touch. Known bodies: ", known.empty() ? "none" : joined(known), ".",
                   nearest.empty() ? "" : " Did you mean \"" + nearest + "\"?");
}

int CoupledBodies::couple(const std::string& name, const std::string& unit_style) {
  scene_body(name, unit_style);
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found != names_.end()) return static_cast<int>(found - names_.begin());
  if (closed_)
    throw InputError(code::kBodyCoupledLate, "couple/mbd: body \"", name,
                     "\" cannot be coupled after the first run; couple it before");
  names_.push_back(name);
  touched_.emplace_back();
  return static_cast<int>(names_.size()) - 1;
}

void CoupledBodies::clear() {
  touched_.clear();
  names_.clear();
}

std::vector<std::string> CoupledBodies::untouched_warnings() const {
  std::vector<std::string> warnings;
  for (const CoupledBody& body : geometry_.bodies) {
    const ModalBoundary& boundary = body.boundary;
    const auto name = std::find(names_.begin(), names_.end(), boundary.name());
    const Touched touched = name == names_.end() ? Touched{} : touched_[name - names_.begin()];
    std::vector<std::string> missed;
    if (!boundary.triangles().empty() && !touched.surface) missed.emplace_back("its surface (by a mesh)");
    std::set<int> chains;
    for (const BeamSegment& segment : boundary.segments())
      if (touched.chains.count(segment.chain) == 0) chains.insert(segment.chain);
    for (const int chain : chains) missed.push_back(concat("its beam ", chain, " (by fix wall/gran/beam)"));
    if (missed.empty()) continue;
    warnings.push_back(with_code(code::kBoundaryNotCoupled, "body \"", boundary.name(),
                                 "\" has a boundary for grains in the scene, but the script does not couple ",
                                 joined(missed), ": grains pass through it"));
  }
  return warnings;
}

int CoupledBodies::most_modes() const {
  int most = 0;
  for (const CoupledBody& body : geometry_.bodies)
    if (std::find(names_.begin(), names_.end(), body.boundary.name()) != names_.end())
      most = std::max(most, body.boundary.mode_count());
  return most;
}

}  // namespace footfall
