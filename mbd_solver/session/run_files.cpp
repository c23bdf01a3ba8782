// Rows are written at each multiple of their interval, pictures at the first window end at or after each of theirs, motion and
// momentum in every window, peaks at the end.

#include "mbd_solver/session/run_files.h"

#include <cstdlib>

#include "coupler/base/files.h"
#include "coupler/base/run_directory.h"
#include "coupler/programs.h"
#include "mbd_solver/session/observe/terrain_patch.h"

namespace footfall {
namespace {

const std::string& created(const std::string& folder) {
  make_folder(folder);
  guard_folder(folder);
  return folder;
}

double picture_interval(const Scene& scene) {
  constexpr double kPictures = 100.0;  // per run, unless the scene sets an interval
  return scene.output.vtk_interval > 0.0 ? scene.output.vtk_interval : scene.end_time / kPictures;
}

}  // namespace

RunFiles::RunFiles(const Simulation& simulation, const std::string& folder, Beginning beginning)
    : folder_(created(folder) + "/"),
      observation_(simulation.subject()),
      history_(folder_ + "history.csv", observation_.names(), observation_.units(), beginning),
      peaks_(observation_.names(), observation_.units()),
      requirements_(simulation.scene(), observation_.names()),
      pictures_(folder, "bodies"),
      row_clock_(simulation.scene().output.interval, 0.0),
      picture_clock_(picture_interval(simulation.scene()), 0.0) {
  if (simulation.coupled())
    motion_.emplace(simulation.subject(), simulation.kinematics(), folder_ + "motion", beginning);
  if (const char* const audit = std::getenv(kAuditFolder); audit != nullptr && simulation.coupled())
    audit_.emplace(simulation.subject(), audit);
  if (simulation.scene().output.vtk) drawing_.emplace(simulation.subject());
  if (drawing_ && drawing_->empty()) drawing_.reset();
  if (!drawing_ || beginning == Beginning::kResume) return;
  const Subject& subject = simulation.subject();
  if (const std::string terrain = terrain_text(subject.scene, subject.mechanism); !terrain.empty())
    write_whole_file(folder_ + kTerrainFile, terrain, "is the disk full?");
}

const std::vector<double>& RunFiles::see_row(const Sample& sample) {
  const std::vector<double>& row = observation_.row(sample);
  peaks_.see(row);
  requirements_.see(row);
  return row;
}

// With grains, stresses within windows would delay the grains; stresses at their ends are computed while the grains move.
void RunFiles::observe(const Sample& sample) {
  if (sample.coupling == nullptr || observation_.flexible().count() == 0) {
    see_row(sample);
  } else {
    observation_.watch(sample);
  }
}

void RunFiles::write_row(const Sample& sample) {
  as_file_error([&] {
    const bool due = row_clock_.take_turn(sample.state.time) || sample.last;
    const std::vector<double>& row = see_row(sample);
    if (due) history_.write(row);
  });
}

void RunFiles::write(const Sample& sample) {
  write_row(sample);
  as_file_error([&] {
    if (motion_) motion_->write(sample);
    if (audit_) audit_->write(sample);
    if (drawing_ && picture_clock_.take_turn(sample.state.time))
      pictures_.write(sample.state.time, drawing_->frame(sample));
  });
}

void RunFiles::flush() {
  history_.flush();
  peaks_.write(folder_ + "peaks.csv");
  if (motion_) motion_->flush();
}

void RunFiles::visit(Archive& archive) {
  archive("row_clock", row_clock_);
  archive("picture_clock", picture_clock_);
  archive("observation", observation_);
  archive("peaks", peaks_);
  archive("requirements", requirements_);
  long position = archive.restores() ? 0 : history_.position();
  archive("history", position);
  if (archive.restores()) history_.resume_at(position);
  if (motion_) archive("motion", *motion_);
  std::vector<double> pictures = pictures_.times();
  archive("pictures", pictures);
  if (archive.restores()) pictures_.resume_after(pictures);
}

}  // namespace footfall
