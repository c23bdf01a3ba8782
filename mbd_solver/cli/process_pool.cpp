#include "mbd_solver/cli/process_pool.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <map>

#include "coupler/errors.h"

namespace footfall {

namespace {

constexpr int kCannotStart = 127;

[[noreturn]] void become(const PoolTask& task, const sigset_t& old_mask) {
  setpgid(0, 0);  // Ctrl-C in the terminal reaches the pool alone, which asks its tasks to end
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  sigprocmask(SIG_SETMASK, &old_mask, nullptr);
  const int nothing = open("/dev/null", O_RDONLY), file = open(task.output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (nothing >= 0) dup2(nothing, STDIN_FILENO);
  if (file >= 0) {
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
  }
  std::vector<char*> words;
  for (const std::string& word : task.words) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  execvp(words[0], words.data());
  std::fprintf(stderr, "footfall: cannot start %s: %s\n", words[0], std::strerror(errno));
  _exit(kCannotStart);
}

int exit_code(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

}  // namespace

PoolEnd run_pool(const std::vector<PoolTask>& tasks, int jobs, const std::function<void(int, int)>& ended) {
  sigset_t held, old_mask;
  sigemptyset(&held);
  for (const int signal : {SIGINT, SIGTERM, SIGCHLD}) sigaddset(&held, signal);
  sigprocmask(SIG_BLOCK, &held, &old_mask);
  PoolEnd end;
  std::map<pid_t, int> running;
  std::size_t next = 0;
  while (!running.empty() || (next < tasks.size() && !end.interrupted)) {
    while (next < tasks.size() && !end.interrupted && static_cast<int>(running.size()) < jobs) {
      const pid_t pid = fork();
      if (pid == 0) become(tasks[next], old_mask);
      if (pid < 0) throw InputError(std::string("cannot start another process: ") + std::strerror(errno));
      running[pid] = static_cast<int>(next++);
    }
    const timespec second{1, 0};
    const int signal = sigtimedwait(&held, nullptr, &second);
    if (signal == SIGINT || signal == SIGTERM) {
      end.interrupted = true;
      for (const auto& [pid, task] : running) kill(pid, SIGINT);
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
  sigprocmask(SIG_SETMASK, &old_mask, nullptr);
  return end;
}

}  // namespace footfall
