#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/cli/analysis/viewer/frames_of_run.h"
#include "mbd_solver/cli/analysis/viewer/packed_series.h"
#include "mbd_solver/cli/grains/bed_frames.h"

namespace footfall {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kShown = 0.999;  // of the grains of a frame are within the colours

// A frame as it stays in memory until the box of all is known: single precision is finer than the steps of a page.
struct LeanFrame {
  std::vector<int> id;        // rising
  Eigen::Matrix3Xf x;         // [m]
  Eigen::MatrixXf numbers;    // a row per number, a column per grain
  std::vector<float> radius;  // [m]
};

struct Number {
  const char* name;
  const char* unit;
  const Eigen::Matrix3Xd BedFrame::*vector;  // whose length it is
};
const Number kNumbers[] = {{"speed", "m/s", &BedFrame::v}, {"force", "N", &BedFrame::f}};

LeanFrame lean(const BedFrame& bed, const std::vector<Number>& numbers, const std::string& file) {
  LeanFrame frame{bed.id, bed.x.cast<float>(), {}, {bed.radius.begin(), bed.radius.end()}};
  frame.numbers.resize(static_cast<Eigen::Index>(numbers.size()), bed.x.cols());
  for (std::size_t j = 0; j < numbers.size(); ++j) {
    const Eigen::Matrix3Xd& vectors = bed.*numbers[j].vector;
    if (vectors.cols() != bed.x.cols())
      throw InputError(file + ": lacks the " + numbers[j].name + " of the grains, which the first dump holds");
    frame.numbers.row(static_cast<Eigen::Index>(j)) = vectors.colwise().norm().cast<float>();
  }
  if (!frame.x.allFinite() || !frame.numbers.allFinite())
    throw InputError(file + ": holds a number that is not finite; was it cut off?");
  return frame;
}

// The value that all but one in a thousand stay below.
double upper(std::vector<float> values) {
  if (values.empty()) return 0.0;
  const auto k = static_cast<std::ptrdiff_t>(kShown * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + k, values.end());
  return values[static_cast<std::size_t>(k)];
}

// Every so many, the first and the last among them.
std::vector<std::pair<long, std::string>> thinned(const std::map<long, std::string>& dumps, std::size_t most) {
  std::vector<std::pair<long, std::string>> all(dumps.begin(), dumps.end()), chosen;
  if (all.size() <= most) return all;
  for (std::size_t i = 0; i < most; ++i)
    chosen.push_back(all[i * (all.size() - 1) / std::max<std::size_t>(1, most - 1)]);
  return chosen;
}

std::size_t most_frames(const FrameLimits& limits, std::size_t grains) {
  const double room = limits.most_grains / static_cast<double>(std::max<std::size_t>(grains, 1));
  const std::size_t most = std::max<std::size_t>(2, static_cast<std::size_t>(room));
  return limits.frames > 0 ? std::min(most, static_cast<std::size_t>(limits.frames)) : most;
}

// Places of the grains of a frame among all that ever were.
template <class Action>
void for_each_place(const std::vector<int>& all, const LeanFrame& frame, const Action& action) {
  std::size_t place = 0;
  for (std::size_t i = 0; i < frame.id.size(); ++i) {
    while (all[place] != frame.id[i]) ++place;
    action(static_cast<Eigen::Index>(i), place);
  }
}

struct FrameBed {
  std::vector<double> times;  // [s]
  std::vector<LeanFrame> frames;
  std::vector<Number> numbers;
  std::vector<int> ids;  // of all frames, rising
};

FrameBed read_bed(const std::vector<std::pair<long, std::string>>& dumps, double dt) {
  FrameBed bed;
  for (const auto& [step, file] : dumps) {
    const BedFrame frame = read_bed_frame(file);
    if (bed.frames.empty())
      for (const Number& number : kNumbers)
        if ((frame.*number.vector).cols() > 0) bed.numbers.push_back(number);
    bed.times.push_back(static_cast<double>(step) * dt);
    bed.frames.push_back(lean(frame, bed.numbers, file));
    if (frame.id == bed.ids) continue;
    std::vector<int> both;
    std::set_union(bed.ids.begin(), bed.ids.end(), frame.id.begin(), frame.id.end(), std::back_inserter(both));
    bed.ids = std::move(both);
  }
  return bed;
}

// How far the grains have come since the first frame, at the end of the colours [m].
double farthest(const FrameBed& bed) {
  double most = 0.0;
  std::vector<Eigen::Vector3f> start(bed.ids.size());
  std::vector<bool> known(bed.ids.size(), false);
  for_each_place(bed.ids, bed.frames.front(), [&](Eigen::Index i, std::size_t place) {
    start[place] = bed.frames.front().x.col(i);
    known[place] = true;
  });
  for (const LeanFrame& frame : bed.frames) {
    std::vector<float> way;
    for_each_place(bed.ids, frame, [&](Eigen::Index i, std::size_t place) {
      if (known[place]) way.push_back((frame.x.col(i) - start[place]).norm());
    });
    most = std::max(most, upper(std::move(way)));
  }
  return most;
}

}  // namespace

void add_grains(const std::string& run, double dt, FrameLimits& limits, PageParts& parts) {
  parts.run["grains"] = nullptr;
  const std::map<long, std::string> dumps = find_bed_frames(run);
  if (dumps.empty()) return;
  const std::size_t most = most_frames(limits, static_cast<std::size_t>(read_bed_frame(dumps.begin()->second).count()));
  const FrameBed bed = read_bed(thinned(dumps, most), dt);
  const std::size_t n = bed.ids.size();
  if (bed.frames.size() < dumps.size())
    limits.notes.push_back("The run dumped its grains " + std::to_string(dumps.size()) + " times; " +
                           std::to_string(bed.frames.size()) + " of them are shown, evenly spread.");

  Box box, view;
  std::vector<float> radius(n, 0.0f);
  for (const LeanFrame& frame : bed.frames) {
    for (Eigen::Index i = 0; i < frame.x.cols(); ++i) box.include(frame.x.col(i).cast<double>());
    if (view.is_empty()) view = box;
    for_each_place(bed.ids, frame, [&](Eigen::Index i, std::size_t place) {
      radius[place] = frame.radius[static_cast<std::size_t>(i)];
    });
  }
  std::vector<double> largest, shown;
  for (std::size_t j = 0; j < bed.numbers.size(); ++j) {
    double all = 0.0, most_of_all = 0.0;
    for (const LeanFrame& frame : bed.frames) {
      const Eigen::VectorXf row = frame.numbers.row(static_cast<Eigen::Index>(j));
      if (row.size() > 0) all = std::max(all, static_cast<double>(row.maxCoeff()));
      most_of_all = std::max(most_of_all, upper({row.begin(), row.end()}));
    }
    largest.push_back(all > 0.0 ? all : 1.0);
    shown.push_back(most_of_all > 0.0 ? most_of_all : largest.back());
  }

  Json& grains = parts.run["grains"];
  grains = {{"count", n}, {"times", bed.times}, {"farthest", farthest(bed)}, {"numbers", Json::array()}};
  add_box(box, view, grains);
  for (std::size_t j = 0; j < bed.numbers.size(); ++j)
    grains["numbers"].push_back(
        {{"name", bed.numbers[j].name}, {"unit", bed.numbers[j].unit}, {"largest", largest[j]}, {"shown", shown[j]}});
  parts.chunks.emplace_back("grains-radius", packed_numbers(radius));
  PackedSeries series(n * (3 + bed.numbers.size()));
  for (std::size_t k = 0; k < bed.frames.size(); ++k) {
    const LeanFrame& frame = bed.frames[k];
    std::vector<std::uint16_t> values(n * (3 + bed.numbers.size()), 0);
    std::fill_n(values.begin(), n, kAbsent);
    for_each_place(bed.ids, frame, [&](Eigen::Index i, std::size_t place) {
      for (int axis = 0; axis < 3; ++axis)
        values[static_cast<std::size_t>(axis) * n + place] = box.number_of(axis, static_cast<double>(frame.x(axis, i)));
      for (std::size_t j = 0; j < bed.numbers.size(); ++j)
        values[(3 + j) * n + place] =
            root_number(static_cast<double>(frame.numbers(static_cast<Eigen::Index>(j), i)), largest[j]);
    });
    parts.add_frame("grains", k, series.add(values));
  }
}

}  // namespace footfall
