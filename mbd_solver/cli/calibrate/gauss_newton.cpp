#include "mbd_solver/cli/calibrate/gauss_newton.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace footfall {

namespace {

constexpr double kFirstDamping = 1.0, kLeastDamping = 1e-6, kMostDamping = 1e8;  // lambda

struct OutOfSets {};  // the stage stops here: sets are wanted, or a limit is reached

class LeastSquares {
 public:
  LeastSquares(const StageSpec& stage, double step, const LeastSquaresQuestions& questions)
      : stage_(stage), step_(step), questions_(questions) {}

  void search(Shares at) {
    Eigen::VectorXd r = residuals(at);
    double damping = kFirstDamping;
    for (;;) {
      const Eigen::MatrixXd j = derivatives(at, r.size());
      for (bool better = false; !better;) {
        const Shares next = stepped(at, j, r, damping);
        if (distance_of(at, next) < stage_.precision || damping > kMostDamping) {
          way.end = "within its precision";
          return;
        }
        const Eigen::VectorXd tried = residuals(next);
        better = tried.size() == r.size() && tried.squaredNorm() < r.squaredNorm();
        damping = better ? std::max(kLeastDamping, 0.1 * damping) : 10.0 * damping;
        if (better) at = next, r = tried;
      }
    }
  }

  StageWay way;

 private:
  Eigen::VectorXd residuals(const Shares& set) { return residuals(std::vector<Shares>{set}).front(); }

  // Of all sets, or none where one is not known.
  std::vector<Eigen::VectorXd> residuals(const std::vector<Shares>& sets) {
    std::vector<Eigen::VectorXd> all;
    for (const Shares& set : sets) {
      const bool fresh = std::find(way.sets.begin(), way.sets.end(), set) == way.sets.end();
      if (fresh && static_cast<int>(way.sets.size() + way.wanted.size()) >= stage_.evaluations)
        stop("all evaluations done");
      if (fresh && way.wanted.empty() && !questions_.may_go_on(set)) stop("limit reached");
      const auto known = questions_.residuals(set);
      if (!known) {
        way.wanted.push_back(set);
        continue;
      }
      const Eigen::VectorXd r =
          Eigen::Map<const Eigen::VectorXd>(known->data(), static_cast<Eigen::Index>(known->size()));
      all.push_back(r);
      if (!fresh || !way.wanted.empty()) continue;
      way.sets.push_back(set);
      if (r.size() > 0 && r.squaredNorm() < way.misfit) way.misfit = r.squaredNorm(), way.best = set;
    }
    if (!way.wanted.empty()) throw OutOfSets();
    return all;
  }

  [[noreturn]] void stop(const std::string& why) {
    way.end = why;
    throw OutOfSets();
  }

  Eigen::MatrixXd derivatives(const Shares& at, Eigen::Index rows) {
    std::vector<Shares> sets;
    for (std::size_t i = 0; i < at.size(); ++i)
      for (const double sign : {1.0, -1.0}) {
        sets.push_back(at);
        sets.back()[i] = std::clamp(at[i] + sign * step_, 0.0, 1.0);
      }
    const std::vector<Eigen::VectorXd> r = residuals(sets);
    Eigen::MatrixXd j = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(at.size()));
    for (std::size_t i = 0; i < at.size(); ++i)
      if (r[2 * i].size() == rows && r[2 * i + 1].size() == rows)
        j.col(static_cast<Eigen::Index>(i)) = (r[2 * i] - r[2 * i + 1]) / (sets[2 * i][i] - sets[2 * i + 1][i]);
    return j;
  }

  // Parameters that the step would take out of their ranges stay at the end, and the others are solved for anew.
  static Shares stepped(const Shares& at, const Eigen::MatrixXd& j, const Eigen::VectorXd& r, double damping) {
    const auto n = static_cast<Eigen::Index>(at.size());
    Eigen::VectorXd d = Eigen::VectorXd::Zero(n);
    std::vector<Eigen::Index> open(at.size());
    for (Eigen::Index i = 0; i < n; ++i) open[static_cast<std::size_t>(i)] = i;
    for (bool cut = true; cut && !open.empty();) {
      cut = false;
      const auto m = static_cast<Eigen::Index>(open.size());
      Eigen::MatrixXd of_open(j.rows(), m);
      Eigen::VectorXd rest = r;
      for (Eigen::Index k = 0; k < m; ++k) of_open.col(k) = j.col(open[static_cast<std::size_t>(k)]);
      for (Eigen::Index i = 0; i < n; ++i)
        if (std::find(open.begin(), open.end(), i) == open.end()) rest += j.col(i) * d[i];
      const Eigen::MatrixXd normal = of_open.transpose() * of_open + damping * Eigen::MatrixXd::Identity(m, m);
      const Eigen::VectorXd step = normal.ldlt().solve(-of_open.transpose() * rest);
      for (Eigen::Index k = m - 1; k >= 0; --k) {
        const Eigen::Index i = open[static_cast<std::size_t>(k)];
        const double from = at[static_cast<std::size_t>(i)];
        d[i] = std::clamp(step[k], -from, 1.0 - from);
        if (d[i] == step[k]) continue;
        open.erase(open.begin() + k);
        cut = true;
      }
    }
    Shares next = at;
    for (std::size_t i = 0; i < at.size(); ++i) next[i] = std::clamp(at[i] + d[static_cast<Eigen::Index>(i)], 0.0, 1.0);
    return next;
  }

  static double distance_of(const Shares& a, const Shares& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
  }

  const StageSpec& stage_;
  double step_;
  const LeastSquaresQuestions& questions_;
};

}  // namespace

StageWay walk_least_squares(const StageSpec& stage, const Shares& start, double step,
                            const LeastSquaresQuestions& questions) {
  LeastSquares search(stage, step, questions);
  try {
    search.search(start);
  } catch (const OutOfSets&) {
  }
  return search.way;
}

}  // namespace footfall
