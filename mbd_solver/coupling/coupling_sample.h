#pragma once
// Data of the coupling for observers of a run: plain structs, independent of the rest of the coupling.

#include <vector>

#include "coupler/messages.h"
#include "coupler/schemes/scheme.h"

namespace footfall {

// Agreed between both programs before the first window: holds for the whole run.
struct Agreement {
  double dt = 0.0;                 // DEM step [s]
  int substeps = 0;                // n of every window but the last; 0: `every auto`, chosen per window
  std::vector<int> boundaries;     // indices in Mechanism of the coupled ones, in the order of Motion and Load
  const Scheme* scheme = nullptr;  // never null in a coupled run, which owns it
};

// At the end of a window.
struct CouplingSample {
  int substeps = 0;              // DEM steps of the window; 0 before the first
  double estimate = 0.0;         // of its force error, when windows are chosen [-]
  double energy_residual = 0.0;  // created (< 0) or dissipated (> 0) by the interface since the start [J]
  std::vector<double> omega_h;   // per coupled body [-]
  GrainChanges changes;          // since the start
};

}  // namespace footfall
