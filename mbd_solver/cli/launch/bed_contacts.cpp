#include "mbd_solver/cli/launch/bed_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace footfall {

BedContacts bed_contacts(const std::vector<GrainPlace>& grains) {
  BedContacts out;
  if (grains.empty()) return out;
  double radius = 0.0;
  Eigen::Vector3d low = grains[0].centre, high = low;
  for (const GrainPlace& grain : grains) {
    radius = std::max(radius, grain.radius);
    low = low.cwiseMin(grain.centre);
    high = high.cwiseMax(grain.centre);
  }
  // Cells as wide as the largest grain: what touches stands in the same or in a neighbouring one.
  using Cell = std::array<long, 3>;
  const auto cell_of = [&](const Eigen::Vector3d& x) {
    const Eigen::Vector3d at = (x - low) / (2.0 * radius);
    return Cell{std::lround(std::floor(at.x())), std::lround(std::floor(at.y())), std::lround(std::floor(at.z()))};
  };
  std::map<Cell, std::vector<std::size_t>> cells;
  for (std::size_t i = 0; i < grains.size(); ++i) cells[cell_of(grains[i].centre)].push_back(i);

  const double quarter = 0.25 * (high.z() - low.z());
  double touches = 0.0;
  std::vector<GrainPlace> inside;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const GrainPlace& grain = grains[i];
    const Eigen::Vector3d margin = (grain.centre - low).cwiseMin(high - grain.centre);
    const bool counts = margin.head<2>().minCoeff() >= 3.0 * radius && margin.z() >= quarter;
    const Cell cell = cell_of(grain.centre);
    for (long k = 0; k < 27; ++k) {
      const auto found = cells.find({cell[0] + k % 3 - 1, cell[1] + k / 3 % 3 - 1, cell[2] + k / 9 - 1});
      if (found == cells.end()) continue;
      for (const std::size_t j : found->second) {
        if (j == i || (grain.clump != 0 && grain.clump == grains[j].clump)) continue;
        const double overlap = grain.radius + grains[j].radius - (grain.centre - grains[j].centre).norm();
        if (overlap <= 0.0) continue;
        out.largest_overlap = std::max(out.largest_overlap, overlap / std::min(grain.radius, grains[j].radius));
        touches += counts ? 1.0 : 0.0;
      }
    }
    if (counts) inside.push_back(grain);
  }
  if (!inside.empty()) out.coordination = touches / static_cast<double>(count_grains(inside));
  return out;
}

}  // namespace footfall
