#pragma once
// The table of errors for the pages, in Markdown; with an ensemble, also what it recommends.

#include <iosfwd>
#include <string>

#include "mbd_solver/cli/experiments/error_table.h"

namespace footfall {

// `command`: the one that makes the page, told with an ensemble. Throws InputError when `path` cannot be written.
void write_error_page(const std::string& path, const ErrorTable& table, const std::string& command);

// The section "Recommended settings" for 1 and 5 %.
void write_recommendations(std::ostream& out, const ErrorTable& table);

}  // namespace footfall
