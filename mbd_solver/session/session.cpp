// The run pauses at its samples; a step is over at the sample of its end, and save() at the checkpoint that it requests. A lock that nobody
// waits for refuses calls of other threads; values are copied when they are read, so that no thread sees them change.

#include "mbd_solver/session/session.h"

#include <atomic>
#include <cmath>
#include <csignal>
#include <shared_mutex>
#include <thread>
#include <unordered_map>
#include <utility>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/fingerprint.h"
#include "mbd_solver/scene/foreign/foreign_code.h"
#include "mbd_solver/scene/scene_schema.h"
#include "mbd_solver/session/codes.h"
#include "mbd_solver/session/run_summary.h"
#include "mbd_solver/session/simulation.h"

namespace footfall {
namespace {

constexpr double kAskEvery = 0.1;  // interruption, by the wall clock [s]
const char* const kStateHead = "footfall state ";

const Scene& without_grains(const Scene& scene, bool trusted) {
  require_trust(scene, trusted);
  require_foreign_code(scene);
  if (scene.touches_particles())
    throw InputError(code::kEmbeddedGrains,
                     scene.file +
                         ": ground.kind = \"particles\": this simulation has no grains; control both programs from "
                         "Python (footfall.Simulation), or set ground.kind to \"plane\" or \"soil\"");
  return scene;
}

}  // namespace

struct Session::Run {
  Run(Scene given, SessionOptions chosen)
      : scene(std::move(given)),
        options(chosen),
        simulation(without_grains(scene, options.trusted), scene.end_time, nullptr),
        observation(simulation.subject()),
        metrics(simulation.subject()),
        names(observation.names()),
        units(observation.units()) {
    for (std::size_t i = 0; i < names.size(); ++i) places.emplace(names[i], i);
    const auto see = [this](const Sample& sample) { metrics.update_peaks(sample); };
    if (options.record) simulation.observe_within(see, nullptr);
    const std::vector<SignalSpec>& signals = scene.signals;
    for (std::size_t i = 0; i < signals.size(); ++i)
      if (signals[i].kind == SignalKind::kHost)
        hosts.push_back({signals[i].name, simulation.mechanism().signals[i].place, signals[i].initial.value_or(0.0)});
    begin();
    continue_run();
    take(simulation.sample());
  }

  void begin() {
    failed = false;
    CheckpointWriter writer;
    writer.begin = [](long) { return std::string(); };
    writer.finish = [] {};
    simulation.begin(never, writer);
  }

  // To the next sample, checkpoint or end.
  Reached continue_run() {
    try {
      const Reached reached = simulation.next();
      if (reached == Reached::kSample) metrics.update(simulation.sample());
      return reached;
    } catch (...) {
      failed = true;
      throw;
    }
  }

  // Up to the time of the step, or until `asked` ends it at the time that it has reached.
  void step(const std::function<bool()>& asked) {
    double next_question = wall_clock() + kAskEvery;
    for (Reached reached = continue_run(); reached != Reached::kEnd; reached = continue_run()) {
      for (Host& host : hosts) host.waits = false;
      if (reached != Reached::kSample) continue;
      const Sample& sample = simulation.sample();
      if (sample.state.time >= target - simulation.instructions().rows().tolerance() || sample.last)
        return take(sample);
      observation.watch(sample);
      if (!asked || wall_clock() < next_question) continue;
      if (asked()) {
        target = sample.state.time;
        return take(sample);
      }
      next_question = wall_clock() + kAskEvery;
    }
  }

  // The present state as in a checkpoint, with which an integrator begins anew.
  void pause() {
    simulation.instructions().request_checkpoint();
    const Reached reached = continue_run();
    FOOTFALL_DEMAND(reached == Reached::kCheckpoint);
  }

  void require_state(const Eigen::VectorXd& new_q, const Eigen::VectorXd& new_v) const {
    const std::string here = scene.file + ": the state that is set ";
    if (new_q.size() != q.size() || new_v.size() != v.size())
      throw InputError(code::kWrongArgument, here + "has " + std::to_string(new_q.size()) + " positions and " +
                                                 std::to_string(new_v.size()) + " velocities, expected " +
                                                 std::to_string(q.size()) + " and " + std::to_string(v.size()));
    if (!new_q.allFinite() || !new_v.allFinite())
      throw InputError(code::kGivenNotFinite, here + "has a number that is not finite; correct it");
    for (const int body_q : simulation.subject().layout.body_q)
      if (!(new_q.segment<4>(body_q + 3).norm() > 0.5))
        throw InputError(code::kWrongArgument, here + "has the quaternion of a body at place " +
                                                   std::to_string(body_q + 3) + " with a length below 0.5, expected 1");
  }

  void take(const Sample& sample) {
    time = sample.state.time;
    q = sample.state.q;
    v = sample.state.v;
    z = sample.state.z;
    row = observation.row(sample);
  }

  std::string archived() {
    Archive archive;
    simulation.forget_times();  // a state has no wall clock
    visit(archive);
    return archive.text();
  }

  void visit(Archive& archive) {
    archive("simulation", simulation);
    archive("observation", observation);
    archive("metrics", metrics);
    archive("row", row);
    for (Host& host : hosts) {
      archive(("signal." + host.name).c_str(), host.value);
      archive(("signal." + host.name + ".waits").c_str(), host.waits);
      if (archive.restores() && host.waits) simulation.instructions().set_input(host.place, host.value);
    }
  }

  std::string head() const { return kStateHead + fingerprint(scene_json(scene)) + "\n"; }

  struct Host {
    std::string name;
    int place;
    double value;
    bool waits = false;  // its value has not acted yet
  };

  Scene scene;
  SessionOptions options;
  Simulation simulation;
  Observation observation;
  MetricRecorder metrics;
  std::vector<std::string> names, units;
  std::unordered_map<std::string, std::size_t> places;  // in a row, by name
  std::vector<Host> hosts;
  const volatile std::sig_atomic_t never = 0;  // no signal interrupts a step
  double target = 0.0;                         // of the step [s]
  bool failed = false;
  double time = 0.0;  // [s], and the data for this time
  Eigen::VectorXd q, v, z;
  std::vector<double> row;
  std::shared_mutex use;                 // shared by those who read, alone for one who changes
  std::atomic<std::thread::id> changer;  // whose questions within a step may read

  bool has_ended() const { return time >= scene.end_time * (1.0 - 1e-12); }
  [[noreturn]] void refuse_use() const {
    throw InputError(code::kInUse, scene.file +
                                       ": the simulation is being stepped by another thread, or in a call that has not "
                                       "ended; wait for its end, or make a simulation for each thread");
  }
};

// For the time of a call that reads.
class Session::Reading {
 public:
  explicit Reading(Run& run) : run_(run) {
    if (run.changer == std::this_thread::get_id()) return;
    lock_ = std::shared_lock(run.use, std::try_to_lock);
    if (!lock_) run.refuse_use();
  }
  const Run* operator->() const { return &run_; }

 private:
  const Run& run_;
  std::shared_lock<std::shared_mutex> lock_;
};

// For the time of a call that changes the simulation.
class Session::Changing {
 public:
  explicit Changing(Run& run) : run_(run) {
    if (run.changer == std::this_thread::get_id() || !run.use.try_lock()) run.refuse_use();
    run.changer = std::this_thread::get_id();
  }
  ~Changing() {
    run_.changer = std::thread::id();
    run_.use.unlock();
  }
  Changing(const Changing&) = delete;
  Changing& operator=(const Changing&) = delete;

 private:
  Run& run_;
};

Session::Session(Scene scene, SessionOptions options) : run_(std::make_unique<Run>(std::move(scene), options)) {}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

const Scene& Session::scene() const { return run_->scene; }
double Session::time() const { return Reading(*run_)->time; }
double Session::end_time() const { return run_->scene.end_time; }
bool Session::finished() const { return Reading(*run_)->has_ended(); }
Eigen::VectorXd Session::q() const { return Reading(*run_)->q; }
Eigen::VectorXd Session::v() const { return Reading(*run_)->v; }
Eigen::VectorXd Session::z() const { return Reading(*run_)->z; }

void Session::step_to(double until, const std::function<bool()>& asked) {
  Run& run = *run_;
  const Changing changing(run);
  const std::string now = "t = " + number_text(run.time, 9) + " s: ";
  if (run.failed)
    throw InputError(code::kCannotGoOn,
                     now + "the simulation has failed; restore a state that was saved, or make a new simulation");
  if (run.has_ended())
    throw InputError(code::kCannotGoOn,
                     now + "the end of the scene has been reached; set a later end_time and make a new simulation");
  if (!std::isfinite(until) || until < run.time)
    throw InputError(code::kStepBackwards, now + "the requested step to " + number_text(until, 9) +
                                               " s lies in the past, expected a later time; restore() goes back");
  if (until <= run.time + run.simulation.instructions().rows().tolerance()) return;
  run.target = std::min(until, run.scene.end_time);
  run.simulation.instructions().stop_at(run.target);
  run.step(asked);
}

const std::vector<std::string>& Session::names() const { return run_->names; }
const std::vector<std::string>& Session::units() const { return run_->units; }
std::vector<double> Session::row() const { return Reading(*run_)->row; }

std::size_t Session::column(const std::string& name) const {
  const auto found = run_->places.find(name);
  if (found == run_->places.end())
    throw InputError(code::kNoSuchColumn, run_->scene.file + ": there is no column \"" + name + "\"." +
                                              known_names("columns", name, run_->names));
  return found->second;
}

double Session::value(const std::string& name) const {
  const std::size_t place = column(name);
  return Reading(*run_)->row[place];
}

std::vector<std::string> Session::signals() const {
  std::vector<std::string> names;
  for (const Run::Host& host : run_->hosts) names.push_back(host.name);
  return names;
}

void Session::set(const std::string& name, double value) {
  Run& run = *run_;
  const Changing changing(run);
  const double before = signal(name);
  if (!std::isfinite(value))
    throw InputError(code::kGivenNotFinite,
                     "signal \"" + name + "\" was set to " + number_text(value) + ", expected a finite number");
  if (value == before || run.failed) return;
  for (Run::Host& host : run.hosts) {
    if (host.name != name) continue;
    host.value = value;
    host.waits = true;
    run.simulation.instructions().set_input(host.place, value);
  }
}

double Session::signal(const std::string& name) const {
  const Reading reading(*run_);
  for (const Run::Host& host : run_->hosts)
    if (host.name == name) return host.value;
  throw InputError(code::kNoHostSignal, run_->scene.file + ": there is no signal \"" + name + "\" of kind \"host\"." +
                                            known_names("such signals", name, signals()));
}

void Session::place(const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
  Run& run = *run_;
  const Changing changing(run);
  if (run.failed || run.has_ended())
    throw InputError(code::kCannotGoOn, "a simulation that has " + std::string(run.failed ? "failed" : "ended") +
                                            " has no state to set; restore an earlier state, or make a new simulation");
  run.require_state(q, v);
  run.pause();
  const double before = run.simulation.sample().energy.stored.total();
  run.simulation.place(q, v);
  run.metrics.count_jump(run.simulation.sample().energy.stored.total() - before);
  run.take(run.simulation.sample());
  run.begin();
}

std::string Session::save() {
  Run& run = *run_;
  const Changing changing(run);
  if (run.failed)
    throw InputError(code::kCannotGoOn, "a simulation that has failed has no state to save; restore an earlier state");
  if (!run.has_ended()) run.pause();
  return run.head() + run.archived();
}

void Session::restore(const std::string& state) {
  Run& run = *run_;
  const Changing changing(run);
  const std::string head = run.head();
  if (state.compare(0, head.size(), head) != 0)
    throw InputError(code::kStateOfAnother,
                     run.scene.file +
                         ": the state that is restored belongs to another scene, other settings or another "
                         "version of footfall");
  run.failed = true;  // until all of it is restored
  Archive archive("state", state.substr(head.size()));
  run.visit(archive);
  archive.finish();
  const State& now = run.simulation.state();
  run.time = run.target = now.time;
  run.q = now.q;
  run.v = now.v;
  run.z = now.z;
  run.begin();
}

double Session::energy_balance() const { return Reading(*run_)->metrics.metrics().energy_balance_relative(); }
double Session::summed_error() const { return Reading(*run_)->simulation.integrator().statistics().summed_error; }

std::vector<std::string> Session::warnings() const {
  const Reading reading(*run_);
  const Run& run = *run_;
  std::vector<std::string> all = run.simulation.mechanism().warnings;  // including the warnings of the scene
  const std::vector<std::string> of_run = RunWarnings(run.simulation, run.observation, run.metrics).all();
  all.insert(all.end(), of_run.begin(), of_run.end());
  return all;
}

std::vector<std::string> Session::notes() const { return Reading(*run_)->simulation.assembly().notes; }

std::string Session::summary() const {
  const Reading reading(*run_);
  const Run& run = *run_;
  if (!run.options.record)
    throw InputError(code::kNotRecorded,
                     "a summary needs the peaks of all steps: make the simulation with the option to record");
  const std::string status = run.failed ? "failed" : run.has_ended() ? "done" : "interrupted";
  return run_summary(run.simulation, run.metrics, run.observation, status, "", "").dump(1);
}

std::string Session::parameters() const { return scene_json(run_->scene); }

}  // namespace footfall
