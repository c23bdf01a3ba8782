#pragma once
// What a run writes while it goes: rows of the history, surfaces that touch grains, pictures. Each writer knows when its
// next turn is.

#include <optional>
#include <string>

#include "coupler/base/errors.h"
#include "mbd_solver/run/observe/drawing.h"
#include "mbd_solver/run/observe/observation.h"
#include "mbd_solver/run/observe/records.h"
#include "mbd_solver/run/output/history.h"
#include "mbd_solver/run/output/vtk_writer.h"
#include "mbd_solver/run/simulation.h"

namespace footfall {

class RunFiles {
 public:
  // Makes the folder. The simulation must outlive this. kResume: the files stand there, and visit() says where they go
  // on. Throws InputError when it cannot be written.
  RunFiles(const Simulation& simulation, const std::string& folder, Beginning beginning);

  void write(const Sample& sample);  // what is due; throws FileError, NumericalError
  void flush();                      // rows are on the disk's side
  void visit(Archive& archive);
  const Observation& observation() const { return observation_; }

 private:
  void write_due(const Sample& sample);

  std::string folder_;
  Observation observation_;
  HistoryWriter history_;
  std::optional<MotionRecord> motion_;   // none without grains
  std::optional<MomentumRecord> audit_;  // none unless the environment asks for it (coupler/programs.h)
  std::optional<Drawing> drawing_;       // none without output.vtk, or without anything to draw
  VtkSeries pictures_;
  IntervalClock rows_, picture_turns_;
};

}  // namespace footfall
