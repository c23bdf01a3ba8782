#include "mbd_solver/cli/launch/child.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "coupler/base/errors.h"
#include "coupler/base/quote.h"
#include "mbd_solver/cli/launch/process.h"

namespace footfall {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::seconds kGrace(20);     // to write a checkpoint and end in order
constexpr std::chrono::seconds kAfterEnd(1);   // from the end of the child to SIGTERM for what it left behind
constexpr std::chrono::seconds kAfterTerm(2);  // from SIGTERM to SIGKILL

// Every process below this one.
std::vector<pid_t> descendants() {
  std::map<pid_t, std::vector<pid_t>> children;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    std::ifstream stat(entry.path() / "stat");
    std::string line;
    std::getline(stat, line);
    const std::size_t end = line.rfind(')');  // the program's name may hold anything
    char state = '?';
    int parent = 0;
    if (end == std::string::npos || std::sscanf(line.c_str() + end + 1, " %c %d", &state, &parent) != 2 || state == 'Z')
      continue;
    children[parent].push_back(std::stoi(name));
  }
  std::vector<pid_t> found = children[getpid()];
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::vector<pid_t> next = children[found[i]];
    found.insert(found.end(), next.begin(), next.end());
  }
  return found;
}

std::string program_of(pid_t pid) {
  std::error_code gone;
  return std::filesystem::read_symlink("/proc/" + std::to_string(pid) + "/exe", gone).filename();
}

void send_all(const std::vector<pid_t>& pids, int signal) {
  for (pid_t pid : pids) kill(pid, signal);
}

// Asks for an orderly end: true if somebody was there to ask.
bool ask_gracefully(const std::string& graceful) {
  bool asked = false;
  for (pid_t pid : descendants()) {
    if (graceful.empty() || program_of(pid) != graceful) continue;
    kill(pid, SIGINT);
    asked = true;
  }
  return asked;
}

// Collects every child that ended (orphans of the child come to us). True when `pid` is among them; `status` is then
// its status.
bool reap(pid_t pid, int& status) {
  bool ended = false;
  int s = 0;
  for (pid_t child = waitpid(-1, &s, WNOHANG); child > 0; child = waitpid(-1, &s, WNOHANG)) {
    if (child != pid) continue;
    status = s;
    ended = true;
  }
  return ended;
}

}  // namespace

ChildEnd run_child(const Command& command, const std::string& graceful, const std::function<void()>& tick) {
  const SignalsHeld signals;
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  const pid_t pid = start_process(command, signals);

  ChildEnd end;
  int status = 0;
  bool ended = false, terminated = false;
  Clock::time_point deadline = Clock::time_point::max();
  const auto terminate = [&] {
    send_all(descendants(), terminated ? SIGKILL : SIGTERM);
    terminated = true;
    deadline = Clock::now() + kAfterTerm;
  };
  while (!ended || !descendants().empty()) {
    const bool signalled = signals.wait();
    if (signalled && !end.interrupted && ask_gracefully(graceful)) {
      deadline = Clock::now() + kGrace;
    } else if (signalled) {
      terminate();
    }
    end.interrupted = end.interrupted || signalled;
    if (reap(pid, status)) {
      ended = true;
      if (deadline == Clock::time_point::max()) deadline = Clock::now() + kAfterEnd;
    }
    if (Clock::now() > deadline) terminate();
    if (tick && !ended) tick();
  }
  reap(pid, status);  // orphans killed last
  end.code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  if (end.code == kCannotStart) throw InputError("cannot start " + command.words[0] + "; is it installed?");
  return end;
}

std::string shell_line(const Command& command) {
  std::string line;
  for (const auto& [name, value] : command.environment) line += name + "=" + shell_word(value) + " ";
  for (const std::string& word : command.words)
    line += (line.empty() || line.back() == ' ' ? "" : " ") + shell_word(word);
  return line;
}

}  // namespace footfall
