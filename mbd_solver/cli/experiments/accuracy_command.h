#pragma once
// footfall accuracy: runs a work-precision study or a stability map.

#include <string>

namespace footfall {

struct AccuracyArguments {
  std::string file;
  std::string out;      // empty: runs/accuracy/NAME
  std::string only;     // of a map: this case alone
  std::string table;    // also written to this file, as Markdown
  bool resume = false;  // of a study: runs that were done with the same settings are kept
  // of a study: the `short` values alone, and the expectations of the file decide the exit code
  bool short_form = false;
};

// Returns the exit code: 0, or 1 when an expectation of the file does not hold. Throws InputError.
int accuracy_command(const AccuracyArguments& arguments);

}  // namespace footfall
