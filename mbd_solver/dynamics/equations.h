#pragma once
// The equations of motion as an implicit differential-algebraic system F(t, y, dy/dt) = 0, index 1:
//   y = [q; v; z; lambda]
//   F_q      = dq - N(q) v
//   F_v      = M(q) dv + h(q, v) + Phi_v^T lambda - Q(t, q, v, z)
//   F_z      = dz - g(q, v, z)
//   F_lambda = phi'' + 2 alpha phi' + beta^2 phi - eps lambda          alpha, beta: Baumgarte (0 by default)
// eps: regularisation (saddle_system.h), which also solves for accelerations and removes drift. No function allocates. One
// Equations object belongs to one thread: it owns the workspace, and the scratch of the elements. Any number may share a model.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "mbd_solver/dynamics/assembly.h"
#include "mbd_solver/dynamics/jacobian.h"
#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/dynamics/saddle_system.h"
#include "mbd_solver/model/state.h"

namespace footfall {

// Energies and powers at one instant.
struct EnergySample {
  StoredEnergy stored;         // [J]
  Dissipated power;            // dissipated power by kind [W]
  Eigen::VectorXd load_power;  // of the external loads, per body [W]
  Supplied supplied;           // power of prescribed motions, forces and drives [W]
};

class Equations {
 public:
  // `model` must outlive this object. Throws InputError like SaddleSystem.
  Equations(const Model& model, const Assembly& assembly, const Baumgarte& baumgarte = {});
  ~Equations();

  const Model& model() const { return model_; }
  const Layout& layout() const { return layout_; }
  SaddleSystem& saddle() { return *saddle_; }  // accelerations, reactions, drift

  // F(t, y, ydot).
  void residual(double t, const Eigen::Ref<const Eigen::VectorXd>& y, const Eigen::Ref<const Eigen::VectorXd>& ydot,
                const Inputs& inputs, Eigen::Ref<Eigen::VectorXd> F);
  Jacobian& jacobian() { return jacobian_; }  // dF/dy + c dF/dydot
  const Jacobian& jacobian() const { return jacobian_; }
  // dF/dydot * x at (t, y), for the filter of an error estimate.
  void apply_mass(const Eigen::Ref<const Eigen::VectorXd>& y, const Eigen::Ref<const Eigen::VectorXd>& x, double t,
                  Eigen::Ref<Eigen::VectorXd> out);

  // Energies and powers at (t, y); multipliers enter the power of prescribed motions.
  void energy(double t, const Eigen::Ref<const Eigen::VectorXd>& y, const Inputs& inputs, EnergySample& out);
  // The powers alone, for the time integrals of a step: out.stored is undefined.
  void powers(double t, const Eigen::Ref<const Eigen::VectorXd>& y, const Inputs& inputs, EnergySample& out);

  // Input values at a state, with the continuous signals at their current values.
  void signals(const State& state, const Inputs& inputs, Eigen::VectorXd& out);
  // Settles the states of the continuous signals at the start (before null), or of those that become active when the scene
  // enters another of its states: `before` are the inputs until then.
  void settle_signals(const Eigen::VectorXd* before, const Inputs& inputs, State& state);

  // Modes of force elements (Switching): the smallest value, below 0 where a mode no longer fits; switch_modes()
  // sets those, true if there were any.
  bool has_modes() const { return !switching_.empty(); }
  double mode_value(const State& state, const Inputs& inputs);
  bool switch_modes(const Inputs& inputs, State& state);

  // Memory of force elements (Remembering): recall() before a state is evaluated that does not follow the last one,
  // remember() at the end of a step.
  bool has_memory() const { return !remembering_.empty(); }
  void recall(const State& state);
  void remember(const Inputs& inputs, State& state);

  // Unpacks a state for the output functions below.
  void load(const State& state);
  void load(const Eigen::Ref<const Eigen::VectorXd>& y);
  const Kinematics& kinematics() const;
  const BodyKinematics& motion(int body) const;
  // valid after load(), without continuous signals
  ElementInput element_input(int force, const State& state, const Inputs& inputs);
  // Scratch data of force elements during an evaluation, and their memory since recall() or remember().
  ElementScratches& scratch();
  // Force and moment [N, N m] that joint `joint` exerts on its body 2, about the point of marker 2, in W.
  // After load().
  Vector6d joint_wrench(int joint, double t, const Eigen::Ref<const Eigen::VectorXd>& lambda) const;

  // Consistent sizes of the inputs, else an internal error.
  void check_inputs(const Inputs& inputs) const;
  // Name of an entry of y for messages: `body "cabin": w.y`, `joint "hinge": condition 3`.
  std::string entry_name(int index) const;

 private:
  struct Workspace;
  void sample_energy(double t, const Eigen::Ref<const Eigen::VectorXd>& y, const Inputs& inputs, bool stored_by_bodies,
                     EnergySample& out);

  const Model& model_;
  Layout layout_;
  Baumgarte baumgarte_;
  // With the index of the element.
  std::vector<std::pair<int, const Switching*>> switching_;
  std::vector<std::pair<int, const Remembering*>> remembering_;
  std::unique_ptr<Workspace> work_;
  std::unique_ptr<SaddleSystem> saddle_;
  Jacobian jacobian_;
};

}  // namespace footfall
