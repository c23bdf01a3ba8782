#include "mbd_solver/run/observe/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/modal_body.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {

template <>
inline constexpr auto kFields<FlexibleFigures> = std::tuple{
    Field{"strain_energy", &FlexibleFigures::strain_energy}, Field{"deflection", &FlexibleFigures::deflection},
    Field{"von_mises", &FlexibleFigures::von_mises}, Field{"spin", &FlexibleFigures::spin}};

FlexibleBodies::FlexibleBodies(const Subject& subject) : model_(subject.mechanism.model) {
  for (int i = 0; i < model_.body_count(); ++i)
    if (model_.body(i).mode_count() > 0) bodies_.push_back(i);
  now_.resize(bodies_.size());
  peak_.resize(bodies_.size());
  const Scene& scene = subject.scene;
  for (const int i : bodies_) {
    const ModalBody& modal = *model_.body(i).modal();
    Watch watch;
    watch.lowest = lowest_frequency(modal);
    watch.extent = extent(modal);
    const std::string& material = scene.bodies[static_cast<std::size_t>(i)].material;
    if (!material.empty()) watch.yield_stress = scene.material(material).yield_stress;
    watch_.push_back(watch);
  }
}

void FlexibleBodies::visit(Archive& archive) {
  archive("now", now_);
  archive("peak", peak_);
  for (std::size_t k = 0; k < watch_.size(); ++k) {
    archive("spins", watch_[k].spins);
    archive("bends", watch_[k].bends);
    archive("yields", watch_[k].yields);
  }
  archive("warnings", warnings_);
}

int FlexibleBodies::find(int body) const {
  const auto found = std::find(bodies_.begin(), bodies_.end(), body);
  return found == bodies_.end() ? -1 : static_cast<int>(found - bodies_.begin());
}

const Body& FlexibleBodies::body(int k) const { return model_.body(bodies_[static_cast<std::size_t>(k)]); }

void FlexibleBodies::take(const Sample& sample) {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const Body& body = model_.body(bodies_[k]);
    const BodyKinematics& at = sample.kinematics.of(bodies_[k]);
    now_[k] = {body.inertia().strain_energy(at.a), largest_deflection(*body.modal(), at.a),
               von_mises(*body.modal(), at.a), at.w.norm() / watch_[k].lowest};
    peak_[k].strain_energy = std::max(peak_[k].strain_energy, now_[k].strain_energy);
    peak_[k].deflection = std::max(peak_[k].deflection, now_[k].deflection);
    peak_[k].von_mises = std::max(peak_[k].von_mises, now_[k].von_mises);
    peak_[k].spin = std::max(peak_[k].spin, now_[k].spin);
    warn(sample.state.time, static_cast<int>(k));
  }
}

void FlexibleBodies::warn(double time, int k) {
  Watch& watch = watch_[static_cast<std::size_t>(k)];
  const FlexibleFigures& now = this->now(k);
  const auto number = [](double x) { return number_text(x, 3); };
  const std::string where = "t = " + number(time) + " s: body " + body(k).name();
  const auto tell = [&](bool& told, const std::string& what) {
    told = true;
    warnings_.push_back(where + what);
  };
  if (!watch.spins && now.spin > kSpinRange)
    tell(watch.spins, " spins at " + number(now.spin) + " of its lowest elastic frequency (" + number(watch.lowest) +
                          " rad/s): beyond " + number(kSpinRange) +
                          " linear modes, which centrifugal tension does not stiffen, err by more than 1 %; divide the "
                          "body into several");
  if (!watch.bends && now.deflection > kDeflectionRange * watch.extent)
    tell(watch.bends, " bends by " + number(now.deflection) + " m, " + number(now.deflection / watch.extent) +
                          " of its extent: beyond " + number(kDeflectionRange) +
                          " linear modes err by more than 1 %; divide the body into several");
  if (!watch.yields && watch.yield_stress > 0.0 && now.von_mises > watch.yield_stress)
    tell(watch.yields, " has a von Mises stress of " + number(1e-6 * now.von_mises) +
                           " MPa, more than the yield stress of its material, " + number(1e-6 * watch.yield_stress) +
                           " MPa: it would stay bent, which elastic modes cannot show");
}

JointFigures::JointFigures(const Subject& subject)
    : subject_(subject),
      now_(subject.mechanism.coordinates.size()),
      acc_(now_.size(), 0.0),
      warned_(now_.size(), false),
      reactions_(subject.scene.output.reactions ? subject.scene.joints.size() : 0, Vector6d::Zero()) {}

void JointFigures::take(const Sample& sample) {
  const Model& model = subject_.mechanism.model;
  const double h = sample.state.time - time_;
  for (std::size_t k = 0; k < now_.size(); ++k) {
    const CoordinateEntry& entry = subject_.mechanism.coordinates[k];
    const Joint& joint = model.joint(entry.joint);
    const JointCoordinate at(entry.coordinate, sample.kinematics.pair(joint.m1.body, joint.m2.body), joint.m1,
                             joint.m2);
    if (started_ && entry.coordinate == Coordinate::kAngle) {
      follow(k, h, at);
    } else {
      now_[k].value = at.value();
    }
    now_[k].rate = at.rate();
    acc_[k] = at.acc();
  }
  const Eigen::Ref<const Eigen::VectorXd> lambda = sample.rates.tail(subject_.layout.row_count);
  for (std::size_t j = 0; j < reactions_.size(); ++j) {
    const Joint& joint = model.joint(static_cast<int>(j));
    reactions_[j] =
        joint_wrench(joint, sample.kinematics.pair(joint.m1.body, joint.m2.body), sample.state.time,
                     lambda.segment(subject_.layout.joint_row[j], static_cast<Eigen::Index>(joint.rows.size())));
  }
  time_ = sample.state.time;
  started_ = true;
}

void JointFigures::follow(std::size_t k, double h, const JointCoordinate& at) {
  const double expected = now_[k].value + 0.5 * h * (now_[k].rate + at.rate()) + h * h / 12.0 * (acc_[k] - at.acc());
  now_[k].value = at.value() + 2.0 * kPi * std::round((expected - at.value()) / (2.0 * kPi));
  if (warned_[k] || std::abs(now_[k].value - expected) < 0.5 * kPi) return;
  warned_[k] = true;
  warnings_.push_back(
      "joint \"" + subject_.mechanism.coordinates[k].name + "\": between two rows, at t = " + number_text(time_, 6) +
      " s, it turns too unsteadily for its turns to be counted, and its angle may be off by whole turns; "
      "make output.interval smaller");
}

template <>
inline constexpr auto kFields<Figures> = std::tuple{
    Field{"peak_acceleration", &Figures::peak_acceleration}, Field{"max_descent", &Figures::max_descent},
    Field{"max_penetration", &Figures::max_penetration},     Field{"max_contact_force", &Figures::max_contact_force},
    Field{"reference_energy", &Figures::reference_energy},   Field{"energy_flow", &Figures::energy_flow},
    Field{"energy_balance", &Figures::energy_balance},       Field{"energy_noise", &Figures::energy_noise},
    Field{"contact_work", &Figures::contact_work},           Field{"contact_force", &Figures::contact_force}};

FigureTaker::FigureTaker(const Subject& subject)
    : subject_(subject),
      flow_(subject.mechanism.model),
      up_(up_direction(subject.scene.gravity)),
      normal_(up_),
      ground_(subject.mechanism.placement.ground_height) {
  const GroundSpec& ground = subject.scene.ground;
  if (ground.kind == GroundKind::kPlane) {
    normal_ = ground.plane->normal;
    ground_ = normal_.dot(ground.plane->point);
  }
  const Model& model = subject.mechanism.model;
  for (int i = 1; i < model.body_count(); ++i)
    if (model.body(i).mass() > model.body(body_).mass()) body_ = i;
}

void FigureTaker::visit(Archive& archive) {
  archive("figures", figures_);
  archive("flow", flow_);
  archive("start_height", start_height_);
  archive("start_energy", start_energy_);
  archive("started", started_);
}

const std::string& FigureTaker::body_name() const { return subject_.mechanism.model.body(body_).name(); }

std::string FigureTaker::balance_warning() const {
  if (figures_.energy_balance_relative() <= kGoodBalance || figures_.energy_balance <= figures_.energy_noise) return "";
  return "the energy of the mechanism does not close by " + number_text(figures_.energy_balance, 3) + " J, " +
         number_text(100.0 * figures_.energy_balance_relative(), 3) +
         " % of the energy that it moved: its integration is not accurate; make solver.rtol and solver.atol, or "
         "solver.max_step, smaller";
}

double FigureTaker::depth(const Sample& sample) const {
  double lowest = std::numeric_limits<double>::infinity();
  for (const BodyBoundary& entry : subject_.mechanism.boundaries) {
    const BodyKinematics& body = sample.kinematics.of(entry.body);
    lowest = std::min(lowest, normal_.dot(body.r) + lowest_place(entry, body.A.transpose() * normal_, body.a));
  }
  return ground_ - lowest;
}

void FigureTaker::take(const Sample& sample) {
  Figures& f = figures_;
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
  f.peak_acceleration = std::max(f.peak_acceleration, body.ddr.norm());
  f.max_descent = std::max(f.max_descent, start_height_ - height);
  Eigen::Vector3d total = Eigen::Vector3d::Zero();
  for (const GeneralizedForce& contact : sample.contact) {
    f.max_contact_force = std::max(f.max_contact_force, contact.F_W.norm());
    total += contact.F_W;
  }
  f.contact_force = total.norm();
  if (subject_.scene.ground.kind != GroundKind::kNone) f.max_penetration = std::max(f.max_penetration, depth(sample));
  flow_.sample(stored, sample.state, sample.kinematics);
  f.energy_flow = flow_.scale();
  const double balance =
      stored.total() - start_energy_ + sample.state.dissipated.total() - f.contact_work - sample.state.supplied.total();
  f.energy_balance = std::max(f.energy_balance, std::abs(balance));
  // A mechanism at rest moves no energy, but its places are known to atol only.
  const Model& model = subject_.mechanism.model;
  double forces = sample.rates.tail(subject_.layout.row_count).lpNorm<1>();
  for (int i = 0; i < model.body_count(); ++i) forces += model.body(i).mass() * subject_.scene.gravity.norm();
  f.energy_noise = std::max(f.energy_noise, subject_.scene.solver.atol_position() * forces);
}

}  // namespace footfall
