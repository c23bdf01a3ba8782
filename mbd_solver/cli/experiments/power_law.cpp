#include "mbd_solver/cli/experiments/power_law.h"

#include <Eigen/QR>
#include <cmath>
#include <unsupported/Eigen/SpecialFunctions>

#include "coupler/base/errors.h"

namespace footfall {

namespace {

constexpr double kConfidence = 0.95;

// Probability that |t| < x (Abramowitz and Stegun, 26.7.1).
double student_probability(double x, int degrees) {
  return 1.0 - Eigen::numext::betainc(0.5 * degrees, 0.5, degrees / (degrees + x * x));
}

void demand_rows(Eigen::Index rows, Eigen::Index coefficients) {
  if (rows <= coefficients)
    throw InputError(std::to_string(rows) + " values for " + std::to_string(coefficients) +
                     " coefficients, expected more values than coefficients");
}

// Fills what follows from residuals e of log y about the law.
void judge(PowerLaw& law, const Eigen::VectorXd& log_y, const Eigen::VectorXd& e) {
  const double total = (log_y.array() - log_y.mean()).square().sum();
  law.scatter = std::sqrt(e.squaredNorm() / law.degrees_of_freedom);
  law.r_squared = total > 0.0 ? 1.0 - e.squaredNorm() / total : 1.0;
}

}  // namespace

double student_t(double confidence, int degrees) {
  FOOTFALL_DEMAND(confidence > 0.0 && confidence < 1.0 && degrees >= 1);
  double low = 0.0, high = 1.0;
  while (student_probability(high, degrees) < confidence) high *= 2.0;
  while (high - low > 1e-15 * high) {
    const double middle = 0.5 * (low + high);
    (student_probability(middle, degrees) < confidence ? low : high) = middle;
  }
  return high;
}

double PowerLaw::at(const Eigen::VectorXd& x) const {
  return factor * std::exp(exponents.dot(x.array().log().matrix()));
}

PowerLaw fit_power_law(const Eigen::MatrixXd& x, const Eigen::VectorXd& y) {
  const Eigen::Index n = x.rows(), m = x.cols();
  demand_rows(n, m + 1);
  // About their means the columns are orthogonal to the constant, and near collinearity shows in the pivots.
  const Eigen::MatrixXd log_x = x.array().log();
  const Eigen::VectorXd log_y = y.array().log();
  const Eigen::RowVectorXd mean_x = log_x.colwise().mean();
  const Eigen::MatrixXd X = log_x.rowwise() - mean_x;
  constexpr double kIndependent = 1e-8;  // of the largest pivot; logarithms read from files carry some six digits
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(X);
  qr.setThreshold(kIndependent);
  if (qr.rank() < m)
    throw InputError("the quantities do not vary independently of each other; expected values in all combinations");

  PowerLaw law;
  law.exponents = qr.solve((log_y.array() - log_y.mean()).matrix());
  law.degrees_of_freedom = static_cast<int>(n - m) - 1;
  judge(law, log_y, (log_y.array() - log_y.mean()).matrix() - X * law.exponents);
  // Covariance of the exponents: scatter^2 (X^T X)^-1 with X P = Q R.
  const Eigen::MatrixXd R_inverse =
      qr.matrixR().topLeftCorner(m, m).triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(m, m));
  const Eigen::MatrixXd S = qr.colsPermutation() * R_inverse;
  const double t = student_t(kConfidence, law.degrees_of_freedom);
  law.errors = law.scatter * S.rowwise().norm();
  law.lower = law.exponents - t * law.errors;
  law.upper = law.exponents + t * law.errors;
  const double log_factor = log_y.mean() - mean_x.dot(law.exponents);
  const double error = law.scatter * std::sqrt(1.0 / static_cast<double>(n) + (mean_x * S).squaredNorm());
  law.factor = std::exp(log_factor);
  law.factor_interval = {std::exp(log_factor - t * error), std::exp(log_factor + t * error)};
  return law;
}

PowerLaw fit_factor(const Eigen::MatrixXd& x, const Eigen::VectorXd& y, const Eigen::VectorXd& exponents) {
  demand_rows(x.rows(), 1);
  const Eigen::VectorXd log_y = y.array().log();
  const Eigen::VectorXd rest = log_y - x.array().log().matrix() * exponents;
  PowerLaw law;
  law.exponents = law.lower = law.upper = exponents;
  law.errors = Eigen::VectorXd::Zero(exponents.size());
  law.degrees_of_freedom = static_cast<int>(x.rows()) - 1;
  judge(law, log_y, rest.array() - rest.mean());
  const double error =
      student_t(kConfidence, law.degrees_of_freedom) * law.scatter / std::sqrt(static_cast<double>(x.rows()));
  law.factor = std::exp(rest.mean());
  law.factor_interval = {std::exp(rest.mean() - error), std::exp(rest.mean() + error)};
  return law;
}

}  // namespace footfall
