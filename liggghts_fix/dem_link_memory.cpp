// What the grains' side of a coupling keeps in a checkpoint, and how it goes on from there.

#include <algorithm>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/message_fields.h"
#include "liggghts_fix/dem_link.h"

namespace footfall {

void DemLink::read_memory() {
  const std::string file = memory_file(geometry_.resume);
  const std::optional<std::string> text = read_whole_file(file);
  if (!text) throw InputError(file + ": cannot be read, but the run goes on from there");
  memory_ = Archive(file, *text);
  // Where the boundaries stand now: what meshes are held against, and beams start from.
  for (CoupledBody& body : geometry_.bodies) (*memory_)(body.boundary.name().c_str(), body.initial);
}

void DemLink::go_on_from_memory() {
  std::int64_t kept_step = 0;
  (*memory_)("step", kept_step);
  if (kept_step != script_.step) throw InputError(wrong_grains());
  visit(*memory_);
  memory_->finish();
  if (kept_standing_.size() != standing().size())
    throw InputError(memory_file(geometry_.resume) + ": standing: " + std::to_string(kept_standing_.size()) +
                     " numbers, expected " + std::to_string(standing().size()) + ": it is of another scene or damaged");
}

std::string DemLink::wrong_grains() const {
  return "couple/mbd: the run goes on from " + geometry_.resume +
         ", but the script has not read its grains: " + "`read_restart` must read " + geometry_.resume +
         "/grains.restart (scripts of footfall: -var bed FILE), without reset_timestep and without a `run` before the "
         "coupled one";
}

std::string DemLink::memory(std::int64_t step) {
  Archive archive;
  for (CoupledBody& body : geometry_.bodies) {
    const auto coupled = std::find(names_.begin(), names_.end(), body.boundary.name());
    BodyMotion pose =
        coupled == names_.end() ? body.initial : bodies_[static_cast<std::size_t>(coupled - names_.begin())]->pose();
    archive(body.boundary.name().c_str(), pose);
  }
  archive("step", step);
  visit(archive);
  return archive.text();
}

void DemLink::kept(std::int64_t step, bool done) {
  CheckpointDone kept;
  kept.window = motion_.window;
  kept.step = step;
  kept.done = done;
  motion_.checkpoint.clear();
  link_->send(kept);
}

// Between two windows.
void DemLink::visit(Archive& archive) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) archive(names_[i].c_str(), *bodies_[i]);
  archive("standing", kept_standing_);
  archive("at_last_start", at_last_start_);
  archive("windows", windows_);
  archive("lost", load_.lost);
  archive("window_work", window_work_);
  archive("work_given", work_given_);
  archive("work_received", work_received_);
  archive("work", work_);
  archive("overlap", overlap_);
}

std::vector<double> DemLink::standing() const {
  std::vector<double> row;
  for (const auto& body : bodies_) {
    const OpeningForce& force = body->standing();
    row.insert(row.end(), force.F_W.data(), force.F_W.data() + 3);
    row.insert(row.end(), force.T_B.data(), force.T_B.data() + 3);
    row.insert(row.end(), force.Q_a.data(), force.Q_a.data() + force.Q_a.size());
  }
  return row;
}

void DemLink::stand_as_kept(bool on_this_rank) {
  const double* next = kept_standing_.data();
  for (const auto& body : bodies_) {
    OpeningForce force(body->boundary().mode_count());
    if (on_this_rank) {
      force.F_W = Eigen::Map<const Eigen::Vector3d>(next);
      force.T_B = Eigen::Map<const Eigen::Vector3d>(next + 3);
      force.Q_a = Eigen::Map<const Eigen::VectorXd>(next + 6, force.Q_a.size());
    }
    next += 6 + force.Q_a.size();
    body->set_opening_force(force);
  }
  FOOTFALL_DEMAND(next == kept_standing_.data() + kept_standing_.size());
  forces_are_new_ = false;
}

}  // namespace footfall
