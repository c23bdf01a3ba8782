// Collects the values; keys are documented in docs/reference/summary.md.

#include "mbd_solver/session/run_summary.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/integrator/ida.h"
#include "mbd_solver/model/rotation.h"
#include "mbd_solver/scene/scene_schema.h"
#include "mbd_solver/session/output/summary.h"

namespace footfall {

std::array<std::vector<std::string>, RunWarnings::kLists> RunWarnings::lists() const {
  const CoupledRun* const coupled = simulation_.coupled();
  return {coupled != nullptr ? coupled->watch().warnings() : std::vector<std::string>(),
          observation_.flexible().warnings(),
          observation_.joints().warnings(),
          observation_.grips().warnings(),
          simulation_.time_warnings(),
          simulation_.signal_warnings()};
}

// Entries of the lists never change: counting them is enough to know what is new.
std::vector<std::string> RunWarnings::news() {
  std::vector<std::string> out;
  const auto all = lists();
  for (std::size_t i = 0; i < kLists; ++i)
    for (; told_[i] < all[i].size(); ++told_[i]) out.push_back(all[i][told_[i]]);
  return out;
}

std::vector<std::string> RunWarnings::all() const {
  std::vector<std::string> out;
  for (const std::vector<std::string>& list : lists()) out.insert(out.end(), list.begin(), list.end());
  const std::vector<std::string> last = at_end();
  out.insert(out.end(), last.begin(), last.end());
  return out;
}

std::vector<std::string> RunWarnings::at_end() const {
  const CoupledRun* const coupled = simulation_.coupled();
  std::vector<std::string> out = coupled != nullptr ? coupled->watch().conclusions() : std::vector<std::string>();
  const std::vector<std::string> extremes = metrics_.warnings();
  out.insert(out.end(), extremes.begin(), extremes.end());
  if (const std::string text = simulation_.integrator().warning(); !text.empty()) out.push_back(text);
  return out;
}

namespace {

using Json = nlohmann::ordered_json;

// Parts that were constructed for this scene.
std::vector<std::string> active_parts(const Simulation& simulation, const FlexibleBodies& flexible) {
  const Mechanism& mechanism = simulation.mechanism();
  std::vector<std::string> active = {"bodies"};
  if (flexible.count() > 0) active.push_back("flexible");
  if (mechanism.model.joint_count() > 0) active.push_back("joints");
  if (!mechanism.struts.empty()) active.push_back("struts");
  if (!mechanism.cables.empty()) active.push_back("cables");
  if (!mechanism.controllers.empty()) active.push_back("controllers");
  if (!mechanism.signals.empty()) active.push_back("signals");
  for (const ContactKind kind : every<ContactKind>())
    if (mechanism.has(kind) && active.back() != name_of(kind)) active.emplace_back(name_of(kind));
  if (simulation.coupled()) active.push_back("particles");
  return active;
}

void add_flexible_bodies(const FlexibleBodies& flexible, Json& json) {
  for (int k = 0; k < flexible.count(); ++k) {
    Json& body = json["flexible_bodies"][flexible.body(k).name()];
    body["modes"] = flexible.body(k).mode_count();
    body["lowest_frequency_Hz"] = std::sqrt(flexible.body(k).modal()->stiffness.minCoeff()) / (2.0 * kPi);
    if (const auto error = flexible.body(k).modal()->static_error) body["static_error"] = *error;
    body["max_strain_energy_J"] = flexible.peak(k).strain_energy;
    body["max_deflection_m"] = flexible.peak(k).deflection;
    body["max_von_mises_Pa"] = flexible.peak(k).von_mises;
    body["max_spin_over_lowest_frequency"] = flexible.peak(k).spin;
  }
}

void add_landing(const LandingWatch& landing, const std::vector<LandingPointSpec>& points, Json& json) {
  json["stability_distance_m"] = landing.least_distance().value;
  json["stability_distance_time_s"] = landing.least_distance().time;
  json["tip_energy_margin_J"] = landing.least_margin().value;
  json["tip_energy_margin_time_s"] = landing.least_margin().time;
  json["tipped"] = landing.tipped() ? 1 : 0;
  json["max_tilt_rad"] = landing.largest_tilt().value;
  json["max_tilt_time_s"] = landing.largest_tilt().time;
  json["final_tilt_rad"] = landing.now().tilt;
  json["slid_distance_m"] = landing.now().slid;
  for (std::size_t k = 0; k < points.size(); ++k) {
    json["clearance_" + points[k].name + "_m"] = landing.least_clearance(k).value;
    json["clearance_" + points[k].name + "_time_s"] = landing.least_clearance(k).time;
  }
  const std::vector<LandingWatch::First> contacts = landing.first_contacts(), stops = landing.struts_at_stops();
  json["pads_touched"] = contacts.size();
  json["struts_at_stops"] = stops.size();
  Json& told = json["landing"];
  told["base"] = landing.base();
  told["pads"] = landing.pads();
  for (const auto& [key, firsts] : {std::pair{"first_contacts", &contacts}, std::pair{"struts_at_stops", &stops}}) {
    told[key] = Json::array();
    for (const LandingWatch::First& first : *firsts)
      told[key].push_back({{"name", first.name}, {"time_s", first.time}});
  }
}

void add_coupling(const CoupledRun& coupled, double energy_flow, Json& json) {
  const CouplingWatch& watch = coupled.watch();
  json["coupling_energy_error_relative"] = energy_flow > 0.0 ? watch.largest_energy_residual() / energy_flow : 0.0;
  const CouplingWatch::Peak peak = watch.peak();
  json["max_step_force_N"] = peak.force;
  json["max_step_force_time_s"] = peak.time;
  json["max_overlap_over_radius"] = watch.largest_overlap();
  json["particles"] = coupled.load().particles;
  json["grains_lost"] = coupled.load().lost;
  json["grains_lost_kg"] = coupled.load().changes.lost_mass;
  if (const GrainChanges& bed = coupled.load().changes; bed.added > 0.0 || bed.removed > 0.0)
    json["bed"] = {{"grains_added", bed.added},
                   {"grains_removed", bed.removed},
                   {"mass_added_kg", bed.added_mass},
                   {"mass_removed_kg", bed.removed_mass}};
  json["dt_dem_s"] = coupled.agreement().dt;
  if (const int n = coupled.agreement().substeps; n > 0) {
    json["substeps_per_window"] = n;
  } else {
    json["substeps_per_window"] = "auto";
  }
  for (std::size_t i = 0; i < watch.body_count(); ++i) json["max_omega_h"][watch.name(i)] = watch.largest_omega_h(i);
}

// Into "warnings", or with the scene's reason into "accepted_warnings".
void add_warnings(const Simulation& simulation, const MetricRecorder& recorder, const Observation& observation,
                  Json& json) {
  const Scene& scene = simulation.scene();
  Json warnings = Json::array(), accepted = Json::array();
  const auto add = [&](const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
      if (const std::string* const reason = scene.accepted_reason(text))
        accepted.push_back({{"warning", text}, {"reason", *reason}});
      else
        warnings.push_back(text);
    }
  };
  add(simulation.mechanism().warnings);
  add(simulation.assembly().notes);
  add(simulation.time_warnings());
  add(simulation.signal_warnings());
  if (const CoupledRun* const coupled = simulation.coupled()) {
    add(coupled->watch().warnings());
    add(coupled->watch().conclusions());
  }
  add(observation.flexible().warnings());
  add(observation.joints().warnings());
  add(observation.grips().warnings());
  add(recorder.warnings());
  if (const std::string text = simulation.integrator().warning(); !text.empty()) add({text});
  json["warnings"] = warnings;
  if (!accepted.empty()) json["accepted_warnings"] = accepted;
}

void add_costs(const Simulation& simulation, Json& json) {
  const IntegratorStatistics& statistics = simulation.integrator().statistics();
  json["steps"] = statistics.steps;
  json["windows"] = statistics.windows;
  json["rejected_steps"] = statistics.rejected;
  json["newton_failures"] = statistics.newton_failures;
  json["residuals"] = statistics.residuals;
  json["jacobians"] = statistics.jacobians;
  json["factorizations"] = statistics.factorizations;
  const RunTimes& times = simulation.times();
  const CoupledRun* const coupled = simulation.coupled();
  json["wall_s"] = times.total;
  json["dem_wall_s"] = coupled ? coupled->times().dem : 0.0;
  json["waited_wall_s"] = coupled ? coupled->times().waited : 0.0;
  json["mbd_wall_s"] = times.mbd;
  json["mbd_beside_wall_s"] = times.overlapped + (coupled ? coupled->times().overlapped : 0.0);
  json["control_wall_s"] = times.control;
  json["checkpoint_wall_s"] = times.checkpoint;
  json["exchange_wall_s"] = coupled ? coupled->times().exchange : 0.0;
}

// A body at rest on an inclined plane creeps where friction_speed is given; no value where it slides.
void add_creep(const Scene& scene, Json& json) {
  if (scene.ground.kind != GroundKind::kPlane || scene.ground.is_uneven()) return;
  const PlaneSpec& plane = *scene.ground.plane;
  const double slope = std::acos(std::clamp(plane.normal.dot(up_direction(scene.gravity)), -1.0, 1.0));
  const double speed = creep_speed(plane.friction, plane.friction_speed.value_or(0.0), slope);
  if (std::isfinite(speed)) json["creep_speed_m_s"] = speed;
}

}  // namespace

Json run_summary(const Simulation& simulation, const MetricRecorder& recorder, const Observation& observation,
                 const std::string& status, const std::string& reason, const std::string& mpi_version) {
  const Metrics& metrics = recorder.metrics();
  const FlexibleBodies& flexible = observation.flexible();
  const IntegratorStatistics& statistics = simulation.integrator().statistics();
  Json json;
  json["status"] = status;
  if (!reason.empty()) json["reason"] = reason;
  json["end_time_s"] = simulation.state().time;
  json["observed_body"] = recorder.body_name();
  json["peak_acceleration_g"] = metrics.peak_acceleration.value / 9.80665;
  json["peak_acceleration_time_s"] = metrics.peak_acceleration.time;
  json["max_descent_m"] = metrics.max_descent.value;
  json["max_descent_time_s"] = metrics.max_descent.time;
  json["max_sinkage_m"] = metrics.max_penetration.value;
  json["max_sinkage_time_s"] = metrics.max_penetration.time;
  json["max_contact_force_N"] = metrics.max_contact_force.value;
  json["max_contact_force_time_s"] = metrics.max_contact_force.time;
  add_creep(simulation.scene(), json);
  if (const LandingWatch* const landing = observation.landing())
    add_landing(*landing, simulation.scene().landing->points, json);
  if (const LandingEnd* const end = observation.landing_end()) json["landing"]["ended"] = end->name();
  json["reference_energy_J"] = metrics.reference_energy;
  json["energy_flow_J"] = metrics.energy_flow;
  const std::vector<WorkEstimate> estimates =
      work_estimates(metrics, statistics.summed_error * simulation.scene().solver.rtol);
  json["energy_balance_relative"] = energy_balance_relative(metrics, estimates);
  Json& errors = json["work_errors_J"] = Json::object();
  for (const WorkEstimate& estimate : estimates) errors[estimate.column] = estimate.error;
  json["drift_position"] = statistics.drift_position;
  json["drift_velocity"] = statistics.drift_velocity;
  json["drift_removed_position"] = statistics.removed_position;
  json["drift_removed_velocity"] = statistics.removed_velocity;
  add_flexible_bodies(flexible, json);
  if (simulation.coupled()) add_coupling(*simulation.coupled(), metrics.energy_flow, json);
  add_costs(simulation, json);
  json["integrator"] = simulation.integrator().name();
  json["active"] = active_parts(simulation, flexible);
  add_warnings(simulation, recorder, observation, json);
  Json& versions = json["versions"];
  versions["footfall"] = FOOTFALL_VERSION;
  if (simulation.coupled()) versions["LIGGGHTS"] = simulation.coupled()->dem_version();
  if (!mpi_version.empty()) versions["MPI"] = mpi_version;
  versions["SUNDIALS"] = sundials_version();
  versions["compiler"] = compiler_version();
  json["machine"] = machine();
  json["scene_file"] = std::filesystem::absolute(simulation.scene().file).lexically_normal().string();
  json["settings"] = simulation.scene().settings;
  json["scene"] = Json::parse(scene_json(simulation.scene()));
  return json;
}

}  // namespace footfall
