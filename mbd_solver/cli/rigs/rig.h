#pragma once
// A rig: a scene that is an instrument, run on samples of a bed, and what its figures make of the soil. The runs are an
// experiment (inputs/rigs/NAME.toml, experiments/experiment.h); a rig adds the evaluation.

#include <string>
#include <vector>

#include "mbd_solver/cli/rigs/rig_checks.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// A finished run of the experiment.
struct RigRun {
  std::string name, folder;
  Scene scene;  // with all its settings
};

// A number that the rig is for, of one sample of the bed. NaN: the runs do not give it.
struct RigAnswer {
  std::string name, unit;
  double value = 0.0;
};

// A line of the picture, of one run.
struct RigCurve {
  std::string name;
  std::vector<double> x, y;
};

struct RigSample {
  std::vector<RigAnswer> answers;
  std::vector<RigCurve> curves;
};

// The answer that a law printed elsewhere gives, nothing fitted but what the law leaves open.
struct RigClaim {
  std::string text, answer;  // the answer's name
  double least = 0.0, most = 0.0;
  std::string source;
};

struct Rig {
  const char* name;
  const char* what;     // for --help
  const char* x_label;  // of the picture
  const char* y_label;
  // The runs of one sample of the bed, in the order of the experiment. Throws InputError when they are no runs of this
  // rig.
  RigSample (*evaluate)(const std::vector<RigRun>& runs);
  // What the evaluation needs of the scene, before anything runs. Throws InputError naming what is missing.
  void (*demand)(const Scene& scene);
  bool slow = true;  // its speed is no subject: half of it is a check
  std::vector<RigClaim> claims;
  std::vector<RigCheck> (*checks)(const Scene& scene, bool slow) = checks_of;
};

// All of them; throws InputError for a name that none has.
const std::vector<Rig>& all_rigs();
const Rig& rig_named(const std::string& name);

// The evaluations; each source says the equations.
RigSample evaluate_plate(const std::vector<RigRun>& runs);
RigSample evaluate_cone(const std::vector<RigRun>& runs);
RigSample evaluate_wheel(const std::vector<RigRun>& runs);
RigSample evaluate_shear(const std::vector<RigRun>& runs);
RigSample evaluate_box(const std::vector<RigRun>& runs);
RigSample evaluate_repose(const std::vector<RigRun>& runs);
RigSample evaluate_sphere(const std::vector<RigRun>& runs);
RigSample evaluate_rft(const std::vector<RigRun>& runs);

void demand_plate(const Scene& scene);
void demand_cone(const Scene& scene);
void demand_wheel(const Scene& scene);
void demand_shear(const Scene& scene);
void demand_box(const Scene& scene);
void demand_repose(const Scene& scene);
void demand_sphere(const Scene& scene);
void demand_rft(const Scene& scene);

}  // namespace footfall
