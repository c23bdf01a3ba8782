#pragma once
// Counts, in a run that is audited, who gives the grains how much momentum: what `footfall audit` reads. Exists only
// where the environment asks for it (coupler/programs.h: kAuditFolder); the script, its fixes and the run's bits are
// those of the run that is not audited.
//
// LIGGGHTS integrates by velocity Verlet, for which these are identities, to round-off:
//   P' - P = sum over steps of dt/2 (F_n + F_n+1),   F = sum of f,            P = sum of m v
//   L' - L = sum over steps of dt/2 (M_n + M_n+1),   M = sum of x x f + tau,  L = sum of x x m v + I w   (about the origin)
// F and M are the sums of what each source adds to the grains: the pair style, and every fix with a post_force. Clumps
// (fix multisphere) count as the bodies they are. Written per window, one line per source:
//   window,kind,name,jx,jy,jz,lx,ly,lz,force,moment
// with the linear and angular impulse [N s, N m s], and what goes into them without regard to sign, to which round-off
// and bounds are relative: the time integrals of the sums of |f| and |x x f| + |tau| over the grains. Kinds:
//   clock      j: end of the window [s], its length [s], 0; l: substeps, grains, periodic directions (x 1, y 2, z 4)
//   state      P, L at the window's end; force, moment: sums of |m v| and |x| |m v| + |I w|. Window -1: at the start
//   energy     jx: kinetic energy at the window's end [J]; jy: m g . x then, of the script's gravity [J]; jz: how many
//              grains and clumps these and `state` are of: those that a fix integrates
//   pairs      grains on each other
//   gravity    of a fix gravity (name: its id), or of fix multisphere on its clumps
//   weight     what that must be: m g of the grains that it acts on
//   wall       a fix wall/gran that touches no body, or of another one the share of meshes that no body moves
//   body_wall  a fix wall/gran on the meshes or beams of bodies
//   fix        any other fix
//   held       taken away from grains that nothing integrates
//   body       on body `name`, as projected on it (DemBody), by the same weights; force, moment: of the sums, the moment
//              with the largest arms that they can have
//   mean       likewise, but by the weights of the scheme, l about Bo in B
//   load       the same as it was sent: mean force and moment times the length of the window
//   impulse    j: the Verlet impulse on body `name` as it was sent; lx: the work on it, likewise [J]

#include <Eigen/Dense>
#include <array>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "liggghts_fix/dem_link.h"
#include "liggghts_fix/liggghts_access.h"
#include "pointers.h"

namespace LAMMPS_NS {

class FixMultisphere;
class FixWallGran;
class MeshShare;

class GrainAudit final : private Pointers, public footfall::ForceWatch {
 public:
  // The file is written by the first rank. Throws InputError when it cannot be.
  GrainAudit(LAMMPS* lmp, footfall::DemLink& link, const std::string& file);
  ~GrainAudit() override;

  void pairs_done(bool set_up) override;
  void fix_done(Fix& fix) override;
  void forces_done(bool set_up) override;
  void step_done() override;

 private:
  using Real = long double;  // sums over many grains, of which little is left
  using Vector = Eigen::Matrix<Real, 3, 1>;
  using Wrench = Eigen::Matrix<Real, 6, 1>;
  static Vector wide(const double* x) { return {x[0], x[1], x[2]}; }

  // What one source does to the grains of this rank.
  struct Account {
    std::string kind, name;
    Wrench now = Wrench::Zero();      // of the forces that stand [N, N m]
    Wrench before = Wrench::Zero();   // one step ago
    Wrench impulse = Wrench::Zero();  // since the window began [N s, N m s]
    void remember() {
      before = now;
      gross_before = {gross_force, gross_moment};
    }
    // A sum of which the parts are not known.
    void set(const Wrench& sum) {
      now = sum;
      gross_force = sum.head<3>().norm();
      gross_moment = sum.tail<3>().norm();
    }
    Real gross_force = 0.0L, gross_moment = 0.0L;  // now [N, N m]
    std::array<Real, 2> gross_before{};            // likewise, one step ago
    Real force = 0.0L, moment = 0.0L;              // integrals of them [N s, N m s]
  };

  Account& account(const std::string& kind, const std::string& name);
  bool is_integrated(int grain) const;  // its place, by some fix
  bool is_rotated(int grain) const;     // likewise its angle
  bool is_clump(int grain) const;
  void remember();                          // the forces that stand
  void add_source(Account& account) const;  // what has come to them since
  void count_held();
  void count_weight();
  void count_bodies();
  void find_integrators();
  void watch_mixed_walls();
  void write_state(long window);
  void write_accounts(long window);
  void write(long window, const std::string& kind, const std::string& name, const Wrench& value, Real size,
             Real size_of_moment);

  footfall::DemLink& link_;
  std::ofstream file_;
  std::vector<Account> accounts_;  // the same on all ranks, in the same order
  std::map<std::string, std::size_t> places_;
  std::map<std::string, std::shared_ptr<Wrench>> shares_;  // of meshes without bodies in walls that have both
  std::vector<std::array<double, 6>> before_;              // forces and torques behind the last source, by grain
  int moved_by_ = 0, turned_by_ = 0;                       // group bits of integrating fixes
  FixMultisphere* clumps_ = nullptr;
  std::int64_t windows_ = -1;  // written
  int steps_ = 0;              // in this window
};

// Starts it for this LIGGGHTS where the environment asks for it.
std::unique_ptr<GrainAudit> audit_if_asked(LAMMPS* lmp, footfall::DemLink& link);

}  // namespace LAMMPS_NS
