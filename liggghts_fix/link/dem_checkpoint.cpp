// One Archive: poses first, which the handshake needs, then the step and the state of the coupling.

#include "liggghts_fix/link/dem_checkpoint.h"

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/message_fields.h"
#include "liggghts_fix/link/codes.h"

namespace footfall {

std::string DemCheckpoint::text(Poses poses, std::int64_t step, const Visit& visit) {
  Archive archive;
  for (auto& [name, pose] : poses) archive(name.c_str(), pose);
  archive("step", step);
  visit(archive);
  return archive.text();
}

void DemCheckpoint::open(const std::string& folder, std::vector<CoupledBody>& bodies) {
  folder_ = folder;
  const std::optional<std::string> text = read_whole_file(file(folder));
  if (!text)
    throw InputError(code::kCheckpointNotReadable, file(folder) + ": cannot be read, but the run resumes from it");
  archive_ = Archive(file(folder), *text);
  for (CoupledBody& body : bodies) (*archive_)(body.boundary.name().c_str(), body.initial);
}

void DemCheckpoint::restore(std::int64_t step, const Visit& visit) {
  std::int64_t saved_step = 0;
  (*archive_)("step", saved_step);
  if (saved_step != step) throw InputError(code::kCheckpointGrainsNotRead, grains_not_read());
  visit(*archive_);
  archive_->finish();
}

std::string DemCheckpoint::grains_not_read() const {
  return "couple/mbd: the run resumes from " + folder_ +
         ", but the script has not read its grains: `read_restart` must read " + restart_file(folder_) +
         " (scripts of footfall: -var bed FILE), without reset_timestep and without a `run` before the coupled one";
}

}  // namespace footfall
