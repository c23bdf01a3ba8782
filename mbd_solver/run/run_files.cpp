#include "mbd_solver/run/run_files.h"

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/folder.h"
#include "mbd_solver/run/checkpoint.h"

namespace footfall {
namespace {

// True once per interval [s], at the first window end at or after each multiple of it; moves `next` on.
bool due(double time, double interval, double& next) {
  if (time < next - 1e-9 * interval) return false;
  next = (std::floor(time / interval + 1e-9) + 1.0) * interval;
  return true;
}

const std::string& made(const std::string& folder) {
  make_folder(folder);
  return folder;
}

}  // namespace

RunFiles::RunFiles(const Simulation& simulation, const std::string& folder)
    : simulation_(simulation),
      output_(simulation.scene().output),
      folder_(made(folder) + "/"),
      observation_(simulation.subject()),
      history_(folder_ + "history.csv", observation_.names(), observation_.units()),
      pictures_(folder, "bodies"),
      next_checkpoint_(output_.checkpoint_interval) {
  if (simulation.coupled()) motion_.emplace(simulation.subject(), simulation.kinematics(), folder_ + "motion");
  if (output_.vtk) drawing_.emplace(simulation.subject());
}

void RunFiles::write(const Sample& sample) {
  try {
    write_due(sample);
  } catch (const InputError& error) {
    throw FileError(error.what());
  }
}

void RunFiles::write_due(const Sample& sample) {
  const double time = sample.state.time;
  voltages_ = sample.inputs.voltages;
  if (due(time, output_.interval, next_row_) || sample.last) history_.write(observation_.row(sample));
  if (motion_) motion_->write(sample);
  if (drawing_ && due(time, output_.vtk_interval, next_picture_)) pictures_.write(time, drawing_->frame(sample));
  if (output_.checkpoint_interval > 0.0 && due(time, output_.checkpoint_interval, next_checkpoint_))
    write_checkpoint_of(sample.state);
}

void RunFiles::flush() {
  history_.flush();
  if (motion_) motion_->flush();
}

void RunFiles::write_checkpoint_of(const State& state) const {
  write_checkpoint(folder_ + "checkpoint.txt", state, simulation_.mechanism(), voltages_);
}

}  // namespace footfall
