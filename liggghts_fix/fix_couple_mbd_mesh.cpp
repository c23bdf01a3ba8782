#include "liggghts_fix/fix_couple_mbd_mesh.h"

#include <algorithm>
#include <cmath>

#include "atom.h"
#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "domain.h"
#include "fix_mesh_surface.h"
#include "fix_wall_gran.h"
#include "liggghts_fix/fix_couple_mbd_box.h"
#include "liggghts_fix/fix_couple_mbd_match.h"
#include "liggghts_fix/fix_couple_mbd_materials.h"
#include "liggghts_fix/fix_wall_gran_smooth.h"
#include "liggghts_fix/fix_wall_torque.h"
#include "liggghts_fix/liggghts_access.h"
#include "modify.h"
#include "tri_mesh.h"
#include "update.h"

namespace LAMMPS_NS {
namespace {

using footfall::InputError;

constexpr const char* kModule = footfall::kMeshModule;
constexpr const char* kVelocityName = "v";  // element property that LIGGGHTS' contacts read

using NodeVelocities = MultiVectorContainer<double, 3, 3>;

NodeVelocities* node_velocities(TriMesh* mesh) {
  return mesh->prop().getElementProperty<NodeVelocities>(kVelocityName);
}

}  // namespace

CoupledMesh::CoupledMesh(LAMMPS* lmp_, const std::string& asker, const footfall::MeshOfBody& pair,
                         footfall::DemLink& link)
    : Pointers(lmp_), link_(link), mesh_id_(pair.mesh), where_(asker + "mesh " + mesh_id_ + ": ") {
  fix_ = dynamic_cast<FixMeshSurface*>(modify->find_fix_id(mesh_id_.c_str()));
  if (fix_ == nullptr)
    throw InputError(where_ +
                     "no fix mesh/surface of this id stands before this line; correct the "
                     "id, or move this line below its mesh");
  if (fix_->triMesh()->isMoving() || fix_->triMesh()->isDeforming())
    throw InputError(where_ + "another fix or a servo moves it already");
  if (footfall::surface_velocity_varies(fix_))
    throw InputError(where_ +
                     "its surface velocity is a variable, which LIGGGHTS sets anew in every step; give "
                     "surface_vel or surface_ang_vel numbers");
  body_ = link_.couple(pair.body, update->unit_style);
  const footfall::CoupledBody& scene_body = link_.scene_body(pair.body, update->unit_style);
  try {
    module_ = std::make_unique<MeshModuleMbd>(lmp, fix_, match_over_ranks(fix_->triMesh(), mesh_id_, scene_body, world),
                                              scene_body.boundary.rho0());
  } catch (const InputError& mismatch) {
    if (!modify->have_restart_data(fix_)) throw;
    throw InputError(mismatch.what() + std::string(". The restart file knows a mesh of this id and has placed it: give "
                                                   "the mesh another id"));
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
  made_velocities_ = node_velocities(mesh) == nullptr;  // not of a conveyor, or after a `fix move/mesh`
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
    WallTorque::meet(*wall, fix_, nullptr);
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

// Another mesh of the same id, perhaps at the same address, does not know our module.
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
    throw InputError(where_ +
                     "another fix moves it too (fix move/mesh or a servo after fix couple/mbd), and the body of the "
                     "scene moves it already: unfix the other one");
  const std::vector<FixWallGran*> touching = walls();
  if (touching.empty())
    throw InputError(where_ +
                     "no fix wall/gran names it, so grains would pass through it: add  fix ID all wall/gran model ... "
                     "mesh n_meshes 1 meshes " +
                     mesh_id_);
  if (const std::string outside = outside_box(); !outside.empty())
    throw InputError(where_ + "body \"" + link_.body_name(body_) + "\" " + outside);
  for (FixWallGran* wall : touching) {
    WallTorque::watch(lmp, *wall, torque_before);
    if (arguments.mass_of_pair) WallTorque::meet(*wall, fix_, &link_.body(body_));
  }
  let_grains_touch_once(arguments, touching);
  module_->set_torque_before(torque_before);
  module_->set_body(&link_.body(body_));
  module_->set_contacts(wall_contacts(*modify, atom->ntypes, fix_->atomTypeWall(), style));
  if (link_.resumed() && !moved_) set_velocities();
}

// Restart files hold the places of the nodes alone, and the forces that stand before the first substep damp.
void CoupledMesh::set_velocities() {
  const footfall::DemBody& body = link_.body(body_);
  TriMesh* mesh = fix_->triMesh();
  body.boundary().node_velocities(body.pose(), v_W_);
  double*** v = node_velocities(mesh)->begin();
  for (int i = 0; i < mesh->sizeLocal(); ++i) {
    const footfall::CornerNodes& corner = module_->corners()[static_cast<std::size_t>(mesh->id(i))];
    for (int k = 0; k < 3; ++k) std::copy_n(v_W_.col(corner[static_cast<std::size_t>(k)]).data(), 3, v[i][k]);
  }
}

// Owned and ghost triangles alike: LIGGGHTS copies neither positions nor velocities to ghosts between two
// re-neighbourings.
void CoupledMesh::move() {
  moved_ = true;
  bend_round_surface();
  const footfall::DemBody& body = link_.body(body_);
  TriMesh* tri_mesh = fix_->triMesh();
  if (body.path().steady_translation()) {
    translate(body.pose().dr);
    add_belt();
    return;
  }
  body.boundary().node_positions(body.pose(), x_W_);
  body.boundary().node_velocities(body.pose(), v_W_);
  const std::vector<footfall::CornerNodes>& corners = module_->corners();
  double*** x = footfall::mesh_nodes(tri_mesh);
  double** center = footfall::mesh_centers(tri_mesh);
  double*** v = node_velocities(tri_mesh)->begin();
  for (int i = 0; i < tri_mesh->size(); ++i) {
    const footfall::CornerNodes& corner = corners[static_cast<std::size_t>(tri_mesh->id(i))];
    for (int k = 0; k < 3; ++k) {
      const int node = corner[static_cast<std::size_t>(k)];
      std::copy_n(v_W_.col(node).data(), 3, v[i][k]);
      for (int c = 0; c < 3; ++c) x[i][k][c] = nearest_image(x_W_(c, node), x[i][k][c], c);
    }
    for (int c = 0; c < 3; ++c) center[i][c] = (x[i][0][c] + x[i][1][c] + x[i][2][c]) / 3.0;
  }
  add_belt();
  if (body.path().first_substep()) turn_properties(body.path().jump());
  turn_properties(body.path().last_step());
  if (body.boundary().mode_count() > 0) footfall::recalculate_mesh(tri_mesh);
}

// The same sums as fix move/mesh linear, so that the same motion gives the same bits.
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

// A conveyor's belt runs on the body and turns with it: v = v_body + R_WB v_belt.
void CoupledMesh::add_belt() {
  if (belt_B_.empty()) return;
  TriMesh* mesh = fix_->triMesh();
  const Eigen::Matrix3d R_WB = link_.body(body_).pose().rotation();
  double*** v = node_velocities(mesh)->begin();
  for (int i = 0; i < mesh->size(); ++i)
    for (int k = 0; k < 3; ++k)
      Eigen::Map<Eigen::Vector3d>(v[i][k]) += R_WB * belt_B_[static_cast<std::size_t>(mesh->id(i))].col(k);
}

// In a periodic direction a triangle may stand one or more boxes away from its body's own place: it stays there.
double CoupledMesh::nearest_image(double place, double before, int direction) const {
  if (!domain->periodicity[direction]) return place;
  const double box = domain->boxhi[direction] - domain->boxlo[direction];
  return place + box * std::round((before - place) / box);
}

// Normals and edges turn with the body, the mesh's reference point (fix mesh/surface/stress) moves with it; areas and
// lengths stay. LIGGGHTS computes all of them anew from the nodes at every re-neighbouring, so round-off does not add
// up for long.
void CoupledMesh::turn_properties(const footfall::BoundaryStep& step) {
  CustomValueTracker& properties = fix_->triMesh()->prop();
  if (step.theta_W.isZero(0.0)) {
    if (!step.r.isZero(0.0)) properties.move(step.r.data());
    return;
  }
  const footfall::BodyMotion& pose = link_.body(body_).pose();
  const Eigen::Vector3d from_Bo = step.r - pose.r;  // minus Bo before the step
  const Eigen::Vector4d turn = footfall::turned(Eigen::Vector4d(1.0, 0.0, 0.0, 0.0), step.theta_W);
  properties.move(from_Bo.data());
  properties.rotate(turn.data());
  properties.move(pose.r.data());
}

std::string CoupledMesh::outside_box() const {
  const footfall::DemBody& body = link_.body(body_);
  Eigen::Matrix3Xd x(3, body.boundary().node_count());
  body.boundary().node_positions(body.pose(), x);
  return LAMMPS_NS::outside_box(*domain, x(Eigen::all, nodes_));
}

// LIGGGHTS loses triangles that leave the box. Every rank looks at the same pose and comes to the same end.
void CoupledMesh::check_inside_box() const {
  const footfall::DemBody& body = link_.body(body_);
  if (body.boundary().mode_count() == 0 && !is_outside(*domain, body.pose().r, reach_)) return;
  const std::string outside = outside_box();
  if (outside.empty()) return;
  throw footfall::NumericalError("t = " + footfall::number_text(static_cast<double>(update->ntimestep) * update->dt) +
                                 " s: mesh " + mesh_id_ + " (body \"" + link_.body_name(body_) + "\"), at step " +
                                 std::to_string(update->ntimestep) + ", " + outside);
}

}  // namespace LAMMPS_NS
