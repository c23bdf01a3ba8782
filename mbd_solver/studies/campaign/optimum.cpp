// Functions of std::vector as those of OpenTURNS.
#include "mbd_solver/studies/campaign/optimum.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <openturns/CMinpack.hxx>
#include <openturns/EvaluationImplementation.hxx>
#include <openturns/Function.hxx>
#include <openturns/GradientImplementation.hxx>
#include <openturns/LeastSquaresProblem.hxx>
#include <openturns/Log.hxx>
#include <openturns/NLopt.hxx>

#include "coupler/base/errors.h"
#include "mbd_solver/studies/codes.h"

namespace footfall {
namespace {

using Numbers = std::vector<double>;
constexpr double kVeryBad = 1e6;   // residual where there is none
constexpr double kInside = 0.02;   // of the range: a least squares search starts off its ends, where derivatives vanish
constexpr double kRounded = 1e12;  // positions between the bounds are rounded to its inverse

Numbers numbers_of(const OT::Point& p) { return {p.begin(), p.end()}; }
OT::Point point_of(const Numbers& x) { return OT::Point(OT::Collection<double>(x.begin(), x.end())); }

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

// Derivatives as OpenTURNS has them, a row per input; its own central differences leave the bounds.
class OurGradient : public OT::GradientImplementation {
 public:
  OurGradient(std::size_t outputs, const OptimumTask& task, const Residuals& f)
      : outputs_(outputs), task_(task), f_(f) {}
  OurGradient* clone() const override { return new OurGradient(*this); }
  OT::UnsignedInteger getInputDimension() const override { return task_.start.size(); }
  OT::UnsignedInteger getOutputDimension() const override { return outputs_; }
  OT::Matrix gradient(const OT::Point& x) const override {
    std::vector<Numbers> points;
    for (std::size_t i = 0; i < task_.start.size(); ++i)
      for (const double step : {task_.step, -task_.step}) {
        points.push_back(numbers_of(x));
        points.back()[i] = std::clamp(x[i] + step, task_.least[i], task_.most[i]);
      }
    const std::vector<Numbers> r = f_(points);
    OT::Matrix d(task_.start.size(), outputs_);
    for (std::size_t i = 0; i < task_.start.size(); ++i)
      for (std::size_t k = 0; k < outputs_; ++k)
        if (r[2 * i].size() == outputs_ && r[2 * i + 1].size() == outputs_)
          d(i, k) = (r[2 * i][k] - r[2 * i + 1][k]) / (points[2 * i][i] - points[2 * i + 1][i]);
    return d;
  }

 private:
  std::size_t outputs_;
  const OptimumTask& task_;
  const Residuals& f_;
};

// Runs f; OpenTURNS and NLopt forget what was thrown.
template <class F>
auto noting(std::exception_ptr& thrown, const F& f) {
  try {
    return f();
  } catch (...) {
    thrown = std::current_exception();
    throw;
  }
}

template <class Problem>
Problem bounded(Problem problem, const OptimumTask& task) {
  OT::Log::Show(OT::Log::NONE);
  problem.setBounds({point_of(task.least), point_of(task.most)});
  return problem;
}

void run(OT::OptimizationAlgorithmImplementation& search, const Numbers& start, int evaluations,
         const std::exception_ptr& thrown) {
  search.setStartingPoint(point_of(start));
  search.setMaximumEvaluationNumber(static_cast<std::size_t>(evaluations));
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
  OT::NLopt search(bounded(OT::OptimizationProblem(OT::Function(f)), task), method);
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
  const std::size_t n = task.start.size();
  std::exception_ptr thrown;
  const Residuals inside = [&](const std::vector<Numbers>& points) {
    std::vector<Numbers> rounded = points;
    for (Numbers& x : rounded)
      for (std::size_t i = 0; i < n; ++i)
        x[i] = std::clamp(std::round(x[i] * kRounded) / kRounded, task.least[i], task.most[i]);
    std::vector<Numbers> all = noting(thrown, [&] { return residuals(rounded); });
    for (Numbers& r : all)
      if (!r.empty()) r.resize(std::max(n, r.size()), 0.0);  // MINPACK wants at least as many as unknowns
    return all;
  };
  Numbers start = task.start;
  for (std::size_t i = 0; i < n; ++i) {
    const double margin = kInside * (task.most[i] - task.least[i]);
    start[i] = std::clamp(start[i], task.least[i] + margin, task.most[i] - margin);
  }
  const std::size_t rows = inside({start}).front().size();
  if (rows == 0) return start;
  OT::Function function(OurEvaluation(n, rows, [&](const Numbers& x) {
    const Numbers r = inside({x}).front();
    return r.size() == rows ? r : Numbers(rows, kVeryBad);
  }));
  function.setGradient(OurGradient(rows, task, inside));
  OT::CMinpack search(bounded(OT::LeastSquaresProblem(function), task));
  search.setMaximumAbsoluteError(task.precision);
  search.setMaximumRelativeError(task.precision);
  search.setMaximumResidualError(1e-12);
  run(search, start, task.evaluations, thrown);
  return numbers_of(search.getResult().getOptimalPoint());
}

}  // namespace footfall
