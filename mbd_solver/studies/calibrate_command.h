#pragma once
// footfall calibrate FILE: the parameters with which runs meet targets (calibration.h), how well the targets determine
// them, and which targets pull against each other. Its folder holds NAME.md, report.html, way.csv, best.txt, pictures,
// and the runs; the same command goes on where it was stopped. What is known so far can be asked for at any time.

#include <string>

namespace footfall {

struct CalibrateArguments {
  std::string file;
  std::string out;        // empty: runs/calibrations/NAME
  std::string table;      // also write the page to this file; empty: no
  int jobs = 0;           // runs at once; 0: as many as fit the cores
  bool estimate = false;  // run the start, tell the time that all will take, and stop
  bool so_far = false;    // run nothing: print the page of what is known by now
};

// Returns the exit code: 0; 3 when interrupted. Throws InputError, NumericalError.
int calibrate_command(const CalibrateArguments& arguments);

}  // namespace footfall
