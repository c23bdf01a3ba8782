#pragma once
// The stability map: cases that are stiff, extreme or unstable, each with the way it must end.

#include <string>
#include <vector>

#include "mbd_solver/cli/experiments/study.h"

namespace footfall {

struct Verdict {
  std::string group, name, value, expected, found;  // found: accurate, warned, stopped, refused, or what is wrong
  std::string note;                                 // error, gain, message
  double wall = 0.0;                                // [s]
  double error = 0.0;                               // against its reference [-]; 0 without one, or when it was not done
  bool as_expected = false;
};

// Runs the cases (all, or those of one name) below `out`. Throws InputError for a case name that is not there.
std::vector<Verdict> run_map(const StudySpec& study, const std::string& only, const std::string& out);

// The table as Markdown.
void write_map(const std::string& path, const StudySpec& study, const std::vector<Verdict>& verdicts);

}  // namespace footfall
