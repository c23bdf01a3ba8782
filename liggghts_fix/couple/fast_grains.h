#pragma once
// Finds grains that are too fast for the time step of the run, before they meet a coupled body.

#include <Eigen/Dense>
#include <vector>

#include "liggghts_fix/link/dem_link.h"
#include "pointers.h"

namespace LAMMPS_NS {

// Every grain of this rank is visited once per list of neighbours: a grain that moves far makes LIGGGHTS build a new list.
class FastGrains : protected Pointers {
 public:
  FastGrains(LAMMPS* lmp_, footfall::DemLink& link) : Pointers(lmp_), link_(link) {}

  // After a DEM step of the bodies. Reports a grain that will meet a body within the window, and moves farther than
  // kLongestWay relative to it in a time step.
  void check();

 private:
  void measure();
  void find_faults();

  footfall::DemLink& link_;
  std::int64_t measured_ = -1, list_ = -1;  // steps: of the measurement, of the list of neighbours then
  double rate_ = 0.0;                       // largest speed over radius of a grain [1/s]
  double smallest_ = 0.0;                   // radius; 0: no grain here [m]
  std::vector<double> elastic_;             // of each body: largest speed of a node by its modes [m/s]
  Eigen::Matrix3Xd nodes_;
};

}  // namespace LAMMPS_NS
