#pragma once
// The multibody side of the exchange with LIGGGHTS: opens it, trades one motion for one mean load per window, closes
// it.

#include <functional>
#include <string>
#include <vector>

#include "coupler/archive.h"
#include "coupler/link.h"
#include "coupler/message_fields.h"
#include "coupler/messages.h"

namespace footfall {

// What the scene fixes before LIGGGHTS speaks.
struct DemTerms {
  std::string scheme;                                 // a name that make_scheme knows
  double t_end = 0.0;                                 // [s]
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  // [m/s2]
  double max_dt = 0.0;                                // a larger DEM step is refused [s]; 0: any
  double expected_dt = 0.0;                           // stated by the scene for the script; 0: not stated [s]
  int expected_n = 0;                                 // likewise
  int n_max = 1;                                      // longest window when the script has `every auto`
  std::vector<std::string> held_by_walls;             // bodies that the script's walls stop: [[contacts]] with walls
  std::string resume;  // folder of the checkpoint that both sides go on from; empty: a new run
};

class DemPartner {
 public:
  // `bodies`: every body with a boundary, at its initial motion. The transport must outlive the partner. Waits for
  // LIGGGHTS' first words as long as its script takes to get there. Throws ProtocolError when the two sides disagree,
  // naming both values.
  DemPartner(Transport& transport, std::vector<CoupledBody> bodies, const DemTerms& terms, double patience);

  double dt() const { return start_.dt; }    // substep of the grains [s]
  int substeps() const { return start_.n; }  // n of the script; 0: `every auto`
  bool wants_masses() const { return start_.requires_masses; }
  const std::string& grains_version() const { return start_.dem_version; }
  // index in `bodies` of each body of Motion and Load, in their order
  const std::vector<int>& coupled() const { return coupled_; }

  // Of the script; those that still stand where they stood when it began to run.
  const std::vector<StaticWall>& walls() const { return start_.walls; }

  // For the user: what the script said and is no error.
  const std::vector<std::string>& warnings() const { return warnings_; }

  // One window: sends `motion` and returns the load that the grains gave over it. The reference holds until the next
  // call. A script that ends early, as it has said it may, gives no load any more: script_has_ended().
  // meanwhile: called when the motion is out, before the load is waited for.
  const Load& exchange(const Motion& motion, const std::function<void()>& meanwhile = {});
  bool script_has_ended() const { return script_has_ended_; }
  const Load& load() const { return load_; }  // of the last window
  // Waits until the grains' side has kept itself after this window, whose motion asked for it; false when it has not,
  // as it could not quietly.
  bool expect_kept(std::int64_t window);

  // A signal ends the run that it meets: what goes on from its checkpoint was not asked to end.
  void visit(Archive& archive) {
    archive("load", load_);
    if (archive.restores()) load_.end_requested = false;
  }
  void close() {
    if (!link_.closed()) link_.close();
  }
  void fail(const std::string& reason, Status status) noexcept { link_.fail(reason, status); }

 private:
  void check(const DemTerms& terms) const;
  void check_gravity(const Eigen::Vector3d& scene);

  Link link_;
  std::vector<CoupledBody> bodies_;
  Start start_;
  std::vector<int> coupled_;
  Load load_;
  std::vector<std::string> warnings_;
  bool script_has_ended_ = false;
};

}  // namespace footfall
