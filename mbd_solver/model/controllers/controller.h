#pragma once
// A sampled controller: sees the motion of one body at its own period, answers voltages in [0, 1]. Never called inside
// a residual: between two samples its outputs are constants of the model.

#include <Eigen/Dense>
#include <string>
#include <string_view>
#include <vector>

namespace footfall {

inline constexpr double kDefaultControllerPeriod = 1.0e-3;  // [s]

// What is measured on the observed body (the cabin), already in the controller's own terms. Frames: inertial W, z up.
struct ControllerMeasurement {
  double time = 0.0;           // [s]
  double acceleration = 0.0;   // along the up axis, gravity not included (coordinate acceleration) [m/s2]
  double velocity = 0.0;       // along the up axis [m/s]
  double pitch = 0.0;          // alpha, positive when the legs with positive x sink [rad]
  double roll = 0.0;           // beta, positive when the legs with positive y sink [rad]
  Eigen::VectorXd strut_rate;  // rate of each controlled strut, in output order [m/s] (compression positive)
};

class Controller {
 public:
  virtual ~Controller() = default;
  virtual std::string_view kind() const = 0;  // "constant", "fuzzy", "skyhook", "pid"
  virtual int output_count() const = 0;
  virtual double period() const = 0;  // [s] > 0
  // One sample. Writes output_count() voltages, each finite and in [0, 1]. Changes the controller's memory (filter,
  // integral).
  virtual void sample(const ControllerMeasurement& m, Eigen::Ref<Eigen::VectorXd> voltages) = 0;
  // The memory as numbers, so that a run can be checkpointed and resumed to the bit.
  virtual Eigen::VectorXd memory() const = 0;
  virtual void restore(const Eigen::Ref<const Eigen::VectorXd>& memory) = 0;
};

}  // namespace footfall
