#pragma once
// Processes that carry out one run without grains after another: `mbd_solver --serve`, the program of every run, so that a
// run repeated with `footfall run` has the same digits. Each writes all its runs into one folder.

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/base/child_watch.h"
#include "mbd_solver/base/line_channel.h"

namespace footfall {

struct WorkerTask {
  std::size_t run = 0;  // its number
  std::string scene;
  std::vector<std::string> settings;
  double until = 0.0;    // [s]; 0: the scene's end time
  bool trusted = false;  // programs that the scene names may run
};

struct WorkerAnswer {
  static constexpr int kLost = 128;  // and above (+ signal): the worker ended without an answer
  std::size_t run = 0;
  int code = 0;         // exit code of the run; RunEnd::kHung at the time limit
  std::string message;  // of a run that is not done
  std::string folder;   // of its results, until the next call of start()
};

class WorkerPool {
 public:
  // Makes the folders; time_limit: of a run [s]; 0: none. Throws InputError.
  WorkerPool(std::string folder, int workers, int time_limit);
  ~WorkerPool();  // ends the processes and removes the folders
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  bool idle() const;  // a worker has nothing to do
  bool busy() const;  // a worker has a run
  void start(const WorkerTask& task);
  // Waits up to a fifth of a second for the end of a run.
  std::optional<WorkerAnswer> wait();
  bool interrupted() const { return interrupted_; }  // a signal requests the end

 private:
  struct Worker {
    std::string folder;
    pid_t process = -1;
    int to = -1, from = -1;  // pipes
    bool works = false;
    std::size_t run = 0;
    double started = 0.0;  // wall clock [s]
    LineChannel lines;
  };
  void begin(Worker& worker);
  int end(Worker& worker);  // returns its exit code
  WorkerAnswer answered(Worker& worker, int code, const std::string& message);

  SignalsHeld signals_;
  std::string folder_;
  int time_limit_;
  std::vector<Worker> workers_;
  bool interrupted_ = false;
};

}  // namespace footfall
