#pragma once
// Measured or designed values over one or two inputs: linear between the points, constant outside.

#include <Eigen/Dense>
#include <vector>

#include "mbd_solver/model/signals/signal_block.h"

namespace footfall {

class LookupTable final : public SignalBlock {
 public:
  // y over x: at least two points, x rising. Throws InputError.
  LookupTable(std::vector<double> x, std::vector<double> y);
  // y over x1 (rows) and x2 (columns), bilinear. Throws InputError.
  LookupTable(std::vector<double> x1, std::vector<double> x2, Eigen::MatrixXd y);

  int input_count() const override { return x2_.empty() ? 1 : 2; }
  double value(const BlockValues& u, const BlockValues& z) const override;

 private:
  std::vector<double> x1_, x2_;
  Eigen::MatrixXd y_;  // x1 by x2
};

}  // namespace footfall
