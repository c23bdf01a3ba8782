// Construction matches the triangles of mesh and body. A step writes the nodes and velocities of all owned and ghost
// triangles, and turns or recalculates the mesh's properties. Grains touch facets, or smooth surfaces once.

#include "liggghts_fix/couple/coupled_mesh.h"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <map>
#include <sstream>

#include "atom.h"
#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "coupler/communicator.h"
#include "domain.h"
#include "fix_mesh_surface.h"
#include "fix_wall_gran.h"
#include "liggghts_fix/access/liggghts_access.h"
#include "liggghts_fix/contact/fix_wall_gran_smooth.h"
#include "liggghts_fix/contact/wall_materials.h"
#include "liggghts_fix/contact/wall_observers.h"
#include "liggghts_fix/link/codes.h"
#include "modify.h"
#include "neighbor.h"
#include "tri_mesh.h"
#include "update.h"

namespace LAMMPS_NS {
namespace {

using footfall::InputError;
namespace code = footfall::code;

constexpr const char* kModule = footfall::kMeshModule;
constexpr const char* kVelocityName = "v";  // element property that LIGGGHTS' contacts read

using NodeVelocities = MultiVectorContainer<double, 3, 3>;

NodeVelocities* node_velocities(TriMesh* mesh) {
  return mesh->prop().getElementProperty<NodeVelocities>(kVelocityName);
}

// Largest distance between round and flat facets: a grain outside the skin of the flat facet must not touch the round one
// [of the skin].
constexpr double kLargestBulge = 0.1;

// --- The simulation box. LIGGGHTS loses triangles that leave it, and grains are only inside.

// Mesh files have six or seven digits: a node this near to a side of the box is on it [of the box's size].
constexpr double kOnTheSide = 1e-6;
constexpr int kFixed = 1;  // Domain::boundary of a side that follows the grains is larger

Eigen::Vector3d low(const Domain& domain) { return Eigen::Vector3d(domain.boxlo); }
Eigen::Vector3d high(const Domain& domain) { return Eigen::Vector3d(domain.boxhi); }

std::string text(const Eigen::Vector3d& x, const char* between) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << x[0] << between << x[1] << between << x[2];
  return out.str();
}

// A body larger than the box probably has another unit.
std::string unit_guess(double body, double box) {
  if (body <= box) return "";
  const bool centimetres = 0.01 * body <= box;  // then it would fit
  return footfall::concat(": these may be ", centimetres ? "centimetres" : "millimetres", " instead of metres");
}

// Is x [m] outside of a side of the box that does not follow the grains, by more than `margin` [m]? Periodic directions
// have no outside; a node on a side is inside, in spite of the round-off of mesh files.
bool is_outside(const Domain& domain, const Eigen::Vector3d& x, double margin) {
  const double inside = margin - kOnTheSide * (high(domain) - low(domain)).maxCoeff();
  for (int c = 0; c < 3; ++c) {
    if (domain.periodicity[c]) continue;
    if (domain.boundary[c][0] <= kFixed && x[c] - inside < domain.boxlo[c]) return true;
    if (domain.boundary[c][1] <= kFixed && x[c] + inside > domain.boxhi[c]) return true;
  }
  return false;
}

// "leaves the simulation box: node at ..., box from ... to ...", with the body's size and its probable unit, for the first
// node outside; empty when all are inside. x: nodes [m].
std::string outside_box_text(const Domain& domain, const Eigen::Matrix3Xd& x) {
  for (int j = 0; j < x.cols(); ++j) {
    if (!is_outside(domain, x.col(j), 0.0)) continue;
    const Eigen::Vector3d size = x.rowwise().maxCoeff() - x.rowwise().minCoeff();
    const Eigen::Vector3d box = high(domain) - low(domain);
    return "leaves the simulation box: node at (" + text(x.col(j), ", ") + "), box from (" + text(low(domain), ", ") +
           ") to (" + text(high(domain), ", ") + "). The body measures " + text(size, " x ") + " m" +
           unit_guess(size.maxCoeff(), box.maxCoeff()) +
           ". Enlarge the region of create_box, or place the body inside it";
  }
  return "";
}

// --- Matching of the triangles of mesh and body over the ranks.

// Moves triangles by whole boxes along periodic directions, to the image that is nearest to r. False if none moved.
bool put_beside_body(const Domain& domain, const Eigen::Vector3d& r, std::vector<footfall::MeshTriangle>& triangles) {
  bool any = false;
  for (footfall::MeshTriangle& triangle : triangles) {
    const Eigen::Vector3d centre = (triangle.corners[0] + triangle.corners[1] + triangle.corners[2]) / 3.0;
    for (int c = 0; c < 3; ++c) {
      if (!domain.periodicity[c]) continue;
      const double box = domain.boxhi[c] - domain.boxlo[c], way = box * std::round((r[c] - centre[c]) / box);
      for (Eigen::Vector3d& corner : triangle.corners) corner[c] += way;
      any = any || way != 0.0;
    }
  }
  return any;
}

// By element id, for all elements of the mesh, which may be a part of the body's surface. Every rank matches the triangles
// it owns (all of them before the first run), then the ranks share the result. Throws InputError, the same on all ranks,
// when mesh and body differ. Collective over `world`.
std::vector<footfall::CornerNodes> match_over_ranks(TriMesh* mesh, const std::string& mesh_id,
                                                    const footfall::CoupledBody& body, const Domain& domain,
                                                    MPI_Comm world) {
  std::vector<footfall::MeshTriangle> mine(mesh->sizeLocal());
  int highest = -1;
  for (int i = 0; i < mesh->sizeLocal(); ++i) {
    footfall::MeshTriangle& triangle = mine[i];
    triangle.id = mesh->id(i);
    highest = std::max(highest, triangle.id);
    for (std::size_t k = 0; k < 3; ++k) triangle.corners[k] = Eigen::Vector3d(footfall::mesh_nodes(mesh)[i][k]);
  }
  std::string failure;
  std::vector<footfall::CornerNodes> corners;
  try {
    corners = footfall::match_mesh(mesh_id, body.boundary, body.initial, mine);
  } catch (const footfall::InputError& mismatch) {
    failure = mismatch.what();
  }
  // A body outside a periodic box, for example after a resume: LIGGGHTS has put its triangles into the box.
  if (!failure.empty() && put_beside_body(domain, body.initial.r, mine)) {
    try {
      corners = footfall::match_mesh(mesh_id, body.boundary, body.initial, mine);
      failure.clear();
    } catch (const footfall::InputError&) {  // the first message is about the mesh as it is
    }
  }
  // All ranks throw the message of the first rank that failed.
  int me = 0, ranks = 1;
  MPI_Comm_rank(world, &me);
  MPI_Comm_size(world, &ranks);
  int first_failed = failure.empty() ? ranks : me;
  footfall::check_mpi(MPI_Allreduce(MPI_IN_PLACE, &first_failed, 1, MPI_INT, MPI_MIN, world), "MPI_Allreduce");
  if (first_failed < ranks) {
    int length = static_cast<int>(failure.size());
    footfall::check_mpi(MPI_Bcast(&length, 1, MPI_INT, first_failed, world), "MPI_Bcast");
    failure.resize(length);
    footfall::check_mpi(MPI_Bcast(failure.data(), length, MPI_CHAR, first_failed, world), "MPI_Bcast");
    throw InputError(failure);
  }

  footfall::check_mpi(MPI_Allreduce(MPI_IN_PLACE, &highest, 1, MPI_INT, MPI_MAX, world), "MPI_Allreduce");
  std::vector<footfall::CornerNodes> all(highest + 1, footfall::CornerNodes{-1, -1, -1});
  for (std::size_t i = 0; i < mine.size(); ++i) all[mine[i].id] = corners[i];
  footfall::check_mpi(MPI_Allreduce(MPI_IN_PLACE, all.data(), 3 * (highest + 1), MPI_INT, MPI_MAX, world),
                      "MPI_Allreduce");
  return all;
}

// By element id: LIGGGHTS' velocities of the three corners of each triangle, in W [m/s]. Collective.
std::vector<Eigen::Matrix3d> velocities_over_ranks(TriMesh* mesh, double*** v, std::size_t elements, MPI_Comm world) {
  constexpr double kNotMine = std::numeric_limits<double>::lowest();
  std::vector<Eigen::Matrix3d> all(elements, Eigen::Matrix3d::Constant(kNotMine));
  for (int i = 0; i < mesh->sizeLocal(); ++i)
    for (int k = 0; k < 3; ++k) all[mesh->id(i)].col(k) = Eigen::Map<const Eigen::Vector3d>(v[i][k]);
  footfall::check_mpi(
      MPI_Allreduce(MPI_IN_PLACE, all.front().data(), static_cast<int>(9 * elements), MPI_DOUBLE, MPI_MAX, world),
      "MPI_Allreduce");
  return all;
}

}  // namespace

void require_whole_surface(const footfall::ModalBoundary& boundary, const std::vector<PartOfSurface>& parts) {
  std::map<footfall::CornerNodes, const std::string*> holder;  // mesh of each triangle, by sorted nodes
  std::string meshes;
  for (const PartOfSurface& part : parts) {
    meshes += (meshes.empty() ? "mesh " : " and mesh ") + part.mesh;
    for (footfall::CornerNodes corners : part.corners) {
      std::sort(corners.begin(), corners.end());
      const auto [place, is_new] = holder.emplace(corners, &part.mesh);
      if (!is_new && place->second != &part.mesh)
        throw InputError(code::kTriangleInTwoMeshes, "meshes ", *place->second, " and ", part.mesh,
                         " contain the same triangle of body \"", boundary.name(),
                         "\"; its contacts would count twice");
    }
  }
  const std::size_t whole = boundary.triangles().size();
  if (holder.size() != whole)
    throw InputError(code::kMeshDiffersFromBody, meshes, parts.size() == 1 ? " has " : " have ", holder.size(),
                     " triangles, body \"", boundary.name(), "\" of the scene has ", whole);
}

CoupledMesh::CoupledMesh(LAMMPS* lmp_, const std::string& where, const footfall::MeshOfBody& pair,
                         footfall::DemLink& link)
    : Pointers(lmp_), link_(link), mesh_id_(pair.mesh), where_(where + "mesh " + mesh_id_ + ": ") {
  fix_ = dynamic_cast<FixMeshSurface*>(modify->find_fix_id(mesh_id_.c_str()));
  if (fix_ == nullptr)
    throw InputError(
        code::kMeshNotFound, where_,
        "no fix mesh/surface of this id is defined before this line; correct the id, or move this line below its mesh");
  if (fix_->triMesh()->isMoving() || fix_->triMesh()->isDeforming())
    throw InputError(code::kMeshMovedTwice, where_, "another fix or a servo moves it already");
  if (footfall::surface_velocity_varies(fix_))
    throw InputError(code::kMeshVelocityVaries, where_,
                     "its surface velocity is a variable, which LIGGGHTS sets in every step; give surface_vel or "
                     "surface_ang_vel numbers");
  body_ = link_.bodies().couple(pair.body, update->unit_style);
  const footfall::CoupledBody& scene_body = link_.bodies().scene_body(pair.body, update->unit_style);
  try {
    module_ = std::make_unique<ContactModule>(
        lmp, fix_, match_over_ranks(fix_->triMesh(), mesh_id_, scene_body, *domain, world), scene_body.boundary.rho0());
  } catch (const InputError& mismatch) {
    if (!modify->have_restart_data(fix_)) throw;
    throw InputError(footfall::with_addition(
        mismatch.what(), ". The restart file contains a mesh of this id at another place: give the mesh another id"));
  }
  x_W_.resize(3, scene_body.boundary.node_count());
  v_W_.resize(3, scene_body.boundary.node_count());
  for (const footfall::CornerNodes& corner : corners()) nodes_.insert(nodes_.end(), corner.begin(), corner.end());
  std::sort(nodes_.begin(), nodes_.end());
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
  if (fix_->surfaceVel()) {
    belt_B_ =
        velocities_over_ranks(fix_->triMesh(), node_velocities(fix_->triMesh())->begin(), corners().size(), world);
    for (Eigen::Matrix3d& corner : belt_B_) corner = scene_body.initial.rotation().transpose() * corner;
  }
  reach_ = scene_body.boundary.rho0().colwise().norm().maxCoeff();
}

void CoupledMesh::attach() {
  TriMesh* mesh = fix_->triMesh();
  mesh->registerMove(false, true, true);
  made_velocities_ = node_velocities(mesh) == nullptr;  // a conveyor has them, or a mesh after `fix move/mesh`
  if (made_velocities_)
    mesh->prop()
        .addElementProperty<NodeVelocities>(kVelocityName, "comm_exchange_borders", "frame_invariant", "restart_no")
        ->setAll(0.0);
  footfall::attach_mesh_module(fix_, kModule, module_.get());
}

void CoupledMesh::detach() {
  if (!is_there()) return;
  footfall::detach_mesh_module(fix_, kModule);
  for (FixWallGran* wall : walls()) {
    WallTorque::set_body(*wall, fix_, nullptr);
    if (auto* const smooth = dynamic_cast<FixWallGranSmooth*>(wall)) smooth->touch_once(fix_, nullptr);
  }
  TriMesh* mesh = fix_->triMesh();
  if (made_velocities_) {
    mesh->prop().removeElementProperty(kVelocityName);
  } else if (link_.started()) {
    node_velocities(mesh)->setAll(0.0);
    add_belt();
  }
  mesh->unregisterMove(false, true, true);
}

// Another mesh of the same id, perhaps at the same address, does not have our module.
bool CoupledMesh::is_there() const {
  auto* const found = dynamic_cast<FixMeshSurface*>(modify->find_fix_id(mesh_id_.c_str()));
  return found != nullptr && found == fix_ && found->get_module(kModule) == module_.get();
}

std::vector<FixWallGran*> CoupledMesh::walls() const {
  std::vector<FixWallGran*> walls;
  for (int i = 0; i < modify->nfix; ++i) {
    auto* wall = dynamic_cast<FixWallGran*>(modify->fix[i]);
    if (wall == nullptr || !wall->is_mesh_wall()) continue;
    FixMeshSurface** const meshes = wall->mesh_list();
    if (std::find(meshes, meshes + wall->n_meshes(), fix_) != meshes + wall->n_meshes()) walls.push_back(wall);
  }
  return walls;
}

void CoupledMesh::begin_run(const char* style, const GrainTorque& torque_before,
                            const footfall::CoupleMbdArguments& arguments) {
  if (fix_->triMesh()->nMove() > 1)
    throw InputError(code::kMeshMovedTwice, where_,
                     "another fix moves it as well (fix move/mesh or a servo after fix couple/mbd), although the body "
                     "of the scene moves it: unfix the other one");
  const std::vector<FixWallGran*> touching = walls();
  if (touching.empty())
    throw InputError(code::kMeshWithoutWall, where_,
                     "no fix wall/gran names it, so that grains would pass through it: add  fix ID all wall/gran model "
                     "... mesh n_meshes 1 meshes ",
                     mesh_id_);
  const std::string outside = outside_box();
  stays_behind_ = !outside.empty() && link_.window().body(body_).sides().off_bed();
  if (!outside.empty() && !stays_behind_)
    throw InputError(code::kMeshLeavesBox, where_, "body \"", link_.bodies().name(body_), "\" ", outside);
  for (FixWallGran* wall : touching) {
    WallTorque::observe(lmp, *wall, torque_before);
    if (arguments.mass_of_pair) WallTorque::set_body(*wall, fix_, &link_.window().body(body_));
  }
  let_grains_touch_once(arguments, touching);
  module_->set_torque_before(torque_before);
  module_->set_body(link_, body_);
  module_->set_contacts(wall_contacts(*modify, atom->ntypes, fix_->atomTypeWall(), style));
  if (link_.resumed() && !moved_) set_velocities();
  hold_in_box();
}

// Restart files hold the positions of the nodes only, but the forces before the first DEM step include damping.
void CoupledMesh::set_velocities() {
  const footfall::DemBody& body = link_.window().body(body_);
  TriMesh* mesh = fix_->triMesh();
  body.boundary().node_velocities(body.pose(), v_W_);
  double*** v = node_velocities(mesh)->begin();
  for (int i = 0; i < mesh->sizeLocal(); ++i) {
    const footfall::CornerNodes& corner = module_->corners()[mesh->id(i)];
    for (int k = 0; k < 3; ++k) std::copy_n(v_W_.col(corner[k]).data(), 3, v[i][k]);
  }
}

// Owned and ghost triangles: LIGGGHTS copies neither positions nor velocities to ghosts between two re-neighbourings.
void CoupledMesh::move() {
  moved_ = true;
  if (stays_behind_) return;
  bend_round_surface();
  const footfall::DemBody& body = link_.window().body(body_);
  TriMesh* tri_mesh = fix_->triMesh();
  if (body.path().steady_translation()) {
    translate(body.pose().dr);
    add_belt();
    hold_in_box();
    return;
  }
  body.boundary().node_positions(body.pose(), x_W_);
  body.boundary().node_velocities(body.pose(), v_W_);
  const std::vector<footfall::CornerNodes>& corners = module_->corners();
  double*** x = footfall::mesh_nodes(tri_mesh);
  double** center = footfall::mesh_centers(tri_mesh);
  double*** v = node_velocities(tri_mesh)->begin();
  for (int i = 0; i < tri_mesh->size(); ++i) {
    const footfall::CornerNodes& corner = corners[tri_mesh->id(i)];
    for (int k = 0; k < 3; ++k) {
      const int node = corner[k];
      std::copy_n(v_W_.col(node).data(), 3, v[i][k]);
      for (int c = 0; c < 3; ++c) x[i][k][c] = nearest_image(x_W_(c, node), x[i][k][c], c);
    }
    for (int c = 0; c < 3; ++c) center[i][c] = (x[i][0][c] + x[i][1][c] + x[i][2][c]) / 3.0;
  }
  add_belt();
  if (body.path().first_substep()) turn_properties(body.path().jump());
  turn_properties(body.path().last_step());
  if (body.boundary().mode_count() > 0) footfall::recalculate_mesh(tri_mesh);
  hold_in_box();
}

// LIGGGHTS loses a triangle whose centre is outside of a side of the box, be it by round-off.
void CoupledMesh::hold_in_box() {
  const footfall::DemBody& body = link_.window().body(body_);
  const double margin = reach_ + 2.0 * kOnTheSide * (high(*domain) - low(*domain)).maxCoeff();
  if (body.boundary().mode_count() == 0 && !is_outside(*domain, body.pose().r, margin)) return;
  TriMesh* mesh = fix_->triMesh();
  double** center = footfall::mesh_centers(mesh);
  for (int i = 0; i < mesh->size(); ++i)
    for (int c = 0; c < 3; ++c) {
      if (domain->periodicity[c]) continue;
      if (domain->boundary[c][0] <= kFixed) center[i][c] = std::max(center[i][c], domain->boxlo[c]);
      if (domain->boundary[c][1] <= kFixed) center[i][c] = std::min(center[i][c], domain->boxhi[c]);
    }
}

// The same sums as in fix move/mesh linear, so that the same motion gives the same bits.
void CoupledMesh::translate(const Eigen::Vector3d& velocity) {
  TriMesh* mesh = fix_->triMesh();
  double dx[3];
  for (int c = 0; c < 3; ++c) dx[c] = velocity[c] * update->dt;
  double*** x = footfall::mesh_nodes(mesh);
  double** center = footfall::mesh_centers(mesh);
  double*** v = node_velocities(mesh)->begin();
  for (int i = 0; i < mesh->size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      for (int c = 0; c < 3; ++c) x[i][k][c] += dx[c];
      std::copy_n(velocity.data(), 3, v[i][k]);
    }
    for (int c = 0; c < 3; ++c) center[i][c] += dx[c];
  }
  mesh->prop().move(dx);
}

// A conveyor belt moves on the body and turns with it: v = v_body + R_WB v_belt.
void CoupledMesh::add_belt() {
  if (belt_B_.empty()) return;
  TriMesh* mesh = fix_->triMesh();
  const Eigen::Matrix3d R_WB = link_.window().body(body_).pose().rotation();
  double*** v = node_velocities(mesh)->begin();
  for (int i = 0; i < mesh->size(); ++i)
    for (int k = 0; k < 3; ++k) Eigen::Map<Eigen::Vector3d>(v[i][k]) += R_WB * belt_B_[mesh->id(i)].col(k);
}

// In a periodic direction a triangle may be one or more boxes away from its body's own position: it stays there.
double CoupledMesh::nearest_image(double place, double before, int direction) const {
  if (!domain->periodicity[direction]) return place;
  const double box = domain->boxhi[direction] - domain->boxlo[direction];
  return place + box * std::round((before - place) / box);
}

// Normals and edges turn with the body, and the mesh's reference point (fix mesh/surface/stress) moves with it; areas and
// lengths are constant. LIGGGHTS computes all of them from the nodes at every re-neighbouring, so that round-off does not
// accumulate for long.
void CoupledMesh::turn_properties(const footfall::BoundaryStep& step) {
  CustomValueTracker& properties = fix_->triMesh()->prop();
  if (step.theta_W.isZero(0.0)) {
    if (!step.r.isZero(0.0)) properties.move(step.r.data());
    return;
  }
  const footfall::BodyMotion& pose = link_.window().body(body_).pose();
  const Eigen::Vector3d from_Bo = step.r - pose.r;  // minus Bo before the step
  const Eigen::Vector4d turn = footfall::turned(Eigen::Vector4d(1.0, 0.0, 0.0, 0.0), step.theta_W);
  properties.move(from_Bo.data());
  properties.rotate(turn.data());
  properties.move(pose.r.data());
}

std::string CoupledMesh::outside_box() const {
  const footfall::DemBody& body = link_.window().body(body_);
  Eigen::Matrix3Xd x(3, body.boundary().node_count());
  body.boundary().node_positions(body.pose(), x);
  return outside_box_text(*domain, x(Eigen::all, nodes_));
}

// Every rank checks the same pose with the same result.
void CoupledMesh::check_inside_box() {
  const footfall::DemBody& body = link_.window().body(body_);
  if (stays_behind_) return;
  if (body.boundary().mode_count() == 0 && !is_outside(*domain, body.pose().r, reach_)) return;
  const std::string outside = outside_box();
  if (outside.empty()) return;
  stays_behind_ = link_.window().body(body_).sides().off_bed();
  if (stays_behind_) return;
  throw footfall::NumericalError(code::kMeshLeavesBox,
                                 "t = ", footfall::number_text(static_cast<double>(update->ntimestep) * update->dt),
                                 " s: mesh ", mesh_id_, " (body \"", link_.bodies().name(body_), "\"), at step ",
                                 update->ntimestep, ", ", outside);
}

// --- Grains that touch a curved or deforming mesh once, on its facets or on the round surface behind them.

// fix multicontact/halfspace reads LIGGGHTS' contacts of a mesh facet by facet.
void CoupledMesh::let_grains_touch_once(const footfall::CoupleMbdArguments& arguments,
                                        const std::vector<FixWallGran*>& walls) {
  using Surface = footfall::CoupleMbdArguments::Surface;
  if (arguments.surface == Surface::kFacets || modify->n_fixes_style("multicontact/halfspace") > 0) return;
  const footfall::ModalBoundary& boundary = link_.window().body(body_).boundary();
  auto smooth = std::make_shared<SmoothMesh>(
      SmoothMesh{footfall::SurfacePieces(boundary.rho0(), corners(), arguments.edge_angle), nullptr});
  if (!smooth->pieces.curved() && boundary.mode_count() == 0) return;
  if (arguments.surface == Surface::kRound) {
    smooth->round = std::make_unique<footfall::RoundSurface>(smooth->pieces, boundary.rho0());
    if (smooth->round->largest_bulge() > kLargestBulge * neighbor->skin)
      throw InputError(code::kSurfaceTooRound, where_, "`surface round` raises a facet by ",
                       footfall::number_text(smooth->round->largest_bulge()), " m, more than ",
                       footfall::number_text(kLargestBulge),
                       " of the skin in which LIGGGHTS finds grains: use smaller facets, a larger skin (command "
                       "`neighbor`), or sharp edges (`edge DEGREES`)");
  }
  smooth_ = smooth;
  for (FixWallGran* wall : walls) {
    auto* const smooth_wall = dynamic_cast<FixWallGranSmooth*>(wall);
    if (smooth_wall == nullptr) return;  // another style of LIGGGHTS
    smooth_wall->touch_once(fix_, smooth);
  }
  module_->set_touched_once();
  bend_round_surface();
}

// Turns or deforms the round surface with the body.
void CoupledMesh::bend_round_surface() {
  if (smooth_ == nullptr || smooth_->round == nullptr) return;
  const footfall::DemBody& body = link_.window().body(body_);
  if (body.boundary().mode_count() == 0) {
    smooth_->round->turn(body.pose().rotation());
    return;
  }
  body.boundary().node_positions(body.pose(), x_W_);
  smooth_->round->deform(smooth_->pieces, x_W_);
}

}  // namespace LAMMPS_NS
