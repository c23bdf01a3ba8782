// Per mesh: finds all facets within reach of each grain, keeps the nearest of each piece, and calls LIGGGHTS' contact
// model for it. Other meshes go through LIGGGHTS' own loop, one at a time.

#include "liggghts_fix/contact/fix_wall_gran_smooth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "atom.h"
#include "fix_contact_history_mesh.h"
#include "fix_mesh_surface.h"
#include "fix_neighlist_mesh.h"
#include "granular_wall.h"
#include "liggghts_fix/access/liggghts_access.h"
#include "neighbor.h"
#include "tri_mesh.h"

namespace LAMMPS_NS {
namespace {

using footfall::SurfacePieces;
using NodeVelocities = MultiVectorContainer<double, 3, 3>;

// A facet whose plane is farther from the grain than this is out of reach [of the reach].
constexpr double kSlack = 1.0 + 1e-9;

// LIGGGHTS returns a million as the distance from an edge or corner that does not act [m].
constexpr double kFar = 1e5;

}  // namespace

void FixWallGranSmooth::touch_once(FixMeshSurface* mesh, std::shared_ptr<const SmoothMesh> smooth) {
  if (smooth) {
    smooth_[mesh] = std::move(smooth);
  } else {
    smooth_.erase(mesh);
  }
}

int FixWallGranSmooth::number_of(const FixMeshSurface* mesh) const {
  return static_cast<int>(std::find(meshes_.begin(), meshes_.end(), mesh) - meshes_.begin());
}

// LIGGGHTS' own loop runs over the meshes of its list, which is cut to one mesh at a time.
void FixWallGranSmooth::post_force_mesh(int vflag) {
  if (smooth_.empty()) {
    FixWallGran::post_force_mesh(vflag);
    return;
  }
  FixMeshSurface** const all = FixMesh_list_;
  const int count = n_FixMesh_;
  meshes_.assign(all, all + count);
  for (int i = 0; i < count; ++i) {
    const auto smooth = smooth_.find(all[i]);
    if (smooth != smooth_.end()) {
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

void FixWallGranSmooth::touch_pieces(FixMeshSurface& mesh_fix, int mesh_number, const SmoothMesh& smooth) {
  const SurfacePieces& pieces = smooth.pieces;
  TriMesh& mesh = *mesh_fix.triMesh();
  FixContactHistoryMesh* const history = mesh_fix.contactHistory();
  if (history != nullptr) history->markAllContacts();
  if (store_force_contact_) fix_wallforce_contact_ = mesh_fix.meshforceContact();
  if (store_force_contact_stress_) fix_wallforce_contact_stress_ = mesh_fix.meshforceContactStress();
  atom_type_wall_ = mesh_fix.atomTypeWall();
  auto* const moving = mesh.prop().getElementProperty<NodeVelocities>("v");
  double*** const v = moving != nullptr ? moving->begin() : nullptr;

  find_touches(mesh_fix, smooth);
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
  for (const Touch& touch : touches_) last_[touch.grain] = -1;
  if (history != nullptr) history->cleanUpContacts();
}

// All facets within reach of a grain. In LIGGGHTS an edge or corner acts in one of its facets only, and in none when they
// were coplanar at first: this is applied on the border of a piece, where two pieces meet.
void FixWallGranSmooth::find_touches(FixMeshSurface& mesh_fix, const SmoothMesh& smooth) {
  TriMesh& mesh = *mesh_fix.triMesh();
  const FixNeighlistMesh& neighbours = *mesh_fix.meshNeighlist();
  double*** const nodes = footfall::mesh_nodes(&mesh);
  const int grains = atom->nlocal;
  if (last_.size() < static_cast<std::size_t>(grains)) last_.resize(grains, -1);
  touches_.clear();
  const double reach = kSlack * std::max(1.0, neighbor->contactDistanceFactor);  // [of the grain's radius]
  const double bulge = smooth.round ? smooth.round->largest_bulge() : 0.0;
  for (int element = 0; element < mesh.size(); ++element) {
    const std::vector<int>& near = neighbours.get_contact_list(element);
    if (near.empty()) continue;
    double normal[3];
    mesh.surfaceNorm(element, normal);
    Touch touch;
    touch.element = element;
    touch.nearest.facet = mesh.id(element);
    // The bounding sphere of the facet excludes most grains of the list.
    const Eigen::Map<const Eigen::Vector3d> a(nodes[element][0]), b(nodes[element][1]), c(nodes[element][2]);
    const Eigen::Vector3d centre = (a + b + c) / 3.0;
    const double around =
        kSlack *
            std::sqrt(std::max({(a - centre).squaredNorm(), (b - centre).squaredNorm(), (c - centre).squaredNorm()})) +
        bulge;
    for (const int grain : near) {
      if (grain >= grains) continue;  // of another rank
      const double farthest = reach * radius_[grain] + around;
      if ((Eigen::Map<const Eigen::Vector3d>(x_[grain]) - centre).squaredNorm() > farthest * farthest) continue;
      touch.grain = grain;
      if (!reaches(smooth, mesh, nodes[element], normal, touch)) continue;
      int& last = last_[grain];
      touch.before = std::exchange(last, static_cast<int>(touches_.size()));
      touches_.push_back(touch);
    }
  }
}

// Fills in the point of the facet nearest to the grain. False: it is out of reach.
bool FixWallGranSmooth::reaches(const SmoothMesh& smooth, TriMesh& mesh, double* const* corners, const double* normal,
                                Touch& touch) const {
  double* const x = x_[touch.grain];
  const double r = radius_[touch.grain];
  const double reach = std::max(0.0, neighbor->contactDistanceFactor - 1.0) * r;  // of models that act at a distance
  const bool is_round = smooth.round && !smooth.round->is_flat(touch.nearest.facet);
  const double height =
      normal[0] * (x[0] - corners[0][0]) + normal[1] * (x[1] - corners[0][1]) + normal[2] * (x[2] - corners[0][2]);
  if (std::abs(height) > kSlack * (r + reach + (is_round ? smooth.round->largest_bulge() : 0.0))) return false;

  footfall::FacetTouch& nearest = touch.nearest;
  int region = 0;
  if (is_round) {
    Eigen::Matrix3d nodes;
    for (int k = 0; k < 3; ++k) nodes.col(k) = Eigen::Map<const Eigen::Vector3d>(corners[k]);
    const Eigen::Map<const Eigen::Vector3d> centre(x);
    const auto [weights, point] = smooth.round->facet(nearest.facet, nodes).nearest(centre);
    Eigen::Map<Eigen::Vector3d>(touch.delta) = point - centre;
    nearest.weights = weights;
    nearest.gap = (point - centre).norm() - r;
  } else {
    nearest.gap = mesh.resolveTriSphereContactBary(touch.grain, touch.element, r, x, touch.delta,
                                                   nearest.weights.data(), region, false);
  }
  if (nearest.gap > 0.0 && nearest.gap >= reach) return false;

  nearest.acts = true;
  touch.nearest.on_border = !smooth.pieces.inside_piece(nearest.facet, nearest.weights);
  if (touch.nearest.on_border) {
    double delta[3], weights[3];
    nearest.acts =
        mesh.resolveTriSphereContactBary(touch.grain, touch.element, r, x, delta, weights, region, true) < kFar;
  }
  return true;
}

bool FixWallGranSmooth::counts(const Touch& touch, const SurfacePieces& pieces) const {
  if (!touch.nearest.acts) return false;
  for (int k = last_[touch.grain]; k >= 0;) {
    const Touch& other = touches_[k];
    if (&other != &touch && yields_to(touch.nearest, other.nearest, pieces)) return false;
    k = other.before;
  }
  return true;
}

// LIGGGHTS stores a history for each facet that a grain touched in the previous step. A new contact continues the history
// of a contact that ends on the same piece, on a neighbouring facet if there are several. Along the border of a flat face
// LIGGGHTS starts anew on each facet; so does a face that bends, in order to equal a rigid face while it is flat.
double* FixWallGranSmooth::history_of(FixContactHistoryMesh& history, const Touch& touch, const SurfacePieces& pieces) {
  const int grain = touch.grain, facet = touch.nearest.facet, places = history.nneighs(grain);
  const double* past = nullptr;
  std::pair<bool, int> past_facet;
  bool continues = pieces.curved() || !touch.nearest.on_border;
  for (int j = 0; j < places && continues; ++j) continues = history.partner(grain, j) != facet;
  for (int j = 0; j < places && continues && history.get_dnum() > 0; ++j) {
    const int other = history.partner(grain, j);
    if (other < 0 || pieces.piece(other) != pieces.piece(facet) || touches(grain, other, pieces)) continue;
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

bool FixWallGranSmooth::touches(int grain, int facet, const SurfacePieces& pieces) const {
  for (int k = last_[grain]; k >= 0;) {
    const Touch& touch = touches_[k];
    if (touch.nearest.facet == facet && counts(touch, pieces)) return true;
    k = touch.before;
  }
  return false;
}

}  // namespace LAMMPS_NS
