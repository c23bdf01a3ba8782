// Controllers of the scene with the struts that they drive, and its signals: blocks, their places among the inputs of a run,
// and the measurements of continuous signals.

#include <algorithm>
#include <optional>
#include <utility>

#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "mbd_solver/assemble/codes.h"
#include "mbd_solver/assemble/foreign_block.h"
#include "mbd_solver/assemble/law_files.h"
#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/assemble/time_functions.h"
#include "mbd_solver/base/fmu_description.h"
#include "mbd_solver/model/control/continuous_signals.h"
#include "mbd_solver/model/control/controllers.h"
#include "mbd_solver/model/control/fuzzy_controller.h"
#include "mbd_solver/model/control/signal_blocks.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/shipped_files.h"

namespace footfall {
namespace {

std::unique_ptr<Controller> build(const ControllerSpec& spec, int outputs, std::vector<std::string>& warnings) {
  switch (spec.kind) {
    case ControllerKind::kConstant: {
      ConstantControllerParameters p;
      p.period = spec.period;
      p.voltages.resize(outputs);
      for (int k = 0; k < outputs; ++k)
        p.voltages(k) = spec.voltages[spec.voltages.size() == 1 ? 0 : static_cast<std::size_t>(k)];
      return std::make_unique<ConstantController>(p);
    }
    case ControllerKind::kFuzzy: {
      FuzzyControllerParameters p;
      p.rules = read_fll(spec.file);
      p.period = spec.period;
      p.filter_frequency = spec.filter_frequency;
      p.tabulated = spec.tabulated;
      for (std::size_t i = 0; i < p.grid.size(); ++i) p.grid[i] = spec.grid[i];
      auto controller = std::make_unique<FuzzyController>(p);
      if (controller->table_difference())
        warnings.push_back(with_code(code::kTableDifference, "controller \"", spec.name,
                                     "\": the table differs from the exact controller by up to ",
                                     plain_text(*controller->table_difference())));
      return controller;
    }
    case ControllerKind::kSkyhook: {
      SkyhookControllerParameters p = spec.skyhook;
      p.outputs = outputs;
      p.period = spec.period;
      return std::make_unique<SkyhookController>(p);
    }
    case ControllerKind::kPid: {
      PidControllerParameters p = spec.pid;
      p.outputs = outputs;
      p.period = spec.period;
      p.filter_frequency = spec.filter_frequency;
      return std::make_unique<PidController>(p);
    }
  }
  FOOTFALL_DEMAND(false);
}

// Signals and states of the scene: blocks, their places among the inputs of a run, and measurements of continuous signals.

std::unique_ptr<SignalBlock> build_table2(const SignalSpec& spec) {
  using RowByRow = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto rows = static_cast<Eigen::Index>(spec.x.size()), columns = static_cast<Eigen::Index>(spec.x2.size());
  return std::make_unique<LookupTable>(spec.x, spec.x2, Eigen::Map<const RowByRow>(spec.values.data(), rows, columns));
}

std::unique_ptr<SignalBlock> build(const SignalSpec& spec) {
  switch (spec.kind) {
    case SignalKind::kExpression: return std::make_unique<PassBlock>();
    case SignalKind::kPid: {
      PidBlockParameters p = spec;
      p.rate_is_given = !spec.rate.empty();
      return std::make_unique<PidBlock>(p);
    }
    case SignalKind::kLowpass:
      return std::make_unique<LinearFilter>(LinearFilter::low_pass(spec.frequency, spec.period));
    case SignalKind::kLowpass2:
      return std::make_unique<LinearFilter>(LinearFilter::low_pass_2(spec.frequency, spec.damping, spec.period));
    case SignalKind::kNotch:
      return std::make_unique<LinearFilter>(LinearFilter::notch(spec.frequency, spec.damping, spec.period));
    case SignalKind::kRateLimit: return std::make_unique<RateLimit>(spec.max_rate);
    case SignalKind::kSaturation: return std::make_unique<Saturation>(spec.min, spec.max);
    case SignalKind::kTable: {
      const auto [x, y] = columns_of(spec.points);
      return std::make_unique<LookupTable>(x, y);
    }
    case SignalKind::kTable2: return build_table2(spec);
    case SignalKind::kFuzzy: return std::make_unique<FuzzyBlock>(read_fll(spec.file), spec.inputs.size(), spec.output);
    case SignalKind::kFmu: break;     // add_foreign
    case SignalKind::kPython: break;  // likewise
    case SignalKind::kHost: break;    // its place is all of it
  }
  FOOTFALL_DEMAND(false);
}

SignalNode node_of(const Scene& scene, const SignalSpec& spec, int place) {
  SignalNode node{spec.name, build(spec), {}, spec.states, spec.initial, spec.period, place};
  const auto add = [&](const std::string& key, const std::string& input) {
    node.inputs.push_back(input);
    node.written_at.push_back(place_of(scene.file, spec.source, key));
  };
  if (spec.kind == SignalKind::kFuzzy) {
    for (const std::string& input : spec.inputs) add("inputs", input);
    return node;
  }
  add("input", spec.input);
  if (!spec.input2.empty()) add("input2", spec.input2);
  if (!spec.rate.empty()) add("rate", spec.rate);
  return node;
}

// ---- programs of the user ----

// The program and its task (inputs/scripts/signal_host.py, programs/footfall_fmu_host.cpp).
void set_program(const SignalSpec& spec, ForeignProgram& program) {
  if (spec.kind == SignalKind::kPython) {
    program.command.words = {"python3", shipped_file("inputs/scripts/signal_host.py")};
    program.task = {spec.file, spec.function, spec.stateless ? "1" : "0", std::to_string(spec.inputs.size())};
    return;
  }
  program.command.words = {fmu_host().empty() ? "footfall_fmu_host" : fmu_host(), "run"};
  program.task = {spec.file};
  for (const std::string& name : spec.input_names) program.task.insert(program.task.end(), {"input", name});
  for (const std::string& name : spec.outputs) program.task.insert(program.task.end(), {"output", name});
  for (const auto& [name, value] : spec.start) program.task.insert(program.task.end(), {"start", name, value});
}

// The node that leads the program, and one per output that reads it.
void add_foreign(const Scene& scene, const SignalSpec& spec, std::size_t index, Mechanism& mechanism) {
  ForeignProgram program;
  program.label = "signal \"" + spec.name + "\" (" + spec.file + ")";
  set_program(spec, program);
  program.limit = spec.time_limit;
  program.inputs = static_cast<int>(spec.inputs.size());
  const bool script = spec.kind == SignalKind::kPython;
  program.outputs = script ? 1 : static_cast<int>(spec.outputs.size());
  program.output_names = script ? std::vector<std::string>{spec.function} : spec.outputs;
  program.period = spec.period;
  program.end = scene.end_time;
  const auto function = std::make_shared<ForeignFunction>(std::move(program));
  SignalNode leader{spec.name,
                    std::make_unique<ForeignBlock>(function, script),
                    spec.inputs,
                    spec.states,
                    {},
                    spec.period,
                    mechanism.signals[index].place};
  leader.inputs.push_back("time");
  leader.written_at.assign(leader.inputs.size(), place_of(scene.file, spec.source, "inputs"));
  mechanism.sampled.push_back(std::move(leader));
  const std::vector<std::string> names = spec.output_signals();
  for (std::size_t i = 0; i < names.size(); ++i)
    mechanism.sampled.push_back({names[i],
                                 std::make_unique<ForeignOutput>(function, static_cast<int>(i)),
                                 {"signal." + spec.name},
                                 spec.states,
                                 {},
                                 spec.period,
                                 signal_place(mechanism, names[i])});
}

// A name of the form "OWNER.what".
bool is(const std::string& name, const std::string& owner, const std::string& what) {
  return name.size() == owner.size() + 1 + what.size() && name.compare(0, owner.size(), owner) == 0 &&
         name[owner.size()] == '.' && name.compare(owner.size() + 1, what.size(), what) == 0;
}

// OWNER of "OWNER.what": `what` has no dots.
std::string owner_in(const std::string& name) { return name.substr(0, name.rfind('.')); }

constexpr const char* kAccelerations[] = {"ax", "ay", "az"};

std::unique_ptr<Sensor> body_sensor(const Model& model, const std::string& name) {
  const std::optional<int> body = model.find_body(owner_in(name));
  if (!body) return nullptr;
  const auto find = [&](const auto& entries) -> std::unique_ptr<Sensor> {
    for (const auto& entry : entries) {
      const std::string what = std::string(entry.pattern).substr(std::string("<body>.").size());
      const bool position =
          std::find(std::begin(kAccelerations), std::end(kAccelerations), what) == std::end(kAccelerations);
      if (position && is(name, model.body(*body).name(), what)) return std::make_unique<BodySensor>(*body, entry.value);
    }
    return nullptr;
  };
  if (auto sensor = find(kBodyEntries)) return sensor;
  return find(kAttitudeEntries);
}

std::vector<std::string> continuous_names(const Mechanism& mechanism) {
  std::vector<std::string> names = {"time"};
  for (const PlaceEntry& entry : mechanism.signals) names.push_back("signal." + entry.name);
  for (const CoordinateEntry& entry : mechanism.coordinates)
    names.push_back(concat(entry.name, ".", name_of(entry.coordinate)));
  for (int i = 0; i < mechanism.model.body_count(); ++i) names.push_back(mechanism.model.body(i).name() + ".z");
  for (const StrutEntry& entry : mechanism.struts) names.push_back(entry.name + ".stroke");
  for (const CableEntry& entry : mechanism.cables) names.push_back(entry.name + ".force");
  return names;
}

void add_continuous(const Scene& scene, SignalChain chain, Mechanism& mechanism) {
  std::vector<SignalSource> sources;
  std::vector<std::unique_ptr<Sensor>> sensors;
  for (const std::string& name : chain.names()) {
    if (const std::optional<SignalSource> source = signal_source(mechanism, name)) {
      sources.push_back(*source);
      continue;
    }
    std::unique_ptr<Sensor> sensor = sensor_of(mechanism, name);
    if (!sensor)
      throw InputError(
          code::kNotContinuous, where_read(scene, name), "a continuous signal cannot read \"", name,
          "\", expected time, positions and velocities of bodies, joints and struts, cables, or other signals. For "
          "accelerations, forces and contacts give the signal a period, for example period_ms = 1.",
          known_names("names", name, continuous_names(mechanism)));
    sources.push_back({SignalSource::Kind::kSensor, sensors.size()});
    sensors.push_back(std::move(sensor));
  }
  mechanism.model.set_signals(
      std::make_shared<const ContinuousSignals>(std::move(chain), std::move(sources), std::move(sensors)));
}

}  // namespace

void add_controllers(const Scene& scene, Mechanism& mechanism) {
  for (const ControllerSpec& spec : scene.controllers) {
    const int outputs = static_cast<int>(spec.outputs.size());
    ControllerEntry entry;
    entry.name = spec.name;
    entry.controller = build(spec, outputs, mechanism.warnings);
    if (entry.controller->output_count() != outputs)
      throw InputError(code::kOutputCount, place_of(scene.file, spec.source, "outputs"), "contains ", outputs,
                       " names, expected ", entry.controller->output_count(), ", the outputs of the controller");
    entry.body = scene.body_index(spec.body);
    entry.touchdown_acceleration = spec.touchdown_acceleration;
    entry.touchdown_delay = spec.touchdown_delay;
    if (spec.touchdown_acceleration == 0.0 || spec.kind == ControllerKind::kConstant)
      entry.wakes_at = -std::numeric_limits<double>::infinity();
    entry.outputs = spec.outputs;
    for (int k = 0; k < outputs; ++k) {
      const int place = add_input(mechanism, 0.0);
      if (k == 0) entry.first_input = place;
    }
    entry.struts.assign(outputs, -1);
    for (std::size_t i = 0; i < scene.struts.size(); ++i)
      for (std::size_t k = 0; k < spec.outputs.size(); ++k)
        if (scene.struts[i].mr && scene.struts[i].mr->controller == spec.name + "." + spec.outputs[k])
          entry.struts[k] = static_cast<int>(i);
    mechanism.controllers.push_back(std::move(entry));
  }
}

std::unique_ptr<Sensor> sensor_of(const Mechanism& mechanism, const std::string& name) {
  const Model& model = mechanism.model;
  if (auto sensor = body_sensor(model, name)) return sensor;
  const std::string owner = owner_in(name);
  const std::vector<CoordinateEntry>& coordinates = mechanism.coordinates;  // of a joint one after the other
  std::size_t i = mechanism.coordinate_index.find(coordinates, owner).value_or(coordinates.size());
  for (; i < coordinates.size() && coordinates[i].name == owner; ++i) {
    const CoordinateEntry& entry = coordinates[i];
    const std::string coordinate(name_of(entry.coordinate));
    const Joint& joint = model.joint(entry.joint);
    if (is(name, entry.name, coordinate)) return std::make_unique<CoordinateSensor>(joint, entry.coordinate);
    if (is(name, entry.name, coordinate + "_rate"))
      return std::make_unique<CoordinateRateSensor>(joint, entry.coordinate);
  }
  if (const std::optional<std::size_t> found = mechanism.strut_index.find(mechanism.struts, owner)) {
    const StrutEntry& entry = mechanism.struts[*found];
    const Strut& strut = entry.force.of(model);
    if (is(name, entry.name, "stroke")) return std::make_unique<StrutSensor>(strut, StrutSensor::Reads::kStroke);
    if (is(name, entry.name, "rate")) return std::make_unique<StrutSensor>(strut, StrutSensor::Reads::kRate);
  }
  for (const CableEntry& entry : mechanism.cables)
    if (entry.name == owner)
      for (const auto& column : kCableEntries)
        if (is(name, owner, std::string(column.pattern).substr(std::string("<cable>.").size())))
          return std::make_unique<CableSensor>(entry.force.of(model), entry.force.index(), column.value);
  return nullptr;
}

std::optional<SignalSource> signal_source(const Mechanism& mechanism, const std::string& name) {
  using Kind = SignalSource::Kind;
  if (name == "time") return SignalSource{Kind::kTime, 0};
  if (name == "state.since" && mechanism.state_since >= 0)
    return SignalSource{Kind::kSince, static_cast<std::size_t>(mechanism.state_since)};
  const auto place_in = [&](const std::string& prefix, const std::vector<PlaceEntry>& entries,
                            const NameIndex& index) -> std::optional<SignalSource> {
    if (name.rfind(prefix, 0) != 0) return std::nullopt;
    const std::optional<std::size_t> found = index.find(entries, name.substr(prefix.size()));
    if (!found) return std::nullopt;
    return SignalSource{Kind::kPlace, static_cast<std::size_t>(entries[*found].place)};
  };
  if (const auto source = place_in("signal.", mechanism.signals, mechanism.signal_index)) return source;
  if (const auto source = place_in("state.", mechanism.states, mechanism.state_index)) return source;
  for (const ControllerEntry& entry : mechanism.controllers)
    for (std::size_t k = 0; k < entry.outputs.size(); ++k)
      if (is(name, entry.name, entry.outputs[k]))
        return SignalSource{Kind::kPlace, static_cast<std::size_t>(entry.first_input) + k};
  return std::nullopt;
}

int signal_place(const Mechanism& mechanism, const std::string& name) {
  if (name.empty()) return -1;
  const std::optional<std::size_t> found = mechanism.signal_index.find(mechanism.signals, name);
  FOOTFALL_DEMAND(found.has_value());  // the scene is checked
  return mechanism.signals[*found].place;
}

std::string where_read(const Scene& scene, const std::string& name) {
  const auto reads = [&](const std::string& text) {
    if (text.empty()) return false;
    const std::vector<std::string> names = Expression::names_in(text);
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const SignalSpec& spec : scene.signals) {
    for (const auto& [key, text] : {std::pair("input", &spec.input), {"input2", &spec.input2}, {"rate", &spec.rate}})
      if (reads(*text)) return place_of(scene.file, spec.source, key);
    for (const std::string& input : spec.inputs)
      if (reads(input)) return place_of(scene.file, spec.source, "inputs");
  }
  for (const EventSpec& spec : scene.events)
    if (reads(spec.when)) return place_of(scene.file, spec.source, "when");
  return scene.file + ": ";
}

SignalChain chain_of_signals(const Scene& scene, std::vector<SignalNode> nodes) {
  try {
    return SignalChain(std::move(nodes));
  } catch (const InputError& error) {
    throw InputError(place_of(scene.file, scene.signals.front().source.line, "signals") + error.what());
  }
}

std::vector<SignalNode> conditions_of(const Scene& scene) {
  std::vector<SignalNode> nodes;
  for (const EventSpec& event : scene.events) {
    SignalNode node;
    node.name = event.name;
    node.block = std::make_unique<PassBlock>();
    node.inputs = {event.when};
    node.period = event.period;
    node.written_at = {place_of(scene.file, event.source, "when")};
    nodes.push_back(std::move(node));
  }
  return nodes;
}

void add_signal_places(const Scene& scene, Mechanism& mechanism) {
  for (const SignalSpec& spec : scene.signals)
    mechanism.signals.push_back(
        {spec.name, add_input(mechanism, spec.kind == SignalKind::kHost ? spec.initial.value_or(0.0) : 0.0)});
  for (const SignalSpec& spec : scene.signals)
    for (const std::string& name : spec.output_signals())
      mechanism.signals.push_back({name, add_input(mechanism, 0.0)});
  for (const StateSpec& spec : scene.states)
    mechanism.states.push_back({spec.name, add_input(mechanism, mechanism.states.empty() ? 1.0 : 0.0)});
  if (!scene.states.empty()) mechanism.state_since = add_input(mechanism, 0.0);
}

void add_signals(const Scene& scene, Mechanism& mechanism) {
  std::vector<SignalNode> continuous;
  for (std::size_t i = 0; i < scene.signals.size(); ++i) {
    const SignalSpec& spec = scene.signals[i];
    if (spec.is_foreign()) {
      add_foreign(scene, spec, i, mechanism);
      continue;
    }
    if (spec.kind == SignalKind::kHost) continue;
    try {
      (spec.period > 0.0 ? mechanism.sampled : continuous).push_back(node_of(scene, spec, mechanism.signals[i].place));
    } catch (const InputError& error) {
      throw InputError(place_of(scene.file, spec.source) + error.what());
    }
  }
  if (!continuous.empty()) add_continuous(scene, chain_of_signals(scene, std::move(continuous)), mechanism);
}

}  // namespace footfall
