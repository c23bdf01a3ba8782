#pragma once
// summary.json of a run: its end, metrics, costs and scene.

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mbd_solver/session/observe/metrics.h"
#include "mbd_solver/session/observe/observation.h"
#include "mbd_solver/session/simulation.h"

namespace footfall {

// What a run warns of, whoever controls it: lists that grow while it proceeds, and what its end shows.
class RunWarnings {
 public:
  // All must outlive this object.
  RunWarnings(const Simulation& simulation, const Observation& observation, const MetricRecorder& metrics)
      : simulation_(simulation), observation_(observation), metrics_(metrics) {}

  // What has been added to the lists since the last call.
  std::vector<std::string> news();
  // Of the whole run, with what would be added at the present time. Warnings of the mechanism are not among them.
  std::vector<std::string> all() const;
  // What only the end shows: the coupling, extreme values, the integrator.
  std::vector<std::string> at_end() const;

 private:
  static constexpr std::size_t kLists = 6;
  std::array<std::vector<std::string>, kLists> lists() const;

  const Simulation& simulation_;
  const Observation& observation_;
  const MetricRecorder& metrics_;
  std::array<std::size_t, kLists> told_ = {};  // entries of each list
};

// status: "done", "interrupted" or "failed"; reason: of a failure, else empty; mpi_version: empty without MPI.
nlohmann::ordered_json run_summary(const Simulation& simulation, const MetricRecorder& recorder,
                                   const Observation& observation, const std::string& status, const std::string& reason,
                                   const std::string& mpi_version);

}  // namespace footfall
