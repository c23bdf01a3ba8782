#pragma once
// The columns of history.csv: one registry of name, unit and value. docs/reference/history.md lists them.

#include <functional>
#include <string>
#include <vector>

#include "mbd_solver/session/observe/landing.h"
#include "mbd_solver/session/observe/metrics.h"
#include "mbd_solver/session/observe/sampler.h"

namespace footfall {

struct Column {
  std::string name;     // `footpad_1.x`
  std::string unit;     // SI; "-" for a plain number
  std::string pattern;  // its name in the registry: `<body>.x`
  std::function<double(const Sample&)> value;
  enum class Reads { kSample, kFlexible, kJoints, kLanding };
  Reads reads = Reads::kSample;  // in addition to the sample: what is updated with it
};

// The columns of this scene, in the order of the file. flexible, joints and landing are updated with the sample before a value
// is read; they and the subject's parts must outlive the columns. landing: null where the scene has none.
std::vector<Column> history_columns(const Subject& subject, const FlexibleBodies& flexible, const JointObserver& joints,
                                    const LandingWatch* landing = nullptr);

// The whole registry, for all scenes.
struct ColumnPattern {
  std::string pattern;
  std::string unit;
};
std::vector<ColumnPattern> column_patterns();

}  // namespace footfall
