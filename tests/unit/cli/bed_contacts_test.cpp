// mbd_solver/cli/launch/bed_contacts.h: contacts of grains against those of regular packings.
#include "mbd_solver/cli/launch/bed_contacts.h"

#include <gtest/gtest.h>

#include <cmath>

namespace footfall {
namespace {

// n^3 grains of radius r at the corners of cubes, or in the densest layers of triangles, `gap` apart from touching.
std::vector<GrainPlace> packing(int n, double r, bool dense, double gap) {
  std::vector<GrainPlace> grains;
  const double a = 2.0 * r + gap;
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        Eigen::Vector3d x(i, j, k);
        if (dense)  // layers of triangles, each in the hollows of the one below
          x = Eigen::Vector3d(i + 0.5 * ((j + k) % 2), std::sqrt(3.0) * (0.5 * j + (k % 2) / 6.0),
                              std::sqrt(6.0) / 3.0 * k);
        grains.push_back({a * x, r});
      }
  return grains;
}

TEST(BedContacts, AreThoseOfRegularPackings) {
  const double r = 0.01;
  const BedContacts cubes = bed_contacts(packing(9, r, false, -0.02 * r)),
                    dense = bed_contacts(packing(9, r, true, -0.04 * r)),
                    loose = bed_contacts(packing(9, r, false, 1e-9));
  EXPECT_DOUBLE_EQ(cubes.coordination, 6.0);
  EXPECT_NEAR(cubes.largest_overlap, 0.02, 1e-12);
  EXPECT_DOUBLE_EQ(dense.coordination, 12.0);
  EXPECT_NEAR(dense.largest_overlap, 0.04, 1e-12);
  EXPECT_EQ(loose.coordination, 0.0);
  EXPECT_EQ(loose.largest_overlap, 0.0);
}

TEST(BedContacts, SmallGrainsCountByTheirOwnRadius) {
  const BedContacts two = bed_contacts({{{0, 0, 0}, 0.02}, {{0.0295, 0, 0}, 0.01}});
  EXPECT_NEAR(two.largest_overlap, 0.05, 1e-12);
  EXPECT_EQ(bed_contacts({}).coordination, 0.0);
}

// Two clumps of two spheres each, one above the other: their spheres overlap within a clump and touch across.
TEST(BedContacts, SpheresOfOneClumpDoNotTouch) {
  const std::vector<GrainPlace> clumps = {
      {{0, 0, 0}, 0.01, 1}, {{0.017, 0, 0}, 0.01, 1}, {{0, 0, 0.0199}, 0.01, 2}, {{0.017, 0, 0.0199}, 0.01, 2}};
  EXPECT_NEAR(bed_contacts(clumps).largest_overlap, 0.01, 1e-12);
  EXPECT_EQ(count_grains(clumps), 2u);
  EXPECT_EQ(count_grains({{{0, 0, 0}, 0.01}, {{0, 0, 1}, 0.01}}), 2u);
}

}  // namespace
}  // namespace footfall
