// Filters advance by the matrix exponential; tables interpolate; the PID's integral is held back at its limits.

#include "mbd_solver/model/control/signal_blocks.h"

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "coupler/matrix_exponential.h"
#include "mbd_solver/base/parameter_check.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/codes.h"
#include "mbd_solver/model/laws/curves.h"

namespace footfall {

LinearFilter::LinearFilter(const Matrix& A, const Vector& b, const Vector& c, double d, double period)
    : A_(A), A_period_(A), b_(b), c_(c), b_period_(b), d_(d) {
  require_not_negative("filter", "period", period, "s");
  if (period == 0.0) return;
  const Eigen::Index n = b.size();
  Eigen::MatrixXd both = Eigen::MatrixXd::Zero(n + 1, n + 1);  // [z; u]' = [A, b; 0, 0] [z; u]
  both.topLeftCorner(n, n) = A;
  both.topRightCorner(n, 1) = b;
  const Eigen::MatrixXd moved = matrix_exponential(both * period);
  A_period_ = moved.topLeftCorner(n, n);
  b_period_ = moved.topRightCorner(n, 1);
}

LinearFilter LinearFilter::low_pass(double frequency, double period) {
  require_positive("lowpass", "frequency", frequency, "Hz");
  const double w = 2.0 * kPi * frequency;
  return {Matrix::Constant(1, 1, -w), Vector::Constant(1, w), Vector::Ones(1), 0.0, period};
}

LinearFilter LinearFilter::low_pass_2(double frequency, double damping, double period) {
  require_positive("lowpass2", "frequency", frequency, "Hz");
  require_positive("lowpass2", "damping", damping, "");
  const double w = 2.0 * kPi * frequency;
  // z = [y; y'/w]: both of the size of the signal
  Matrix A(2, 2);
  A << 0.0, w, -w, -2.0 * damping * w;
  return {A, (Vector(2) << 0.0, w).finished(), (Vector(2) << 1.0, 0.0).finished(), 0.0, period};
}

LinearFilter LinearFilter::notch(double frequency, double damping, double period) {
  require_positive("notch", "frequency", frequency, "Hz");
  require_positive("notch", "damping", damping, "");
  LinearFilter low = low_pass_2(frequency, damping, period);
  // y = u - 2 D w s / (s^2 + 2 D w s + w^2) u, of which z_2 is the part w s / (...) u
  low.c_ << 0.0, -2.0 * damping;
  low.d_ = 1.0;
  return low;
}

void LinearFilter::settle(const BlockValues& u, Eigen::Ref<Eigen::VectorXd> z) const {
  z.setZero();
  z[0] = u[0];  // A z + b u = 0 for all kinds
}

double LinearFilter::value(const BlockValues& u, const BlockValues& z) const {
  double y = d_ * u[0];
  for (Eigen::Index i = 0; i < z.size(); ++i) y += c_[i] * z[i];
  return y;
}

void LinearFilter::rates(const BlockValues& u, const BlockValues& z, Eigen::Ref<Eigen::VectorXd> dz) const {
  dz.noalias() = A_.lazyProduct(z);
  dz += u[0] * b_;
}

void LinearFilter::advance(const BlockValues& u, double, Eigen::Ref<Eigen::VectorXd> z) const {
  const Vector next = A_period_.lazyProduct(z) + u[0] * b_period_;
  z = next;
}

namespace {

struct TablePlace {
  Eigen::Index cell;
  double share;  // of the point after the cell, in [0, 1]
};

TablePlace table_place(const std::vector<double>& x, double u) {
  const auto next = std::upper_bound(x.begin() + 1, x.end() - 1, u);
  const auto cell = static_cast<std::size_t>(next - x.begin()) - 1;
  return {static_cast<Eigen::Index>(cell), std::clamp((u - x[cell]) / (x[cell + 1] - x[cell]), 0.0, 1.0)};
}

void demand_rising(const std::vector<double>& x) {
  if (x.size() < 2) throw InputError(code::kTableShape, "table: expected at least two points.");
  for (std::size_t i = 1; i < x.size(); ++i)
    if (!(x[i] > x[i - 1]))
      throw InputError(code::kCurveNotRising, "table: " + number_text(x[i]) + " follows " + number_text(x[i - 1]) +
                                                  "; expected rising inputs.");
}

}  // namespace

LookupTable::LookupTable(std::vector<double> x, std::vector<double> y) : x1_(std::move(x)) {
  demand_rising(x1_);
  FOOTFALL_DEMAND(y.size() == x1_.size());
  y_ = Eigen::Map<const Eigen::VectorXd>(y.data(), static_cast<Eigen::Index>(y.size()));
  corners_ = corners_of_lines(x1_, y);
}

LookupTable::LookupTable(std::vector<double> x1, std::vector<double> x2, Eigen::MatrixXd y)
    : x1_(std::move(x1)), x2_(std::move(x2)), y_(std::move(y)), corners_(x1_) {
  demand_rising(x1_);
  demand_rising(x2_);
  FOOTFALL_DEMAND(y_.rows() == static_cast<Eigen::Index>(x1_.size()) &&
                  y_.cols() == static_cast<Eigen::Index>(x2_.size()));
}

double LookupTable::value(const BlockValues& u, const BlockValues&) const {
  const TablePlace row = table_place(x1_, u[0]);
  const auto along = [&](Eigen::Index column) {
    return (1.0 - row.share) * y_(row.cell, column) + row.share * y_(row.cell + 1, column);
  };
  if (x2_.empty()) return along(0);
  const TablePlace column = table_place(x2_, u[1]);
  return (1.0 - column.share) * along(column.cell) + column.share * along(column.cell + 1);
}

double LookupTable::piece(const BlockValues& u) const {
  const auto before = [](const std::vector<double>& x, double at) {
    return static_cast<double>(std::upper_bound(x.begin(), x.end(), at) - x.begin());
  };
  const double row = before(corners_, u[0]);
  return x2_.empty() ? row : row + static_cast<double>(corners_.size() + 1) * before(x2_, u[1]);
}

PidBlock::PidBlock(const PidBlockParameters& parameters)
    : parameters_(parameters), w_(2.0 * kPi * parameters.derivative_frequency) {
  const PidBlockParameters& p = parameters_;
  require_not_negative("pid", "kp", p.kp, "");
  require_not_negative("pid", "ki", p.ki, "");
  require_not_negative("pid", "kd", p.kd, "");
  require_not_negative("pid", "derivative_frequency", p.derivative_frequency, "Hz");
  if (p.min && p.max && !(*p.min < *p.max)) throw InputError(code::kParametersDisagree, "pid: min is not below max.");
  if ((p.min || p.max) && p.ki > 0.0 && !(p.kp > 0.0))
    throw InputError(code::kParametersDisagree, "pid: ki with limits requires kp, for the anti-windup.");
  if (has_rate() && p.period == 0.0 && w_ == 0.0)
    throw InputError(code::kParametersDisagree,
                     "pid: kd of a continuous pid requires derivative_frequency, a rate as second input, or a period.");
}

double PidBlock::unlimited(const BlockValues& u, const BlockValues& z) const {
  const PidBlockParameters& p = parameters_;
  double v = p.bias + p.kp * u[0];
  if (has_integral()) v += p.ki * z[0];
  if (p.kd > 0.0) {
    const double gain = w_ > 0.0 ? w_ : 1.0 / p.period;
    v += p.kd * (p.rate_is_given ? u[1] : gain * (u[0] - z[z.size() - 1]));
  }
  return v;
}

double PidBlock::limited(double v) const {
  if (parameters_.min) v = std::max(v, *parameters_.min);
  if (parameters_.max) v = std::min(v, *parameters_.max);
  return v;
}

double PidBlock::integral_rate(const BlockValues& u, const BlockValues& z) const {
  const double v = unlimited(u, z), cut = limited(v) - v;
  return cut == 0.0 ? u[0] : u[0] + cut / parameters_.kp;
}

void PidBlock::settle(const BlockValues& u, Eigen::Ref<Eigen::VectorXd> z) const {
  z.setZero();
  if (has_rate()) z[z.size() - 1] = u[0];
}

double PidBlock::value(const BlockValues& u, const BlockValues& z) const { return limited(unlimited(u, z)); }

void PidBlock::rates(const BlockValues& u, const BlockValues& z, Eigen::Ref<Eigen::VectorXd> dz) const {
  if (has_rate()) dz[dz.size() - 1] = w_ * (u[0] - z[z.size() - 1]);
  if (has_integral()) dz[0] = integral_rate(u, z);
}

void PidBlock::advance(const BlockValues& u, double period, Eigen::Ref<Eigen::VectorXd> z) const {
  if (has_integral()) z[0] += period * integral_rate(u, z);
  if (!has_rate()) return;
  double& filtered = z[z.size() - 1];
  filtered = w_ > 0.0 ? filtered - std::expm1(-w_ * period) * (u[0] - filtered) : u[0];
}

}  // namespace footfall
