#pragma once
// footfall compare DIR [OTHER]: the bed of a run beside the one that stock LIGGGHTS makes of the same motion, or beside
// that of another run.

#include <string>

namespace footfall {

// Writes DIR/compare (without OTHER: the stock script, and what stock LIGGGHTS made of it), prints the table, draws the
// plots. Returns an exit code; throws InputError for a folder that holds no coupled run.
// `trust_script`: the script of the run may run programs and write anywhere.
int compare_command(const std::string& run, const std::string& other, bool trust_script, bool quiet);

}  // namespace footfall
