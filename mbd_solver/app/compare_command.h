#pragma once
// footfall compare: two beds of grains at the same times, and the forces on the bodies. The second bed comes from
// another run, or from stock LIGGGHTS, which replays the run's own script with its coupled meshes moved by `fix move/mesh` as
// recorded (DIR/motion).

#include <Eigen/Dense>
#include <map>
#include <string>
#include <vector>

namespace footfall {

struct Replay {
  std::string script;                        // text for `liggghts -in`
  std::map<std::string, std::string> files;  // by name: files that the script reads
  std::vector<std::string> bodies;  // replayed, in the order of the columns of forces.txt: step, fx fy fz of each
  std::vector<std::string> notes;   // parts that stock LIGGGHTS cannot do, left out
  int steps = 0, every = 1;         // of the whole run; between two changes of velocity
};

// `script`: of the coupled run. `motion`: its DIR/motion. `out`: folder of the replay. dt: DEM time step [s].
// variables: of the run's LIGGGHTS command line. Throws InputError when the script has no coupling, or none of its meshes
// was recorded.
Replay stock_replay(const std::string& script, const std::string& motion, const std::string& out, double dt,
                    std::map<std::string, std::string> variables = {});

// Forces on one body. Times are ends of windows [s].
struct ComparedBody {
  std::vector<double> time;
  std::vector<Eigen::Vector3d> force;  // mean of the grains on the body in the window that ends then [N]
};
struct ComparedRun {
  std::string label;                 // "coupled"
  std::string frames;                // folder of the dumps of grains
  std::vector<ComparedBody> bodies;  // the same, in the same order, in both runs
};

// Path of a coupled surface.
struct SurfacePath {
  std::string body;
  double radius = 0.0;  // horizontal, of the surface about its mean [m]
  std::vector<double> time;
  std::vector<Eigen::Vector3d> place;  // mean of its nodes [m]
};

struct Comparison {
  std::string beds;     // CSV: measures of both beds at every time that both dumped
  std::string forces;   // CSV: magnitude of the forces of both runs on each body
  std::string profile;  // CSV: height of the surface around the first body at the last time
  std::string table;    // for people
  // largest relative difference of the impulse on one body in the first 0.1 s of contact [-]
  double worst_impulse = 0.0;
  bool has_beds = false;          // both runs dumped their grains
  bool touches_at_start = false;  // a body, in its first window
  double first_apart = -1.0;      // when the first grain differs by a tenth of its radius [s]; below 0: none does
  double smallest_radius = 0.0;   // of the grains [m]; 0 without dumps
};

// "equal", "within scatter" or "differs", and why: one line. bend: the largest distance of a mesh from the rigid motion that was
// replayed [m]; 0 for two runs of footfall.
std::string verdict_of(const Comparison& comparison, double bend);

Comparison compare_beds(const ComparedRun& a, const ComparedRun& b, const std::vector<SurfacePath>& surfaces,
                        double dt);

// Writes DIR/compare (without `other` also the stock script and its results), prints the table, draws the plots. Returns the
// exit code; throws InputError for a folder without a coupled run. `trust_script`: the script of the run may run programs
// and write anywhere.
int compare_command(const std::string& run, const std::string& other, bool trust_script, bool quiet);

}  // namespace footfall
