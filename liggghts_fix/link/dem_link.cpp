// The parts begin with the first run of the script, in the order in which they read each other.

#include "liggghts_fix/link/dem_link.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/message_fields.h"
#include "liggghts_fix/link/codes.h"
#include "liggghts_fix/link/number.h"

namespace footfall {

void DemLink::start(Start script) {
  if (started()) {
    handshake_.require_same(script);
    return;
  }
  handshake_.exchange(std::move(script), coupled_);
  if (handshake_.accept().outflow) grains_.expect_outflow();
  grains_.begin();
  window_.begin(coupled_);
  if (!resumed()) return;
  checkpoint_.restore(handshake_.script().step, [this](Archive& archive) { window_.visit(archive); });
  OpeningForces& forces = window_.opening_forces();
  const std::size_t expected = forces.of_this_rank().size();
  if (forces.stored().size() != expected)
    throw InputError(code::kCheckpointDamaged, DemCheckpoint::file(checkpoint_.folder()),
                     ": opening_forces: ", forces.stored().size(), " numbers, expected ", expected,
                     ": the checkpoint is damaged, or belongs to another scene");
}

std::string DemLink::checkpoint_text(std::int64_t step) {
  const std::vector<std::string>& names = coupled_.names();
  DemCheckpoint::Poses poses;
  for (const CoupledBody& body : coupled_.of_scene()) {
    const auto place = std::find(names.begin(), names.end(), body.boundary.name());
    poses.emplace_back(body.boundary.name(), place == names.end()
                                                 ? body.initial
                                                 : window_.body(static_cast<int>(place - names.begin())).pose());
  }
  return DemCheckpoint::text(std::move(poses), step, [this](Archive& archive) { window_.visit(archive); });
}

void DemLink::uncoupled_by(const std::string& command) {
  if (!started()) {
    coupled_.clear();
    return;
  }
  if (finished() || link_->closed()) return;
  if (handshake_.script().may_end_early) {
    script_ended();
    return;
  }
  throw InputError(code::kCouplingRemoved, command, ": removes the coupling at t = ", ten_digits(window_.time()),
                   " s, before the end of the scene at t = ", ten_digits(handshake_.accept().t_end),
                   " s. If the grains shall continue alone, allow it: fix ID all couple/mbd every N end script ...");
}

void DemLink::script_ended() {
  if (link_ == nullptr || link_->closed()) return;
  if (started() && handshake_.script().may_end_early) {
    window_.end_early();
    return;
  }
  const double t_end = handshake_.accept().t_end;
  const InputError error =
      !started()
          ? InputError(code::kScriptWithoutCoupling,
                       "the LIGGGHTS script ended without running `fix couple/mbd`, but the scene has grains. "
                       "Add the fix and a `run`, or run the scene without LIGGGHTS")
          : InputError(
                code::kScriptEndedEarly, "the LIGGGHTS script ended at t = ", ten_digits(window_.time()),
                " s, before the end of the scene at t = ", ten_digits(t_end), " s. `run` at least ",
                ten_digits(std::ceil(t_end / handshake_.script().dt - 1e-9)),
                " steps in all, or allow the script to end the run: fix ID all couple/mbd every N end script ...");
  link_->fail(error.what(), Status::kBadInput);
  throw error;
}

}  // namespace footfall
