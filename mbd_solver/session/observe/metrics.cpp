// Metrics are updated at every sample and stored with a checkpoint. Warnings are given once per body, joint and cause.

#include "mbd_solver/session/observe/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/assemble/codes.h"
#include "mbd_solver/model/elements/cable.h"
#include "mbd_solver/model/rotation.h"
#include "mbd_solver/scene/resolve.h"
#include "mbd_solver/session/codes.h"

namespace footfall {
namespace {

constexpr std::size_t kMostNamed = 6;  // bodies

}  // namespace

void UnheldBodies::Depth::visit(Archive& archive) {
  archive("start", start);
  archive("largest", largest);
  archive("time", time);
}

UnheldBodies::UnheldBodies(const Subject& subject) {
  const Scene& scene = subject.scene;
  if (!scene.ground.is_flat()) return;
  ground_ = ground_level(subject);
  for (const BodySpec& spec : scene.bodies) {
    std::optional<UnheldShape> shape = unheld_shape(scene, spec);
    if (!shape) continue;
    Watched watched{scene.body_index(spec.name), spec.name, shape->size, std::move(shape->outline)};
    const std::vector<HullEntry>& hulls = subject.mechanism.hulls;
    watched.held =
        std::any_of(hulls.begin(), hulls.end(), [&](const HullEntry& hull) { return hull.body == watched.body; });
    watched_.push_back(std::move(watched));
  }
  depths_.resize(watched_.size());
}

// The outline of each shape against the surface, row by row.
void UnheldBodies::update(const Sample& sample) {
  for (std::size_t k = 0; k < watched_.size(); ++k) {
    const Watched& watched = watched_[k];
    Depth& depth = depths_[k];
    const BodyKinematics& body = sample.kinematics.of(watched.body);
    const bool first = depth.start < 0.0;
    if (first) depth.start = 0.0;
    if (ground_->above(body.r) > watched.size) continue;
    double deepest = 0.0;
    for (const Eigen::Vector3d& p : watched.outline) deepest = std::max(deepest, -ground_->above(body.r + body.A * p));
    if (first) depth.start = deepest;
    if (deepest <= depth.largest) continue;
    depth.largest = deepest;
    depth.time = sample.state.time;
  }
}

std::string UnheldBodies::warning() const {
  std::vector<std::size_t> through;
  for (std::size_t k = 0; k < watched_.size(); ++k)
    if (depths_[k].largest - std::max(0.0, depths_[k].start) > kHullDepth * watched_[k].size) through.push_back(k);
  if (through.empty()) return "";
  std::stable_sort(through.begin(), through.end(),
                   [&](std::size_t a, std::size_t b) { return depths_[a].largest > depths_[b].largest; });
  std::vector<std::string> others;
  for (std::size_t i = 1; i < std::min(through.size(), kMostNamed); ++i) others.push_back(watched_[through[i]].name);
  const std::size_t more = through.size() > kMostNamed ? through.size() - kMostNamed : 0;
  const Depth& depth = depths_[through[0]];
  const std::string& name = watched_[through[0]].name;
  const bool held = watched_[through[0]].held;
  return with_code(code::kThroughGround,
                   "body " + name + " went " + number_text(depth.largest, 3) +
                       " m below the surface of the ground, at t = " + number_text(depth.time, 3) + " s" +
                       (others.empty() ? "" : " (others: " + joined(others)) +
                       (more > 0 ? " and " + std::to_string(more) + " more" : "") + (others.empty() ? "" : ")") +
                       ": it has no boundary, so the ground " +
                       (held ? "holds only a coarse surface of its shape, 5 % of its size lower" : "does not hold it") +
                       "; add  [[boundaries]] body = \"" + name + "\", surface = {}  or judge the run until then only");
}

template <>
inline constexpr auto kFields<FlexibleMetrics> =
    kFieldsOf<&FlexibleMetrics::strain_energy, &FlexibleMetrics::deflection, &FlexibleMetrics::von_mises,
              &FlexibleMetrics::spin>;

FlexibleBodies::FlexibleBodies(const Subject& subject) : model_(subject.mechanism.model) {
  for (int i = 0; i < model_.body_count(); ++i)
    if (model_.body(i).mode_count() > 0) bodies_.push_back(i);
  now_.resize(bodies_.size());
  peak_.resize(bodies_.size());
  const Scene& scene = subject.scene;
  for (const int i : bodies_) {
    const ModalBody& modal = *model_.body(i).modal();
    stresses_.emplace_back(modal);
    Limits limits;
    limits.lowest = lowest_frequency(modal);
    limits.extent = extent(modal);
    const std::string& material = scene.bodies[i].material;
    if (!material.empty()) limits.yield_stress = scene.material(material).yield_stress;
    limits_.push_back(limits);
  }
}

void FlexibleBodies::visit(Archive& archive) {
  archive("now", now_);
  archive("peak", peak_);
  for (std::size_t k = 0; k < limits_.size(); ++k) {
    archive("spins", limits_[k].spins);
    archive("bends", limits_[k].bends);
    archive("yields", limits_[k].yields);
  }
  archive("warnings", warnings_);
}

int FlexibleBodies::find(int body) const {
  const auto found = std::find(bodies_.begin(), bodies_.end(), body);
  return found == bodies_.end() ? -1 : static_cast<int>(found - bodies_.begin());
}

const Body& FlexibleBodies::body(int k) const { return model_.body(bodies_[k]); }

void FlexibleBodies::update(const Sample& sample) {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const Body& body = model_.body(bodies_[k]);
    const BodyKinematics& at = sample.kinematics.of(bodies_[k]);
    now_[k] = {body.inertia().strain_energy(at.a), largest_deflection(*body.modal(), at.a), stresses_[k].at(at.a),
               at.w.norm() / limits_[k].lowest};
    peak_[k].strain_energy = std::max(peak_[k].strain_energy, now_[k].strain_energy);
    peak_[k].deflection = std::max(peak_[k].deflection, now_[k].deflection);
    peak_[k].von_mises = std::max(peak_[k].von_mises, now_[k].von_mises);
    peak_[k].spin = std::max(peak_[k].spin, now_[k].spin);
    warn(sample.state.time, static_cast<int>(k));
  }
}

void FlexibleBodies::warn(double time, int k) {
  Limits& limits = limits_[k];
  const FlexibleMetrics& now = this->now(k);
  const auto number = [](double x) { return number_text(x, 3); };
  const std::string where = "t = " + number(time) + " s: body " + body(k).name();
  const auto warn = [&](bool& warned, const MessageCode& code, const std::string& what) {
    warned = true;
    warnings_.push_back(with_code(code, where + what));
  };
  if (!limits.spins && now.spin > kSpinRange)
    warn(limits.spins, code::kBeyondLinearRange,
         " spins at " + number(now.spin) + " of its lowest elastic frequency (" + number(limits.lowest) +
             " rad/s): above " + number(kSpinRange) +
             " linear modes, which centrifugal tension does not stiffen, err by more than 1 %; divide the body into "
             "several");
  if (!limits.bends && now.deflection > kDeflectionRange * limits.extent)
    warn(limits.bends, code::kBeyondLinearRange,
         " bends by " + number(now.deflection) + " m, " + number(now.deflection / limits.extent) +
             " of its extent: above " + number(kDeflectionRange) +
             " linear modes err by more than 1 %; divide the body into several");
  if (!limits.yields && limits.yield_stress > 0.0 && now.von_mises > limits.yield_stress)
    warn(limits.yields, code::kYields,
         " has a von Mises stress of " + number(1e-6 * now.von_mises) +
             " MPa, above the yield stress of its material (" + number(1e-6 * limits.yield_stress) +
             " MPa): it would deform permanently, which elastic modes do not model");
}

JointObserver::JointObserver(const Subject& subject)
    : subject_(subject),
      now_(subject.mechanism.coordinates.size()),
      reactions_(subject.scene.output.reactions ? subject.scene.joints.size() : 0, Vector6d::Zero()) {}

void JointObserver::update(const Sample& sample) {
  const Model& model = subject_.mechanism.model;
  for (std::size_t k = 0; k < now_.size(); ++k) {
    const CoordinateEntry& entry = subject_.mechanism.coordinates[k];
    const Joint& joint = model.joint(entry.joint);
    const JointCoordinate at(entry.coordinate, sample.kinematics.pair(joint.m1.body, joint.m2.body), joint.m1,
                             joint.m2);
    const int angle = entry.coordinate == Coordinate::kAngle ? subject_.layout.joint_angle[entry.joint] : -1;
    now_[k] = {angle >= 0 ? nearest_turn(at.value(), sample.state.angles[angle]) : at.value(), at.rate()};
  }
  const Eigen::Ref<const Eigen::VectorXd> lambda = sample.rates.tail(subject_.layout.row_count);
  for (std::size_t j = 0; j < reactions_.size(); ++j) {
    const Joint& joint = model.joint(static_cast<int>(j));
    reactions_[j] =
        joint_wrench(joint, sample.kinematics.pair(joint.m1.body, joint.m2.body), sample.state.time,
                     lambda.segment(subject_.layout.joint_row[j], static_cast<Eigen::Index>(joint.rows.size())));
  }
  const int uncertain = sample.state.uncertain_angle;
  if (uncertain < 0 || !warnings_.empty()) return;
  warnings_.push_back(with_code(
      code::kTurnsNotCounted,
      "joint \"" + model.joint(uncertain).name + "\": by t = " + number_text(sample.state.time, 6) +
          " s it turned too fast in one integration step for its turns to be counted; angles may be off by whole "
          "turns: reduce solver.max_step"));
}

GripWatch::GripWatch(const Subject& subject) : subject_(subject) {
  for (const GripEntry& grip : subject.mechanism.grips) told_.push_back(grip.wrap < -kLeastWrap ? 1 : 0);
}

void GripWatch::update(const Sample& sample) {
  for (std::size_t k = 0; k < told_.size(); ++k) {
    if (told_[k] != 0) continue;
    const GripEntry& grip = subject_.mechanism.grips[k];
    const CableSample before = sample_of(grip.before, subject_, sample),
                      after = sample_of(grip.after, subject_, sample);
    const double wrap = grip.wrap + after.first - before.last, tension = std::max(before.force, after.force);
    if (!(wrap < -kLeastWrap && tension > 0.0)) continue;
    told_[k] = 1;
    warnings_.push_back(with_code(
        code::kGripWithoutWrap,
        "t = " + number_text(sample.state.time, 6) + " s: " + grip.name +
            ": the cable would leave this pulley with a tension of " + number_text(tension, 3) +
            " N, but grip = true holds it there: motion and tensions are wrong from here on. Remove grip, so that the "
            "cable slides over the pulley and leaves it, or place the pulley so that the cable stays on it"));
  }
}

template <>
inline constexpr auto kFields<Metrics> =
    kFieldsOf<&Metrics::peak_acceleration, &Metrics::max_descent, &Metrics::max_penetration,
              &Metrics::max_contact_force, &Metrics::reference_energy, &Metrics::energy_flow, &Metrics::energy_balance,
              &Metrics::energy_noise, &Metrics::contact_work, &Metrics::contact_force, &Metrics::work_error,
              &Metrics::work_size>;

namespace {

constexpr double kSmallPart = 0.05;  // of the flow: smaller integrals are judged by the flow
// A power is a product of a force and a velocity, each with the relative error of the state, the root mean square over all
// coordinates: the error of a single coordinate is larger. An embedded rule sees what its own nodes show.
constexpr double kPowerOfState = 6.0, kRule = 3.0;

// The largest size of each so far.
void raise(const WorkError& now, WorkError& largest) {
  for (std::size_t k = 0; k < now.dissipated.by_kind.size(); ++k)
    largest.dissipated.by_kind[k] = std::max(largest.dissipated.by_kind[k], std::abs(now.dissipated.by_kind[k]));
  for (std::size_t k = 0; k < now.supplied.by_kind.size(); ++k)
    largest.supplied.by_kind[k] = std::max(largest.supplied.by_kind[k], std::abs(now.supplied.by_kind[k]));
  if (largest.load_work.size() == 0) largest.load_work.setZero(now.load_work.size());
  largest.load_work = largest.load_work.cwiseMax(now.load_work.cwiseAbs());
  largest.scale = std::max(largest.scale, now.scale);
}

}  // namespace

// What dissipates has the sign of its power; of work only the integral of all sizes is known, and what is missing in the balance is
// an error of work.
std::vector<WorkEstimate> work_estimates(const Metrics& metrics, double state_error) {
  const WorkError &error = metrics.work_error, &size = metrics.work_size;
  std::vector<WorkEstimate> out;
  double imbalance = 0.0;  // [J]
  const auto add = [&](const std::string& column, double of_rule, double largest, double powers) {
    if (powers > 0.0 && (largest > 0.0 || of_rule > 0.0))
      out.push_back({column, of_rule, kRule * of_rule + imbalance + kPowerOfState * state_error * powers, largest});
  };
  double work = size.scale;
  for (std::size_t k = 0; k < size.dissipated.by_kind.size(); ++k) {
    const double dissipated = size.dissipated.by_kind[k];
    add("dissipated." + std::string(name_of(static_cast<Dissipation>(k))), error.dissipated.by_kind[k], dissipated,
        dissipated);
    work -= dissipated;
  }
  imbalance = metrics.energy_balance;
  add("work.contact", error.load_work.sum(), size.load_work.sum(), work);
  for (std::size_t k = 0; k < size.supplied.by_kind.size(); ++k)
    add("work." + std::string(name_of(static_cast<Supply>(k))), error.supplied.by_kind[k], size.supplied.by_kind[k],
        work);
  return out;
}

double energy_balance_relative(const Metrics& metrics, const std::vector<WorkEstimate>& estimates) {
  double largest = metrics.energy_balance_relative();
  for (const WorkEstimate& estimate : estimates)
    largest = std::max(
        largest, kRule * estimate.rule /
                     (estimate.largest > kSmallPart * metrics.energy_flow ? estimate.largest : metrics.energy_flow));
  return largest;
}

MetricRecorder::MetricRecorder(const Subject& subject)
    : subject_(subject), unheld_(subject), flow_(subject.mechanism.model), up_(up_direction(subject.scene.gravity)) {
  const GroundLevel ground = ground_level(subject);
  normal_ = ground.normal;
  ground_ = ground.height;
  const std::shared_ptr<const Terrain> terrain =
      subject.scene.touches_particles() ? ground.terrain : subject.mechanism.terrain;
  if (terrain) terrain_ = std::make_unique<Terrain>(*terrain);
  const Model& model = subject.mechanism.model;
  for (int i = 1; i < model.body_count(); ++i)
    if (model.body(i).mass() > model.body(body_).mass()) body_ = i;
}

void MetricRecorder::visit(Archive& archive) {
  archive.members<&MetricRecorder::metrics_, &MetricRecorder::soil_speed_, &MetricRecorder::unheld_,
                  &MetricRecorder::flow_, &MetricRecorder::start_height_, &MetricRecorder::start_energy_,
                  &MetricRecorder::started_>(*this);
}

const std::string& MetricRecorder::body_name() const { return subject_.mechanism.model.body(body_).name(); }

std::string MetricRecorder::balance_warning() const {
  if (metrics_.energy_balance_relative() <= kGoodBalance || metrics_.energy_balance <= metrics_.energy_noise) return "";
  return with_code(code::kEnergyBalance,
                   "the energy balance of the mechanism has an error of " + number_text(metrics_.energy_balance, 3) +
                       " J, " + number_text(100.0 * metrics_.energy_balance_relative(), 3) +
                       " % of the energy exchanged: its integration is not accurate; reduce solver.rtol and "
                       "solver.atol, or solver.max_step" +
                       std::string(subject_.mechanism.terrain && subject_.mechanism.terrain->parts().map
                                       ? "; where a body meets steps of the map, their edges begin and end to "
                                         "touch at some depth: a larger ground.plane.stiffness, or a smoother map"
                                       : ""));
}

std::string MetricRecorder::soil_warning() const {
  const GroundSpec& ground = subject_.scene.ground;
  if (ground.kind != GroundKind::kSoil) return "";
  std::vector<std::string> beyond;
  const auto compare = [&](const std::optional<double>& limit, const Peak& peak, const char* what, const char* unit) {
    if (!limit || peak.value <= *limit) return;
    beyond.push_back(number_text(peak.value, 3) + unit + what + " at t = " + number_text(peak.time, 3) +
                     " s, fitted up to " + number_text(*limit, 3) + unit);
  };
  compare(ground.law->fitted_speed, soil_speed_, " into the soil", " m/s");
  compare(ground.law->fitted_depth, metrics_.max_penetration, " deep", " m");
  if (beyond.empty()) return "";
  return with_code(code::kBeyondSoil,
                   "the run leaves the range for which the numbers of the soil hold: " + joined(beyond) +
                       "; forces and depths there are extrapolated. Fit the soil for this range (footfall ground fit), "
                       "or use grains");
}

std::vector<std::string> MetricRecorder::warnings() const {
  std::vector<std::string> texts;
  for (const std::string& text : {unheld_.warning(), soil_warning(), balance_warning()})
    if (!text.empty()) texts.push_back(text);
  return texts;
}

double MetricRecorder::depth(const Sample& sample) const {
  const Mechanism& mechanism = subject_.mechanism;
  const Scene& scene = subject_.scene;
  const bool cut_bed = scene.touches_particles() && scene.ground.terrain;
  const auto in_ground = [&](int body) {  // its rocks
    return cut_bed && stands_still(scene, mechanism.model.body(body).name());
  };
  if (mechanism.terrain && (mechanism.has(ContactKind::kTerrain) || mechanism.has(ContactKind::kSoil))) {
    double deepest = 0.0;  // of places that touch
    for (const ContactEntry& entry : mechanism.contacts) {
      const ContactElement& contact = entry.force.of(mechanism.model);
      if (contact.kind() == ContactKind::kTerrain || contact.kind() == ContactKind::kSoil)
        deepest = std::max(deepest, contact.largest_overlap(element_input(subject_, sample, entry.force.index())));
    }
    return deepest;
  }
  if (terrain_) {  // grains: points of what does not belong to the ground, by the height over its tangent
    double deepest = 0.0;
    for (const BodyBoundary& entry : mechanism.boundaries) {
      const BodyKinematics& body = sample.kinematics.of(entry.body);
      if (in_ground(entry.body)) continue;
      for (const ContactPoint& point : entry.points) {
        Eigen::Vector3d s = point.marker.s0;
        if (point.marker.S.cols() > 0) s += point.marker.S * body.a;
        const Eigen::Vector3d p = body.r + body.A * s;
        const Terrain::Height ground = terrain_->at(p.x(), p.y());
        deepest = std::max(deepest, point.radius + (ground.h - p.z()) / std::sqrt(1.0 + ground.slope.squaredNorm()));
      }
    }
    return deepest;
  }
  double lowest = std::numeric_limits<double>::infinity();
  for (const BodyBoundary& entry : mechanism.boundaries) {
    const BodyKinematics& body = sample.kinematics.of(entry.body);
    if (in_ground(entry.body)) continue;
    lowest = std::min(lowest, normal_.dot(body.r) + lowest_place(entry, body.A.transpose() * normal_, body.a));
  }
  return ground_ - lowest;
}

void MetricRecorder::update_peaks(const Sample& sample) {
  Metrics& f = metrics_;
  const double time = sample.state.time;
  const BodyKinematics& body = sample.kinematics.of(body_);
  f.peak_acceleration.see(body.ddr.norm(), time);
  f.max_descent.see(start_height_ - up_.dot(body.r), time);
  for (const GeneralizedForce& contact : sample.contact) f.max_contact_force.see(contact.F_W.norm(), time);
  if (subject_.scene.ground.kind == GroundKind::kSoil)
    for (std::size_t k = 0; k < sample.contact.size(); ++k)
      if (!sample.contact[k].F_W.isZero(0.0))
        soil_speed_.see(-normal_.dot(sample.kinematics.of(static_cast<int>(k)).dr), time);
  if (subject_.scene.ground.kind != GroundKind::kNone) f.max_penetration.see(depth(sample), time);
}

void MetricRecorder::update(const Sample& sample) {
  unheld_.update(sample);
  Metrics& f = metrics_;
  const StoredEnergy& stored = sample.energy.stored;
  const BodyKinematics& body = sample.kinematics.of(body_);
  const double height = up_.dot(body.r);
  f.contact_work = sample.state.load_work.sum();
  if (!started_) {
    started_ = true;
    start_height_ = height;
    start_energy_ = stored.total();
    f.reference_energy = stored.total() - stored[Stored::kGravity];
  }
  f.reference_energy = std::max(f.reference_energy, stored[Stored::kKinetic]);
  update_peaks(sample);
  Eigen::Vector3d total = Eigen::Vector3d::Zero();
  for (const GeneralizedForce& contact : sample.contact) total += contact.F_W;
  f.contact_force = total.norm();
  flow_.sample(stored, sample.state, sample.kinematics);
  f.energy_flow = flow_.scale();
  const double balance =
      stored.total() - start_energy_ + sample.state.dissipated.total() - f.contact_work - sample.state.supplied.total();
  f.energy_balance = std::max({f.energy_balance, std::abs(balance), sample.state.work_error.total()});
  const State& state = sample.state;
  raise(state.work_error, f.work_error);
  raise({state.dissipated, state.load_work, state.supplied, state.work_error.scale}, f.work_size);
  // A mechanism at rest exchanges no energy, but its positions are known to atol only.
  const Model& model = subject_.mechanism.model;
  double forces = sample.rates.tail(subject_.layout.row_count).lpNorm<1>();
  for (int i = 0; i < model.body_count(); ++i) forces += model.body(i).mass() * subject_.scene.gravity.norm();
  f.energy_noise = std::max(f.energy_noise, subject_.scene.solver.atol_position() * forces);
}

}  // namespace footfall
