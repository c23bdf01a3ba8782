#pragma once
// Initial state, controllers, signals, states and events, solver, coupling and output of a scene.

#include <Eigen/Dense>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "coupler/schemes/registry.h"
#include "mbd_solver/base/kinds.h"
#include "mbd_solver/model/control/controllers.h"
#include "mbd_solver/model/control/fuzzy_controller.h"
#include "mbd_solver/model/control/signal_blocks.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/joint_spec.h"

namespace footfall {

// Velocity of one body that differs from the mechanism's. The first projection of the solver reports a velocity that
// contradicts the joints.
struct BodyVelocitySpec {
  Source source;
  std::string body;
  std::optional<Eigen::Vector3d> velocity;          // of the mass centre, in W [m/s]
  std::optional<Eigen::Vector3d> angular_velocity;  // in W [rad/s]
};

// The initial coordinate of a joint, instead of zero.
struct InitialJointSpec {
  Source source;
  std::string name;                                                    // of the joint
  std::optional<double> angle;                                         // [rad]
  std::optional<double> displacement, displacement_x, displacement_y;  // [m]
  const std::optional<double>& value(Coordinate coordinate) const;
};

// Which bodies [initial] places and moves; the others are in W as they are drawn, at rest: rocks, ramps.
struct InitialGroupsSpec {
  std::vector<std::string> moving, still;  // one of the two; the other bodies are in the other group
};

// Places the frame D in W: turned about the total mass centre by R_WD = Rz(yaw) Ry(pitch) Rx(roll), moved by
// position, then up or down to the clearance. Points fixed to the ground by joints, struts or springs are given in D and
// placed with it.
struct InitialSpec {
  Source source;
  std::string from;  // folder of a run, from whose end this one starts; empty: from the reference configuration
  Eigen::Vector3d position = Eigen::Vector3d::Zero();          // [m]
  double roll = 0.0, pitch = 0.0, yaw = 0.0;                   // [rad]
  std::optional<double> clearance;                             // lowest boundary point above plane or highest grain [m]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          // of the total mass centre [m/s]
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  // about it [rad/s]
  std::vector<BodyVelocitySpec> bodies;
  std::vector<InitialJointSpec> joints;
  std::optional<InitialGroupsSpec> groups;  // none: all bodies move
  bool settle = false;                      // the run starts from the equilibrium under its loads; not with grains
  double largest_gap = 1e-6;                // between the points of a joint, closed before the start [m]
};

enum class ControllerKind { kConstant, kFuzzy, kSkyhook, kPid };
constexpr std::string_view name_of(ControllerKind kind) { return name_in(kind, "constant", "fuzzy", "skyhook", "pid"); }

struct ControllerSpec {
  Source source;
  std::string name;
  ControllerKind kind = ControllerKind::kConstant;
  std::string body;                          // whose motion is measured
  double period = kDefaultControllerPeriod;  // [s] > 0
  std::vector<std::string> outputs;          // names "U1" ...: a strut's mr.controller is "NAME.U1"
  // The outputs stay 0 until the upward acceleration first exceeds this [m/s2]; 0: no waiting; not for constant
  double touchdown_acceleration = 0.0;
  double touchdown_delay = 0.0;                       // and until so long after it, when the filter has settled [s]
  double filter_frequency = kDefaultFilterFrequency;  // fuzzy, pid: low-pass of the acceleration, 0 = none [Hz]
  std::vector<double> voltages = {0.0};               // constant: one per output, or one for all [-] in [0, 1]
  std::string file;                                   // fuzzy: .fll
  bool tabulated = false;                             // fuzzy: computed once on a grid, then interpolated
  std::vector<int> grid = {kDefaultFuzzyGrid.begin(), kDefaultFuzzyGrid.end()};  // points along a, da, alpha, beta [-]
  SkyhookControllerParameters skyhook;  // with the outputs and the period above
  PidControllerParameters pid;          // with outputs, period and filter frequency above
};

enum class IntegratorKind { kOneStep, kIda };
constexpr std::string_view name_of(IntegratorKind kind) { return name_in(kind, "one_step", "ida"); }

enum class OneStepMethod { kAuto, kTrBdf2, kEsdirk3, kEsdirk5 };
constexpr std::string_view name_of(OneStepMethod kind) {
  return name_in(kind, "auto", "tr_bdf2", "esdirk3", "esdirk5");
}

enum class DriftKind { kProjection, kBaumgarte };
constexpr std::string_view name_of(DriftKind kind) { return name_in(kind, "projection", "baumgarte"); }

struct SolverSpec {
  Source source;
  IntegratorKind integrator = IntegratorKind::kOneStep;
  // Of one_step; auto: tr_bdf2 and esdirk3 with grains, esdirk3 and esdirk5 without.
  OneStepMethod method = OneStepMethod::kAuto;
  double rtol = 1e-6;          // [-]
  std::optional<double> atol;  // of positions [m, rad]; not given: a hundredth of rtol
  double max_step = 1e-3;      // [s]; a step never exceeds the coupling interval
  bool error_control = true;   // one_step: false takes steps of max_step without error control
  DriftKind drift = DriftKind::kProjection;
  double baumgarte_velocity = 100.0;  // alpha: ddPhi + 2 alpha dPhi + beta^2 Phi = 0 [1/s]
  double baumgarte_position = 100.0;  // beta [1/s]

  // Absolute tolerances.
  double atol_position() const { return atol.value_or(0.01 * rtol); }  // [m], [rad]
  double atol_velocity() const { return 100.0 * atol_position(); }     // [m/s], [rad/s]
};

struct CouplingSpec {
  Source source;
  std::string scheme{kDefaultScheme};  // one of scheme_names()
  // `every auto` in the script: the DEM steps of a coupling interval ("window") are chosen in [1, max_substeps] so that the
  // error of the force on a body at its end is `tolerance` times the force scale.
  double tolerance = 0.01;           // [-]
  int max_substeps = 100;            // [-]
  double warn_omega_h = 0.5;         // warn above this coupling frequency number omega H [-]
  bool stop_on_energy_gain = true;   // end the run when the coupling adds spurious energy ...
  double max_energy_residual = 0.1;  // ... of more than this share of the energy exchanged by contacts [-]
  bool stop_on_chatter = true;       // end the run when the mean force alternates from window to window
  double timeout = 300.0;            // without a message of the partner [s]
};

struct OutputSpec {
  Source source;
  double interval = 1e-3;            // between rows of history.csv [s]
  std::vector<std::string> bodies;   // whose motion is recorded; empty: all
  bool joints = true;                // coordinates of joints and their rates are recorded
  bool reactions = false;            // forces and moments of joints are recorded
  bool modal_forces = false;         // mean loads of grains on the modes of flexible bodies are recorded
  bool attitudes = true;             // angular velocities and quaternions of bodies are recorded
  bool vtk = true;                   // deformed geometry, one file per frame
  double vtk_interval = 0.0;         // [s]; 0: a hundredth of the scene's time
  bool plots = true;                 // gnuplot pictures at the end of `footfall run`
  double checkpoint_interval = 0.0;  // [s]; 0: only when interrupted
  bool keep_grains = false;          // of the end of the run, for a later run that starts from it
};

// A point whose clearance is told, and that may be a pad.
struct LandingPointSpec {
  Source source;
  std::string name;
  std::string body;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  // in D [m]
};

// What is told of a landing: stability, slid distance, clearances (session/observe/landing.h).
struct LandingSpec {
  Source source;
  std::string base;               // whose tilt is told; empty: the heaviest body
  std::vector<std::string> pads;  // bodies with a boundary, or points; empty: all such bodies joined to the base
  std::optional<Eigen::Vector3d>
      axis;  // of the base, upwards, in D; not given: the coordinate axis nearest to the vertical
  std::vector<LandingPointSpec> points;
  // The run ends before end_time (session/observe/landing.h).
  bool end_at_rest = false, end_when_tipped = false;
  double rest_speed = 0.02;  // [m/s] > 0
  double rest_time = 0.3;    // [s] > 0
};

// How a requirement gets one number from an expression that has a value at each instant.
enum class Reduce { kMax, kMin, kLargest, kFinal };
constexpr std::string_view name_of(Reduce kind) { return name_in(kind, "max", "min", "largest", "final"); }

// A bound that the results of a run must keep (session/observe/requirements.h).
struct RequirementSpec {
  Source source;
  std::string name;
  std::string value;                  // expression of keys of summary.json and columns of history.csv
  std::optional<Reduce> reduce;       // over all instants; not given: columns are read as COLUMN.max, COLUMN.final ...
  std::string unit;                   // of the value: a label, nothing is converted
  std::optional<double> least, most;  // [unit]; at least one
};

// Signals, states and events of a scene: what is measured and computed during a run.
enum class SignalKind {
  kExpression,  // the input itself
  kPid,
  kLowpass,   // first order
  kLowpass2,  // second order
  kNotch,
  kRateLimit,
  kSaturation,
  kTable,   // over one input
  kTable2,  // over two
  kFuzzy,   // rules of a FuzzyLite file, over any inputs
  kFmu,     // computed by an FMU
  kPython,  // computed by a function of a Python file, once per period
  kHost     // set by the program that leads the run (mbd_solver/session/session.h), constant between its steps
};
constexpr std::string_view name_of(SignalKind kind) {
  return name_in(kind, "expression", "pid", "lowpass", "lowpass2", "notch", "rate_limit", "saturation", "table",
                 "table2", "fuzzy", "fmu", "python", "host");
}

// Inherited: period [s] of every kind (0: continuous); min, max of pid and saturation; the rest of pid, whose error e is the
// input. Units are those that an expression reads; none is converted.
struct SignalSpec : PidBlockParameters {
  Source source;
  std::string name;
  SignalKind kind = SignalKind::kExpression;
  std::string input;                // expression of history columns, "signal.NAME", "state.NAME", "time"
  std::vector<std::string> states;  // outside of these it is 0, and it restarts when one begins; empty: always active
  // filters, rate limit: input before the start; not given: at the start. host: value until it is set; not given: 0
  std::optional<double> initial;
  std::string rate;                     // pid: expression for e'; not given: e is filtered and differentiated
  double frequency = 0.0;               // of a filter [Hz] > 0
  double damping = 0.7;                 // of a filter of second order [-] > 0
  double max_rate = 0.0;                // [unit/s] > 0
  std::vector<Eigen::Vector2d> points;  // table: (input, value), inputs rising
  std::string input2;                   // table2: the second input
  std::vector<double> x, x2;            // table2: where the inputs have values, rising
  std::vector<double> values;           // table2: for x[0] at all x2, then for x[1] ...
  std::string file;                     // fuzzy: .fll; fmu: .fmu; python: .py
  std::vector<std::string>
      inputs;  // fuzzy: expressions, in the order of the file's input variables; fmu: as input_names
  std::vector<std::string> input_names;      // fmu: the variables that the inputs set
  std::string output;                        // fuzzy: which output variable; not given: the only one
  std::vector<std::string> outputs;          // fmu: the variables that are read
  std::vector<std::string> output_names;     // fmu: their names as signals; empty: made of the variables
  std::map<std::string, std::string> start;  // fmu: values of parameters and start values, by variable
  double time_limit = 30.0;                  // fmu, python: for a step, by the wall clock [s]
  std::string function;                      // python: its name in the file
  bool stateless = false;                    // python: it keeps nothing between calls

  // Another program computes it: the outputs of an FMU are the signals NAME.OUTPUT, and the first is NAME as well.
  bool is_foreign() const { return kind == SignalKind::kFmu || kind == SignalKind::kPython; }
  std::vector<std::string> output_signals() const;
};

// The scene is in one of its states at any time, in the first of them at the start.
struct StateSpec {
  Source source;
  std::string name;
};

// The scene changes to another state when a condition holds.
struct EventSpec {
  Source source;
  std::string name;
  std::vector<std::string> from;  // states in which the condition is watched; empty: all but `to`
  std::string when;               // logical expression
  std::string to;
  double period = 0.0;  // the condition is evaluated at its multiples [s]; 0: continuously, and its instant is located
};

}  // namespace footfall
