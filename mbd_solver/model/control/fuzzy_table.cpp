// Rules are reduced to those that fire for the first two inputs before the other two are visited.

#include "mbd_solver/model/control/fuzzy_table.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "coupler/base/errors.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/codes.h"

namespace footfall {
namespace {

// One output with scratch: its samples, and for each term the samples where it is not 0 (most terms cover few).
struct Sampled {
  explicit Sampled(const MamdaniOutput& of)
      : output(of), x(of.membership.rows()), y(of.membership.rows()), level(of.membership.cols()) {
    const double half = 0.5 * (of.high - of.low) / static_cast<double>(x.size());
    x = Eigen::ArrayXd::LinSpaced(x.size(), of.low + half, of.high - half);
    for (Eigen::Index t = 0; t < level.size(); ++t) {
      Eigen::Index first = 0, last = x.size();
      while (first < last && of.membership(first, t) == 0.0) ++first;
      while (last > first && of.membership(last - 1, t) == 0.0) --last;
      begin.push_back(first);
      count.push_back(last - first);
    }
  }
  // The centroid of the aggregated output y(x) = max over terms of min(level, membership(x)).
  double centroid() {
    y.setZero();
    for (Eigen::Index t = 0; t < level.size(); ++t) {
      if (level[t] <= 0.0) continue;
      const Eigen::Index from = begin[t], n = count[t];
      y.segment(from, n) = y.segment(from, n).max(output.membership.col(t).segment(from, n).array().min(level[t]));
    }
    const double area = y.sum();
    return area > 0.0 ? (x * y).sum() / area : output.value_without_rule;
  }

  const MamdaniOutput& output;
  Eigen::ArrayXd x, y;
  Eigen::VectorXd level;  // of each term
  std::vector<Eigen::Index> begin, count;
};

}  // namespace

std::vector<double> evaluate_on_grid(const MamdaniSystem& system, const std::array<Eigen::MatrixXd, 4>& axis) {
  std::vector<Sampled> outputs(system.outputs.begin(), system.outputs.end());
  const auto membership = [&](const MamdaniRule& rule, std::size_t input, Eigen::Index node) {
    return rule.term[input] < 0 ? 1.0 : axis[input](node, rule.term[input]);
  };
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(axis[0].rows() * axis[1].rows() * axis[2].rows() * axis[3].rows()) *
                 outputs.size());
  // Rules that fire for the first two inputs, with their minimum so far.
  std::vector<std::pair<const MamdaniRule*, double>> active;
  for (Eigen::Index i = 0; i < axis[0].rows(); ++i)
    for (Eigen::Index j = 0; j < axis[1].rows(); ++j) {
      active.clear();
      for (const MamdaniRule& rule : system.rules) {
        const double degree = std::min(membership(rule, 0, i), membership(rule, 1, j));
        if (degree > 0.0) active.emplace_back(&rule, degree);
      }
      for (Eigen::Index k = 0; k < axis[2].rows(); ++k)
        for (Eigen::Index l = 0; l < axis[3].rows(); ++l) {
          for (Sampled& output : outputs) output.level.setZero();
          for (const auto& [rule, so_far] : active) {
            const double degree = rule->weight * std::min({so_far, membership(*rule, 2, k), membership(*rule, 3, l)});
            for (const auto& [output, term] : rule->outcomes) {
              double& at = outputs[output].level[term];
              at = std::max(at, degree);
            }
          }
          for (Sampled& output : outputs) values.push_back(output.centroid());
        }
    }
  return values;
}

namespace {

constexpr double kMostValues = 2.0e7;  // 160 MB

// The points of one axis: all corners, and the intervals between them divided in proportion to their length.
Eigen::VectorXd axis_nodes(const std::vector<double>& corners, int points, const std::string& name) {
  const std::size_t intervals = corners.size() - 1;
  if (points < static_cast<int>(corners.size()))
    throw InputError(code::kFuzzyGrid, "controller fuzzy: grid has " + std::to_string(points) + " points along " +
                                           name + "; expected at least " + std::to_string(corners.size()) +
                                           ", one for each corner of its terms.");
  std::vector<int> parts(intervals, 1);
  for (int left = points - 1 - static_cast<int>(intervals); left > 0; --left) {  // the longest part is divided next
    std::size_t longest = 0;
    const auto length = [&](std::size_t i) { return (corners[i + 1] - corners[i]) / parts[i]; };
    for (std::size_t i = 1; i < intervals; ++i)
      if (length(i) > length(longest) * (1.0 + 1e-3)) longest = i;
    ++parts[longest];
  }
  Eigen::VectorXd nodes(points);
  Eigen::Index n = 0;
  for (std::size_t i = 0; i < intervals; ++i)
    for (int k = 0; k < parts[i]; ++k) {
      const double even = static_cast<double>(k) / parts[i], cosine = 0.5 * (1.0 - std::cos(kPi * even));
      nodes[n++] = corners[i] + (corners[i + 1] - corners[i]) * 0.5 * (even + cosine);
    }
  nodes[n] = corners.back();
  return nodes;
}

}  // namespace

FuzzyTable::FuzzyTable(const FuzzySystem& system, const FuzzyGrid& grid) : outputs_(system.output_count()) {
  double total = outputs_;
  for (const int points : grid) total *= points;
  if (total > kMostValues)
    throw InputError(code::kFuzzyGrid, "controller fuzzy: grid requires a table of " +
                                           std::to_string(std::llround(total)) + " numbers; expected at most " +
                                           std::to_string(std::llround(kMostValues)) + ". Use fewer points.");
  for (std::size_t i = 0; i < kFuzzyInputs; ++i)
    nodes_[i] = axis_nodes(system.breakpoints(static_cast<int>(i)), grid[i], kFuzzyInputNames[i]);
  values_ = system.evaluate_on_grid(nodes_);
}

void FuzzyTable::evaluate(const FuzzyInput& input, Eigen::Ref<Eigen::VectorXd> voltages) const {
  FOOTFALL_DEMAND(voltages.size() == outputs_);
  // Lower corner of the cell and the place inside it, input by input; then the 16 corners with multilinear weights.
  std::array<std::size_t, kFuzzyInputs> corner{}, stride{};
  FuzzyInput t{};
  std::size_t step = static_cast<std::size_t>(outputs_);
  for (std::size_t i = kFuzzyInputs; i-- > 0;) {
    const Eigen::VectorXd& nodes = nodes_[i];
    if (std::isnan(input[i])) {  // like the exact rules: none fires
      voltages.setConstant(kNoRuleVoltage);
      return;
    }
    const double x = std::clamp(input[i], nodes[0], nodes[nodes.size() - 1]);
    const auto above = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, x) - nodes.begin();
    corner[i] = static_cast<std::size_t>(above - 1);
    t[i] = (x - nodes[above - 1]) / (nodes[above] - nodes[above - 1]);
    stride[i] = step;
    step *= static_cast<std::size_t>(nodes.size());
  }
  voltages.setZero();
  for (unsigned bits = 0; bits < (1u << kFuzzyInputs); ++bits) {
    double weight = 1.0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < kFuzzyInputs; ++i) {
      const bool high = (bits >> i) & 1u;
      weight *= high ? t[i] : 1.0 - t[i];
      at += (corner[i] + (high ? 1 : 0)) * stride[i];
    }
    if (weight > 0.0) voltages += weight * Eigen::Map<const Eigen::VectorXd>(values_.data() + at, outputs_);
  }
  // A sum of weights may exceed 1 by a unit in the last place.
  voltages = voltages.cwiseMax(0.0).cwiseMin(1.0);
}

double FuzzyTable::largest_difference(const FuzzySystem& system, int samples) const {
  std::mt19937_64 generator(20251012);
  Eigen::VectorXd exact(outputs_), table(outputs_);
  double largest = 0.0;
  for (int n = 0; n < samples; ++n) {
    FuzzyInput x{};
    for (std::size_t i = 0; i < kFuzzyInputs; ++i)
      x[i] = std::uniform_real_distribution<double>(nodes_[i][0], nodes_[i][nodes_[i].size() - 1])(generator);
    system.evaluate(x, exact);
    evaluate(x, table);
    largest = std::max(largest, (exact - table).cwiseAbs().maxCoeff());
  }
  return largest;
}

}  // namespace footfall
