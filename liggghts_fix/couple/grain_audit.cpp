// Compares the forces on the grains before and after each source of a step; long double, because the sums over many grains
// nearly cancel.

#include "liggghts_fix/couple/grain_audit.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>
#include <vector>

#include "atom.h"
#include "comm.h"
#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/communicator.h"
#include "coupler/programs.h"
#include "domain.h"
#include "fix_gravity.h"
#include "fix_mesh_surface.h"
#include "fix_multisphere.h"
#include "fix_wall_gran.h"
#include "liggghts_fix/access/liggghts_access.h"
#include "liggghts_fix/contact/fix_wall_gran_beam.h"
#include "liggghts_fix/contact/wall_observers.h"
#include "liggghts_fix/link/codes.h"
#include "modify.h"
#include "update.h"

namespace LAMMPS_NS {
namespace {

bool is_coupled(FixMeshSurface* mesh) { return mesh->get_module(footfall::kMeshModule) != nullptr; }

// Numbers of meshes of a wall that bodies move, and of other meshes.
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
  footfall::set_listener<footfall::ForceListener>(lmp, this);
  if (comm->me != 0) return;
  std::remove(file.c_str());  // perhaps a link, in a folder of someone else
  file_.open(file);
  if (!file_) throw footfall::InputError(footfall::code::kAuditNotWritten, file + ": cannot be written");
  file_.precision(17);
  file_ << "window,kind,name,jx,jy,jz,lx,ly,lz,force,moment\n";
}

GrainAudit::~GrainAudit() { footfall::set_listener<footfall::ForceListener>(lmp, nullptr); }

GrainAudit::Source& GrainAudit::source(const std::string& kind, const std::string& name) {
  const auto [place, is_new] = places_.try_emplace(kind + " " + name, sources_.size());
  if (is_new) {
    sources_.emplace_back();
    sources_.back().kind = kind;
    sources_.back().name = name;
  }
  return sources_[place->second];
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

// For a wall that has coupled and other meshes, the loads of the other meshes are observed at their contacts.
void GrainAudit::observe_mixed_walls() {
  for (int i = 0; i < modify->nfix; ++i) {
    auto* wall = dynamic_cast<FixWallGran*>(modify->fix[i]);
    if (wall == nullptr) continue;
    const auto [coupled, others] = coupled_and_not(*wall);
    if (coupled == 0 || others == 0 || shares_.count(wall->id) > 0) continue;
    shares_[wall->id] = MeshLoad::observe(lmp, *wall, [](FixMeshSurface* mesh) { return !is_coupled(mesh); });
  }
}

void GrainAudit::store_forces() {
  before_.resize(atom->nlocal);
  for (int i = 0; i < atom->nlocal; ++i) {
    const double *const f = atom->f[i], *const t = atom->torque[i];
    before_[i] = {f[0], f[1], f[2], t[0], t[1], t[2]};
  }
}

void GrainAudit::add_source(Source& source) const {
  source.now.setZero();
  source.gross_force = source.gross_moment = 0.0L;
  for (int i = 0; i < atom->nlocal; ++i) {
    const double* const before = before_[i].data();
    const Vector f = wide(atom->f[i]) - wide(before), t = wide(atom->torque[i]) - wide(before + 3);
    if (f.isZero(0.0L) && t.isZero(0.0L)) continue;
    const Vector arm = wide(atom->x[i]).cross(f);
    source.now.head<3>() += f;
    source.now.tail<3>() += arm + t;
    source.gross_force += f.norm();
    source.gross_moment += arm.norm() + t.norm();
  }
}

void GrainAudit::pair_forces_done(bool set_up) {
  if (!link_.started()) return;
  if (set_up) {
    find_integrators();
    observe_mixed_walls();
    // A new run: sources that were removed have no effect any more.
    for (Source& one : sources_) {
      one.now.setZero();
      one.gross_force = one.gross_moment = 0.0L;
    }
  }
  for (auto& [id, share] : shares_) share->setZero();
  before_.assign(atom->nlocal, {});
  add_source(source("pairs", "-"));
  store_forces();
}

void GrainAudit::fix_force_done(Fix& fix) {
  if (!link_.started()) return;
  const std::string kind = kind_of(fix);
  if (kind == "fix" && (modify->fmask[modify->my_index(&fix)] & FixConst::POST_FORCE) == 0) return;
  const auto share = shares_.find(fix.id);
  Source& one = source(kind, fix.id);
  add_source(one);
  store_forces();
  if (share == shares_.end()) return;
  one.now -= *share->second;
  source("wall", std::string(fix.id) + " (meshes of no body)").set(*share->second);
}

void GrainAudit::count_held() {
  Wrench held = Wrench::Zero();
  for (int i = 0; i < atom->nlocal; ++i) {
    const Vector f = wide(atom->f[i]), x = wide(atom->x[i]);
    if (!is_integrated(i)) held.head<3>() -= f, held.tail<3>() -= x.cross(f);
    if (!is_rotated(i)) held.tail<3>() -= wide(atom->torque[i]);
  }
  source("held", "-").set(held);
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
    source("weight", gravity->id).set(weight);
    for (int body = 0; clumps_ != nullptr && body < clumps_->n_body(); ++body) {
      double x[3];
      clumps_->data().xcm(x, body);
      const Vector mg = static_cast<Real>(clumps_->data().mass(body)) * g;
      of_clumps.head<3>() += mg;
      of_clumps.tail<3>() += wide(x).cross(mg);
    }
  }
  if (clumps_ == nullptr) return;
  source("gravity", clumps_->id).set(of_clumps);
  source("weight", clumps_->id).set(of_clumps);
}

void GrainAudit::count_bodies() {
  for (int i = 0; i < link_.bodies().count(); ++i) {
    const footfall::DemBody& body = link_.window().body(i);
    const footfall::GeneralizedForce& Q = body.contact_force();
    const Vector F = Q.F_W.cast<Real>(), T = Q.T_W.cast<Real>();
    const Vector r = body.pose().r.cast<Real>();
    const Real force_size = F.norm(), reach = body.boundary().rho0().colwise().norm().maxCoeff();
    Source& about_origin = source("body", link_.bodies().name(i));
    about_origin.now << F, T + r.cross(F);
    about_origin.gross_force = force_size;
    about_origin.gross_moment = T.norm() + (r.norm() + reach) * force_size;
    Source& in_body = source("mean", link_.bodies().name(i));
    in_body.now << F, body.pose().rotation().cast<Real>().transpose() * T;
    in_body.gross_force = force_size;
    in_body.gross_moment = T.norm() + reach * force_size;
  }
}

void GrainAudit::all_forces_done(bool set_up) {
  if (!link_.started()) return;
  count_held();
  count_weight();
  count_bodies();
  if (set_up) {
    for (Source& one : sources_) one.advance();
    if (windows_ < 0) write_state(windows_), windows_ = 0;
    return;
  }
  const Real dt = update->dt;
  const footfall::StepWeights scheme = link_.handshake().scheme().weights();
  for (Source& one : sources_) {
    const bool by_scheme = one.kind == "mean";
    const Real opening = by_scheme ? scheme.opening : 0.5L, closing = by_scheme ? scheme.closing : 0.5L;
    one.impulse += dt * (opening * one.before + closing * one.now);
    one.force += 0.5L * dt * (one.gross_before[0] + one.gross_force);
    one.moment += 0.5L * dt * (one.gross_before[1] + one.gross_moment);
    one.advance();
  }
  ++steps_;
}

void GrainAudit::step_done() {
  if (!link_.started() || link_.window().count() <= windows_) return;
  const long window = static_cast<long>(windows_);
  write_sources(window);
  write_state(window);
  if (comm->me == 0 && !file_.flush())
    throw footfall::NumericalError(footfall::code::kAuditNotWritten, "the file of the audit cannot be written");
  windows_ = link_.window().count();
  steps_ = 0;
}

// --- The file: state of the grains and balance of each source at the end of a window.

void GrainAudit::write_state(long window) {
  Vector g = Vector::Zero();
  for (int k = 0; k < modify->nfix; ++k) {
    auto* gravity = dynamic_cast<FixGravity*>(modify->fix[k]);
    if (gravity == nullptr) continue;
    double g_now[3];
    gravity->get_gravity(g_now);
    g += wide(g_now);
  }
  // P, L; |m v|, |x| |m v| + |I w|; kinetic energy; m g . x; count; tags, which reveal an exchange of grains
  Eigen::Matrix<Real, 12, 1> sum = Eigen::Matrix<Real, 12, 1>::Zero();
  const auto add = [&](Real m, const Vector& x, const Vector& v, const Vector& spin, Real rotation) {
    sum.head<3>() += m * v;
    sum.segment<3>(3) += x.cross(m * v) + spin;
    sum[6] += m * v.norm();
    sum[7] += x.norm() * m * v.norm() + spin.norm();
    sum[8] += 0.5L * m * v.squaredNorm() + rotation;
    sum[9] += m * g.dot(x);
    sum[10] += 1.0L;
  };
  for (int i = 0; i < atom->nlocal; ++i) {
    if (is_clump(i) || !is_integrated(i)) continue;
    const Real m = atom->rmass[i], r = atom->radius[i];
    const Vector w = is_rotated(i) ? wide(atom->omega[i]) : Vector(Vector::Zero());
    const Real I = 0.4L * m * r * r;
    add(m, wide(atom->x[i]), wide(atom->v[i]), I * w, 0.5L * I * w.squaredNorm());
    sum[11] += atom->tag[i];
  }
  for (int body = 0; clumps_ != nullptr && body < clumps_->n_body(); ++body) {
    double x[3], v[3], w[3], spin[3];
    clumps_->data().xcm(x, body);
    clumps_->data().vcm(v, body);
    clumps_->data().omega(w, body);
    clumps_->data().angmom(spin, body);
    add(clumps_->data().mass(body), wide(x), wide(v), wide(spin), 0.5L * wide(w).dot(wide(spin)));
  }
  footfall::check_mpi(MPI_Allreduce(MPI_IN_PLACE, sum.data(), 12, MPI_LONG_DOUBLE, MPI_SUM, world), "MPI_Allreduce");
  write(window, "state", "-", sum.head<6>(), sum[6], sum[7]);
  Wrench energy = Wrench::Zero();
  energy[0] = sum[8];
  energy[1] = sum[9];
  energy[2] = sum[10];
  energy[3] = sum[11];
  write(window, "energy", "-", energy, 0.0L, 0.0L);
}

void GrainAudit::write_sources(long window) {
  std::vector<Real> row;
  for (const Source& one : sources_) {
    row.insert(row.end(), one.impulse.data(), one.impulse.data() + 6);
    row.insert(row.end(), {one.force, one.moment});
  }
  footfall::check_mpi(
      MPI_Allreduce(MPI_IN_PLACE, row.data(), static_cast<int>(row.size()), MPI_LONG_DOUBLE, MPI_SUM, world),
      "MPI_Allreduce");
  double grains = static_cast<double>(atom->nlocal);
  footfall::check_mpi(MPI_Allreduce(MPI_IN_PLACE, &grains, 1, MPI_DOUBLE, MPI_SUM, world), "MPI_Allreduce");
  const Real H = static_cast<Real>(update->dt) * steps_;
  Wrench clock;
  clock << link_.window().time(), H, 0.0L, steps_, grains,
      domain->xperiodic + 2 * domain->yperiodic + 4 * domain->zperiodic;
  write(window, "clock", "-", clock, 0.0L, 0.0L);
  for (std::size_t k = 0; k < sources_.size(); ++k) {
    const Real* const values = &row[8 * k];
    write(window, sources_[k].kind, sources_[k].name, Eigen::Map<const Wrench>(values), values[6], values[7]);
    sources_[k].impulse.setZero();
    sources_[k].force = sources_[k].moment = 0.0L;
  }
  for (int i = 0; i < link_.bodies().count(); ++i) {
    const footfall::MeanLoad& mean = link_.window().body(i).load().mean;
    Wrench load = Wrench::Zero();
    load << H * mean.F_W.cast<Real>(), H * mean.T_B.cast<Real>();
    write(window, "load", link_.bodies().name(i), load, 0.0L, 0.0L);
    load << mean.impulse_W.cast<Real>(), static_cast<Real>(mean.work), 0.0L, 0.0L;
    write(window, "impulse", link_.bodies().name(i), load, 0.0L, 0.0L);
  }
}

void GrainAudit::write(long window, const std::string& kind, const std::string& name, const Wrench& value, Real size,
                       Real size_of_moment) {
  if (comm->me != 0) return;
  file_ << window << "," << kind << "," << name;
  for (const Real x : value) file_ << "," << static_cast<double>(x);
  file_ << "," << static_cast<double>(size) << "," << static_cast<double>(size_of_moment) << "\n";
}

std::unique_ptr<GrainAudit> audit_if_required(LAMMPS* lmp, footfall::DemLink& link) {
  const char* const folder = std::getenv(footfall::kAuditFolder);
  if (folder == nullptr || !link.has_partner()) return nullptr;
  footfall::make_folder(folder);
  return std::make_unique<GrainAudit>(lmp, link, std::string(folder) + "/grains.csv");
}

}  // namespace LAMMPS_NS
