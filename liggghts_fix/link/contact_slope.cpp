// Slopes of Hertz-Mindlin and linear contacts, and their projection on a body as rank-one updates.

#include "liggghts_fix/link/contact_slope.h"

#include <cmath>
#include <tuple>

namespace footfall {
namespace {

constexpr double kSliding = 1.0 - 1e-6;  // share of the Coulomb limit from which a contact slides

double compliance(const ElasticConstants& m) { return (1.0 - m.poisson * m.poisson) / m.young; }

double shear_compliance(const ElasticConstants& m) { return 2.0 * (2.0 - m.poisson) * (1.0 + m.poisson) / m.young; }

}  // namespace

// The point moves by J [dr; dtheta], and its force -k J [dr; dtheta] acts on the body by J^T:
//   J = [1, -rho~],   k = k_t 1 + (k_n - k_t) n n^T
//   J^T k J = (k_n - k_t) u u^T + k_t J^T J,   u = J^T n = [n; rho x n].
// A rank-one update, and nothing more while the contact slides.
void add_slope(const ContactSlope& slope, const Eigen::Vector3d& rho, ContactTangent& tangent) {
  Eigen::Matrix<double, 6, 1> u;
  u << slope.normal_W, rho.cross(slope.normal_W);
  const auto add = [&](double k_n, double k_t, Eigen::Matrix<double, 6, 6>& sum) {
    if (k_n == 0.0) return;  // elastic: no damping
    const Eigen::Matrix<double, 6, 1> scaled = (k_n - k_t) * u;
    for (int column = 0; column < 6; ++column) sum.col(column) += u[column] * scaled;
    if (k_t == 0.0) return;
    const Eigen::Vector3d t = k_t * rho;
    sum.diagonal().head<3>().array() += k_t;
    sum.bottomRightCorner<3, 3>() -= t * rho.transpose();
    sum.diagonal().tail<3>().array() += t.dot(rho);
    for (const auto& [row, column, value] :
         {std::tuple(4, 2, -t.x()), std::tuple(5, 1, t.x()), std::tuple(3, 2, t.y()), std::tuple(5, 0, -t.y()),
          std::tuple(3, 1, -t.z()), std::tuple(4, 0, t.z())}) {
      sum(row, column) += value;
      sum(column, row) += value;
    }
  };
  add(slope.stiffness, slope.shear_stiffness, tangent.K);
  add(slope.damping, slope.shear_damping, tangent.C);
}

WallContact hertz_mindlin(const ElasticConstants& grain, const ElasticConstants& wall) {
  WallContact contact;
  contact.young = 1.0 / (compliance(grain) + compliance(wall));
  contact.shear = 1.0 / (shear_compliance(grain) + shear_compliance(wall));
  return contact;
}

double damping_of_restitution(double e) {
  const double log_e = std::log(e);
  return -2.0 * std::sqrt(5.0 / 6.0) * log_e / std::sqrt(log_e * log_e + M_PI * M_PI);
}

ContactSlope WallContact::slope(const Eigen::Vector3d& normal_W, const Eigen::Vector3d& f_W, double s,
                                double mass) const {
  ContactSlope slope;
  slope.normal_W = normal_W;
  slope.stiffness = stiffness(s);
  const bool is_linear = linear > 0.0;
  slope.damping = is_linear ? linear_damping * mass : damping * std::sqrt(slope.stiffness * mass);
  const double pressure = f_W.dot(normal_W);
  const double across = (f_W - pressure * normal_W).norm();
  if (across < kSliding * friction * std::abs(pressure)) {
    slope.shear_stiffness = is_linear ? linear_shear : 8.0 * shear * s;
    slope.shear_damping = is_linear ? linear_shear_damping * mass : damping * std::sqrt(slope.shear_stiffness * mass);
  }
  return slope;
}

}  // namespace footfall
