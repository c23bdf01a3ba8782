#pragma once
// One scalar condition between two markers, built from dot products of kinematic vectors:
//   phi(t) = sum_i c_i(t) (alpha_i . beta_i) - f(t) = 0
// alpha_i: a fixed direction of W, an axis of marker 1, or the difference d = p2 - p1; beta_i: d, or an axis of marker 2.

#include <Eigen/Dense>
#include <memory>
#include <optional>

#include "mbd_solver/model/elements/joint_coordinate.h"
#include "mbd_solver/model/kinematic_vector.h"
#include "mbd_solver/model/laws/curves.h"
#include "mbd_solver/model/laws/time_function.h"

namespace footfall {

class RowLaw;

// A factor of a dot product.
struct Factor {
  enum class Kind { kWorldDirection, kAxis1, kAxis2, kDifference } kind = Kind::kDifference;
  int axis = 0;  // 0, 1, 2
};

struct DotTerm {
  Factor alpha, beta;
};

struct ConstraintRow {
  enum class Unit { kLength, kAngle };
  Unit unit = Unit::kLength;  // of phi near zero: [m] or [rad]
  // Constant coefficient `scale` of the first term; a second term exists only for a prescribed rotation,
  //   phi = cos(f) y1.x2 - sin(f) x1.x2 about z (and its cyclic forms): terms {y1.x2, x1.x2}.
  int term_count = 1;
  DotTerm terms[2];
  double scale = 1.0;
  double scale2 = 0.0;     // of a constant second term
  double offset = 0.0;     // constant part of f; of an open cam on an angle: q + offset is its place on the curve [rad]
  TimeFunctionPtr motion;  // f(t) of a prescribed coordinate; null otherwise
  bool rotation = false;   // motion is an angle (see above), else a displacement
  // Rows on a coordinate q of a joint:
  // - a rotor: no condition, but the inertia J of q. Its multiplier is lambda = J q'', so that
  //     M dv + h + Phi_v^T lambda = Q,  q'' - lambda / J = 0
  //   phi and phi' are zero.
  // - a member of a gear (J = 0): its term `scale` q of the sum; of a cam: `scale` (y(q) - y(0)).
  std::optional<Coordinate> coordinate;
  double inertia = 0.0;                      // J of a rotor > 0 [kg m2 or kg]
  std::shared_ptr<const CubicSpline> curve;  // y of a cam
  // A condition other than a sum of dot products: row `law_row` of a law (rolling.h).
  std::shared_ptr<const RowLaw> law;
  int law_row = 0;
  bool holds_positions() const;  // false: a condition on phi' alone, phi = 0 (nonholonomic)
};

// What row_derivatives() writes besides its results, for pairs of bodies of size n at most.
struct RowScratch {
  static constexpr int kProducts = 10;  // of one row, at most
  explicit RowScratch(Eigen::Index n) : coordinate(n), products(n, kProducts), row(n) {}
  CoordinateScratch coordinate;
  Eigen::MatrixXd products;  // n x kProducts
  Eigen::VectorXd row;
};

// Values of one row at one instant. n = size of the pair of bodies.
struct RowValue {
  double phi = 0.0;    // [m or rad]
  double rate = 0.0;   // phi' = Phi_v v + phi_t
  double acc = 0.0;    // phi'' = Phi_v dv - gamma
  double phi_t = 0.0;  // explicit part of the rate
  double speed = 0.0;  // q' of a rotor [rad/s or m/s]
};

// Rows other than dot products. Arguments as in the functions below.
class RowLaw {
 public:
  virtual ~RowLaw() = default;
  virtual bool holds_positions(int row) const = 0;
  virtual RowValue evaluate(int row, MarkerVectors& vectors, Eigen::Ref<Eigen::VectorXd> phi_v) const = 0;
  // Adds to all arguments.
  virtual void add_derivatives(int row, MarkerVectors& vectors, double lambda, Eigen::Ref<Eigen::VectorXd> rate_dx,
                               Eigen::Ref<Eigen::VectorXd> acc_dx, Eigen::Ref<Eigen::VectorXd> acc_dv,
                               Eigen::Ref<Eigen::MatrixXd> K, RowScratch& scratch) const = 0;
};
inline bool ConstraintRow::holds_positions() const { return !law || law->holds_positions(law_row); }

// phi, phi', phi'' and jacobian row Phi_v (n, overwritten). near: an angle of a gear is taken in the turn nearest to it [rad].
RowValue evaluate_row(const ConstraintRow& row, double t, MarkerVectors& vectors, Eigen::Ref<Eigen::VectorXd> phi_v,
                      double near = 0.0);

// phi, phi' and phi'' alone. scratch: n.
RowValue measure_row(const ConstraintRow& row, double t, MarkerVectors& vectors,
                     const Eigen::Ref<Eigen::VectorXd>& scratch, double near = 0.0);
// The same, and Phi_v^T lambda is pushed on `vectors` or added to `reaction` (n): after the last row of a joint
// vectors.add_pushed(reaction) completes it.
RowValue measure_row_with_reaction(const ConstraintRow& row, double t, MarkerVectors& vectors, double lambda,
                                   const Eigen::Ref<Eigen::VectorXd>& scratch, Eigen::Ref<Eigen::VectorXd> reaction,
                                   double near = 0.0);

// Derivatives; all overwritten except the last:
//   rate_dx = d phi' / dx, acc_dx = d phi'' / dx, acc_dv = d phi'' / dv (n each)
//   K += d(Phi_v^T lambda) / dx (n x n)
void row_derivatives(const ConstraintRow& row, double t, MarkerVectors& vectors, double lambda,
                     Eigen::Ref<Eigen::VectorXd> rate_dx, Eigen::Ref<Eigen::VectorXd> acc_dx,
                     Eigen::Ref<Eigen::VectorXd> acc_dv, Eigen::Ref<Eigen::MatrixXd> K, RowScratch& scratch,
                     double near = 0.0);

}  // namespace footfall
