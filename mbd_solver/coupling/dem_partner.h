#pragma once
// The multibody side of the exchange with LIGGGHTS: opens it, sends one motion and receives one mean load per window,
// closes it.

#include <functional>
#include <string>
#include <vector>

#include "coupler/archive.h"
#include "coupler/link.h"
#include "coupler/message_fields.h"
#include "coupler/messages.h"

namespace footfall {

// Requirements of the scene on the LIGGGHTS script.
struct DemTerms {
  std::string scheme;                                 // a name that make_scheme knows
  double t_end = 0.0;                                 // [s]
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  // [m/s2]
  double max_dt = 0.0;                                // largest DEM step [s]; 0: no limit
  double expected_dt = 0.0;                           // particles.variables.dt [s]; 0: not given
  int expected_n = 0;                                 // particles.variables.every; 0: not given
  int n_max = 1;                                      // longest window for `every auto`
  std::vector<std::string> held_by_walls;             // bodies that walls of the script stop ([[contacts]] with walls)
  bool outflow = false;                               // grains may leave the box
  std::string resume;                                 // folder of the checkpoint to resume from; empty: a new run
};

class DemPartner {
 public:
  // bodies: every body with a boundary, at its initial motion. The transport must outlive this. Waits for the first
  // message of LIGGGHTS without time limit; later ones for `patience` [s]. Throws ProtocolError, naming both values,
  // when the two sides disagree.
  DemPartner(Transport& transport, std::vector<CoupledBody> bodies, const DemTerms& terms, double patience);

  double dt() const { return start_.dt; }    // DEM step [s]
  int substeps() const { return start_.n; }  // n of the script; 0: `every auto`
  bool requires_masses() const { return start_.requires_masses; }
  const std::string& dem_version() const { return start_.dem_version; }
  // Index in `bodies` of each body of Motion and Load, in their order.
  const std::vector<int>& coupled() const { return coupled_; }

  // Planes and static meshes of the script at its first run.
  const std::vector<StaticWall>& walls() const { return start_.walls; }

  // Warnings of the script, for the user.
  const std::vector<std::string>& warnings() const { return warnings_; }

  // One window: sends `motion` and returns the mean load of the grains. The reference is valid until the next call.
  // A script that may end early, and has, sends no load: script_has_ended().
  // meanwhile: called after sending, before waiting for the load.
  const Load& exchange(const Motion& motion, const std::function<void()>& meanwhile = {});
  bool script_has_ended() const { return script_has_ended_; }
  const Load& load() const { return load_; }  // of the last window
  // Waits for the checkpoint of the DEM side after this window, whose motion required it; false when it could not be
  // written without disturbing the run.
  bool wait_for_checkpoint(std::int64_t window);

  // A request to end concerns the interrupted run only, not the run that resumes from its checkpoint.
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
