#pragma once
// The one place that starts programs and copies of this process (tests/structure/sources.py forbids fork and exec elsewhere).
// The caller that starts a program states its rights: a Command has no rights by default.

#include <sys/types.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coupler/base/confinement.h"

namespace footfall {

// The rights of a program and all programs that it starts. The kernel enforces them before the program begins, for good.
class Rights {
 public:
  // The user's rights: for programs that the user trusts, and for programs of footfall that judge their input by themselves.
  static Rights of_user() { return Rights(std::nullopt); }
  // Starts only these programs (paths), itself among them; it writes with the user's rights.
  static Rights starting(const std::vector<std::string>& programs) {
    return Rights(Confinement{{}, absolute(programs), false});
  }
  // The same, and it writes only below these folders.
  static Rights writing(const std::vector<std::string>& programs, const std::vector<std::string>& folders) {
    return Rights(Confinement{absolute(folders), absolute(programs), true});
  }
  // One program more, where programs are limited.
  void add(const std::string& program) {
    if (limits_) limits_->executable.push_back(absolute({program})[0]);
  }
  // Empty: the user's rights.
  const std::optional<Confinement>& limits() const { return limits_; }

 private:
  // They hold wherever the program begins. Without those that are empty, of programs that are not installed.
  static std::vector<std::string> absolute(std::vector<std::string> paths);
  explicit Rights(std::optional<Confinement> limits) : limits_(std::move(limits)) {}
  std::optional<Confinement> limits_;
};

struct Command {
  Rights rights;
  std::vector<std::string> words = {};                  // program (a path, or to be found in PATH) and arguments
  std::map<std::string, std::string> environment = {};  // added to ours
  std::string output = {};                              // file for standard output and error; empty: ours
  std::string folder = {};                              // working directory; empty: the current one
  std::map<std::string, std::string> unshown = {};      // added to ours as well, but shell_line leaves it out
};

// Files of this process (pipes) that become files of the program. Standard input is empty where none is given.
using Files = std::vector<std::pair<int, int>>;  // file here -> its number there

// When this process dies, or the thread that has started it.
enum class Orphan { kIsKilled, kIsAsked, kEndsByItself };  // SIGKILL; SIGTERM; its input ends

constexpr int kCannotStart = 127;  // exit code of a process whose program cannot be started, as of a shell

// Starts a command in its own process group (Ctrl-C in a terminal reaches this program alone, which ends the others in
// order). Throws InputError when a word of it has a line end or another control character, or when no process can be created;
// a program that does not exist, or cannot be confined, writes why to standard error and ends with kCannotStart.
pid_t start_program(const Command& command, const Files& files = {}, Orphan orphan = Orphan::kIsAsked);

// A copy of this process that does `work` and ends with the code that it returns, without destructors of existing objects.
// -1 when no process can be created.
pid_t start_copy(const std::function<int()>& work, Orphan orphan);

// Replaces this process by the program `path`; `words` begins with the name that it sees. Returns why that is not possible.
std::string become_program(const std::string& path, const std::vector<std::string>& words);

// Standard output of a short command; empty when it cannot be started or fails.
std::string output_of(const Command& command);

// Waits for the end of a process. Returns its exit code as a shell does (exit_code_of); kCannotStart when there is none.
int wait_for_end(pid_t process);

// From the status of waitpid(): a signal counts as 128 + its number, as in a shell.
int exit_code_of(int status);

// Path of a program as the shell would find it; empty when there is none.
std::string program_in_path(const std::string& name);

// Words, or a command with its environment in front, as a line for a shell.
std::string shell_line(const std::vector<std::string>& words);
std::string shell_line(const Command& command);

}  // namespace footfall
