// Expressions read the columns of a scene that records everything, so that they do not depend on what is recorded.

#include "mbd_solver/session/observe/observation.h"

#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/model/control/continuous_signals.h"
#include "mbd_solver/session/codes.h"

namespace footfall {
namespace {

Scene recording_everything(Scene scene) {
  scene.output.bodies.clear();
  scene.output.joints = scene.output.attitudes = scene.output.reactions = true;
  return scene;
}

std::optional<LandingWatch> landing_of(const Subject& subject) {
  return subject.scene.landing ? std::optional<LandingWatch>(subject) : std::nullopt;
}

const LandingWatch* pointer_to(const std::optional<LandingWatch>& landing) { return landing ? &*landing : nullptr; }

}  // namespace

Readings::Readings(const std::vector<std::string>& names, const Subject& subject)
    : scene_(recording_everything(subject.scene)),
      subject_{scene_, subject.mechanism, subject.layout},
      flexible_(subject_),
      joints_(subject_),
      landing_(landing_of(subject_)) {
  const Mechanism& mechanism = subject.mechanism;
  const std::vector<Column> columns = history_columns(subject_, flexible_, joints_, pointer_to(landing_));
  const NameIndex index;
  std::set<int> continuous;  // places of continuous signals
  if (const ContinuousSignals* const signals = mechanism.model.signals())
    for (std::size_t k = 0; k < signals->chain().size(); ++k) continuous.insert(signals->chain().node(k).place);
  std::string unknown;
  for (const std::string& name : names) {
    Reading reading;
    reading.source = signal_source(mechanism, name);
    if (reading.source) {
      reading.continuous = reading.source->kind == SignalSource::Kind::kPlace &&
                           continuous.count(static_cast<int>(reading.source->index)) > 0;
      readings_.push_back(std::move(reading));
      continue;
    }
    const std::optional<std::size_t> column = index.find(columns, name);
    if (!column) {
      std::vector<std::string> known;
      for (const Column& c : columns) known.push_back(c.name);
      const std::string line = where_read(subject.scene, name) + "unknown name \"" + name +
                               "\"; expected a column of history.csv (without \"-\" in it), signal.NAME, state.NAME or "
                               "time." +
                               known_names("columns", name, known);
      if (unknown.find(line) == std::string::npos) unknown += (unknown.empty() ? "" : "\n") + line;
      continue;
    }
    reading.column = columns[*column].value;
    uses_flexible_ = uses_flexible_ || columns[*column].reads == Column::Reads::kFlexible;
    uses_landing_ = uses_landing_ || columns[*column].reads == Column::Reads::kLanding;
    uses_joints_ = uses_joints_ || columns[*column].reads == Column::Reads::kJoints;
    readings_.push_back(std::move(reading));
  }
  if (!unknown.empty()) throw InputError(code::kNoSuchQuantity, unknown);
}

void Readings::update(const Sample& sample) {
  if (uses_flexible_) flexible_.update(sample);
  if (uses_joints_) joints_.update(sample);
  if (uses_landing_) landing_->update(sample);
}

double Readings::value(std::size_t k, const Sample& sample, const Eigen::VectorXd& values) const {
  const Reading& reading = readings_[k];
  if (!reading.source) return reading.column(sample);
  const auto index = static_cast<Eigen::Index>(reading.source->index);
  switch (reading.source->kind) {
    case SignalSource::Kind::kTime: return sample.state.time;
    case SignalSource::Kind::kPlace: return (reading.continuous ? sample.values : values)(index);
    case SignalSource::Kind::kSince: return sample.state.time - values(index);
    case SignalSource::Kind::kSensor: break;
  }
  FOOTFALL_DEMAND(false);
}

Observation::Observation(const Subject& subject)
    : flexible_(subject),
      joints_(subject),
      landing_(landing_of(subject)),
      grips_(subject),
      columns_(history_columns(subject, flexible_, joints_, pointer_to(landing_))),
      row_(columns_.size()) {
  if (landing_ && (subject.scene.landing->end_at_rest || subject.scene.landing->end_when_tipped))
    landing_end_.emplace(subject, *landing_);
}

std::vector<std::string> Observation::names() const {
  std::vector<std::string> names;
  for (const Column& column : columns_) names.push_back(column.name);
  return names;
}

std::vector<std::string> Observation::units() const {
  std::vector<std::string> units;
  for (const Column& column : columns_) units.push_back(column.unit);
  return units;
}

const std::vector<double>& Observation::row(const Sample& sample) {
  flexible_.update(sample);
  joints_.update(sample);
  watch(sample);
  for (std::size_t i = 0; i < columns_.size(); ++i) row_[i] = columns_[i].value(sample);
  return row_;
}

void Observation::watch(const Sample& sample) {
  grips_.update(sample);
  if (landing_) landing_->update(sample);
  if (landing_end_) landing_end_->update(sample, *landing_);
}

}  // namespace footfall
