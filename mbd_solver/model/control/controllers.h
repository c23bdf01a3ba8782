#pragma once
// Sampled controllers: from the motion of one body, at their own period, to damper inputs in [0, 1]. They are never called inside
// a residual; between two samples their outputs are constants of the model.

#include <Eigen/Dense>
#include <string_view>

namespace footfall {

inline constexpr double kDefaultControllerPeriod = 1.0e-3;  // [s]

// Measurements on the monitored body (the cabin). Frame: inertial W, z up.
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
  // One sample. Writes output_count() damper inputs, each finite and in [0, 1], and updates the memory (filter, integral).
  virtual void sample(const ControllerMeasurement& m, Eigen::Ref<Eigen::VectorXd> voltages) = 0;
  // The memory as numbers, for checkpoints.
  virtual Eigen::VectorXd memory() const = 0;
  virtual void restore(const Eigen::Ref<const Eigen::VectorXd>& memory) = 0;
};

inline constexpr double kDefaultFilterFrequency = 50.0;  // [Hz]

// First-order low-pass of a sampled acceleration, and the jerk of its output:
//   y_k = y_(k-1) + (1 - exp(-2 pi f T)) (a_k - y_(k-1)),   jerk_k = (y_k - y_(k-1)) / T
// the exact response of the analogue filter to a held input. The first sample sets y = a and jerk = 0.
class AccelerationFilter {
 public:
  // frequency f: corner [Hz], > 0, or 0 for no filter (y = a). period T > 0 [s]. Throws InputError, naming `owner`.
  AccelerationFilter(std::string_view owner, double frequency, double period);

  void sample(double acceleration);                  // [m/s2]
  double acceleration() const { return filtered_; }  // y [m/s2]
  double jerk() const { return jerk_; }              // [m/s3]

  static constexpr int kMemory = 3;
  void save(Eigen::Ref<Eigen::VectorXd> memory) const;            // kMemory numbers
  void restore(const Eigen::Ref<const Eigen::VectorXd>& memory);  // as written by save()

 private:
  double gain_;    // 1 - exp(-2 pi f T) [-]
  double period_;  // [s]
  bool started_ = false;
  double filtered_ = 0.0, jerk_ = 0.0;
};

// Constant damper inputs: the passive strut of comparisons.
struct ConstantControllerParameters {
  Eigen::VectorXd voltages;                  // one per controlled strut, each in [0, 1] [-]; at least one
  double period = kDefaultControllerPeriod;  // > 0 [s]
};

class ConstantController final : public Controller {
 public:
  explicit ConstantController(const ConstantControllerParameters& parameters);  // throws InputError

  std::string_view kind() const override { return "constant"; }
  int output_count() const override { return static_cast<int>(parameters_.voltages.size()); }
  double period() const override { return parameters_.period; }
  void sample(const ControllerMeasurement& m, Eigen::Ref<Eigen::VectorXd> voltages) override;
  Eigen::VectorXd memory() const override { return {}; }
  void restore(const Eigen::Ref<const Eigen::VectorXd>& memory) override;

 private:
  ConstantControllerParameters parameters_;
};

// PID on the vertical acceleration: controls the deceleration of the body to a set value.
//   e = set_point - a,   U = clamp(bias + kp e + ki integral(e) - kd jerk, 0, 1),   the same for every strut
// a and jerk come from the acceleration filter. The integral stops while U is saturated in the direction of e (anti-windup),
// and while the body does not decelerate (a <= 0), so that free fall does not wind it up.
struct PidControllerParameters {
  int outputs = 4;                                    // controlled struts >= 1
  double period = kDefaultControllerPeriod;           // > 0 [s]
  double filter_frequency = kDefaultFilterFrequency;  // corner of the acceleration filter, 0 = none [Hz]
  double set_point = 29.4;                            // required upward acceleration > 0 (3 g) [m/s2]
  double kp = 0.03;                                   // >= 0 [s2/m]
  double ki = 0.5;                                    // >= 0 [s/m]
  double kd = 0.0;                                    // >= 0 [s3/m]
  double bias = 0.0;                                  // U without error, in [0, 1] [-]
};

class PidController final : public Controller {
 public:
  explicit PidController(const PidControllerParameters& parameters);  // throws InputError

  std::string_view kind() const override { return "pid"; }
  int output_count() const override { return parameters_.outputs; }
  double period() const override { return parameters_.period; }
  void sample(const ControllerMeasurement& m, Eigen::Ref<Eigen::VectorXd> voltages) override;
  Eigen::VectorXd memory() const override;
  void restore(const Eigen::Ref<const Eigen::VectorXd>& memory) override;

 private:
  PidControllerParameters parameters_;
  AccelerationFilter filter_;
  double integral_ = 0.0;  // of e [m/s]
};

// On-off skyhook (Karnopp 1974), strut by strut: a strut is on while its damper force opposes the motion of the body. A
// compressing strut (rate > 0) pushes the body up, so
//   U_i = on   if velocity * rate_i < 0 (body sinks while the strut compresses, or rises while it extends),
//   else off
// U_i does not change while |rate_i| < deadband or |velocity| < deadband: no chatter at rest.
struct SkyhookControllerParameters {
  int outputs = 4;                           // controlled struts >= 1
  double period = kDefaultControllerPeriod;  // > 0 [s]
  double on = 1.0;                           // voltage in [0, 1] [-]
  double off = 0.0;                          // voltage in [0, on] [-]; also the value before the first decision
  double deadband = 0.01;                    // >= 0 [m/s]
};

class SkyhookController final : public Controller {
 public:
  explicit SkyhookController(const SkyhookControllerParameters& parameters);  // throws InputError

  std::string_view kind() const override { return "skyhook"; }
  int output_count() const override { return parameters_.outputs; }
  double period() const override { return parameters_.period; }
  void sample(const ControllerMeasurement& m, Eigen::Ref<Eigen::VectorXd> voltages) override;
  Eigen::VectorXd memory() const override { return held_; }
  void restore(const Eigen::Ref<const Eigen::VectorXd>& memory) override;

 private:
  SkyhookControllerParameters parameters_;
  Eigen::VectorXd held_;  // last voltages
};

}  // namespace footfall
