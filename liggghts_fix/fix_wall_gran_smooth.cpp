#include "liggghts_fix/fix_wall_gran_smooth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "atom.h"
#include "fix_contact_history_mesh.h"
#include "fix_mesh_surface.h"
#include "fix_neighlist_mesh.h"
#include "granular_wall.h"
#include "liggghts_fix/liggghts_access.h"
#include "neighbor.h"
#include "tri_mesh.h"

namespace LAMMPS_NS {
namespace {

using footfall::SurfacePieces;
using NodeVelocities = MultiVectorContainer<double, 3, 3>;

// A facet whose plane is farther from the grain than this needs no closer look [of its reach].
constexpr double kSlack = 1.0 + 1e-9;

}  // namespace

void FixWallGranSmooth::touch_once(FixMeshSurface* mesh, std::shared_ptr<const SurfacePieces> pieces) {
  if (pieces) {
    pieces_[mesh] = std::move(pieces);
  } else {
    pieces_.erase(mesh);
  }
}

int FixWallGranSmooth::number_of(const FixMeshSurface* mesh) const {
  return static_cast<int>(std::find(meshes_.begin(), meshes_.end(), mesh) - meshes_.begin());
}

// LIGGGHTS' own loop runs over the meshes of its list: it sees one of them at a time.
void FixWallGranSmooth::post_force_mesh(int vflag) {
  if (pieces_.empty()) {
    FixWallGran::post_force_mesh(vflag);
    return;
  }
  FixMeshSurface** const all = FixMesh_list_;
  const int count = n_FixMesh_;
  meshes_.assign(all, all + count);
  for (int i = 0; i < count; ++i) {
    const auto smooth = pieces_.find(all[i]);
    if (smooth != pieces_.end()) {
      touch_pieces(*all[i], i, *smooth->second);
      continue;
    }
    FixMesh_list_ = all + i;
    n_FixMesh_ = 1;
    FixWallGran::post_force_mesh(vflag);
    FixMesh_list_ = all;
    n_FixMesh_ = count;
  }
}

void FixWallGranSmooth::touch_pieces(FixMeshSurface& mesh_fix, int mesh_number, const SurfacePieces& pieces) {
  TriMesh& mesh = *mesh_fix.triMesh();
  FixContactHistoryMesh* const history = mesh_fix.contactHistory();
  if (history != nullptr) history->markAllContacts();
  if (store_force_contact_) fix_wallforce_contact_ = mesh_fix.meshforceContact();
  if (store_force_contact_stress_) fix_wallforce_contact_stress_ = mesh_fix.meshforceContactStress();
  atom_type_wall_ = mesh_fix.atomTypeWall();
  auto* const moving = mesh.prop().getElementProperty<NodeVelocities>("v");
  double*** const v = moving != nullptr ? moving->begin() : nullptr;

  find_touches(mesh_fix);
  LCM::SurfacesIntersectData contact;
  contact.is_wall = true;
  contact.mesh = &mesh;
  contact.fix_mesh = &mesh_fix;
  for (const Touch& touch : touches_) {
    if (!counts(touch, pieces)) continue;
    const std::array<double, 3>& weights = touch.nearest.weights;
    double v_wall[3] = {};
    if (v != nullptr)
      for (int c = 0; c < 3; ++c)
        v_wall[c] = weights[0] * v[touch.element][0][c] + weights[1] * v[touch.element][1][c] +
                    weights[2] * v[touch.element][2][c];
    contact.i = touch.grain;
    contact.radi = radius_[touch.grain];
    contact.deltan = -touch.nearest.gap;
    for (int c = 0; c < 3; ++c) contact.delta[c] = -touch.delta[c];
    contact.contact_history = history != nullptr ? history_of(*history, touch, pieces) : nullptr;
    impl->compute_force(this, contact, touch.nearest.gap <= 0.0, v_wall, &mesh_fix, mesh_number, &mesh, touch.element);
  }
  for (const Touch& touch : touches_) last_[static_cast<std::size_t>(touch.grain)] = -1;
  if (history != nullptr) history->cleanUpContacts();
}

// All facets within reach of a grain, whether LIGGGHTS lets their edges and corners act or not: it lets those of one
// facet act for both.
void FixWallGranSmooth::find_touches(FixMeshSurface& mesh_fix) {
  TriMesh& mesh = *mesh_fix.triMesh();
  const FixNeighlistMesh& neighbours = *mesh_fix.meshNeighlist();
  double*** const nodes = footfall::mesh_nodes(&mesh);
  const double reach = neighbor->contactDistanceFactor - 1.0;  // of models that act at a distance
  const int grains = atom->nlocal;
  if (last_.size() < static_cast<std::size_t>(grains)) last_.resize(static_cast<std::size_t>(grains), -1);
  touches_.clear();
  for (int element = 0; element < mesh.size(); ++element) {
    const std::vector<int>& near = neighbours.get_contact_list(element);
    if (near.empty()) continue;
    const double* const corner = nodes[element][0];
    double normal[3];
    mesh.surfaceNorm(element, normal);
    for (const int grain : near) {
      if (grain >= grains) continue;  // of another rank
      double* const x = x_[grain];
      const double r = radius_[grain];
      const double farthest = r * std::max(1.0, 1.0 + reach);
      const double height =
          normal[0] * (x[0] - corner[0]) + normal[1] * (x[1] - corner[1]) + normal[2] * (x[2] - corner[2]);
      if (std::abs(height) > kSlack * farthest) continue;
      Touch touch;
      int region = 0;
      const double gap = mesh.resolveTriSphereContactBary(grain, element, r, x, touch.delta,
                                                          touch.nearest.weights.data(), region, false);
      if (gap > 0.0 && gap >= reach * r) continue;
      int& last = last_[static_cast<std::size_t>(grain)];
      touch.nearest.facet = mesh.id(element);
      touch.nearest.gap = gap;
      touch.grain = grain;
      touch.element = element;
      touch.before = std::exchange(last, static_cast<int>(touches_.size()));
      touches_.push_back(touch);
    }
  }
}

bool FixWallGranSmooth::counts(const Touch& touch, const SurfacePieces& pieces) const {
  for (int k = last_[static_cast<std::size_t>(touch.grain)]; k >= 0;) {
    const Touch& other = touches_[static_cast<std::size_t>(k)];
    if (&other != &touch && yields(touch.nearest, other.nearest, pieces)) return false;
    k = other.before;
  }
  return true;
}

// LIGGGHTS keeps a history for each facet that a grain touched in the step before. A new contact goes on from one that
// ends on the same piece, from a facet beside it where there are several.
double* FixWallGranSmooth::history_of(FixContactHistoryMesh& history, const Touch& touch, const SurfacePieces& pieces) {
  const int grain = touch.grain, facet = touch.nearest.facet, places = history.nneighs(grain);
  const double* past = nullptr;
  std::pair<bool, int> past_facet;
  bool is_new = true;
  for (int j = 0; j < places && is_new; ++j) is_new = history.partner(grain, j) != facet;
  for (int j = 0; j < places && is_new && history.get_dnum() > 0; ++j) {
    const int other = history.partner(grain, j);
    if (other < 0 || pieces.piece(other) != pieces.piece(facet) || goes_on(grain, other, pieces)) continue;
    const std::pair place(!pieces.are_neighbours(facet, other), other);
    if (past != nullptr && past_facet < place) continue;
    past_facet = place;
    past = history.contacthistory(grain, j);
  }
  double* mine = nullptr;
  history.handleContact(grain, facet, mine, touch.nearest.gap <= 0.0, false);
  if (past != nullptr) std::copy_n(past, history.get_dnum(), mine);
  return mine;
}

bool FixWallGranSmooth::goes_on(int grain, int facet, const SurfacePieces& pieces) const {
  for (int k = last_[static_cast<std::size_t>(grain)]; k >= 0;) {
    const Touch& touch = touches_[static_cast<std::size_t>(k)];
    if (touch.nearest.facet == facet && counts(touch, pieces)) return true;
    k = touch.before;
  }
  return false;
}

}  // namespace LAMMPS_NS
