#include "mbd_solver/cli/launch/process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "coupler/base/errors.h"
#include "coupler/interrupt.h"

namespace footfall {

namespace {

constexpr std::chrono::nanoseconds kTick = std::chrono::milliseconds(200);

[[noreturn]] void become(const Command& command, const sigset_t& held) {
  setpgid(0, 0);  // Ctrl-C in the terminal reaches the front door alone, which then ends the others in order
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  sigprocmask(SIG_UNBLOCK, &held, nullptr);
  const int nothing = open("/dev/null", O_RDONLY);
  if (nothing >= 0) dup2(nothing, STDIN_FILENO);
  if (!command.folder.empty() && chdir(command.folder.c_str()) != 0) _exit(kCannotStart);
  if (!command.output.empty()) {
    const int file = open(command.output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (file >= 0) {
      dup2(file, STDOUT_FILENO);
      dup2(file, STDERR_FILENO);
    }
  }
  for (const auto& [name, value] : command.environment) setenv(name.c_str(), value.c_str(), 1);
  std::vector<char*> words;
  for (const std::string& word : command.words) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  execvp(words[0], words.data());
  std::fprintf(stderr, "footfall: cannot start %s: %s\n", words[0], std::strerror(errno));
  _exit(kCannotStart);
}

}  // namespace

double processor_time(const rusage& usage) {
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

SignalsHeld::SignalsHeld() {
  sigemptyset(&held_);
  for (int signal : {SIGINT, SIGTERM, SIGQUIT, SIGUSR1, SIGCHLD}) sigaddset(&held_, signal);
  if (!is_ignored(SIGHUP)) sigaddset(&held_, SIGHUP);  // nohup
  sigprocmask(SIG_BLOCK, &held_, &old_);
}

SignalsHeld::~SignalsHeld() { sigprocmask(SIG_SETMASK, &old_, nullptr); }

int SignalsHeld::wait() const {
  const timespec tick{0, kTick.count()};
  const int signal = sigtimedwait(&held_, nullptr, &tick);
  return signal > 0 && signal != SIGCHLD ? signal : 0;
}

void SignalsHeld::ignore() const {
  for (const int signal : {SIGINT, SIGTERM, SIGQUIT, SIGUSR1, SIGHUP}) std::signal(signal, SIG_IGN);
}

pid_t start_process(const Command& command, const SignalsHeld& signals) {
  const pid_t pid = fork();
  if (pid < 0) throw InputError("cannot start " + command.words[0] + ": " + std::strerror(errno));
  if (pid == 0) become(command, signals.held());
  return pid;
}

int exit_code_of(int status) { return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status); }

}  // namespace footfall
