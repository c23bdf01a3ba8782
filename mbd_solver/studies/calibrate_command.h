#pragma once
// footfall calibrate FILE: the parameters with which runs meet targets, how well the targets determine them, and trade-offs
// between targets. The folder of results holds NAME.md, report.html, way.csv, best.txt, pictures, and the runs; the same
// command resumes an interrupted calibration.

#include <string>

namespace footfall {

struct CalibrateArguments {
  std::string file;
  std::string out;        // empty: runs/calibrations/NAME
  std::string table;      // also write the page to this file; empty: no
  int jobs = 0;           // runs at once; 0: as many as the cores allow
  bool estimate = false;  // only the runs of the start, and an estimate of the time of all
  bool so_far = false;    // no runs: print the results so far
};

// Returns the exit code: 0; 3 when interrupted. Throws InputError, NumericalError.
int calibrate_command(const CalibrateArguments& arguments);

}  // namespace footfall
