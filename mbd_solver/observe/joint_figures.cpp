#include "mbd_solver/observe/joint_figures.h"

#include <cmath>

#include "coupler/base/pi.h"
#include "coupler/base/text.h"

namespace footfall {

JointFigures::JointFigures(const Subject& subject)
    : subject_(subject),
      now_(subject.mechanism.coordinates.size()),
      acc_(now_.size(), 0.0),
      warned_(now_.size(), false),
      reactions_(subject.scene.output.reactions ? subject.scene.joints.size() : 0, Vector6d::Zero()) {}

void JointFigures::take(const Sample& sample) {
  const Model& model = subject_.mechanism.model;
  const double h = sample.state.time - time_;
  for (std::size_t k = 0; k < now_.size(); ++k) {
    const CoordinateEntry& entry = subject_.mechanism.coordinates[k];
    const Joint& joint = model.joint(entry.joint);
    const JointCoordinate at(entry.coordinate, sample.kinematics.pair(joint.m1.body, joint.m2.body), joint.m1,
                             joint.m2);
    if (started_ && entry.coordinate == Coordinate::kAngle) {
      follow(k, h, at);
    } else {
      now_[k].value = at.value();
    }
    now_[k].rate = at.rate();
    acc_[k] = at.acc();
  }
  const Eigen::Ref<const Eigen::VectorXd> lambda = sample.rates.tail(subject_.layout.row_count);
  for (std::size_t j = 0; j < reactions_.size(); ++j) {
    const Joint& joint = model.joint(static_cast<int>(j));
    reactions_[j] =
        joint_wrench(joint, sample.kinematics.pair(joint.m1.body, joint.m2.body), sample.state.time,
                     lambda.segment(subject_.layout.joint_row[j], static_cast<Eigen::Index>(joint.rows.size())));
  }
  time_ = sample.state.time;
  started_ = true;
}

void JointFigures::follow(std::size_t k, double h, const JointCoordinate& at) {
  const double expected = now_[k].value + 0.5 * h * (now_[k].rate + at.rate()) + h * h / 12.0 * (acc_[k] - at.acc());
  now_[k].value = at.value() + 2.0 * kPi * std::round((expected - at.value()) / (2.0 * kPi));
  if (warned_[k] || std::abs(now_[k].value - expected) < 0.5 * kPi) return;
  warned_[k] = true;
  warnings_.push_back(
      "joint \"" + subject_.mechanism.coordinates[k].name + "\": between two rows, at t = " + number_text(time_, 6) +
      " s, it turns too unsteadily for its turns to be counted, and its angle may be off by whole turns; "
      "make output.interval smaller");
}

}  // namespace footfall
