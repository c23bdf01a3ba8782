#pragma once
// What makes one signal y of its inputs u: a transfer function, a limit, a table. Its inner states z belong to whoever
// uses it. A block works in two ways:
//   continuous: y = value(u, z), z' = rates(u, z), integrated with the mechanism
//   sampled:    y_k = sample(u_k, z) at its period T; z then moves to the next sample, u_k held
// No function here allocates.

#include <Eigen/Dense>
#include <string>

namespace footfall {

using BlockValues = Eigen::Ref<const Eigen::VectorXd>;

class SignalBlock {
 public:
  virtual ~SignalBlock() = default;

  virtual int input_count() const { return 1; }
  virtual int state_count() const { return 0; }
  // y depends on u at once. Without, a loop may go through it.
  virtual bool passes_through() const { return true; }
  // z at rest with this input for long; y is then what it settles to.
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
};

// y = u: the value of an expression.
class PassBlock final : public SignalBlock {
 public:
  double value(const BlockValues& u, const BlockValues&) const override { return u[0]; }
};

}  // namespace footfall
