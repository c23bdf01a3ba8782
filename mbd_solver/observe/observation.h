#pragma once
// The rows of history.csv, and what flexible bodies and joints did in them.

#include <string>
#include <vector>

#include "mbd_solver/observe/columns.h"
#include "mbd_solver/observe/flexible_figures.h"
#include "mbd_solver/observe/sample.h"

namespace footfall {

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
