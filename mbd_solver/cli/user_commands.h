#pragma once
// Options of the commands around a run: a case to begin with, plots, a look at a run that is under way. As in
// subcommands.cpp, each returns what it does once its options are read.

#include <CLI/CLI.hpp>
#include <functional>

namespace footfall {

using Action = std::function<int()>;

Action new_case(CLI::App& command);
Action plot_columns(CLI::App& command);
Action watch_run(CLI::App& command);

}  // namespace footfall
