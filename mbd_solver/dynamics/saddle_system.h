#pragma once
// Direct solves of the saddle system of the equations of motion,
//   [M, Phi_v^T; Phi_v, -eps] [x; lambda] = [f; g]
// for accelerations, responses to forces, reactions of joints and the projection of drift. eps is a regularisation
// for singular positions (relative 1e-12 of the size of Phi_v M^-1 Phi_v^T; very light bodies count as heavier). Some
// of the rows that depend on each other rest: their eps is large (Redundancy).

#include <memory>
#include <vector>

#include "mbd_solver/dynamics/assembly.h"
#include "mbd_solver/dynamics/body_force.h"
#include "mbd_solver/dynamics/constraint_rows.h"
#include "mbd_solver/dynamics/jacobian_pattern.h"
#include "mbd_solver/dynamics/sparse_lu.h"
#include "mbd_solver/model/state.h"

namespace footfall {

class Equations;

// Errors of the joints before and after a projection.
struct Drift {
  double position = 0.0;       // largest |phi| before [m or rad]
  double velocity = 0.0;       // largest |phi'| before [m/s or rad/s]
  double position_left = 0.0;  // the same two after
  double velocity_left = 0.0;
  int worst_row = 0;  // row of the largest |phi|
};

// No function allocates, except where redundant rows are found anew.
class SaddleSystem {
 public:
  // `equations` owns this object. Throws InputError if bodies connected by joints differ by more than 1e15 in mass.
  SaddleSystem(Equations& equations, const Assembly& assembly);
  ~SaddleSystem();

  // dv and lambda of a state; also dq and dz: out is the complete dy/dt with the multipliers in the place of their rates.
  // Throws NumericalError naming time and body if not finite.
  void accelerations(const State& state, const Inputs& inputs, Eigen::Ref<Eigen::VectorXd> ydot_and_lambda);
  // The same for the steps of an integrator: redundant multipliers come from multipliers_without_resting_rows(), they
  // are not the smallest.
  void stage_rates(const State& state, const Inputs& inputs, Eigen::Ref<Eigen::VectorXd> ydot_and_lambda);
  // One Newton step of the same from approximate rates, with the factors of an earlier solve: out is corrected by `change`
  // (of dv and lambda; else 0). With old factors the convergence is linear. False: there are no factors, or rows are
  // redundant, or a law has no value here.
  bool correct_rates(const State& state, const Inputs& inputs, Eigen::Ref<Eigen::VectorXd> out,
                     Eigen::Ref<Eigen::VectorXd> change);

  // The accelerations caused by generalized forces f (as v) under joints, motions and resting rows:
  //   [M, Phi_v^T; Phi_v, -eps] [a; lambda] = [f; 0],   f becomes a
  // Throws NumericalError if the system is singular.
  void respond(const State& state, Eigen::Ref<Eigen::VectorXd> f);
  void factor_at(const State& state);  // prepares respond() for this state

  // Among all lambda with the same total reactions on the bodies: the lambda with the smallest sum (s_i lambda_i)^2
  // (Redundancy). No change without redundant rows.
  void smallest_multipliers(const State& state, Eigen::Ref<Eigen::VectorXd> lambda);
  // The same lambda, but zero in resting rows: equal in all stages of a step, so that stages can be combined.
  void multipliers_without_resting_rows(double t, const Eigen::Ref<const Eigen::VectorXd>& y,
                                        Eigen::Ref<Eigen::VectorXd> lambda);
  // F_lambda += eps expected, where no row rests: eps then acts on the difference of lambda from `expected`. eps lambda itself
  // would be an acceleration error of the sign of lambda: between projections it removes energy, and the error at the end
  // would have a floor that no tolerance lowers.
  void expect_multipliers(const Eigen::Ref<const Eigen::VectorXd>& expected,
                          Eigen::Ref<Eigen::VectorXd> F_lambda) const;
  long resting_row_changes() const { return resting_row_changes_; }  // 0: no rows are redundant
  // Checks whether the resting rows may continue to rest; for occasional calls within a window.
  void update_resting_rows(const State& state);
  bool has_redundant_rows() const { return !redundancies_.empty(); }
  // Per row, F_lambda = phi'' - regularisation lambda: eps, s^2 of a resting row, 1 / J of a rotor.
  const Eigen::VectorXd& regularisation() const { return regularisation_; }

  // Removes the drift of Phi and Phi' by the Moore-Penrose inverse of Phi_v in the metric of the mass matrix:
  //   dx = -M^-1 Phi_v^T (Phi_v M^-1 Phi_v^T)^+ Phi, repeated to round-off; the same for v.
  // Quaternions are normalised. Throws NumericalError naming time and joint if a joint remains open by more than 1e-6 m or rad.
  enum class Close {
    kToTolerance,    // drift below 1e-10 m and 2e-9 m/s remains
    kFully,          // to round-off
    kWithOldFactors  // to tolerance, with the factors of an earlier position if they suffice; for output rows
  };
  Drift project(State& state, Close close = Close::kToTolerance);
  // Measures only; for runs without projection. Throws NumericalError if a joint is open by more than 1e-3 m or rad.
  Drift check_closed(const State& state);
  Drift drift(const State& state);  // measures only
  // ln |det| of the matrix, with resting rows; minus infinity if it is singular.
  double log_determinant(const State& state);

  // Drops the pivots and resting rows of earlier solves, so that results depend on arguments alone.
  void forget();

 private:
  enum class Rest { kGood, kBadRows, kLost };
  void set_row_sizes(const State& state);
  void set_regularisation();
  // All at the loaded kinematics, which must belong to the state:
  bool factor_saddle(const State& state);
  void fill_saddle(double t, double mass, const Eigen::VectorXd& diagonal);  // [mass M, Phi_v^T; Phi_v, -diagonal]
  Rest judge_resting_rows();
  void choose_resting_rows();
  void find_redundancies(const State& state);
  void solve_saddle();  // scratch_.x
  void make_smallest(double t, Eigen::Ref<Eigen::VectorXd> lambda);
  void add_reaction(const Eigen::Ref<const Eigen::VectorXd>& lambda, double sign,
                    Eigen::Ref<Eigen::VectorXd> force) const;
  void remove_drift(double closed, double closed_speed, bool together, State& state, Drift& now);

  Equations& equations_;
  const Model& model_;
  const Layout& layout_;
  const Kinematics& kinematics_;  // of the equations
  SaddlePattern pattern_;
  Eigen::VectorXd own_;  // diagonal of M in the matrix
  std::unique_ptr<ThinLu> lu_;
  bool factored_ = false;                // lu_ has factors,
  double factored_time_ = 0.0;           // of this time
  Eigen::VectorXd factored_q_;           // and position
  std::unique_ptr<ThinLu> smallest_lu_;  // of the same pattern, for make_smallest()

  // Per row [1/kg or 1/(kg m2)]: (Phi_v M^-1 Phi_v^T)_ii at the start; s^2 of make_smallest(), the same or its mean over a
  // joint; eps of rows that do not rest; regularisation of all rows.
  Eigen::VectorXd row_size_, smallest_size_, eps_, regularisation_;
  std::vector<Redundancy> redundancies_;
  bool redundancies_known_ = true;  // false: to be found from the next state
  long resting_row_changes_ = 0;

  struct Scratch {
    std::vector<InertiaScratch> inertia;  // per body
    Eigen::VectorXd row;                  // of the largest pair
    Eigen::MatrixXd M;                    // of the largest body
    Eigen::VectorXd x, rest_x, phi_rate;
    Eigen::MatrixXd two;             // two right sides of a projection: of positions, of velocities
    Eigen::VectorXd reaction;        // Phi_v^T lambda
    Eigen::VectorXd y, rhs;          // full vectors of stage_rates()
    Eigen::VectorXd last_q, last_v;  // copies during a projection
  };
  Scratch scratch_;
};

}  // namespace footfall
