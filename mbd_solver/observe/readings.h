#pragma once
// What names of expressions stand for at a sample: columns of the history, all of them, recorded or not; signals, states,
// voltages and time.

#include <string>
#include <vector>

#include "coupler/archive.h"
#include "mbd_solver/observe/columns.h"

namespace footfall {

class Readings {
 public:
  // names: those that will be asked for. Throws InputError, a line "FILE:LINE: ..." for each that nothing has.
  Readings(const std::vector<std::string>& names, const Subject& subject);
  Readings(const Readings&) = delete;
  Readings& operator=(const Readings&) = delete;

  // Before values are asked for.
  void take(const Sample& sample);
  // Of names[k]. voltages: those of the window that begins, as far as they are known.
  double value(std::size_t k, const Sample& sample, const Eigen::VectorXd& voltages) const;

  void visit(Archive& archive) {
    archive("flexible", flexible_);
    archive("joints", joints_);
  }

 private:
  struct Reading {
    std::optional<SignalSource> source;  // else a column
    bool continuous = false;             // a continuous signal: that of the sample
    std::function<double(const Sample&)> column;
  };

  Scene scene_;  // whose output records everything
  Subject subject_;
  FlexibleBodies flexible_;
  JointFigures joints_;
  bool uses_flexible_ = false, uses_joints_ = false;
  std::vector<Reading> readings_;
};

}  // namespace footfall
