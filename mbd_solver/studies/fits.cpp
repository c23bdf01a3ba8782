// Fits by QR of the centred logarithms; pictures show measured over fitted values.
#include "mbd_solver/studies/fits.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <set>
#include <unsupported/Eigen/SpecialFunctions>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/plot_script.h"
#include "mbd_solver/base/quote.h"
#include "mbd_solver/studies/codes.h"
#include "mbd_solver/studies/tables.h"

namespace footfall {
namespace {

constexpr double kConfidence = 0.95;

// Probability that |t| < x (Abramowitz and Stegun, 26.7.1).
double student_probability(double x, int degrees) {
  return 1.0 - Eigen::numext::betainc(0.5 * degrees, 0.5, degrees / (degrees + x * x));
}

void require_rows(Eigen::Index rows, Eigen::Index coefficients) {
  if (rows <= coefficients)
    throw InputError(code::kPowerLaw, std::to_string(rows) + " values for " + std::to_string(coefficients) +
                                          " coefficients, expected more values");
}

// From the residuals e of log y about the law.
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
  require_rows(n, m + 1);
  // Centred columns are orthogonal to the constant, and pivots show collinearity.
  const Eigen::MatrixXd log_x = x.array().log();
  const Eigen::VectorXd log_y = y.array().log();
  const Eigen::RowVectorXd mean_x = log_x.colwise().mean();
  const Eigen::MatrixXd X = log_x.rowwise() - mean_x;
  constexpr double kIndependent = 1e-8;  // of the largest pivot; numbers in files have about six digits
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(X);
  qr.setThreshold(kIndependent);
  if (qr.rank() < m)
    throw InputError(code::kPowerLaw, "the quantities do not vary independently; expected values in all combinations");

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
  require_rows(x.rows(), 1);
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

namespace fs = std::filesystem;

namespace {

constexpr int kShort = 3;

// "d = 0.1 (rho)^0.50 (D)^0.67".
std::string law_text(const FitSpec& fit, const PowerLaw& law) {
  std::string text = fit.label + " = " + number_text(law.factor, kShort);
  for (std::size_t k = 0; k < fit.factors.size(); ++k)
    text += " (" + fit.factors[k].name + ")^" + fixed_text(law.exponents[k], 2);
  return text;
}

// Place of the fit in the file, for messages.
std::string place_of(const SweepSpec& spec, const FitSpec& fit) {
  return spec.file + ":" + std::to_string(fit.source.line) + ": " + fit.source.path;
}

// " with diameter 0.24": the runs of the fit.
std::string where_text(const FitSpec& fit) {
  std::string text;
  for (const auto& [parameter, value] : fit.where) text += (text.empty() ? " with " : ", ") + parameter + " " + value;
  return text;
}

// Authors of published exponents.
std::set<std::string> publishers(const FitSpec& fit) {
  std::set<std::string> names;
  for (const FitFactor& factor : fit.factors)
    for (const auto& [who, exponent] : factor.published) names.insert(who);
  return names;
}

// The published exponent; empty: none by this author.
std::string published_by(const FitFactor& factor, const std::string& who) {
  const auto found = factor.published.find(who);
  return found == factor.published.end() ? "" : number_text(*number_in(found->second), kShort);
}

struct FitResult {
  FitData data;
  PowerLaw law;
  std::vector<std::pair<std::string, PowerLaw>> published;  // of authors who give every exponent: only A is fitted
};

FitResult fitted(const SweepSpec& spec, const FitSpec& fit, const Plan& plan, const std::vector<RunResult>& results) {
  FitResult r;
  r.data = fit_data(spec, fit, plan, results);
  try {
    r.law = fit_power_law(r.data.x, r.data.y);
  } catch (const InputError& error) {
    throw InputError(place_of(spec, fit) + ": " + error.what());
  }
  for (const std::string& who : publishers(fit)) {
    std::vector<double> exponents;
    for (const FitFactor& factor : fit.factors)
      if (factor.published.count(who) > 0) exponents.push_back(*number_in(factor.published.at(who)));
    if (exponents.size() < fit.factors.size()) continue;
    const Eigen::Map<const Eigen::VectorXd> given(exponents.data(), r.data.x.cols());
    r.published.emplace_back(who, fit_factor(r.data.x, r.data.y, given));
  }
  return r;
}

std::string fit_page(const FitSpec& fit, const FitResult& r) {
  const auto quality = [](const PowerLaw& law) {
    return ", R^2 = " + fixed_text(law.r_squared, 4) + ", scatter " + fixed_text(100.0 * law.scatter, 1) + " %\n";
  };
  std::vector<std::string> head = {"exponent of", "found", "standard error", "95 % interval"};
  for (const std::string& who : publishers(fit)) head.push_back(who);
  Table table(head);
  for (std::size_t k = 0; k < fit.factors.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    std::vector<std::string> row = {fit.factors[k].name, fixed_text(r.law.exponents[i], 3),
                                    fixed_text(r.law.errors[i], 3),
                                    fixed_text(r.law.lower[i], 3) + " to " + fixed_text(r.law.upper[i], 3)};
    for (const std::string& who : publishers(fit)) row.push_back(published_by(fit.factors[k], who));
    table.add(row);
  }
  std::string text = "\n`" + law_text(fit, r.law) + "`: " + std::to_string(r.data.runs.size()) + " runs" +
                     where_text(fit) + quality(r.law) + "\n" + table.page();
  for (const auto& [who, law] : r.published)
    text += "\nWith the exponents of " + who + ": `" + law_text(fit, law) + "`" + quality(law);
  return text;
}

void add_rows(const FitSpec& fit, const FitResult& r, const std::string& name, const PowerLaw& law, Table& table) {
  const auto add = [&](const std::string& what, double value, double error, double low, double high) {
    std::vector<std::string> row = {fit.name, name, what};
    for (const double number : {value, error, low, high}) row.push_back(number_text(number));
    append(row, {std::to_string(r.data.runs.size()), std::to_string(law.degrees_of_freedom), number_text(law.r_squared),
                 number_text(law.scatter)});
    table.add(row);
  };
  add("factor", law.factor, std::nan(""), law.factor_interval.first, law.factor_interval.second);
  for (std::size_t k = 0; k < fit.factors.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    add(fit.factors[k].name, law.exponents[i], law.errors[i], law.lower[i], law.upper[i]);
  }
}

// Tics between the decades, so that every axis has more than one number.
std::string tics_between(double low, double high) {
  const bool narrow = high < 4.0 * low;  // few would lie within
  const std::vector<int> digits = narrow ? std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8} : std::vector<int>{1, 2, 3, 5};
  std::vector<std::string> tics;
  for (int decade = static_cast<int>(std::floor(std::log10(low)));
       decade <= static_cast<int>(std::ceil(std::log10(high))); ++decade)
    for (const int digit : digits) tics.push_back(number_text(digit * std::pow(10.0, decade), kShort));
  return "(" + joined(tics) + ")";
}

// Measured over fitted, one symbol per value of the parameter `marks`; the line is the law. Returns the script.
std::string draw_fit(const SweepSpec& spec, const FitSpec& fit, const Plan& plan, const FitResult& r,
                     const std::string& folder) {
  const int marks = index_of(spec.parameters, fit.marks);
  const auto mark_of = [&](std::size_t run) { return marks < 0 ? "" : plan.runs[run].values[marks]; };
  std::vector<std::string> values = {""};
  if (marks >= 0) values = names_in(spec.parameters[marks].choices);
  std::string data;
  std::vector<std::string> curves = {"x with lines lc rgb 'gray40' title 'power law'"};
  for (std::size_t k = 0; k < values.size(); ++k) {
    std::string points;
    for (std::size_t i = 0; i < r.data.runs.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      if (mark_of(r.data.runs[i]) == values[k])
        points += number_text(r.law.at(r.data.x.row(row).transpose())) + " " + number_text(r.data.y[row]) + "\n";
    }
    if (points.empty()) continue;
    const std::string color = std::to_string(k + 1), block = "$d" + color;
    data += block + " << EOD\n" + points + "EOD\n";
    curves.push_back(block + " using 1:2 with points pt " + std::to_string(2 * k + 5) + " ps 1.3 lc " + color +
                     " title " + gnuplot_text(marks < 0 ? "" : fit.marks + " " + values[k]));
  }
  const double low = r.data.y.minCoeff(), high = r.data.y.maxCoeff();
  const std::string tics = tics_between(low, high);
  const std::string range = "[" + number_text(low / 1.2) + ":" + number_text(high * 1.2) + "]";
  return write_drawing(folder, fit.name, {760, 720}, data,
                       "set logscale xy\nset grid\nset size square\nset xtics " + tics + "\nset ytics " + tics +
                           "\nset xrange " + range + "\nset yrange " + range + "\nset title " +
                           gnuplot_text(spec.title + where_text(fit)) + " noenhanced\nset xlabel " +
                           gnuplot_text(law_text(fit, r.law)) + " noenhanced\nset ylabel " + gnuplot_text(fit.metric) +
                           " noenhanced\nset key below center noenhanced\nplot " + joined(curves) + "\n");
}

}  // namespace

FitData fit_data(const SweepSpec& spec, const FitSpec& fit, const Plan& plan, const std::vector<RunResult>& results) {
  FitData data;
  const auto is_meant = [&](const RunRequest& run) {
    return std::all_of(fit.where.begin(), fit.where.end(), [&](const auto& entry) {
      return run.values[index_of(spec.parameters, entry.first)] == entry.second;
    });
  };
  for (std::size_t i = 0; i < plan.runs.size(); ++i)
    if (results[i].end.done() && is_meant(plan.runs[i])) data.runs.push_back(i);
  data.x = Eigen::MatrixXd::Zero(data.runs.size(), fit.factors.size());
  data.y.resize(data.x.rows());
  const auto positive = [&](double value, const std::string& what, std::size_t run) {
    if (!(value > 0.0))
      throw InputError(code::kPowerLaw, place_of(spec, fit) + "." + what + ": is " + number_text(value, kShort) +
                                            " in the run " + plan.runs[run].name + ", expected a number above zero");
    return value;
  };
  for (Eigen::Index row = 0; row < data.x.rows(); ++row) {
    const std::size_t run = data.runs[row];
    const auto value_of = [&](const std::string& name) {
      if (const int metric = index_of(spec.metrics, name); metric >= 0) return results[run].metrics[metric];
      return *number_in(plan.runs[run].values[index_of(spec.parameters, name)]);
    };
    data.y[row] = positive(value_of(fit.metric), "figure", run);
    for (Eigen::Index k = 0; k < data.x.cols(); ++k) {
      const FitFactor& factor = fit.factors[k];
      for (const std::string& name : factor.sum) data.x(row, k) += value_of(name);
      positive(data.x(row, k), "factors \"" + factor.name + "\"", run);
    }
  }
  return data;
}

std::vector<std::string> write_fits(const SweepSpec& spec, const Plan& plan, const std::vector<RunResult>& results,
                                    const std::string& folder) {
  if (spec.fits.empty()) return {};
  std::vector<FitResult> found;
  for (const FitSpec& fit : spec.fits) found.push_back(fitted(spec, fit, plan, results));
  Table table({"fit", "law", "exponent_of", "value", "standard_error", "low_95", "high_95", "runs",
               "degrees_of_freedom", "r_squared", "scatter"});
  std::string page = "Made by `./footfall sweep " + spec.file + "`.\n";
  std::vector<std::string> scripts;
  for (std::size_t f = 0; f < spec.fits.size(); ++f) {
    const FitSpec& fit = spec.fits[f];
    add_rows(fit, found[f], "fitted", found[f].law, table);
    for (const auto& [who, law] : found[f].published) add_rows(fit, found[f], who, law, table);
    const std::string section = fit_page(fit, found[f]);
    std::printf("%s", section.c_str());
    page += section;
    scripts.push_back(draw_fit(spec, fit, plan, found[f], folder));
  }
  const std::string csv = (fs::path(folder) / "fits.csv").string(), md = (fs::path(folder) / "fits.md").string();
  write_whole_file(csv, table.csv());
  write_whole_file(md, page);
  std::vector<std::string> files = run_gnuplot(folder, scripts);
  files.insert(files.begin(), {csv, md});
  return files;
}

}  // namespace footfall
