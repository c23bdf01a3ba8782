// The parts of a run are made in the order in which they read each other; one of two loops then
// runs it: alone, a window ends where an input changes; with grains, every window is one exchange.

#include "mbd_solver/session/simulation.h"

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/dynamics/turn_follower.h"
#include "mbd_solver/session/codes.h"
#include "mbd_solver/session/loop/coupled_loop.h"
#include "mbd_solver/session/loop/moving_mechanism.h"
#include "mbd_solver/session/observe/attached_damping.h"
#include "mbd_solver/session/observe/carry_over.h"
#include "mbd_solver/session/observe/observation.h"
#include "mbd_solver/session/observe/requirements.h"
#include "mbd_solver/session/observe/start_values.h"
#include "mbd_solver/session/settle.h"

namespace footfall {
namespace {

void add_warnings(std::vector<std::string> more, Mechanism& mechanism) {
  for (std::string& warning : more) mechanism.warnings.push_back(std::move(warning));
}

void settle_start(MovingMechanism& moving) {
  const Scene& scene = moving.scene();
  const Settled settled =
      settle(scene, assembly_options(scene, moving.mechanism().model), integrator_options(scene.solver, false));
  State& state = moving.state();
  state.q = settled.state.q;
  state.z = settled.state.z;
  state.angles = settled.state.angles;
  state.memory = settled.state.memory;
  moving.equations().recall(state);
  moving.equations().saddle().project(state);  // velocities of prescribed motions
  moving.assembly().notes.push_back(
      with_code(code::kSettled, "the mechanism was settled under the loads of the start: body \"" + settled.body +
                                    "\" moved most, by " + number_text(settled.moved, 3) +
                                    " m; the largest remaining acceleration is " +
                                    number_text(settled.acceleration, 3) + " m/s2 or rad/s2."));
}

}  // namespace

Simulation::Simulation(const Scene& scene, double t_end, Transport* partner_transport, const std::string& resume)
    : parts_(std::make_unique<RunParts>(scene, t_end, partner_transport != nullptr)) {
  MovingMechanism& moving = parts_->moving;
  Mechanism& mechanism = moving.mechanism();
  add_warnings(damping_warnings_of_run(scene, mechanism), mechanism);
  if (!scene.requirements.empty()) {
    const Observation observation(subject());
    add_warnings(requirement_unit_warnings(scene, observation.names(), observation.units()), mechanism);
  }
  if (!scene.initial.from.empty() && resume.empty())  // the angles, which the assembly has counted from zero
    carry_over(scene, mechanism.model, moving.equations().layout(), moving.state(), &mechanism.warnings);
  parts_->inputs.begin();
  const Kinematics reference = kinematics();
  if (scene.initial.settle && resume.empty()) settle_start(moving);
  moving.equations().settle_signals(nullptr, moving.inputs(), moving.state());
  moving.equations().switch_modes(moving.inputs(), moving.state());
  if (partner_transport) moving.couple(*partner_transport, resume);
  parts_->surfaces.start(reference);
}

void Simulation::run(const std::function<void(const Sample&)>& observe, const volatile std::sig_atomic_t& interrupted,
                     const CheckpointWriter& checkpoints) {
  if (coupled()) {
    parts_->checkpoints.begin(checkpoints);
    CoupledLoop(*parts_, observe, interrupted).run();
    return;
  }
  begin(interrupted, checkpoints);
  for (Reached reached = next(); reached != Reached::kEnd; reached = next())
    if (reached == Reached::kSample) observe(sample());
}

void Simulation::begin(const volatile std::sig_atomic_t& interrupted, const CheckpointWriter& checkpoints) {
  parts_->checkpoints.begin(checkpoints);
  loop_ = std::make_unique<AloneLoop>(*parts_, interrupted);
}

void Simulation::place(const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
  MovingMechanism& moving = parts_->moving;
  const Layout& layout = moving.equations().layout();
  FOOTFALL_DEMAND(!coupled() && q.size() == layout.q_size && v.size() == layout.v_size);
  State placed = moving.state();
  placed.q = q;
  placed.v = v;
  for (const int body_q : layout.body_q) placed.q.segment<4>(body_q + 3).normalize();
  moving.equations().saddle().project(placed, SaddleSystem::Close::kFully);
  // Angles that count turns stay within half a turn of what they were.
  Kinematics kinematics(mechanism().model);
  kinematics.load(layout, placed.q, placed.v, Eigen::VectorXd());
  const Eigen::VectorXd before = placed.angles;
  start_angles(mechanism().model, layout, kinematics, placed);
  for (Eigen::Index i = 0; i < before.size(); ++i)
    placed.angles[i] += 2.0 * kPi * std::round((before[i] - placed.angles[i]) / (2.0 * kPi));
  placed.step = 0.0;
  moving.state() = placed;
  moving.equations().switch_modes(moving.inputs(), moving.state());
  moving.renew();
  parts_->events.apply();
  parts_->resumed = true;  // the caller has taken the present sample
}

// The integrator's history is dropped at a checkpoint, in the run that continues and in the resumed
// one.
void Simulation::visit(Archive& archive) {
  MovingMechanism& moving = parts_->moving;
  moving.visit(archive);
  parts_->inputs.visit(archive);
  parts_->foresight.visit(archive);
  archive("times", moving.times());
  parts_->checkpoints.visit(archive);
  if (const auto& landing = scene().landing; landing && (landing->end_at_rest || landing->end_when_tipped))
    parts_->instructions.visit_end(archive);
  archive("control", parts_->inputs.control());
  IntegratorStatistics statistics = moving.integrator().statistics();
  archive("statistics", statistics);
  if (archive.restores()) moving.resume(statistics);
  if (moving.coupled()) archive("coupled", *moving.coupled());
  if (archive.restores()) parts_->instructions.forget_inputs();
  parts_->resumed = archive.restores();
}

}  // namespace footfall
