#pragma once
// summary.json of a run: its end, metrics, costs and scene.

#include <nlohmann/json.hpp>
#include <string>

#include "mbd_solver/session/observe/metrics.h"
#include "mbd_solver/session/observe/observation.h"
#include "mbd_solver/session/simulation.h"

namespace footfall {

// status: "done", "interrupted" or "failed"; reason: of a failure, else empty; mpi_version: empty without MPI.
nlohmann::ordered_json run_summary(const Simulation& simulation, const MetricRecorder& recorder,
                                   const Observation& observation, const std::string& status, const std::string& reason,
                                   const std::string& mpi_version);

}  // namespace footfall
