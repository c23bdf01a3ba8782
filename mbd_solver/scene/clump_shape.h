#pragma once
// Grains with corners: clumps of equal spheres that LIGGGHTS moves as one rigid body (fix multisphere).
//
// The spheres of a clump are sqrt(3) radii apart. That is as near as three spheres can be without sharing a point, so
// volume and moments of their union are those of the spheres less those of the lenses in which two overlap, in closed
// form:
//   V = n 4/3 pi s^3 - m V_lens        S = sum of int x x^T dV over spheres - the same over lenses        I / density = tr(S) 1 - S
// What overlaps counts once. The centre of mass is the mean of the centres, because each shape is symmetric.

#include <Eigen/Dense>
#include <string>
#include <string_view>
#include <vector>

#include "mbd_solver/base/kinds.h"

namespace footfall {

// 2 spheres; 3 in a line; 3; 4; 5: two tetrahedra on one triangle; 6.
enum class ClumpShape { kPair, kRod, kTriangle, kTetrahedron, kBipyramid, kOctahedron };
constexpr std::string_view name_of(ClumpShape kind) {
  return name_in(kind, "pair", "rod", "triangle", "tetrahedron", "bipyramid", "octahedron");
}

struct Clump {
  Eigen::Matrix3Xd centres;  // of the spheres, from the centre of mass [m]
  double radius = 0.0;       // of each sphere [m]
  double volume = 0.0;       // of their union [m3]
  Eigen::Matrix3d inertia;   // about the centre of mass, over the density [m5]
};

// The clump whose volume is that of a sphere of this radius [m] > 0.
Clump clump_of(ClumpShape shape, double equal_radius);

// The shape of this name; throws InputError with what is known.
ClumpShape clump_shape(const std::string& name);

}  // namespace footfall
