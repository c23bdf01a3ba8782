#pragma once
// Files that a run writes while it runs: history, motion of coupled surfaces, pictures.

#include <optional>
#include <string>

#include "coupler/base/errors.h"
#include "mbd_solver/session/observe/drawing.h"
#include "mbd_solver/session/observe/observation.h"
#include "mbd_solver/session/observe/records.h"
#include "mbd_solver/session/observe/requirements.h"
#include "mbd_solver/session/output/history.h"
#include "mbd_solver/session/output/peaks.h"
#include "mbd_solver/session/output/vtk_writer.h"
#include "mbd_solver/session/simulation.h"

namespace footfall {

// A file that cannot be written during a run is not a mistake of the scene.
template <class Write>
auto as_file_error(const Write& write) {
  try {
    return write();
  } catch (const InputError& error) {
    throw FileError(error.what());
  }
}

class RunFiles {
 public:
  // Creates the folder. The simulation must outlive this. kResume: the files exist, and visit() restores where they
  // continue. Throws InputError when it cannot be written.
  RunFiles(const Simulation& simulation, const std::string& folder, Beginning beginning);

  void write(const Sample& sample);      // what is due at the end of a window; throws FileError, NumericalError
  void write_row(const Sample& sample);  // of the history, if it is due, within a window; throws likewise
  void observe(const Sample& sample);    // between rows
  void flush();                          // writes the peaks so far; throws InputError when a file is not complete
  void visit(Archive& archive);
  const Observation& observation() const { return observation_; }
  const Requirements& requirements() const { return requirements_; }

 private:
  const std::vector<double>& see_row(const Sample& sample);  // for peaks and requirements

  std::string folder_;
  Observation observation_;
  HistoryWriter history_;
  Peaks peaks_;
  Requirements requirements_;
  std::optional<MotionRecord> motion_;   // none without grains
  std::optional<MomentumRecord> audit_;  // only if the environment requires it (coupler/programs.h)
  std::optional<Drawing> drawing_;       // none without output.vtk, or without bodies
  VtkSeries pictures_;
  IntervalClock row_clock_, picture_clock_;
};

}  // namespace footfall
