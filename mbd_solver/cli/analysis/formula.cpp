#include "mbd_solver/cli/analysis/formula.h"

#include <cmath>

#include "coupler/base/quote.h"
#include "coupler/base/text.h"

namespace footfall {

std::string Formula::gnuplot() const {
  std::string sum = constant != 0.0 ? number_text(constant, 12) : "";
  for (const auto& [c, name] : columns) {
    const std::string term = "column(" + gnuplot_text(name) + ")" + (is_norm ? "**2" : "");
    sum += c < 0.0 ? "-" : sum.empty() ? "" : "+";
    sum += std::abs(c) == 1.0 ? term : number_text(std::abs(c), 12) + "*" + term;
  }
  const std::string whole = is_norm ? "sqrt(" + sum + ")" : "(" + sum + ")";
  return factor == 1.0 ? "(" + whole + ")" : "(" + number_text(factor, 12) + "*" + whole + ")";
}

std::vector<double> Formula::values(const History& history) const {
  std::vector<double> values(history.columns.empty() ? 0 : history.columns.front().size(), is_norm ? 0.0 : constant);
  for (const auto& [c, name] : columns) {
    const std::vector<double>& column = history.column(name);
    for (std::size_t k = 0; k < values.size(); ++k) values[k] += is_norm ? column[k] * column[k] : c * column[k];
  }
  for (double& value : values) value = factor * (is_norm ? std::sqrt(value) : value);
  return values;
}

}  // namespace footfall
