#pragma once
// Sizes of grains: radii, their shares in the mass, and the radii that represent a size distribution.
//
// A continuous distribution is cut into classes. Each becomes one radius, of which as many grains weigh what the class weighs as
// there are grains in the class:
//   d^-3 = int f(x) x^-3 dx / int f(x) dx      f: density of the mass over the diameter x, integrals over the class

#include <vector>

#include "mbd_solver/scene/box_spec.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// Share of the k-th of `count` kinds in the mass; equal without `shares`.
double share_of(const std::vector<double>& shares, std::size_t k, std::size_t count);

// One radius of a distribution [m], and its share in the mass [-]; the shares of all are a whole.
struct GrainClass {
  double radius, share;
};
// Of a distribution without finding, from fine to coarse; classes without mass are left out.
std::vector<GrainClass> classes_of(const SizeDistributionSpec& distribution);

// Of the bed with all its zones [m]: every radius, the smallest and the largest one.
std::vector<double> all_radii(const BoxSpec& box);
double smallest_radius(const BoxSpec& box);
double largest_radius(const BoxSpec& box);

double mean_radius(const GrainSizesSpec& sizes);  // by mass [m]

// Solid fraction of grains of these sizes that are packed as densely as equal ones of the fraction `equal` [-]:
//   equal + 0.0658 d + 0.0857 s d^2     d: standard deviation over mean of the radii, s: their skewness, by number
// [Desmond and Weeks, Phys. Rev. E 90 (2014) 022204], at most 0.75.
double mixed_fraction(const GrainSizesSpec& sizes, double equal);

// Checks the sizes of the bed and of its zones, and sets radius and shares where a distribution is given.
void resolve_grain_sizes(Scene& scene, Findings& findings);

// Zones: place, size, grains; of a box with good sizes.
void check_zones(const Scene& scene, const EntryFindings& at);

constexpr std::size_t kMostSizes = 12;  // of one part of the bed
constexpr std::size_t kMostKinds =
    24;  // of grains of the whole bed: sizes times shapes of clumps, in inputs/box/in.bed

}  // namespace footfall
