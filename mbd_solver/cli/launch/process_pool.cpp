#include "mbd_solver/cli/launch/process_pool.h"

#include <sys/wait.h>

#include <map>

#include "mbd_solver/cli/launch/process.h"

namespace footfall {

namespace {

int exit_code(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

}  // namespace

bool run_pool(const std::vector<Command>& commands, int jobs, const std::function<void(int, int)>& ended) {
  const SignalsHeld signals;
  std::map<pid_t, int> running;  // number of each process
  std::size_t next = 0;
  bool interrupted = false;
  while (!running.empty() || (next < commands.size() && !interrupted)) {
    while (next < commands.size() && !interrupted && static_cast<int>(running.size()) < jobs) {
      running[start_process(commands[next], signals)] = static_cast<int>(next);
      ++next;
    }
    if (signals.wait()) {
      interrupted = true;
      for (const auto& [pid, number] : running) kill(pid, SIGINT);
    }
    for (auto it = running.begin(); it != running.end();) {
      int status = 0;
      if (waitpid(it->first, &status, WNOHANG) != it->first) {
        ++it;
        continue;
      }
      ended(it->second, exit_code(status));
      it = running.erase(it);
    }
  }
  return interrupted;
}

}  // namespace footfall
