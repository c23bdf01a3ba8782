#pragma once
// The subcommands that start many runs, and the schema of their files. They stand in a program of their own, footfall_studies,
// so that a first run does not wait for their compilation.

#include <vector>

#include "mbd_solver/cli/subcommands.h"

namespace footfall {

const std::vector<Subcommand>& studies();

}  // namespace footfall
