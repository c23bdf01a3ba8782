#pragma once
// A separate process that answers requests through a pair of pipes: code of the user that must not end this program.
//
// Each request and each answer is a frame on the helper's standard input and output: 8 bytes, the number of bytes that
// follow (the machine's order of bytes), then these bytes. All other output of the helper goes to its standard error. It
// should end when its input ends.

#include <sys/types.h>

#include <string>

#include "coupler/base/errors.h"
#include "mbd_solver/base/child_process.h"

namespace footfall {

// Code of the user failed while it ran: an FMU, a script. Exit code 1.
class ForeignError : public CodedError {
 public:
  using CodedError::CodedError;
};

// Why there is no answer, as the end of a sentence: "was ended by signal 11 (Segmentation fault)". The last lines of the
// helper's standard error are added.
class NoAnswer : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class HelperProcess {
 public:
  // limit: for one answer, by the wall clock [s]. orphan: code of the user, which may not watch its input, is killed with the
  // thread that made this object. Throws NoAnswer when the program cannot be started.
  HelperProcess(const Command& command, double limit, Orphan orphan = Orphan::kIsKilled);
  ~HelperProcess();  // ends it and everything in its process group
  HelperProcess(const HelperProcess&) = delete;
  HelperProcess& operator=(const HelperProcess&) = delete;

  // limit: for this answer [s]; 0: the common limit. Throws NoAnswer when the helper ends, does not answer within the limit, or
  // sends something else; it is ended then.
  std::string ask(const std::string& question, double limit = 0.0);
  // For a helper that is written in C++.
  static bool read_frame(int file, std::string& content);  // false: the input has ended
  static bool write_frame(int file, const std::string& content);

 private:
  [[noreturn]] void give_up(std::string why);
  std::string how_it_ended();
  bool has_ended_within(double time);  // [s]
  void end_group();
  void take_errors();  // reads the pipe of its standard error
  void wait_for(int file, short events);
  void close_all();

  pid_t child_ = -1;
  int to_ = -1, from_ = -1, errors_ = -1;  // pipes
  double limit_;                           // for one answer [s]
  double asked_ = 0.0, patience_ = 0.0;    // this answer: time of the request (wall clock), and its limit [s]
  std::string last_words_;                 // of its standard error
};

}  // namespace footfall
