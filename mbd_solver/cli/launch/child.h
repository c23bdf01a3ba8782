#pragma once
// One child program of the front door, with everything it starts itself: nothing of it survives the front door.

#include <sys/types.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace footfall {

struct Command {
  std::vector<std::string> words;                  // program and arguments
  std::map<std::string, std::string> environment;  // added to ours
  std::string output;  // file that takes standard output and error; empty: they go where ours go
  std::string folder;  // to start in; empty: where we are
};

struct ChildEnd {
  int code = 0;              // exit code; 128 + signal when a signal ended it
  bool interrupted = false;  // the user asked for the end (SIGINT, SIGTERM)
};

// Runs a command to its end. `tick` is called about five times a second. SIGINT and SIGTERM are forwarded as SIGINT to
// every descendant whose program is `graceful` (the one that ends the others in order), or as SIGTERM to all when there
// is none; who is still there some seconds later, or at a second signal, is killed. Returns with no descendant left.
// Throws InputError when the program cannot be started.
ChildEnd run_child(const Command& command, const std::string& graceful = "", const std::function<void()>& tick = {});

// As a shell would take it, environment first.
std::string shell_line(const Command& command);

}  // namespace footfall
