// State, rates and inputs are plain data of the mechanism; the sampler views them.

#include "mbd_solver/session/loop/moving_mechanism.h"

#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "mbd_solver/session/codes.h"
#include "mbd_solver/session/loop/advance.h"
#include "mbd_solver/session/observe/start_values.h"

namespace footfall {
namespace {

// Without grains: third order for windows of one step, fifth order for longer ones, where it takes
// longer steps (window_order). With grains windows are short, and their own error is of second
// order.
int order_of(OneStepMethod method, bool with_grains) {
  switch (method) {
    case OneStepMethod::kAuto: return with_grains ? 2 : 3;
    case OneStepMethod::kTrBdf2: return 2;
    case OneStepMethod::kEsdirk3: return 3;
    case OneStepMethod::kEsdirk5: return 5;
  }
  FOOTFALL_DEMAND(false);
}

}  // namespace

Baumgarte baumgarte_of(const SolverSpec& spec) {
  if (spec.drift == DriftKind::kProjection) return {};
  return {spec.baumgarte_velocity, spec.baumgarte_position};
}

IntegratorOptions integrator_options(const SolverSpec& spec, bool with_grains) {
  IntegratorOptions options;
  options.order = order_of(spec.method, with_grains);
  if (spec.method == OneStepMethod::kAuto) {
    options.window_order = with_grains ? 3 : 5;
    if (!spec.error_control && !with_grains) options.order = 5;  // fixed steps: one order for all windows
  }
  options.rtol = spec.rtol;
  options.atol = spec.atol_position();
  options.atol_velocity = spec.atol_velocity();
  options.max_step = spec.max_step;
  options.error_control = spec.error_control;
  options.projection = spec.drift == DriftKind::kProjection;
  return options;
}

template <>
inline constexpr auto kFields<State> =
    kFieldsOf<&State::time, &State::q, &State::v, &State::z, &State::dissipated, &State::load_work, &State::supplied,
              &State::work_error, &State::angles, &State::uncertain_angle, &State::memory, &State::step>;

MovingMechanism::MovingMechanism(const Scene& scene, double t_end, bool with_grains)
    : scene_(scene),
      t_end_(t_end),
      mechanism_(build_mechanism(scene)),
      assembly_(assemble(mechanism_.model, assembly_options(scene, mechanism_.model))),
      equations_(mechanism_.model, assembly_, baumgarte_of(scene.solver)),
      corners_(scene, mechanism_),
      integrator_(make_integrator(std::string(name_of(scene.solver.integrator)), equations_,
                                  integrator_options(scene.solver, with_grains))),
      state_(assembly_.state),
      rates_(Eigen::VectorXd::Zero(equations_.layout().size())),
      sampler_({scene_, mechanism_, equations_.layout()}, equations_, state_, rates_, inputs_) {}

void MovingMechanism::couple(Transport& partner, const std::string& resume) {
  inputs_.loads.resize(static_cast<std::size_t>(mechanism_.model.body_count()));
  coupled_ =
      std::make_unique<CoupledRun>(scene_, mechanism_, assembly_, equations_, kinematics(), t_end_, partner, resume);
}

Subject MovingMechanism::subject() const {
  return {scene_, mechanism_, equations_.layout(), coupled_ ? &coupled_->agreement() : nullptr};
}

Kinematics MovingMechanism::kinematics() const {
  Kinematics kinematics(mechanism_.model);
  kinematics.load(equations_.layout(), state_.q, state_.v, Eigen::VectorXd());
  return kinematics;
}

bool MovingMechanism::finished() const {
  return state_.time >= t_end_ * (1.0 - 1e-12) || (coupled_ && coupled_->script_has_ended());
}

void MovingMechanism::advance(const State& from, double time) {
  Advance way(*this);
  way.begin(from, time);
  way.next();
}

void MovingMechanism::check_finite() const {
  if (state_.q.allFinite() && state_.v.allFinite() && state_.z.allFinite()) return;
  throw NumericalError(code::kStateNotFinite,
                       "t = " + plain_text(state_.time) + " s: the state of the mechanism is not finite");
}

void MovingMechanism::visit(Archive& archive) {
  archive("state", state_);
  archive("rates", rates_);
  archive("inputs", inputs_);
  archive("window", window_);
}

void MovingMechanism::resume(const IntegratorStatistics& so_far) {
  integrator_->resume(so_far);
  equations_.recall(state_);
}

}  // namespace footfall
