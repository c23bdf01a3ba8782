#pragma once
// LIGGGHTS marks and cleans up the contact histories of all grains for each mesh in each step, although most grains are
// far from it (four pads on 43 000 grains: 3 % of the DEM time). Only grains in the neighbour lists of the mesh have
// histories. This visits those.

#include <cstdint>
#include <utility>
#include <vector>

#include "fix_neighlist_mesh.h"

namespace footfall {

// Which grains of this rank were visited in a round.
class VisitedGrains {
 public:
  explicit VisitedGrains(int grains) : grains_(grains) {
    ++round_;
    if (last_.size() < static_cast<std::size_t>(grains)) last_.resize(static_cast<std::size_t>(grains), 0);
  }
  bool is_new(int grain) {
    if (grain >= grains_) return false;  // of another rank
    std::int64_t& last = last_[grain];
    return std::exchange(last, round_) != round_;
  }

 private:
  int grains_;
  static inline std::int64_t round_ = 0;
  static inline std::vector<std::int64_t> last_;  // round of each grain's last visit
};

// Calls visit(grain) once for each grain of this rank in the list of some triangle.
template <class Visit>
void for_each_listed_grain(const LAMMPS_NS::FixNeighlistMesh& lists, int triangles, int grains, Visit visit) {
  VisitedGrains visited(grains);
  for (int triangle = 0; triangle < triangles; ++triangle)
    for (const int grain : lists.get_contact_list(triangle))
      if (visited.is_new(grain)) visit(grain);
}

}  // namespace footfall
