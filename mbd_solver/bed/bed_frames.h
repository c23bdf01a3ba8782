#pragma once
// Dumps of grains, one file per time: PREFIX_STEP.vtk (LIGGGHTS' dump custom/vtk, ASCII), PREFIX_STEP.txt (dump custom), or
// PREFIX_STEP.vtp (VTK XML: a run writes its dumps anew in this form); and grains_energy.txt of a resumed run.

#include <Eigen/Dense>
#include <map>
#include <string>
#include <vector>

namespace footfall {

struct BedFrame {
  long step = 0;
  std::vector<int> id;         // ascending
  std::vector<int> type;       // of the material; empty if not dumped
  Eigen::Matrix3Xd x, v;       // of the grains, in this order [m], [m/s]; v is empty if not dumped
  Eigen::Matrix3Xd f;          // force on each [N]; empty if not dumped
  std::vector<double> radius;  // [m]
  int count() const { return static_cast<int>(id.size()); }
};

// Reads one dump, with id, x y z and radius at least; it may have no grains. Throws InputError.
BedFrame read_bed_frame(const std::string& path);

// The names of a dump's columns, as read_bed_frame knows them: id, x, vx, radius ... Throws InputError.
std::vector<std::string> dumped_columns(const std::string& path);

// The dumps of grains in a folder, by step: files that read_bed_frame accepts, at least one of them with grains; of several
// prefixes the one with the most steps. Where a step has several files LIGGGHTS' own goes before a .vtp.
std::map<long, std::string> find_bed_frames(const std::string& folder);

// grains_energy.txt of a resumed run: LIGGGHTS begins the file again, so the rows before the checkpoint are moved to
// grains_energy.before.txt first, and joined with the new rows afterwards.

// LIGGGHTS' step number at a checkpoint. Throws InputError when the DEM part of the checkpoint is missing.
long step_of_checkpoint(const std::string& checkpoint);

// Moves the rows up to `step`, after joining those that an earlier resumed part has left.
void move_rows_aside(const std::string& run, long step);
// The gravity energy from which the rows count, as the script wrote it to grains_energy_start.txt; empty without the
// file.
std::string energy_at_start(const std::string& run);
// Joins both files: the rows moved aside, then the rows of later steps.
void join_rows(const std::string& run);

}  // namespace footfall
