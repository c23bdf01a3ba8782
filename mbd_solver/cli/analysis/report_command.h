#pragma once
// footfall report DIR: one page for a run or a sweep, DIR/report.html, that can be read without network and sent to
// somebody.

#include <string>

namespace footfall {

// Writes the page and returns its path. Throws InputError for a folder that is neither a run nor a sweep.
std::string write_report(const std::string& folder);

}  // namespace footfall
