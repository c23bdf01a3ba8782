// Sums over the grains of a rank.
#include "liggghts_fix/access/grain_sum.h"

#include <cmath>

#include "atom.h"
#include "domain.h"
#include "fix_multisphere.h"
#include "modify.h"

namespace LAMMPS_NS {
namespace {

FixMultisphere* clumps_of(Modify& modify) {
  for (int i = 0; i < modify.nfix; ++i)
    if (auto* clumps = dynamic_cast<FixMultisphere*>(modify.fix[i])) return clumps;
  return nullptr;
}

bool is_outside(const Domain& domain, const double* x) {
  for (int c = 0; c < 3; ++c)
    if (!domain.periodicity[c] && (x[c] < domain.boxlo[c] || x[c] >= domain.boxhi[c])) return true;
  return false;
}

void add(GrainSum& sum, double share, double kinetic, double m, const Eigen::Vector3d& g, const double* x) {
  const double height = -m * (g[0] * x[0] + g[1] * x[1] + g[2] * x[2]);
  sum.energy += share * (kinetic + height);
  sum.size += share * (kinetic + std::abs(height));
  sum.mass += share * m;
}

double square(const double* v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

}  // namespace

// Each sphere of a clump has an equal share of it.
GrainSum sum_of_grains(LAMMPS* lmp, const Eigen::Vector3d& g, bool only_outside, double ahead) {
  const double more[3] = {ahead * g[0], ahead * g[1], ahead * g[2]};
  const Atom& atom = *lmp->atom;
  GrainSum sum;
  if (atom.rmass == nullptr || atom.radius == nullptr) return sum;
  FixMultisphere* const clumps = clumps_of(*lmp->modify);
  for (int i = 0; i < atom.nlocal; ++i) {
    if (only_outside && !is_outside(*lmp->domain, atom.x[i])) continue;
    ++sum.count;
    const int clump = clumps == nullptr || clumps->n_body() == 0 ? -1 : clumps->belongs_to(i);
    if (clump < 0) {
      const double m = atom.rmass[i], r = atom.radius[i];
      const double rotation = atom.omega == nullptr ? 0.0 : 0.4 * m * r * r * square(atom.omega[i]);
      const double v[3] = {atom.v[i][0] + more[0], atom.v[i][1] + more[1], atom.v[i][2] + more[2]};
      add(sum, 1.0, 0.5 * (m * square(v) + rotation), m, g, atom.x[i]);
      continue;
    }
    const int body = clumps->data().map(clump);
    if (body < 0) continue;  // of another rank
    double x[3], v[3], w[3], spin[3];
    clumps->data().xcm(x, body);
    clumps->data().vcm(v, body);
    clumps->data().omega(w, body);
    clumps->data().angmom(spin, body);
    for (int c = 0; c < 3; ++c) v[c] += more[c];
    const double m = clumps->data().mass(body);
    add(sum, 1.0 / clumps->data().nrigid(body),
        0.5 * (m * square(v) + w[0] * spin[0] + w[1] * spin[1] + w[2] * spin[2]), m, g, x);
  }
  return sum;
}

}  // namespace LAMMPS_NS
