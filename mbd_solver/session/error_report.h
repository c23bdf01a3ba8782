#pragma once
// An error as its parts, for programs that show or sort errors by themselves.

#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "mbd_solver/scene/scene.h"

namespace footfall {

struct ErrorReport {
  enum class Kind {
    kInput,      // the user can correct it
    kNumerical,  // a solver failed
    kPartner,    // another program ended or failed
    kFile,       // a file cannot be written
    kInternal    // a fault of this program
  };
  Kind kind = Kind::kInternal;
  std::string code, name;  // "E0123", "unknown-body"; empty without a code
  std::string file;        // empty: the message names none
  int line = 0;            // 0: likewise; of --set: -1
  std::string key;         // of the scene, "joints.axle.bodies"; empty: likewise
  std::string text;        // without place and code
  std::string message;     // all of it, as printed
};

// One for each finding of a scene, at least one.
std::vector<ErrorReport> reports_of(const std::exception& error);
// The report of one line "file:line: key: text [E0123 name]", as warnings are.
ErrorReport report_of(const std::string& message);

// All that is wrong with a scene, or strange, as `footfall check` finds it, but without grains of a cached bed.
struct CheckedScene {
  std::vector<ErrorReport> errors, warnings;
};
CheckedScene check_for_findings(const std::function<Scene()>& read);

}  // namespace footfall
