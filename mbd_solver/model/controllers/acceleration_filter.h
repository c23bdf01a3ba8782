#pragma once
// What a sampled controller makes of a raw acceleration: a first-order low-pass and, from its output, the
// jerk.
//   y_k = y_(k-1) + (1 - exp(-2 pi f T)) (a_k - y_(k-1)),   jerk_k = (y_k - y_(k-1)) / T
// the exact response of the analogue filter to a held input. The first sample sets y = a and jerk = 0.

#include <Eigen/Dense>
#include <string_view>

namespace footfall {

inline constexpr double kDefaultFilterFrequency = 50.0;  // [Hz]

class AccelerationFilter {
 public:
  // frequency f: corner [Hz], > 0, or 0 for no filter (y = a). period T > 0 [s]. Throws InputError, naming
  // `owner`.
  AccelerationFilter(std::string_view owner, double frequency, double period);

  void sample(double acceleration);                  // [m/s2]
  double acceleration() const { return filtered_; }  // y [m/s2]
  double jerk() const { return jerk_; }              // [m/s3]

  static constexpr int kMemory = 3;
  void save(Eigen::Ref<Eigen::VectorXd> memory) const;            // kMemory numbers
  void restore(const Eigen::Ref<const Eigen::VectorXd>& memory);  // what save wrote

 private:
  double gain_;    // 1 - exp(-2 pi f T) [-]
  double period_;  // [s]
  bool started_ = false;
  double filtered_ = 0.0, jerk_ = 0.0;
};

}  // namespace footfall
