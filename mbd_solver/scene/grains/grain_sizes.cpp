// Size distributions in classes, in closed form, and measures of sizes.

#include "mbd_solver/scene/grains/grain_sizes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace footfall {

namespace {

// Share of a normal distribution below x.
double below(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

// ln(diameter) about ln(median): the mass has the normal distribution N(m, s), its number of grains, which weighs with
// x^-3, N(m - 3 s^2, s) times exp(-3 m + 4.5 s^2).
std::vector<GrainClass> lognormal_classes(const SizeDistributionSpec& d) {
  constexpr double kTail = 1.6448536269514722;  // of 5 % [standard deviations]
  const double m = std::log(d.median), s = d.deviation;
  const double from = d.finest ? std::log(*d.finest) : m - kTail * s;
  const double to = d.coarsest ? std::log(*d.coarsest) : m + kTail * s;
  std::vector<GrainClass> classes;
  for (int k = 0; k < d.classes; ++k) {
    const double a = from + (to - from) * k / d.classes, b = from + (to - from) * (k + 1) / d.classes;
    const double mass = below((b - m) / s) - below((a - m) / s);
    const double number =
        std::exp(-3.0 * m + 4.5 * s * s) * (below((b - m) / s + 3.0 * s) - below((a - m) / s + 3.0 * s));
    if (mass > 0.0 && number > 0.0) classes.push_back({0.5 * std::cbrt(mass / number), mass});
  }
  return classes;
}

// Between two sieves the mass is spread evenly over ln(diameter).
std::vector<GrainClass> sieve_classes(const SizeDistributionSpec& d) {
  std::vector<GrainClass> classes;
  for (std::size_t k = 0; k + 1 < d.diameters.size(); ++k) {
    const double a = d.diameters[k], b = d.diameters[k + 1], mass = d.passing[k + 1] - d.passing[k];
    if (!(mass > 0.0)) continue;
    const double number = (std::pow(a, -3) - std::pow(b, -3)) / (3.0 * std::log(b / a));
    classes.push_back({0.5 / std::cbrt(number), mass});
  }
  return classes;
}

}  // namespace

double share_of(const std::vector<double>& shares, std::size_t k, std::size_t count) {
  if (shares.empty() || count < 2) return 1.0 / static_cast<double>(count);
  return shares[k] / std::accumulate(shares.begin(), shares.end(), 0.0);
}

std::vector<GrainClass> classes_of(const SizeDistributionSpec& d) {
  std::vector<GrainClass> classes;
  switch (d.kind) {
    case SizeDistributionKind::kTable:
      for (std::size_t k = 0; k < d.diameters.size(); ++k)
        if (d.fractions[k] > 0.0) classes.push_back({0.5 * d.diameters[k], d.fractions[k]});
      break;
    case SizeDistributionKind::kLognormal: classes = lognormal_classes(d); break;
    case SizeDistributionKind::kSieve: classes = sieve_classes(d); break;
  }
  double whole = 0.0;
  for (const GrainClass& one : classes) whole += one.share;
  for (GrainClass& one : classes) one.share /= whole;
  return classes;
}

std::vector<double> all_radii(const BoxSpec& box) {
  std::vector<double> radii = box.radius;
  for (const GrainZoneSpec& zone : box.zones) radii.insert(radii.end(), zone.radius.begin(), zone.radius.end());
  return radii;
}

double smallest_radius(const BoxSpec& box) {
  const std::vector<double> radii = all_radii(box);
  return *std::min_element(radii.begin(), radii.end());
}

double largest_radius(const BoxSpec& box) {
  const std::vector<double> radii = all_radii(box);
  return *std::max_element(radii.begin(), radii.end());
}

double mean_radius(const GrainSizesSpec& sizes) {
  double mean = 0.0;
  for (std::size_t i = 0; i < sizes.radius.size(); ++i)
    mean += share_of(sizes.shares, i, sizes.radius.size()) * sizes.radius[i];
  return mean;
}

double mixed_fraction(const GrainSizesSpec& sizes, double equal) {
  constexpr double kMost = 0.75;
  const std::size_t n = sizes.radius.size();
  std::vector<double> number(n);
  double whole = 0.0, mean = 0.0, variance = 0.0, third = 0.0;
  for (std::size_t i = 0; i < n; ++i) whole += number[i] = share_of(sizes.shares, i, n) / std::pow(sizes.radius[i], 3);
  for (std::size_t i = 0; i < n; ++i) mean += number[i] / whole * sizes.radius[i];
  for (std::size_t i = 0; i < n; ++i) {
    variance += number[i] / whole * std::pow(sizes.radius[i] - mean, 2);
    third += number[i] / whole * std::pow(sizes.radius[i] - mean, 3);
  }
  if (!(variance > 1e-12 * mean * mean)) return equal;
  const double d = std::sqrt(variance) / mean, s = third / std::pow(variance, 1.5);
  return std::min(kMost, equal + 0.0658 * d + 0.0857 * s * d * d);
}

}  // namespace footfall
