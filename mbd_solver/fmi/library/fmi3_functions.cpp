// The library of an exported FMU: the functions of FMI 3.0 for co-simulation. It holds the values of the variables;
// the simulation is a separate program in the FMU's resources. So nothing of footfall is linked into the importing
// program, and no failure of a simulation ends it. Whatever fails leaves values and state as they were.

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>

#include "coupler/base/files.h"
#include "mbd_solver/base/exact_number.h"
#include "mbd_solver/base/helper_process.h"
#include "mbd_solver/fmi/fmi3_interface.h"
#include "mbd_solver/fmi/model/exported_model.h"

namespace {

using namespace footfall;
using Kind = ExportedVariable::Kind;

constexpr double kTimeOfAnswer = 3600.0;  // for one step at most, by the wall clock [s]

std::string text_in(const std::string& path) { return read_whole_file(path).value_or(""); }

// The path by which a program can be started: archives lose the right to execute.
std::string runnable(const std::string& program) {
  if (access(program.c_str(), X_OK) == 0) return program;
  if (chmod(program.c_str(), 0755) == 0 && access(program.c_str(), X_OK) == 0) return program;
  const std::string bytes = text_in(program);
  const int memory = memfd_create("footfall_fmu_model", 0);
  if (memory < 0 || write(memory, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) return program;
  return "/proc/self/fd/" + std::to_string(memory);
}

struct State {
  std::vector<double> values;
  double time = 0.0;   // of the importing program [s]
  double start = 0.0;  // of the simulation, in that time [s]
  std::string settings;
  bool initialized = false;
  std::string simulation;
};

class Instance {
 public:
  enum class Phase { kInstantiated, kInitializing, kStepping, kTerminated };

  Instance(std::string resources, bool early, fmi3InstanceEnvironment environment, fmi3LogMessageCallback log)
      : resources_(std::move(resources)), early_allowed_(early), environment_(environment), log_(log) {
    while (resources_.size() > 1 && resources_.back() == '/') resources_.pop_back();
    variables_ = variables_of_text(text_in(resources_ + "/variables.txt"));
    if (variables_.empty())
      throw std::runtime_error(resources_ + "/variables.txt cannot be read: the FMU is incomplete");
    reset();
    start_program();
  }

  // The next initialization starts a program anew: the present one may have died, or hang.
  void reset() {
    process_.reset();
    state_ = State();
    for (const ExportedVariable& v : variables_) {
      by_reference_[v.reference] = &v;
      if (state_.values.size() < v.reference + v.start.size()) state_.values.resize(v.reference + v.start.size(), 0.0);
      std::copy(v.start.begin(), v.start.end(), state_.values.begin() + v.reference);
    }
    changed_.clear();
    phase_ = Phase::kInstantiated;
    made_ = false;
  }

  void tell(fmi3Status status, const std::string& text) const {
    if (log_) log_(environment_, status, "logStatusError", text.c_str());
  }

  void set(const fmi3ValueReference* references, std::size_t count, const double* values, std::size_t value_count) {
    std::size_t next = 0;
    std::vector<double> now = state_.values;
    std::map<unsigned, bool> changed;
    for (std::size_t i = 0; i < count; ++i) {
      const ExportedVariable& v = variable(references[i]);
      if (v.kind == Kind::kTime || v.kind == Kind::kOutput)
        throw std::runtime_error("\"" + v.name + "\" cannot be set");
      if (v.kind == Kind::kParameter && phase_ != Phase::kInstantiated && phase_ != Phase::kInitializing)
        throw std::runtime_error("the parameter \"" + v.name + "\" is fixed once the model is initialized");
      if (next + v.start.size() > value_count) throw std::runtime_error("too few values are given");
      for (std::size_t k = 0; k < v.start.size(); ++k, ++next) {
        if (!std::isfinite(values[next]))
          throw std::runtime_error("\"" + v.name + "\" cannot be " + shortest_text(values[next]));
        now[v.reference + k] = values[next];
      }
      if (v.kind == Kind::kParameter) changed[v.reference] = true;
    }
    if (next != value_count) throw std::runtime_error("too many values are given");
    state_.values = now;
    changed_.insert(changed.begin(), changed.end());
    if (phase_ != Phase::kStepping) made_ = false;
  }

  void get(const fmi3ValueReference* references, std::size_t count, double* values, std::size_t value_count) {
    std::size_t next = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const ExportedVariable& v = variable(references[i]);
      if (phase_ == Phase::kInitializing && v.kind == Kind::kOutput) make();
      if (next + v.start.size() > value_count) throw std::runtime_error("there is room for too few values");
      for (std::size_t k = 0; k < v.start.size(); ++k) values[next++] = state_.values[v.reference + k];
    }
    if (next != value_count) throw std::runtime_error("there is room for too many values");
  }

  void enter_initialization(double start, bool stop_defined, double stop) {
    require(Phase::kInstantiated, "fmi3EnterInitializationMode");
    if (!std::isfinite(start) || (stop_defined && !(stop > start)))
      throw std::runtime_error("fmi3EnterInitializationMode from " + shortest_text(start) + " s" +
                               (stop_defined ? " to " + shortest_text(stop) + " s" : "") +
                               ", expected a finite start time, and a stop time behind it");
    require_program();
    phase_ = Phase::kInitializing;
    state_.start = state_.time = start;
    duration_ = stop_defined ? stop - start : 0.0;
    put_time(start);
    made_ = false;
  }
  void exit_initialization() {
    require(Phase::kInitializing, "fmi3ExitInitializationMode");
    make();
    phase_ = Phase::kStepping;
  }
  void terminate() { phase_ = Phase::kTerminated; }

  fmi3Status step(double from, double length, bool* terminate_simulation, bool* early, double* last) {
    require(Phase::kStepping, "fmi3DoStep");
    const double round_off = 1e-9 * std::max({1.0, std::abs(from), std::abs(length)});
    if (!(length > 0.0) || std::abs(from - state_.time) > round_off)
      throw std::runtime_error("fmi3DoStep from " + shortest_text(from) + " s by " + shortest_text(length) +
                               " s, but the model is at " + shortest_text(state_.time) + " s");
    const double until = from + length;
    std::string question = "S";
    append(question, until - state_.start);
    append(question, early_allowed_ ? 1.0 : 0.0);
    for (const ExportedVariable& v : variables_)
      if (v.kind == Kind::kInput) append(question, state_.values[v.reference]);
    const Answer answer = take_values(question);
    const bool whole = std::abs(answer.time + state_.start - until) <= round_off;
    state_.time = whole ? until : answer.time + state_.start;
    put_time(state_.time);
    *last = state_.time;
    *early = answer.early;
    *terminate_simulation = answer.finished && !whole;  // the scene ends before the step does
    if (*terminate_simulation) *early = true;
    return fmi3OK;
  }

  std::unique_ptr<State> save() {
    auto saved = std::make_unique<State>(state_);
    saved->initialized = phase_ == Phase::kStepping;
    saved->settings = settings();
    if (saved->initialized) saved->simulation = ask("G").substr(1);
    return saved;
  }
  void restore(const State& saved) {
    const auto finite = [](double x) { return std::isfinite(x); };
    if (saved.values.size() != state_.values.size() || !std::isfinite(saved.time) || !std::isfinite(saved.start) ||
        !std::all_of(saved.values.begin(), saved.values.end(), finite))
      throw std::runtime_error("the state is damaged, or belongs to another FMU");
    if (saved.initialized) {
      require_program();
      take_values("R" + saved.simulation);
    }
    state_ = saved;
    phase_ = saved.initialized ? Phase::kStepping : Phase::kInstantiated;
    made_ = saved.initialized;
    for (const ExportedVariable& v : variables_)
      if (v.kind == Kind::kParameter &&
          !std::equal(v.start.begin(), v.start.end(), state_.values.begin() + v.reference))
        changed_[v.reference] = true;
  }

 private:
  struct Answer {
    double time;
    bool early, finished;
  };

  const ExportedVariable& variable(unsigned reference) const {
    const auto found = by_reference_.find(reference);
    if (found == by_reference_.end())
      throw std::runtime_error("there is no variable with the value reference " + std::to_string(reference));
    return *found->second;
  }
  void require(Phase phase, const char* function) const {
    if (phase_ != phase)
      throw std::runtime_error(std::string(function) + " is called in another mode than the standard allows");
  }
  static void append(std::string& bytes, double value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }

  void put_time(double time) {
    for (const ExportedVariable& v : variables_)
      if (v.kind == Kind::kTime) state_.values[v.reference] = time;
  }

  void start_program() {
    const std::string programs = resources_ + "/bin/";
    const std::string host = programs + "footfall_fmu_host";  // of a scene that runs FMUs
    if (access(host.c_str(), F_OK) == 0 && access(host.c_str(), X_OK) != 0 && chmod(host.c_str(), 0755) != 0)
      throw std::runtime_error(host +
                               " may not be executed; unpack the FMU with your own rights, on a disk that allows it");
    const Command command{Rights::of_user(), {runnable(programs + "footfall_fmu_model"), resources_}};
    process_ = std::make_unique<HelperProcess>(command, kTimeOfAnswer, Orphan::kEndsByItself);
  }

  void require_program() {
    if (!process_) start_program();
  }

  std::string ask(const std::string& question) {
    if (!process_)
      throw std::runtime_error(
          "the program of the model has ended; call fmi3Reset and initialize again, or fmi3SetFMUState with a state "
          "that was saved");
    std::string answer;
    try {
      answer = process_->ask(question);
    } catch (const NoAnswer& error) {
      process_.reset();
      throw std::runtime_error(std::string("the program of the model (resources/bin/footfall_fmu_model) ") +
                               error.what());
    }
    if (answer.empty() || answer[0] == 'E') throw std::runtime_error(answer.empty() ? "no answer" : answer.substr(1));
    return answer;
  }

  // Only whole and finite answers change the values.
  Answer take_values(const std::string& question) {
    const std::string answer = ask(question);
    std::size_t next = 3;
    for (const ExportedVariable& v : variables_) next += v.kind == Kind::kOutput ? 1 : 0;
    std::vector<double> numbers(next);
    if (answer[0] != 'V' || answer.size() < 1 + next * sizeof(double))
      throw std::runtime_error("the program of the model sent another answer than outputs");
    std::memcpy(numbers.data(), answer.data() + 1, next * sizeof(double));
    if (const std::string warnings = answer.substr(1 + next * sizeof(double)); !warnings.empty())
      tell(fmi3Warning, warnings);
    next = 3;
    for (const ExportedVariable& v : variables_)
      if (v.kind == Kind::kOutput) state_.values[v.reference] = numbers[next++];
    return {numbers[0], numbers[1] != 0.0, numbers[2] != 0.0};
  }

  // KEY=VALUE of parameters that were set.
  std::string settings() const {
    std::string text;
    for (const auto& [reference, unused] : changed_) {
      const ExportedVariable& v = variable(reference);
      text += v.name + "=";
      if (v.start.size() > 1) text += "[";
      for (std::size_t k = 0; k < v.start.size(); ++k)
        text += (k ? "," : "") + shortest_text(state_.values[reference + k]);
      if (v.start.size() > 1) text += "]";
      text += "\n";
    }
    for (const ExportedVariable& v : variables_)
      if (v.kind == Kind::kInput && state_.values[v.reference] != v.start[0])
        text += "signals." + v.name + ".initial=" + shortest_text(state_.values[v.reference]) + "\n";
    bool ends = duration_ > 0.0;
    for (const ExportedVariable& v : variables_)
      if (v.name == "end_time" && (changed_.count(v.reference) > 0 || v.start[0] >= duration_)) ends = false;
    if (ends) text += "end_time=" + shortest_text(duration_) + "\n";
    return text;
  }
  void make() {
    if (made_) return;
    take_values("N" + settings());
    made_ = true;
  }

  std::string resources_;
  bool early_allowed_;
  fmi3InstanceEnvironment environment_;
  fmi3LogMessageCallback log_;
  std::vector<ExportedVariable> variables_;
  std::map<unsigned, const ExportedVariable*> by_reference_;
  std::map<unsigned, bool> changed_;  // parameters that were set
  State state_;
  double duration_ = 0.0;  // of the importing program's simulation [s]; 0: unknown
  Phase phase_ = Phase::kInstantiated;
  bool made_ = false;  // the simulation has the present parameters and inputs
  std::unique_ptr<HelperProcess> process_;
};

// Errors become a message and a status.
template <class Work>
fmi3Status guarded_call(fmi3Instance instance, const Work& work) {
  if (!instance) return fmi3Error;
  auto& i = *static_cast<Instance*>(instance);
  try {
    work(i);
    return fmi3OK;
  } catch (const std::exception& error) {
    i.tell(fmi3Error, error.what());
  } catch (...) {
    i.tell(fmi3Error, "an unknown failure");
  }
  return fmi3Error;
}

State& state_at(fmi3FMUState state) {
  if (!state) throw std::runtime_error("no state is given, expected one of fmi3GetFMUState or fmi3DeserializeFMUState");
  return *static_cast<State*>(state);
}

template <class Value>
Value* given(Value* pointer, const char* what) {
  if (!pointer) throw std::runtime_error(std::string("no place for the ") + what + " is given");
  return pointer;
}

std::string bytes_of_state(const State& s) {
  std::string bytes;
  const auto number = [&](double value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  number(s.initialized ? 1.0 : 0.0);
  number(s.time);
  number(s.start);
  number(static_cast<double>(s.values.size()));
  for (const double value : s.values) number(value);
  return bytes + s.simulation;
}

State state_of_bytes(const std::string& bytes) {
  State s;
  std::size_t next = 0;
  const auto number = [&] {
    double value = 0.0;
    if (next + sizeof value > bytes.size()) throw std::runtime_error("the serialized state is too short");
    std::memcpy(&value, bytes.data() + next, sizeof value);
    next += sizeof value;
    return value;
  };
  s.initialized = number() != 0.0;
  s.time = number();
  s.start = number();
  const double count = number();
  if (!(count >= 0.0 && count * sizeof(double) <= static_cast<double>(bytes.size())))
    throw std::runtime_error("the serialized state is damaged");
  for (double k = 0.0; k < count; ++k) s.values.push_back(number());
  s.simulation = bytes.substr(next);
  return s;
}

}  // namespace

#define FMI3 extern "C" __attribute__((visibility("default")))

FMI3 const char* fmi3GetVersion() { return "3.0"; }
FMI3 fmi3Status fmi3SetDebugLogging(fmi3Instance, fmi3Boolean, std::size_t, const fmi3String*) { return fmi3OK; }

FMI3 fmi3Instance fmi3InstantiateCoSimulation(fmi3String, fmi3String token, fmi3String resources, fmi3Boolean,
                                              fmi3Boolean, fmi3Boolean events, fmi3Boolean early,
                                              const fmi3ValueReference*, std::size_t,
                                              fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                                              fmi3IntermediateUpdateCallback) {
  const auto refuse = [&](const std::string& why) -> fmi3Instance {
    if (log) log(environment, fmi3Error, "logStatusError", why.c_str());
    return nullptr;
  };
  try {
    if (!resources) return refuse("no path of the resources is given, expected the resources of the unpacked FMU");
    std::string path = resources;
    if (path.rfind("file://", 0) == 0) path = path.substr(7);
    if (events) return refuse("the event mode is not supported (hasEventMode is false)");
    const std::string own = text_in(path + "/token.txt");
    if (own.empty())
      return refuse(path + "/token.txt cannot be read: expected the path of the resources of the unpacked FMU");
    if (!token || own != token) return refuse("the instantiation token does not belong to this FMU");
    return new Instance(path, early, environment, log);
  } catch (const std::exception& error) {
    return refuse(error.what());
  }
}
FMI3 void fmi3FreeInstance(fmi3Instance instance) { delete static_cast<Instance*>(instance); }

FMI3 fmi3Status fmi3EnterInitializationMode(fmi3Instance i, fmi3Boolean, fmi3Float64, fmi3Float64 start,
                                            fmi3Boolean stops, fmi3Float64 stop) {
  return guarded_call(i, [&](Instance& model) { model.enter_initialization(start, stops, stop); });
}
FMI3 fmi3Status fmi3ExitInitializationMode(fmi3Instance i) {
  return guarded_call(i, [](Instance& model) { model.exit_initialization(); });
}
FMI3 fmi3Status fmi3Terminate(fmi3Instance i) {
  return guarded_call(i, [](Instance& model) { model.terminate(); });
}
FMI3 fmi3Status fmi3Reset(fmi3Instance i) {
  return guarded_call(i, [](Instance& model) { model.reset(); });
}
FMI3 fmi3Status fmi3DoStep(fmi3Instance i, fmi3Float64 from, fmi3Float64 length, fmi3Boolean, fmi3Boolean* events,
                           fmi3Boolean* terminate, fmi3Boolean* early, fmi3Float64* last) {
  bool unused[3];
  double unused_time = 0.0;
  if (events) *events = false;
  bool* const ends = terminate ? terminate : &unused[0];
  bool* const returns = early ? early : &unused[1];
  *ends = *returns = false;
  return guarded_call(i, [&](Instance& model) { model.step(from, length, ends, returns, last ? last : &unused_time); });
}
FMI3 fmi3Status fmi3SetFloat64(fmi3Instance i, const fmi3ValueReference* r, std::size_t n, const fmi3Float64* values,
                               std::size_t m) {
  return guarded_call(i, [&](Instance& model) { model.set(r, n, values, m); });
}
FMI3 fmi3Status fmi3GetFloat64(fmi3Instance i, const fmi3ValueReference* r, std::size_t n, fmi3Float64* values,
                               std::size_t m) {
  return guarded_call(i, [&](Instance& model) { model.get(r, n, values, m); });
}
FMI3 fmi3Status fmi3GetFMUState(fmi3Instance i, fmi3FMUState* state) {
  return guarded_call(i, [&](Instance& model) {
    given(state, "state");
    std::unique_ptr<State> saved = model.save();
    delete static_cast<State*>(*state);
    *state = saved.release();
  });
}
FMI3 fmi3Status fmi3SetFMUState(fmi3Instance i, fmi3FMUState state) {
  return guarded_call(i, [&](Instance& model) { model.restore(state_at(state)); });
}
FMI3 fmi3Status fmi3FreeFMUState(fmi3Instance, fmi3FMUState* state) {
  if (!state) return fmi3OK;
  delete static_cast<State*>(*state);
  *state = nullptr;
  return fmi3OK;
}
FMI3 fmi3Status fmi3SerializedFMUStateSize(fmi3Instance i, fmi3FMUState state, std::size_t* size) {
  return guarded_call(i, [&](Instance&) { *given(size, "size") = bytes_of_state(state_at(state)).size(); });
}
FMI3 fmi3Status fmi3SerializeFMUState(fmi3Instance i, fmi3FMUState state, fmi3Byte* bytes, std::size_t size) {
  return guarded_call(i, [&](Instance&) {
    const std::string text = bytes_of_state(state_at(state));
    if (text.size() != size) throw std::runtime_error("the state has another size");
    std::memcpy(given(bytes, "bytes"), text.data(), size);
  });
}
FMI3 fmi3Status fmi3DeserializeFMUState(fmi3Instance i, const fmi3Byte* bytes, std::size_t size, fmi3FMUState* state) {
  return guarded_call(i, [&](Instance&) {
    auto read = std::make_unique<State>(state_of_bytes({reinterpret_cast<const char*>(given(bytes, "bytes")), size}));
    *given(state, "state") = read.release();
  });
}

// Parts that this FMU lacks: other types of variables, other modes, derivatives, clocks, model exchange, scheduled execution.
#define NOT_SUPPORTED(name)                                                                                \
  FMI3 fmi3Status name(fmi3Instance instance, ...) {                                                       \
    return guarded_call(instance, [](Instance&) { throw std::runtime_error(#name " is not supported"); }); \
  }
#define NO_ACCESS(type)        \
  NOT_SUPPORTED(fmi3Get##type) \
  NOT_SUPPORTED(fmi3Set##type)
NO_ACCESS(Float32)
NO_ACCESS(Int8)
NO_ACCESS(UInt8)
NO_ACCESS(Int16)
NO_ACCESS(UInt16)
NO_ACCESS(Int32)
NO_ACCESS(UInt32)
NO_ACCESS(Int64)
NO_ACCESS(UInt64)
NO_ACCESS(Boolean)
NO_ACCESS(String)
NO_ACCESS(Binary)
NO_ACCESS(Clock)
NOT_SUPPORTED(fmi3GetNumberOfVariableDependencies)
NOT_SUPPORTED(fmi3GetVariableDependencies)
NOT_SUPPORTED(fmi3GetDirectionalDerivative)
NOT_SUPPORTED(fmi3GetAdjointDerivative)
NOT_SUPPORTED(fmi3EnterConfigurationMode)
NOT_SUPPORTED(fmi3ExitConfigurationMode)
NOT_SUPPORTED(fmi3EnterEventMode)
NOT_SUPPORTED(fmi3EnterStepMode)
NO_ACCESS(IntervalDecimal)
NO_ACCESS(IntervalFraction)
NO_ACCESS(ShiftDecimal)
NO_ACCESS(ShiftFraction)
NOT_SUPPORTED(fmi3EvaluateDiscreteStates)
NOT_SUPPORTED(fmi3UpdateDiscreteStates)
NOT_SUPPORTED(fmi3EnterContinuousTimeMode)
NOT_SUPPORTED(fmi3CompletedIntegratorStep)
NOT_SUPPORTED(fmi3SetTime)
NOT_SUPPORTED(fmi3SetContinuousStates)
NOT_SUPPORTED(fmi3GetContinuousStateDerivatives)
NOT_SUPPORTED(fmi3GetEventIndicators)
NOT_SUPPORTED(fmi3GetContinuousStates)
NOT_SUPPORTED(fmi3GetNominalsOfContinuousStates)
NOT_SUPPORTED(fmi3GetNumberOfEventIndicators)
NOT_SUPPORTED(fmi3GetNumberOfContinuousStates)
NOT_SUPPORTED(fmi3GetOutputDerivatives)
NOT_SUPPORTED(fmi3ActivateModelPartition)

FMI3 fmi3Instance fmi3InstantiateModelExchange(fmi3String, ...) { return nullptr; }
FMI3 fmi3Instance fmi3InstantiateScheduledExecution(fmi3String, ...) { return nullptr; }
