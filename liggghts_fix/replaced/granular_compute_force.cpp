// LIGGGHTS::PairStyles::Granular<hertz, tangential history, rolling off or cdt>::compute_force: the same forces, to the
// bit, in less time. Pairs that do not touch are passed over after one comparison; those that touch are collected, and
// their forces computed together, several in each instruction: every operation is taken from the contact models, in their
// order, and forces are added to the grains in the order of the list. What this does not know (energies per contact, heat,
// rigid bodies, frozen grains, virials, a step without history) goes to LIGGGHTS' own function.

#include "atom.h"
#include "contact_models.h"
#include "force.h"
#include "granular_pair_style.h"
#include "liggghts_fix/replaced/contact_kernel.h"
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

PairModel model_of(const Hertz& hertz, const History& history) {
  PairModel m{};
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
PairModel model_of(const WithoutRolling& model) {
  return model_of(model.*hand_out(NormalOfWithout{}), model.*hand_out(TangentialOfWithout{}));
}
PairModel model_of(const WithCdt& model) {
  PairModel m = model_of(model.*hand_out(NormalOfCdt{}), model.*hand_out(TangentialOfCdt{}));
  m.rolling = (model.*hand_out(RollingOfCdt{})).*hand_out(RollingFriction{});
  m.torsion = (model.*hand_out(RollingOfCdt{})).*hand_out(Torsion{});
  return m;
}

constexpr int kTouches = models::CONTACT_NORMAL_MODEL | models::CONTACT_TANGENTIAL_MODEL;
constexpr int kAhead = 8;  // contacts: memory is requested before it is used

struct Touching {
  int i, j;
  double* shear;  // displacement [m], in the history of the contact
};

// The forces of all pairs of a list, to the bit of LIGGGHTS.
class PairForces {
 public:
  void add(const PairModel& model, const LAMMPS_NS::Atom& atom, double dt, const LAMMPS_NS::NeighList& list,
           const LAMMPS_NS::NeighList& contacts, int history_length) {
    ContactRows<double>& c = contacts_;
    c.materials.forget();
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
        const double radii = radius_i + radius[j], square = d0 * d0 + d1 * d1 + d2 * d2;
        // Written in any case and kept if they touch: a branch here could not be predicted.
        const bool touches = square < radii * radii;
        touching_[count] = {i, j, history + history_length * jj};
        c.delta[0][count] = d0;
        c.delta[1][count] = d1;
        c.delta[2][count] = d2;
        c.square[count] = square;
        flags[jj] |= touches ? kTouches : 0;
        count += touches;
        if (count == kMost) {
          add_touching(model, atom, dt, count);
          count = 0;
        }
      }
    }
    add_touching(model, atom, dt, count);
  }

 private:
  void add_touching(const PairModel& m, const LAMMPS_NS::Atom& atom, double dt, int count) {
    static const Compute<ContactRows<double>> compute = best_compute<ContactRows<double>>();
    ContactRows<double>& c = contacts_;
    c.count = count;
    const double *v = atom.v[0], *w = atom.omega[0], *radius = atom.radius, *mass = atom.rmass;
    double *f = atom.f[0], *torque = atom.torque[0];
    const int* type = atom.type;
    for (int k = 0; k < count; ++k) {
      const auto [i, j, shear] = touching_[k];
      const Touching& ahead = touching_[k + kAhead];
      __builtin_prefetch(v + 3 * ahead.j);
      __builtin_prefetch(w + 3 * ahead.j);
      __builtin_prefetch(ahead.shear, 1);
      __builtin_prefetch(f + 3 * j, 1);
      __builtin_prefetch(torque + 3 * j, 1);
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
      c.materials.set(k, m, type[i], type[j]);
    }
    compute(c, dt, m);
    const int locals = atom.nlocal;
    for (int k = 0; k < count;) {
      const int i = touching_[k].i;
      double on_i[3], torque_i[3];  // sums of the contacts of i, which come one after the other
      for (int a = 0; a < 3; ++a) {
        on_i[a] = f[3 * i + a];
        torque_i[a] = torque[3 * i + a];
      }
      for (; k < count && touching_[k].i == i; ++k) {
        const int j = touching_[k].j;
        double* const shear = touching_[k].shear;
        for (int a = 0; a < 3; ++a) {
          shear[a] = c.shear[a][k];
          on_i[a] += c.force[a][k];
          torque_i[a] += c.torque_i[a][k];
        }
        if (j >= locals) continue;
        for (int a = 0; a < 3; ++a) {
          f[3 * j + a] -= c.force[a][k];
          torque[3 * j + a] += c.torque_j[a][k];
        }
      }
      for (int a = 0; a < 3; ++a) {
        f[3 * i + a] = on_i[a];
        torque[3 * i + a] = torque_i[a];
      }
    }
  }

  Touching touching_[kMost + kAhead] = {};
  ContactRows<double> contacts_{};
};

// Whether all pairs can be computed here; see the top of this file.
bool is_known(const PairModel& model, LAMMPS_NS::PairGran& pair, LAMMPS_NS::Atom& atom, LAMMPS_NS::Force& force,
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
    const footfall::PairModel model = footfall::model_of(cmodel);                                             \
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
