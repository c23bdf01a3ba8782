#pragma once
// What a run writes while it goes: rows of the history, surfaces that touch grains, pictures, checkpoints. Each writer
// knows when its next turn is.

#include <optional>
#include <string>

#include "mbd_solver/observe/drawing.h"
#include "mbd_solver/observe/motion_record.h"
#include "mbd_solver/observe/observation.h"
#include "mbd_solver/output/history.h"
#include "mbd_solver/output/vtk_writer.h"
#include "mbd_solver/run/simulation.h"

namespace footfall {

class RunFiles {
 public:
  // Makes the folder. The simulation must outlive this. Throws InputError when it cannot be written.
  RunFiles(const Simulation& simulation, const std::string& folder);

  void write(const Sample& sample);                    // what is due
  void flush();                                        // rows are on the disk's side
  void write_checkpoint_of(const State& state) const;  // with the voltages of the last sample
  const Observation& observation() const { return observation_; }

 private:
  const Simulation& simulation_;
  const OutputSpec& output_;
  std::string folder_;
  Observation observation_;
  HistoryWriter history_;
  std::optional<MotionRecord> motion_;  // none without grains
  std::optional<Drawing> drawing_;      // none unless the scene asks for pictures
  VtkSeries pictures_;
  Eigen::VectorXd voltages_;                                      // of the last sample
  double next_row_ = 0.0, next_picture_ = 0.0, next_checkpoint_;  // [s]
};

}  // namespace footfall
