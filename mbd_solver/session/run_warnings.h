#pragma once
// What a run warns of, whoever controls it: lists that grow while it proceeds, and what its end shows.

#include <array>
#include <string>
#include <vector>

#include "mbd_solver/session/observe/metrics.h"
#include "mbd_solver/session/observe/observation.h"
#include "mbd_solver/session/simulation.h"

namespace footfall {

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

}  // namespace footfall
