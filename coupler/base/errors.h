#pragma once
// The ways in which footfall stops, and their exit codes. Only main() ends a program; it turns errors into exit codes.
// Every message to users ends with a stable code, "[E0123 unknown-body]", which pages, tests and scripts refer to; its
// wording may change. docs/reference/messages.md lists all codes.

#include <stdexcept>
#include <string>

#include "coupler/base/concat.h"

namespace footfall {

// A stable name of one kind of message. number: "E0123" (errors) or "W0123" (warnings); name: "unknown-body". Each
// module lists its own in codes.h; a number is never used again.
struct MessageCode {
  const char* number;
  const char* name;
};

// The pieces of the text, then " [E0123 unknown-body]".
template <class... Pieces>
std::string with_code(const MessageCode& code, const Pieces&... text) {
  return concat(text..., " [", code.number, " ", code.name, "]");
}

// Does the text end with a code? Reasons that come from the partner program usually do.
inline bool has_code(const std::string& text) {
  const std::size_t start = text.rfind(" [");
  return start != std::string::npos && text.back() == ']' && start + 8 < text.size() &&
         (text[start + 2] == 'E' || text[start + 2] == 'W') &&
         text.find_first_not_of("0123456789", start + 3) == start + 7 && text[start + 7] == ' ';
}

// Adds `more` to a message in front of its code.
inline std::string with_addition(const std::string& text, const std::string& more) {
  return has_code(text) ? text.substr(0, text.rfind(" [")) + more + text.substr(text.rfind(" [")) : text + more;
}

// Common base of the errors below: a text for users that ends with its code.
class CodedError : public std::runtime_error {
 public:
  template <class... Pieces>
  CodedError(const MessageCode& code, const Pieces&... text) : std::runtime_error(with_code(code, text...)) {}
  // `text` ends with its code already: an error caught below and given its place.
  explicit CodedError(const std::string& text) : std::runtime_error(text) {}
};

// The user can correct it. Message: where, what is wrong, what was expected, what to do. Exit code 2.
class InputError : public CodedError {
 public:
  using CodedError::CodedError;
};

// The two programs disagree (version, dt, bodies, shape of a message). Exit code 2; both sides print it, naming both
// values.
class ProtocolError : public CodedError {
 public:
  using CodedError::CodedError;
};

// A solver gave up, or a result is no longer finite. The message names time and body or constraint. Exit code 1.
class NumericalError : public CodedError {
 public:
  using CodedError::CodedError;
};

// The partner is gone or reported a failure of its own. Exit code 1.
class PartnerError : public CodedError {
 public:
  using CodedError::CodedError;
};

// A signal requested the end of this program or its partner. Exit code 3.
class Interrupted : public PartnerError {
 public:
  using PartnerError::PartnerError;
};

// A file of a run cannot be written: full disk, folder gone, a limit. The message names the file. Exit code 1.
class FileError : public CodedError {
 public:
  using CodedError::CodedError;
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
