#include "mbd_solver/cli/launch/process_pool.h"

#include <sys/resource.h>
#include <sys/wait.h>

#include <exception>
#include <map>

#include "mbd_solver/cli/launch/process.h"

namespace footfall {

bool run_pool(const std::vector<Command>& commands, int jobs, const std::function<void(int, int, double)>& ended) {
  const SignalsHeld signals;
  std::map<pid_t, int> running;  // number of each process
  std::size_t next = 0;
  bool interrupted = false;
  std::exception_ptr failure;
  const auto interrupt = [&] {
    interrupted = true;
    for (const auto& [pid, number] : running) kill(pid, SIGINT);
  };
  while (!running.empty() || (next < commands.size() && !interrupted)) {
    while (next < commands.size() && !interrupted && static_cast<int>(running.size()) < jobs) {
      running[start_process(commands[next], signals)] = static_cast<int>(next);
      ++next;
    }
    if (signals.wait() != 0) interrupt();
    for (auto it = running.begin(); it != running.end();) {
      int status = 0;
      rusage usage{};
      if (wait4(it->first, &status, WNOHANG, &usage) != it->first) {
        ++it;
        continue;
      }
      const int number = it->second;
      it = running.erase(it);
      try {
        ended(number, exit_code_of(status), processor_time(usage));
      } catch (...) {
        if (!failure) failure = std::current_exception();
        interrupt();
      }
    }
  }
  if (failure) std::rethrow_exception(failure);
  return interrupted;
}

}  // namespace footfall
