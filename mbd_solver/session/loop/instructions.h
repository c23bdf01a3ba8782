#pragma once
// What a program that leads a run has instructed: it does so while a sample is observed, and all
// takes effect at that sample.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Dense>

#include "coupler/archive.h"

namespace footfall {

// Output rows of a run: multiples of an interval.
class RowTimes {
 public:
  explicit RowTimes(double interval) : interval_(interval) {}            // [s]
  double tolerance() const { return 1e-9 * std::max(interval_, 1e-6); }  // two times of a row are one [s]
  // The first row after t [s].
  double after(double t) const { return (std::floor((t + tolerance()) / interval_) + 1.0) * interval_; }

 private:
  double interval_;  // [s]
};

class Instructions {
 public:
  explicit Instructions(double row_interval) : rows_(row_interval) {}  // [s]

  // The sample at this time [s] is observed, too, or a row so near to it that two rows would be
  // one.
  void stop_at(double time) { stop_ = time; }
  // A signal of kind "host"; place: of the signal among the inputs (PlaceEntry).
  void set_input(int place, double value) { given_.push_back({place, value}); }
  // A checkpoint before the run continues; with grains after the window that begins.
  void request_checkpoint() { checkpoint_requested_ = true; }

  const RowTimes& rows() const { return rows_; }
  double stop_after(double t) const { return stop_ > t ? stop_ : kNoStop; }  // [s]
  // The next row after t, or stop_at(), or `otherwise` if it comes first [s].
  double next(double t, double otherwise) const {
    const double next = std::min(rows_.after(t), otherwise);
    return stop_ > t && stop_ < next - rows_.tolerance() ? stop_ : next;
  }
  bool has_stop_behind(double t) const { return t < stop_ - rows_.tolerance(); }
  // A row, or stop_at(), is at this time [s].
  bool is_stop(double t) const {
    return rows_.after(t - 2.0 * rows_.tolerance()) < t + rows_.tolerance() || std::abs(stop_ - t) <= rows_.tolerance();
  }

  bool waiting() const { return !given_.empty() || checkpoint_requested_; }  // before the run may continue
  bool checkpoint_requested() const { return checkpoint_requested_; }
  void checkpoint_answered() { checkpoint_requested_ = false; }
  // The run is over at the next row; with grains at the end of the window after the present one.
  void request_end() { end_requested_ = true; }
  bool end_requested() const { return end_requested_; }
  void visit_end(Archive& archive) { archive("end_requested", end_requested_); }
  // Writes what set_input() gave; false: nothing.
  bool apply_inputs(Eigen::VectorXd& values) {
    if (given_.empty()) return false;
    for (const Given& given : given_) values(given.place) = given.value;
    given_.clear();
    return true;
  }
  void forget_inputs() { given_.clear(); }

 private:
  static constexpr double kNoStop = std::numeric_limits<double>::infinity();
  struct Given {
    int place;
    double value;
  };

  RowTimes rows_;
  double stop_ = kNoStop;     // [s]
  std::vector<Given> given_;  // since the last sample
  bool checkpoint_requested_ = false;
  bool end_requested_ = false;
};

}  // namespace footfall
