// Contact histories of grains at meshes: members that stand here in place of the library's. LIGGGHTS marks and cleans up
// the histories of all grains for each mesh in each step, though almost all are far from it (four pads on 43 000 grains: 3 %
// of the time of the grains). Here it is those in the lists of the mesh: no other has one.

#include <cstdint>
#include <utility>
#include <vector>

#include "atom.h"
#include "error.h"
#include "fix_contact_history_mesh.h"
#include "fix_neighlist_mesh.h"
#include "tri_mesh.h"

namespace LAMMPS_NS {
namespace {

// Which grains of this rank were met in a round.
class Meeting {
 public:
  explicit Meeting(int grains) : grains_(grains) {
    ++round_;
    if (met_.size() < static_cast<std::size_t>(grains)) met_.resize(static_cast<std::size_t>(grains), 0);
  }
  bool is_new(int grain) {
    if (grain >= grains_) return false;  // another rank's
    std::int64_t& last = met_[static_cast<std::size_t>(grain)];
    return std::exchange(last, round_) != round_;
  }

 private:
  int grains_;
  static inline std::int64_t round_ = 0;
  static inline std::vector<std::int64_t> met_;  // the last round of each grain
};

// Calls what(grain) once for each grain of this rank that stands in the list of a triangle.
template <class What>
void for_each_near(const FixNeighlistMesh& lists, int triangles, int grains, What what) {
  Meeting meeting(grains);
  for (int triangle = 0; triangle < triangles; ++triangle)
    for (const int grain : lists.get_contact_list(triangle))
      if (meeting.is_new(grain)) what(grain);
}

}  // namespace

// Before the contacts of a step: none is kept or touches until it is met.
void FixContactHistoryMesh::markAllContacts() {
  keeppage_[0]->reset(true);
  intersectpage_[0]->reset(false);
  for_each_near(*fix_neighlist_mesh_, mesh_->sizeLocal() + mesh_->sizeGhost(), atom->nlocal, [this](int grain) {
    keepflag_[grain] = keeppage_[0]->get(nneighs(grain));
    intersectflag_[grain] = intersectpage_[0]->get(nneighs(grain));
    if (keepflag_[grain] == nullptr || intersectflag_[grain] == nullptr)
      error->one(FLERR, "mesh contact history overflow, boost neigh_modify one");
  });
}

// Behind them: those that were not met are forgotten.
void FixContactHistoryMesh::cleanUpContacts() {
  for_each_near(*fix_neighlist_mesh_, mesh_->sizeLocal() + mesh_->sizeGhost(), atom->nlocal,
                [this](int grain) { cleanUpContacts(grain, grain + 1); });
}

}  // namespace LAMMPS_NS
