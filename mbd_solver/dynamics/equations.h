#pragma once
// The equations of motion as an implicit differential-algebraic system F(t, y, dy/dt) = 0, index 1:
//   y = [q; v; z; lambda]
//   F_q      = dq - N(q) v
//   F_v      = M(q) dv + h(q, v) + Phi_v^T lambda - Q(t, q, v, z)
//   F_z      = dz - g(q, v, z)
//   F_lambda = phi'' + 2 alpha phi' + beta^2 phi - eps lambda          alpha, beta: Baumgarte (0 by default)
// eps is a regularisation (relative 1e-12 of the size of Phi_v M^-1 Phi_v^T, very light bodies counted heavier) for singular
// positions; see expect_multipliers(). Where rows depend on each other some of them rest: their eps is large (redundancy.h).
// No function here allocates. One Equations object belongs to one thread (it owns the workspace).

#include <Eigen/Sparse>
#include <memory>
#include <string>

#include "mbd_solver/dynamics/assembly.h"
#include "mbd_solver/dynamics/constraint_rows.h"
#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/model/state.h"

namespace footfall {

struct Baumgarte {
  double alpha = 0.0;  // [1/s]
  double beta = 0.0;   // [1/s]
};

// Everything one can say about the energy at one instant.
struct EnergySample {
  StoredEnergy stored;         // [J]
  Dissipated power;            // dissipated power by kind [W]
  Eigen::VectorXd load_power;  // of the external loads, per body [W]
  Supplied supplied;           // power of prescribed motions, forces and drives [W]
};

class Equations {
 public:
  // `model` must outlive this object. Throws InputError when bodies that joints connect differ by more than 1e15 in mass.
  Equations(const Model& model, const Assembly& assembly, const Baumgarte& baumgarte = {});
  ~Equations();

  const Model& model() const { return model_; }
  const Layout& layout() const { return layout_; }

  // F(t, y, ydot).
  void residual(double t, const Eigen::Ref<const Eigen::VectorXd>& y, const Eigen::Ref<const Eigen::VectorXd>& ydot,
                const Inputs& inputs, Eigen::Ref<Eigen::VectorXd> F);
  // dF/dy + c dF/dydot: column-major, compressed, the same pattern for ever; values are rewritten in place.
  const Eigen::SparseMatrix<double>& jacobian(double t, const Eigen::Ref<const Eigen::VectorXd>& y,
                                              const Eigen::Ref<const Eigen::VectorXd>& ydot, double c,
                                              const Inputs& inputs);
  // The same matrix, whatever its values are now.
  const Eigen::SparseMatrix<double>& jacobian_pattern() const;
  // The same with the rows F_q and the columns q eliminated by c dq = N dv + (dN v) (exact for the step of a
  // one-step method): square in [v; z; lambda], a quarter of the work to factor.
  const Eigen::SparseMatrix<double>& reduced_jacobian(double t, const Eigen::Ref<const Eigen::VectorXd>& y,
                                                      const Eigen::Ref<const Eigen::VectorXd>& ydot, double c,
                                                      const Inputs& inputs);
  // eps in F_lambda then acts on what lambda differs by from `expected`: F_lambda += eps expected, where no row rests.
  // eps lambda itself would be an acceleration that conditions are left with, of the sign of lambda: between projections
  // that takes energy, and the error of the end would have a floor that no tolerance lowers.
  void expect_multipliers(const Eigen::Ref<const Eigen::VectorXd>& expected,
                          Eigen::Ref<Eigen::VectorXd> F_lambda) const;
  const Eigen::SparseMatrix<double>& reduced_pattern() const;
  // Per velocity, what its body alone gives the diagonal of the last Jacobian reduced at c: c M_ii, of a mode c M_ii + C_i +
  // K_i / c.
  const Eigen::VectorXd& own_diagonal() const;
  // Per velocity, the share of that below which Newton may leave out an entry of its row (thin_lu.h).
  Eigen::VectorXd negligible_shares() const;
  // out -= d[F_v; F_z; F_lambda]/dx dx, with the derivatives of the last Jacobian.
  // dx as v; out as [v; z; lambda].
  void subtract_stiffness(const Eigen::Ref<const Eigen::VectorXd>& dx, Eigen::Ref<Eigen::VectorXd> out) const;
  // dF/dydot * x at (t, y): what an error estimate is filtered with.
  void apply_mass(const Eigen::Ref<const Eigen::VectorXd>& y, const Eigen::Ref<const Eigen::VectorXd>& x, double t,
                  Eigen::Ref<Eigen::VectorXd> out);

  // dv and lambda of a state, by a direct solve of [M, Phi_v^T; Phi_v, -eps]; also dq and dz: out is the
  // complete dy/dt with the multipliers in the place of their rates. Throws NumericalError naming time and
  // body when not finite.
  void accelerations(const State& state, const Inputs& inputs, Eigen::Ref<Eigen::VectorXd> ydot_and_lambda);
  // The same for the steps of an integrator: of redundant multipliers those of rest_multipliers(), not the smallest.
  void stage_rates(const State& state, const Inputs& inputs, Eigen::Ref<Eigen::VectorXd> ydot_and_lambda);

  // One step of the same from rates that are nearly right, with the factors of an earlier solve: out is corrected, change
  // is by how much (of dv and lambda; else 0). Where the factors are old its corrections fall by what the matrix has
  // changed since. False: there are no factors, or rows are redundant, or a law has no value here.
  bool correct_rates(const State& state, const Inputs& inputs, Eigen::Ref<Eigen::VectorXd> out,
                     Eigen::Ref<Eigen::VectorXd> change);

  // What generalized forces f (as v) add to the accelerations that joints, motions and resting rows leave:
  //   [M, Phi_v^T; Phi_v, -eps] [a; lambda] = [f; 0],   f becomes a
  // Throws NumericalError when that is singular.
  void respond(const State& state, Eigen::Ref<Eigen::VectorXd> f);
  void factor_at(const State& state);  // what respond() needs there, ahead of it

  // Of all lambda with the same reactions on the bodies together, that of the smallest sum (s_i lambda_i)^2 (redundancy.h).
  // Nothing changes where no rows are redundant.
  void smallest_multipliers(const State& state, Eigen::Ref<Eigen::VectorXd> lambda);
  // Of all those, that which is zero where rows rest: all stages of a step have it, so that it can be combined of them.
  void rest_multipliers(double t, const Eigen::Ref<const Eigen::VectorXd>& y, Eigen::Ref<Eigen::VectorXd> lambda);
  long rest_choices() const;  // how often the rows that rest were chosen; 0: none are redundant
  // Looks at whether the rows that rest may go on resting; to be called now and then within a window.
  void renew_rest(const State& state);

  // Removes the drift of Phi and Phi' by the Moore-Penrose inverse of Phi_v in the metric of the mass matrix:
  //   dx = -M^-1 Phi_v^T (Phi_v M^-1 Phi_v^T)^+ Phi, repeated to round-off; the same for v.
  // Quaternions are normalised.
  struct Drift {
    double position = 0.0;       // largest |phi| before [m or rad]
    double velocity = 0.0;       // largest |phi'| before [m/s or rad/s]
    double position_left = 0.0;  // the same two after
    double velocity_left = 0.0;
    int worst_row = 0;  // that of the largest |phi|
  };
  enum class Close {
    kAsPromised,      // drift below 1e-10 m and 2e-9 m/s is left alone
    kFully,           // to round-off
    kByFactorsAtHand  // as promised, with the factors at hand where they serve; for rows
  };
  // Throws NumericalError naming time and joint when a joint stays open by more than 1e-6 m or rad.
  Drift project(State& state, Close close = Close::kAsPromised);
  // Measured only; for runs without projection, which end likewise when a joint is open by more than 1e-3 m or rad.
  Drift check_closed(const State& state);
  Drift drift(const State& state);  // measured only
  // ln |det [M, Phi_v^T; Phi_v, -eps]|, with resting rows: that of the squares of the conditions' singular values.
  double log_determinant(const State& state);

  // Energies and powers at (t, y); multipliers enter the power of prescribed motions.
  void energy(double t, const Eigen::Ref<const Eigen::VectorXd>& y, const Inputs& inputs, EnergySample& out);
  // The powers alone, which is all that the time integrals of a step need: out.stored has no meaning.
  void powers(double t, const Eigen::Ref<const Eigen::VectorXd>& y, const Inputs& inputs, EnergySample& out);

  // Voltages and signals at a state: those of the inputs, continuous signals at their present values.
  void signals(const State& state, const Inputs& inputs, Eigen::VectorXd& out);
  // States of the continuous signals at the start (before null), or of those that begin to work as the scene goes to
  // another of its states: `before` are the inputs until then.
  void settle_signals(const Eigen::VectorXd* before, const Inputs& inputs, State& state);

  // Unpacks a state for the output functions below.
  void load(const State& state);
  const BodyKinematics& motion(int body) const;
  // valid after load(), without continuous signals
  ElementInput element_input(int force, const State& state, const Inputs& inputs) const;
  // Force and moment [N, N m] that joint `joint` exerts on its body 2, about the point of marker 2, in W.
  // After load().
  Vector6d joint_wrench(int joint, double t, const Eigen::Ref<const Eigen::VectorXd>& lambda) const;

  // Drops the pivots and resting rows of earlier solves, so that results depend on arguments alone.
  void forget();

  // y of a state (multipliers given) and back.
  void pack(const State& state, const Eigen::Ref<const Eigen::VectorXd>& lambda, Eigen::Ref<Eigen::VectorXd> y) const;
  void unpack(const Eigen::Ref<const Eigen::VectorXd>& y, State& state) const;
  // Human name of an entry of y: `body "cabin": w.y`, `joint "hinge": condition 3`.
  std::string entry_name(int index) const;

 private:
  struct Workspace;
  void set_row_sizes(const State& state);
  void sample_energy(double t, const Eigen::Ref<const Eigen::VectorXd>& y, const Inputs& inputs, bool stored_by_bodies,
                     EnergySample& out);
  void rest_rows();  // regularisation of all rows
  void demand_fitting(const Inputs& inputs) const;
  // At the loaded kinematics: of the inputs, or with the continuous signals among them. Also the rates of their states.
  const Eigen::VectorXd& input_values_at(double t, const Eigen::Ref<const Eigen::VectorXd>& y, const Inputs& inputs);
  void add_signal_derivatives(double t, const Eigen::Ref<const Eigen::VectorXd>& y, const Inputs& inputs);
  void gather_derivatives(double t, const Eigen::Ref<const Eigen::VectorXd>& y,
                          const Eigen::Ref<const Eigen::VectorXd>& ydot, double c, const Inputs& inputs);
  void add_body_derivatives(int index, double c, const Inputs& inputs);
  void add_joint_derivatives(int index, double t, double c, const Eigen::Ref<const Eigen::VectorXd>& lambda);
  void add_force_derivatives(int index, double t, const Eigen::Ref<const Eigen::VectorXd>& z,
                             const Eigen::VectorXd& values);
  // All at the loaded kinematics, which are those of the state:
  bool factor_saddle(const State& state);
  void fill_saddle(double t, double mass, const Eigen::VectorXd& diagonal);  // [mass M, Phi_v^T; Phi_v, -diagonal]
  enum class Rest { kGood, kBadRows, kLost };
  Rest judge_rest();
  void choose_resting_rows();
  void find_redundancies(const State& state);
  void solve_saddle();  // saddle_x
  void make_smallest(double t, Eigen::Ref<Eigen::VectorXd> lambda);
  void add_reaction(const Eigen::Ref<const Eigen::VectorXd>& lambda, double sign,
                    Eigen::Ref<Eigen::VectorXd> force) const;
  void demand_closed(double t, const Drift& drift, double tolerance) const;
  void remove_drift(double closed, double closed_speed, bool together, State& state, Drift& now);
  Drift measure_drift(double t, Eigen::Ref<Eigen::VectorXd> phi, Eigen::Ref<Eigen::VectorXd> rate);

  const Model& model_;
  Layout layout_;
  Baumgarte baumgarte_;
  std::unique_ptr<Workspace> work_;
};

}  // namespace footfall
