#include "mbd_solver/observe/observation.h"

namespace footfall {

Observation::Observation(const Subject& subject)
    : flexible_(subject),
      joints_(subject),
      columns_(history_columns(subject, flexible_, joints_)),
      row_(columns_.size()) {}

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
  flexible_.take(sample);
  joints_.take(sample);
  for (std::size_t i = 0; i < columns_.size(); ++i) row_[i] = columns_[i].value(sample);
  return row_;
}

}  // namespace footfall
