// Each cartridge is an elastic one-sided spring in series with a rate-independent crush c. The crush rate is smoothed
// just below the crush force, so that force and rates have derivatives.

#include "mbd_solver/model/laws/honeycomb.h"

#include <algorithm>
#include <numeric>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/parameter_check.h"
#include "mbd_solver/model/codes.h"

namespace footfall {
namespace {

constexpr double kOnset = 0.95;  // crushing starts at this fraction of the crush force

// S(r): 0 up to the onset, 1 at r = 1, C1. It rises beyond 1, so that the force returns to P from both sides.
double crushing(double r) {
  const double s = (r - kOnset) / (1.0 - kOnset);
  return s <= 0.0 ? 0.0 : (s < 1.0 ? s * s : 2.0 * s - 1.0);
}
double crushing_slope(double r) {
  const double s = (r - kOnset) / (1.0 - kOnset);
  return (s <= 0.0 ? 0.0 : (s < 1.0 ? 2.0 * s : 2.0)) / (1.0 - kOnset);
}

void check(const HoneycombCartridge& data, const std::string& which) {
  const std::string who = "honeycomb: " + which;
  if (data.stages.empty())
    throw InputError(
        code::kTableShape,
        who +
            ": no stages; expected at least one stage of crush force and crush length. Leave the cartridge out "
            "if the strut does not crush in this direction.");
  double shortest = data.stages.front().crush_length, last = 0.0;
  for (std::size_t i = 0; i < data.stages.size(); ++i) {
    const std::string stage = "stage " + std::to_string(i + 1) + " ";
    require_positive(who, stage + "crush_force", data.stages[i].crush_force, "N");
    require_positive(who, stage + "crush_length", data.stages[i].crush_length, "m");
    if (data.stages[i].crush_force < last)
      throw InputError(code::kCurveNotRising,
                       who + ": " + stage + "crush_force " + number_text(data.stages[i].crush_force) +
                           " N is below the force of the previous stage, " + number_text(last) +
                           " N; expected rising forces. The softest stage crushes first: list it first.");
    last = data.stages[i].crush_force;
    shortest = std::min(shortest, data.stages[i].crush_length);
  }
  require_positive(who, "elastic_stiffness", data.elastic_stiffness, "N/m");
  require_positive(who, "bottom_out_stiffness", data.bottom_out_stiffness, "N/m");
  require_positive(who, "transition_length", data.transition_length, "m");
  require_positive(who, "toe", data.toe, "m");
  if (data.bottom_out_stiffness >= data.elastic_stiffness)
    throw InputError(code::kParametersDisagree,
                     who + ": bottom_out_stiffness " + number_text(data.bottom_out_stiffness) +
                         " N/m is not below elastic_stiffness " + number_text(data.elastic_stiffness) +
                         " N/m; expected less, because the elastic spring is in series with it.");
  if (data.transition_length > shortest)
    throw InputError(code::kParametersDisagree, who + ": transition_length " + number_text(data.transition_length) +
                                                    " m is longer than the shortest stage, " + number_text(shortest) +
                                                    " m; expected at most that.");
}

}  // namespace

Honeycomb::Honeycomb(const HoneycombParameters& parameters) {
  const auto add = [&](const HoneycombCartridge& data, double sign) {
    check(data, sign > 0.0 ? "compression" : "tension");
    const double length = std::accumulate(data.stages.begin(), data.stages.end(), 0.0,
                                          [](double sum, const HoneycombStage& s) { return sum + s.crush_length; });
    // In series with the elastic spring k_e, a plastic slope h over the crush gives the slope k_e h / (k_e +
    // h) over the stroke.
    const double k_e = data.elastic_stiffness, k_b = data.bottom_out_stiffness;
    cartridges_.push_back({data, OneSidedSpring{k_e, data.toe}, sign, length, k_b * k_e / (k_e - k_b)});
  };
  if (parameters.compression) add(*parameters.compression, 1.0);
  if (parameters.tension) add(*parameters.tension, -1.0);
  if (cartridges_.empty())
    throw InputError(code::kParametersDisagree,
                     "honeycomb: neither a compression nor a tension cartridge is given; expected at least one.");
}

double Honeycomb::Cartridge::crush_force(double c, double& slope) const {
  const double w = data.transition_length;
  double force = data.stages.front().crush_force, end = 0.0;
  slope = 0.0;
  for (std::size_t i = 0; i + 1 < data.stages.size(); ++i) {
    end += data.stages[i].crush_length;
    const double step = data.stages[i + 1].crush_force - data.stages[i].crush_force;
    const double t = std::clamp((c - end) / w + 0.5, 0.0, 1.0);
    force += step * t * t * (3.0 - 2.0 * t);
    slope += step * 6.0 * t * (1.0 - t) / w;
  }
  const OneSidedSpring bottom{plastic_slope, w};
  slope += bottom.slope(c - total_length);
  return force + bottom.force(c - total_length);
}

struct Honeycomb::Flow {
  double f, df_dd;           // force magnitude [N], slope over the penetration d = x+ - c [N/m]
  double dc;                 // crush rate [m/s]
  double ddc_dd, ddc_drate;  // over d and over the closing rate
  double ddc_dc;             // over c at constant d
};

Honeycomb::Flow Honeycomb::flow(const Cartridge& cartridge, double stroke, double rate, double c) {
  const double d = cartridge.sign * stroke - c, closing = cartridge.sign * rate;
  Flow out{cartridge.spring.force(d), cartridge.spring.slope(d), 0.0, 0.0, 0.0, 0.0};
  if (out.f <= 0.0 || closing < 0.0) return out;
  double p_slope = 0.0;
  const double p = cartridge.crush_force(c, p_slope);
  const double r = out.f / p, s = crushing(r), ds = crushing_slope(r);
  out.dc = closing * s;
  out.ddc_drate = s;
  out.ddc_dd = closing * ds * out.df_dd / p;
  out.ddc_dc = -closing * ds * r * p_slope / p;
  return out;
}

void Honeycomb::evaluate(const StrutInput& in, StrutOutput& out) const {
  out.set_zero();
  for (int i = 0; i < state_count(); ++i) {
    const Cartridge& cartridge = cartridges_[i];
    const Flow q = flow(cartridge, in.stroke, in.rate, in.z[i]);
    out.force += cartridge.sign * q.f;
    out.dforce_dstroke += q.df_dd;
    out.dforce_dz[i] = -cartridge.sign * q.df_dd;
    out.dz[i] = q.dc;
    out.ddz_dstroke[i] = cartridge.sign * q.ddc_dd;
    out.ddz_drate[i] = cartridge.sign * q.ddc_drate;
    out.ddz_dz(i, i) = q.ddc_dc - q.ddc_dd;
  }
}

double Honeycomb::stored_energy(const StrutInput& in) const {
  double energy = 0.0;
  for (int i = 0; i < state_count(); ++i) {
    const Cartridge& cartridge = cartridges_[i];
    energy += cartridge.spring.energy(cartridge.sign * in.stroke - in.z[i]);
  }
  return energy;
}

void Honeycomb::dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const {
  double power = 0.0;
  for (int i = 0; i < state_count(); ++i) {
    const Flow q = flow(cartridges_[i], in.stroke, in.rate, in.z[i]);
    power += q.f * q.dc;
  }
  out.push_back({Dissipation::kHoneycomb, power});
}

std::vector<Honeycomb::Report> Honeycomb::report(const Eigen::Ref<const Eigen::VectorXd>& z) const {
  std::vector<Report> reports;
  for (int i = 0; i < state_count(); ++i) {
    const Cartridge& cartridge = cartridges_[i];
    Report report{cartridge.sign < 0.0, {}, std::max(0.0, z[i] - cartridge.total_length)};
    double left = z[i];
    for (const HoneycombStage& stage : cartridge.data.stages) {
      report.stage_crush.push_back(std::clamp(left, 0.0, stage.crush_length));
      left -= stage.crush_length;
    }
    reports.push_back(std::move(report));
  }
  return reports;
}

}  // namespace footfall
