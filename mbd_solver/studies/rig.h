#pragma once
// Rigs: scenes that are instruments, run on samples of a bed, and the evaluation of their runs. The runs are a sweep
// (inputs/rigs/NAME.toml); checks repeat them with twice the bed, half the grains, half the speed.

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "mbd_solver/scene/scene.h"
#include "mbd_solver/session/output/history.h"

namespace footfall {

struct RigVariation {
  std::string name;
  std::vector<std::string> settings;  // of --set
};

// For a scene with [particles.box]. Half the speed, only if `slow`: every prescribed motion, a polynomial of time, becomes
// c_k / 2^k, with twice the end time. Throws InputError for a bed from a script, or other motions.
std::vector<RigVariation> variations_of(const Scene& scene, bool slow);
// For a rig whose bodies contain the bed (tray, frame and lid of a shear box, the gate before a slope): with twice the bed also
// bodies and motions are twice as long, pressures are unchanged.
std::vector<RigVariation> variations_of_holding_bodies(const Scene& scene, bool slow);

// A finished run of the sweep.
struct RigRun {
  std::string name, folder;
  Scene scene;  // with all its settings
};

// A number that the rig measures, of one sample of the bed. NaN: the runs do not determine it.
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

// The range of an answer that a published law predicts.
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
  // Evaluates the runs of one sample of the bed, in the order of the sweep. Throws InputError for runs of another rig.
  RigSample (*evaluate)(const std::vector<RigRun>& runs);
  // Throws InputError, before anything runs, when the scene lacks something that the evaluation requires.
  void (*require)(const Scene& scene);
  std::vector<RigVariation> (*variations)(const Scene& scene, bool slow) = variations_of;
  bool slow = true;  // half the speed is a check
  std::vector<RigClaim> claims = {};
};

const std::vector<Rig>& all_rigs();
const Rig& rig_named(const std::string& name);  // throws InputError for an unknown name

// The evaluations; rig_evaluations.cpp has their equations.
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

// Tools of the evaluations.

History history_of(const RigRun& run);
// A body of the scene. Throws InputError when it is missing.
const BodySpec& body_of(const Scene& scene, std::string_view name);
// The shape of a body that is this mesh of inputs/rigs/scenes, whose dimensions follow from its scale. Throws InputError for
// any other.
const ShapeSpec& mesh_of(const Scene& scene, const std::string& name, const std::string& file);
// Throws InputError without [particles.box].
const BoxSpec& box_of(const Scene& scene);
// Height of the bed's mean surface [m]: about a radius of the larger grains below z = 0, negative.
double mean_surface(const RigRun& run);
double gravity_of(const RigRun& run);       // magnitude [m/s2]
double density_of_bed(const BoxSpec& box);  // bulk [kg/m3]

// Means of x and y over `count` equal bins of x in [from, to]; empty bins are left out.
struct Bins {
  std::vector<double> x, y;
};
Bins binned(const std::vector<double>& x, const std::vector<double>& y, double from, double to, int count);

// Mean of the rows after the share `from` of the time.
double late_mean(const History& history, const std::string& column, double from);

// y = A c by least squares. Not valid, with c NaN, unless there are more rows than coefficients and A has full rank. R^2 about
// the mean of y.
struct LineFit {
  bool valid = false;
  Eigen::VectorXd c;
  double r_squared = 0.0;
};
LineFit least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& y);
// The same for two coefficients, exact for two rows.
Eigen::Vector2d two_coefficients(const Eigen::MatrixXd& A, const Eigen::VectorXd& y);

// Resistive force theory with its published coefficients: stress per depth along x and z of generic media with scalar one
// [N/cm^3]. Positive against a motion along +x, and upwards.
struct RftAlpha {
  double z = 0.0, x = 0.0;
};
// beta, gamma in [-pi/2, pi/2] [rad]: of the plate to the horizontal, of the motion below the horizontal.
RftAlpha rft_alpha(double beta, double gamma);

// The mu in (0, 2] with xi = weight (894 mu^3 - 386 mu^2 + 89 mu) of 3D-RFT, weight = rho g [N/m^3]; NaN: none.
double friction_of_xi(double xi, double weight);

}  // namespace footfall
