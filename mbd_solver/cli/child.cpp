#include "mbd_solver/cli/child.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "coupler/errors.h"

namespace footfall {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kTick(200);
constexpr std::chrono::seconds kGrace(20);       // to write a checkpoint and end in order
constexpr std::chrono::seconds kAfterEnd(1);     // from the end of the child to SIGTERM for what it left behind
constexpr std::chrono::seconds kAfterTerm(2);    // from SIGTERM to SIGKILL
constexpr int kCannotStart = 127;                // exit code of a child whose program could not be started

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
    if (end == std::string::npos || std::sscanf(line.c_str() + end + 1, " %c %d", &state, &parent) != 2 || state == 'Z') continue;
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

[[noreturn]] void become(const Command& command, const sigset_t& old_mask) {
  setpgid(0, 0);  // Ctrl-C in the terminal reaches the front door alone, which then ends the others in order
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  sigprocmask(SIG_SETMASK, &old_mask, nullptr);
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

// While a child runs, the signals we act on are taken one by one instead of interrupting us.
class SignalsHeld {
 public:
  SignalsHeld() {
    sigemptyset(&held_);
    for (int signal : {SIGINT, SIGTERM, SIGCHLD}) sigaddset(&held_, signal);
    sigprocmask(SIG_BLOCK, &held_, &old_);
  }
  ~SignalsHeld() { sigprocmask(SIG_SETMASK, &old_, nullptr); }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

  const sigset_t& old_mask() const { return old_; }
  // Waits for at most one tick. True for SIGINT or SIGTERM.
  bool wait() const {
    const timespec tick{0, std::chrono::nanoseconds(kTick).count()};
    const int signal = sigtimedwait(&held_, nullptr, &tick);
    return signal == SIGINT || signal == SIGTERM;
  }

 private:
  sigset_t held_, old_;
};

// Collects every child that ended (orphans of the child come to us). True when `pid` is among them; `status` is then its status.
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
  const pid_t pid = fork();
  if (pid < 0) throw InputError("cannot start " + command.words[0] + ": " + std::strerror(errno));
  if (pid == 0) become(command, signals.old_mask());

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
  const auto quoted = [](const std::string& word) -> std::string {
    const bool plain = !word.empty() && word.find_first_of(" \t\n\"'\\$&|;<>(){}[]*?!#~`") == std::string::npos;
    if (plain) return word;
    std::string inside;
    for (char c : word) inside += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return "'" + inside + "'";
  };
  std::string line;
  for (const auto& [name, value] : command.environment) line += name + "=" + quoted(value) + " ";
  for (const std::string& word : command.words) line += (word == command.words.front() ? "" : " ") + quoted(word);
  return line;
}

}  // namespace footfall
