#include "mbd_solver/observe/observation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "coupler/base/errors.h"
#include "mbd_solver/model/elements/strut.h"

namespace footfall {
namespace {

bool recorded(const OutputSpec& output, const std::string& body) {
  return output.bodies.empty() || std::find(output.bodies.begin(), output.bodies.end(), body) != output.bodies.end();
}

void push(const Eigen::Vector3d& x, std::vector<double>& row) { row.insert(row.end(), {x.x(), x.y(), x.z()}); }

// Roll, pitch, yaw of A = Rz(yaw) Ry(pitch) Rx(roll) [rad].
Eigen::Vector3d roll_pitch_yaw(const Eigen::Matrix3d& A) {
  return {std::atan2(A(2, 1), A(2, 2)), -std::asin(std::clamp(A(2, 0), -1.0, 1.0)), std::atan2(A(1, 0), A(0, 0))};
}

Eigen::Vector3d up_direction(const Eigen::Vector3d& gravity) {
  return gravity.norm() > 0.0 ? Eigen::Vector3d(-gravity.normalized()) : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
}

}  // namespace

void Observation::column(const std::string& name, const std::string& unit) {
  names_.push_back(name);
  units_.push_back(unit);
}

Observation::Observation(Simulation& simulation) : simulation_(simulation), flexible_(simulation) {
  const Mechanism& mechanism = simulation.mechanism();
  const Scene& scene = simulation.scene();
  column("time", "s");
  groups_.push_back([](const Sample& s, std::vector<double>& row) { row.push_back(s.state.time); });
  for (int i = 0; i < mechanism.model.body_count(); ++i) {
    if (recorded(scene.output, mechanism.model.body(i).name())) {
      add_body(i);
      if (flexible_.find(i) >= 0) add_flexible(flexible_.find(i));
    }
  }
  if (scene.ground.kind != GroundKind::kNone)
    for (const BodyBoundary& entry : mechanism.boundaries) add_contact(entry.body, entry.boundary.name());
  for (const StrutEntry& strut : mechanism.struts) add_strut(strut);
  for (const ControllerEntry& controller : mechanism.controllers) add_controller(controller);
  add_energies();
  if (simulation.partner()) add_coupling();
}

const std::vector<double>& Observation::row(const Sample& sample) {
  row_.clear();
  flexible_.take(sample);
  for (const Group& group : groups_) group(sample, row_);
  FOOTFALL_DEMAND(row_.size() == names_.size());
  return row_;
}

void Observation::add_body(int body) {
  const std::string name = simulation_.mechanism().model.body(body).name();
  for (const char* axis : {".x", ".y", ".z"}) column(name + axis, "m");
  for (const char* axis : {".vx", ".vy", ".vz"}) column(name + axis, "m/s");
  for (const char* axis : {".ax", ".ay", ".az"}) column(name + axis, "m/s2");
  for (const char* axis : {".roll", ".pitch", ".yaw"}) column(name + axis, "rad");
  groups_.push_back([this, body](const Sample& s, std::vector<double>& row) {
    const BodyKinematics& motion = simulation_.equations().motion(body);
    const Layout& layout = simulation_.equations().layout();
    push(motion.r, row);
    push(motion.dr, row);
    push(s.rates.segment<3>(layout.v0() + layout.body_v[static_cast<std::size_t>(body)]), row);
    push(roll_pitch_yaw(motion.A), row);
  });
}

void Observation::add_flexible(int k) {
  const std::string name = flexible_.body(k).name();
  column(name + ".strain_energy", "J");
  column(name + ".deflection", "m");
  column(name + ".von_mises", "Pa");
  groups_.push_back([this, k](const Sample&, std::vector<double>& row) {
    const FlexibleFigures& now = flexible_.now(k);
    row.insert(row.end(), {now.strain_energy, now.deflection, now.von_mises});
  });
}

void Observation::add_contact(int body, const std::string& name) {
  for (const char* axis : {".contact.fx", ".contact.fy", ".contact.fz"}) column(name + axis, "N");
  for (const char* axis : {".contact.mx", ".contact.my", ".contact.mz"}) column(name + axis, "N m");
  groups_.push_back([body](const Sample& s, std::vector<double>& row) {
    const GeneralizedForce& contact = s.contact[static_cast<std::size_t>(body)];
    push(contact.F_W, row);
    push(contact.T_W, row);
  });
}

void Observation::add_strut(const StrutEntry& strut) {
  column(strut.name + ".stroke", "m");
  column(strut.name + ".rate", "m/s");
  column(strut.name + ".force", "N");
  groups_.push_back([this, force = strut.force](const Sample& s, std::vector<double>& row) {
    Equations& equations = simulation_.equations();
    const auto& element = static_cast<const Strut&>(equations.model().force(force));
    const StrutSample sample = element.sample(equations.element_input(force, s.state, s.inputs));
    row.insert(row.end(), {sample.stroke, sample.rate, sample.force});
  });
}

void Observation::add_controller(const ControllerEntry& controller) {
  for (const std::string& output : controller.outputs) column(controller.name + "." + output, "-");
  groups_.push_back([first = controller.first_voltage, count = static_cast<int>(controller.outputs.size())](
                        const Sample& s, std::vector<double>& row) {
    for (int k = 0; k < count; ++k) row.push_back(s.inputs.voltages(first + k));
  });
}

void Observation::add_energies() {
  for (const std::string& name : names_of<Stored>()) column("energy." + name, "J");
  column("energy.total", "J");
  for (const std::string& name : names_of<Dissipation>()) column("dissipated." + name, "J");
  column("work.contact", "J");
  column("work.motion", "J");
  groups_.push_back([](const Sample& s, std::vector<double>& row) {
    const StoredEnergy& stored = s.energy.stored;
    row.insert(row.end(), stored.by_kind.begin(), stored.by_kind.end());
    row.push_back(stored.total());
    for (const double work : s.state.dissipated.by_kind) row.push_back(work);
    row.push_back(s.state.load_work.sum());
    row.push_back(s.state.motion_work);
  });
}

void Observation::add_coupling() {
  column("coupling.energy_residual", "J");
  column("coupling.substeps", "-");
  if (simulation_.partner()->substeps() == 0) column("coupling.estimate", "-");
  const std::vector<int>& coupled = simulation_.partner()->coupled();
  for (const int i : coupled)
    column("coupling.omega_h." + simulation_.mechanism().boundaries[static_cast<std::size_t>(i)].boundary.name(), "-");
  groups_.push_back([this](const Sample& s, std::vector<double>& row) {
    row.push_back(s.coupling->energy_residual());
    row.push_back(s.substeps);
    if (simulation_.partner()->substeps() == 0) row.push_back(s.estimate);
    row.insert(row.end(), s.coupling->omega_h().begin(), s.coupling->omega_h().end());
  });
}

FigureTaker::FigureTaker(Simulation& simulation)
    : simulation_(simulation), up_(up_direction(simulation.scene().gravity)) {
  const Model& model = simulation.mechanism().model;
  for (int i = 1; i < model.body_count(); ++i)
    if (model.body(i).mass() > model.body(body_).mass()) body_ = i;
}

const std::string& FigureTaker::body_name() const { return simulation_.mechanism().model.body(body_).name(); }

std::string FigureTaker::balance_warning() const {
  if (figures_.energy_balance_relative() <= kGoodBalance) return "";
  std::ostringstream text;
  text.precision(3);
  text << "the energy of the mechanism does not close by " << figures_.energy_balance << " J, "
       << 100.0 * figures_.energy_balance_relative()
       << " % of the reference energy: its integration is not accurate; make solver.rtol and solver.atol, or "
          "solver.max_step, smaller";
  return text.str();
}

double FigureTaker::lowest_boundary_point(const Sample& sample) {
  double lowest = std::numeric_limits<double>::infinity();
  const Layout& layout = simulation_.equations().layout();
  for (const BodyBoundary& entry : simulation_.mechanism().boundaries) {
    const BodyKinematics& motion = simulation_.equations().motion(entry.body);
    const Eigen::Vector3d up_B = motion.A.transpose() * up_;
    const double height = up_.dot(motion.r);
    const Eigen::Matrix3Xd& rho0 = entry.boundary.rho0();
    const Eigen::Index s = entry.boundary.mode_count();
    const Eigen::Index first = layout.body_q[static_cast<std::size_t>(entry.body)] + 7;
    for (Eigen::Index j = 0; j < rho0.cols(); ++j) {
      double node = height + up_B.dot(rho0.col(j));
      if (s > 0) node += up_B.dot(entry.boundary.Phi().middleRows<3>(3 * j) * sample.state.q.segment(first, s));
      lowest = std::min(lowest, node);
    }
  }
  return lowest;
}

void FigureTaker::take(const Sample& sample) {
  Figures& f = figures_;
  const Layout& layout = simulation_.equations().layout();
  const StoredEnergy& stored = sample.energy.stored;
  const double height = up_.dot(simulation_.equations().motion(body_).r);
  f.contact_work = sample.state.load_work.sum();
  if (!started_) {
    started_ = true;
    start_height_ = height;
    start_energy_ = stored.total();
    f.reference_energy = stored.total() - stored[Stored::kGravity];
  }
  f.reference_energy = std::max(f.reference_energy, stored[Stored::kKinetic]);
  f.peak_acceleration =
      std::max(f.peak_acceleration,
               sample.rates.segment<3>(layout.v0() + layout.body_v[static_cast<std::size_t>(body_)]).norm());
  f.max_descent = std::max(f.max_descent, start_height_ - height);
  Eigen::Vector3d total = Eigen::Vector3d::Zero();
  for (const GeneralizedForce& contact : sample.contact) {
    f.max_contact_force = std::max(f.max_contact_force, contact.F_W.norm());
    total += contact.F_W;
  }
  f.contact_force = total.norm();
  if (simulation_.scene().ground.kind != GroundKind::kNone && !simulation_.mechanism().boundaries.empty())
    f.max_penetration =
        std::max(f.max_penetration, simulation_.mechanism().placement.ground_height - lowest_boundary_point(sample));
  const double balance =
      stored.total() - start_energy_ + sample.state.dissipated.total() - f.contact_work - sample.state.motion_work;
  f.energy_balance = std::max(f.energy_balance, std::abs(balance));
}

}  // namespace footfall
