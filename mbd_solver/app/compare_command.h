#pragma once
// The bed of a coupled run made again by stock LIGGGHTS: the run's own script, with its coupled meshes moved by `fix
// move/mesh` as they were recorded (DIR/motion).

#include <Eigen/Dense>
#include <map>
#include <string>
#include <vector>

namespace footfall {

// One coupled mesh: position and rotation since the start, at equal times.
struct RecordedMotion {
  std::string body;
  std::vector<double> time;                // [s]
  std::vector<std::vector<double>> pose;   // x y z of the nodes' mean [m], rotation vector [rad]
  std::vector<std::vector<double>> force;  // mean force of the grains in the window before [N]
  std::vector<double> bend;                // farthest node from the rigid motion [m]
};

// Reads FOLDER/BODY.csv. Throws InputError.
RecordedMotion read_motion(const std::string& folder, const std::string& body);
// Names of all bodies recorded there; none: empty.
std::vector<std::string> recorded_bodies(const std::string& folder);

struct Replay {
  std::string script;                        // text for `liggghts -in`
  std::map<std::string, std::string> files;  // by name: what the script reads
  std::vector<std::string> bodies;  // replayed, in the order of the columns of forces.txt: step, fx fy fz of each
  std::vector<std::string> notes;   // what stock LIGGGHTS cannot do, and was left out
  int steps = 0, every = 1;         // of the whole run; between two changes of velocity
};

// `script`: the coupled run's. `motion`: its DIR/motion. `out`: folder of the replay, whose files the script names. dt:
// of the grains [s]. variables: what the run's LIGGGHTS was given on its command line.
// Throws InputError when the script has no coupling, or no mesh of it was recorded.
Replay stock_replay(const std::string& script, const std::string& motion, const std::string& out, double dt,
                    std::map<std::string, std::string> variables = {});

// Two beds of grains side by side, moment by moment, and the forces on what touched them.

// Of one run. Times are ends of windows [s].
struct ComparedBody {
  std::vector<double> time;
  std::vector<Eigen::Vector3d> force;  // mean of the grains on the body in the window that ends then [N]
};
struct ComparedRun {
  std::string label;                 // "coupled"
  std::string frames;                // folder of the dumps of grains
  std::vector<ComparedBody> bodies;  // the same, in the same order, in both runs
};

// Where a surface was, for what lies under it.
struct SurfacePath {
  std::string body;
  double radius = 0.0;  // of the surface about its mean, level [m]
  std::vector<double> time;
  std::vector<Eigen::Vector3d> place;  // mean of its nodes [m]
};

struct Comparison {
  std::string beds;     // CSV: figures of both beds at every moment that both dumped
  std::string forces;   // CSV: size of the forces of both runs on each body
  std::string profile;  // CSV: height of the surface around the first body at the last moment
  std::string table;    // for people
  // largest relative difference of the impulse on one body in the first 0.1 s of contact [-]
  double worst_impulse = 0.0;
  bool has_beds = false;  // both runs dumped their grains
};

Comparison compare_beds(const ComparedRun& a, const ComparedRun& b, const std::vector<SurfacePath>& surfaces,
                        double dt);

// footfall compare DIR [OTHER]: the bed of a run beside the one that stock LIGGGHTS makes of the same motion, or beside
// that of another run.

// Writes DIR/compare (without OTHER: the stock script, and what stock LIGGGHTS made of it), prints the table, draws the
// plots. Returns an exit code; throws InputError for a folder that holds no coupled run.
// `trust_script`: the script of the run may run programs and write anywhere.
int compare_command(const std::string& run, const std::string& other, bool trust_script, bool quiet);

}  // namespace footfall
