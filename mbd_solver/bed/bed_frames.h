#pragma once
// Beds of grains as LIGGGHTS dumped them, one file per moment: PREFIX_STEP.vtk (dump custom/vtk, ASCII) or
// PREFIX_STEP.txt (dump custom).

#include <Eigen/Dense>
#include <map>
#include <string>
#include <vector>

namespace footfall {

struct BedFrame {
  long step = 0;
  std::vector<int> id;         // rising
  Eigen::Matrix3Xd x, v;       // of the grains, in this order [m], [m/s]; v is empty when it was not dumped
  Eigen::Matrix3Xd f;          // force on each [N]; empty when it was not dumped
  std::vector<double> radius;  // [m]
  int count() const { return static_cast<int>(id.size()); }
};

// Reads one dump; it must hold id, x y z and radius. Throws InputError naming the file.
BedFrame read_bed_frame(const std::string& path);

// The dumps of grains in a folder, by step: those whose file can be read as a bed; of several prefixes the one with
// most steps.
std::map<long, std::string> find_bed_frames(const std::string& folder);

// grains_energy.txt of a run that is resumed: LIGGGHTS begins the file anew, so the rows before the checkpoint are set
// aside and joined with the new ones afterwards.

// LIGGGHTS' step number at a checkpoint. Throws InputError when its part of it is not there.
long step_of_checkpoint(const std::string& checkpoint);

// Rows up to `step` go to grains_energy.before.txt; those that an earlier resumed part has left there are joined first.
void set_rows_aside(const std::string& run, long step);
// The energy of gravity that the rows count from, as the script has left it in grains_energy_start.txt; empty when it has
// not.
std::string energy_at_start(const std::string& run);
// One file again: the rows set aside, then those of later steps.
void join_rows(const std::string& run);

}  // namespace footfall
