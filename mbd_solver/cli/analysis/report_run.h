#pragma once
// report.html of a run.

#include <string>

namespace footfall {

// Its text; makes the ledger, plots and view.html that the run lacks. `run`: absolute path of the folder. Throws
// InputError for damaged files.
std::string run_page(const std::string& run);

}  // namespace footfall
