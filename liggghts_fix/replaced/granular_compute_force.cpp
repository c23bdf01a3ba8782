// LIGGGHTS::PairStyles::Granular<hertz, tangential history, rolling off or cdt>::compute_force: the same forces, to the
// bit, in less time. Pairs that do not touch are passed over after one comparison; those that touch are collected, and
// their forces computed together, several in each instruction: every operation is taken from the contact models, in their
// order, and forces are added to the grains in the order of the list. What this does not know (energies per contact, heat,
// rigid bodies, frozen grains, virials, a step without history) goes to LIGGGHTS' own function.

#include <algorithm>
#include <cmath>
#include <vector>

#include "atom.h"
#include "contact_models.h"
#include "force.h"
#include "granular_pair_style.h"
#include "liggghts_fix/replaced/next_definition.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair_gran.h"
#include "update.h"

// As pair_gran_base.h declares it, which Debian's package installs without a header that it includes. Only compute_force is defined here.
namespace LIGGGHTS::PairStyles {
template <class ContactModel>
class Granular : private LAMMPS_NS::Pointers, public IGranularPairStyle {
  ContactModels::SurfacesIntersectData* aligned_sidata;
  ContactModels::ForceData *aligned_i_forces, *aligned_j_forces;
  ContactModel cmodel;

 public:
  virtual ~Granular();
  virtual void settings(int, char**, IContactHistorySetup*);
  virtual void init_granular();
  virtual void write_restart_settings(FILE*);
  virtual void read_restart_settings(FILE*, int64_t);
  virtual void compute_force(LAMMPS_NS::PairGran*, int, int, int);
  virtual int64_t hashcode();
  virtual double stressStrainExponent();
  virtual bool contact_match(std::string, std::string);
  virtual int get_history_offset(std::string);
};
}  // namespace LIGGGHTS::PairStyles

namespace footfall {

// Members of contact models that no function hands out: an explicit instantiation may name them.
template <class Tag, typename Tag::type member>
struct Handed {
  friend typename Tag::type hand_out(Tag) { return member; }
};
#define FOOTFALL_MEMBER(tag, of, what, name) \
  struct tag {                               \
    using type = what of::*;                 \
    friend type hand_out(tag);               \
  };                                         \
  template struct Handed<tag, &of::name>

namespace models = LIGGGHTS::ContactModels;
using Hertz = models::NormalModel<models::HERTZ>;
using History = models::TangentialModel<models::TANGENTIAL_HISTORY>;
using RollingOff = models::RollingModel<models::ROLLING_OFF>;
using Cdt = models::RollingModel<models::ROLLING_CDT>;
using WithoutRolling =
    models::ContactModel<models::GranStyle<models::HERTZ, models::TANGENTIAL_HISTORY, models::COHESION_OFF,
                                           models::ROLLING_OFF, models::SURFACE_DEFAULT>>;
using WithCdt = models::ContactModel<models::GranStyle<models::HERTZ, models::TANGENTIAL_HISTORY, models::COHESION_OFF,
                                                       models::ROLLING_CDT, models::SURFACE_DEFAULT>>;

FOOTFALL_MEMBER(NormalOfWithout, WithoutRolling, Hertz, normalModel);
FOOTFALL_MEMBER(TangentialOfWithout, WithoutRolling, History, tangentialModel);
FOOTFALL_MEMBER(NormalOfCdt, WithCdt, Hertz, normalModel);
FOOTFALL_MEMBER(TangentialOfCdt, WithCdt, History, tangentialModel);
FOOTFALL_MEMBER(RollingOfCdt, WithCdt, Cdt, rollingModel);
FOOTFALL_MEMBER(Young, Hertz, double**, Yeff);
FOOTFALL_MEMBER(Shear, Hertz, double**, Geff);
FOOTFALL_MEMBER(Damping, Hertz, double**, betaeff);
FOOTFALL_MEMBER(TangentialDamping, Hertz, bool, tangential_damping);
FOOTFALL_MEMBER(LimitForce, Hertz, bool, limitForce);
FOOTFALL_MEMBER(NormalHeat, Hertz, bool, heating);
FOOTFALL_MEMBER(NormalEnergy, Hertz, bool, elasticpotflag_);
FOOTFALL_MEMBER(NormalDissipated, Hertz, bool, dissipatedflag_);
FOOTFALL_MEMBER(WhenBonded, Hertz, bool, disable_when_bonded_);
FOOTFALL_MEMBER(Friction, History, double**, coeffFrict);
FOOTFALL_MEMBER(Offset, History, int, history_offset);
FOOTFALL_MEMBER(TangentialHeat, History, bool, heating);
FOOTFALL_MEMBER(TangentialEnergy, History, bool, elasticpotflag_);
FOOTFALL_MEMBER(TangentialDissipated, History, bool, dissipatedflag_);
FOOTFALL_MEMBER(RollingFriction, Cdt, double**, coeffRollFrict);
FOOTFALL_MEMBER(Torsion, Cdt, bool, torsion_torque);
FOOTFALL_MEMBER(Relaxation, LAMMPS_NS::PairGran, LAMMPS_NS::FixRelaxContacts*, fix_relax_);
#undef FOOTFALL_MEMBER

namespace {

struct Model {
  double** young;
  double** rigidity;
  double** damping;
  double** friction;
  double** rolling;  // null: no rolling model
  int offset;        // of the shear displacement in the history of a contact
  bool tangential_damping, limit_force, torsion;
  bool known;  // nothing of it is beyond what is computed here
};

Model model_of(const Hertz& hertz, const History& history) {
  Model m{};
  m.young = hertz.*hand_out(Young{});
  m.rigidity = hertz.*hand_out(Shear{});
  m.damping = hertz.*hand_out(Damping{});
  m.tangential_damping = hertz.*hand_out(TangentialDamping{});
  m.limit_force = hertz.*hand_out(LimitForce{});
  m.friction = history.*hand_out(Friction{});
  m.offset = history.*hand_out(Offset{});
  m.known = !(hertz.*hand_out(NormalHeat{}) || hertz.*hand_out(NormalEnergy{}) || hertz.*hand_out(NormalDissipated{}) ||
              hertz.*hand_out(WhenBonded{}) || history.*hand_out(TangentialHeat{}) ||
              history.*hand_out(TangentialEnergy{}) || history.*hand_out(TangentialDissipated{}));
  return m;
}
Model model_of(const WithoutRolling& model) {
  return model_of(model.*hand_out(NormalOfWithout{}), model.*hand_out(TangentialOfWithout{}));
}
Model model_of(const WithCdt& model) {
  Model m = model_of(model.*hand_out(NormalOfCdt{}), model.*hand_out(TangentialOfCdt{}));
  m.rolling = (model.*hand_out(RollingOfCdt{})).*hand_out(RollingFriction{});
  m.torsion = (model.*hand_out(RollingOfCdt{})).*hand_out(Torsion{});
  return m;
}

// Contacts of which the forces are computed together: a row per quantity.
struct Contacts {
  static constexpr int kMost = 64;
  alignas(64) double delta[3][kMost];  // x_i - x_j [m]
  alignas(64) double square[kMost];    // of its length
  alignas(64) double radius_i[kMost], radius_j[kMost];
  alignas(64) double velocity[3][kMost];                  // v_i - v_j [m/s]
  alignas(64) double spin_i[3][kMost], spin_j[3][kMost];  // [rad/s]
  alignas(64) double mass_i[kMost], mass_j[kMost];
  alignas(64) double young[kMost], rigidity[kMost], damping[kMost], friction[kMost],
      rolling[kMost];                  // E, G [Pa], beta and coefficients of the pair
  alignas(64) double shear[3][kMost];  // displacement [m]: of the last step, then of this one
  alignas(64) double force[3][kMost];  // on i [N]
  alignas(64) double torque_i[3][kMost], torque_j[3][kMost];
  int count = 0;
};

// The models hertz, history and cdt of LIGGGHTS 3.8.0 (theory 5). A select has no effect on the bits of the side that is taken.
template <bool kRolling, bool kTangentialDamping, bool kLimitForce, bool kTorsion>
inline __attribute__((always_inline)) void compute(Contacts& c, double dt) {
  for (int k = 0; k < c.count; ++k) {
    const double dx = c.delta[0][k], dy = c.delta[1][k], dz = c.delta[2][k];
    const double r = std::sqrt(c.square[k]);
    const double rinv = 1.0 / r;
    const double enx = dx * rinv, eny = dy * rinv, enz = dz * rinv;

    // Relative velocity of the surfaces.
    const double vr1 = c.velocity[0][k], vr2 = c.velocity[1][k], vr3 = c.velocity[2][k];
    const double vn = vr1 * enx + vr2 * eny + vr3 * enz;
    const double vt1 = vr1 - vn * enx, vt2 = vr2 - vn * eny, vt3 = vr3 - vn * enz;
    const double radi = c.radius_i[k], radj = c.radius_j[k];
    const double deltan = (radi + radj) - r;
    const double cri = radi - 0.5 * deltan, crj = radj - 0.5 * deltan;
    const double wr1 = (cri * c.spin_i[0][k] + crj * c.spin_j[0][k]) * rinv;
    const double wr2 = (cri * c.spin_i[1][k] + crj * c.spin_j[1][k]) * rinv;
    const double wr3 = (cri * c.spin_i[2][k] + crj * c.spin_j[2][k]) * rinv;
    const double vtr1 = vt1 - (dz * wr2 - dy * wr3);
    const double vtr2 = vt2 - (dx * wr3 - dz * wr1);
    const double vtr3 = vt3 - (dy * wr1 - dx * wr2);

    // Normal force: Hertz with damping.
    const double reff = radi * radj / (radi + radj);
    const double meff = c.mass_i[k] * c.mass_j[k] / (c.mass_i[k] + c.mass_j[k]);
    const double root = std::sqrt(reff * deltan);
    constexpr double kRootOfFiveSixths = 0.91287092917527685576161630466800355658790782499663875;
    const double sn = 2. * c.young[k] * root;
    const double kt = 8. * c.rigidity[k] * root;
    const double kn = 4. / 3. * c.young[k] * root;
    const double gamman = -2. * kRootOfFiveSixths * c.damping[k] * std::sqrt(sn * meff);
    double fn = -gamman * vn + kn * deltan;
    if (kLimitForce) fn = fn < 0.0 ? 0.0 : fn;

    // Tangential force: shear displacement, limited by friction; damped where it sticks.
    double s1 = c.shear[0][k] + vtr1 * dt, s2 = c.shear[1][k] + vtr2 * dt, s3 = c.shear[2][k] + vtr3 * dt;
    const double along = s1 * enx + s2 * eny + s3 * enz;
    s1 -= along * enx;
    s2 -= along * eny;
    s3 -= along * enz;
    const double length = std::sqrt(s1 * s1 + s2 * s2 + s3 * s3);
    const double ft1 = -(kt * s1), ft2 = -(kt * s2), ft3 = -(kt * s3);
    const double ft_shear = kt * length, ft_friction = c.friction[k] * std::fabs(fn);
    const bool slides = ft_shear > ft_friction;
    const double ratio = ft_friction / ft_shear;
    const double slide1 = ft1 * ratio, slide2 = ft2 * ratio, slide3 = ft3 * ratio;
    double stick1 = ft1, stick2 = ft2, stick3 = ft3;
    if (kTangentialDamping) {
      const double gammat = -2. * kRootOfFiveSixths * c.damping[k] * std::sqrt(kt * meff);
      stick1 -= gammat * vtr1;
      stick2 -= gammat * vtr2;
      stick3 -= gammat * vtr3;
    } else {
      stick1 -= 0.0 * vtr1;
      stick2 -= 0.0 * vtr2;
      stick3 -= 0.0 * vtr3;
    }
    c.shear[0][k] = slides ? -slide1 / kt : s1;
    c.shear[1][k] = slides ? -slide2 / kt : s2;
    c.shear[2][k] = slides ? -slide3 / kt : s3;
    const double f1 = slides ? slide1 : stick1, f2 = slides ? slide2 : stick2, f3 = slides ? slide3 : stick3;

    const double tor1 = eny * f3 - enz * f2, tor2 = enz * f1 - enx * f3, tor3 = enx * f2 - eny * f1;
    double roll1 = 0.0, roll2 = 0.0, roll3 = 0.0;
    if (kRolling) {
      const double w1 = c.spin_i[0][k] - c.spin_j[0][k], w2 = c.spin_i[1][k] - c.spin_j[1][k],
                   w3 = c.spin_i[2][k] - c.spin_j[2][k];
      const double w = std::sqrt(w1 * w1 + w2 * w2 + w3 * w3);
      const double scale = c.rolling[k] * kn * deltan * reff / w;
      roll1 = scale * w1;
      roll2 = scale * w2;
      roll3 = scale * w3;
      if (!kTorsion) {
        const double axial = roll1 * enx + roll2 * eny + roll3 * enz;
        roll1 -= enx * axial;
        roll2 -= eny * axial;
        roll3 -= enz * axial;
      }
      roll1 = w > 0.0 ? roll1 : 0.0;
      roll2 = w > 0.0 ? roll2 : 0.0;
      roll3 = w > 0.0 ? roll3 : 0.0;
    }
    c.force[0][k] = fn * enx + f1;
    c.force[1][k] = fn * eny + f2;
    c.force[2][k] = fn * enz + f3;
    c.torque_i[0][k] = -cri * tor1 - roll1;
    c.torque_i[1][k] = -cri * tor2 - roll2;
    c.torque_i[2][k] = -cri * tor3 - roll3;
    c.torque_j[0][k] = -crj * tor1 + roll1;
    c.torque_j[1][k] = -crj * tor2 + roll2;
    c.torque_j[2][k] = -crj * tor3 + roll3;
  }
}

template <bool kRolling, bool kTorsion>
inline __attribute__((always_inline)) void compute(Contacts& c, double dt, bool tangential_damping, bool limit_force) {
  if (tangential_damping) {
    limit_force ? compute<kRolling, true, true, kTorsion>(c, dt) : compute<kRolling, true, false, kTorsion>(c, dt);
  } else {
    limit_force ? compute<kRolling, false, true, kTorsion>(c, dt) : compute<kRolling, false, false, kTorsion>(c, dt);
  }
}

inline __attribute__((always_inline)) void compute_any(Contacts& c, double dt, const Model& m) {
  if (m.rolling == nullptr)
    compute<false, false>(c, dt, m.tangential_damping, m.limit_force);
  else if (m.torsion)
    compute<true, true>(c, dt, m.tangential_damping, m.limit_force);
  else
    compute<true, false>(c, dt, m.tangential_damping, m.limit_force);
}
// Without fused multiply-add, so that all of them round alike.
#ifdef __x86_64__
__attribute__((target("avx2"))) void compute_wide(Contacts& c, double dt, const Model& m) { compute_any(c, dt, m); }
#endif
void compute_narrow(Contacts& c, double dt, const Model& m) { compute_any(c, dt, m); }

using Compute = void (*)(Contacts&, double, const Model&);
Compute best_compute() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2")) return compute_wide;
#endif
  return compute_narrow;
}

// The forces of all pairs of a list.
class PairForces {
 public:
  void add(const Model& model, const LAMMPS_NS::Atom& atom, double dt, const LAMMPS_NS::NeighList& list,
           const LAMMPS_NS::NeighList& contacts, int history_length) {
    constexpr int kTouches = models::CONTACT_NORMAL_MODEL | models::CONTACT_TANGENTIAL_MODEL;
    const double *x = atom.x[0], *radius = atom.radius;
    int count = 0;
    for (int ii = 0; ii < list.inum; ++ii) {
      const int i = list.ilist[ii];
      const double x0 = x[3 * i], x1 = x[3 * i + 1], x2 = x[3 * i + 2], radius_i = radius[i];
      const int* neighbours = list.firstneigh[i];
      const int pairs = list.numneigh[i];
      int* flags = contacts.firstneigh[i];
      double* history = contacts.firstdouble[i] + model.offset;
      for (int jj = 0; jj < pairs; ++jj) {
        const int j = neighbours[jj] & NEIGHMASK;
        const double d0 = x0 - x[3 * j], d1 = x1 - x[3 * j + 1], d2 = x2 - x[3 * j + 2];
        const double radii = radius_i + radius[j];
        // Written in any case and kept if they touch: a branch here could not be predicted.
        const bool touches = d0 * d0 + d1 * d1 + d2 * d2 < radii * radii;
        touching_[count] = {i, j, history + history_length * jj};
        flags[jj] |= touches ? kTouches : 0;
        count += touches;
        if (count == Contacts::kMost) {
          add_touching(model, atom, dt, count);
          count = 0;
        }
      }
    }
    add_touching(model, atom, dt, count);
  }

 private:
  struct Touching {
    int i, j;
    double* shear;  // displacement [m], in the history of the contact
  };

  void add_touching(const Model& m, const LAMMPS_NS::Atom& atom, double dt, int count) {
    static const Compute compute = best_compute();
    Contacts& c = contacts_;
    c.count = count;
    const double *x = atom.x[0], *v = atom.v[0], *w = atom.omega[0], *radius = atom.radius, *mass = atom.rmass;
    const int* type = atom.type;
    int ti = -1, tj = -1;
    double young = 0.0, rigidity = 0.0, damping = 0.0, friction = 0.0, rolling = 0.0;
    for (int k = 0; k < count; ++k) {
      const auto [i, j, shear] = touching_[k];
      const double d0 = x[3 * i] - x[3 * j], d1 = x[3 * i + 1] - x[3 * j + 1], d2 = x[3 * i + 2] - x[3 * j + 2];
      c.delta[0][k] = d0;
      c.delta[1][k] = d1;
      c.delta[2][k] = d2;
      c.square[k] = d0 * d0 + d1 * d1 + d2 * d2;
      c.radius_i[k] = radius[i];
      c.radius_j[k] = radius[j];
      for (int a = 0; a < 3; ++a) {
        c.velocity[a][k] = v[3 * i + a] - v[3 * j + a];
        c.spin_i[a][k] = w[3 * i + a];
        c.spin_j[a][k] = w[3 * j + a];
        c.shear[a][k] = shear[a];
      }
      c.mass_i[k] = mass[i];
      c.mass_j[k] = mass[j];
      if (type[i] != ti || type[j] != tj) {
        ti = type[i];
        tj = type[j];
        young = m.young[ti][tj];
        rigidity = m.rigidity[ti][tj];
        damping = m.damping[ti][tj];
        friction = m.friction[ti][tj];
        rolling = m.rolling == nullptr ? 0.0 : m.rolling[ti][tj];
      }
      c.young[k] = young;
      c.rigidity[k] = rigidity;
      c.damping[k] = damping;
      c.friction[k] = friction;
      c.rolling[k] = rolling;
    }
    compute(c, dt, m);
    double *f = atom.f[0], *torque = atom.torque[0];
    const int locals = atom.nlocal;
    for (int k = 0; k < count; ++k) {
      const auto [i, j, shear] = touching_[k];
      for (int a = 0; a < 3; ++a) {
        shear[a] = c.shear[a][k];
        f[3 * i + a] += c.force[a][k];
        torque[3 * i + a] += c.torque_i[a][k];
      }
      if (j >= locals) continue;
      for (int a = 0; a < 3; ++a) {
        f[3 * j + a] -= c.force[a][k];
        torque[3 * j + a] += c.torque_j[a][k];
      }
    }
  }

  Touching touching_[Contacts::kMost + 1];
  Contacts contacts_{};
};

// Whether all pairs can be computed here; see the top of this file.
bool is_known(const Model& model, LAMMPS_NS::PairGran& pair, LAMMPS_NS::Atom& atom, LAMMPS_NS::Force& force,
              LAMMPS_NS::Neighbor& neighbor, LAMMPS_NS::Modify& modify, bool virial, bool per_contact) {
  return model.known && !virial && !(per_contact && pair.cpl() != nullptr) && pair.computeflag() &&
         pair.shearupdate() && !pair.storeSumDelta() && !pair.storeContactForces() &&
         !pair.storeContactForcesStress() && !pair.store_sum_normal_force() && pair.fr_pair() == nullptr &&
         pair.freeze_group_bit() == 0 && pair.*hand_out(Relaxation{}) == nullptr && pair.listgranhistory != nullptr &&
         atom.rmass != nullptr && atom.sphere_flag && !atom.shapetype_flag && force.newton_pair == 0 &&
         force.nktv2p == 1.0 && neighbor.contactDistanceFactor == 1.0 && atom.nlocal > 0 &&
         modify.n_fixes_style("insert/stream/predefined") == 0;
}

}  // namespace
}  // namespace footfall

#define FOOTFALL_COMPUTE_FORCE(of, symbol)                                                                    \
  template <>                                                                                                 \
  void LIGGGHTS::PairStyles::Granular<of>::compute_force(LAMMPS_NS::PairGran* pair, int eflag, int vflag,     \
                                                         int addflag) {                                       \
    const footfall::Model model = footfall::model_of(cmodel);                                                 \
    if (!footfall::is_known(model, *pair, *atom, *force, *neighbor, *modify, eflag || vflag, addflag != 0)) { \
      using Original = void (*)(void*, LAMMPS_NS::PairGran*, int, int, int);                                  \
      static const auto original = footfall::next_definition<Original>(symbol);                               \
      return original(this, pair, eflag, vflag, addflag);                                                     \
    }                                                                                                         \
    pair->evflag = pair->vflag_fdotr = 0;                                                                     \
    static footfall::PairForces forces; /* keeps its memory */                                                \
    forces.add(model, *atom, update->dt, *pair->list, *pair->listgranhistory, pair->dnum());                  \
  }
FOOTFALL_COMPUTE_FORCE(footfall::WithoutRolling,
                       "_ZN8LIGGGHTS10PairStyles8GranularINS_13ContactModels12ContactModelINS2_"
                       "9GranStyleILi3ELi2ELi0ELi0ELi0EEEEEE13compute_forceEPN9LAMMPS_NS8PairGranEiii")
FOOTFALL_COMPUTE_FORCE(footfall::WithCdt,
                       "_ZN8LIGGGHTS10PairStyles8GranularINS_13ContactModels12ContactModelINS2_"
                       "9GranStyleILi3ELi2ELi0ELi1ELi0EEEEEE13compute_forceEPN9LAMMPS_NS8PairGranEiii")
#undef FOOTFALL_COMPUTE_FORCE
