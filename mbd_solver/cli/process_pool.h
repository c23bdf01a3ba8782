#pragma once
// Several runs of the front door at once, each with its output in a file.

#include <functional>
#include <string>
#include <vector>

namespace footfall {

struct PoolTask {
  std::vector<std::string> words;  // program and arguments
  std::string output;              // file for its standard output and error
};

struct PoolEnd {
  bool interrupted = false;  // by SIGINT or SIGTERM: no new task was started, those at work were asked to end and waited for
};

// Runs all tasks, at most `jobs` at once, in their order. `ended(index, exit code)` is called after each; 128 + signal when a signal
// ended it. A task whose parent dies gets SIGTERM.
PoolEnd run_pool(const std::vector<PoolTask>& tasks, int jobs, const std::function<void(int, int)>& ended);

}  // namespace footfall
