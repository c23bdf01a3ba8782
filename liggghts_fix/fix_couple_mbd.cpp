#include "liggghts_fix/fix_couple_mbd.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "atom.h"
#include "comm.h"
#include "coupler/mpi_check.h"
#include "coupler/base/errors.h"
#include "domain.h"
#include "fix_mesh_surface.h"
#include "fix_property_global.h"
#include "liggghts_fix/liggghts_access.h"
#include "modify.h"
#include "signal_handling.h"
#include "tri_mesh.h"
#include "update.h"

namespace LAMMPS_NS {
namespace {

using footfall::InputError;

constexpr const char* kModule = "footfall_mbd";
constexpr const char* kUsage = "fix ID all couple/mbd every N|auto [patience SECONDS] [mesh MESH-ID BODY ...]";

using NodeVelocities = MultiVectorContainer<double, 3, 3>;

NodeVelocities* node_velocities(TriMesh* mesh) { return mesh->prop().getElementProperty<NodeVelocities>("v"); }

}  // namespace

FixCoupleMbd::FixCoupleMbd(LAMMPS* lmp_, int narg, char** arg)
    : Fix(lmp_, narg, arg), link_(footfall::dem_link_of(lmp_)) {
  const std::string where = std::string("fix ") + id + " couple/mbd: ";
  if (modify->n_fixes_style_strict(style) > 0) throw InputError(where + "there is one already; name all meshes in it");
  if (link_.started()) throw InputError(where + "the coupling has run already and cannot be set up anew");
  if (narg < 5 || std::strcmp(arg[3], "every") != 0) throw InputError(where + "expected: " + kUsage);
  if (std::strcmp(arg[4], "auto") != 0) {
    char* rest = nullptr;
    const long n = std::strtol(arg[4], &rest, 10);
    if (*rest != '\0' || n < 1 || n > 1000000)
      throw InputError(where + "`every` needs a number of steps from 1 to 1000000 or `auto`, not \"" + arg[4] + "\"");
    every_ = static_cast<int>(n);
  }
  int next = 5;
  if (next + 1 < narg && std::strcmp(arg[next], "patience") == 0) {
    char* rest = nullptr;
    const double patience = std::strtod(arg[next + 1], &rest);
    if (*rest != '\0' || !(patience > 0.0))
      throw InputError(where + "`patience` needs a positive number of seconds, not \"" + arg[next + 1] + "\"");
    link_.set_patience(patience);
    next += 2;
  }
  for (; next + 2 < narg && std::strcmp(arg[next], "mesh") == 0; next += 3)
    meshes_.push_back(couple(arg[next + 1], arg[next + 2]));
  if (next != narg) throw InputError(where + "at \"" + arg[next] + "\" expected: " + kUsage);

  vector_flag = 1;
  size_vector = 5;
  extvector = 0;
  array_flag = 1;
  size_array_rows = link_.body_count();
  size_array_cols = 6;
  extarray = 0;
  global_freq = 1;
  time_depend = 1;
}

FixCoupleMbd::CoupledMesh FixCoupleMbd::couple(const std::string& mesh_id, const std::string& body_name) {
  const std::string where = std::string("fix ") + id + " couple/mbd: mesh " + mesh_id + ": ";
  auto* mesh_fix = dynamic_cast<FixMeshSurface*>(modify->find_fix_id(mesh_id.c_str()));
  if (mesh_fix == nullptr) throw InputError(where + "no fix mesh/surface of this id stands before this line");
  if (mesh_fix->triMesh()->isMoving() || mesh_fix->triMesh()->isDeforming())
    throw InputError(where + "another fix or a servo moves it already");
  if (mesh_fix->surfaceVel())
    throw InputError(where + "it has a surface velocity of its own (surface_vel, surface_ang_vel)");
  const int body = link_.couple(body_name, update->unit_style);
  for (const CoupledMesh& other : meshes_)
    if (other.body == body) throw InputError(where + "body \"" + body_name + "\" has a mesh already");
  const footfall::CoupledBody& scene_body = link_.scene_body(body_name, update->unit_style);
  const int nodes = scene_body.boundary.node_count();
  auto module = std::make_unique<MeshModuleMbd>(lmp, mesh_fix, match(mesh_fix, mesh_id, scene_body));
  return {mesh_fix,
          mesh_id,
          body,
          std::move(module),
          Eigen::Matrix3Xd(3, nodes),
          Eigen::Matrix3Xd(3, nodes),
          scene_body.boundary.rho0().colwise().norm().maxCoeff()};
}

// Every rank matches the triangles it owns (all of them before the first run), then the ranks share the
// result.
std::vector<footfall::CornerNodes> FixCoupleMbd::match(FixMeshSurface* mesh_fix, const std::string& mesh_id,
                                                       const footfall::CoupledBody& body) const {
  TriMesh* mesh = mesh_fix->triMesh();
  std::vector<footfall::MeshTriangle> mine(static_cast<std::size_t>(mesh->sizeLocal()));
  int highest = -1;
  for (int i = 0; i < mesh->sizeLocal(); ++i) {
    footfall::MeshTriangle& triangle = mine[static_cast<std::size_t>(i)];
    triangle.id = mesh->id(i);
    highest = std::max(highest, triangle.id);
    for (std::size_t k = 0; k < 3; ++k) triangle.corners[k] = Eigen::Vector3d(footfall::mesh_nodes(mesh)[i][k]);
  }
  std::string failure;
  std::vector<footfall::CornerNodes> corners;
  try {
    corners = footfall::match_mesh(mesh_id, body.boundary, body.initial, mine);
  } catch (const InputError& mismatch) {
    failure = mismatch.what();
  }
  // The first rank that failed speaks for all.
  int speaker = failure.empty() ? comm->nprocs : comm->me;
  MPI_Allreduce(MPI_IN_PLACE, &speaker, 1, MPI_INT, MPI_MIN, world);
  if (speaker < comm->nprocs) {
    int length = static_cast<int>(failure.size());
    MPI_Bcast(&length, 1, MPI_INT, speaker, world);
    failure.resize(static_cast<std::size_t>(length));
    MPI_Bcast(failure.data(), length, MPI_CHAR, speaker, world);
    throw InputError(failure);
  }

  MPI_Allreduce(MPI_IN_PLACE, &highest, 1, MPI_INT, MPI_MAX, world);
  std::vector<footfall::CornerNodes> all(static_cast<std::size_t>(highest + 1), footfall::CornerNodes{-1, -1, -1});
  for (std::size_t i = 0; i < mine.size(); ++i) all[static_cast<std::size_t>(mine[i].id)] = corners[i];
  MPI_Allreduce(MPI_IN_PLACE, all.data(), 3 * (highest + 1), MPI_INT, MPI_MAX, world);
  if (all.size() != body.boundary.triangles().size())
    throw InputError("mesh " + mesh_id + " has " + std::to_string(all.size()) + " triangles, body \"" +
                     body.boundary.name() + "\" of the scene has " + std::to_string(body.boundary.triangles().size()));
  return all;
}

int FixCoupleMbd::setmask() { return FixConst::INITIAL_INTEGRATE | FixConst::FINAL_INTEGRATE; }

void FixCoupleMbd::post_create() {
  for (CoupledMesh& mesh : meshes_) {
    TriMesh* tri_mesh = mesh.fix->triMesh();
    tri_mesh->registerMove(false, true, true);
    NodeVelocities* velocities = tri_mesh->prop().addElementProperty<NodeVelocities>("v", "comm_exchange_borders",
                                                                                     "frame_invariant", "restart_no");
    velocities->setAll(0.0);
    footfall::attach_mesh_module(mesh.fix, kModule, mesh.module.get());
  }
}

void FixCoupleMbd::pre_delete(bool unfixed) {
  if (!unfixed) return;  // LIGGGHTS goes down, and the meshes may have gone first
  for (CoupledMesh& mesh : meshes_) {
    footfall::detach_mesh_module(mesh.fix, kModule);
    mesh.fix->triMesh()->prop().removeElementProperty("v");
    mesh.fix->triMesh()->unregisterMove(false, true, true);
  }
}

void FixCoupleMbd::init() {
  const std::string where = std::string("fix ") + id + " couple/mbd: ";
  if (std::strcmp(update->integrate_style, "verlet") != 0)
    throw InputError(where + "run_style " + update->integrate_style + " is not supported; use run_style verlet");
  if (modify->timing > 1)
    throw InputError(where + "modify_timing verbose waits for all programs of the run and would hang here; use `on`");
  for (const CoupledMesh& mesh : meshes_)
    if (modify->find_fix_id(mesh.mesh_id.c_str()) != mesh.fix)
      throw InputError(where + "mesh " + mesh.mesh_id + " was removed by `unfix`; unfix " + id + " first");
  if (link_.body_count() == 0)
    throw InputError(where + "no body to couple: name meshes here, or beams with fix wall/gran/beam");
  link_.start(update->dt, every_, update->ntimestep);
  rows_of_output_.clear();
  for (const CoupledMesh& mesh : meshes_) rows_of_output_.push_back(mesh.body);
  for (int body = 0; body < link_.body_count(); ++body)
    if (std::find(rows_of_output_.begin(), rows_of_output_.end(), body) == rows_of_output_.end())
      rows_of_output_.push_back(body);
  size_array_rows = link_.body_count();
  for (CoupledMesh& mesh : meshes_) {
    mesh.module->set_body(&link_.body(mesh.body));
    mesh.module->set_contacts(wall_contacts(mesh.fix->atomTypeWall()));
  }
  link_.expect_set_up();
}

// 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2, 1/G* = sum of 2 (2 - nu)(1 + nu)/E, for every grain type against
// the wall, where the script gives elastic constants; else empty.
std::vector<WallContact> FixCoupleMbd::wall_contacts(int wall_type) const {
  const int types = atom->ntypes;
  const auto property = [&](const char* name, const char* kind, int columns) {
    return dynamic_cast<FixPropertyGlobal*>(
        modify->find_fix_property(name, "property/global", kind, types, columns, style, false));
  };
  FixPropertyGlobal* young = property("youngsModulus", "peratomtype", 0);
  FixPropertyGlobal* poisson = property("poissonsRatio", "peratomtype", 0);
  FixPropertyGlobal* restitution = property("coefficientRestitution", "peratomtypepair", types);
  FixPropertyGlobal* friction = property("coefficientFriction", "peratomtypepair", types);
  if (wall_type < 1 || wall_type > types) return {};
  if (FixPropertyGlobal* kn = property("kn", "peratomtypepair", types)) {
    const auto constant = [&](const char* name, int type) {
      FixPropertyGlobal* pairs = property(name, "peratomtypepair", types);
      return pairs == nullptr ? 0.0 : pairs->compute_array(type - 1, wall_type - 1);
    };
    std::vector<WallContact> result(static_cast<std::size_t>(types) + 1);
    for (int type = 1; type <= types; ++type) {
      WallContact& contact = result[static_cast<std::size_t>(type)];
      contact.linear = kn->compute_array(type - 1, wall_type - 1);
      contact.linear_shear = constant("kt", type);
      contact.linear_damping = constant("gamman", type);
      contact.linear_shear_damping = constant("gammat", type);
      contact.friction = constant("coefficientFriction", type);
    }
    return result;
  }
  if (young == nullptr || poisson == nullptr) return {};
  const auto compliance = [&](int type) {
    const double nu = poisson->compute_vector(type - 1);
    return (1.0 - nu * nu) / young->compute_vector(type - 1);
  };
  const auto shear_compliance = [&](int type) {
    const double nu = poisson->compute_vector(type - 1);
    return 2.0 * (2.0 - nu) * (1.0 + nu) / young->compute_vector(type - 1);
  };
  std::vector<WallContact> result(static_cast<std::size_t>(types) + 1);
  for (int type = 1; type <= types; ++type) {
    WallContact& contact = result[static_cast<std::size_t>(type)];
    contact.young = 1.0 / (compliance(type) + compliance(wall_type));
    contact.shear = 1.0 / (shear_compliance(type) + shear_compliance(wall_type));
    if (friction != nullptr) contact.friction = friction->compute_array(type - 1, wall_type - 1);
    if (restitution == nullptr) continue;
    const double log_e = std::log(restitution->compute_array(type - 1, wall_type - 1));
    contact.damping = -2.0 * std::sqrt(5.0 / 6.0) * log_e / std::sqrt(log_e * log_e + M_PI * M_PI);
  }
  return result;
}

void FixCoupleMbd::initial_integrate(int) {
  link_.begin_substep(update->ntimestep);
  for (CoupledMesh& mesh : meshes_) {
    check_inside_box(mesh);
    move(mesh);
  }
  // The scene is the truth for the length of the run: the run loop stops after this step.
  if (link_.in_last_substep() && update->ntimestep < update->laststep) SignalHandler::request_quit = true;
}

// Owned and ghost triangles alike: LIGGGHTS copies neither positions nor velocities to ghosts between two
// re-neighbourings.
void FixCoupleMbd::move(CoupledMesh& mesh) {
  const footfall::DemBody& body = link_.body(mesh.body);
  TriMesh* tri_mesh = mesh.fix->triMesh();
  if (body.path().steady_translation()) {
    translate(tri_mesh, body.pose().dr);
    return;
  }
  body.boundary().node_positions(body.pose(), mesh.x_W);
  body.boundary().node_velocities(body.pose(), mesh.v_W);
  const std::vector<footfall::CornerNodes>& corners = mesh.module->corners();
  double*** x = footfall::mesh_nodes(tri_mesh);
  double** center = footfall::mesh_centers(tri_mesh);
  double*** v = node_velocities(tri_mesh)->begin();
  for (int i = 0; i < tri_mesh->size(); ++i) {
    const footfall::CornerNodes& corner = corners[static_cast<std::size_t>(tri_mesh->id(i))];
    for (int k = 0; k < 3; ++k) {
      const int node = corner[static_cast<std::size_t>(k)];
      std::copy_n(mesh.v_W.col(node).data(), 3, v[i][k]);
      for (int c = 0; c < 3; ++c) x[i][k][c] = nearest_image(mesh.x_W(c, node), x[i][k][c], c);
    }
    for (int c = 0; c < 3; ++c) center[i][c] = (x[i][0][c] + x[i][1][c] + x[i][2][c]) / 3.0;
  }
  if (body.path().first_substep()) turn_properties(mesh, body.path().jump());
  turn_properties(mesh, body.path().last_step());
  if (body.boundary().mode_count() > 0) footfall::recalculate_mesh(tri_mesh);
}

// The same sums as fix move/mesh linear, so that the same motion gives the same bits.
void FixCoupleMbd::translate(TriMesh* mesh, const Eigen::Vector3d& velocity) const {
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

// In a periodic direction a triangle may stand one or more boxes away from its body's own place: it stays
// there.
double FixCoupleMbd::nearest_image(double place, double before, int direction) const {
  if (!domain->periodicity[direction]) return place;
  const double box = domain->boxhi[direction] - domain->boxlo[direction];
  return place + box * std::round((before - place) / box);
}

// Normals and edges turn with the body, the mesh's reference point (fix mesh/surface/stress) moves with it;
// areas and lengths stay. LIGGGHTS computes all of them anew from the nodes at every re-neighbouring, so
// round-off does not add up for long.
void FixCoupleMbd::turn_properties(CoupledMesh& mesh, const footfall::BoundaryStep& step) {
  CustomValueTracker& properties = mesh.fix->triMesh()->prop();
  if (step.theta_W.isZero(0.0)) {
    if (!step.r.isZero(0.0)) properties.move(step.r.data());
    return;
  }
  const footfall::BodyMotion& pose = link_.body(mesh.body).pose();
  const Eigen::Vector3d from_Bo = step.r - pose.r;  // minus Bo before the step
  const Eigen::Vector4d turn = footfall::turned(Eigen::Vector4d(1.0, 0.0, 0.0, 0.0), step.theta_W);
  properties.move(from_Bo.data());
  properties.rotate(turn.data());
  properties.move(pose.r.data());
}

// LIGGGHTS loses triangles that leave the box. Every rank looks at the same pose and comes to the same end.
void FixCoupleMbd::check_inside_box(const CoupledMesh& mesh) const {
  const footfall::DemBody& body = link_.body(mesh.body);
  const auto outside = [this](const Eigen::Vector3d& x, double margin) {
    for (int c = 0; c < 3; ++c) {
      if (domain->periodicity[c]) continue;
      // shrink-wrapped
      const bool follows_low = domain->boundary[c][0] > 1, follows_high = domain->boundary[c][1] > 1;
      if ((!follows_low && x[c] - margin < domain->boxlo[c]) || (!follows_high && x[c] + margin > domain->boxhi[c]))
        return true;
    }
    return false;
  };
  if (body.boundary().mode_count() == 0 && !outside(body.pose().r, mesh.reach)) return;
  Eigen::Matrix3Xd x(3, body.boundary().node_count());
  body.boundary().node_positions(body.pose(), x);
  for (int j = 0; j < x.cols(); ++j)
    if (outside(x.col(j), 0.0)) {
      std::ostringstream message;
      message << "t = " << static_cast<double>(update->ntimestep) * update->dt << " s: mesh " << mesh.mesh_id
              << " (body \"" << link_.body_name(mesh.body) << "\") leaves the simulation box at step "
              << update->ntimestep << ": node at (" << x(0, j) << ", " << x(1, j) << ", " << x(2, j) << "), box from ("
              << domain->boxlo[0] << ", " << domain->boxlo[1] << ", " << domain->boxlo[2] << ") to ("
              << domain->boxhi[0] << ", " << domain->boxhi[1] << ", " << domain->boxhi[2]
              << "). Make the region of create_box larger";
      throw footfall::NumericalError(message.str());
    }
}

void FixCoupleMbd::final_integrate() {
  if (!link_.end_substep()) return;
  link_.write_sums(sums_);
  rows_.resize(sums_.size() * static_cast<std::size_t>(comm->nprocs));
  const int count = static_cast<int>(sums_.size());
  footfall::check_mpi(MPI_Allgather(sums_.data(), count, MPI_DOUBLE, rows_.data(), count, MPI_DOUBLE, world),
                      "MPI_Allgather");
  link_.finish_window(rows_, comm->nprocs, atom->natoms);
}

double FixCoupleMbd::compute_vector(int n) {
  switch (n) {
    case 0: return static_cast<double>(link_.windows());
    case 1: return link_.energy_residual();
    case 2: return link_.work();
    case 3: return link_.max_overlap_over_radius();
    default: break;
  }
  double contacts = 0.0;
  if (link_.started())
    for (int i = 0; i < link_.body_count(); ++i) contacts += static_cast<double>(link_.body(i).load().contacts);
  return contacts;
}

double FixCoupleMbd::compute_array(int i, int j) {
  if (!link_.started()) return 0.0;
  const footfall::DemBody& body = link_.body(rows_of_output_[static_cast<std::size_t>(i)]);
  return j < 3 ? body.load().mean.F_W[j] : body.mean_moment_W()[j - 3];
}

}  // namespace LAMMPS_NS
