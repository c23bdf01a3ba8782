#pragma once
// A mechanism inside another program, which controls it:
//   Session lander(read_scene("landing.toml", {"initial.velocity = [0, 0, -5]"}));
//   while (!lander.finished()) {
//     lander.set("thrust", 3000.0);
//     lander.step_to(lander.time() + 1e-3);
//     use(lander.value("cabin.az"));
//   }
// It is the run of the command line (run/simulation.h), in parts: while no signal is set and no state saved, times at which it is read
// influence it as rows of a history do, by round-off at most. No file is written. Objects share nothing. Each serves one thread at a time: while a call is
// under way that changes it (step_to, set, save, restore), every call of another thread throws InputError.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mbd_solver/scene/scene.h"

namespace footfall {

struct SessionOptions {
  bool trusted = false;  // programs that the scene names may run: FMUs, Python files
  bool record = false;   // the peaks of all steps, as a run from the command line has them: for summary()
};

class Session {
 public:
  // At the start, with its columns. Throws InputError, also for a scene that touches grains, and NumericalError.
  explicit Session(Scene scene, SessionOptions options = {});
  ~Session();
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;

  const Scene& scene() const;
  double time() const;      // [s]
  double end_time() const;  // of the scene [s]
  bool finished() const;    // the end of the scene has been reached

  // To this time [s], or to the end of the scene if that is earlier. Throws NumericalError; time, columns and state are then
  // as before the step, but the simulation can continue only after restore(). Throws InputError for a time before the present
  // one. asked: called at most every tenth of a second (wall clock); true ends the step early, at a time that it has reached.
  void step_to(double until, const std::function<bool()>& asked = {});

  // Columns of history.csv of this scene, as docs/reference/history.md lists them; the first is the time. SI units, "-" of plain numbers.
  const std::vector<std::string>& names() const;
  const std::vector<std::string>& units() const;
  std::vector<double> row() const;                    // now, in the order of the names
  double value(const std::string& name) const;        // one of them; throws InputError
  std::size_t column(const std::string& name) const;  // its place in the row; throws InputError

  // Signals of kind "host". A value acts from the present time on, constant until it is set again.
  std::vector<std::string> signals() const;
  void set(const std::string& signal, double value);  // throws InputError
  double signal(const std::string& name) const;       // its last value; throws InputError

  // Coordinates, velocities and inner states, as integrated: theory 2.1.
  Eigen::VectorXd q() const;  // positions [m] and unit quaternions [-], then modal coordinates
  Eigen::VectorXd v() const;  // their velocities [m/s, rad/s]
  Eigen::VectorXd z() const;  // of struts, drives and signals

  // Sets q and v; inner states and what contacts remember stay. Quaternions are normalized, and joints are closed by the
  // smallest change of both, so q() and v() may differ from what was given. The energy that this gives or takes
  // counts as stored from the start. Throws InputError for another size, numbers that are not finite or a
  // quaternion of length zero, NumericalError if the joints cannot be closed; nothing has changed then.
  void place(const Eigen::VectorXd& q, const Eigen::VectorXd& v);

  // The whole state as text. The continuations from save() and from restore() are bitwise identical; they differ from a run without
  // save() within the tolerances of the scene, because the memory of the integrator is not part of a state. restore() takes a state
  // of the same scene with the same settings, from any object or process of this version; throws InputError otherwise.
  std::string save();
  void restore(const std::string& state);

  // Relative error of the energy balance so far [-], as energy_balance_relative of summary.json without the estimates of integrals.
  double energy_balance() const;
  double summed_error() const;  // estimated, of all steps [tolerances of the scene]
  // Warnings of the scene, the mechanism and the motion so far, each with its code. Notes are warnings without a consequence.
  std::vector<std::string> warnings() const;
  std::vector<std::string> notes() const;
  std::string summary() const;     // summary.json of the run so far; throws InputError unless options.record
  std::string parameters() const;  // the scene with all defaults, as JSON: the keys of --set

 private:
  struct Run;
  class Reading;
  class Changing;
  std::unique_ptr<Run> run_;
};

}  // namespace footfall
