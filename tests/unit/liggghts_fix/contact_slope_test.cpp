// Slopes of contacts, projected on a body: liggghts_fix/dem_body.h.

#include <gtest/gtest.h>

#include "coupler/schemes/registry.h"
#include "liggghts_fix/dem_body.h"

namespace footfall {
namespace {

CoupledBody triangle() {
  Eigen::Matrix3Xd rho0(3, 3);
  rho0 << 0, 1, 0, 0, 0, 1, 0, 0, 0;
  BodyMotion initial;
  initial.r = {0.3, -0.2, 0.5};
  return {ModalBoundary("body", rho0, {{0, 1, 2}}), initial};
}

// The window's mean slopes of one contact that lasts all the time.
ContactTangent slopes_of(const CoupledBody& body, const Eigen::Vector3d& point, const ContactSlope& slope) {
  const std::unique_ptr<Scheme> scheme = make_scheme("tangent");
  DemBody dem(body, *scheme);
  dem.begin_window(body.initial, 2, 1e-3);
  for (int i = 0; i < 2; ++i) {
    dem.advance();
    dem.clear_contacts();
    dem.add_slope(point, slope);
    dem.end_substep(1e-3);
  }
  std::vector<double> row;
  dem.append_share(row);
  dem.clear_load();
  dem.add_share(row.data());
  return dem.load().tangent.at(0);
}

TEST(ContactSlope, IsTheDerivativeOfTheWrenchOfASpringAtThePoint) {
  const CoupledBody body = triangle();
  const Eigen::Vector3d point(0.5, 0.1, 0.6);
  ContactSlope slope;
  slope.normal_W = Eigen::Vector3d(1.0, 2.0, 2.0) / 3.0;
  slope.stiffness = 1000.0;
  slope.shear_stiffness = 300.0;
  slope.damping = 5.0;
  slope.shear_damping = 1.0;
  const ContactTangent tangent = slopes_of(body, point, slope);

  const Eigen::Vector3d rho = point - body.initial.r;
  const Eigen::Matrix3d along = slope.normal_W * slope.normal_W.transpose();
  const Eigen::Matrix3d k = 1000.0 * along + 300.0 * (Eigen::Matrix3d::Identity() - along);
  const Eigen::Matrix3d c = 5.0 * along + 1.0 * (Eigen::Matrix3d::Identity() - along);
  for (int j = 0; j < 6; ++j) {
    // A small motion of the body moves the point by dr + dtheta x rho; the springs answer there.
    const Eigen::Matrix<double, 6, 1> unit = Eigen::Matrix<double, 6, 1>::Unit(j);
    const Eigen::Vector3d moved = unit.head<3>() + unit.tail<3>().cross(rho);
    Eigen::Matrix<double, 6, 1> by_k, by_c;
    by_k << k * moved, rho.cross(k * moved);
    by_c << c * moved, rho.cross(c * moved);
    EXPECT_LT((tangent.K.col(j) - by_k).norm(), 1e-10 * tangent.K.norm());
    EXPECT_LT((tangent.C.col(j) - by_c).norm(), 1e-10 * tangent.C.norm());
  }
}

TEST(ContactSlope, IsNotCollectedForSchemesThatDoNotAsk) {
  const CoupledBody body = triangle();
  const std::unique_ptr<Scheme> scheme = make_scheme("css-trapezoid");
  const DemBody dem(body, *scheme);
  EXPECT_FALSE(dem.samples_slopes());
  EXPECT_TRUE(dem.load().tangent.empty());
  EXPECT_EQ(dem.share_size(), 16U);  // F, T, impulse: 3 each; two works, two contacts, stiffness, overlap, patch
}

}  // namespace
}  // namespace footfall
