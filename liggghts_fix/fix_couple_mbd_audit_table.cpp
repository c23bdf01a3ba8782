// What the audit writes at the end of a window: the state of the grains, and what each source gave them.
#include <vector>

#include "atom.h"
#include "comm.h"
#include "coupler/communicator.h"
#include "domain.h"
#include "fix_gravity.h"
#include "fix_multisphere.h"
#include "liggghts_fix/fix_couple_mbd_audit.h"
#include "modify.h"
#include "update.h"

namespace LAMMPS_NS {

void GrainAudit::write_state(long window) {
  Vector g = Vector::Zero();
  for (int k = 0; k < modify->nfix; ++k) {
    auto* gravity = dynamic_cast<FixGravity*>(modify->fix[k]);
    if (gravity == nullptr) continue;
    double g_now[3];
    gravity->get_gravity(g_now);
    g += wide(g_now);
  }
  // P, L; |m v|, |x| |m v| + |I w|; kinetic energy; m g . x; how many
  Eigen::Matrix<Real, 11, 1> sum = Eigen::Matrix<Real, 11, 1>::Zero();
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
  }
  for (int body = 0; clumps_ != nullptr && body < clumps_->n_body(); ++body) {
    double x[3], v[3], w[3], spin[3];
    clumps_->data().xcm(x, body);
    clumps_->data().vcm(v, body);
    clumps_->data().omega(w, body);
    clumps_->data().angmom(spin, body);
    add(clumps_->data().mass(body), wide(x), wide(v), wide(spin), 0.5L * wide(w).dot(wide(spin)));
  }
  footfall::check_mpi(MPI_Allreduce(MPI_IN_PLACE, sum.data(), 11, MPI_LONG_DOUBLE, MPI_SUM, world), "MPI_Allreduce");
  write(window, "state", "-", sum.head<6>(), sum[6], sum[7]);
  Wrench energy = Wrench::Zero();
  energy[0] = sum[8];
  energy[1] = sum[9];
  energy[2] = sum[10];
  write(window, "energy", "-", energy, 0.0L, 0.0L);
}

void GrainAudit::write_accounts(long window) {
  std::vector<Real> row;
  for (const Account& one : accounts_) {
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
  clock << link_.time(), H, 0.0L, steps_, grains, domain->xperiodic + 2 * domain->yperiodic + 4 * domain->zperiodic;
  write(window, "clock", "-", clock, 0.0L, 0.0L);
  for (std::size_t k = 0; k < accounts_.size(); ++k) {
    const Real* const values = &row[8 * k];
    write(window, accounts_[k].kind, accounts_[k].name, Eigen::Map<const Wrench>(values), values[6], values[7]);
    accounts_[k].impulse.setZero();
    accounts_[k].force = accounts_[k].moment = 0.0L;
  }
  for (int i = 0; i < link_.body_count(); ++i) {
    const footfall::MeanLoad& mean = link_.body(i).load().mean;
    Wrench load = Wrench::Zero();
    load << H * mean.F_W.cast<Real>(), H * mean.T_B.cast<Real>();
    write(window, "load", link_.body_name(i), load, 0.0L, 0.0L);
    load << mean.impulse_W.cast<Real>(), static_cast<Real>(mean.work), 0.0L, 0.0L;
    write(window, "impulse", link_.body_name(i), load, 0.0L, 0.0L);
  }
}

void GrainAudit::write(long window, const std::string& kind, const std::string& name, const Wrench& value, Real size,
                       Real size_of_moment) {
  if (comm->me != 0) return;
  file_ << window << "," << kind << "," << name;
  for (const Real x : value) file_ << "," << static_cast<double>(x);
  file_ << "," << static_cast<double>(size) << "," << static_cast<double>(size_of_moment) << "\n";
}

}  // namespace LAMMPS_NS
