#pragma once
// How the runs of an experiment ended, against how they must: cases that are stiff, extreme or unstable.
//
//   [[curves]]
//     ends                     one for all values, or one per value:
//       "accurate"             done, error within the tolerance (without a reference: no warning), no energy gained
//       "warned"                 done, energy bounded, but the error is larger, and a warning said so
//       "stopped"                ended by itself with a message (exit code 1)
//       "refused"                not started (exit code 2)
//     group                    heading in the table
//     columns, at_end          of history.csv, compared with the reference: over the run, or where it comes to rest
//     tolerance                of that error, of the reference's swing (default: 0.02)
//     message                  regular expression that warnings or the last message must match
//     order_beyond             from this value on errors grow at most in proportion to the value

#include <string>
#include <vector>

#include "mbd_solver/cli/experiments/results.h"

namespace footfall {

struct Verdict {
  std::string group, name, value, expected, found;  // found: accurate, warned, stopped, refused, or what is wrong
  std::string note;                                 // error, gain, message
  double error = 0.0;                               // against its reference [-]; 0 without one, or when it was not done
  bool as_expected = false;
};

// One per case, but for references. Throws NumericalError when a reference was not done.
std::vector<Verdict> verdicts_of(const ExperimentSpec& spec, const Results& results);
// The table as Markdown.
std::string verdict_page(const ExperimentSpec& spec, const std::vector<Verdict>& verdicts);

}  // namespace footfall
