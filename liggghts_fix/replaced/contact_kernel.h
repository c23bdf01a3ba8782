#pragma once
// The contact models hertz, history and cdt of LIGGGHTS 3.8.0 (theory 5), for several contacts in each instruction, in the
// precision of LIGGGHTS or in single precision. In double precision every operation is taken from the models, in their order,
// and results are equal to the bit. Included by one file, which is compiled without fused operations.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <type_traits>

#define FOOTFALL_INLINE inline __attribute__((always_inline))

namespace footfall {

struct PairModel {
  double** young;
  double** rigidity;
  double** damping;
  double** friction;
  double** rolling;  // null: no rolling model
  int offset;        // of the shear displacement in the history of a contact
  bool tangential_damping, limit_force, torsion;
  bool known;  // nothing of it is beyond what is computed here
};

// One contact of grains i and j.
template <class Real>
struct Contact {
  Real delta[3], square;  // x_i - x_j [m], square of its length
  Real excess;            // in single precision: (R_i + R_j)^2 - square [m2]
  Real radius_i, radius_j, mass_i, mass_j;
  Real velocity[3];                                  // v_i - v_j [m/s]
  Real spin_i[3], spin_j[3];                         // [rad/s]
  Real young, rigidity, damping, friction, rolling;  // E, G [Pa], beta and coefficients of the pair
  Real shear[3];                                     // displacement [m]: of the last step, then of this one
  Real force[3], torque_i[3], torque_j[3];           // results: on i [N]; [N m]
};

// A select has no effect on the bits of the side that is taken.
template <bool kRolling, bool kTangentialDamping, bool kLimitForce, bool kTorsion, class Real>
FOOTFALL_INLINE void compute(Contact<Real>& c, Real dt) {
  const Real dx = c.delta[0], dy = c.delta[1], dz = c.delta[2];
  const Real r = std::sqrt(c.square);
  const Real rinv = Real(1.0) / r;
  const Real enx = dx * rinv, eny = dy * rinv, enz = dz * rinv;

  // Relative velocity of the surfaces.
  const Real vr1 = c.velocity[0], vr2 = c.velocity[1], vr3 = c.velocity[2];
  const Real vn = vr1 * enx + vr2 * eny + vr3 * enz;
  const Real vt1 = vr1 - vn * enx, vt2 = vr2 - vn * eny, vt3 = vr3 - vn * enz;
  const Real radi = c.radius_i, radj = c.radius_j;
  // In single precision from the difference of squares, so that its error is 1e-7 of itself, not of the radii.
  const Real deltan = std::is_same_v<Real, float> ? c.excess / ((radi + radj) + r) : (radi + radj) - r;
  const Real cri = radi - Real(0.5) * deltan, crj = radj - Real(0.5) * deltan;
  const Real wr1 = (cri * c.spin_i[0] + crj * c.spin_j[0]) * rinv;
  const Real wr2 = (cri * c.spin_i[1] + crj * c.spin_j[1]) * rinv;
  const Real wr3 = (cri * c.spin_i[2] + crj * c.spin_j[2]) * rinv;
  const Real vtr1 = vt1 - (dz * wr2 - dy * wr3);
  const Real vtr2 = vt2 - (dx * wr3 - dz * wr1);
  const Real vtr3 = vt3 - (dy * wr1 - dx * wr2);

  // Normal force: Hertz with damping.
  const Real reff = radi * radj / (radi + radj);
  const Real meff = c.mass_i * c.mass_j / (c.mass_i + c.mass_j);
  const Real root = std::sqrt(reff * deltan);
  constexpr Real kRootOfFiveSixths = Real(0.91287092917527685576161630466800355658790782499663875);
  const Real sn = Real(2.) * c.young * root;
  const Real kt = Real(8.) * c.rigidity * root;
  const Real kn = Real(4. / 3.) * c.young * root;
  const Real gamman = Real(-2.) * kRootOfFiveSixths * c.damping * std::sqrt(sn * meff);
  Real fn = -gamman * vn + kn * deltan;
  if (kLimitForce) fn = fn < Real(0.0) ? Real(0.0) : fn;

  // Tangential force: shear displacement, limited by friction; damped where it sticks.
  Real s1 = c.shear[0] + vtr1 * dt, s2 = c.shear[1] + vtr2 * dt, s3 = c.shear[2] + vtr3 * dt;
  const Real along = s1 * enx + s2 * eny + s3 * enz;
  s1 -= along * enx;
  s2 -= along * eny;
  s3 -= along * enz;
  const Real length = std::sqrt(s1 * s1 + s2 * s2 + s3 * s3);
  const Real ft1 = -(kt * s1), ft2 = -(kt * s2), ft3 = -(kt * s3);
  const Real ft_shear = kt * length, ft_friction = c.friction * std::fabs(fn);
  const bool slides = ft_shear > ft_friction;
  const Real ratio = ft_friction / ft_shear;
  const Real slide1 = ft1 * ratio, slide2 = ft2 * ratio, slide3 = ft3 * ratio;
  const Real gammat = kTangentialDamping ? Real(-2.) * kRootOfFiveSixths * c.damping * std::sqrt(kt * meff) : Real(0.0);
  const Real stick1 = ft1 - gammat * vtr1, stick2 = ft2 - gammat * vtr2, stick3 = ft3 - gammat * vtr3;
  c.shear[0] = slides ? -slide1 / kt : s1;
  c.shear[1] = slides ? -slide2 / kt : s2;
  c.shear[2] = slides ? -slide3 / kt : s3;
  const Real f1 = slides ? slide1 : stick1, f2 = slides ? slide2 : stick2, f3 = slides ? slide3 : stick3;

  const Real tor1 = eny * f3 - enz * f2, tor2 = enz * f1 - enx * f3, tor3 = enx * f2 - eny * f1;
  Real roll1 = Real(0.0), roll2 = Real(0.0), roll3 = Real(0.0);
  if (kRolling) {
    const Real w1 = c.spin_i[0] - c.spin_j[0], w2 = c.spin_i[1] - c.spin_j[1], w3 = c.spin_i[2] - c.spin_j[2];
    const Real w = std::sqrt(w1 * w1 + w2 * w2 + w3 * w3);
    const Real scale = c.rolling * kn * deltan * reff / w;
    roll1 = scale * w1;
    roll2 = scale * w2;
    roll3 = scale * w3;
    if (!kTorsion) {
      const Real axial = roll1 * enx + roll2 * eny + roll3 * enz;
      roll1 -= enx * axial;
      roll2 -= eny * axial;
      roll3 -= enz * axial;
    }
    roll1 = w > Real(0.0) ? roll1 : Real(0.0);
    roll2 = w > Real(0.0) ? roll2 : Real(0.0);
    roll3 = w > Real(0.0) ? roll3 : Real(0.0);
  }
  c.force[0] = fn * enx + f1;
  c.force[1] = fn * eny + f2;
  c.force[2] = fn * enz + f3;
  c.torque_i[0] = -cri * tor1 - roll1;
  c.torque_i[1] = -cri * tor2 - roll2;
  c.torque_i[2] = -cri * tor3 - roll3;
  c.torque_j[0] = -crj * tor1 + roll1;
  c.torque_j[1] = -crj * tor2 + roll2;
  c.torque_j[2] = -crj * tor3 + roll3;
}

constexpr int kMost = 64;  // contacts of which the forces are computed together

// E, G [Pa], beta and coefficients of contacts that are computed together: a row per quantity.
template <class Real>
struct Materials {
  alignas(64) Real young[kMost], rigidity[kMost], damping[kMost], friction[kMost], rolling[kMost];
  int types[kMost] = {};  // pair of types of which these are; 0: none

  void forget() { std::fill(std::begin(types), std::end(types), 0); }
  void set(int k, const PairModel& m, int i, int j) {  // types of grains
    const int pair = (i << 16) + j;
    if (types[k] == pair) return;
    types[k] = pair;
    young[k] = static_cast<Real>(m.young[i][j]);
    rigidity[k] = static_cast<Real>(m.rigidity[i][j]);
    damping[k] = static_cast<Real>(m.damping[i][j]);
    friction[k] = static_cast<Real>(m.friction[i][j]);
    rolling[k] = static_cast<Real>(m.rolling == nullptr ? 0.0 : m.rolling[i][j]);
  }
  void get(int k, Contact<Real>& c) const {
    c.young = young[k];
    c.rigidity = rigidity[k];
    c.damping = damping[k];
    c.friction = friction[k];
    c.rolling = rolling[k];
  }
};

// Contacts that are computed together: a row per quantity.
template <class Real>
struct ContactRows {
  using Number = Real;
  Materials<Real> materials;
  alignas(64) Real delta[3][kMost], square[kMost], excess[kMost];
  alignas(64) Real radius_i[kMost], radius_j[kMost], mass_i[kMost], mass_j[kMost];
  alignas(64) Real velocity[3][kMost], spin_i[3][kMost], spin_j[3][kMost], shear[3][kMost];
  alignas(64) Real force[3][kMost], torque_i[3][kMost], torque_j[3][kMost];
  int count = 0;

  Contact<Real> get(int k) const {
    Contact<Real> c{};
    materials.get(k, c);
    c.square = square[k];
    if (std::is_same_v<Real, float>) c.excess = excess[k];
    c.radius_i = radius_i[k];
    c.radius_j = radius_j[k];
    c.mass_i = mass_i[k];
    c.mass_j = mass_j[k];
    for (int a = 0; a < 3; ++a) {
      c.delta[a] = delta[a][k];
      c.velocity[a] = velocity[a][k];
      c.spin_i[a] = spin_i[a][k];
      c.spin_j[a] = spin_j[a][k];
      c.shear[a] = shear[a][k];
    }
    return c;
  }
  void put(int k, const Contact<Real>& c) {
    for (int a = 0; a < 3; ++a) {
      shear[a][k] = c.shear[a];
      force[a][k] = c.force[a];
      torque_i[a][k] = c.torque_i[a];
      torque_j[a][k] = c.torque_j[a];
    }
  }
};

template <bool kRolling, bool kTangentialDamping, bool kLimitForce, bool kTorsion, class Contacts>
FOOTFALL_INLINE void compute(Contacts& all, typename Contacts::Number dt) {
  const int count = all.count;
  for (int k = 0; k < count; ++k) {
    Contact<typename Contacts::Number> one = all.get(k);
    compute<kRolling, kTangentialDamping, kLimitForce, kTorsion>(one, dt);
    all.put(k, one);
  }
}

template <bool kRolling, bool kTorsion, class Contacts>
FOOTFALL_INLINE void compute(Contacts& c, typename Contacts::Number dt, const PairModel& m) {
  if (m.tangential_damping) {
    m.limit_force ? compute<kRolling, true, true, kTorsion>(c, dt) : compute<kRolling, true, false, kTorsion>(c, dt);
  } else {
    m.limit_force ? compute<kRolling, false, true, kTorsion>(c, dt) : compute<kRolling, false, false, kTorsion>(c, dt);
  }
}

template <class Real>
FOOTFALL_INLINE void compute_any(ContactRows<Real>& c, double step, const PairModel& m) {
  const Real dt = static_cast<Real>(step);
  if (m.rolling == nullptr)
    compute<false, false>(c, dt, m);
  else if (m.torsion)
    compute<true, true>(c, dt, m);
  else
    compute<true, false>(c, dt, m);
}

// The same for each kind of vector registers; without fused multiply-add, so that all of them round alike. Contacts have a
// function compute_any of their own.
#ifdef __x86_64__
template <class Contacts>
__attribute__((target("avx512f,avx512vl,avx512dq"))) void compute_widest(Contacts& c, double dt, const PairModel& m) {
  compute_any(c, dt, m);
}
template <class Contacts>
__attribute__((target("avx2"))) void compute_wide(Contacts& c, double dt, const PairModel& m) {
  compute_any(c, dt, m);
}
#endif
template <class Contacts>
void compute_narrow(Contacts& c, double dt, const PairModel& m) {
  compute_any(c, dt, m);
}

template <class Contacts>
using Compute = void (*)(Contacts&, double, const PairModel&);
template <class Contacts>
Compute<Contacts> best_compute() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq"))
    return compute_widest<Contacts>;
  if (__builtin_cpu_supports("avx2")) return compute_wide<Contacts>;
#endif
  return compute_narrow<Contacts>;
}

}  // namespace footfall
