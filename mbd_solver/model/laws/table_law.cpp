// The column of rate 0 is split off as the elastic part with its integral; the rest is interpolated bilinearly.

#include "mbd_solver/model/laws/table_law.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/model/codes.h"

namespace footfall {
namespace {

// The cell of a value among rising nodes and its relative place there; t < 0 or t > 1 outside.
struct TableCell {
  Eigen::Index cell;
  double t, width;
};
TableCell locate(const std::vector<double>& nodes, double value) {
  const auto above = std::upper_bound(nodes.begin(), nodes.end(), value) - nodes.begin();
  const Eigen::Index cell = std::clamp<Eigen::Index>(above - 1, 0, static_cast<Eigen::Index>(nodes.size()) - 2);
  const std::size_t i = cell;
  const double width = nodes[i + 1] - nodes[i];
  return {cell, (value - nodes[i]) / width, width};
}

void check_rising(const TableLawParameters& p, const std::vector<double>& values, const char* what, const char* unit) {
  if (values.size() < 2)
    throw InputError(code::kTableShape,
                     p.source + ": " + std::to_string(values.size()) + " " + what + "(s); expected at least two.");
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i]))
      throw InputError(code::kTableShape,
                       p.source + ": " + what + " " + std::to_string(i + 1) + " is not a finite number.");
    if (i > 0 && values[i] <= values[i - 1])
      throw InputError(code::kCurveNotRising,
                       p.source + ": " + what + " " + number_text(values[i]) + " " + unit + " follows " +
                           number_text(values[i - 1]) + " " + unit +
                           "; expected strictly rising values. Sort the table and remove duplicates.");
  }
}

}  // namespace

struct TableLaw::Split {
  double elastic, elastic_slope;           // E [N], dE/dx [N/m]
  double dissipative, d_dstroke, d_drate;  // D [N], its slopes [N/m], [N s/m]
};

TableLaw::TableLaw(const TableLawParameters& p) : stroke_(p.stroke), rate_(p.rate) {
  check_rising(p, stroke_, "stroke", "m");
  check_rising(p, rate_, "rate", "m/s");
  const auto rows = static_cast<Eigen::Index>(stroke_.size()), columns = static_cast<Eigen::Index>(rate_.size());
  if (p.force.rows() != rows || p.force.cols() != columns)
    throw InputError(code::kTableShape, p.source + ": the forces are a table of " + std::to_string(p.force.rows()) +
                                            " x " + std::to_string(p.force.cols()) + "; expected strokes x rates, " +
                                            std::to_string(rows) + " x " + std::to_string(columns) + ".");
  const auto zero = std::find(rate_.begin(), rate_.end(), 0.0);
  if (zero == rate_.end())
    throw InputError(code::kTableShape,
                     p.source + ": 0 m/s is not among the rates; add this column, which holds the elastic forces.");
  elastic_ = p.force.col(zero - rate_.begin());
  dissipative_ = p.force.colwise() - elastic_;
  for (Eigen::Index i = 0; i < rows; ++i)
    for (Eigen::Index j = 0; j < columns; ++j) {
      const auto row = static_cast<std::size_t>(i), column = static_cast<std::size_t>(j);
      const std::string where = row < p.lines.size() ? p.source + ":" + std::to_string(p.lines[row]) : p.source;
      const std::string entry = where + ": force " + number_text(p.force(i, j)) + " N at stroke " +
                                number_text(stroke_[row]) + " m, rate " + number_text(rate_[column]) + " m/s";
      if (!std::isfinite(p.force(i, j))) throw InputError(code::kTableShape, entry + " is not a finite number.");
      if (dissipative_(i, j) * rate_[column] < 0.0)
        throw InputError(code::kTableNotPassive,
                         entry + (rate_[column] > 0.0 ? " is below" : " is above") + " the force at rest, " +
                             number_text(elastic_[i]) +
                             " N: the strut would deliver energy. Expected a passive table: forces " +
                             (rate_[column] > 0.0 ? "not below it for compression." : "not above it for extension."));
    }
  stored_.assign(stroke_.size(), 0.0);
  for (std::size_t i = 1; i < stroke_.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    stored_[i] = stored_[i - 1] + 0.5 * (elastic_[k - 1] + elastic_[k]) * (stroke_[i] - stroke_[i - 1]);
  }
  stored_at_zero_ = elastic_integral(0.0);
}

TableLaw::Split TableLaw::split(double stroke, double rate) const {
  const TableCell x = locate(stroke_, stroke), v = locate(rate_, rate);
  const Eigen::Index i = x.cell, j = v.cell;
  Split s{};
  s.elastic_slope = (elastic_[i + 1] - elastic_[i]) / x.width;
  s.elastic = elastic_[i] + x.t * (elastic_[i + 1] - elastic_[i]);
  // Outside the table D is taken from its nearest point, without slope across the edge.
  const double tx = std::clamp(x.t, 0.0, 1.0), tv = std::clamp(v.t, 0.0, 1.0);
  const double low = (1.0 - tx) * dissipative_(i, j) + tx * dissipative_(i + 1, j);
  const double high = (1.0 - tx) * dissipative_(i, j + 1) + tx * dissipative_(i + 1, j + 1);
  s.dissipative = (1.0 - tv) * low + tv * high;
  const double across = (1.0 - tv) * (dissipative_(i + 1, j) - dissipative_(i, j)) +
                        tv * (dissipative_(i + 1, j + 1) - dissipative_(i, j + 1));
  s.d_dstroke = x.t < 0.0 || x.t >= 1.0 ? 0.0 : across / x.width;
  s.d_drate = v.t < 0.0 || v.t >= 1.0 ? 0.0 : (high - low) / v.width;
  return s;
}

double TableLaw::elastic_integral(double stroke) const {
  const TableCell x = locate(stroke_, stroke);
  const double slope = (elastic_[x.cell + 1] - elastic_[x.cell]) / x.width, past = x.t * x.width;
  return stored_[x.cell] + (elastic_[x.cell] + 0.5 * slope * past) * past;
}

void TableLaw::evaluate(const StrutInput& in, StrutOutput& out) const {
  out.set_zero();
  const Split s = split(in.stroke, in.rate);
  out.force = s.elastic + s.dissipative;
  out.dforce_dstroke = s.elastic_slope + s.d_dstroke;
  out.dforce_drate = s.d_drate;
}

double TableLaw::stored_energy(const StrutInput& in) const { return elastic_integral(in.stroke) - stored_at_zero_; }

void TableLaw::dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const {
  out.push_back({Dissipation::kDamper, split(in.stroke, in.rate).dissipative * in.rate});
}

}  // namespace footfall
