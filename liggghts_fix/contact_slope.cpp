#include "liggghts_fix/contact_slope.h"

#include <tuple>

namespace footfall {

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

}  // namespace footfall
