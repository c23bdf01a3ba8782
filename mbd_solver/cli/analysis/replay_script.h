#pragma once
// The bed of a coupled run made again by stock LIGGGHTS: the run's own script, with its coupled meshes moved by `fix
// move/mesh` as they were recorded (DIR/motion).

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

}  // namespace footfall
