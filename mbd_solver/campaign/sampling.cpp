// A design in the unit cube, a normal copula, and the quantiles of each distribution.
#include "mbd_solver/campaign/sampling.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <openturns/Binomial.hxx>
#include <openturns/ComposedDistribution.hxx>
#include <openturns/ConstantBasisFactory.hxx>
#include <openturns/CorrectedLeaveOneOut.hxx>
#include <openturns/CorrelationAnalysis.hxx>
#include <openturns/DistFunc.hxx>
#include <openturns/FixedStrategy.hxx>
#include <openturns/FunctionalChaosAlgorithm.hxx>
#include <openturns/GeneralLinearModelAlgorithm.hxx>
#include <openturns/HyperbolicAnisotropicEnumerateFunction.hxx>
#include <openturns/KrigingAlgorithm.hxx>
#include <openturns/LARS.hxx>
#include <openturns/LHSExperiment.hxx>
#include <openturns/LeastSquaresMetaModelSelectionFactory.hxx>
#include <openturns/LeastSquaresStrategy.hxx>
#include <openturns/LegendreFactory.hxx>
#include <openturns/LinearBasisFactory.hxx>
#include <openturns/Log.hxx>
#include <openturns/LogNormal.hxx>
#include <openturns/MaternModel.hxx>
#include <openturns/Normal.hxx>
#include <openturns/NormalCopula.hxx>
#include <openturns/OrthogonalProductPolynomialFactory.hxx>
#include <openturns/PlatformInfo.hxx>
#include <openturns/RandomGenerator.hxx>
#include <openturns/SobolSequence.hxx>
#include <openturns/Triangular.hxx>
#include <openturns/TruncatedDistribution.hxx>
#include <openturns/Uniform.hxx>
#include <openturns/UserDefined.hxx>
#include <openturns/WeibullMin.hxx>
#include <random>

#include "coupler/base/errors.h"
#include "mbd_solver/scene/codes.h"

namespace footfall {
namespace {

OT::ComposedDistribution unit_cube(std::size_t width) {
  return OT::ComposedDistribution(OT::Collection<OT::Distribution>(width, OT::Uniform(0.0, 1.0)));
}

constexpr std::uint32_t kSeeds = 0x7fffffffU;  // 2^31 - 1, as a mask

OT::Distribution truncated(const OT::Distribution& whole, const DistributionSpec& d) {
  using OT::TruncatedDistribution;
  if (d.least && d.most) return TruncatedDistribution(whole, *d.least, *d.most);
  if (d.least) return TruncatedDistribution(whole, *d.least, TruncatedDistribution::LOWER);
  if (d.most) return TruncatedDistribution(whole, *d.most, TruncatedDistribution::UPPER);
  return whole;
}

OT::Distribution listed(const std::vector<double>& values, const std::vector<double>& weights) {
  OT::Sample points(values.size(), 1);
  OT::Point shares(values.size());
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    points(i, 0) = values[i];
    shares[i] = weights.empty() ? 1.0 / static_cast<double>(values.size()) : weights[i] / sum;
  }
  return OT::UserDefined(points, shares);
}

OT::Distribution distribution_of(const ParameterSpec& p) {
  const DistributionSpec& d = p.distribution;
  switch (*d.kind) {
    case DistributionKind::kNormal: return truncated(OT::Normal(*d.mean, *d.deviation), d);
    case DistributionKind::kLognormal: {
      // m = exp(mu + sigma^2 / 2), s^2 = m^2 (exp(sigma^2) - 1), of the values above `least`.
      const double least = d.least.value_or(0.0), ratio = *d.deviation / (*d.mean - least);
      const double variance = std::log1p(ratio * ratio);
      DistributionSpec above = d;
      above.least.reset();
      const double mu = std::log(*d.mean - least) - 0.5 * variance;
      return truncated(OT::LogNormal(mu, std::sqrt(variance), least), above);
    }
    case DistributionKind::kUniform: return OT::Uniform(*d.least, *d.most);
    case DistributionKind::kTriangular: return OT::Triangular(*d.least, *d.likely, *d.most);
    case DistributionKind::kWeibull: {
      // `least` is where it begins: bounded above only.
      DistributionSpec above = d;
      above.least.reset();
      return truncated(OT::WeibullMin(*d.scale, *d.shape, d.least.value_or(0.0)), above);
    }
    case DistributionKind::kDiscrete: {
      std::vector<double> places(p.choices.size());
      std::iota(places.begin(), places.end(), 0.0);
      return listed(places, d.weights);
    }
    case DistributionKind::kMeasured: return listed(d.measured, {});
  }
  FOOTFALL_DEMAND(false);
  return {};
}

// Above 0 and below 1.
double open_unit(double u) { return std::clamp(u, 1e-12, 1.0 - 1e-12); }

std::vector<std::vector<double>> design_of(const SweepSpec& spec, std::size_t width, const Draws& draws) {
  const std::size_t count = spec.runs;
  std::vector<std::vector<double>> units(count, std::vector<double>(width));
  const auto uniform = [](std::mt19937_64& engine) { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  if (spec.design == Design::kRandom) {
    for (std::size_t run = 0; run < count; ++run) {
      std::mt19937_64 engine(draws.seed(run));
      for (double& u : units[run]) u = uniform(engine);
    }
    return units;
  }
  if (spec.design == Design::kLatinHypercube)
    return latin_hypercube(count, width, static_cast<std::uint64_t>(spec.seed));
  const OT::Sample sample = OT::SobolSequence(width).generate(count);
  std::vector<double> shift(width, 0.0);
  std::mt19937_64 engine(static_cast<std::uint64_t>(spec.seed));
  for (double& s : shift) s = uniform(engine);
  for (std::size_t run = 0; run < count; ++run)
    for (std::size_t k = 0; k < width; ++k) units[run][k] = std::fmod(sample(run, k) + shift[k], 1.0);
  return units;
}

}  // namespace

std::vector<std::vector<double>> latin_hypercube(std::size_t count, std::size_t width, std::uint64_t seed) {
  OT::RandomGenerator::SetSeed(seed);
  OT::LHSExperiment design(unit_cube(width), count);
  design.setAlwaysShuffle(true);
  const OT::Sample sample = design.generate();
  std::vector<std::vector<double>> rows(count, std::vector<double>(width));
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < width; ++k) rows[i][k] = sample(i, k);
  return rows;
}

double two_sided_quantile(double confidence, int degrees) {
  const double share = 0.5 * (1.0 + confidence);
  return degrees > 0 ? OT::DistFunc::qStudent(degrees, share) : OT::DistFunc::qNormal(share);
}

double beta_quantile(double a, double b, double share) { return OT::DistFunc::qBeta(a, b, share); }

std::string openturns_version() { return OT::PlatformInfo::GetVersion(); }

std::uint32_t scattered(std::uint32_t base, std::uint32_t place) {
  // Odd factors and shifts are permutations modulo 2^31.
  std::uint32_t x = (base + place) & kSeeds;
  x = (x * 0x2c1b3c6dU) & kSeeds;
  x ^= x >> 15;
  x = (x * 0x297a2d39U) & kSeeds;
  x ^= x >> 13;
  return x;
}

std::uint32_t Draws::seed(std::size_t run) const { return scattered(base_, static_cast<std::uint32_t>(run)); }

Draws::Draws(const SweepSpec& spec, const std::vector<std::vector<double>>* points)
    : base_(scattered(0x1234567U, static_cast<std::uint32_t>(spec.seed) * 0x9e3779b1U & kSeeds)) {
  OT::Log::Show(OT::Log::NONE);
  std::vector<OT::Distribution> laws;
  for (std::size_t k = 0; k < spec.parameters.size(); ++k)
    if (spec.parameters[k].is_drawn()) {
      parameters_.push_back(k);
      laws.push_back(distribution_of(spec.parameters[k]));
      moments_.push_back({laws.back().getMean()[0], laws.back().getStandardDeviation()[0]});
    }
  const std::size_t width = parameters_.size();
  units_ = points != nullptr ? *points : design_of(spec, width, *this);
  for (auto& row : units_) std::transform(row.begin(), row.end(), row.begin(), open_unit);
  if (!spec.correlations.empty()) {
    independent_ = false;
    OT::CorrelationMatrix ranks(width);
    const auto place = [&](const std::string& name) {
      const std::size_t k = index_of(spec.parameters, name);
      return static_cast<std::size_t>(std::find(parameters_.begin(), parameters_.end(), k) - parameters_.begin());
    };
    for (const CorrelationSpec& c : spec.correlations) ranks(place(c.between[0]), place(c.between[1])) = c.rank;
    OT::TriangularMatrix factor;
    try {
      factor = OT::NormalCopula::GetCorrelationFromSpearmanCorrelation(ranks).computeCholesky();
    } catch (const OT::Exception&) {
      throw InputError(code::kConflictingKeys,
                       spec.file +
                           ": correlations: the coefficients contradict each other, expected the ranks of some "
                           "common distribution (a positive definite matrix); reduce them");
    }
    for (auto& row : units_) {
      OT::Point z(width);
      for (std::size_t k = 0; k < width; ++k) z[k] = OT::DistFunc::qNormal(row[k]);
      for (std::size_t k = 0; k < width; ++k) {
        double sum = 0.0;
        for (std::size_t j = 0; j <= k; ++j) sum += factor(k, j) * z[j];
        row[k] = open_unit(OT::DistFunc::pNormal(sum));
      }
    }
  }
  for (const auto& row : units_) {
    std::vector<double> values(width);
    for (std::size_t k = 0; k < width; ++k) values[k] = laws[k].computeQuantile(row[k])[0];
    values_.push_back(values);
  }
  draw_whole_rows(spec);
}

// The first parameter of a file determines the row; the position of each parameter is the position of its own value.
void Draws::draw_whole_rows(const SweepSpec& spec) {
  std::map<std::string, std::size_t> first;  // by file
  const std::vector<std::vector<double>> drawn = units_;
  for (std::size_t k = 0; k < parameters_.size(); ++k) {
    const DistributionSpec& d = spec.parameters[parameters_[k]].distribution;
    if (!d.whole_rows) continue;
    const auto [at, is_first] = first.emplace(d.file, k);
    independent_ = independent_ && is_first;
    std::vector<double> sorted = d.measured;
    std::sort(sorted.begin(), sorted.end());
    const auto count = static_cast<double>(sorted.size());
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      const auto row = static_cast<std::size_t>(drawn[i][at->second] * count);
      const double value = d.measured[std::min(row, d.measured.size() - 1)];
      const auto [low, high] = std::equal_range(sorted.begin(), sorted.end(), value);
      values_[i][k] = value;
      units_[i][k] = 0.5 * static_cast<double>((low - sorted.begin()) + (high - sorted.begin())) / count;
    }
  }
}

std::pair<long, long> quantile_bounds(std::size_t count, double share) {
  // The number of values below the quantile is binomial.
  if (count == 0) return {-1, 0};
  const OT::Binomial below(count, share);
  const auto low = static_cast<long>(below.computeQuantile(0.025)[0]);
  const auto high = static_cast<long>(below.computeQuantile(0.975)[0]);
  return {low - 1, high};
}

std::size_t tolerance_place(std::size_t count, double share) {
  // x_(k), from 1, is too low if at least k values are below the quantile: the least k with P(B >= k) <= 0.05.
  constexpr double kConfidence = 0.95;
  if (count == 0) return 0;
  return static_cast<std::size_t>(OT::Binomial(count, share).computeQuantile(kConfidence)[0]);
}

namespace {

OT::Sample column_of(const std::vector<double>& y, std::size_t first, std::size_t last) {
  OT::Sample sample(last - first, 1);
  for (std::size_t i = first; i < last; ++i) sample(i - first, 0) = y[i];
  return sample;
}

OT::Sample rows_of(const std::vector<std::vector<double>>& x, std::size_t first, std::size_t last) {
  OT::Sample sample(last - first, x.front().size());
  for (std::size_t i = first; i < last; ++i)
    for (std::size_t k = 0; k < x[i].size(); ++k) sample(i - first, k) = x[i][k];
  return sample;
}

// A polynomial of the inputs: y = sum of coefficients times products of orthonormal Legendre polynomials.
struct Chaos {
  OT::Function model;
  std::vector<OT::Indices> degrees;  // of each term, an entry per input
  std::vector<double> coefficients;
};

Chaos chaos_of(const OT::Sample& x, const OT::Sample& y) {
  constexpr double kNorm = 0.75;           // of the degrees: interactions of high degree are left out
  constexpr std::size_t kMostTerms = 250;  // time grows with their square
  constexpr std::size_t kDegree = 12;      // highest: few inputs have fewer terms
  const std::size_t width = x.getDimension();
  const OT::HyperbolicAnisotropicEnumerateFunction enumerate(width, kNorm);
  const std::size_t terms = std::min({kMostTerms, std::max<std::size_t>(1 + width, x.getSize() / 2),
                                      static_cast<std::size_t>(enumerate.getMaximumDegreeCardinal(kDegree))});
  const OT::OrthogonalProductPolynomialFactory basis(
      OT::Collection<OT::OrthogonalUniVariatePolynomialFamily>(width, OT::LegendreFactory()), enumerate);
  OT::FunctionalChaosAlgorithm algorithm(
      x, y, unit_cube(width), OT::FixedStrategy(basis, terms),
      OT::LeastSquaresStrategy(OT::LeastSquaresMetaModelSelectionFactory(OT::LARS(), OT::CorrectedLeaveOneOut())));
  algorithm.run();
  const OT::FunctionalChaosResult result = algorithm.getResult();
  Chaos chaos{result.getMetaModel(), {}, {}};
  const OT::Indices chosen = result.getIndices();
  for (std::size_t k = 0; k < chosen.getSize(); ++k) {
    chaos.degrees.push_back(enumerate(chosen[k]));
    chaos.coefficients.push_back(result.getCoefficients()(k, 0));
  }
  return chaos;
}

// The terms are orthonormal: V = sum of c^2 over all terms but the constant. For input k alone the sum is over terms
// without other inputs, in total over all terms with k [Sudret 2008]. OT::FunctionalChaosSobolIndices takes the first
// term for the constant, which the selection leaves out where the mean is about 0.
void add_indices(const Chaos& chaos, std::size_t width, Sensitivity& s) {
  double variance = 0.0;
  s.first.assign(width, 0.0);
  s.total.assign(width, 0.0);
  for (std::size_t i = 0; i < chaos.degrees.size(); ++i) {
    const OT::Indices& degrees = chaos.degrees[i];
    const double part = chaos.coefficients[i] * chaos.coefficients[i];
    const auto inputs = std::count_if(degrees.begin(), degrees.end(), [](std::size_t d) { return d > 0; });
    if (inputs > 0) variance += part;
    for (std::size_t k = 0; k < width; ++k) {
      if (degrees[k] == 0) continue;
      s.total[k] += part;
      if (inputs == 1) s.first[k] += part;
    }
  }
  for (std::vector<double>* indices : {&s.first, &s.total})
    for (double& index : *indices) index = variance > 0.0 ? index / variance : 0.0;
}

// Products of orthonormal Legendre polynomials at the rows of x, a column per term.
Eigen::MatrixXd terms_at(const Chaos& chaos, const std::vector<std::vector<double>>& x) {
  Eigen::MatrixXd a = Eigen::MatrixXd::Ones(x.size(), chaos.degrees.size());
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t k = 0; k < x[i].size(); ++k) {
      std::size_t most = 0;
      for (const OT::Indices& degrees : chaos.degrees) most = std::max<std::size_t>(most, degrees[k]);
      // (n + 1) P_n+1 = (2 n + 1) u P_n - n P_n-1
      std::vector<double> p = {1.0};
      const double u = 2.0 * x[i][k] - 1.0;
      for (std::size_t n = 0; n < most; ++n) {
        const auto m = static_cast<double>(n);
        p.push_back(((2.0 * m + 1.0) * u * p[n] - (n > 0 ? m * p[n - 1] : 0.0)) / (m + 1.0));
      }
      for (std::size_t j = 0; j < chaos.degrees.size(); ++j) {
        const std::size_t n = chaos.degrees[j][k];
        a(i, j) *= std::sqrt(2.0 * static_cast<double>(n) + 1.0) * p[n];
      }
    }
  return a;
}

// S = sum of c_j^2 over the terms of an input / sum over all terms: dS/dc_j = 2 c_j ([j is of the input] - S) / V.
// The covariance of the coefficients is White's with residuals r / (1 - h) (HC3), h the leverage of a run.
void add_intervals(const Chaos& chaos, const std::vector<std::vector<double>>& x, const std::vector<double>& y,
                   Sensitivity& s) {
  const Eigen::MatrixXd a = terms_at(chaos, x);
  const Eigen::Map<const Eigen::VectorXd> c(chaos.coefficients.data(), a.cols()), values(y.data(), a.rows());
  const Eigen::MatrixXd inverse = (a.transpose() * a).ldlt().solve(Eigen::MatrixXd::Identity(a.cols(), a.cols()));
  const Eigen::ArrayXd leverage = ((a * inverse).array() * a.array()).rowwise().sum();
  const Eigen::ArrayXd residual = (values - a * c).array() / (1.0 - leverage).max(0.05);
  const Eigen::MatrixXd weighted = (a * inverse).array().colwise() * residual;
  const double variance = std::max(c.squaredNorm(), std::numeric_limits<double>::min());
  const double unknown = std::clamp(1.0 - s.explained, 0.0, 1.0);
  // Variance that the polynomial explains in its own runs but not in held-back runs is noise in its terms.
  const double own = 1.0 - (values - a * c).squaredNorm() / values.squaredNorm();
  const double noise = std::max(0.0, own - s.explained);
  const double deviations = two_sided_quantile(0.95, 0);
  for (const bool total : {false, true}) {
    auto& intervals = total ? s.total_interval : s.first_interval;
    for (std::size_t k = 0; k < s.first.size(); ++k) {
      const double index = total ? s.total[k] : s.first[k];
      Eigen::VectorXd slope(c.size());
      for (Eigen::Index j = 0; j < c.size(); ++j) {
        const OT::Indices& degrees = chaos.degrees[j];
        const auto inputs = std::count_if(degrees.begin(), degrees.end(), [](std::size_t d) { return d > 0; });
        const bool mine = degrees[k] > 0 && (total || inputs == 1);
        slope[j] = inputs == 0 ? 0.0 : 2.0 * c[j] * ((mine ? 1.0 : 0.0) - index) / variance;
      }
      const double half = deviations * (weighted * slope).norm();
      intervals.emplace_back(std::max(0.0, (index - half) * (1.0 - unknown) - noise),
                             std::min(1.0, std::min(1.0, index + half) * (1.0 - unknown) + unknown));
    }
  }
}

}  // namespace

Sensitivity sobol_indices(const std::vector<std::vector<double>>& x, const std::vector<double>& values) {
  Sensitivity s;
  const std::size_t count = x.size(), width = x.empty() ? 0 : x.front().size();
  if (count < 8 * (width + 1)) return s;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  if (!(*least < *most)) return s;
  // Without their mean, so that a constant that is added changes nothing.
  std::vector<double> y = values;
  const double mean = std::accumulate(y.begin(), y.end(), 0.0) / static_cast<double>(count);
  for (double& value : y) value -= mean;
  const std::size_t fitted = count - count / 4;
  const OT::Function model = chaos_of(rows_of(x, 0, fitted), column_of(y, 0, fitted)).model;
  const OT::Sample predicted = model(rows_of(x, fitted, count));
  double error = 0.0, variance = 0.0;
  for (std::size_t i = fitted; i < count; ++i) {
    error += std::pow(y[i] - predicted(i - fitted, 0), 2);
    variance += y[i] * y[i];
  }
  s.explained = variance > 0.0 ? 1.0 - error / variance : 0.0;
  const Chaos chaos = chaos_of(rows_of(x, 0, count), column_of(y, 0, count));
  add_indices(chaos, width, s);
  add_intervals(chaos, x, y, s);
  return s;
}

Surface response_surface(const std::vector<std::vector<double>>& x, const std::vector<double>& y) {
  constexpr std::size_t kFew = 3;  // points
  constexpr double kSmoothness = 2.5, kLengths[] = {0.7, 3.0};
  constexpr double kNoises[] = {1e-8, 1e-4, 1e-2, 1.0};  // variance, over the variance of the function
  const auto [least, most] = std::minmax_element(y.begin(), y.end());
  if (y.size() < kFew || x.front().empty() || !(*least < *most)) {
    const double mean = std::accumulate(y.begin(), y.end(), 0.0) / static_cast<double>(y.size());
    return [mean](const std::vector<std::vector<double>>& points) { return std::vector<double>(points.size(), mean); };
  }
  OT::Log::Show(OT::Log::NONE);
  const std::size_t width = x.front().size();
  const OT::Sample points = rows_of(x, 0, x.size()), values = column_of(y, 0, y.size());
  const OT::Basis trend =
      x.size() > width + 2 ? OT::LinearBasisFactory(width).build() : OT::ConstantBasisFactory(width).build();
  double best = -std::numeric_limits<double>::infinity();
  OT::CovarianceModel chosen;
  for (const double length : kLengths)
    for (const double noise : kNoises) {
      OT::CovarianceModel model = OT::MaternModel(OT::Point(width, length), kSmoothness);
      model.setNuggetFactor(noise);
      OT::GeneralLinearModelAlgorithm algorithm(points, values, model, trend);
      const double likelihood = algorithm.getObjectiveFunction()(OT::Point(width, length))[0];
      if (likelihood > best) best = likelihood, chosen = model;
    }
  OT::KrigingAlgorithm algorithm(points, values, chosen, trend);
  algorithm.setOptimizeParameters(false);
  algorithm.run();
  const OT::Function model = algorithm.getResult().getMetaModel();
  return [model](const std::vector<std::vector<double>>& places) {
    const OT::Sample found = model(rows_of(places, 0, places.size()));
    std::vector<double> all(places.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = found(i, 0);
    return all;
  };
}

std::vector<double> rank_correlations(const std::vector<std::vector<double>>& x, const std::vector<double>& y) {
  const auto [least, most] = std::minmax_element(y.begin(), y.end());
  if (x.size() < 3 || !(*least < *most)) return {};
  const OT::Point r =
      OT::CorrelationAnalysis(rows_of(x, 0, x.size()), column_of(y, 0, y.size())).computeSpearmanCorrelation();
  return {r.begin(), r.end()};
}

}  // namespace footfall
