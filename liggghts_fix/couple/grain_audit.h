#pragma once
// Balance of the grains' momentum by source, for audited runs. Exists only where the environment requires it
// (coupler/programs.h: kAuditFolder); script, fixes and bits are the same as in a run without audit.
//
// LIGGGHTS integrates by velocity Verlet, for which these are identities, to round-off:
//   P' - P = sum over steps of dt/2 (F_n + F_n+1),   F = sum of f,            P = sum of m v
//   L' - L = sum over steps of dt/2 (M_n + M_n+1),   M = sum of x x f + tau,  L = sum of x x m v + I w   (about the origin)
// F and M are sums over sources: the pair style, and every fix with a post_force. Clumps (fix multisphere) count as rigid
// bodies. Written per window, one line per source:
//   window,kind,name,jx,jy,jz,lx,ly,lz,force,moment
// with the linear and angular impulse [N s, N m s], and the same without regard to sign, to which round-off and bounds are
// relative: the time integrals of the sums of |f| and |x x f| + |tau| over the grains. Kinds:
//   clock      j: end of the window [s], its length [s], 0; l: DEM steps, grains, periodic directions (x 1, y 2, z 4)
//   state      P, L at the window's end; force, moment: sums of |m v| and |x| |m v| + |I w|. Window -1: at the start
//   energy     jx: kinetic energy at the window's end [J]; jy: m g . x, of the script's gravity [J]; jz: number of
//              grains and clumps in these and in `state`: those that a fix integrates
//   pairs      grains on each other
//   gravity    of a fix gravity (name: its id), or of fix multisphere on its clumps
//   weight     its exact value: m g of the grains on which it acts
//   wall       a fix wall/gran without coupled bodies, or of another one the part of meshes that no body moves
//   body_wall  a fix wall/gran on the meshes or beams of bodies
//   fix        any other fix
//   held       minus the forces on grains that nothing integrates
//   body       on body `name`, as projected on it (DemBody), by the same weights; force, moment: of the sums, the moment
//              with the largest possible arms
//   mean       likewise, by the weights of the scheme; l about Bo in B
//   load       the same as it was sent: mean force and moment times the length of the window
//   impulse    j: the Verlet impulse on body `name` as it was sent; lx: the work on it, likewise [J]

#include <Eigen/Dense>
#include <array>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "liggghts_fix/link/dem_link.h"
#include "liggghts_fix/replaced/force_listeners.h"
#include "pointers.h"

namespace LAMMPS_NS {

class FixMultisphere;
class FixWallGran;

class GrainAudit final : private Pointers, public footfall::ForceListener {
 public:
  // The file is written by the first rank. Throws InputError when it cannot be.
  GrainAudit(LAMMPS* lmp, footfall::DemLink& link, const std::string& file);
  ~GrainAudit() override;

  void pair_forces_done(bool set_up) override;
  void fix_force_done(Fix& fix) override;
  void all_forces_done(bool set_up) override;
  void step_done() override;

 private:
  using Real = long double;  // sums over many grains that nearly cancel
  using Vector = Eigen::Matrix<Real, 3, 1>;
  using Wrench = Eigen::Matrix<Real, 6, 1>;
  static Vector wide(const double* x) { return {x[0], x[1], x[2]}; }

  // The effect of one source on the grains of this rank.
  struct Source {
    std::string kind, name;
    Wrench now = Wrench::Zero();      // of the present forces [N, N m]
    Wrench before = Wrench::Zero();   // one step ago
    Wrench impulse = Wrench::Zero();  // since the window began [N s, N m s]
    void advance() {
      before = now;
      gross_before = {gross_force, gross_moment};
    }
    // A sum whose parts are unknown.
    void set(const Wrench& sum) {
      now = sum;
      gross_force = sum.head<3>().norm();
      gross_moment = sum.tail<3>().norm();
    }
    Real gross_force = 0.0L, gross_moment = 0.0L;  // now [N, N m]
    std::array<Real, 2> gross_before{};            // likewise, one step ago
    Real force = 0.0L, moment = 0.0L;              // integrals of them [N s, N m s]
  };

  Source& source(const std::string& kind, const std::string& name);
  bool is_integrated(int grain) const;  // its position, by some fix
  bool is_rotated(int grain) const;     // its rotation, by some fix
  bool is_clump(int grain) const;
  void store_forces();                    // the present ones
  void add_source(Source& source) const;  // the change of the forces since
  void count_held();
  void count_weight();
  void count_bodies();
  void find_integrators();
  void observe_mixed_walls();
  void write_state(long window);
  void write_sources(long window);
  void write(long window, const std::string& kind, const std::string& name, const Wrench& value, Real size,
             Real size_of_moment);

  footfall::DemLink& link_;
  std::ofstream file_;
  std::vector<Source> sources_;                            // the same on all ranks, in the same order
  std::map<std::string, std::size_t> places_;              // in sources_, by kind and name
  std::map<std::string, std::shared_ptr<Wrench>> shares_;  // loads of meshes without bodies, by wall
  std::vector<std::array<double, 6>> before_;              // forces and torques after the last source, by grain
  int moved_by_ = 0, turned_by_ = 0;                       // group bits of integrating fixes
  FixMultisphere* clumps_ = nullptr;
  std::int64_t windows_ = -1;  // written
  int steps_ = 0;              // in this window
};

// Starts the audit of this LIGGGHTS where the environment requires it.
std::unique_ptr<GrainAudit> audit_if_required(LAMMPS* lmp, footfall::DemLink& link);

}  // namespace LAMMPS_NS
