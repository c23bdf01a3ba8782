// mbd_solver/scene/clump_shape.h: clumps of spheres.
#include "mbd_solver/scene/clump_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"

namespace footfall {
namespace {

constexpr double kRadius = 0.008;  // [m]

// How many spheres of the clump hold this point.
int holds(const Clump& clump, const Eigen::Vector3d& x) {
  int count = 0;
  for (Eigen::Index i = 0; i < clump.centres.cols(); ++i)
    count += (x - clump.centres.col(i)).norm() < clump.radius ? 1 : 0;
  return count;
}

// Two spheres of radius s whose centres are sqrt(3) s apart: 8/3 pi s^3 less pi / 12 (4 s + d) (2 s - d)^2.
TEST(ClumpShape, PairHasTheVolumeOfTwoSpheresLessTheirLens) {
  const Clump pair = clump_of(ClumpShape::kPair, kRadius);
  const double s = pair.radius, d = std::sqrt(3.0) * s;
  EXPECT_NEAR(pair.volume, 8.0 / 3.0 * kPi * s * s * s - kPi / 12.0 * (4.0 * s + d) * std::pow(2.0 * s - d, 2),
              1e-14 * pair.volume);
}

// On a grid of midpoints: volume, mass centre and inertia of what any sphere holds. The grid has an error of its own, of some
// 1e-3 at this width.
TEST(ClumpShape, VolumeCentreAndInertiaAreThoseOfTheUnion) {
  for (const ClumpShape shape : every<ClumpShape>()) {
    SCOPED_TRACE(std::string(name_of(shape)));
    const Clump clump = clump_of(shape, kRadius);
    EXPECT_NEAR(clump.volume, 4.0 / 3.0 * kPi * std::pow(kRadius, 3), 1e-14 * clump.volume);
    EXPECT_LT(clump.centres.rowwise().mean().norm(), 1e-15 * kRadius + 1e-17);
    const Eigen::Vector3d reach = (clump.centres.cwiseAbs().rowwise().maxCoeff().array() + clump.radius).matrix();
    constexpr int n = 72;
    const Eigen::Vector3d width = 2.0 * reach / n;
    const double cell = width.prod();
    double volume = 0.0;
    int most = 0;
    Eigen::Vector3d first = Eigen::Vector3d::Zero();
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
    for (int k = 0; k < n * n * n; ++k) {
      const Eigen::Vector3d at(k % n + 0.5, k / n % n + 0.5, k / n / n + 0.5);
      const Eigen::Vector3d x = at.cwiseProduct(width) - reach;
      const int count = holds(clump, x);
      most = std::max(most, count);
      if (count == 0) continue;
      volume += cell, first += cell * x, second += cell * x * x.transpose();
    }
    EXPECT_LE(most, 2) << "three spheres share a point: the closed form does not hold";
    EXPECT_NEAR(volume, clump.volume, 3e-3 * clump.volume);
    EXPECT_LT((first / volume).norm(), 3e-3 * kRadius);
    const Eigen::Matrix3d inertia = second.trace() * Eigen::Matrix3d::Identity() - second;
    EXPECT_LT((inertia - clump.inertia).norm(), 5e-3 * clump.inertia.norm());
  }
}

// The files by which inputs/regolith/in.bed makes clumps, for a radius of 1.
TEST(ClumpShape, ScriptOfTheLandingHasTheSameNumbers) {
  for (const ClumpShape shape : every<ClumpShape>()) {
    const std::string file = FOOTFALL_SOURCE_DIR "/inputs/regolith/clumps/" + std::string(name_of(shape));
    SCOPED_TRACE(file);
    const Clump clump = clump_of(shape, 1.0);
    std::ifstream places(file + ".txt"), script(file + ".lammps");
    for (Eigen::Index i = 0; i < clump.centres.cols(); ++i) {
      Eigen::Vector4d sphere;
      for (double& number : sphere) ASSERT_TRUE(places >> number);
      EXPECT_LT((sphere.head<3>() - clump.centres.col(i)).norm(), 1e-14);
      EXPECT_NEAR(sphere[3], clump.radius, 1e-14);
    }
    std::map<std::string, double> variables;
    for (std::string line, word, name; std::getline(script, line);) {
      std::istringstream words(line);
      if (words >> word >> name && word == "variable") words >> word >> variables[name];
    }
    EXPECT_EQ(variables["spheres"], static_cast<double>(clump.centres.cols()));
    EXPECT_LT((clump.inertia - Eigen::Vector3d(variables["inertia_x"], variables["inertia_y"], variables["inertia_z"])
                                   .asDiagonal()
                                   .toDenseMatrix())
                  .norm(),
              1e-13);
  }
}

TEST(ClumpShape, HasTwoToSixSpheresAndItsName) {
  std::vector<Eigen::Index> spheres;
  for (const ClumpShape shape : every<ClumpShape>()) {
    spheres.push_back(clump_of(shape, kRadius).centres.cols());
    EXPECT_EQ(clump_shape(std::string(name_of(shape))), shape);
  }
  EXPECT_EQ(spheres, (std::vector<Eigen::Index>{2, 3, 3, 4, 5, 6}));
  EXPECT_THROW(clump_shape("tetraedron"), InputError);
}

}  // namespace
}  // namespace footfall
