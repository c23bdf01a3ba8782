#pragma once
// Where the wall time of a run goes.

#include <tuple>

#include "coupler/base/field_list.h"

namespace footfall {

struct RunTimes {
  double total = 0.0;       // wall time of the loop [s]
  double mbd = 0.0;         // in the integrator [s]
  double overlapped = 0.0;  // in output and controllers while the grains move [s]
  double control = 0.0;     // in controllers [s]; with grains a part of the one above
  double checkpoint = 0.0;  // in checkpoints: waiting for the DEM side, writing files [s]
};

template <>
inline constexpr auto kFields<RunTimes> = std::tuple{
    Field{"total", &RunTimes::total}, Field{"mbd", &RunTimes::mbd}, Field{"overlapped", &RunTimes::overlapped},
    Field{"control", &RunTimes::control}, Field{"checkpoint", &RunTimes::checkpoint}};

}  // namespace footfall
