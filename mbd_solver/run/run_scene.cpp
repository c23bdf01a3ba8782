#include "mbd_solver/run/run_scene.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "coupler/base/errors.h"
#include "coupler/base/folder.h"
#include "coupler/base/pi.h"
#include "mbd_solver/observe/drawing.h"
#include "mbd_solver/observe/motion_record.h"
#include "mbd_solver/observe/observation.h"
#include "mbd_solver/output/history.h"
#include "mbd_solver/output/summary.h"
#include "mbd_solver/run/checkpoint.h"
#include "mbd_solver/run/progress.h"
#include "mbd_solver/scene/scene_json.h"

namespace footfall {
namespace {

using Json = nlohmann::ordered_json;

// What was constructed for this scene, and nothing else.
std::vector<std::string> active_parts(const Simulation& simulation) {
  const Mechanism& mechanism = simulation.mechanism();
  std::vector<std::string> active = {"bodies"};
  bool flexible = false;
  for (int i = 0; i < mechanism.model.body_count(); ++i)
    flexible = flexible || mechanism.model.body(i).mode_count() > 0;
  if (flexible) active.push_back("flexible");
  if (mechanism.model.joint_count() > 0) active.push_back("joints");
  if (!mechanism.struts.empty()) active.push_back("struts");
  if (!mechanism.controllers.empty()) active.push_back("controllers");
  if (!mechanism.planes.empty()) active.push_back("plane");
  if (simulation.partner()) active.push_back("particles");
  return active;
}

Json summary_of(const Simulation& simulation, const FigureTaker& taker, const FlexibleBodies& flexible,
                const std::string& status, const std::string& reason) {
  const Figures& figures = taker.figures();
  const IntegratorStatistics& statistics = simulation.integrator().statistics();
  const RunTimes& times = simulation.times();
  Json json;
  json["status"] = status;
  if (!reason.empty()) json["reason"] = reason;
  json["end_time_s"] = simulation.state().time;
  json["observed_body"] = taker.body_name();
  json["peak_acceleration_g"] = figures.peak_acceleration / 9.80665;
  json["max_descent_m"] = figures.max_descent;
  json["max_penetration_m"] = figures.max_penetration;
  json["max_contact_force_N"] = figures.max_contact_force;
  json["reference_energy_J"] = figures.reference_energy;
  json["energy_balance_relative"] = figures.energy_balance_relative();
  json["drift_position"] = statistics.drift_position;
  json["drift_velocity"] = statistics.drift_velocity;
  json["drift_removed_position"] = statistics.removed_position;
  json["drift_removed_velocity"] = statistics.removed_velocity;
  for (int k = 0; k < flexible.count(); ++k) {
    Json& body = json["flexible_bodies"][flexible.body(k).name()];
    body["modes"] = flexible.body(k).mode_count();
    body["lowest_frequency_Hz"] = std::sqrt(flexible.body(k).modal()->stiffness.minCoeff()) / (2.0 * kPi);
    body["max_strain_energy_J"] = flexible.peak(k).strain_energy;
    body["max_deflection_m"] = flexible.peak(k).deflection;
    body["max_von_mises_Pa"] = flexible.peak(k).von_mises;
    body["max_spin_over_lowest_frequency"] = flexible.peak(k).spin;
  }
  Json warnings = Json::array();
  for (const std::string& text : simulation.mechanism().warnings) warnings.push_back(text);
  for (const std::string& text : simulation.assembly().notes) warnings.push_back(text);
  if (const CouplingWatch* watch = simulation.watch()) {
    json["coupling_energy_residual_relative"] =
        figures.reference_energy > 0.0 ? watch->largest_energy_residual() / figures.reference_energy : 0.0;
    json["max_overlap_over_radius"] = watch->largest_overlap();
    json["particles"] = simulation.particles();
    json["dt_dem_s"] = simulation.partner()->dt();
    if (const int n = simulation.partner()->substeps(); n > 0) {
      json["substeps_per_window"] = n;
    } else {
      json["substeps_per_window"] = "auto";
    }
    for (std::size_t i = 0; i < watch->names().size(); ++i)
      json["max_omega_h"][watch->names()[i]] = watch->largest_omega_h()[i];
    for (const std::string& text : watch->warnings()) warnings.push_back(text);
  }
  for (const std::string& text : flexible.warnings()) warnings.push_back(text);
  if (const std::string text = taker.balance_warning(); !text.empty()) warnings.push_back(text);
  json["steps"] = statistics.steps;
  json["windows"] = statistics.windows;
  json["rejected_steps"] = statistics.rejected;
  json["newton_failures"] = statistics.newton_failures;
  json["residuals"] = statistics.residuals;
  json["jacobians"] = statistics.jacobians;
  json["factorizations"] = statistics.factorizations;
  json["wall_s"] = times.total;
  json["dem_wall_s"] = times.dem;
  json["mbd_wall_s"] = times.mbd;
  json["control_wall_s"] = times.control;
  // What the exchange costs beyond the partner's own work.
  json["exchange_wall_s"] = std::max(0.0, times.waiting - times.dem);
  json["integrator"] = simulation.integrator().name();
  json["active"] = active_parts(simulation);
  json["warnings"] = warnings;
  json["versions"]["footfall"] = FOOTFALL_VERSION;
  json["scene_file"] = std::filesystem::absolute(simulation.scene().file).lexically_normal().string();
  json["settings"] = simulation.scene().settings;
  json["scene"] = Json::parse(scene_json(simulation.scene()));
  return json;
}

// True once per interval [s], at the first window end at or after each multiple of it; moves `next` on.
bool due(double time, double interval, double& next) {
  if (time < next - 1e-9 * interval) return false;
  next = (std::floor(time / interval + 1e-9) + 1.0) * interval;
  return true;
}

}  // namespace

int run_scene(const Scene& scene, const RunOptions& options, Transport* transport,
              const volatile std::sig_atomic_t& interrupted) {
  const double t_end = options.until > 0.0 ? std::min(options.until, scene.end_time) : scene.end_time;
  Simulation simulation(scene, t_end, transport);
  make_folder(options.out);
  const std::string folder = options.out + "/";
  for (const std::string& warning : simulation.mechanism().warnings)
    std::fprintf(stderr, "mbd_solver: warning: %s\n", warning.c_str());
  for (const std::string& note : simulation.assembly().notes)
    std::fprintf(stderr, "mbd_solver: note: %s\n", note.c_str());

  Observation observation(simulation);
  FigureTaker taker(simulation);
  HistoryWriter history(folder + "history.csv", observation.names(), observation.units());
  std::optional<MotionRecord> motion;
  if (simulation.partner()) motion.emplace(simulation, folder + "motion");
  std::optional<Drawing> drawing;
  VtkSeries pictures(options.out, "bodies");
  if (scene.output.vtk) drawing.emplace(simulation);
  Progress progress(t_end, options.quiet);
  std::size_t warned = 0, warned_of_bodies = 0;
  double next_row = 0.0, next_picture = 0.0, next_checkpoint = scene.output.checkpoint_interval;
  Eigen::VectorXd voltages;
  const auto observe = [&](const Sample& sample) {
    taker.take(sample);
    voltages = sample.inputs.voltages;
    if (due(sample.state.time, scene.output.interval, next_row) || simulation.finished())
      history.write(observation.row(sample));
    if (motion) motion->write(sample);
    if (drawing && due(sample.state.time, scene.output.vtk_interval, next_picture))
      pictures.write(sample.state.time, drawing->frame(sample));
    if (scene.output.checkpoint_interval > 0.0 &&
        due(sample.state.time, scene.output.checkpoint_interval, next_checkpoint))
      write_checkpoint(folder + "checkpoint.txt", sample.state, simulation.mechanism(), voltages);
    progress.show(sample.state.time, sample.window, taker.figures().contact_force);
    for (; sample.coupling && warned < sample.coupling->warnings().size(); ++warned)
      std::fprintf(stderr, "\nmbd_solver: warning: %s\n", sample.coupling->warnings()[warned].c_str());
    for (const auto& texts = observation.flexible().warnings(); warned_of_bodies < texts.size(); ++warned_of_bodies)
      std::fprintf(stderr, "\nmbd_solver: warning: %s\n", texts[warned_of_bodies].c_str());
  };

  try {
    simulation.run(observe, interrupted);
  } catch (const std::exception& error) {
    progress.finish();
    history.flush();
    if (motion) motion->flush();
    const bool mendable = dynamic_cast<const InputError*>(&error) || dynamic_cast<const ProtocolError*>(&error);
    if (simulation.partner()) simulation.partner()->fail(error.what(), mendable ? Status::kBadInput : Status::kFailed);
    if (simulation.state().q.allFinite() && simulation.state().v.allFinite())
      write_checkpoint(folder + "checkpoint.txt", simulation.state(), simulation.mechanism(), voltages);
    write_summary(folder + "summary.json",
                  summary_of(simulation, taker, observation.flexible(), "failed", error.what()));
    throw;
  }
  progress.finish();
  history.flush();
  if (motion) motion->flush();
  if (const std::string text = taker.balance_warning(); !text.empty())
    std::fprintf(stderr, "mbd_solver: warning: %s\n", text.c_str());
  const bool done = simulation.finished();
  if (!done) {
    write_checkpoint(folder + "checkpoint.txt", simulation.state(), simulation.mechanism(), voltages);
    if (simulation.partner()) simulation.partner()->fail("interrupted by the user", Status::kInterrupted);
  }
  write_summary(folder + "summary.json",
                summary_of(simulation, taker, observation.flexible(), done ? "done" : "interrupted", ""));
  return done ? kExitDone : kExitInterrupted;
}

}  // namespace footfall
