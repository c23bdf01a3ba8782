// The hooks of LIGGGHTS: init sends Start; a step moves the boundaries, before or after the pair forces; final_integrate
// ends the DEM step and, with the last DEM step of a window, sends the load; end_of_step writes checkpoints.

#include "liggghts_fix/couple/fix_couple_mbd.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "atom.h"
#include "comm.h"
#include "coupler/base/errors.h"
#include "coupler/base/interrupt.h"
#include "coupler/communicator.h"
#include "fix_mesh_surface.h"
#include "integrate.h"
#include "liggghts_fix/access/liggghts_access.h"
#include "liggghts_fix/couple/grain_checkpoint.h"
#include "liggghts_fix/couple/script_checks.h"
#include "liggghts_fix/link/codes.h"
#include "modify.h"
#include "output.h"
#include "signal_handling.h"
#include "tri_mesh.h"
#include "universe.h"
#include "update.h"

namespace LAMMPS_NS {
namespace {

using footfall::InputError;
namespace code = footfall::code;

// Index of f_ID[...], from 0.
constexpr int kForceAndMoment = 6;  // columns of f_ID before the modal forces
enum OutputIndex { kWindows, kEnergyResidual, kWork, kOverlap, kContacts, kInserted, kLeft, kChanged, kOutputs };

}  // namespace

FixCoupleMbd::FixCoupleMbd(LAMMPS* lmp_, int narg, char** arg)
    : Fix(lmp_, narg, arg),
      link_(footfall::dem_link_of(lmp_)),
      arguments_(narg, arg),
      fast_grains_(lmp_, link_),
      grain_changes_(lmp_, link_) {
  if (modify->n_fixes_style_strict(style) > 0)
    throw InputError(code::kSecondCoupling, arguments_.fix, "the script has one already; name all meshes in it");
  if (link_.started())
    throw InputError(code::kCouplingAfterRun, arguments_.fix,
                     "the coupling has run already and cannot be defined again");
  if (arguments_.patience) link_.handshake().set_patience(*arguments_.patience);
  link_.grains().set_max_lost(arguments_.max_lost);
  if (arguments_.outflow) link_.grains().expect_outflow();
  for (const footfall::MeshOfBody& pair : arguments_.meshes)
    meshes_.push_back(std::make_unique<CoupledMesh>(lmp_, arguments_.fix, pair, link_));
  for (const auto& mesh : meshes_) {
    std::vector<PartOfSurface> parts;
    for (const auto& other : meshes_)
      if (other->body() == mesh->body()) parts.push_back({other->id(), other->corners()});
    const std::string& body = link_.bodies().name(mesh->body());
    require_whole_surface(link_.bodies().scene_body(body, update->unit_style).boundary, parts);
    link_.bodies().touch_surface(mesh->body());
  }

  vector_flag = 1;
  size_vector = kOutputs;
  extvector = 0;
  array_flag = 1;
  size_array_rows = link_.bodies().count();
  size_array_cols = kForceAndMoment + link_.bodies().most_modes();
  extarray = 0;
  global_freq = 1;
  time_depend = 1;
  nevery = 1;  // end_of_step
}

FixCoupleMbd::~FixCoupleMbd() {
  footfall::set_listener<footfall::DeferredBoundaryMotion>(lmp, nullptr);
  footfall::set_listener<footfall::SetUpListener>(lmp, nullptr);
}

int FixCoupleMbd::setmask() { return FixConst::INITIAL_INTEGRATE | FixConst::FINAL_INTEGRATE | FixConst::END_OF_STEP; }

void FixCoupleMbd::post_create() {
  for (const auto& mesh : meshes_) mesh->attach();
  if (link_.resumed()) create_held_forces(lmp);
  footfall::set_listener<footfall::SetUpListener>(lmp, this);
}

void FixCoupleMbd::pre_delete(bool unfixed) {
  if (!unfixed) return;  // LIGGGHTS ends, and the meshes may be gone already
  for (const auto& mesh : meshes_) mesh->detach();
  link_.uncoupled_by(std::string("unfix ") + id);
}

void FixCoupleMbd::init() {
  const std::string& where = arguments_.fix;
  if (std::strcmp(update->integrate_style, "verlet") != 0)
    throw InputError(code::kRunStyleUnsupported, where, "run_style ", update->integrate_style,
                     " is not supported; use run_style verlet");
  if (modify->timing > 1)
    throw InputError(code::kModifyTimingVerbose, where,
                     "modify_timing verbose would wait for mbd_solver and hang; use modify_timing on");
  for (const auto& mesh : meshes_)
    if (!mesh->is_there())
      throw InputError(code::kCoupledMeshRemoved, where, "mesh ", mesh->id(), " was removed by `unfix`; unfix ", id,
                       " first");
  if (link_.bodies().count() == 0)
    throw InputError(code::kNoBodyCoupled, where,
                     "no body to couple: name meshes here, or beams with fix wall/gran/beam");
  check_grains(lmp, where);
  const bool first_run = !link_.started();
  link_.start(describe_script());
  footfall::work_is_under_way();
  number_output_rows();
  grain_changes_.initialized();
  for (const auto& mesh : meshes_) mesh->begin_run(style, torque_before_, arguments_);
  overlap_or_wait(first_run);
  link_.window().opening_forces().expect_set_up();
  if (first_run && link_.resumed()) link_.window().opening_forces().restore(comm->me == 0);
}

footfall::Start FixCoupleMbd::describe_script() {
  footfall::Start script;
  script.dt = update->dt;
  script.n = arguments_.every;
  script.step = update->ntimestep;
  script.may_end_early = !arguments_.end_of_scene;
  script.requires_masses = arguments_.mass_of_pair;
  const std::string version = universe->version;  // "Version LIGGGHTS-PUBLIC 3.8.0, compiled ..."
  const std::size_t name = version.find("LIGGGHTS");
  script.dem_version = name == std::string::npos ? version : version.substr(name, version.find(',') - name);
  compares_gravity_ =
      arguments_.gravity_of_scene && !read_gravity(*modify, script) && !link_.started() && !link_.resumed();
  warn_of_clumps(*modify, script);
  if (!link_.started()) {
    warn_of_liquid_on_walls(*modify, script);
    warn_of_spheres_at_rest(lmp, script);
    warn_of_radius(lmp, script);
    script.walls = static_walls(*modify, world, script.warnings);
  } else {
    for (const std::string& wall : gone_walls(*modify, link_.handshake().script().walls)) {
      link_.handshake().forget_wall(wall);
      link_.window().wall_is_gone(wall);
    }
  }
  return script;
}

void FixCoupleMbd::number_output_rows() {
  output_rows_.clear();
  const auto add_row = [this](int body) {
    if (std::find(output_rows_.begin(), output_rows_.end(), body) == output_rows_.end()) output_rows_.push_back(body);
  };
  for (const auto& mesh : meshes_) add_row(mesh->body());
  for (int body = 0; body < link_.bodies().count(); ++body) add_row(body);
  size_array_rows = link_.bodies().count();
  size_array_cols = kForceAndMoment + link_.bodies().most_modes();
}

// The first part of a step (positions of the grains, neighbour lists, pair forces) does not depend on the bodies. Where
// nothing else prevents it, that part overlaps with the mechanism's step, and the rank waits for the motion afterwards.
void FixCoupleMbd::overlap_or_wait(bool report) {
  const std::string obstacle = overlap_obstacle(lmp);
  overlaps_ = obstacle.empty();
  footfall::set_listener<footfall::DeferredBoundaryMotion>(lmp, overlaps_ ? this : nullptr);
  if (!report || comm->me != 0) return;
  const std::string text = footfall::concat(
      "fix ", id, " (couple/mbd): ",
      overlaps_ ? "pair forces of the grains overlap with the mechanism's step\n"
                : "grains wait for the mechanism at the start of each window, because of " + obstacle + "\n");
  for (FILE* const out : {screen, logfile})
    if (out != nullptr) std::fputs(text.c_str(), out);
}

void FixCoupleMbd::initial_integrate(int) {
  if (update->dt != link_.handshake().script().dt)
    throw InputError(code::kTimeStepChanged, arguments_.fix,
                     "the time step changed within the run (fix dt/reset?), but the coupling needs one time step; use "
                     "a fixed `timestep`");
  if (compares_gravity_)
    link_.handshake().require_scene_gravity(gravity_now(*modify));  // its variables have values now
  compares_gravity_ = false;
  grain_changes_.run_begins();
  if (!overlaps_) move_boundaries();
}

void FixCoupleMbd::move_boundaries() {
  link_.window().begin_substep(update->ntimestep);
  for (const auto& mesh : meshes_) {
    mesh->check_inside_box();
    mesh->move();
  }
  fast_grains_.check();
  // The scene determines the length of the run: the run loop stops after this step. LIGGGHTS writes the thermo line of
  // this step only if the request comes in time, which restart_requested does.
  if (!link_.window().in_last_substep() || (update->ntimestep >= update->laststep && !link_.runs().repeats())) return;
  SignalHandler::request_quit = true;
  output->restart_requested(update->ntimestep);
}

void FixCoupleMbd::final_integrate() {
  if (!link_.window().end_substep()) return;
  crossings_.check(*modify, link_, link_.window().time());
  link_.window().write_shares(atom->nlocal, footfall::interrupted() != 0, row_);
  gather(row_);
  link_.window().finish_window(rows_, comm->nprocs);
}

// In the order of the ranks: the same bits on all.
std::vector<double> FixCoupleMbd::sum_over_ranks(const std::vector<double>& row) {
  gather(row);
  std::vector<double> sum(row.size(), 0.0);
  for (std::size_t i = 0; i < rows_.size(); ++i) sum[i % row.size()] += rows_[i];
  return sum;
}

// Into rows_, in the order of the ranks.
void FixCoupleMbd::gather(const std::vector<double>& row) {
  rows_.resize(row.size() * static_cast<std::size_t>(comm->nprocs));
  const int count = static_cast<int>(row.size());
  footfall::check_mpi(MPI_Allgather(row.data(), count, MPI_DOUBLE, rows_.data(), count, MPI_DOUBLE, world),
                      "MPI_Allgather");
}

void FixCoupleMbd::end_of_step() {
  if (const std::string folder = link_.window().checkpoint_folder(); !folder.empty()) write_checkpoint(folder);
}

void FixCoupleMbd::write_checkpoint(const std::string& folder) {
  const bool undisturbed = link_.window().checkpoint_undisturbed();
  const std::string file = footfall::DemCheckpoint::restart_file(folder);
  link_.window().opening_forces().store(sum_over_ranks(link_.window().opening_forces().of_this_rank()));
  const bool done = !undisturbed || write_grains_undisturbed(lmp, file);
  if (!undisturbed) write_grains(lmp, file);
  if (done) write_text(lmp, footfall::DemCheckpoint::file(folder), link_.checkpoint_text(update->ntimestep));
  link_.window().checkpoint_done(update->ntimestep, done);
  if (undisturbed) return;
  continue_as_after_restart();
  link_.window().opening_forces().restore(comm->me == 0);
}

void FixCoupleMbd::set_up_done() {
  return_held_forces(lmp);
  link_.grains().count_changes();
}

// When a restart file is read, the grains get another order, and lists and contacts are created anew. Here the same is
// done, as by `write_restart` between two `run`, so that this run and the resumed one continue alike.
void FixCoupleMbd::continue_as_after_restart() {
  for (int i = 0; i < modify->nfix; ++i)
    if (auto* mesh = dynamic_cast<FixMeshSurface*>(modify->fix[i])) {
      order_as_after_restart(mesh->triMesh());
      mesh->next_reneighbor =
          -1;  // a mesh that has moved far requests new lists in the next step, but setup makes them
    }
  lmp->init();
  update->integrate->setup();
}

void FixCoupleMbd::order_as_after_restart(TriMesh* mesh) const {
  const int own = mesh->sizeLocal();
  int until = 0, all = 0;  // of the ranks up to this one, of all
  footfall::check_mpi(MPI_Scan(&own, &until, 1, MPI_INT, MPI_SUM, world), "MPI_Scan");
  footfall::check_mpi(MPI_Allreduce(&own, &all, 1, MPI_INT, MPI_SUM, world), "MPI_Allreduce");
  if (own < all) footfall::reorder_mesh(mesh, footfall::order_after_restart(until - own, own, all - until));
}

void FixCoupleMbd::post_run() { grain_changes_.run_ended(); }

// In the order of the ranks.
double FixCoupleMbd::over_ranks(double share) { return sum_over_ranks({share}).front(); }

double FixCoupleMbd::compute_vector(int n) {
  switch (static_cast<OutputIndex>(n)) {
    case kWindows: return static_cast<double>(link_.window().count());
    case kEnergyResidual: return link_.window().work().residual();
    case kWork: return link_.window().work().all;
    case kOverlap: return link_.window().max_overlap_over_radius();
    case kInserted: return over_ranks(link_.grains().changes_here().inserted) + link_.grains().changes().inserted;
    case kLeft: return over_ranks(link_.grains().changes_here().left) + link_.grains().changes().left;
    case kChanged: return over_ranks(link_.grains().changes_here().changed) + link_.grains().changes().changed;
    case kContacts:
    case kOutputs: break;
  }
  double contacts = 0.0;
  if (link_.started())
    for (int i = 0; i < link_.bodies().count(); ++i)
      contacts += static_cast<double>(link_.window().body(i).load().contacts);
  return contacts;
}

double FixCoupleMbd::compute_array(int i, int j) {
  if (!link_.started()) return 0.0;
  const footfall::DemBody& body = link_.window().body(output_rows_[i]);
  if (j < 3) return body.load().mean.F_W[j];
  if (j < kForceAndMoment) return body.mean_moment_W()[j - 3];
  const Eigen::VectorXd& Q_a = body.load().mean.Q_a;
  return j - kForceAndMoment < Q_a.size() ? Q_a[j - kForceAndMoment] : 0.0;  // others have more modes
}

}  // namespace LAMMPS_NS
