#include "mbd_solver/observe/figures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupler/base/text.h"
#include "mbd_solver/model/up_direction.h"

namespace footfall {

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
  flow_.take(stored, sample.state, sample.kinematics);
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
