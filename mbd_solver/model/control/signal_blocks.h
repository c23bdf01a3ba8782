#pragma once
// Blocks of signals: from inputs u to one signal y. Filters, limits, PID, lookup tables.

#include <Eigen/Dense>
#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

namespace footfall {

class Archive;

using BlockValues = Eigen::Ref<const Eigen::VectorXd>;

// A block works in two ways; its inner states z belong to the caller:
//   continuous: y = value(u, z), z' = rates(u, z), integrated with the mechanism
//   sampled:    y_k = sample(u_k, z) at its period T; z then advances to the next sample, with u_k held
// No function allocates.
class SignalBlock {
 public:
  virtual ~SignalBlock() = default;

  virtual int input_count() const { return 1; }
  virtual int state_count() const { return 0; }
  // y depends on u directly. If false, a loop of signals may contain this block.
  virtual bool passes_through() const { return true; }
  // z of the steady state with this input.
  virtual void settle(const BlockValues&, Eigen::Ref<Eigen::VectorXd>) const {}
  virtual double value(const BlockValues& u, const BlockValues& z) const = 0;
  virtual void rates(const BlockValues&, const BlockValues&, Eigen::Ref<Eigen::VectorXd>) const {}
  // z over one period T [s] with u held.
  virtual void advance(const BlockValues&, double, Eigen::Ref<Eigen::VectorXd>) const {}
  virtual double sample(const BlockValues& u, double period, Eigen::Ref<Eigen::VectorXd> z) const {
    const double y = value(u, z);
    advance(u, period, z);
    return y;
  }
  // Blocks without memory whose value is a line in each of several pieces, in steps of the inputs: the piece at u.
  virtual bool has_pieces() const { return false; }
  virtual double piece(const BlockValues&) const { return 0.0; }
  // A separate program computes y, which only a run starts (assemble/foreign_block.h).
  virtual bool runs_apart() const { return false; }
  // Scratch data of one evaluation, of a block that stores its last result; null: any number of evaluations may share the block.
  virtual std::unique_ptr<SignalBlock> copy() const { return nullptr; }
  // Its data in a checkpoint besides z.
  virtual void visit(Archive&) {}
};

// y = u: the value of an expression.
class PassBlock final : public SignalBlock {
 public:
  double value(const BlockValues& u, const BlockValues&) const override { return u[0]; }
};

// y = u within [min, max]
class Saturation final : public SignalBlock {
 public:
  Saturation(std::optional<double> min, std::optional<double> max) : min_(min), max_(max) {}
  double value(const BlockValues& u, const BlockValues&) const override {
    double y = u[0];
    if (min_) y = std::max(y, *min_);
    if (max_) y = std::min(y, *max_);
    return y;
  }
  bool has_pieces() const override { return true; }
  double piece(const BlockValues& u) const override {
    return min_ && u[0] < *min_ ? -1.0 : max_ && u[0] > *max_ ? 1.0 : 0.0;
  }

 private:
  std::optional<double> min_, max_;
};

// y_k = y_(k-1) + (u_k - y_(k-1)), the change within +- r T. Sampled only: its rate jumps.
class RateLimit final : public SignalBlock {
 public:
  explicit RateLimit(double largest_rate) : rate_(largest_rate) {}  // r > 0 [unit/s]
  int state_count() const override { return 1; }                    // y_(k-1)
  void settle(const BlockValues& u, Eigen::Ref<Eigen::VectorXd> z) const override { z[0] = u[0]; }
  double value(const BlockValues&, const BlockValues& z) const override { return z[0]; }
  double sample(const BlockValues& u, double period, Eigen::Ref<Eigen::VectorXd> z) const override {
    z[0] += std::clamp(u[0] - z[0], -rate_ * period, rate_ * period);
    return z[0];
  }

 private:
  double rate_;
};

// Linear filters with unit gain at rest, w = 2 pi f:
//   low pass, first order   1 / (1 + s/w)
//   low pass, second order  w^2 / (s^2 + 2 D w s + w^2)
//   notch                   (s^2 + w^2) / (s^2 + 2 D w s + w^2): zero gain at f, width 2 D f
// as z' = A z + b u, y = c.z + d u. Sampled, z advances by exp(A T): the exact response to held inputs.
class LinearFilter final : public SignalBlock {
 public:
  // frequency f > 0 [Hz], damping D > 0 [-]; period T > 0 [s] or 0 for a continuous filter. Throw InputError.
  static LinearFilter low_pass(double frequency, double period);
  static LinearFilter low_pass_2(double frequency, double damping, double period);
  static LinearFilter notch(double frequency, double damping, double period);

  int state_count() const override { return static_cast<int>(b_.size()); }
  bool passes_through() const override { return d_ != 0.0; }
  void settle(const BlockValues& u, Eigen::Ref<Eigen::VectorXd> z) const override;
  double value(const BlockValues& u, const BlockValues& z) const override;
  void rates(const BlockValues& u, const BlockValues& z, Eigen::Ref<Eigen::VectorXd> dz) const override;
  void advance(const BlockValues& u, double period, Eigen::Ref<Eigen::VectorXd> z) const override;

 private:
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 2, 2>;  // no allocation
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 2, 1>;
  LinearFilter(const Matrix& A, const Vector& b, const Vector& c, double d, double period);

  Matrix A_, A_period_;  // A; exp(A T)
  Vector b_, c_, b_period_;
  double d_;
};

// Measured or designed values over one or two inputs: linear between the points, constant outside.
class LookupTable final : public SignalBlock {
 public:
  // y over x: at least two points, x rising. Throws InputError.
  LookupTable(std::vector<double> x, std::vector<double> y);
  // y over x1 (rows) and x2 (columns), bilinear. Throws InputError.
  LookupTable(std::vector<double> x1, std::vector<double> x2, Eigen::MatrixXd y);

  int input_count() const override { return x2_.empty() ? 1 : 2; }
  double value(const BlockValues& u, const BlockValues& z) const override;
  bool has_pieces() const override { return true; }
  double piece(const BlockValues& u) const override;

 private:
  std::vector<double> x1_, x2_;
  Eigen::MatrixXd y_;            // x1 by x2
  std::vector<double> corners_;  // x1 at which the slope changes; for two inputs all
};

// PID with limits and anti-windup.
//   v = bias + kp e + ki I + kd D,   y = v within [min, max]
//   I' = e + (y - v) / kp:  the integral stops growing at a limit
//   D = the second input if there is one, else the filtered rate D = w (e - z), z' = w (e - z), w = 2 pi f
// Sampled: I by Euler's rule, z exactly; without f the rate is the difference over a period, D = (e_k - e_k-1) / T.
struct PidBlockParameters {
  double kp = 0.0, ki = 0.0, kd = 0.0;  // >= 0 [unit, unit/s, unit s]
  double bias = 0.0;
  std::optional<double> min, max;
  double derivative_frequency = 0.0;  // f >= 0 [Hz]; 0: none, sampled only
  bool rate_is_given = false;         // by the second input
  double period = 0.0;                // [s]; 0: continuous
};

class PidBlock final : public SignalBlock {
 public:
  explicit PidBlock(const PidBlockParameters& parameters);  // throws InputError

  int input_count() const override { return parameters_.rate_is_given ? 2 : 1; }
  int state_count() const override { return (has_integral() ? 1 : 0) + (has_rate() ? 1 : 0); }
  void settle(const BlockValues& u, Eigen::Ref<Eigen::VectorXd> z) const override;
  double value(const BlockValues& u, const BlockValues& z) const override;
  void rates(const BlockValues& u, const BlockValues& z, Eigen::Ref<Eigen::VectorXd> dz) const override;
  void advance(const BlockValues& u, double period, Eigen::Ref<Eigen::VectorXd> z) const override;

 private:
  bool has_integral() const { return parameters_.ki > 0.0; }
  bool has_rate() const { return parameters_.kd > 0.0 && !parameters_.rate_is_given; }
  double unlimited(const BlockValues& u, const BlockValues& z) const;  // v
  double limited(double v) const;
  double integral_rate(const BlockValues& u, const BlockValues& z) const;  // I'

  PidBlockParameters parameters_;
  double w_ = 0.0;  // [rad/s]
};

}  // namespace footfall
