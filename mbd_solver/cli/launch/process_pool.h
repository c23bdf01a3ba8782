#pragma once
// Several commands at once, each with its output in a file.

#include <functional>
#include <vector>

#include "mbd_solver/cli/launch/child.h"

namespace footfall {

// Runs all commands, at most `jobs` at once, in their order. `ended(index, exit code, processor time)` is called after
// each; the code is 128 + signal when a signal ended it, the time [s] is that of the command and of all it waited for.
// At SIGINT or SIGTERM, or when `ended` throws, no new one is started, those at work get SIGINT and are waited for; true
// says so, or what was thrown is thrown on.
bool run_pool(const std::vector<Command>& commands, int jobs, const std::function<void(int, int, double)>& ended);

}  // namespace footfall
