// Handshake (versions, units, dt, n, names, gravity), then one Motion and one Load per window over a Link. Every
// disagreement is a ProtocolError with both values, and is sent to the partner before it is thrown.

#include "mbd_solver/coupling/dem_partner.h"

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/coupling/codes.h"

namespace footfall {

DemPartner::DemPartner(Transport& transport, std::vector<CoupledBody> bodies, const DemTerms& terms, double patience)
    : link_(transport, patience), bodies_(std::move(bodies)) {
  try {
    Hello hello;
    link_.receive_without_limit(hello);
    if (hello.protocol != kProtocolVersion)
      throw ProtocolError(code::kProtocolsDiffer, "liggghts_mbd uses protocol " + std::to_string(hello.protocol) +
                                                      " (footfall " + hello.footfall_version + "), mbd_solver uses " +
                                                      std::to_string(kProtocolVersion) + " (footfall " +
                                                      kFootfallVersion + "): build both from the same footfall");
    if (hello.unit_style != kUnitStyle)
      throw ProtocolError(code::kScriptUnits, "the LIGGGHTS script has units " + hello.unit_style +
                                                  ", footfall requires SI: write `units si`");
    Geometry geometry;
    geometry.bodies = bodies_;
    geometry.resume = terms.resume;
    link_.send(geometry);
    link_.receive_without_limit(start_);
    require_finite(start_, link_.partner());
    check(terms);
    warnings_ = start_.warnings;
    check_gravity(terms.gravity);
    for (const std::string& name : start_.bodies)
      for (std::size_t i = 0; i < bodies_.size(); ++i)
        if (bodies_[i].boundary.name() == name) coupled_.push_back(static_cast<int>(i));
    FOOTFALL_DEMAND(coupled_.size() == start_.bodies.size());
    Accept accept;
    accept.scheme = terms.scheme;
    accept.t_end = terms.t_end;
    accept.n_max = start_.n > 0 ? start_.n : terms.n_max;
    accept.patience = patience;
    accept.held_by_walls = terms.held_by_walls;
    accept.gravity = terms.gravity;
    accept.gravity_known = true;
    accept.outflow = terms.outflow;
    link_.send(accept);
  } catch (const ProtocolError& error) {
    link_.fail(error.what(), Status::kBadInput);
    throw;
  } catch (const NumericalError& error) {
    link_.fail(error.what(), Status::kFailed);
    throw;
  }
}

void DemPartner::check(const DemTerms& terms) const {
  if (!(start_.dt > 0.0) || start_.n < 0)
    throw ProtocolError(code::kCouplingInterval,
                        "fix couple/mbd: timestep " + number_text(start_.dt) + " s and every " +
                            std::to_string(start_.n) +
                            ": expected a positive time step, and `auto` or at least 1 DEM step");
  if (terms.max_dt > 0.0 && start_.dt > terms.max_dt * (1.0 + 1e-9))
    throw ProtocolError(code::kTimeStepTooLarge,
                        "the grains have a time step of " + number_text(start_.dt) + " s, the scene allows at most " +
                            number_text(terms.max_dt) +
                            " s (particles.max_time_step): larger steps falsify contact forces long before they become "
                            "unstable");
  if (terms.expected_dt > 0.0 && std::abs(start_.dt - terms.expected_dt) > 1e-9 * terms.expected_dt)
    throw ProtocolError(code::kScriptDiffers,
                        "the LIGGGHTS script has timestep " + number_text(start_.dt) +
                            " s, the scene has particles.variables.dt = " + number_text(terms.expected_dt) +
                            " s: make them equal, or remove the variable from the scene");
  if (terms.expected_n > 0 && start_.n != terms.expected_n)
    throw ProtocolError(code::kScriptDiffers,
                        "fix couple/mbd has every " + (start_.n > 0 ? std::to_string(start_.n) : "auto") +
                            ", the scene has particles.variables.every = " + std::to_string(terms.expected_n) +
                            ": make them equal, or remove the variable from the scene");
  for (const std::string& name : start_.bodies) {
    bool known = false;
    for (const CoupledBody& body : bodies_) known = known || body.boundary.name() == name;
    if (!known) {
      std::string names;
      for (const CoupledBody& body : bodies_) names += (names.empty() ? "" : ", ") + body.boundary.name();
      throw ProtocolError(code::kBodyWithoutBoundary,
                          "fix couple/mbd names body \"" + name +
                              "\", which has no boundary in the scene. Bodies with a boundary: " + names);
    }
  }
}

void DemPartner::check_gravity(const Eigen::Vector3d& scene) {
  if (!start_.gravity_known || is_same_gravity(start_.gravity, scene)) return;
  const std::string what = gravity_differs(start_.gravity, scene, "");
  if (!start_.gravity.isZero(0.0)) throw ProtocolError(code::kGravityDiffers, what);
  warnings_.push_back(with_code(code::kGrainsWithoutGravity, what));
}

const Load& DemPartner::exchange(const Motion& motion, const std::function<void()>& meanwhile) {
  link_.send(motion);
  if (meanwhile) {
    link_.wake_partner();
    meanwhile();
  }
  try {
    link_.receive(load_);
  } catch (const PartnerError&) {
    if (!start_.may_end_early || !link_.closed() || link_.partner_status() != Status::kOk) throw;
    script_has_ended_ = true;
    return load_;
  }
  if (load_.window != motion.window || load_.bodies.size() != motion.bodies.size())
    throw ProtocolError(code::kWrongInterval, "load of window " + std::to_string(load_.window) + " with " +
                                                  std::to_string(load_.bodies.size()) + " bodies, expected window " +
                                                  std::to_string(motion.window) + " with " +
                                                  std::to_string(motion.bodies.size()));
  return load_;
}

bool DemPartner::wait_for_checkpoint(std::int64_t window) {
  CheckpointDone checkpoint;
  link_.receive(checkpoint);
  if (checkpoint.window != window)
    throw ProtocolError(code::kWrongInterval, "checkpoint after window " + std::to_string(checkpoint.window) +
                                                  ", expected one after window " + std::to_string(window));
  return checkpoint.done;
}

}  // namespace footfall
