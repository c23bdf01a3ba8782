#include "mbd_solver/model/signals/lookup_table.h"

#include <algorithm>
#include <string>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"

namespace footfall {
namespace {

struct Place {
  Eigen::Index cell;
  double share;  // of the point behind the cell, in [0, 1]
};

Place place_of(const std::vector<double>& x, double u) {
  const auto next = std::upper_bound(x.begin() + 1, x.end() - 1, u);
  const auto cell = static_cast<std::size_t>(next - x.begin()) - 1;
  return {static_cast<Eigen::Index>(cell), std::clamp((u - x[cell]) / (x[cell + 1] - x[cell]), 0.0, 1.0)};
}

void demand_rising(const std::vector<double>& x) {
  if (x.size() < 2) throw InputError("table: has fewer than two points; expected at least two.");
  for (std::size_t i = 1; i < x.size(); ++i)
    if (!(x[i] > x[i - 1]))
      throw InputError("table: " + number_text(x[i]) + " stands after " + number_text(x[i - 1]) +
                       "; expected inputs that rise.");
}

}  // namespace

LookupTable::LookupTable(std::vector<double> x, std::vector<double> y) : x1_(std::move(x)) {
  demand_rising(x1_);
  FOOTFALL_DEMAND(y.size() == x1_.size());
  y_ = Eigen::Map<const Eigen::VectorXd>(y.data(), static_cast<Eigen::Index>(y.size()));
}

LookupTable::LookupTable(std::vector<double> x1, std::vector<double> x2, Eigen::MatrixXd y)
    : x1_(std::move(x1)), x2_(std::move(x2)), y_(std::move(y)) {
  demand_rising(x1_);
  demand_rising(x2_);
  FOOTFALL_DEMAND(y_.rows() == static_cast<Eigen::Index>(x1_.size()) &&
                  y_.cols() == static_cast<Eigen::Index>(x2_.size()));
}

double LookupTable::value(const BlockValues& u, const BlockValues&) const {
  const Place row = place_of(x1_, u[0]);
  const auto along = [&](Eigen::Index column) {
    return (1.0 - row.share) * y_(row.cell, column) + row.share * y_(row.cell + 1, column);
  };
  if (x2_.empty()) return along(0);
  const Place column = place_of(x2_, u[1]);
  return (1.0 - column.share) * along(column.cell) + column.share * along(column.cell + 1);
}

}  // namespace footfall
