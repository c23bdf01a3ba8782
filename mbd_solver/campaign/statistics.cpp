// Closed forms, and Newton's method for the logistic curve.
#include "mbd_solver/campaign/statistics.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "mbd_solver/campaign/sampling.h"

namespace footfall {

namespace {
constexpr double kTail = 0.025;                    // beyond each end of an interval of 95 %
constexpr double kOneSided = 0.95;                 // of bounds on one side
constexpr double kDeviations = 1.959963984540054;  // of the normal distribution, 95 % on both sides

// Bonett and Price: p_b = (b + 1) / (n + 2), p_c likewise, (p_c - p_b) -+ z sqrt((p_b + p_c - (p_c - p_b)^2) / (n + 2)).
std::pair<double, double> difference_bounds(double b, double c, double n) {
  const double p_b = (b + 1.0) / (n + 2.0), p_c = (c + 1.0) / (n + 2.0), d = p_c - p_b;
  const double half = kDeviations * std::sqrt((p_b + p_c - d * d) / (n + 2.0));
  return {std::max(-1.0, d - half), std::min(1.0, d + half)};
}

}  // namespace

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  constexpr double kRoundOff = 1e-9;
  const double place = share * static_cast<double>(values.size());
  const auto at = [&](double k) { return values[std::min(values.size() - 1, static_cast<std::size_t>(k))]; };
  if (place >= 1.0 && std::abs(place - std::round(place)) < kRoundOff)
    return 0.5 * (at(std::round(place) - 1.0) + at(std::round(place)));
  return at(place);
}

Probability clopper_pearson(double hits, double trials) {
  if (!(trials > 0.0)) return {0.0, 0.0, 1.0};
  const double misses = trials - hits;
  return {hits / trials, hits > 0.0 ? beta_quantile(hits, misses + 1.0, kTail) : 0.0,
          misses > 0.0 ? beta_quantile(hits + 1.0, misses, 1.0 - kTail) : 1.0};
}

double upper_bound(double hits, double trials) {
  return hits < trials ? beta_quantile(hits + 1.0, trials - hits, kOneSided) : 1.0;
}

long runs_for(double p, long hits) {
  const auto shown = [&](long runs) { return upper_bound(static_cast<double>(hits), static_cast<double>(runs)) <= p; };
  long many = hits + 1;
  while (!shown(many)) many *= 2;
  long few = many / 2;  // not enough
  while (many - few > 1) {
    const long middle = few + (many - few) / 2;
    (shown(middle) ? many : few) = middle;
  }
  return many;
}

long hits_allowed(double p, long runs) {
  long hits = -1;
  while (hits + 1 < runs && upper_bound(static_cast<double>(hits + 1), static_cast<double>(runs)) <= p) ++hits;
  return hits;
}

void PairTally::add(int first, int second) {
  if (first < 0 || second < 0)
    ++unknown;
  else if (first > 0)
    ++(second > 0 ? both : first_only);
  else
    ++(second > 0 ? second_only : neither);
}

Probability PairTally::difference() const {
  const auto n = static_cast<double>(runs()), b = static_cast<double>(first_only), c = static_cast<double>(second_only),
             u = static_cast<double>(unknown);
  if (!(n > u)) return {0.0, -1.0, 1.0};
  return {(c - b) / (n - u), difference_bounds(b + u, c, n).first, difference_bounds(b, c + u, n).second};
}

double PairTally::chance() const {
  // Twice the tail of the binomial distribution of b + c trials with 1/2; I_x(a, b) of the beta distribution has it closed,
  // this sum is short enough.
  const long trials = first_only + second_only, fewer = std::min(first_only, second_only);
  double tail = 0.0;
  for (long k = 0; k <= fewer; ++k) {
    const auto n = static_cast<double>(trials), x = static_cast<double>(k);
    tail += std::exp(std::lgamma(n + 1.0) - std::lgamma(x + 1.0) - std::lgamma(n - x + 1.0) - n * std::log(2.0));
  }
  return std::min(1.0, 2.0 * tail);
}

void Tally::add(int outcome) { ++(outcome < 0 ? unknown : outcome > 0 ? hits : misses); }

double Tally::least() const { return runs() > 0 ? static_cast<double>(hits) / static_cast<double>(runs()) : 0.0; }

double Tally::most() const {
  return runs() > 0 ? static_cast<double>(hits + unknown) / static_cast<double>(runs()) : 1.0;
}

Probability Tally::probability() const {
  const auto all = static_cast<double>(runs()), known = static_cast<double>(hits + misses);
  return {known > 0.0 ? static_cast<double>(hits) / known : 0.0, clopper_pearson(static_cast<double>(hits), all).low,
          clopper_pearson(static_cast<double>(hits + unknown), all).high};
}

Probability with_unknown(const Probability& p, long known, long unknown) {
  if (unknown == 0) return p;
  const double share = static_cast<double>(known) / static_cast<double>(known + unknown);
  return {p.value, share * p.low, share * p.high + (1.0 - share)};
}

double Logistic::deviation(const Eigen::VectorXd& x) const { return std::sqrt(std::max(0.0, x.dot(covariance * x))); }

double Logistic::probability(const Eigen::VectorXd& x) const { return 1.0 / (1.0 + std::exp(-score(x))); }

namespace {

struct Likelihood {
  Eigen::VectorXd p;
  Eigen::LLT<Eigen::MatrixXd> information;
  double value = 0.0;  // penalized: log L + 1/2 log |I|
};

Likelihood likelihood_of(const Eigen::MatrixXd& x, const Eigen::VectorXd& y, const Eigen::VectorXd& b) {
  Likelihood l;
  const Eigen::VectorXd score = x * b;
  l.p = (1.0 + (-score.array()).exp()).inverse();
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    const double s = y[i] > 0.5 ? score[i] : -score[i];
    l.value -= s > 0.0 ? std::log1p(std::exp(-s)) : std::log1p(std::exp(s)) - s;
  }
  const Eigen::VectorXd w = (l.p.array() * (1.0 - l.p.array())).max(1e-12);
  Eigen::MatrixXd information = x.transpose() * w.asDiagonal() * x;
  information.diagonal().array() += 1e-9;  // terms that never vary
  l.information.compute(information);
  l.value += l.information.matrixLLT().diagonal().array().log().sum();
  return l;
}

}  // namespace

Logistic fit_logistic(const Eigen::MatrixXd& x, const Eigen::VectorXd& y) {
  constexpr int kMost = 200;
  constexpr double kLongest = 5.0, kEnd = 1e-8;  // of a step
  Logistic fit;
  fit.b = Eigen::VectorXd::Zero(x.cols());
  Likelihood now = likelihood_of(x, y, fit.b);
  for (int k = 0; k < kMost; ++k) {
    // U = X^T (y - p + h (1/2 - p)), h: the diagonal of W^1/2 X I^-1 X^T W^1/2 [Firth 1993].
    const Eigen::ArrayXd w = now.p.array() * (1.0 - now.p.array());
    const Eigen::MatrixXd solved = now.information.solve(x.transpose());
    const Eigen::ArrayXd h = w * (x.array() * solved.transpose().array()).rowwise().sum();
    const Eigen::VectorXd u = x.transpose() * (y.array() - now.p.array() + h * (0.5 - now.p.array())).matrix();
    Eigen::VectorXd step = now.information.solve(u);
    if (const double length = step.cwiseAbs().maxCoeff(); length > kLongest) step *= kLongest / length;
    bool better = false;
    for (int halved = 0; halved < 30 && !better; ++halved, step *= 0.5) {
      const Likelihood next = likelihood_of(x, y, fit.b + step);
      better = next.value > now.value;
      if (!better) continue;
      fit.b += step;
      now = next;
    }
    if (!better || step.cwiseAbs().maxCoeff() < kEnd) break;
  }
  fit.covariance = now.information.solve(Eigen::MatrixXd::Identity(x.cols(), x.cols()));
  return fit;
}

MomentSlopes moment_slopes(const Eigen::MatrixXd& x, const Eigen::VectorXd& y, const std::vector<Moments>& moments) {
  constexpr double kWider = 1.1;  // with 50 events of 1000 runs the interval of the normal distribution holds in 93 %
  MomentSlopes slopes;
  const Eigen::Index runs = x.rows(), inputs = x.cols(), terms = 1 + 2 * inputs;
  if (runs < 5 * terms) return slopes;
  Eigen::MatrixXd a(runs, terms);
  a.col(0).setOnes();
  for (Eigen::Index k = 0; k < inputs; ++k) {
    const Moments& m = moments[k];
    if (!(m.deviation > 0.0)) return slopes;
    a.col(1 + k) = (x.col(k).array() - m.mean) / m.deviation;
    a.col(1 + inputs + k) = a.col(1 + k).array().square();
  }
  const Eigen::LDLT<Eigen::MatrixXd> normal(a.transpose() * a);
  if (normal.rcond() < 1e-9) return slopes;
  const Eigen::MatrixXd solved = a * normal.solve(Eigen::MatrixXd::Identity(terms, terms));
  const Eigen::VectorXd b = solved.transpose() * y;
  const Eigen::ArrayXd leverage = (solved.array() * a.array()).rowwise().sum();
  const Eigen::ArrayXd residual = (y - a * b).array() / (1.0 - leverage).max(0.05);
  const Eigen::MatrixXd weighted = solved.array().colwise() * residual;
  const auto with_interval = [&](Eigen::Index place, double factor) {
    const double value = factor * b[place], half = factor * kWider * kDeviations * weighted.col(place).norm();
    return Probability{value, value - half, value + half};
  };
  for (Eigen::Index k = 0; k < inputs; ++k) {
    slopes.of_mean.push_back(with_interval(1 + k, 1.0));
    slopes.of_deviation.push_back(with_interval(1 + inputs + k, 2.0));
  }
  return slopes;
}

std::vector<GroupDraw> draw_by_groups(const std::vector<double>& weights, int count, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  const std::size_t all = weights.size(), groups = std::min(all, static_cast<std::size_t>(std::max(0, count)));
  std::vector<std::size_t> order(all);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = all; i > 1; --i)  // std::shuffle differs between libraries
    std::swap(order[i - 1], order[static_cast<std::size_t>(uniform() * static_cast<double>(i))]);
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<GroupDraw> checked;
  for (std::size_t g = 0; g < groups; ++g) {
    const std::size_t first = g * all / groups, last = (g + 1) * all / groups;
    double group = 0.0;
    for (std::size_t i = first; i < last; ++i) group += weights[order[i]];
    double left = uniform() * group;
    std::size_t at = first;
    while (at + 1 < last && left >= weights[order[at]]) left -= weights[order[at++]];
    checked.push_back({order[at], group / weights[order[at]] / static_cast<double>(all), group / sum,
                       static_cast<double>(last - first)});
  }
  return checked;
}

TwoLevels two_levels(const std::vector<int>& cheap, const std::vector<GroupDraw>& checked,
                     const std::vector<int>& better) {
  TwoLevels result;
  const auto all = static_cast<double>(cheap.size());
  const double share = std::accumulate(cheap.begin(), cheap.end(), 0.0) / all;
  result.cheap = clopper_pearson(share * all, all);
  double known = 0.0, squares = 0.0, members = 0.0;  // of the groups whose better result is known
  std::vector<double> factors;
  for (std::size_t g = 0; g < checked.size(); ++g) {
    if (better[g] < 0) continue;
    const int wrong = better[g] - cheap[checked[g].run];
    result.missed += wrong > 0 ? 1 : 0;
    result.false_alarms += wrong < 0 ? 1 : 0;
    result.correction += checked[g].factor * wrong;
    known += checked[g].group;
    squares += checked[g].members * checked[g].members;
    members += checked[g].members;
    factors.push_back(checked[g].factor);
  }
  if (factors.empty()) {
    result.corrected = {share, 0.0, 1.0};
    return result;
  }
  result.correction /= known;
  // v = (sum N_g^2 - N) / (N^2 - sum N_g^2) sum_g Q_g (y_g / q_g - T)^2, with y / q = factor / Q_g times the correction.
  double variance = 0.0;
  for (std::size_t g = 0; g < checked.size(); ++g) {
    if (better[g] < 0) continue;
    const double wrong = better[g] - cheap[checked[g].run], q = checked[g].group / known;
    const double y = checked[g].factor / known / q * wrong;
    variance += q * (y - result.correction) * (y - result.correction);
  }
  const double rest = members * members - squares;
  variance *= rest > 0.0 ? (squares - members) / rest : 1.0;
  // Where none or few are wrong, the sum knows little of those that were not drawn: one more wrong call of middle weight, as
  // the interval of Agresti and Coull adds.
  std::nth_element(factors.begin(), factors.begin() + static_cast<long>(factors.size() / 2), factors.end());
  const double middle = factors[factors.size() / 2];
  if (squares > members) variance += middle * middle;
  // The better model determines the scatter of the runs themselves: p (1 - p) / N.
  const double p = std::clamp(share + result.correction, 0.0, 1.0);
  const double scatter = std::max(p * (1.0 - p), 0.25 / all) / all + variance;
  const double trials = std::max(p * (1.0 - p), 0.25 / all) / scatter;
  result.corrected = clopper_pearson(p * trials, trials);
  // Checked runs without result: as if the outcome had happened in none, and in all, of them.
  if (std::count(better.begin(), better.end(), -1) > 0) {
    std::vector<int> none = better, every = better;
    std::replace(none.begin(), none.end(), -1, 0);
    std::replace(every.begin(), every.end(), -1, 1);
    result.corrected.low = std::min(result.corrected.low, two_levels(cheap, checked, none).corrected.low);
    result.corrected.high = std::max(result.corrected.high, two_levels(cheap, checked, every).corrected.high);
  }
  return result;
}

}  // namespace footfall
