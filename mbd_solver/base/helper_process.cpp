// The pipes do not block: every wait is a poll with the time that is left. The helper leads a process group, which is killed
// as a whole; it is killed by the kernel when this program dies.

#include "mbd_solver/base/helper_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "coupler/base/clock.h"
#include "coupler/base/text.h"

namespace footfall {
namespace {

constexpr std::size_t kLastWords = 2000;             // of the standard error that are kept [bytes]
constexpr std::uint64_t kLargestFrame = 1ull << 30;  // [bytes]
constexpr double kTimeToEnd = 0.5;                   // after its input has ended [s]

void make_pipe(int (&ends)[2]) {
  if (pipe2(ends, O_CLOEXEC) != 0) throw NoAnswer(std::string("cannot be started: ") + std::strerror(errno));
}

void close_file(int& file) {
  if (file >= 0) close(file);
  file = -1;
}

}  // namespace

HelperProcess::HelperProcess(const Command& command, double limit, Orphan orphan) : limit_(limit) {
  int in[2] = {-1, -1}, out[2] = {-1, -1}, errors[2] = {-1, -1};
  make_pipe(in);
  make_pipe(out);
  make_pipe(errors);
  std::string why;
  try {
    child_ =
        start_program(command, {{in[0], STDIN_FILENO}, {out[1], STDOUT_FILENO}, {errors[1], STDERR_FILENO}}, orphan);
  } catch (const InputError& error) {
    why = error.what();
  }
  close(in[0]);
  close(out[1]);
  close(errors[1]);
  to_ = in[1];
  from_ = out[0];
  errors_ = errors[0];
  for (const int file : {to_, from_, errors_}) fcntl(file, F_SETFL, O_NONBLOCK);
  if (child_ > 0) return;
  close_all();
  throw NoAnswer("cannot be started: " + why);
}

void HelperProcess::close_all() {
  close_file(to_);
  close_file(from_);
  close_file(errors_);
}

HelperProcess::~HelperProcess() {
  close_file(to_);
  if (!has_ended_within(kTimeToEnd)) end_group();
  close_all();
}

bool HelperProcess::has_ended_within(double time) {
  for (const double until = wall_clock() + time; child_ > 0; usleep(1000)) {
    if (waitpid(child_, nullptr, WNOHANG) != 0) child_ = -1;
    if (child_ > 0 && wall_clock() > until) return false;
  }
  return true;
}

// A helper may clean up before it is killed.
void HelperProcess::end_group() {
  const pid_t group = child_;
  kill(-group, SIGTERM);
  has_ended_within(kTimeToEnd);
  kill(-group, SIGKILL);
  while (child_ > 0 && waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
  }
  child_ = -1;
}

void HelperProcess::take_errors() {
  char bytes[4096];
  for (ssize_t count = 0; errors_ >= 0 && (count = read(errors_, bytes, sizeof bytes)) != 0;) {
    if (count < 0) return;
    last_words_.append(bytes, static_cast<std::size_t>(count));
    if (last_words_.size() > 2 * kLastWords) last_words_.erase(0, last_words_.size() - kLastWords);
  }
  close_file(errors_);
}

std::string HelperProcess::how_it_ended() {
  int status = 0;
  pid_t ended = 0;
  const double until = wall_clock() + kTimeToEnd;
  while ((ended = waitpid(child_, &status, WNOHANG)) == 0 && wall_clock() < until) usleep(1000);
  if (ended != child_) return "closed its output without an answer";
  child_ = -1;
  if (WIFSIGNALED(status))
    return concat("crashed: it was ended by signal ", WTERMSIG(status), " (", strsignal(WTERMSIG(status)), ")");
  if (WEXITSTATUS(status) == kCannotStart) return "cannot be started: there is no such program, or it may not be run";
  return concat("ended with exit code ", WEXITSTATUS(status));
}

void HelperProcess::give_up(std::string why) {
  take_errors();
  if (child_ > 0) end_group();
  close_all();
  std::string last = trimmed(last_words_.substr(last_words_.size() - std::min(last_words_.size(), kLastWords)));
  while (!last.empty() && last.back() == '\n') last.pop_back();
  if (!last.empty()) why += "; it wrote: " + last;
  throw NoAnswer(why);
}

void HelperProcess::wait_for(int file, short events) {
  for (;;) {
    const double left = asked_ + patience_ - wall_clock();
    if (left <= 0.0) give_up(concat("did not answer within its time limit of ", patience_, " s"));
    pollfd files[2] = {{file, events, 0}, {errors_, POLLIN, 0}};
    const int ready = poll(files, errors_ >= 0 ? 2 : 1, static_cast<int>(std::ceil(std::min(left, 60.0) * 1e3)));
    if (ready < 0 && errno != EINTR) give_up(std::string("cannot be waited for: ") + std::strerror(errno));
    if (ready <= 0) continue;
    if (errors_ >= 0 && files[1].revents != 0) take_errors();
    if (files[0].revents != 0) return;
  }
}

std::string HelperProcess::ask(const std::string& question, double limit) {
  if (to_ < 0) throw NoAnswer("has ended before");
  asked_ = wall_clock();
  patience_ = limit > 0.0 ? limit : limit_;
  struct Ignored {  // the missing answer shows that a helper is gone
    struct sigaction before;
    Ignored() {
      struct sigaction ignore = {};
      ignore.sa_handler = SIG_IGN;
      sigaction(SIGPIPE, &ignore, &before);
    }
    ~Ignored() { sigaction(SIGPIPE, &before, nullptr); }
  } const ignored;

  const std::uint64_t length = question.size();
  std::string frame(reinterpret_cast<const char*>(&length), sizeof length);
  frame += question;
  for (std::size_t done = 0; done < frame.size();) {
    const ssize_t count = write(to_, frame.data() + done, frame.size() - done);
    if (count > 0) {
      done += static_cast<std::size_t>(count);
    } else if (errno == EAGAIN || errno == EINTR) {
      wait_for(to_, POLLOUT);
    } else {
      give_up(how_it_ended());
    }
  }
  const auto receive = [&](char* place, std::size_t size) {
    for (std::size_t done = 0; done < size;) {
      const ssize_t count = read(from_, place + done, size - done);
      if (count > 0) {
        done += static_cast<std::size_t>(count);
      } else if (count < 0 && (errno == EAGAIN || errno == EINTR)) {
        wait_for(from_, POLLIN);
      } else {
        give_up(how_it_ended());
      }
    }
  };
  std::uint64_t size = 0;
  receive(reinterpret_cast<char*>(&size), sizeof size);
  if (size > kLargestFrame) give_up("sent something else than an answer to its standard output");
  std::string answer(size, '\0');
  receive(answer.data(), answer.size());
  return answer;
}

bool HelperProcess::read_frame(int file, std::string& content) {
  const auto receive = [&](char* place, std::size_t size) {
    for (std::size_t done = 0; done < size;) {
      const ssize_t count = read(file, place + done, size - done);
      if (count > 0) done += static_cast<std::size_t>(count);
      if (count == 0 || (count < 0 && errno != EINTR)) return false;
    }
    return true;
  };
  std::uint64_t size = 0;
  if (!receive(reinterpret_cast<char*>(&size), sizeof size) || size > kLargestFrame) return false;
  content.assign(size, '\0');
  return receive(content.data(), content.size());
}

bool HelperProcess::write_frame(int file, const std::string& content) {
  const std::uint64_t length = content.size();
  std::string frame(reinterpret_cast<const char*>(&length), sizeof length);
  frame += content;
  for (std::size_t done = 0; done < frame.size();) {
    const ssize_t count = write(file, frame.data() + done, frame.size() - done);
    if (count > 0) done += static_cast<std::size_t>(count);
    if (count < 0 && errno != EINTR) return false;
  }
  return true;
}

}  // namespace footfall
