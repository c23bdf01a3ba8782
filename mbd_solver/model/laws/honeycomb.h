#pragma once
// Crushable honeycomb strut with a cartridge for compression and one for tension (either may be absent);
// theory 3.3.
//
// A cartridge of stages i = 1..N (crush force F_i, crush length L_i, softest first) has one inner state, its
// permanent crush c >= 0. With the closing x+ = x (compression) or -x (tension) and the elastic spring g of
// springs.h:
//
//   force   f  = g(x+ - c)                       elastic up to the crush reached; pushes only
//   crush   dc = max(0, dx+/dt) S(f / P(c))      irreversible and rate-independent
//
// S(r) = s^2 for 0 <= s <= 1 and 2 s - 1 beyond, s = (r - 0.95) / 0.05: crushing sets in at 95 % of the crush
// force P and holds f = P.
// P(c) goes from F_1 to F_2 ... in smooth steps over transition_length, centred on the ends of the stages, so
// that the energy sum F_i L_i is exact. Past the last stage comes the bottom-out: f rises with the slope
// bottom_out_stiffness over the stroke. Compacted foil crushes as well: this work is dissipated, too.
//
// Energy: the spring g stores energy; f dc is dissipated; their sum is force times rate exactly.
// Free play: after crushing, the strut is loose for -c_tension < x < c_compression; a crushed cartridge touches again
// where it was left.
// Valid for any stroke. f is C1 in stroke and state; dc is continuous, with a kink at rate 0 (derivative:
// on the loading side).

#include <optional>
#include <vector>

#include "mbd_solver/model/laws/springs.h"
#include "mbd_solver/model/laws/strut_law.h"

namespace footfall {

struct HoneycombStage {
  double crush_force;   // F_i > 0, not below the stage before [N]
  double crush_length;  // L_i > 0 [m]
};

struct HoneycombCartridge {
  std::vector<HoneycombStage> stages = {{3000.0, 0.10}, {6000.0, 0.08}};  // at least one (assumed values)
  double elastic_stiffness = 5.0e6;  // slope of the elastic branch over the stroke > 0 [N/m]
  // Slope past the last stage over the stroke, in (0, elastic_stiffness) [N/m]
  double bottom_out_stiffness = 2.5e6;
  // Crush over which P passes from stage to stage, in (0, shortest stage] [m]
  double transition_length = 5.0e-3;
  double toe = 1.0e-4;  // penetration over which the contact at zero force is smoothed > 0 [m]
};

struct HoneycombParameters {
  std::optional<HoneycombCartridge> compression = HoneycombCartridge{};
  std::optional<HoneycombCartridge> tension = HoneycombCartridge{};
};

class Honeycomb final : public StrutLaw {
 public:
  explicit Honeycomb(const HoneycombParameters& parameters);  // throws InputError for values out of range

  std::string_view kind() const override { return "honeycomb"; }
  // States: permanent crush [m] of compression, then of tension; an absent cartridge has none.
  int state_count() const override { return static_cast<int>(cartridges_.size()); }
  Eigen::VectorXd initial_state() const override { return Eigen::VectorXd::Zero(state_count()); }
  void evaluate(const StrutInput& in, StrutOutput& out) const override;
  double stored_energy(const StrutInput& in) const override;
  // kHoneycomb >= 0
  void dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const override;

  struct Report {
    bool tension;                     // which cartridge
    std::vector<double> stage_crush;  // of each stage, in [0, L_i] [m]
    double bottom_out;                // crush past the last stage [m]
  };
  std::vector<Report> report(const Eigen::Ref<const Eigen::VectorXd>& z) const;

 private:
  struct Cartridge {
    HoneycombCartridge data;
    OneSidedSpring spring;
    double sign;                                        // +1 compression, -1 tension
    double total_length;                                // [m]
    double plastic_slope;                               // dP/dc of the bottom-out [N/m]
    double crush_force(double c, double& slope) const;  // P(c) [N] and dP/dc [N/m]
  };
  struct Flow;  // force and crush rate of one cartridge with their derivatives
  static Flow flow(const Cartridge& cartridge, double stroke, double rate, double c);

  std::vector<Cartridge> cartridges_;
};

}  // namespace footfall
