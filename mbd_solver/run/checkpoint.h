#pragma once
// The state of the mechanism as a text file of hexadecimal floating-point numbers: nothing is lost.

#include <string>

#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/model/state.h"

namespace footfall {

// Written beside the target and renamed, so that a reader never sees half of it. Throws InputError when the folder is
// not writable.
void write_checkpoint(const std::string& path, const State& state, const Mechanism& mechanism,
                      const Eigen::VectorXd& voltages);

}  // namespace footfall
