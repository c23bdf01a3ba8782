// RFT, the theory of resistive forces. The stress on a plate that is drawn slowly through a bed is proportional to its
// depth,
//
//   sigma_x,z = alpha_x,z(beta, gamma) |z|
//   alpha_z = zeta sum_m,n [ A_mn cos 2 pi (m beta / pi + n gamma / (2 pi)) + B_mn sin 2 pi (m beta / pi + n gamma / (2 pi)) ]
//   alpha_x = zeta sum_m,n [ C_mn cos(...) + D_mn sin(...) ]           m = -1, 0, 1, n = 0, 1
//
// with the nine coefficients of generic media in N/cm^3 and one scalar zeta for the medium: Li, Zhang and Goldman, Science
// 339, 1408 (2013). beta is the angle of the plate to the horizontal, gamma that of its motion below the horizontal, both
// in [-pi/2, pi/2]; a plate of positive beta leans against a motion to the side that alpha_x counts.
//
// Of a run: alpha is the slope of F / A over the depth of the plate's middle, through zero at the bed's mean surface, from
// one plate width on. zeta is fitted by least squares to all alpha_x and alpha_z of a sample; R^2 is
// 1 - sum (measured - zeta theory)^2 / sum (measured - mean)^2.
//
// 3D-RFT has xi = rho_c g (894 mu^3 - 386 mu^2 + 89 mu), Agarwal, Goldman and Kamrin, PNAS 120 (2023);
// the mu at which it is the fitted scalar is told.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "mbd_solver/cli/rigs/rft.h"
#include "mbd_solver/cli/rigs/rig_curves.h"

namespace footfall {

namespace {

constexpr double kPerCubicMetre = 1e6;  // N/cm^3 -> N/m^3
constexpr double kMeasuredFrom = 1.0;   // plate widths of depth

const BodySpec& drawn_plate_of(const Scene& scene) {
  const BodySpec& plate = body_of(scene, "plate");
  if (!plate.shape || plate.shape->kind != ShapeKind::kBox)
    throw InputError(scene.file + ": body \"plate\": the rig expects a box");
  return plate;
}

}  // namespace

RftAlpha rft_alpha(double beta, double gamma) {
  constexpr double A00 = 0.206, A10 = 0.169, B11 = 0.212, B01 = 0.358, Bm11 = 0.055;
  constexpr double C11 = -0.124, C01 = 0.253, Cm11 = 0.007, D10 = 0.088;
  const auto angle = [&](int m, int n) { return 2.0 * m * beta + n * gamma; };
  return {A00 + A10 * std::cos(angle(1, 0)) + B11 * std::sin(angle(1, 1)) + B01 * std::sin(angle(0, 1)) +
              Bm11 * std::sin(angle(-1, 1)),
          C11 * std::cos(angle(1, 1)) + C01 * std::cos(angle(0, 1)) + Cm11 * std::cos(angle(-1, 1)) +
              D10 * std::sin(angle(1, 0))};
}

void demand_rft(const Scene& scene) { drawn_plate_of(scene); }

RigSample evaluate_rft(const std::vector<RigRun>& runs) {
  RigSample sample;
  RigCurve z_curve{"alpha_z", {}, {}}, x_curve{"alpha_x", {}, {}};
  std::vector<double> theory, measured;
  for (const RigRun& run : runs) {
    const BodySpec& plate = drawn_plate_of(run.scene);
    const Eigen::Vector3d size = plate.shape->size;
    const History history = history_of(run);
    const std::vector<double>&x = history.column("plate.x"), &z = history.column("plate.z");
    const std::vector<double>&fx = history.column("plate.contact.fx"), &fz = history.column("plate.contact.fz");
    const double gamma = std::atan2(-(z.back() - z.front()), x.back() - x.front());
    // The plate's plane from its attitude: its body x axis, in W, at the drawing.
    const Eigen::Vector3d along = plate.orientation * Eigen::Vector3d::UnitX();
    double beta = std::atan2(along.z(), along.x());
    if (beta > 0.5 * kPi + 1e-9) beta -= kPi;
    if (beta < -0.5 * kPi - 1e-9) beta += kPi;
    double sum_zz = 0.0, sum_x = 0.0, sum_z = 0.0;
    const double area = size.x() * size.y();
    for (std::size_t i = 0; i < z.size(); ++i) {
      const double depth = mean_surface(run) - z[i];
      if (depth < kMeasuredFrom * size.x()) continue;
      sum_zz += depth * depth;
      sum_x -= depth * fx[i] / area;  // against the motion
      sum_z += depth * fz[i] / area;
    }
    if (!(sum_zz > 0.0)) throw InputError(run.folder + ": the plate does not go a plate width deep");
    const RftAlpha alpha = rft_alpha(beta, gamma);
    for (const auto& [mine, theirs, curve] :
         {std::tuple{sum_z / sum_zz, alpha.z, &z_curve}, {sum_x / sum_zz, alpha.x, &x_curve}}) {
      measured.push_back(mine), theory.push_back(theirs * kPerCubicMetre);
      curve->x.push_back(theirs), curve->y.push_back(mine);
    }
  }
  const Eigen::Map<const Eigen::VectorXd> t(theory.data(), static_cast<Eigen::Index>(theory.size()));
  const Eigen::Map<const Eigen::VectorXd> m(measured.data(), t.size());
  const double zeta = t.dot(m) / t.squaredNorm();
  const double r2 = 1.0 - (m - zeta * t).squaredNorm() / (m.array() - m.mean()).square().sum();
  const BoxSpec& box = *runs.front().scene.particles->box;
  const double rho = box.material.density * (box.packing == Packing::kDense ? 0.61 : 0.55);
  sample.answers = {
      {"scalar zeta", "", zeta},
      {"R^2", "", r2},
      {"alpha_z of a flat plate, beta = 0, gamma = 90 deg", "N/m^3",
       zeta * kPerCubicMetre * rft_alpha(0.0, 0.5 * kPi).z},
      {"mu at which 3D-RFT's xi is as large", "",
       friction_of_xi(zeta * kPerCubicMetre * rft_alpha(0.0, 0.5 * kPi).z, rho * gravity_of(runs.front()))}};
  sample.curves = {z_curve, x_curve};
  return sample;
}

double friction_of_xi(double xi, double weight) {
  const auto at = [&](double mu) { return weight * ((894.0 * mu - 386.0) * mu + 89.0) * mu; };
  double low = 0.0, high = 2.0;
  if (!(xi > 0.0) || at(high) < xi) return std::nan("");
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (at(middle) < xi ? low : high) = middle;
  }
  return high;
}

}  // namespace footfall
