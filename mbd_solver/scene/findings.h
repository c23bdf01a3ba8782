#pragma once
// Where an entry of a scene was given, so that a finding can name file and line.

#include <map>
#include <set>
#include <string>
#include <vector>

#include "coupler/base/concat.h"
#include "coupler/base/errors.h"
#include "mbd_solver/scene/codes.h"

namespace footfall {

struct Source {
  std::string path;  // "bodies.cabin", "struts.primary_1", "solver": for messages and --set
  int line = 0;      // of the entry; 0: not in the file (a default)
  std::map<std::string, int>
      lines;  // of each key given in it: "mass", "gas.exponent"; a key from --set has line kFromSet
  std::set<std::string> in_other_units;  // keys that are written with a unit suffix
  std::set<std::string> refused;         // keys whose value was reported by the reader, and is not in the scene

  static constexpr int kFromSet = -1;
  // Line of a key, or of the innermost given key around it.
  int line_of(const std::string& key) const;
  bool given(const std::string& key) const { return lines.count(key) > 0; }
  // Given, and its value was accepted.
  bool good(const std::string& key) const { return given(key) && refused.count(key) == 0; }
  // Both keys are in the scene file itself. If one came from --set or a base, the other may remain on purpose.
  bool written_together(const std::string& a, const std::string& b) const {
    return given(a) && given(b) && lines.at(a) > 0 && lines.at(b) > 0;
  }
};

// All errors and warnings about a file, collected, so that the user sees them at once. Every finding ends with its code.
// "scene.toml:40: signals.s.input: " or "--set signals.s.input: ". Line and path come from `source`; `key` may be
// empty.
std::string place_of(const std::string& file, const Source& source, const std::string& key = "");
// line: kFromSet means "--set"; 0: unknown.
std::string place_of(const std::string& file, int line, const std::string& path);
// Whether the message begins with a place in this file or in --set.
bool names_a_place(const std::string& file, const std::string& message);

class Findings {
 public:
  explicit Findings(std::string file) : file_(std::move(file)) {}

  // `key`: within the entry that `source` describes; empty: the entry itself.
  template <class... Pieces>  // of the message (coupler/base/concat.h)
  void error(const MessageCode& code, const Source& source, const std::string& key, const Pieces&... what) {
    coded_error(source, key, with_code(code, what...));
  }
  template <class... Pieces>
  void error(const MessageCode& code, int line, const std::string& path, const Pieces&... what) {
    coded_error(line, path, with_code(code, what...));
  }
  template <class... Pieces>
  void warning(const MessageCode& code, const Source& source, const std::string& key, const Pieces&... what) {
    coded_warning(source, key, with_code(code, what...));
  }
  // The text ends with a code already.
  void coded_error(const Source& source, const std::string& key, const std::string& what);
  void coded_error(int line, const std::string& path, const std::string& what);
  void coded_warning(const Source& source, const std::string& key, const std::string& what);

  bool has_errors() const { return !errors_.empty(); }
  int error_count() const { return static_cast<int>(errors_.size()) + more_errors_; }
  // Further errors are counted, not listed: whoever finds them one by one may call skip_error() and make no text of them.
  bool is_full() const { return errors_.size() == kMost; }
  void skip_error() { ++more_errors_; }
  // At most kMost, and how many there are more.
  std::vector<std::string> warnings() const;
  // Throws InputError with one finding per line, sorted by line, if there is any error.
  void throw_if_errors() const;

  static constexpr std::size_t kMost =
      100;  // that are listed: who made a file by a program has one mistake a million times

 private:
  struct Finding {
    int line;
    std::string text;
  };

  std::string file_;
  std::vector<Finding> errors_;
  std::set<std::string> texts_;  // of all errors
  std::vector<std::string> warnings_;
  int more_errors_ = 0, more_warnings_ = 0;
};

// Findings about one entry of a scene.
class EntryFindings {
 public:
  EntryFindings(Findings& findings, const Source& source) : findings_(findings), source_(source) {}
  EntryFindings(Findings&, Source&&) = delete;

  template <class... Pieces>
  void error(const MessageCode& code, const std::string& key, const Pieces&... what) const {
    findings_.error(code, source_, key, what...);
  }
  template <class... Pieces>
  void error_if(bool wrong, const MessageCode& code, const std::string& key, const Pieces&... what) const {
    if (wrong) error(code, key, what...);
  }
  // "KEY is missing; why".
  template <class... Pieces>
  void missing_if(bool wrong, const std::string& key, const Pieces&... why) const {
    error_if(wrong, code::kMissingKey, key, "is missing; ", why...);
  }
  // on: "a mesh from a file".
  template <class... Pieces>
  void no_effect_if(bool wrong, const std::string& key, const Pieces&... on) const {
    error_if(wrong, code::kKeyWithoutEffect, key, "has no effect on ", on..., "; remove it");
  }
  // by: "the controller".
  void given_twice_if(bool wrong, const std::string& key, const std::string& by) const {
    error_if(wrong, code::kConflictingKeys, key, "is given by ", by, " as well; keep one of the two");
  }
  template <class... Pieces>
  void warning(const MessageCode& code, const std::string& key, const Pieces&... what) const {
    findings_.warning(code, source_, key, what...);
  }
  Findings& all() const { return findings_; }
  const Source& source() const { return source_; }
  bool given(const std::string& key) const { return source_.given(key); }

 private:
  Findings& findings_;
  const Source& source_;
};

}  // namespace footfall
