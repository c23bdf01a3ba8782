// OpenTURNS with functions of std::vector.
#include "mbd_solver/campaign/optimum.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <openturns/EvaluationImplementation.hxx>
#include <openturns/Function.hxx>
#include <openturns/Log.hxx>
#include <openturns/NLopt.hxx>
#include <unsupported/Eigen/NonLinearOptimization>

#include "coupler/base/errors.h"
#include "mbd_solver/studies/codes.h"

namespace footfall {
namespace {

using Numbers = std::vector<double>;
constexpr double kVeryBad = 1e6;   // residual where there is none
constexpr double kOutside = 0.01;  // slope of residuals outside of the bounds, of those at the start per range
constexpr double kRounded = 1e12;  // positions between the bounds are rounded to its inverse

Numbers numbers_of(const OT::Point& p) { return {p.begin(), p.end()}; }
Numbers numbers_of(const Eigen::VectorXd& p) { return {p.begin(), p.end()}; }
OT::Point point_of(const Numbers& x) { return OT::Point(OT::Collection<double>(x.begin(), x.end())); }
Eigen::VectorXd vector_of(const Numbers& x) { return Eigen::Map<const Eigen::VectorXd>(x.data(), x.size()); }

class OurEvaluation : public OT::EvaluationImplementation {
 public:
  OurEvaluation(std::size_t inputs, std::size_t outputs, std::function<Numbers(const Numbers&)> f)
      : inputs_(inputs), outputs_(outputs), f_(std::move(f)) {
    setInputDescription(OT::Description::BuildDefault(inputs, "x"));
    setOutputDescription(OT::Description::BuildDefault(outputs, "y"));
  }
  OurEvaluation* clone() const override { return new OurEvaluation(*this); }
  OT::UnsignedInteger getInputDimension() const override { return inputs_; }
  OT::UnsignedInteger getOutputDimension() const override { return outputs_; }
  OT::Point operator()(const OT::Point& x) const override { return point_of(f_(numbers_of(x))); }

 private:
  std::size_t inputs_, outputs_;
  std::function<Numbers(const Numbers&)> f_;
};

// A function of the nearest point within the bounds, continued by residuals that grow with the distance from them: variables
// that are bent at the bounds instead let searches jump from one end to the other. Its derivatives by central differences
// within the bounds. In the form that Eigen's search wants.
class Continued {
 public:
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  Continued(const OptimumTask& task, const Residuals& f) : task_(task), f_(f) {
    const Numbers r = f_({inside(task.start)}).front();
    rows_ = r.size();
    for (const double one : r) outside_ += one * one;
    outside_ = kOutside * std::sqrt(outside_);
  }
  int inputs() const { return static_cast<int>(task_.start.size()); }
  int values() const { return static_cast<int>(rows_) + inputs(); }

  Numbers inside(Numbers x) const {
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] = std::clamp(std::round(x[i] * kRounded) / kRounded, task_.least[i], task_.most[i]);
    return x;
  }
  std::size_t rows() const { return rows_; }  // 0: the start has none
  double slope(std::size_t i) const { return outside_ / (task_.most[i] - task_.least[i]); }

  int operator()(const Eigen::VectorXd& at, Eigen::VectorXd& values) const {
    const Numbers x = numbers_of(at), within = inside(x);
    Numbers r = f_({within}).front();
    if (r.size() != rows_) r.assign(rows_, kVeryBad);
    for (std::size_t i = 0; i < x.size(); ++i) r.push_back(slope(i) * (x[i] - within[i]));
    values = vector_of(r);
    return 0;
  }
  // d(k, i): of residual k by input i.
  int df(const Eigen::VectorXd& at, Eigen::MatrixXd& d) const {
    const Numbers x = numbers_of(at);
    std::vector<Numbers> points;
    for (std::size_t i = 0; i < x.size(); ++i)
      for (const double step : {task_.step, -task_.step}) {
        points.push_back(inside(x));
        if (!out(x, i)) points.back()[i] = std::clamp(points.back()[i] + step, task_.least[i], task_.most[i]);
      }
    points.push_back(inside(x));
    const std::vector<Numbers> r = f_(points);
    d.setZero();
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Numbers &up = r[2 * i], &down = r[2 * i + 1];
      const double width = points[2 * i][i] - points[2 * i + 1][i];
      if (width == 0.0 || up.size() != rows_ || down.size() != rows_ || r.back().size() != rows_) continue;
      double push = 0.0;  // of |r|^2
      for (std::size_t k = 0; k < rows_; ++k) push += r.back()[k] * (up[k] - down[k]);
      // At a bound that keeps the number from less |r|^2 only the others move.
      if ((x[i] <= task_.least[i] && push > 0.0) || (x[i] >= task_.most[i] && push < 0.0)) continue;
      for (std::size_t k = 0; k < rows_; ++k) d(k, i) = (up[k] - down[k]) / width;
    }
    for (std::size_t i = 0; i < x.size(); ++i)
      if (x[i] < task_.least[i] || x[i] > task_.most[i]) d(rows_ + i, i) = slope(i);
    return 0;
  }

 private:
  // By more than the step of differences: the number only comes back to the bound.
  bool out(const Numbers& x, std::size_t i) const {
    return x[i] < task_.least[i] - task_.step || x[i] > task_.most[i] + task_.step;
  }

  const OptimumTask& task_;
  const Residuals& f_;
  std::size_t rows_ = 0;
  double outside_ = 0.0;  // slope of the residuals outside, per range
};

// Runs f; OpenTURNS and NLopt lose exceptions.
template <class F>
auto noting(std::exception_ptr& thrown, const F& f) {
  try {
    return f();
  } catch (...) {
    thrown = std::current_exception();
    throw;
  }
}

void run(OT::OptimizationAlgorithmImplementation& search, const Numbers& start, int evaluations,
         const std::exception_ptr& thrown) {
  OT::Log::Show(OT::Log::NONE);
  search.setStartingPoint(point_of(start));
#if OPENTURNS_VERSION >= 102300  // 1.23, which renamed it
  search.setMaximumCallsNumber(evaluations);
#else
  search.setMaximumEvaluationNumber(evaluations);
#endif
  try {
    search.run();
  } catch (...) {
    if (thrown) std::rethrow_exception(thrown);
    throw;
  }
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace

Numbers minimum(const char* method, const OptimumTask& task, const std::function<double(const Numbers&)>& value) {
  // Where a method ends without a result, the best point is known all the same.
  Numbers best = task.start;
  double least = std::numeric_limits<double>::infinity();
  std::exception_ptr thrown;
  const OurEvaluation f(task.start.size(), 1, [&](const Numbers& x) {
    const double y = noting(thrown, [&] { return value(x); });
    if (y < least) least = y, best = x;
    return Numbers{y};
  });
  OT::OptimizationProblem problem{OT::Function(f)};
  problem.setBounds({point_of(task.least), point_of(task.most)});
  OT::NLopt search(problem, method);
  search.setMaximumAbsoluteError(task.precision);
  search.setMaximumRelativeError(0.0);
  search.setMaximumResidualError(0.0);
  search.setInitialStep(OT::Point(task.start.size(), task.step));
  try {
    run(search, task.start, task.evaluations, thrown);
  } catch (const std::exception& e) {
    if (thrown) throw;
    if (least == std::numeric_limits<double>::infinity())
      throw InputError(code::kSearchRefused, "NLopt refused the search " + std::string(method) + ": " + e.what());
  }
  return best;
}

Numbers least_squares(const OptimumTask& task, const Residuals& residuals) {
  const Continued continued(task, residuals);
  if (continued.rows() == 0) return task.start;
  Eigen::LevenbergMarquardt<const Continued> search(continued);
  search.parameters.xtol = task.precision;
  search.parameters.ftol = 1e-12;
  search.parameters.gtol = 0.0;
  search.parameters.maxfev = task.evaluations;
  Eigen::VectorXd x = vector_of(continued.inside(task.start));
  search.minimize(x);
  return continued.inside(numbers_of(x));
}

}  // namespace footfall
