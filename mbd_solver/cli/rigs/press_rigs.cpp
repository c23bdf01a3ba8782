// Plate and cone pressed into a bed.
//
//   plate  p(s) = (k_c / b + k_phi) s^n    Bekker, Introduction to Terrain-Vehicle Systems (1969)
//
// p is the mean pressure on the plate, s the sinkage of its lower face below the bed's mean surface, b its shorter side
// (its radius when it is round). n is common to all widths; log p is fitted, at 20 depths from two grain radii on.
//
//   cone   q(s) = F / A = q_0 + G s        A the largest section of the cone, s the depth of its tip
//
// G, the gradient of the cone index, is fitted from where the cone is all in the bed.
#include <algorithm>
#include <cmath>
#include <limits>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "coupler/base/text.h"
#include "mbd_solver/cli/rigs/rig_curves.h"

namespace footfall {

namespace {

constexpr int kBins = 20;
constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
constexpr double kShallow = 2.0;  // grain radii of sinkage that are left out

// Sinkage and pressure of a body whose lowest point is drawn at z = 0 + `below` its column z.
struct Pressed {
  double b = 0.0, area = 0.0;
  Bins bins;
};

// Depth of the lowest point below the mean surface, as the run goes on.
std::vector<double> sinkage_of(const RigRun& run, const History& history, const std::string& body, double lowest) {
  std::vector<double> s = history.column(body + ".z");
  for (double& z : s) z = mean_surface(run) - (z - lowest);
  return s;
}

std::vector<double> divided_by(std::vector<double> values, double divisor) {
  for (double& value : values) value /= divisor;
  return values;
}

// Its width, or its radius, and area; half: of its height [m].
Pressed plate_in(const Scene& scene, double& half) {
  const BodySpec& plate = body_of(scene, "plate");
  Pressed p;
  if (plate.shape && plate.shape->kind == ShapeKind::kBox) {
    p.b = std::min(plate.shape->size.x(), plate.shape->size.y());
    p.area = plate.shape->size.x() * plate.shape->size.y();
    half = 0.5 * plate.shape->size.z();
  } else if (plate.shape && plate.shape->kind == ShapeKind::kCylinder) {
    p.b = plate.shape->radius;
    p.area = kPi * p.b * p.b;
    half = 0.5 * plate.shape->length;
  } else {
    throw InputError(scene.file + ": body \"plate\": the rig knows boxes and upright cylinders");
  }
  return p;
}

Pressed plate_of(const RigRun& run) {
  double half = 0.0;
  Pressed p = plate_in(run.scene, half);
  const History history = history_of(run);
  const std::vector<double> s = sinkage_of(run, history, "plate", half);
  p.bins = binned(s, divided_by(history.column("plate.contact.fz"), p.area), -kShallow * mean_surface(run),
                  *std::max_element(s.begin(), s.end()), kBins);
  return p;
}

}  // namespace

void demand_plate(const Scene& scene) {
  double half = 0.0;
  plate_in(scene, half);
}

RigSample evaluate_plate(const std::vector<RigRun>& runs) {
  RigSample sample;
  std::vector<Pressed> plates;
  Eigen::Index rows = 0;
  for (const RigRun& run : runs) {
    plates.push_back(plate_of(run));
    sample.curves.push_back({run.name, plates.back().bins.x, plates.back().bins.y});
    rows += std::count_if(plates.back().bins.y.begin(), plates.back().bins.y.end(), [](double p) { return p > 0.0; });
  }
  const auto count = static_cast<Eigen::Index>(plates.size());
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(rows, count + 1);
  Eigen::VectorXd log_p(rows);
  Eigen::Index row = 0;
  for (Eigen::Index k = 0; k < count; ++k) {
    const Bins& bins = plates[static_cast<std::size_t>(k)].bins;
    for (std::size_t i = 0; i < bins.x.size(); ++i) {
      if (bins.y[i] <= 0.0) continue;
      A(row, k) = 1.0;
      A(row, count) = std::log(bins.x[i]);
      log_p(row++) = std::log(bins.y[i]);
    }
  }
  const LineFit fit = least_squares(A, log_p);
  // k_b = k_c / b + k_phi over the widths.
  Eigen::MatrixXd B(count, 2);
  Eigen::VectorXd k_b(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    B.row(k) << 1.0 / plates[static_cast<std::size_t>(k)].b, 1.0;
    k_b(k) = std::exp(fit.c(k));
  }
  Eigen::Vector2d k = Eigen::Vector2d::Constant(kNoValue);
  if (count == 2)
    k = Eigen::Vector2d(B.colPivHouseholderQr().solve(k_b));
  else if (const LineFit widths = least_squares(B, k_b); widths.valid)
    k = widths.c;
  sample.answers = {
      {"n", "", fit.c(count)}, {"k_c", "N/m^(n+1)", k(0)}, {"k_phi", "N/m^(n+2)", k(1)}, {"R^2", "", fit.r_squared}};
  for (std::size_t i = 0; i < plates.size(); ++i) {
    const double depth = 0.25 * plates[i].b;
    sample.answers.push_back({"pressure at b / 4, b = " + number_text(plates[i].b) + " m", "Pa",
                              std::exp(fit.c(static_cast<Eigen::Index>(i)) + fit.c(count) * std::log(depth))});
  }
  return sample;
}

void demand_cone(const Scene& scene) { mesh_of(scene, "cone", "cone.stl"); }

RigSample evaluate_cone(const std::vector<RigRun>& runs) {
  RigSample sample;
  for (const RigRun& run : runs) {
    const double diameter = mesh_of(run.scene, "cone", "cone.stl").scale, area = 0.25 * kPi * diameter * diameter;
    const double length = 0.5 * diameter / std::tan(15.0 * kPi / 180.0);  // of the cone itself
    const History history = history_of(run);
    // The column is of the centre of mass: what it has gone down is counted from the drawing, where the tip is at 0.
    const std::vector<double>& z = history.column("cone.z");
    const double clearance = run.scene.initial.clearance.value_or(0.0);
    std::vector<double> s = z;
    for (double& value : s) value = z.front() - value - clearance + mean_surface(run);
    const double deepest = *std::max_element(s.begin(), s.end());
    const Bins bins = binned(s, divided_by(history.column("cone.contact.fz"), area), 0.0, deepest, 2 * kBins);
    sample.curves.push_back({run.name, bins.x, bins.y});
    std::vector<std::size_t> deep;
    for (std::size_t i = 0; i < bins.x.size(); ++i)
      if (bins.x[i] >= length) deep.push_back(i);
    Eigen::MatrixXd A(static_cast<Eigen::Index>(deep.size()), 2);
    Eigen::VectorXd q(static_cast<Eigen::Index>(deep.size()));
    for (std::size_t i = 0; i < deep.size(); ++i) {
      A.row(static_cast<Eigen::Index>(i)) << 1.0, bins.x[deep[i]];
      q(static_cast<Eigen::Index>(i)) = bins.y[deep[i]];
    }
    const LineFit fit = least_squares(A, q);
    const double at = 1.5 * length;
    sample.answers.push_back({"gradient G of the cone index", "Pa/m", fit.c(1)});
    sample.answers.push_back(
        {"cone index at 1.5 lengths of the cone", "Pa", deepest >= at ? fit.c(0) + fit.c(1) * at : kNoValue});
    sample.answers.push_back({"R^2", "", fit.r_squared});
  }
  return sample;
}

}  // namespace footfall
