#pragma once
// The four ways in which footfall stops. Only main() ends a program; it turns these into exit codes.

#include <stdexcept>
#include <string>

namespace footfall {

// The user can mend it. Message: where + what is + what was expected + what to do. Exit code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The two programs disagree (version, dt, bodies, shape of a message). Exit code 2; both sides print it, naming both
// values.
class ProtocolError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A solver gave up, or a result is no longer finite. The message names time and body or constraint. Exit code 1.
class NumericalError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The partner is gone or reported a failure of its own. Exit code 1.
class PartnerError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline constexpr int kExitDone = 0;
inline constexpr int kExitFailed = 1;
inline constexpr int kExitBadInput = 2;
inline constexpr int kExitInterrupted = 3;

}  // namespace footfall

// Our own mistake, always on: a broken invariant of the program, never of its input.
#define FOOTFALL_DEMAND(condition)                                                                            \
  do {                                                                                                        \
    if (!(condition))                                                                                         \
      throw std::logic_error(std::string("footfall: internal error: ") + #condition + " (" + __FILE__ + ":" + \
                             std::to_string(__LINE__) + ")");                                                 \
  } while (false)
