#pragma once
// Advances a State through one window under constant loads and inputs.

#include <functional>
#include <limits>
#include <memory>
#include <string>

#include "mbd_solver/dynamics/equations.h"

namespace footfall {

struct IntegratorOptions {
  // Tolerances have no default here: SolverSpec has the defaults of scenes, tests state their own.
  double rtol = 0.0;           // relative tolerance of every coordinate > 0
  double atol = 0.0;           // absolute tolerance of q and z > 0 [m, -]
  double atol_velocity = 0.0;  // absolute tolerance of v > 0 [m/s, rad/s]
  int order = 2;               // one_step: 2 (TR-BDF2), 3 (ESDIRK3(2)4L[2]SA) or 5 (ESDIRK5(4)7L[2]SA2)
  int window_order = 0;        // one_step: order in windows that one step of `order` does not fill; 0: `order`
  double max_step = 0.0;       // [s]; 0: the window is the only limit
  bool error_control = true;   // one_step: false takes steps of max_step with any error
  double min_step = 1e-12;     // [s]; below: NumericalError naming time and the worst body or joint
  bool projection = true;      // removes drift after every window (else Baumgarte terms, or none)
};

struct IntegratorStatistics {
  long windows = 0;
  long steps = 0;     // accepted internal steps
  long rejected = 0;  // by the error test
  long newton_failures = 0;
  long residuals = 0;
  long jacobians = 0;
  long factorizations = 0;
  // Largest |phi| and |phi'| of the joints, [m or rad] and [m/s or rad/s]: in reported states, and removed by projection.
  double drift_position = 0.0, drift_velocity = 0.0;
  double removed_position = 0.0, removed_velocity = 0.0;
  // The error that warning() reports, in tolerances. ida: sum of the estimated errors of all steps; one_step: the largest of a
  // step over a singular position, 0 if none exceeds the tolerance.
  double reported_error = 0.0;
  // Sum of the estimated errors of all steps in q, v and z [tolerances]: of the state at the end, unless the motion amplifies them.
  double summed_error = 0.0;

  template <class Archive>
  void visit(Archive& archive) {
    archive("windows", windows);
    archive("steps", steps);
    archive("rejected", rejected);
    archive("newton_failures", newton_failures);
    archive("residuals", residuals);
    archive("jacobians", jacobians);
    archive("factorizations", factorizations);
    archive("drift_position", drift_position);
    archive("drift_velocity", drift_velocity);
    archive("removed_position", removed_position);
    archive("removed_velocity", removed_velocity);
    archive("reported_error", reported_error);
    archive("summed_error", summed_error);
  }
  void count(const Drift& drift);  // at the end of a window
  // Adds the work of another integrator for this one, from `before` to `now`, without its windows.
  void add(const IntegratorStatistics& before, const IntegratorStatistics& now);
};

// A step that has been made, with its continuous extension.
class StepView {
 public:
  virtual ~StepView() = default;
  virtual double begin() const = 0;  // [s]
  virtual double end() const = 0;    // [s]
  // The state in [begin, end], without projection, with the integrals of the step's end, and its rates [dq; dv; dz; lambda].
  virtual void at(double time, State& state, Eigen::VectorXd& rates) = 0;
};

// Where a window stops on its way.
struct WindowStops {
  // The first required row after a time [s]; infinity: no more. Null: none. Rows are output rows of a history, or samples of a
  // controller: they come from the continuous extension of the steps (DenseWeights) and do not influence the steps.
  const std::function<double(double time)>* next_row = nullptr;
  bool steps = false;  // at every step, after the rows in it

  double row_after(double time) const { return next_row ? (*next_row)(time) : std::numeric_limits<double>::infinity(); }
};

struct WindowStop {
  enum Kind { kRow, kStep, kEnd };
  Kind kind = kEnd;
  // The data of a row: the state, projected if the integrator projects, and its rates [dq; dv; dz; lambda].
  const State* state = nullptr;
  const Eigen::VectorXd* rates = nullptr;
  StepView* step = nullptr;  // of a step
};

// The same for a caller that does not pause within a window.
struct Rows {
  std::function<double(double time)> next;  // WindowStops::next_row; empty: no rows
  // False ends the window there: an event changes the loads or inputs.
  std::function<bool(const State& state, const Eigen::VectorXd& rates)> on_row;
  std::function<bool(StepView& step)> on_step;  // likewise; empty: steps are no stops
};

class Integrator {
 public:
  virtual ~Integrator() = default;
  virtual std::string name() const = 0;  // "one_step", "ida"
  // A window from state.time to t_end [s] under constant loads and inputs:
  //   begin(...);  while (next().kind != WindowStop::kEnd) {...}
  // At its end the state is at t_end exactly (or at the row or step that ended the window), projected if required, with its
  // integrals (dissipated, load_work, supplied) advanced. State and inputs must outlive the window; a window that is not
  // finished is forgotten with the next one, after forget(). Each throws NumericalError naming time and body or joint.
  virtual void begin(State& state, double t_end, const Inputs& inputs, const WindowStops& stops) = 0;
  virtual WindowStop next() = 0;
  virtual void end_window() = 0;  // at the row or step that next() has returned
  void advance(State& state, double t_end, const Inputs& inputs, const Rows& rows = {});
  // dy/dt and multipliers at the end of the last window under its loads: [dq; dv; dz; lambda].
  virtual const Eigen::VectorXd& end_rates() const = 0;
  // Drops all memory of earlier windows (factors, step history), so that the continuation depends on the State alone.
  virtual void forget() = 0;
  virtual const IntegratorStatistics& statistics() const = 0;
  // A warning about the accuracy of the run, at its end; empty: none.
  virtual std::string warning() const { return {}; }
  // Continues from another integrator with these statistics, on which forget() was called.
  virtual void resume(const IntegratorStatistics& so_far) = 0;
};

// Adds a share of the current powers to the time integrals of a State: integral += weight [s] x power [W].
void add_work(const EnergySample& at, double weight, State& state);
// The same for the errors of these integrals, weight: of the rule minus the weight of its embedded rule.
void add_work_error(const EnergySample& at, double weight, WorkError& error);
// Adds the sizes of the errors of a step to the errors of a run.
void add_step_error(const WorkError& step, WorkError& sum);
// The sum of the sizes of all powers [W].
double size_of_powers(const EnergySample& at);

// kind: "one_step" (default, L-stable TR-BDF2, no restarts) or "ida" (SUNDIALS); else InputError. `equations` must outlive the
// integrator.
std::unique_ptr<Integrator> make_integrator(const std::string& kind, Equations& equations,
                                            const IntegratorOptions& options);

}  // namespace footfall
