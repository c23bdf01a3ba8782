#pragma once
// The checks that a rig makes of itself: the same with a bed of twice the size, with grains of half the size, at half the
// speed.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "mbd_solver/run/output/history.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

struct RigCheck {
  std::string name;
  std::vector<std::string> settings;  // of --set
};

// Of a scene with a box. Half the speed: every prescribed motion that is a polynomial of time, c_k -> c_k / 2^k, and twice
// the end time [s]; only where `slow`. Throws InputError where the bed is a script's, or a motion is something else.
std::vector<RigCheck> checks_of(const Scene& scene, bool slow);
// Of a rig whose bodies hold the bed: tray, frame and lid of a shear box, the gate before a slope. Twice the size: bodies,
// bed and path are twice as long, pressures are the same.
std::vector<RigCheck> checks_of_holding_bodies(const Scene& scene, bool slow);

// A rig: a scene that is an instrument, run on samples of a bed, and what its metrics make of the soil. The runs are an
// sweep (inputs/rigs/NAME.toml, sweeps/sweep.h); a rig adds the evaluation.

// A finished run of the sweep.
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

// The answer that a law published_values elsewhere gives, nothing fitted but what the law leaves open.
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
  // The runs of one sample of the bed, in the order of the sweep. Throws InputError when they are no runs of this
  // rig.
  RigSample (*evaluate)(const std::vector<RigRun>& runs);
  // What the evaluation needs of the scene, before anything runs. Throws InputError naming what is missing.
  void (*require)(const Scene& scene);
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

void require_plate(const Scene& scene);
void require_cone(const Scene& scene);
void require_wheel(const Scene& scene);
void require_shear(const Scene& scene);
void require_box(const Scene& scene);
void require_repose(const Scene& scene);
void require_sphere(const Scene& scene);
void require_rft(const Scene& scene);

// What evaluations of rigs have in common: histories, means over bins, least squares.

History history_of(const RigRun& run);
// A body of the scene. Throws InputError naming the rig's need when there is none.
const BodySpec& body_of(const Scene& scene, const std::string& name);
// The shape of one that is the mesh of this file of inputs/rigs/scenes: the rig knows its dimensions by its scale alone.
// Throws InputError for any other.
const ShapeSpec& mesh_of(const Scene& scene, const std::string& name, const std::string& file);
// The bed. Throws InputError when there is none of [particles.box].
const BoxSpec& box_of(const Scene& scene);
// Where the bed's mean surface lies: about a radius of the larger grains below z = 0 [m], negative.
double mean_surface(const RigRun& run);
double gravity_of(const RigRun& run);  // its size [m/s2]

// Means of x and y over `count` equal bins of x in [from, to]; empty bins are left out.
struct Bins {
  std::vector<double> x, y;
};
Bins binned(const std::vector<double>& x, const std::vector<double>& y, double from, double to, int count);

// Mean of the rows after the share `from` of the time.
double late_mean(const History& history, const std::string& column, double from);

// y = A c by least squares. `valid` is false when there are not more rows than coefficients, or A has not full rank; c is
// then NaN. R^2 is about the mean of y.
struct LineFit {
  bool valid = false;
  Eigen::VectorXd c;
  double r_squared = 0.0;
};
LineFit least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& y);

// Resistive force theory of dry granular media, with its published_values coefficients: see rft_rig.cpp.

// Stress per depth along x and z, of generic media at scalar one [N/cm^3]. Positive against a motion along +x, and
// upwards.
struct RftAlpha {
  double z = 0.0, x = 0.0;
};
// beta, gamma in [-pi/2, pi/2] [rad]: of the plate to the horizontal, of the motion below the horizontal.
RftAlpha rft_alpha(double beta, double gamma);

// The mu in (0, 2] at which 3D-RFT's xi = weight (894 mu^3 - 386 mu^2 + 89 mu) is `xi`, weight = rho g [N/m^3]; NaN: none.
double friction_of_xi(double xi, double weight);

}  // namespace footfall
