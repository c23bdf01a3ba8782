// Rows with one constant dot product, most rows of most joints, have a path of their own; the others are sums.

#include "mbd_solver/model/elements/constraint_row.h"

#include <cmath>

namespace footfall {
namespace {

const KinematicVector kDirections[3] = {KinematicVector::constant(Eigen::Vector3d::UnitX()),
                                        KinematicVector::constant(Eigen::Vector3d::UnitY()),
                                        KinematicVector::constant(Eigen::Vector3d::UnitZ())};

const KinematicVector& vector_of(const Factor& factor, MarkerVectors& vectors) {
  switch (factor.kind) {
    case Factor::Kind::kWorldDirection: return kDirections[factor.axis];
    case Factor::Kind::kAxis1: return vectors.axis(0, factor.axis);
    case Factor::Kind::kAxis2: return vectors.axis(1, factor.axis);
    case Factor::Kind::kDifference: break;
  }
  return vectors.difference();
}

// Coefficients c_i(t) of the terms with two derivatives, and the function f(t).
struct Coefficients {
  TimeValue c[2];
  TimeValue f;
};

Coefficients coefficients(const ConstraintRow& row, double t) {
  Coefficients out;
  out.c[0].value = row.scale;
  out.c[1].value = row.scale2;
  out.f.value = row.offset;
  if (!row.motion) return out;
  const TimeValue f = row.motion->at(t);
  if (!row.rotation) {
    out.f = {row.offset + f.value, f.rate, f.accel};
    return out;
  }
  // phi = cos(f) D_1 - sin(f) D_2
  const double s = std::sin(f.value), c = std::cos(f.value);
  out.c[0] = {c, -s * f.rate, -c * f.rate * f.rate - s * f.accel};
  out.c[1] = {-s, -c * f.rate, s * f.rate * f.rate - c * f.accel};
  return out;
}

// y(q) of a cam. On a closed curve the turn of an angle does not matter; on an open one it is that nearest to `near`.
CubicSpline::Value lift(const ConstraintRow& row, double q, double near) {
  if (*row.coordinate == Coordinate::kAngle)
    q = row.curve->closed() ? nearest_turn(q, 0.5 * (row.curve->first() + row.curve->last()))
                            : nearest_turn(q, near) + row.offset;
  return row.curve->at(q);
}

// A rotor: phi'' = q''. A member of a gear: phi = scale q. A cam: phi = scale (y(q) - y(0)).
RowValue evaluate_coordinate(const ConstraintRow& row, MarkerVectors& vectors, Eigen::Ref<Eigen::VectorXd> phi_v,
                             double near) {
  const JointCoordinate q(*row.coordinate, vectors.pair(), vectors.marker(0), vectors.marker(1));
  phi_v.setZero();
  RowValue out;
  if (row.curve) {
    const CubicSpline::Value y = lift(row, q.value(), near);
    q.add_gradient(row.scale * y.slope, phi_v);
    out.phi = row.scale * (y.value - lift(row, 0.0, 0.0).value);
    out.rate = row.scale * y.slope * q.rate();
    out.acc = row.scale * (y.slope * q.acc() + y.curvature * q.rate() * q.rate());
    return out;
  }
  q.add_gradient(row.scale, phi_v);
  out.acc = row.scale * q.acc();
  if (row.inertia > 0.0) {
    out.speed = q.rate();
  } else {
    out.phi = row.scale * (*row.coordinate == Coordinate::kAngle ? nearest_turn(q.value(), near) : q.value());
    out.rate = row.scale * q.rate();
  }
  return out;
}

void coordinate_derivatives(const ConstraintRow& row, MarkerVectors& vectors, double lambda,
                            Eigen::Ref<Eigen::VectorXd> rate_dx, Eigen::Ref<Eigen::VectorXd> acc_dx,
                            Eigen::Ref<Eigen::VectorXd> acc_dv, Eigen::Ref<Eigen::MatrixXd> K,
                            CoordinateScratch& scratch, double near) {
  const JointCoordinate q(*row.coordinate, vectors.pair(), vectors.marker(0), vectors.marker(1));
  if (row.curve) {
    const CubicSpline::Value y = lift(row, q.value(), near);
    const double slope = row.scale * y.slope, curvature = row.scale * y.curvature, third = row.scale * y.third;
    // phi' = y' q',  phi'' = y' q'' + y'' q'^2
    q.add_rate_by_position(slope, scratch, rate_dx);
    q.add_gradient(curvature * q.rate(), rate_dx);
    q.add_acc_by_position(slope, scratch, acc_dx);
    q.add_rate_by_position(2.0 * curvature * q.rate(), scratch, acc_dx);
    q.add_gradient(curvature * q.acc() + third * q.rate() * q.rate(), acc_dx);
    q.add_acc_by_velocity(slope, scratch, acc_dv);
    q.add_gradient(2.0 * curvature * q.rate(), acc_dv);
    if (lambda == 0.0) return;
    q.add_second(slope * lambda, scratch, K);
    Eigen::Ref<Eigen::VectorXd> gradient = scratch.row.head(K.rows());  // the ground has no entries
    gradient.setZero();
    q.add_gradient(1.0, gradient);
    K.noalias() += (curvature * lambda) * gradient * gradient.transpose();
    return;
  }
  if (row.inertia == 0.0) q.add_rate_by_position(row.scale, scratch, rate_dx);
  q.add_acc_by_position(row.scale, scratch, acc_dx);
  q.add_acc_by_velocity(row.scale, scratch, acc_dv);
  if (lambda != 0.0) q.add_second(row.scale * lambda, scratch, K);
}

// One dot product with a constant coefficient c minus a constant: most rows of most joints.
template <typename Use>
RowValue one_product(const ConstraintRow& row, MarkerVectors& vectors, Use use) {
  const double c = row.scale;
  const Factor &first = row.terms[0].alpha, &second = row.terms[0].beta;
  const KinematicVector& beta = vector_of(second, vectors);
  if (first.kind == Factor::Kind::kWorldDirection) {  // a component of beta
    const int k = first.axis;
    use(second, c * Eigen::Vector3d::Unit(k));
    return {c * beta.value()[k] - row.offset, c * beta.rate()[k], c * beta.acc()[k]};
  }
  const KinematicVector& alpha = vector_of(first, vectors);
  use(first, c * beta.value());
  use(second, c * alpha.value());
  const double D = alpha.value().dot(beta.value());
  const double dD = alpha.rate().dot(beta.value()) + alpha.value().dot(beta.rate());
  const double ddD =
      alpha.acc().dot(beta.value()) + 2.0 * alpha.rate().dot(beta.rate()) + alpha.value().dot(beta.acc());
  return {c * D - row.offset, c * dD, c * ddD};
}

// A sum of dot products. use(factor, f): the gradient of phi is the sum of X^T f over its factors.
template <typename Use>
RowValue sum_of_products(const ConstraintRow& row, double t, MarkerVectors& vectors, Use use) {
  // D = alpha.beta,  D' = alpha'.beta + alpha.beta',  D'' = alpha''.beta + 2 alpha'.beta' + alpha.beta''
  if (!row.motion && row.term_count == 1) return one_product(row, vectors, use);
  const Coefficients at = coefficients(row, t);
  RowValue out{-at.f.value, -at.f.rate, -at.f.accel, -at.f.rate};
  for (int i = 0; i < row.term_count; ++i) {
    const KinematicVector& alpha = vector_of(row.terms[i].alpha, vectors);
    const KinematicVector& beta = vector_of(row.terms[i].beta, vectors);
    const double D = alpha.value().dot(beta.value());
    const double dD = alpha.rate().dot(beta.value()) + alpha.value().dot(beta.rate());
    const double ddD =
        alpha.acc().dot(beta.value()) + 2.0 * alpha.rate().dot(beta.rate()) + alpha.value().dot(beta.acc());
    const TimeValue& c = at.c[i];
    out.phi += c.value * D;
    out.rate += c.value * dD + c.rate * D;
    out.acc += c.value * ddD + 2.0 * c.rate * dD + c.accel * D;
    out.phi_t += c.rate * D;
    use(row.terms[i].alpha, c.value * beta.value());
    use(row.terms[i].beta, c.value * alpha.value());
  }
  return out;
}

void push(const Factor& factor, const Eigen::Vector3d& f, MarkerVectors& vectors) {
  switch (factor.kind) {
    case Factor::Kind::kWorldDirection: return;
    case Factor::Kind::kAxis1: return vectors.push_axis(0, factor.axis, f);
    case Factor::Kind::kAxis2: return vectors.push_axis(1, factor.axis, f);
    case Factor::Kind::kDifference: break;
  }
  vectors.push_difference(f);
}

}  // namespace

RowValue evaluate_row(const ConstraintRow& row, double t, MarkerVectors& vectors, Eigen::Ref<Eigen::VectorXd> phi_v,
                      double near) {
  if (row.coordinate) return evaluate_coordinate(row, vectors, phi_v, near);
  if (row.law) return row.law->evaluate(row.law_row, vectors, phi_v);
  phi_v.setZero();
  return sum_of_products(row, t, vectors, [&](const Factor& factor, const Eigen::Vector3d& f) {
    vector_of(factor, vectors).add_transposed(f, phi_v);
  });
}

RowValue measure_row(const ConstraintRow& row, double t, MarkerVectors& vectors,
                     const Eigen::Ref<Eigen::VectorXd>& scratch, double near) {
  if (row.coordinate || row.law) return evaluate_row(row, t, vectors, scratch, near);
  return sum_of_products(row, t, vectors, [](const Factor&, const Eigen::Vector3d&) {});
}

RowValue measure_row_with_reaction(const ConstraintRow& row, double t, MarkerVectors& vectors, double lambda,
                                   const Eigen::Ref<Eigen::VectorXd>& scratch, Eigen::Ref<Eigen::VectorXd> reaction,
                                   double near) {
  if (row.coordinate || row.law) {
    const RowValue value = evaluate_row(row, t, vectors, scratch, near);
    reaction += lambda * scratch;
    return value;
  }
  return sum_of_products(row, t, vectors,
                         [&](const Factor& factor, const Eigen::Vector3d& f) { push(factor, lambda * f, vectors); });
}

void row_derivatives(const ConstraintRow& row, double t, MarkerVectors& vectors, double lambda,
                     Eigen::Ref<Eigen::VectorXd> rate_dx, Eigen::Ref<Eigen::VectorXd> acc_dx,
                     Eigen::Ref<Eigen::VectorXd> acc_dv, Eigen::Ref<Eigen::MatrixXd> K, RowScratch& scratch,
                     double near) {
  rate_dx.setZero();
  acc_dx.setZero();
  acc_dv.setZero();
  if (row.coordinate)
    return coordinate_derivatives(row, vectors, lambda, rate_dx, acc_dx, acc_dv, K, scratch.coordinate, near);
  if (row.law) return row.law->add_derivatives(row.law_row, vectors, lambda, rate_dx, acc_dx, acc_dv, K, scratch);
  const Coefficients at = coefficients(row, t);
  for (int i = 0; i < row.term_count; ++i) {
    const KinematicVector& alpha = vector_of(row.terms[i].alpha, vectors);
    const KinematicVector& beta = vector_of(row.terms[i].beta, vectors);
    const TimeValue& c = at.c[i];
    // Each of the two factors takes its turn as p, the other one is o.
    for (int turn = 0; turn < 2; ++turn) {
      const KinematicVector& p = turn == 0 ? alpha : beta;
      const KinematicVector& o = turn == 0 ? beta : alpha;
      // phi' = c D' + c' D
      p.add_rate_by_position(c.value * o.value(), rate_dx);
      p.add_transposed(c.value * o.rate() + c.rate * o.value(), rate_dx);
      // phi'' = c D'' + 2 c' D' + c'' D
      p.add_acc_by_position(c.value * o.value(), acc_dx);
      p.add_rate_by_position(2.0 * (c.value * o.rate() + c.rate * o.value()), acc_dx);
      p.add_transposed(c.value * o.acc() + 2.0 * c.rate * o.rate() + c.accel * o.value(), acc_dx);
      p.add_acc_by_velocity(c.value * o.value(), acc_dv);
      p.add_transposed(2.0 * (c.value * o.rate() + c.rate * o.value()), acc_dv);
      // d(Phi_v^T lambda) / dx
      if (lambda != 0.0) {
        p.add_second(lambda * c.value * o.value(), K);
        p.add_product((lambda * c.value) * Eigen::Matrix3d::Identity(), o, K);
      }
    }
  }
}

}  // namespace footfall
