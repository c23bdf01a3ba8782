#include "liggghts_fix/fix_couple_mbd_audit.h"

#include <cstdlib>
#include <cstring>
#include <utility>

#include "atom.h"
#include "comm.h"
#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/programs.h"
#include "fix_gravity.h"
#include "fix_mesh_surface.h"
#include "fix_multisphere.h"
#include "fix_wall_gran.h"
#include "liggghts_fix/fix_wall_gran_beam.h"
#include "liggghts_fix/fix_wall_share.h"
#include "modify.h"
#include "update.h"

namespace LAMMPS_NS {
namespace {

bool is_coupled(FixMeshSurface* mesh) { return mesh->get_module(footfall::kMeshModule) != nullptr; }

// Meshes of a wall that bodies move, and others.
std::pair<int, int> coupled_and_not(FixWallGran& wall) {
  std::pair<int, int> count{0, 0};
  if (!wall.is_mesh_wall()) return count;
  for (int k = 0; k < wall.n_meshes(); ++k) ++(is_coupled(wall.mesh_list()[k]) ? count.first : count.second);
  return count;
}

std::string kind_of(Fix& fix) {
  if (dynamic_cast<FixGravity*>(&fix) != nullptr) return "gravity";
  if (dynamic_cast<FixWallGranBeam*>(&fix) != nullptr) return "body_wall";
  if (auto* wall = dynamic_cast<FixWallGran*>(&fix)) return coupled_and_not(*wall).first > 0 ? "body_wall" : "wall";
  return "fix";
}

}  // namespace

GrainAudit::GrainAudit(LAMMPS* lmp_, footfall::DemLink& link, const std::string& file) : Pointers(lmp_), link_(link) {
  footfall::watch_forces(lmp, this);
  if (comm->me != 0) return;
  file_.open(file);
  if (!file_) throw footfall::InputError(file + ": cannot be written");
  file_.precision(17);
  file_ << "window,kind,name,jx,jy,jz,lx,ly,lz,force,moment\n";
}

GrainAudit::~GrainAudit() { footfall::watch_forces(lmp, nullptr); }

GrainAudit::Account& GrainAudit::account(const std::string& kind, const std::string& name) {
  const auto [place, is_new] = places_.try_emplace(kind + " " + name, accounts_.size());
  if (is_new) {
    accounts_.emplace_back();
    accounts_.back().kind = kind;
    accounts_.back().name = name;
  }
  return accounts_[place->second];
}

bool GrainAudit::is_clump(int i) const { return clumps_ != nullptr && clumps_->belongs_to(i) >= 0; }
bool GrainAudit::is_integrated(int i) const { return is_clump(i) || (atom->mask[i] & moved_by_) != 0; }
bool GrainAudit::is_rotated(int i) const { return is_clump(i) || (atom->mask[i] & turned_by_) != 0; }

void GrainAudit::find_integrators() {
  moved_by_ = turned_by_ = 0;
  clumps_ = nullptr;
  for (int i = 0; i < modify->nfix; ++i) {
    Fix& fix = *modify->fix[i];
    if (auto* clumps = dynamic_cast<FixMultisphere*>(&fix)) {
      clumps_ = clumps;
    } else if (fix.time_integrate == 1) {
      moved_by_ |= fix.groupbit;
      if (std::strstr(fix.style, "sphere") != nullptr) turned_by_ |= fix.groupbit;
    }
  }
}

// A wall whose meshes bodies move in part only: the others are told apart at their contacts.
void GrainAudit::watch_mixed_walls() {
  for (int i = 0; i < modify->nfix; ++i) {
    auto* wall = dynamic_cast<FixWallGran*>(modify->fix[i]);
    if (wall == nullptr) continue;
    const auto [coupled, others] = coupled_and_not(*wall);
    if (coupled == 0 || others == 0 || shares_.count(wall->id) > 0) continue;
    shares_[wall->id] = MeshShare::watch(lmp, *wall, [](FixMeshSurface* mesh) { return !is_coupled(mesh); });
  }
}

void GrainAudit::remember() {
  before_.resize(static_cast<std::size_t>(atom->nlocal));
  for (int i = 0; i < atom->nlocal; ++i) {
    const double *const f = atom->f[i], *const t = atom->torque[i];
    before_[static_cast<std::size_t>(i)] = {f[0], f[1], f[2], t[0], t[1], t[2]};
  }
}

void GrainAudit::add_source(Account& source) const {
  source.now.setZero();
  source.gross_force = source.gross_moment = 0.0L;
  for (int i = 0; i < atom->nlocal; ++i) {
    const double* const before = before_[static_cast<std::size_t>(i)].data();
    const Vector f = wide(atom->f[i]) - wide(before), t = wide(atom->torque[i]) - wide(before + 3);
    if (f.isZero(0.0L) && t.isZero(0.0L)) continue;
    const Vector arm = wide(atom->x[i]).cross(f);
    source.now.head<3>() += f;
    source.now.tail<3>() += arm + t;
    source.gross_force += f.norm();
    source.gross_moment += arm.norm() + t.norm();
  }
}

void GrainAudit::pairs_done(bool set_up) {
  if (!link_.started()) return;
  if (set_up) {
    find_integrators();
    watch_mixed_walls();
    // A new run: sources that are gone do nothing any more.
    for (Account& one : accounts_) {
      one.now.setZero();
      one.gross_force = one.gross_moment = 0.0L;
    }
  }
  for (auto& [id, share] : shares_) share->setZero();
  before_.assign(static_cast<std::size_t>(atom->nlocal), {});
  add_source(account("pairs", "-"));
  remember();
}

void GrainAudit::fix_done(Fix& fix) {
  if (!link_.started()) return;
  const std::string kind = kind_of(fix);
  if (kind == "fix" && (modify->fmask[modify->my_index(&fix)] & FixConst::POST_FORCE) == 0) return;
  const auto share = shares_.find(fix.id);
  Account& source = account(kind, fix.id);
  add_source(source);
  remember();
  if (share == shares_.end()) return;
  source.now -= *share->second;
  account("wall", std::string(fix.id) + " (meshes of no body)").set(*share->second);
}

void GrainAudit::count_held() {
  Wrench held = Wrench::Zero();
  for (int i = 0; i < atom->nlocal; ++i) {
    const Vector f = wide(atom->f[i]), x = wide(atom->x[i]);
    if (!is_integrated(i)) held.head<3>() -= f, held.tail<3>() -= x.cross(f);
    if (!is_rotated(i)) held.tail<3>() -= wide(atom->torque[i]);
  }
  account("held", "-").set(held);
}

// fix gravity leaves clumps to fix multisphere.
void GrainAudit::count_weight() {
  Wrench of_clumps = Wrench::Zero();
  for (int k = 0; k < modify->nfix; ++k) {
    auto* gravity = dynamic_cast<FixGravity*>(modify->fix[k]);
    if (gravity == nullptr) continue;
    double g_now[3];
    gravity->get_gravity(g_now);
    const Vector g = wide(g_now);
    Wrench weight = Wrench::Zero();
    for (int i = 0; i < atom->nlocal; ++i) {
      if ((atom->mask[i] & gravity->groupbit) == 0 || is_clump(i)) continue;
      const Vector mg = static_cast<Real>(atom->rmass[i]) * g;
      weight.head<3>() += mg;
      weight.tail<3>() += wide(atom->x[i]).cross(mg);
    }
    account("weight", gravity->id).set(weight);
    for (int body = 0; clumps_ != nullptr && body < clumps_->n_body(); ++body) {
      double x[3];
      clumps_->data().xcm(x, body);
      const Vector mg = static_cast<Real>(clumps_->data().mass(body)) * g;
      of_clumps.head<3>() += mg;
      of_clumps.tail<3>() += wide(x).cross(mg);
    }
  }
  if (clumps_ == nullptr) return;
  account("gravity", clumps_->id).set(of_clumps);
  account("weight", clumps_->id).set(of_clumps);
}

void GrainAudit::count_bodies() {
  for (int i = 0; i < link_.body_count(); ++i) {
    const footfall::DemBody& body = link_.body(i);
    const footfall::GeneralizedForce& Q = body.contact_force();
    const Vector F = Q.F_W.cast<Real>(), T = Q.T_W.cast<Real>();
    const Vector r = body.pose().r.cast<Real>();
    const Real force_size = F.norm(), reach = body.boundary().rho0().colwise().norm().maxCoeff();
    Account& about_origin = account("body", link_.body_name(i));
    about_origin.now << F, T + r.cross(F);
    about_origin.gross_force = force_size;
    about_origin.gross_moment = T.norm() + (r.norm() + reach) * force_size;
    Account& in_body = account("mean", link_.body_name(i));
    in_body.now << F, body.pose().rotation().cast<Real>().transpose() * T;
    in_body.gross_force = force_size;
    in_body.gross_moment = T.norm() + reach * force_size;
  }
}

void GrainAudit::forces_done(bool set_up) {
  if (!link_.started()) return;
  count_held();
  count_weight();
  count_bodies();
  if (set_up) {
    for (Account& one : accounts_) one.remember();
    if (windows_ < 0) write_state(windows_), windows_ = 0;
    return;
  }
  const Real dt = update->dt;
  const footfall::StepWeights scheme = link_.scheme().weights();
  for (Account& one : accounts_) {
    const bool by_scheme = one.kind == "mean";
    const Real opening = by_scheme ? scheme.opening : 0.5L, closing = by_scheme ? scheme.closing : 0.5L;
    one.impulse += dt * (opening * one.before + closing * one.now);
    one.force += 0.5L * dt * (one.gross_before[0] + one.gross_force);
    one.moment += 0.5L * dt * (one.gross_before[1] + one.gross_moment);
    one.remember();
  }
  ++steps_;
}

void GrainAudit::step_done() {
  if (!link_.started() || link_.windows() <= windows_) return;
  const long window = static_cast<long>(windows_);
  write_accounts(window);
  write_state(window);
  if (comm->me == 0 && !file_.flush()) throw footfall::NumericalError("the file of the audit cannot be written");
  windows_ = link_.windows();
  steps_ = 0;
}

std::unique_ptr<GrainAudit> audit_if_asked(LAMMPS* lmp, footfall::DemLink& link) {
  const char* const folder = std::getenv(footfall::kAuditFolder);
  if (folder == nullptr || !link.has_partner()) return nullptr;
  footfall::make_folder(folder);
  return std::make_unique<GrainAudit>(lmp, link, std::string(folder) + "/grains.csv");
}

}  // namespace LAMMPS_NS
