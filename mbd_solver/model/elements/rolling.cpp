// The rows are functions of ten dot products and their rates; automatic differentiation gives their derivatives.

#include "mbd_solver/model/elements/rolling.h"

#include <cmath>
#include <unsupported/Eigen/AutoDiff>

namespace footfall {
namespace {

// The dot products that a row is written in: d_k, then the axes of marker 2 in the frame of marker 1.
enum : int { kD = 0, kX = 1, kY = 4, kA = 7, kCount = 10 };
static_assert(kCount == RowScratch::kProducts);

using ByValue = Eigen::AutoDiffScalar<Eigen::Matrix<double, kCount, 1>>;    // derivatives by u
using ByAll = Eigen::AutoDiffScalar<Eigen::Matrix<double, 3 * kCount, 1>>;  // by u, u', u''

// Values of the dot products, their rates and second derivatives.
template <typename T>
struct Products {
  T u[kCount], du[kCount], ddu[kCount];
};

// Velocity of the contact point along axis k of marker 1, its derivative, and the gap.
template <typename T>
struct Condition {
  T phi, rate, acc;
};

template <typename T>
T root_of(const T& x) {
  using std::sqrt;
  return sqrt(x);
}

template <typename T>
Condition<T> sphere(double R, int k, const Products<T>& p) {
  // w_x = sum_j E_jy E_jz', w_y = sum_j E_jz E_jx', E_j the axes of marker 2
  Condition<T> out{T(0.0), p.du[kD], p.ddu[kD]};
  if (k == 2) {
    out.phi = p.u[kD] - R;
    return out;
  }
  const int other = k == 0 ? 2 : 1, turned = k == 0 ? 0 : 2;
  const double sign = k == 0 ? -R : R;
  for (const int axis : {kX, kY, kA}) {
    out.rate += sign * (p.u[axis + other] * p.du[axis + turned]);
    out.acc += sign * (p.u[axis + other] * p.ddu[axis + turned] + p.du[axis + other] * p.du[axis + turned]);
  }
  return out;
}

template <typename T>
Condition<T> disc(double R, int k, const Products<T>& p) {
  const T &ax = p.u[kA], &ay = p.u[kA + 1], &dax = p.du[kA], &day = p.du[kA + 1];
  const T s = root_of(T(ax * ax + ay * ay));
  const T ds = (ax * dax + ay * day) / s;
  Condition<T> out{T(0.0), p.du[kD], p.ddu[kD]};
  if (k == 2) {
    const T dds = (dax * dax + ax * p.ddu[kA] + day * day + ay * p.ddu[kA + 1] - ds * ds) / s;
    out.phi = p.u[kD] - R * s;
    out.rate -= R * ds;
    out.acc -= R * dds;
    return out;
  }
  T sigma(0.0), dsigma(0.0);
  for (int i = 0; i < 3; ++i) {
    sigma += p.du[kX + i] * p.u[kY + i];
    dsigma += p.ddu[kX + i] * p.u[kY + i] + p.du[kX + i] * p.du[kY + i];
  }
  // h s = n x a
  const T hs = k == 0 ? T(-ay) : T(ax), dhs = k == 0 ? T(-day) : T(dax);
  const T h = hs / s, dh = (dhs - h * ds) / s;
  const T c = p.u[kA + k] / s, dc = (p.du[kA + k] - c * ds) / s;
  out.rate += R * (sigma * h + c * p.du[kA + 2]);
  out.acc += R * (dsigma * h + sigma * dh + dc * p.du[kA + 2] + c * p.ddu[kA + 2]);
  return out;
}

Condition<ByAll> condition(double R, bool is_disc, int k, const Products<ByAll>& p) {
  return is_disc ? disc(R, k, p) : sphere(R, k, p);
}

// c_m with u_k = sum_m c_m u_m', for their derivatives by u.
void weights(double R, bool is_disc, int k, const ByValue (&u)[kCount], ByValue (&c)[kCount]) {
  for (ByValue& weight : c) weight = ByValue(0.0);
  c[kD] = ByValue(1.0);
  if (!is_disc) {
    if (k == 2) return;
    const int other = k == 0 ? 2 : 1, turned = k == 0 ? 0 : 2;
    for (const int axis : {kX, kY, kA}) c[axis + turned] = (k == 0 ? -R : R) * u[axis + other];
    return;
  }
  const ByValue s = root_of(ByValue(u[kA] * u[kA] + u[kA + 1] * u[kA + 1]));
  if (k == 2) {
    c[kA] = -R * u[kA] / s;
    c[kA + 1] = -R * u[kA + 1] / s;
    return;
  }
  const ByValue h = (k == 0 ? ByValue(-u[kA + 1]) : u[kA]) / s;
  for (int i = 0; i < 3; ++i) c[kX + i] = R * h * u[kY + i];
  c[kA + 2] = R * u[kA + k] / s;
}

// The two vectors of dot product m of the row along axis k.
std::pair<const KinematicVector&, const KinematicVector&> factors(int m, int k, MarkerVectors& vectors) {
  if (m == kD) return {vectors.axis(0, k), vectors.difference()};
  return {vectors.axis(0, (m - kX) % 3), vectors.axis(1, (m - kX) / 3)};
}

template <typename T>
Products<T> products(int k, MarkerVectors& vectors) {
  Products<T> out;
  for (int m = 0; m < kCount; ++m) {
    const auto [a, b] = factors(m, k, vectors);
    out.u[m] = T(a.value().dot(b.value()));
    out.du[m] = T(dot_rate(a, b));
    out.ddu[m] = T(dot_acc(a, b));
  }
  return out;
}

Products<ByAll> variables(int k, MarkerVectors& vectors) {
  Products<ByAll> out = products<ByAll>(k, vectors);
  for (int m = 0; m < kCount; ++m) {
    out.u[m].derivatives() = Eigen::Matrix<double, 3 * kCount, 1>::Unit(m);
    out.du[m].derivatives() = Eigen::Matrix<double, 3 * kCount, 1>::Unit(kCount + m);
    out.ddu[m].derivatives() = Eigen::Matrix<double, 3 * kCount, 1>::Unit(2 * kCount + m);
  }
  return out;
}

}  // namespace

RowValue Rolling::evaluate(int row, MarkerVectors& vectors, Eigen::Ref<Eigen::VectorXd> phi_v) const {
  const Condition<ByAll> at = condition(radius_, disc_, row, variables(row, vectors));
  phi_v.setZero();
  for (int m = 0; m < kCount; ++m) {
    const double weight = at.rate.derivatives()[kCount + m];
    if (weight == 0.0) continue;
    const auto [a, b] = factors(m, row, vectors);
    add_dot(a, b, weight, phi_v);
  }
  RowValue out;
  out.phi = at.phi.value();
  out.rate = at.rate.value();
  out.acc = at.acc.value();
  return out;
}

void Rolling::add_derivatives(int row, MarkerVectors& vectors, double lambda, Eigen::Ref<Eigen::VectorXd> rate_dx,
                              Eigen::Ref<Eigen::VectorXd> acc_dx, Eigen::Ref<Eigen::VectorXd> acc_dv,
                              Eigen::Ref<Eigen::MatrixXd> K, RowScratch& scratch) const {
  const Condition<ByAll> at = condition(radius_, disc_, row, variables(row, vectors));
  const auto by = [](const ByAll& of, int m) { return of.derivatives()[m]; };
  for (int m = 0; m < kCount; ++m) {
    const auto [a, b] = factors(m, row, vectors);
    add_dot(a, b, by(at.rate, m), rate_dx);
    add_dot_rate(a, b, by(at.rate, kCount + m), rate_dx);
    add_dot(a, b, by(at.acc, m), acc_dx);
    add_dot_rate(a, b, by(at.acc, kCount + m), acc_dx);
    add_dot_acc(a, b, by(at.acc, 2 * kCount + m), acc_dx);
    add_dot(a, b, by(at.acc, kCount + m), acc_dv);
    add_dot_acc_by_velocity(a, b, by(at.acc, 2 * kCount + m), acc_dv);
  }
  if (lambda == 0.0) return;
  // d(sum c_m u_m,x)/dx = sum c_m u_m,xx + sum u_m,x (sum_n c_m,n u_n,x)^T
  ByValue u[kCount], c[kCount];
  for (int m = 0; m < kCount; ++m) {
    const auto [a, b] = factors(m, row, vectors);
    u[m] = ByValue(a.value().dot(b.value()), kCount, m);
  }
  weights(radius_, disc_, row, u, c);
  const Eigen::Index n = K.rows();
  Eigen::Ref<Eigen::MatrixXd> u_x = scratch.products.topRows(n);
  Eigen::Ref<Eigen::VectorXd> sum = scratch.row.head(n);
  for (int m = 0; m < kCount; ++m) {
    const auto [a, b] = factors(m, row, vectors);
    sum.setZero();
    add_dot(a, b, 1.0, sum);
    u_x.col(m) = sum;
    if (c[m].value() != 0.0) add_dot_second(a, b, lambda * c[m].value(), K);
  }
  for (int m = 0; m < kCount; ++m) {
    if (c[m].derivatives().isZero(0.0)) continue;
    sum.noalias() = u_x * c[m].derivatives();
    for (Eigen::Index j = 0; j < n; ++j) K.col(j) += (lambda * sum[j]) * u_x.col(m);
  }
}

}  // namespace footfall
