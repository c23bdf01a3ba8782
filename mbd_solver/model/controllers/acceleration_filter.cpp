#include "mbd_solver/model/controllers/acceleration_filter.h"

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/parameter_check.h"

namespace footfall {

AccelerationFilter::AccelerationFilter(std::string_view owner, double frequency, double period) : period_(period) {
  constexpr double kTwoPi = 6.28318530717958647692;
  require_not_negative(owner, "filter_frequency", frequency, "Hz");
  require_positive(owner, "period", period, "s");
  gain_ = frequency > 0.0 ? -std::expm1(-kTwoPi * frequency * period) : 1.0;
}

void AccelerationFilter::sample(double acceleration) {
  const double before = started_ ? filtered_ : acceleration;
  filtered_ = before + gain_ * (acceleration - before);
  jerk_ = (filtered_ - before) / period_;
  started_ = true;
}

void AccelerationFilter::save(Eigen::Ref<Eigen::VectorXd> memory) const {
  FOOTFALL_DEMAND(memory.size() == kMemory);
  memory << (started_ ? 1.0 : 0.0), filtered_, jerk_;
}

void AccelerationFilter::restore(const Eigen::Ref<const Eigen::VectorXd>& memory) {
  FOOTFALL_DEMAND(memory.size() == kMemory);
  started_ = memory[0] != 0.0;
  filtered_ = memory[1];
  jerk_ = memory[2];
}

}  // namespace footfall
