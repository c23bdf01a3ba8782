#include "liggghts_fix/fix_couple_mbd.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <utility>

#include "atom.h"
#include "comm.h"
#include "coupler/base/errors.h"
#include "coupler/communicator.h"
#include "coupler/interrupt.h"
#include "fix_mesh_surface.h"
#include "integrate.h"
#include "liggghts_fix/fix_couple_mbd_ahead.h"
#include "liggghts_fix/fix_couple_mbd_grains.h"
#include "liggghts_fix/fix_couple_mbd_match.h"
#include "liggghts_fix/fix_couple_mbd_restart.h"
#include "liggghts_fix/fix_couple_mbd_script.h"
#include "liggghts_fix/fix_couple_mbd_static.h"
#include "liggghts_fix/liggghts_access.h"
#include "liggghts_fix/mesh_order.h"
#include "modify.h"
#include "output.h"
#include "signal_handling.h"
#include "tri_mesh.h"
#include "universe.h"
#include "update.h"

namespace LAMMPS_NS {
namespace {

using footfall::InputError;

// Places of f_ID[...], from 0.
enum Figure { kWindows, kEnergyResidual, kWork, kOverlap, kContacts, kOutputs };

}  // namespace

FixCoupleMbd::FixCoupleMbd(LAMMPS* lmp_, int narg, char** arg)
    : Fix(lmp_, narg, arg), link_(footfall::dem_link_of(lmp_)), arguments_(narg, arg) {
  if (modify->n_fixes_style_strict(style) > 0)
    throw InputError(arguments_.fix + "there is one already; name all meshes in it");
  if (link_.started()) throw InputError(arguments_.fix + "the coupling has run already and cannot be set up anew");
  if (arguments_.patience) link_.set_patience(*arguments_.patience);
  link_.set_max_lost(arguments_.max_lost);
  for (const footfall::MeshOfBody& pair : arguments_.meshes)
    meshes_.push_back(std::make_unique<CoupledMesh>(lmp_, arguments_.fix, pair, link_));
  for (const auto& mesh : meshes_) {
    std::vector<PartOfSurface> parts;
    for (const auto& other : meshes_)
      if (other->body() == mesh->body()) parts.push_back({other->id(), other->corners()});
    check_whole_surface(link_.scene_body(link_.body_name(mesh->body()), update->unit_style).boundary, parts);
    link_.touch_surface(mesh->body());
  }

  vector_flag = 1;
  size_vector = kOutputs;
  extvector = 0;
  array_flag = 1;
  size_array_rows = link_.body_count();
  size_array_cols = 6;
  extarray = 0;
  global_freq = 1;
  time_depend = 1;
  nevery = 1;  // end_of_step
}

FixCoupleMbd::~FixCoupleMbd() { footfall::move_behind_pairs(lmp, nullptr); }

int FixCoupleMbd::setmask() { return FixConst::INITIAL_INTEGRATE | FixConst::FINAL_INTEGRATE | FixConst::END_OF_STEP; }

void FixCoupleMbd::post_create() {
  for (const auto& mesh : meshes_) mesh->attach();
  if (link_.resumed()) expect_held_forces(lmp);
}

void FixCoupleMbd::pre_delete(bool unfixed) {
  if (!unfixed) return;  // LIGGGHTS goes down, and the meshes may have gone first
  for (const auto& mesh : meshes_) mesh->detach();
  link_.uncoupled_by(std::string("unfix ") + id);
}

void FixCoupleMbd::init() {
  const std::string& where = arguments_.fix;
  if (std::strcmp(update->integrate_style, "verlet") != 0)
    throw InputError(where + "run_style " + update->integrate_style + " is not supported; use run_style verlet");
  if (modify->timing > 1)
    throw InputError(where + "modify_timing verbose waits for all programs of the run and would hang here; use `on`");
  for (const auto& mesh : meshes_)
    if (!mesh->is_there())
      throw InputError(where + "mesh " + mesh->id() + " was removed by `unfix`; unfix " + id + " first");
  if (link_.body_count() == 0)
    throw InputError(where + "no body to couple: name meshes here, or beams with fix wall/gran/beam");
  check_grains(lmp, where);
  footfall::Start script;
  script.dt = update->dt;
  script.n = arguments_.every;
  script.step = update->ntimestep;
  script.may_end_early = !arguments_.end_of_scene;
  script.requires_masses = arguments_.mass_of_pair;
  const std::string version = universe->version;  // "Version LIGGGHTS-PUBLIC 3.8.0, compiled ..."
  const std::size_t name = version.find("LIGGGHTS");
  script.dem_version = name == std::string::npos ? version : version.substr(name, version.find(',') - name);
  compare_gravity_ =
      arguments_.gravity_of_scene && !read_gravity(*modify, script) && !link_.started() && !link_.resumed();
  warn_of_clumps(*modify, script);
  if (!link_.started()) {
    warn_of_liquid_on_walls(*modify, script);
    warn_of_still_spheres(lmp, script);
    warn_of_radius(lmp, script);
    script.walls = static_walls(*modify, world, script.warnings);
  } else {
    for (const std::string& wall : gone_walls(*modify, link_.script_walls())) link_.wall_is_gone(wall);
  }
  const bool first_run = !link_.started();
  link_.start(std::move(script));
  footfall::work_is_under_way();
  rows_of_output_.clear();
  const auto add_row = [this](int body) {
    if (std::find(rows_of_output_.begin(), rows_of_output_.end(), body) == rows_of_output_.end())
      rows_of_output_.push_back(body);
  };
  for (const auto& mesh : meshes_) add_row(mesh->body());
  for (int body = 0; body < link_.body_count(); ++body) add_row(body);
  size_array_rows = link_.body_count();
  for (const auto& mesh : meshes_) mesh->begin_run(style, torque_before_, arguments_);
  go_ahead_or_wait(first_run);
  link_.expect_set_up();
  if (first_run && link_.resumed()) link_.stand_as_kept(comm->me == 0);
}

void FixCoupleMbd::go_ahead_or_wait(bool tell) {
  const std::string why = why_grains_wait(lmp);
  grains_go_ahead_ = why.empty();
  footfall::move_behind_pairs(lmp, grains_go_ahead_ ? this : nullptr);
  if (!tell || comm->me != 0) return;
  const std::string said =
      std::string("fix ") + id + " (couple/mbd): " +
      (why.empty() ? "grains go ahead while the mechanism moves\n"
                   : "grains wait for the mechanism at the start of each window, because of " + why + "\n");
  for (FILE* const out : {screen, logfile})
    if (out != nullptr) std::fputs(said.c_str(), out);
}

void FixCoupleMbd::initial_integrate(int) {
  if (update->dt != link_.dt())
    throw InputError(arguments_.fix +
                     "the time step has changed within the run (fix dt/reset?): the windows of the "
                     "coupling need one time step; use a fixed `timestep`");
  if (compare_gravity_) link_.hold_against_scene(gravity_now(*modify));  // its variables have values now
  compare_gravity_ = false;
  if (!grains_go_ahead_) move_boundaries();
}

void FixCoupleMbd::move_boundaries() {
  link_.begin_substep(update->ntimestep);
  for (const auto& mesh : meshes_) {
    mesh->check_inside_box();
    mesh->move();
  }
  // The scene is the truth for the length of the run: the run loop stops after this step, whose thermo line LIGGGHTS
  // writes when it asks in time, at its neighbour lists.
  if (!link_.in_last_substep() || update->ntimestep >= update->laststep) return;
  SignalHandler::request_quit = true;
  output->restart_requested(update->ntimestep);
}

void FixCoupleMbd::final_integrate() {
  if (!link_.end_substep()) return;
  walls_.look(*modify, link_, link_.time());
  link_.write_shares(atom->nlocal, footfall::interrupted() != 0, row_);
  gather(row_);
  link_.finish_window(rows_, comm->nprocs);
}

// In the order of the ranks: the same bits on all.
std::vector<double> FixCoupleMbd::sum_over_ranks(const std::vector<double>& row) {
  gather(row);
  std::vector<double> sum(row.size(), 0.0);
  for (std::size_t i = 0; i < rows_.size(); ++i) sum[i % row.size()] += rows_[i];
  return sum;
}

// rows_: one behind the other.
void FixCoupleMbd::gather(const std::vector<double>& row) {
  rows_.resize(row.size() * static_cast<std::size_t>(comm->nprocs));
  const int count = static_cast<int>(row.size());
  footfall::check_mpi(MPI_Allgather(row.data(), count, MPI_DOUBLE, rows_.data(), count, MPI_DOUBLE, world),
                      "MPI_Allgather");
}

void FixCoupleMbd::end_of_step() {
  if (const std::string folder = link_.checkpoint(); !folder.empty()) keep(folder);
}

void FixCoupleMbd::keep(const std::string& folder) {
  const bool quietly = link_.keeps_quietly();
  const std::string file = folder + "/grains.restart";
  link_.keep_standing(sum_over_ranks(link_.standing()));
  const bool done = !quietly || keep_grains_quietly(lmp, file);
  if (!quietly) keep_grains(lmp, file);
  if (done) keep_text(lmp, footfall::DemLink::memory_file(folder), link_.memory(update->ntimestep));
  link_.kept(update->ntimestep, done);
  if (quietly) return;
  go_on_as_after_restart();
  link_.stand_as_kept(comm->me == 0);
}

// A restart file brings the grains into another order and lists and contacts are made anew when it is read: here the same
// is done, as by `write_restart` between two `run`, so that this run and the resumed one go on alike.
void FixCoupleMbd::go_on_as_after_restart() {
  for (int i = 0; i < modify->nfix; ++i)
    if (auto* mesh = dynamic_cast<FixMeshSurface*>(modify->fix[i])) order_as_after_restart(mesh->triMesh());
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

double FixCoupleMbd::compute_vector(int n) {
  switch (static_cast<Figure>(n)) {
    case kWindows: return static_cast<double>(link_.windows());
    case kEnergyResidual: return link_.energy_residual();
    case kWork: return link_.work();
    case kOverlap: return link_.max_overlap_over_radius();
    case kContacts:
    case kOutputs: break;
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
