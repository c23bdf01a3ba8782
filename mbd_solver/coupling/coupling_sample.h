#pragma once
// What the coupling tells those who watch a run: plain data, so that a watcher needs nothing else of the coupling.

#include <vector>

#include "coupler/schemes/scheme.h"

namespace footfall {

// What both programs agreed on before the first window: holds for the whole run.
struct Agreement {
  double dt = 0.0;                 // substep of the grains [s]
  int substeps = 0;                // n of every window but the last; 0: `every auto`, each window has its own
  std::vector<int> boundaries;     // indices of the coupled ones in Mechanism, in the order of Motion and Load
  const Scheme* scheme = nullptr;  // never null in a coupled run, which owns it
};

// At the end of a window.
struct CouplingSample {
  int substeps = 0;              // of the window; 0 before the first
  double estimate = 0.0;         // of its force error, when windows are chosen [-]
  double energy_residual = 0.0;  // made (< 0) or lost (> 0) by the interface since the start [J]
  std::vector<double> omega_h;   // per coupled body [-]
};

}  // namespace footfall
