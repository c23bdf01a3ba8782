// Words, environment and files of the new process are prepared before fork(). In the child: process group, its fate
// when its parent dies, files, folder, signals, rights, exec.

#include "mbd_solver/base/child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "coupler/base/run_directory.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/codes.h"
#include "mbd_solver/base/quote.h"

namespace footfall {
namespace {

constexpr int kFirstSpare = 100;  // files are first moved beyond the numbers that they get

std::vector<char*> pointers(const std::vector<std::string>& texts) {
  std::vector<char*> all;
  for (const std::string& text : texts) all.push_back(const_cast<char*>(text.c_str()));
  all.push_back(nullptr);
  return all;
}

// Ours with the command's, each "NAME=value".
std::vector<std::string> environment_of(const Command& command) {
  std::map<std::string, std::string> added = command.environment;
  added.insert(command.unshown.begin(), command.unshown.end());
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    if (added.count(text.substr(0, text.find('='))) == 0) all.push_back(text);
  }
  for (const auto& [name, value] : added) all.push_back(name + "=" + value);
  return all;
}

// A word with a line end would be several words for programs that read lists of words.
void require_words(const std::vector<std::string>& words) {
  for (const std::string& word : words)
    if (std::any_of(word.begin(), word.end(), [](char c) { return (c >= 0 && c < ' ') || c == 127; }))
      throw InputError(code::kControlCharacter, words[0], ": is not started: the word \"", visible(word),
                       "\" of its command line has a control character (a line end, a tab); rename the file or folder, "
                       "or correct the value");
}

void die_with_parent(Orphan orphan, pid_t parent) {
  if (orphan == Orphan::kEndsByItself) return;
  prctl(PR_SET_PDEATHSIG, orphan == Orphan::kIsKilled ? SIGKILL : SIGTERM);
  if (getppid() != parent) _exit(kCannotStart);
}

// As in a new process: nothing blocked. exec() resets handlers to their default; signals that this program ignores
// are reset here, but not signals that its own parent ignores (nohup).
void reset_signals() {
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  for (const int number : {SIGPIPE, SIGXFSZ, SIGCHLD}) signal(number, SIG_DFL);
}

void give(const Files& files, const std::string& output) {
  std::vector<int> spare;
  for (const auto& [here, there] : files) spare.push_back(fcntl(here, F_DUPFD_CLOEXEC, kFirstSpare));
  if (const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC); nothing >= 0) dup2(nothing, STDIN_FILENO);
  if (const int file = output.empty() ? -1 : GuardedPath(output).open(O_WRONLY | O_CREAT | O_TRUNC | O_APPEND);
      file >= 0) {
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
  }
  for (std::size_t i = 0; i < files.size(); ++i) dup2(spare[i], files[i].second);
}

[[noreturn]] void end_unstarted(const char* program, const std::string& why) {
  std::fprintf(stderr, "footfall: cannot start %s: %s\n", program, why.c_str());
  _exit(kCannotStart);
}

}  // namespace

std::vector<std::string> Rights::absolute(std::vector<std::string> paths) {
  paths.erase(std::remove(paths.begin(), paths.end(), ""), paths.end());
  for (std::string& path : paths) path = std::filesystem::absolute(path).string();
  return paths;
}

pid_t start_program(const Command& command, const Files& files, Orphan orphan) {
  require_words(command.words);
  std::vector<char*> words = pointers(command.words);
  const std::vector<std::string> settings = environment_of(command);
  std::vector<char*> environment = pointers(settings);
  const std::string named = program_in_path(command.words[0]), program = named.empty() ? command.words[0] : named;
  const pid_t parent = getpid(), child = fork();
  if (child < 0)
    throw InputError(code::kProgramNotStarted, "cannot start ", command.words[0], ": ", std::strerror(errno));
  if (child > 0) return child;
  setpgid(0, 0);
  die_with_parent(orphan, parent);
  if (!command.folder.empty() && fchdir(GuardedPath(command.folder).open(O_RDONLY | O_DIRECTORY)) != 0)
    end_unstarted(words[0], command.folder + ": " + std::strerror(errno));
  give(files, command.output);
  reset_signals();
  if (const auto& limits = command.rights.limits())
    if (const std::string why = confine(*limits); !why.empty())
      end_unstarted(words[0], "it cannot be confined (" + why + ")");
  execve(program.c_str(), words.data(), environment.data());
  end_unstarted(words[0], std::strerror(errno));
}

pid_t start_copy(const std::function<int()>& work, Orphan orphan) {
  const pid_t parent = getpid(), child = fork();
  if (child != 0) return child;
  die_with_parent(orphan, parent);
  _exit(work());
}

std::string become_program(const std::string& path, const std::vector<std::string>& words) {
  std::fflush(nullptr);
  execv(path.c_str(), pointers(words).data());
  return path + ": " + std::strerror(errno);
}

std::string output_of(const Command& command) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return "";
  const int unheard = open("/dev/null", O_WRONLY | O_CLOEXEC);
  const pid_t process = start_program(command, {{ends[1], STDOUT_FILENO}, {unheard, STDERR_FILENO}}, Orphan::kIsKilled);
  close(ends[1]);
  close(unheard);
  std::string output;
  char buffer[4096];
  for (ssize_t count = 0; (count = read(ends[0], buffer, sizeof buffer)) != 0;) {
    if (count < 0 && errno != EINTR) break;
    if (count > 0) output.append(buffer, static_cast<std::size_t>(count));
  }
  close(ends[0]);
  return wait_for_end(process) == 0 ? output : "";
}

int wait_for_end(pid_t process) {
  int status = 0;
  while (process > 0) {
    if (waitpid(process, &status, 0) == process) return exit_code_of(status);
    if (errno != EINTR) break;
  }
  return kCannotStart;
}

int exit_code_of(int status) { return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status); }

std::string program_in_path(const std::string& name) {
  if (name.find('/') != std::string::npos) return access(name.c_str(), X_OK) == 0 ? name : "";
  const char* path = std::getenv("PATH");
  for (const std::string& folder : split(path ? path : "", ':')) {
    const std::string program = (folder.empty() ? "." : folder) + "/" + name;
    std::error_code ignored;
    if (access(program.c_str(), X_OK) == 0 && !std::filesystem::is_directory(program, ignored)) return program;
  }
  return "";
}

std::string shell_line(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + shell_word(word);
  return line;
}

std::string shell_line(const Command& command) {
  std::string line;
  for (const auto& [name, value] : command.environment)
    if (name.rfind("FOOTFALL_", 0) != 0) line += name + "=" + shell_word(value) + " ";
  return line + shell_line(command.words);
}

}  // namespace footfall
