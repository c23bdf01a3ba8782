#include "mbd_solver/cli/experiments/fits.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/quote.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/analysis/gnuplot.h"
#include "mbd_solver/cli/experiments/text.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

constexpr int kShort = 3;

// "d = 0.1 (rho)^0.50 (D)^0.67".
std::string law_text(const FitSpec& fit, const PowerLaw& law) {
  std::string text = fit.label + " = " + number_text(law.factor, kShort);
  for (std::size_t k = 0; k < fit.factors.size(); ++k)
    text += " (" + fit.factors[k].name + ")^" + fixed_text(law.exponents[static_cast<Eigen::Index>(k)], 2);
  return text;
}

// " with diameter 0.24": which runs are meant.
std::string where_text(const FitSpec& fit) {
  std::string text;
  for (const auto& [parameter, value] : fit.where) text += (text.empty() ? " with " : ", ") + parameter + " " + value;
  return text;
}

// Those who published, in the order of the file.
std::vector<std::string> publishers(const FitSpec& fit) {
  std::vector<std::string> names;
  for (const FitFactor& factor : fit.factors)
    for (const auto& [who, exponent] : factor.published)
      if (std::find(names.begin(), names.end(), who) == names.end()) names.push_back(who);
  return names;
}

std::optional<double> published_by(const FitFactor& factor, const std::string& who) {
  for (const auto& [name, exponent] : factor.published)
    if (name == who) return exponent;
  return std::nullopt;
}

// Laws with published exponents, of those who give every one: only the factor A is fitted.
std::vector<std::pair<std::string, PowerLaw>> published_laws(const FitSpec& fit, const FitData& data) {
  std::vector<std::pair<std::string, PowerLaw>> laws;
  for (const std::string& who : publishers(fit)) {
    Eigen::VectorXd exponents(static_cast<Eigen::Index>(fit.factors.size()));
    bool all = true;
    for (std::size_t k = 0; k < fit.factors.size(); ++k) {
      const std::optional<double> exponent = published_by(fit.factors[k], who);
      all = all && exponent;
      exponents[static_cast<Eigen::Index>(k)] = exponent.value_or(0.0);
    }
    if (all) laws.emplace_back(who, fit_factor(data.x, data.y, exponents));
  }
  return laws;
}

struct FitResult {
  FitData data;
  PowerLaw law;
  std::vector<std::pair<std::string, PowerLaw>> published;
};

void write_page(std::ostream& out, const FitSpec& fit, const FitResult& r) {
  const std::vector<std::string> names = publishers(fit);
  out << "\n`" << law_text(fit, r.law) << "`: " << r.data.runs.size() << " runs" << where_text(fit)
      << ", R^2 = " << fixed_text(r.law.r_squared, 4) << ", scatter " << fixed_text(100.0 * r.law.scatter, 1)
      << " %\n\n| exponent of | found | standard error | 95 % interval |";
  for (const std::string& who : names) out << ' ' << who << " |";
  out << "\n|---|---|---|---|";
  for (std::size_t k = 0; k < names.size(); ++k) out << "---|";
  out << '\n';
  for (std::size_t k = 0; k < fit.factors.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    out << "| " << fit.factors[k].name << " | " << fixed_text(r.law.exponents[i], 3) << " | "
        << fixed_text(r.law.errors[i], 3) << " | " << fixed_text(r.law.lower[i], 3) << " to "
        << fixed_text(r.law.upper[i], 3) << " |";
    for (const std::string& who : names) {
      const std::optional<double> exponent = published_by(fit.factors[k], who);
      out << ' ' << (exponent ? number_text(*exponent, kShort) : "") << " |";
    }
    out << '\n';
  }
  for (const auto& [who, law] : r.published)
    out << "\nWith the exponents of " << who << ": `" << law_text(fit, law)
        << "`, R^2 = " << fixed_text(law.r_squared, 4) << ", scatter " << fixed_text(100.0 * law.scatter, 1) << " %\n";
}

void write_rows(std::ostream& out, const FitSpec& fit, const FitResult& r) {
  const auto row = [&](const std::string& law, const std::string& what, double value, double error, double low,
                       double high, const PowerLaw& of) {
    out << fit.name << ',' << csv_field(law) << ',' << csv_field(what) << ',' << number_text(value) << ','
        << number_text(error) << ',' << number_text(low) << ',' << number_text(high) << ',' << r.data.runs.size() << ','
        << of.degrees_of_freedom << ',' << number_text(of.r_squared) << ',' << number_text(of.scatter) << '\n';
  };
  const auto rows = [&](const std::string& name, const PowerLaw& law) {
    row(name, "factor", law.factor, std::nan(""), law.factor_interval.first, law.factor_interval.second, law);
    for (std::size_t k = 0; k < fit.factors.size(); ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      row(name, fit.factors[k].name, law.exponents[i], law.errors[i], law.lower[i], law.upper[i], law);
    }
  };
  rows("fitted", r.law);
  for (const auto& [who, law] : r.published) rows(who, law);
}

// Measured over fitted, one symbol per value of the parameter `marks`; the line is the law.
std::string draw_fit(const ExperimentSpec& spec, const FitSpec& fit, const Plan& plan, const FitResult& r,
                     const std::string& folder) {
  std::ostringstream out;
  const int marks = index_of(spec.parameters, fit.marks);
  std::vector<std::string> values = {""};
  if (marks >= 0) {
    values.clear();
    for (const ChoiceSpec& choice : spec.parameters[static_cast<std::size_t>(marks)].choices)
      values.push_back(choice.name);
  }
  std::string curves;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::string data = "$d" + std::to_string(k + 1);
    out << data << " << EOD\n";
    bool any = false;
    for (std::size_t i = 0; i < r.data.runs.size(); ++i) {
      if (marks >= 0 && plan.runs[r.data.runs[i]].values[static_cast<std::size_t>(marks)] != values[k]) continue;
      const auto row = static_cast<Eigen::Index>(i);
      out << number_text(r.law.at(r.data.x.row(row).transpose())) << ' ' << number_text(r.data.y[row]) << '\n';
      any = true;
    }
    out << "EOD\n";
    if (any)
      curves += ", " + data + " using 1:2 with points pt " + std::to_string(2 * k + 5) + " ps 1.3 lc " +
                std::to_string(k + 1) +
                (marks >= 0 ? " title " + gnuplot_text(fit.marks + " " + values[k]) : " notitle");
  }
  // Round numbers between the decades, so that every picture has more than one number on each axis.
  std::string tics;
  const double low = r.data.y.minCoeff(), high = r.data.y.maxCoeff();
  for (int decade = static_cast<int>(std::floor(std::log10(low)));
       decade <= static_cast<int>(std::ceil(std::log10(high))); ++decade)
    for (const int digit : {1, 2, 3, 5})
      tics += (tics.empty() ? "" : ", ") + number_text(digit * std::pow(10.0, decade), kShort);
  const std::string range = "[" + number_text(low / 1.2) + ":" + number_text(high * 1.2) + "]";
  out << "set logscale xy\nset grid\nset size square\nset xtics (" << tics << ")\nset ytics (" << tics
      << ")\nset xrange " << range << "\nset yrange " << range << "\nset title "
      << gnuplot_text(spec.title + where_text(fit)) << " noenhanced\nset xlabel " << gnuplot_text(law_text(fit, r.law))
      << " noenhanced\nset ylabel " << gnuplot_text(fit.figure) << " noenhanced\nset key left top noenhanced\n"
      << "set terminal pngcairo size 760,720 font 'sans,11'\nset output " << gnuplot_text(fit.name + ".png")
      << "\nplot x with lines lc rgb 'gray40' title " << gnuplot_text("the law") << curves
      << "\nset terminal svg size 760,720 font 'sans,11'\nset output " << gnuplot_text(fit.name + ".svg")
      << "\nreplot\n";
  write_whole_file((fs::path(folder) / (fit.name + ".gp")).string(), out.str());
  return fit.name + ".gp";
}

}  // namespace

FitData fit_data(const ExperimentSpec& spec, const FitSpec& fit, const Plan& plan,
                 const std::vector<RunResult>& results) {
  FitData data;
  const auto is_meant = [&](const RunRequest& run) {
    return std::all_of(fit.where.begin(), fit.where.end(), [&](const auto& entry) {
      return run.values[static_cast<std::size_t>(index_of(spec.parameters, entry.first))] == entry.second;
    });
  };
  for (std::size_t i = 0; i < plan.runs.size(); ++i)
    if (results[i].end.done() && is_meant(plan.runs[i])) data.runs.push_back(i);
  data.x =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(data.runs.size()), static_cast<Eigen::Index>(fit.factors.size()));
  data.y.resize(data.x.rows());
  const auto positive = [&](double value, const std::string& what, std::size_t run) {
    if (!(value > 0.0))
      throw InputError(spec.file + ":" + std::to_string(fit.line) + ": fits." + what + ": is " +
                       number_text(value, kShort) + " in the run " + plan.runs[run].name +
                       ", expected more than 0 in a power law");
    return value;
  };
  for (Eigen::Index row = 0; row < data.x.rows(); ++row) {
    const std::size_t run = data.runs[static_cast<std::size_t>(row)];
    const auto value_of = [&](const std::string& name) {
      if (const int figure = index_of(spec.figures, name); figure >= 0)
        return results[run].figures[static_cast<std::size_t>(figure)];
      return *number_in(plan.runs[run].values[static_cast<std::size_t>(index_of(spec.parameters, name))]);
    };
    data.y[row] = positive(value_of(fit.figure), "figure", run);
    for (Eigen::Index k = 0; k < data.x.cols(); ++k) {
      const FitFactor& factor = fit.factors[static_cast<std::size_t>(k)];
      for (const std::string& name : factor.sum) data.x(row, k) += value_of(name);
      positive(data.x(row, k), "factors \"" + factor.name + "\"", run);
    }
  }
  return data;
}

std::vector<std::string> write_fits(const ExperimentSpec& spec, const Plan& plan, const std::vector<RunResult>& results,
                                    const std::string& folder) {
  if (spec.fits.empty()) return {};
  const std::string table = (fs::path(folder) / "fits.csv").string(), page = (fs::path(folder) / "fits.md").string();
  std::vector<FitResult> found;
  for (const FitSpec& fit : spec.fits) {
    FitResult r;
    r.data = fit_data(spec, fit, plan, results);
    try {
      r.law = fit_power_law(r.data.x, r.data.y);
    } catch (const InputError& error) {
      throw InputError(spec.file + ":" + std::to_string(fit.line) + ": fits: " + fit.name + ": " + error.what());
    }
    r.published = published_laws(fit, r.data);
    found.push_back(std::move(r));
  }
  std::ostringstream csv, md;
  csv << "fit,law,exponent_of,value,standard_error,low_95,high_95,runs,degrees_of_freedom,r_squared,scatter\n";
  md << "Made by `./footfall sweep " << spec.file << "`.\n";
  std::vector<std::string> scripts;
  for (std::size_t f = 0; f < spec.fits.size(); ++f) {
    const FitSpec& fit = spec.fits[f];
    const FitResult& r = found[f];
    std::printf("%s   (%zu runs%s)\n", law_text(fit, r.law).c_str(), r.data.runs.size(), where_text(fit).c_str());
    for (std::size_t k = 0; k < fit.factors.size(); ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      std::printf("  exponent of %-16s %.3f +- %.3f, 95 %% in %.3f to %.3f", fit.factors[k].name.c_str(),
                  r.law.exponents[i], r.law.errors[i], r.law.lower[i], r.law.upper[i]);
      for (const auto& [who, exponent] : fit.factors[k].published) std::printf("; %s %.3g", who.c_str(), exponent);
      std::printf("\n");
    }
    write_rows(csv, fit, r);
    write_page(md, fit, r);
    scripts.push_back(draw_fit(spec, fit, plan, r, folder));
  }
  write_whole_file(table, csv.str());
  write_whole_file(page, md.str());
  std::vector<std::string> files = run_gnuplot(folder, scripts);
  files.insert(files.begin(), {table, page});
  return files;
}

}  // namespace footfall
