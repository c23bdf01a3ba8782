// Tasks go to a worker by one pipe and answers come back by another. A worker that hangs or dies is replaced.
#include "mbd_solver/campaign/worker_pool.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/run_directory.h"
#include "mbd_solver/launch/programs.h"
#include "mbd_solver/studies/codes.h"
#include "mbd_solver/studies/run_store.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {
constexpr int kPoll = 200;  // [ms]
}

WorkerPool::WorkerPool(std::string folder, int workers, int time_limit)
    : folder_(std::move(folder)), time_limit_(time_limit), workers_(std::max(1, workers)) {
  std::signal(SIGPIPE, SIG_IGN);  // a worker that is gone is noticed by its answer
  for (std::size_t k = 0; k < workers_.size(); ++k) {
    workers_[k].folder = (fs::path(folder_) / std::to_string(k)).string();
    make_folder(workers_[k].folder);
  }
}

WorkerPool::~WorkerPool() {
  for (Worker& worker : workers_) end(worker);
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

bool WorkerPool::idle() const {
  return std::any_of(workers_.begin(), workers_.end(), [](const Worker& w) { return !w.works; });
}

bool WorkerPool::busy() const {
  return std::any_of(workers_.begin(), workers_.end(), [](const Worker& w) { return w.works; });
}

void WorkerPool::begin(Worker& worker) {
  const std::string program = built_program("mbd_solver");
  const std::string log = worker.folder + ".log";
  int to[2], from[2];
  if (::pipe2(to, O_CLOEXEC) != 0)
    throw InputError(code::kNoWorker, "no pipe can be made for a worker: too many open files");
  if (::pipe2(from, O_CLOEXEC) != 0) {
    ::close(to[0]), ::close(to[1]);
    throw InputError(code::kNoWorker, "no pipe can be made for a worker: too many open files");
  }
  // The log is appended to, so that it can be emptied between runs. The flag `trusted` of a task decides its rights.
  const Command command{Rights::of_user(), {program, "--serve"}, {}, log};
  worker.process = start_program(command, {{to[0], STDIN_FILENO}, {from[1], STDOUT_FILENO}}, Orphan::kIsKilled);
  ::close(to[0]), ::close(from[1]);
  worker.to = to[1];
  worker.from = from[0];
  worker.lines = LineChannel(worker.from, worker.to);
}

int WorkerPool::end(Worker& worker) {
  if (worker.process < 0) return 0;
  ::close(worker.to), ::close(worker.from);
  ::kill(worker.process, SIGKILL);
  return wait_for_end(std::exchange(worker.process, -1));
}

void WorkerPool::start(const WorkerTask& task) {
  const auto found = std::find_if(workers_.begin(), workers_.end(), [](const Worker& w) { return !w.works; });
  FOOTFALL_DEMAND(found != workers_.end());
  Worker& worker = *found;
  // If a run fails, files of the run before must not count as its results.
  for (const char* file : {"/summary.json", "/history.csv", "/peaks.csv", ".log"})
    if (const int old = GuardedPath(worker.folder + file).open(O_WRONLY | O_TRUNC); old >= 0) ::close(old);
  if (worker.process < 0) begin(worker);
  const std::string line = nlohmann::json{
      {"scene", task.scene},
      {"settings", task.settings},
      {"until", task.until},
      {"out", worker.folder},
      {"trusted",
       task.trusted}}.dump();
  worker.lines.send(line);  // it may be gone: wait() reports it
  worker.works = true;
  worker.run = task.run;
  worker.started = wall_clock();
}

WorkerAnswer WorkerPool::answered(Worker& worker, int code, const std::string& message) {
  worker.works = false;
  return {worker.run, code, message, worker.folder};
}

std::optional<WorkerAnswer> WorkerPool::wait() {
  std::vector<pollfd> fds;
  std::vector<std::size_t> who;
  for (std::size_t k = 0; k < workers_.size(); ++k)
    if (workers_[k].works) {
      fds.push_back({workers_[k].from, POLLIN, 0});
      who.push_back(k);
    }
  ::poll(fds.data(), fds.size(), kPoll);
  const timespec at_once = {0, 0};
  for (int signal = 0; (signal = ::sigtimedwait(&signals_.held(), nullptr, &at_once)) > 0;)
    if (signal != SIGCHLD) interrupted_ = true;
  for (std::size_t i = 0; i < fds.size(); ++i) {
    Worker& worker = workers_[who[i]];
    if (fds[i].revents != 0) {
      std::string answer;
      const LineChannel::Heard heard = worker.lines.receive(answer, 0);
      if (heard == LineChannel::Heard::kNothing) continue;
      if (heard == LineChannel::Heard::kLine)
        return answered(worker, std::atoi(answer.c_str()),
                        answer.substr(std::min(answer.size(), answer.find(' ') + 1)));
      // It has ended: the status of its own end, not of our kill.
      ::close(worker.to), ::close(worker.from);
      const int code = wait_for_end(std::exchange(worker.process, -1));
      if (code == kCannotStart)
        throw InputError(code::kNoWorker, "the program mbd_solver cannot be started; install footfall again");
      return answered(
          worker, std::max(code, WorkerAnswer::kLost),
          code > WorkerAnswer::kLost
              ? "the program of the run was ended by signal " + std::to_string(code - WorkerAnswer::kLost)
              : "the program of the run ended with exit code " + std::to_string(code) + ", without an answer");
    }
    if (time_limit_ > 0 && wall_clock() - worker.started > time_limit_) {
      end(worker);
      return answered(worker, RunEnd::kHung, "no end within the time limit of " + std::to_string(time_limit_) + " s");
    }
  }
  return std::nullopt;
}

}  // namespace footfall
