#pragma once
// Adds a share of the present powers to the time integrals of a State: integral += weight [s] x power [W].

#include "mbd_solver/dynamics/equations.h"

namespace footfall {

inline void add_work(const EnergySample& at, double weight, State& state) {
  for (std::size_t k = 0; k < state.dissipated.by_kind.size(); ++k)
    state.dissipated.by_kind[k] += weight * at.power.by_kind[k];
  state.load_work += weight * at.load_power;
  for (std::size_t k = 0; k < state.supplied.by_kind.size(); ++k)
    state.supplied.by_kind[k] += weight * at.supplied.by_kind[k];
}

}  // namespace footfall
