#pragma once
// What is read from samples: values for expressions (Readings), and the rows of history.csv (Observation).

#include <optional>
#include <string>
#include <vector>

#include "coupler/archive.h"
#include "mbd_solver/session/observe/columns.h"
#include "mbd_solver/session/observe/landing.h"
#include "mbd_solver/session/observe/metrics.h"
#include "mbd_solver/session/observe/sampler.h"

namespace footfall {

// Values of names in expressions: columns of the history, recorded or not; signals, states, inputs and time.
class Readings {
 public:
  // names: all that will be read. Throws InputError, a line "FILE:LINE: ..." for each unknown one.
  Readings(const std::vector<std::string>& names, const Subject& subject);
  Readings(const Readings&) = delete;
  Readings& operator=(const Readings&) = delete;

  void update(const Sample& sample);  // before values are read
  // Of names[k]. values: inputs of the window that begins, as far as they are known.
  double value(std::size_t k, const Sample& sample, const Eigen::VectorXd& values) const;

  void visit(Archive& archive) {
    archive("flexible", flexible_);
    archive("joints", joints_);
    if (landing_) archive("landing", *landing_);
  }

 private:
  struct Reading {
    std::optional<SignalSource> source;  // otherwise a column
    bool continuous = false;             // a continuous signal: its value in the sample
    std::function<double(const Sample&)> column;
  };

  Scene scene_;  // whose output records everything
  Subject subject_;
  FlexibleBodies flexible_;
  JointObserver joints_;
  std::optional<LandingWatch> landing_;
  bool uses_flexible_ = false, uses_joints_ = false, uses_landing_ = false;
  std::vector<Reading> readings_;
};

// The rows of history.csv, with the metrics of flexible bodies and joints.
class Observation {
 public:
  explicit Observation(const Subject& subject);
  Observation(const Observation&) = delete;  // columns refer to members
  Observation& operator=(const Observation&) = delete;

  std::vector<std::string> names() const;
  std::vector<std::string> units() const;
  // One row, in the order of the names. The reference is valid until the next call.
  const std::vector<double>& row(const Sample& sample);
  // What is kept of a landing and of pulleys, at a sample for which no row is computed.
  void watch(const Sample& sample);
  // Of all flexible bodies, over the rows so far.
  const FlexibleBodies& flexible() const { return flexible_; }
  void visit(Archive& archive) {
    archive("flexible", flexible_);
    archive("joints", joints_);
    if (landing_) archive("landing", *landing_);
    if (!grips_.empty()) archive("grips", grips_);
    if (landing_end_) archive("landing_end", *landing_end_);
  }
  const JointObserver& joints() const { return joints_; }
  const GripWatch& grips() const { return grips_; }
  const LandingWatch* landing() const { return landing_ ? &*landing_ : nullptr; }  // null where the scene has none
  // Null where [landing] lets the run go to its end time.
  const LandingEnd* landing_end() const { return landing_end_ ? &*landing_end_ : nullptr; }

 private:
  FlexibleBodies flexible_;
  JointObserver joints_;
  std::optional<LandingWatch> landing_;
  std::optional<LandingEnd> landing_end_;
  GripWatch grips_;
  std::vector<Column> columns_;
  std::vector<double> row_;
};

}  // namespace footfall
