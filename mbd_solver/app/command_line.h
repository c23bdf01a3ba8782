#pragma once
// Options of the commands around a run: a case to begin with, plots, a look at a run that is under way. As in
// subcommands.cpp, each returns what it does once its options are read.

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

namespace footfall {

using Action = std::function<int()>;

Action new_case(CLI::App& command);
Action plot_columns(CLI::App& command);
Action watch_run(CLI::App& command);

// The subcommands of footfall.

struct Subcommand {
  const char* name;
  const char* what;                      // as --help shows it
  Action (*prepare)(CLI::App& command);  // adds its options; returns what it does once they are read
};

// Those of footfall itself, in the order of --help; docs/commands.md has a line for each. Others: studies.h.
const std::vector<Subcommand>& subcommands();

// A command line that cannot be read, told in our words: where, what is, what was expected, what to do.

// line: the words behind the program's name.
std::string option_error(const CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& line);

// Man pages and completion of shells, made from what --help says: the commands, their options and the texts of both
// stand in the table of subcommands.cpp alone.

// In the language of man: of the whole program, and of one command.
std::string man_page(const CLI::App& app);
std::string man_page_of(const CLI::App& command);

// What stands behind an option: "TEXT", "NUMBER", "CASE".
std::string value_name(const CLI::Option& option);

// ' Did you mean "--until"?' for the first word of a line that begins with - and that its command does not know; empty
// where nothing is near.
std::string meant_option(const CLI::App& app, const std::vector<std::string>& line);

// To be sourced by bash; a function for the fpath of zsh. Both complete commands, options, cases of `new --from`, files.
std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);

// All of them: FOLDER/footfall.1, footfall-COMMAND.1 ..., footfall.bash, _footfall. Throws InputError.
void write_help_pages(const CLI::App& app, const std::string& folder);

// A command line of footfall, from its words to an exit code.

// commands: those that --help lists. help: one more, which it does not list; none without. What goes wrong is told on stderr.
int front_door(int argc, char** argv, const std::vector<Subcommand>& commands,
               const std::function<Action(CLI::App& app, CLI::App& command)>& help = {});

}  // namespace footfall
