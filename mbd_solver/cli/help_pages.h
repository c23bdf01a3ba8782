#pragma once
// Man pages and completion of shells, made from what --help says: the commands, their options and the texts of both
// stand in the table of subcommands.cpp alone.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace footfall {

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

}  // namespace footfall
