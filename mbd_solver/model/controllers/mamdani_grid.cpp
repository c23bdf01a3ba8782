#include "mbd_solver/model/controllers/mamdani_grid.h"

#include <algorithm>

namespace footfall {
namespace {

// One output with room to work: its samples, and for each term the samples where it is not 0 (most terms
// cover a small part).
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
  // Of the aggregated output y(x) = max over terms of min(level, membership(x)).
  double centroid() {
    y.setZero();
    for (Eigen::Index t = 0; t < level.size(); ++t) {
      if (level[t] <= 0.0) continue;
      const Eigen::Index from = begin[static_cast<std::size_t>(t)], n = count[static_cast<std::size_t>(t)];
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
  std::vector<std::pair<const MamdaniRule*, double>>
      active;  // rules that fire for the first two inputs, with their minimum so far
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
              double& at = outputs[static_cast<std::size_t>(output)].level[term];
              at = std::max(at, degree);
            }
          }
          for (Sampled& output : outputs) values.push_back(output.centroid());
        }
    }
  return values;
}

}  // namespace footfall
