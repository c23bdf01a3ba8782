#pragma once
// What names of expressions stand for at a sample: columns of the history, all of them, recorded or not; signals, states,
// inputs and time.

#include <string>
#include <vector>

#include "coupler/archive.h"
#include "mbd_solver/run/observe/columns.h"
#include "mbd_solver/run/observe/metrics.h"
#include "mbd_solver/run/observe/sampler.h"

namespace footfall {

class Readings {
 public:
  // names: those that will be asked for. Throws InputError, a line "FILE:LINE: ..." for each that nothing has.
  Readings(const std::vector<std::string>& names, const Subject& subject);
  Readings(const Readings&) = delete;
  Readings& operator=(const Readings&) = delete;

  // Before values are asked for.
  void take(const Sample& sample);
  // Of names[k]. inputs: those of the window that begins, as far as they are known.
  double value(std::size_t k, const Sample& sample, const Eigen::VectorXd& values) const;

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

// The rows of history.csv, and what flexible bodies and joints did in them.

class Observation {
 public:
  explicit Observation(const Subject& subject);
  Observation(const Observation&) = delete;  // the columns read the parts of this one
  Observation& operator=(const Observation&) = delete;

  std::vector<std::string> names() const;
  std::vector<std::string> units() const;
  // One row, in the order of the names. The reference holds until the next call.
  const std::vector<double>& row(const Sample& sample);
  // Of all flexible bodies, over the rows so far.
  const FlexibleBodies& flexible() const { return flexible_; }
  void visit(Archive& archive) {
    archive("flexible", flexible_);
    archive("joints", joints_);
  }
  const JointFigures& joints() const { return joints_; }

 private:
  FlexibleBodies flexible_;
  JointFigures joints_;
  std::vector<Column> columns_;
  std::vector<double> row_;
};

}  // namespace footfall
